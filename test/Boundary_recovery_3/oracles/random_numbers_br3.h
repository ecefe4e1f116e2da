// Random numbers for the tests, always the same ones on every machine.

#ifndef BR3_TEST_RANDOM_NUMBERS_H
#define BR3_TEST_RANDOM_NUMBERS_H

#include <random>

namespace br3_test {

// The distributions of the standard library differ between implementations; this does not.
inline int random_int(std::mt19937& rng, const int n) { return static_cast<int>(rng() % static_cast<unsigned>(n)); }

} // namespace br3_test

#endif // BR3_TEST_RANDOM_NUMBERS_H

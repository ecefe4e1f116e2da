#ifndef BOUNDARY_RECOVERY_3_PROGRAM_DISJOINT_SETS_H
#define BOUNDARY_RECOVERY_3_PROGRAM_DISJOINT_SETS_H

#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/vector_property_map.hpp>

#include <cstddef>

// Sets of numbers, each number below `n` being a set of its own at first. Boost's class with storage does not compile
// everywhere: some headers of Boost.Graph hide the get() of pointers.
class Disjoint_sets
  : public boost::disjoint_sets<boost::vector_property_map<std::size_t>, boost::vector_property_map<std::size_t> >
{
  typedef boost::vector_property_map<std::size_t> Map;

public:
  explicit Disjoint_sets(const std::size_t n)
    : boost::disjoint_sets<Map, Map>(Map(n), Map(n))
  {
    for(std::size_t i = 0; i < n; ++i)
      make_set(i);
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_DISJOINT_SETS_H

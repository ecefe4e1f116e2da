#ifndef BOUNDARY_RECOVERY_3_PROGRAM_LARGE_PAGES_H
#define BOUNDARY_RECOVERY_3_PROGRAM_LARGE_PAGES_H

#include <cstddef>

#if defined(__linux__) && defined(__GLIBC__)
#include <malloc.h>
#include <sys/mman.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#endif

// Memory in pages of 2 MB instead of 4 KB, where Linux has them for those that ask. The cells of a large mesh are in so
// many small pages that a processor does not remember where all these are: looking for them takes a twentieth of the
// time. Without Linux or GNU's C library, nothing is done; where there are no large pages, there are small ones.
namespace large_pages {

#if defined(__linux__) && defined(__GLIBC__)

constexpr std::size_t size = std::size_t(1) << 21;
constexpr double most_bytes = 1e14; // that there are addresses for

// Before there are threads. From then on, all memory comes from one heap, also that of threads, and stays there when it
// is free.
inline void use_one_heap()
{
  mallopt(M_ARENA_MAX, 1);
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, -1);
}

// So much of what the heap has from now on is in large pages. The system gives them only when they are used.
inline void reserve(const double number_of_bytes)
{
  const std::size_t bytes = static_cast<std::size_t>((std::min)(number_of_bytes, most_bytes));
  void* const all = std::malloc(bytes);
  if(all == nullptr)
    return;
  const std::uintptr_t address = reinterpret_cast<std::uintptr_t>(all);
  const std::uintptr_t begin = (address + size - 1) / size * size, end = (address + bytes) / size * size;
  if(begin < end)
    madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
  std::free(all);
}

#else

inline void use_one_heap() { }
inline void reserve(double) { }

#endif

} // namespace large_pages

#endif // BOUNDARY_RECOVERY_3_PROGRAM_LARGE_PAGES_H

#ifndef BOUNDARY_RECOVERY_3_PROGRAM_LARGE_PAGES_H
#define BOUNDARY_RECOVERY_3_PROGRAM_LARGE_PAGES_H

#include <cstddef>

#if defined(__linux__) && defined(__GLIBC__)
#include <CGAL/Boundary_recovery_3/internal/util/available_memory.h>

#include <malloc.h>
#include <sys/mman.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <system_error>
#include <thread>
#endif

// Memory in pages of 2 MB instead of 4 KB, where Linux has them for those that ask. The cells of a large mesh are in so
// many small pages that a processor does not remember where all these are: looking for them takes a twentieth of the
// time. Getting them from the system takes another tenth, and threads wait for each other at that; so one more thread
// gets most of them before they are used. Without Linux or GNU's C library, nothing is done; where there are no large
// pages, there are small ones.
class Large_pages
{
#if defined(__linux__) && defined(__GLIBC__)

  static constexpr std::size_t size = std::size_t(1) << 21;
  static constexpr double most_bytes = 1e14;   // that there are addresses for
  static constexpr double fetched_share = 0.8; // of what is expected to be used
  static constexpr std::chrono::microseconds pause{ 100 }; // after each page that is fetched

  const bool m_are_fetched;
  std::atomic<bool> m_is_over{ false };
  std::thread m_thread;

public:
  // Before there are threads. From then on, all memory comes from one heap, also that of threads, and stays there when
  // it is free.
  static void use_one_heap()
  {
    mallopt(M_ARENA_MAX, 1);
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, -1);
  }

  // `are_fetched` tells whether there may be another thread.
  explicit Large_pages(const bool are_fetched)
    : m_are_fetched(are_fetched && std::thread::hardware_concurrency() > 1)
  { }

  ~Large_pages() { end_fetching(); }

  // The next bytes that the heap gives, so many, are in large pages. It should be about what will be used; what takes
  // more than half of the memory is not fetched, as it may be less.
  void reserve(const double number_of_bytes)
  {
    const std::size_t bytes = static_cast<std::size_t>((std::min)(number_of_bytes, most_bytes));
    void* const all = std::malloc(bytes);
    if(all == nullptr)
      return;
    const std::uintptr_t address = reinterpret_cast<std::uintptr_t>(all);
    std::free(all);
    const std::uintptr_t begin = (address + size - 1) / size * size, end = (address + bytes) / size * size;
    if(begin >= end)
      return;
    madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
    if(m_are_fetched && bytes <= CGAL::Boundary_recovery_3::internal::available_memory() / 2)
      begin_fetching(begin, static_cast<std::size_t>(fetched_share * double(end - begin)));
  }

  // To be called when no more memory will be used than is used by now.
  void end_fetching()
  {
    m_is_over = true;
    if(m_thread.joinable())
      m_thread.join();
    m_is_over = false;
  }

private:
  void begin_fetching(const std::uintptr_t begin, const std::size_t bytes)
  {
    end_fetching();
    try
    {
      m_thread = std::thread([=] { fetch(begin, bytes); });
    }
    catch(const std::system_error&) // there may be no more threads: the pages come when they are used
    { }
  }

  // Pages may be in use meanwhile; what is in them stays. Threads that change the address space, as new ones do, wait
  // for one page; without a pause, they would wait for several. Nothing happens before Linux 5.14.
  void fetch([[maybe_unused]] const std::uintptr_t begin, [[maybe_unused]] const std::size_t bytes) const
  {
#ifdef MADV_POPULATE_WRITE
    const auto fetch_page = [begin](const std::size_t k)
    {
      return madvise(reinterpret_cast<void*>(begin + k * size), size, MADV_POPULATE_WRITE) == 0;
    };
    for(std::size_t k = 0; k < bytes / size && ! m_is_over && fetch_page(k); ++k)
      std::this_thread::sleep_for(pause);
#endif
  }

#else

public:
  static void use_one_heap() { }
  explicit Large_pages(bool) { }
  void reserve(double) { }
  void end_fetching() { }

#endif
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_LARGE_PAGES_H

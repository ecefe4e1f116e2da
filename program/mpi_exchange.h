#ifndef BOUNDARY_RECOVERY_3_PROGRAM_MPI_EXCHANGE_H
#define BOUNDARY_RECOVERY_3_PROGRAM_MPI_EXCHANGE_H

#include <boost/mpi/communicator.hpp>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <thread>
#include <type_traits>
#include <vector>

// Small tasks are done in some milliseconds: ranks must not wait as long for the next one.
inline void pause_briefly() { std::this_thread::sleep_for(std::chrono::microseconds(100)); }

// Waits for all ranks. MPI's own waiting takes a core, which a rank that works may need.
inline void wait_for_all(const boost::mpi::communicator& world)
{
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Ibarrier(world, &request);
  int is_done = 0;
  while(MPI_Test(&request, &is_done, MPI_STATUS_IGNORE) == MPI_SUCCESS && ! is_done)
    pause_briefly();
}

// What ranks tell each other. All of them call a member at the same time.
class Mpi_exchange
{
  const boost::mpi::communicator& m_world;

public:
  explicit Mpi_exchange(const boost::mpi::communicator& world) : m_world(world) { }

  int rank() const { return m_world.rank(); }
  int size() const { return m_world.size(); }
  bool is_first() const { return rank() == 0; }
  void wait() const { wait_for_all(m_world); }

  // whether all ranks did what they had to
  bool do_all_agree(const bool is_done) const
  {
    const int is_done_here = is_done;
    int is_done_everywhere = 0;
    wait();
    MPI_Allreduce(&is_done_here, &is_done_everywhere, 1, MPI_INT, MPI_MIN, m_world);
    return is_done_everywhere != 0;
  }

  // The array becomes that of all ranks: what rank 0 has, then what rank 1 has, and so on. Elements are sent as they
  // are.
  template <typename T>
  void gather(std::vector<T>& array) const
  {
    static_assert(std::is_trivially_copyable<T>::value, "it is more than its bytes");
    wait();
    const std::uint64_t number = array.size();
    std::vector<std::uint64_t> numbers(static_cast<std::size_t>(size()));
    MPI_Allgather(&number, 1, MPI_UINT64_T, numbers.data(), 1, MPI_UINT64_T, m_world);
    std::vector<int> counts, begins;
    std::uint64_t sum = 0;
    for(const std::uint64_t n : numbers)
    {
      counts.push_back(static_cast<int>(n));
      begins.push_back(static_cast<int>(sum));
      sum += n;
      if(sum > static_cast<std::uint64_t>((std::numeric_limits<int>::max)())) // MPI counts with integers of 32 bits
        throw std::length_error("there is too much to be told to all ranks");
    }
    std::vector<T> all(static_cast<std::size_t>(sum));
    MPI_Datatype type = MPI_DATATYPE_NULL;
    MPI_Type_contiguous(static_cast<int>(sizeof(T)), MPI_BYTE, &type);
    MPI_Type_commit(&type);
    MPI_Allgatherv(array.data(), static_cast<int>(number), type, all.data(), counts.data(), begins.data(), type,
                   m_world);
    MPI_Type_free(&type);
    array.swap(all);
  }

  // what the rank has, on all of them
  template <typename T>
  std::vector<T> gathered(const T& value) const
  {
    std::vector<T> values(1, value);
    gather(values);
    return values;
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_MPI_EXCHANGE_H

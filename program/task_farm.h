#ifndef BOUNDARY_RECOVERY_3_PROGRAM_TASK_FARM_H
#define BOUNDARY_RECOVERY_3_PROGRAM_TASK_FARM_H

#include "mpi_exchange.h"

#include <boost/mpi/communicator.hpp>
#include <boost/mpi/environment.hpp>

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <functional>
#include <future>
#include <iostream>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

// what a rank tells of a task that it did; it is sent as it is
struct Task_report
{
  std::uint64_t task = no_task;
  std::uint64_t bytes = 0;      // of the result
  std::uint64_t new_vertices = 0;
  std::int64_t gained_vertices = 0; // new ones, less those that are gone
  std::uint64_t tetrahedra = 0;
  double seconds = 0;
  int rank = 0;
  bool is_stored = false;       // by an earlier run
  bool was_full = false;        // nothing is done: more vertices are needed
  bool is_field_resolved = true;
  char error[300] = {};         // empty: it is done. No memory has to be there for the message.

  static constexpr std::uint64_t no_task = static_cast<std::uint64_t>(-1);
};

namespace task_farm_internal {

// mpirun ends all ranks when one of them dies: then there is a second left to say what was under way
inline volatile sig_atomic_t& is_terminated()
{
  static volatile sig_atomic_t value = 0;
  return value;
}

extern "C" inline void note_termination(int) { is_terminated() = 1; }

} // namespace task_farm_internal

// Rank 0 hands out tasks, the heaviest ones first, and works as well: its tasks run in a thread beside the one that
// talks to the others. Which rank does a task, and when, depends on how fast they are; results must not depend on that.
// It is only MPI's calls of one thread that are needed.
class Task_farm
{
  typedef boost::mpi::communicator Communicator;
  typedef std::uint64_t            Task;

  static constexpr int tag_of_reports = 1, tag_of_tasks = 2;

  const Communicator& m_world;
  std::function<std::string(std::size_t)> m_name; // of a task, in messages
  std::function<void()> m_clean_up;     // before rank 0 ends all ranks
  std::vector<Task> m_order;            // the heaviest first
  std::size_t m_next = 0;
  std::vector<Task> m_under_way;        // of each rank
  std::vector<long> m_processes;        // of each rank on this machine; 0 on others
  std::vector<Task_report> m_reports;
  std::size_t m_number_of_waiting = 0;  // ranks that were told that there is nothing more to do

public:
  // `name(task)` is what a task is called in messages; `clean_up()` is called by rank 0 before all ranks end at once.
  template <typename Name, typename Clean_up>
  Task_farm(const Communicator& world, const Name& name, const Clean_up& clean_up)
    : m_world(world), m_name(name), m_clean_up(clean_up)
  { }

  // does the tasks, and returns what is told of each of them, on all ranks. `work(task)` returns a report. If it
  // throws, or if a rank dies, rank 0 says which task that was, and all ranks end at once.
  template <typename Work>
  std::vector<Task_report> operator()(const std::vector<double>& weights, const Work& work)
  {
    m_reports.assign(weights.size(), Task_report());
    exchange_processes();
    if(m_world.rank() == 0)
      lead(weights, work);
    else
      follow(work);
    wait_for_all(m_world);
    const int n = static_cast<int>(m_reports.size() * sizeof(Task_report));
    MPI_Bcast(m_reports.data(), n, MPI_BYTE, 0, m_world);
    return m_reports;
  }

private:
  void exchange_processes()
  {
    char name[MPI_MAX_PROCESSOR_NAME] = {};
    int length = 0;
    MPI_Get_processor_name(name, &length);
    const std::size_t size = static_cast<std::size_t>(m_world.size());
    std::vector<char> names(size * sizeof(name));
    MPI_Allgather(name, sizeof(name), MPI_CHAR, names.data(), sizeof(name), MPI_CHAR, m_world);
    const long process = ::getpid();
    m_processes.resize(size);
    MPI_Allgather(&process, 1, MPI_LONG, m_processes.data(), 1, MPI_LONG, m_world);
    for(std::size_t r = 0; r < size; ++r)
      if(std::strncmp(&names[r * sizeof(name)], name, sizeof(name)) != 0)
        m_processes[r] = 0;
  }

  template <typename Work>
  Task_report do_task(const Work& work, const Task task) const
  {
    Task_report report;
    const auto begin = std::chrono::steady_clock::now();
    try
    {
      report = work(static_cast<std::size_t>(task));
    }
    catch(const std::exception& e) // such as memory that is exhausted
    {
      std::snprintf(report.error, sizeof(report.error), "%s", e.what());
    }
    report.task = task;
    report.rank = m_world.rank();
    report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return report;
  }

  template <typename Work>
  void lead(const std::vector<double>& weights, const Work& work)
  {
    m_order.resize(weights.size());
    std::iota(m_order.begin(), m_order.end(), Task(0));
    std::stable_sort(m_order.begin(), m_order.end(), [&](const Task a, const Task b)
                     { return weights[a] > weights[b]; });
    m_under_way.assign(m_processes.size(), Task_report::no_task);
    struct sigaction action = {}, previous = {};
    action.sa_handler = task_farm_internal::note_termination;
    sigaction(SIGTERM, &action, &previous);
    std::future<Task_report> own;
    while(own.valid() || m_next < m_order.size() || m_number_of_waiting + 1 < m_processes.size())
    {
      if(! own.valid() && m_next < m_order.size())
        own = std::async(std::launch::async, [this, &work, task = next_task(0)] { return do_task(work, task); });
      bool is_idle = ! receive_report();
      if(own.valid() && own.wait_for(std::chrono::seconds(0)) == std::future_status::ready)
      {
        take(own.get());
        is_idle = false;
      }
      if(task_farm_internal::is_terminated())
        tell_who_is_gone();
      if(is_idle)
        pause_briefly();
    }
    sigaction(SIGTERM, &previous, nullptr);
  }

  std::string name(const Task task) const { return m_name(static_cast<std::size_t>(task)); }

  Task next_task(const std::size_t rank)
  {
    return m_under_way[rank] = (m_next < m_order.size()) ? m_order[m_next++] : Task_report::no_task;
  }

  bool receive_report()
  {
    const auto message = m_world.iprobe(boost::mpi::any_source, tag_of_reports);
    if(! message)
      return false;
    Task_report report;
    MPI_Recv(&report, sizeof(report), MPI_BYTE, message->source(), tag_of_reports, m_world, MPI_STATUS_IGNORE);
    if(report.task != Task_report::no_task) // else it only asks for the first task
      take(report);
    const Task task = next_task(static_cast<std::size_t>(message->source()));
    m_number_of_waiting += task == Task_report::no_task;
    MPI_Send(&task, 1, MPI_UINT64_T, message->source(), tag_of_tasks, m_world);
    return true;
  }

  void take(const Task_report& report)
  {
    if(report.error[0] != 0)
    {
      std::cerr << "mesh_surface_mpi: " << name(report.task) << " failed on rank " << report.rank << ": "
                << report.error << std::endl;
      m_clean_up();
      boost::mpi::environment::abort(3); // the others may work for long
    }
    m_under_way[static_cast<std::size_t>(report.rank)] = Task_report::no_task;
    m_reports[report.task] = report;
  }

  // mpirun has waited for the dead process already, so that there is none of its number any more
  [[noreturn]] void tell_who_is_gone() const
  {
    bool is_any_gone = false;
    for(std::size_t r = 0; r < m_processes.size(); ++r)
      if(m_processes[r] != 0 && ::kill(static_cast<pid_t>(m_processes[r]), 0) != 0)
      {
        is_any_gone = true;
        std::cerr << "mesh_surface_mpi: rank " << r << " was ended from outside";
        if(m_under_way[r] != Task_report::no_task)
          std::cerr << " while it meshed " << name(m_under_way[r]);
        std::cerr << std::endl;
      }
    if(! is_any_gone)
    {
      std::cerr << "mesh_surface_mpi: ended from outside; under way:";
      for(std::size_t r = 0; r < m_under_way.size(); ++r)
        if(m_under_way[r] != Task_report::no_task)
          std::cerr << ' ' << name(m_under_way[r]) << " on rank " << r << ';';
      std::cerr << std::endl;
    }
    std::cerr << "mesh_surface_mpi: with --work, what is finished is not meshed again" << std::endl;
    m_clean_up();
    ::_exit(3); // a thread works still
  }

  template <typename Work>
  void follow(const Work& work)
  {
    Task_report report;
    while(true)
    {
      MPI_Send(&report, sizeof(report), MPI_BYTE, 0, tag_of_reports, m_world);
      while(! m_world.iprobe(0, tag_of_tasks))
        pause_briefly();
      Task task = Task_report::no_task;
      MPI_Recv(&task, 1, MPI_UINT64_T, 0, tag_of_tasks, m_world, MPI_STATUS_IGNORE);
      if(task == Task_report::no_task)
        return;
      report = do_task(work, task);
    }
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_TASK_FARM_H

#ifndef BOUNDARY_RECOVERY_3_PROGRAM_TASK_FARM_H
#define BOUNDARY_RECOVERY_3_PROGRAM_TASK_FARM_H

#include "mpi_exchange.h"

#include <boost/mpi/communicator.hpp>
#include <boost/mpi/environment.hpp>

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <functional>
#include <future>
#include <iostream>
#include <map>
#include <mutex>
#include <numeric>
#include <string>
#include <utility>
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

// The tasks that are under way on a rank, each in a thread beside the one that talks to other ranks.
class Task_crew
{
  const std::size_t m_size; // tasks at the same time
  std::mutex m_mutex;
  std::condition_variable m_condition;
  std::vector<Task_report> m_finished; // with room for all, as no memory may be there when they end
  std::map<std::uint64_t, std::future<void> > m_under_way; // by task

public:
  explicit Task_crew(const std::size_t size) : m_size(size) { m_finished.reserve(size); }

  std::size_t size() const { return m_size; }
  std::size_t number_under_way() const { return m_under_way.size(); }
  bool is_busy() const { return m_under_way.size() == m_size; }

  // `work(task)` returns a report with the task, and never throws.
  template <typename Work>
  void begin(const std::uint64_t task, const Work& work)
  {
    m_under_way[task] = std::async(std::launch::async, [this, task, work]
    {
      const Task_report report = work(task);
      const std::lock_guard<std::mutex> lock(m_mutex);
      m_finished.push_back(report);
      m_condition.notify_one();
    });
  }

  // what was finished since the last call
  std::vector<Task_report> finished()
  {
    std::unique_lock<std::mutex> lock(m_mutex);
    return taken(lock);
  }

  // The same; waits until there is something.
  std::vector<Task_report> wait_for_finished()
  {
    std::unique_lock<std::mutex> lock(m_mutex);
    m_condition.wait(lock, [this] { return ! m_finished.empty(); });
    return taken(lock);
  }

private:
  std::vector<Task_report> taken(std::unique_lock<std::mutex>& lock)
  {
    const std::vector<Task_report> reports = m_finished;
    m_finished.clear();
    lock.unlock(); // which the threads that are waited for may need
    for(const Task_report& report : reports)
      m_under_way.erase(report.task);
    return reports;
  }
};

// Rank 0 hands out tasks, the heaviest ones first, and works as well. A rank may work on several tasks at once, in
// threads beside the one that talks to other ranks. Which rank does a task, and when, depends on how fast they are;
// results must not depend on that. It is only MPI's calls of one thread that are needed.
class Task_farm
{
  typedef boost::mpi::communicator Communicator;
  typedef std::uint64_t            Task;

  static constexpr int tag_of_reports = 1, tag_of_tasks = 2;

  const Communicator& m_world;
  const std::size_t m_tasks_at_once;    // of this rank: so many workers, each of which does one at a time
  std::function<std::string(std::size_t)> m_name; // of a task, in messages
  std::function<void()> m_clean_up;     // before rank 0 ends all ranks
  std::vector<Task> m_order;            // the heaviest first
  std::size_t m_next = 0;
  std::map<Task, int> m_under_way;      // and the rank of each
  std::vector<long> m_processes;        // of each rank on this machine; 0 on others
  std::vector<Task_report> m_reports;
  std::size_t m_number_of_waiting = 0;  // workers of other ranks that were told that there is nothing more to do

public:
  // This rank works on so many tasks at once; other ranks may have other numbers. `name(task)` is what a task is called
  // in messages; `clean_up()` is called by rank 0 before all ranks end at once.
  template <typename Name, typename Clean_up>
  Task_farm(const Communicator& world, const std::size_t tasks_at_once, const Name& name, const Clean_up& clean_up)
    : m_world(world), m_tasks_at_once(tasks_at_once), m_name(name), m_clean_up(clean_up)
  { }

  // does the tasks, and returns what is told of each of them, on all ranks. `work(task)` returns a report. If it
  // throws, or if a rank dies, rank 0 says which task that was, and all ranks end at once.
  template <typename Work>
  std::vector<Task_report> operator()(const std::vector<double>& weights, const Work& work)
  {
    m_reports.assign(weights.size(), Task_report());
    exchange_processes();
    Task_crew crew((std::min)(m_tasks_at_once, weights.size()));
    const auto crews = Mpi_exchange(m_world).gathered(crew.size());
    const auto begin_task = [&](const Task task) { crew.begin(task, [&](const Task t) { return do_task(work, t); }); };
    if(m_world.rank() == 0)
      lead(weights, crew, std::accumulate(crews.begin() + 1, crews.end(), std::size_t(0)), begin_task);
    else
      follow(crew, begin_task);
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

  void lead(const std::vector<double>& weights, Task_crew& crew, const std::size_t number_of_other_workers,
            const std::function<void(Task)>& begin_task)
  {
    m_order.resize(weights.size());
    std::iota(m_order.begin(), m_order.end(), Task(0));
    std::stable_sort(m_order.begin(), m_order.end(), [&](const Task a, const Task b)
                     { return weights[a] > weights[b]; });
    struct sigaction action = {}, previous = {};
    action.sa_handler = task_farm_internal::note_termination;
    sigaction(SIGTERM, &action, &previous);
    while(crew.number_under_way() > 0 || m_next < m_order.size() || m_number_of_waiting < number_of_other_workers)
    {
      while(! crew.is_busy() && m_next < m_order.size())
        begin_task(next_task(0));
      bool is_idle = ! receive_report();
      for(const Task_report& report : crew.finished())
      {
        take(report);
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

  Task next_task(const int rank)
  {
    if(m_next == m_order.size())
      return Task_report::no_task;
    m_under_way[m_order[m_next]] = rank;
    return m_order[m_next++];
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
    const Task task = next_task(message->source());
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
    m_under_way.erase(report.task);
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
        const char* before_name = " while it meshed ";
        for(const auto& [task, rank] : m_under_way)
          if(static_cast<std::size_t>(rank) == r)
            std::cerr << std::exchange(before_name, " and ") << name(task);
        std::cerr << std::endl;
      }
    if(! is_any_gone)
    {
      std::cerr << "mesh_surface_mpi: ended from outside; under way:";
      for(const auto& [task, rank] : m_under_way)
        std::cerr << ' ' << name(task) << " on rank " << rank << ';';
      std::cerr << std::endl;
    }
    std::cerr << "mesh_surface_mpi: with --work, what is finished is not meshed again" << std::endl;
    m_clean_up();
    ::_exit(3); // a thread works still
  }

  // Each worker asks for its first task; then each report asks for the next one. While all of them work, nothing is to
  // be heard of rank 0.
  void follow(Task_crew& crew, const std::function<void(Task)>& begin_task) const
  {
    for(std::size_t k = 0; k < crew.size(); ++k)
      send(Task_report());
    std::size_t number_of_waiting = 0; // workers that have nothing more to do
    while(number_of_waiting < crew.size())
    {
      const bool is_answer_due = crew.number_under_way() + number_of_waiting < crew.size();
      const auto finished = is_answer_due ? crew.finished() : crew.wait_for_finished();
      for(const Task_report& report : finished)
        send(report);
      if(m_world.iprobe(0, tag_of_tasks))
      {
        Task task = Task_report::no_task;
        MPI_Recv(&task, 1, MPI_UINT64_T, 0, tag_of_tasks, m_world, MPI_STATUS_IGNORE);
        if(task == Task_report::no_task)
          ++number_of_waiting;
        else
          begin_task(task);
      }
      else if(finished.empty())
        pause_briefly();
    }
  }

  void send(const Task_report& report) const
  {
    MPI_Send(&report, sizeof(report), MPI_BYTE, 0, tag_of_reports, m_world);
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_TASK_FARM_H

#ifndef BOUNDARY_RECOVERY_3_PROGRAM_DISTRIBUTED_MESHING_H
#define BOUNDARY_RECOVERY_3_PROGRAM_DISTRIBUTED_MESHING_H

#include "byte_string.h"
#include "mpi_exchange.h"
#include "part_bytes.h"
#include "part_store.h"
#include "task_farm.h"

#include <CGAL/Boundary_recovery_3/internal/owners/Divide_space_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Mesh_part_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Seams_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Work_on_part_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/util/for_each_task.h>
#include <CGAL/Real_timer.h>

#include <boost/mpi/communicator.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// What is done in a round. A task is a part of the mesh, or a zone of cells where parts meet.
struct Round_plan
{
  struct Task
  {
    std::vector<std::uint32_t> parts; // that have cells in it, in their order
    std::uint64_t number_of_cells = 0;
    std::uint32_t owner = 0;          // the one of them that it will belong to
  };

  std::uint64_t number_of_vertices = 0; // numbers from there on are free; some before are of vertices that are gone
  std::uint64_t number_of_vertices_in_mesh = 0;
  std::uint64_t number_of_parts = 0;
  std::uint64_t is_field_resolved = true; // by the rounds before
  std::vector<Task> tasks;

  Bytes bytes() const
  {
    Bytes result;
    Byte_writer writer(result);
    writer.put(number_of_vertices);
    writer.put(number_of_vertices_in_mesh);
    writer.put(number_of_parts);
    writer.put(is_field_resolved);
    writer.put(std::uint64_t(tasks.size()));
    for(const Task& task : tasks)
    {
      writer.put(task.number_of_cells);
      writer.put(task.owner);
      writer.put(task.parts);
    }
    return result;
  }

  static Round_plan from_bytes(const Bytes& bytes)
  {
    Round_plan plan;
    Byte_reader reader(bytes);
    plan.number_of_vertices = reader.get<std::uint64_t>();
    plan.number_of_vertices_in_mesh = reader.get<std::uint64_t>();
    plan.number_of_parts = reader.get<std::uint64_t>();
    plan.is_field_resolved = reader.get<std::uint64_t>();
    for(std::uint64_t n = reader.get<std::uint64_t>(); n > 0; --n)
    {
      Task task;
      task.number_of_cells = reader.get<std::uint64_t>();
      task.owner = reader.get<std::uint32_t>();
      reader.get(task.parts);
      plan.tasks.push_back(std::move(task));
    }
    return plan;
  }
};

// what is told of a round that is done
struct Round_report
{
  CGAL::Boundary_recovery_3::internal::Subdomain_round round;
  double seconds_of_plan = 0, seconds_of_work = 0;
  std::vector<double> weights;
  std::vector<Task_report> tasks;

  bool is_field_resolved() const
  {
    return std::all_of(tasks.begin(), tasks.end(), [](const Task_report& task) { return task.is_field_resolved; });
  }
};

// Fills and improves a mesh that is divided into parts, in rounds. The parts are files that all ranks see. In each
// round, rank 0 hands out the tasks; what comes of them are files, too. Then each rank looks for the next seams in its
// share of the parts. So no thread has more than a task, or a part, and no rank more than the bare tetrahedra of its
// share.
//
// `Work` makes of a part what it is to become.
template <typename Tr, typename Work>
class Distributed_meshing
{
public:
  typedef CGAL::Boundary_recovery_3::internal::Mesh_part_3<Tr> Part;

private:
  typedef CGAL::Boundary_recovery_3::internal::Subdomain_round        Round;
  typedef CGAL::Boundary_recovery_3::internal::Join_parts_3<Tr>       Join_parts;
  typedef CGAL::Boundary_recovery_3::internal::Seam_part_3            Seam_part;
  typedef CGAL::Boundary_recovery_3::internal::Seams_3<Mpi_exchange>  Seams;
  typedef CGAL::Boundary_recovery_3::internal::Split_part_3<Tr>       Split_part;

  // of the cells of a part
  struct Share
  {
    std::size_t part;
    std::size_t index;
  };

  const boost::mpi::communicator& m_world;
  const Mpi_exchange m_exchange;
  const Part_store& m_store;
  const Work& m_work;
  const std::vector<Round> m_rounds;
  const std::size_t m_max_number_of_vertices;
  const std::size_t m_number_of_threads; // of this rank
  std::size_t m_round = 0; // that is to be done, or was done last
  Round_plan m_plan;
  std::vector<std::vector<std::size_t> > m_tasks_of_part; // those that have cells of it
  std::vector<std::uint64_t> m_shifts;                    // of the numbers of new vertices, by task; then their sum
  std::vector<Share> m_shares;                            // what each part is in the end: of itself, if it had cells
  std::vector<std::size_t> m_numbers_of_shares;           // into which each part is divided then
  std::vector<Round_report> m_reports;

public:
  Distributed_meshing(const boost::mpi::communicator& world, const Part_store& store, const Work& work,
                      const std::vector<Round>& rounds, const std::size_t max_number_of_vertices,
                      const std::size_t number_of_threads)
    : m_world(world), m_exchange(world), m_store(store), m_work(work), m_rounds(rounds),
      m_max_number_of_vertices(max_number_of_vertices), m_number_of_threads(number_of_threads)
  { }

  // whether an earlier run came to one of the rounds; then it is continued
  bool resume()
  {
    std::size_t number = 0; // of rounds that are begun
    Bytes ignored;
    for(std::size_t r = 0; m_exchange.is_first() && r < m_rounds.size(); ++r)
      if(m_store.load(plan_name(r), 0, ignored))
        number = r + 1;
    number = m_exchange.gathered(number).front();
    if(number > 0)
      load_plan(number - 1);
    return number > 0;
  }

  // Rank 0 has the parts, in which vertices have numbers up to the first one that is free.
  void begin(std::vector<Part>&& parts, const std::size_t first_free_number, const std::size_t number_of_vertices)
  {
    if(m_exchange.is_first())
    {
      Round_plan plan;
      plan.number_of_vertices = first_free_number;
      plan.number_of_vertices_in_mesh = number_of_vertices;
      plan.number_of_parts = parts.size();
      for(std::uint32_t p = 0; p < parts.size(); ++p)
      {
        save(p, 0, Part(), { parts[p] });
        if(parts[p].number_of_cells() > 0)
          plan.tasks.push_back({ { p }, parts[p].number_of_cells(), p });
        parts[p] = Part();
      }
      m_store.save(plan_name(0), { plan.bytes() });
    }
    m_exchange.wait();
    load_plan(0);
  }

  void run()
  {
    for(; ; ++m_round)
    {
      do_tasks();
      if(m_round + 1 == m_rounds.size())
        return share_with_empty_parts();
      CGAL::Boundary_recovery_3::internal::with_threads(m_number_of_threads, [this] { plan_next(); });
    }
  }

  const std::vector<Round_report>& reports() const { return m_reports; }
  std::size_t number_of_parts() const { return static_cast<std::size_t>(m_plan.number_of_parts); }

  // By all rounds.
  bool is_field_resolved() const { return m_plan.is_field_resolved && m_reports.back().is_field_resolved(); }

  bool is_own(const std::size_t part) const
  {
    return static_cast<int>(part % static_cast<std::size_t>(m_exchange.size())) == m_exchange.rank();
  }

  // a part in the end
  Part part(const std::size_t p) const
  {
    const auto [source, index] = m_shares[p];
    Part whole = part_after_round(source);
    if(m_numbers_of_shares[source] == 1)
      return whole;
    const std::vector<std::uint32_t> shares = shares_of_cells(whole, m_numbers_of_shares[source]);
    for(auto& [share, part] : Split_part()(whole, shares))
      if(share == index)
        return std::move(part);
    return Part();
  }

private:
  static std::string plan_name(const std::size_t round) { return "plan_" + std::to_string(round); }

  static std::string parts_name(const std::size_t round, const std::size_t part)
  {
    return "part_" + std::to_string(round) + '_' + std::to_string(part);
  }

  std::string result_name(const std::size_t task) const
  {
    return "result_" + std::to_string(m_round) + '_' + std::to_string(task);
  }

  // that was done last
  Part part_after_round(const std::size_t p) const
  {
    Join_parts join;
    join.add(load(parts_name(m_round, p), 0));
    for(const std::size_t k : m_tasks_of_part[p])
      if(m_plan.tasks[k].owner == p)
        join.add(load(result_name(k), 1), static_cast<std::size_t>(m_plan.number_of_vertices),
                 static_cast<std::size_t>(m_shifts[k]));
    return join.joined();
  }

  Part load(const std::string& name, const std::size_t record) const
  {
    Bytes bytes;
    if(! m_store.load(name, record, bytes))
      throw std::runtime_error(m_store.file_of(name) + " is not there, or not as it was written");
    return Part_bytes<Tr>::to_part(bytes);
  }

  // what is left of a part in a round, and what of it is worked on
  void save(const std::size_t p, const std::size_t round, const Part& left, const std::vector<Part>& pieces) const
  {
    std::vector<Bytes> records(1, Part_bytes<Tr>::from_part(left));
    for(const Part& piece : pieces)
      records.push_back(Part_bytes<Tr>::from_part(piece));
    m_store.save(parts_name(round, p), records);
  }

  void load_plan(const std::size_t round)
  {
    Bytes bytes;
    if(! m_store.load(plan_name(round), 0, bytes))
      throw std::runtime_error(m_store.file_of(plan_name(round)) + " is not there: --work has to be a folder that all "
                               "ranks see");
    m_round = round;
    set_plan(Round_plan::from_bytes(bytes));
  }

  void set_plan(const Round_plan& plan)
  {
    m_plan = plan;
    m_tasks_of_part.assign(number_of_parts(), { });
    for(std::size_t k = 0; k < plan.tasks.size(); ++k)
      for(const std::uint32_t p : plan.tasks[k].parts)
        m_tasks_of_part.at(p).push_back(k);
  }

  // Where in the file of a part its cells for a task are: behind what is left of it.
  std::size_t record(const std::uint32_t part, const std::size_t task) const
  {
    const auto& tasks = m_tasks_of_part[part];
    return 1 + static_cast<std::size_t>(std::lower_bound(tasks.begin(), tasks.end(), task) - tasks.begin());
  }

  // in messages
  std::string name_of(const std::size_t task) const
  {
    const auto& parts = m_plan.tasks[task].parts;
    std::string name = (parts.size() == 1) ? "sub-domain " : "the seam of the sub-domains ";
    for(std::size_t k = 0; k < parts.size(); ++k)
      name += (k > 0 ? ", " : "") + std::to_string(parts[k] + 1);
    return name;
  }

  void do_tasks()
  {
    Round_report report{ m_rounds[m_round], 0, 0, { }, { } };
    std::vector<std::size_t> numbers_of_cells;
    for(const auto& task : m_plan.tasks)
    {
      numbers_of_cells.push_back(static_cast<std::size_t>(task.number_of_cells));
      report.weights.push_back(static_cast<double>(task.number_of_cells));
    }
    const auto shares = CGAL::Boundary_recovery_3::internal::shares_of_vertices(number_left({ }), numbers_of_cells);
    CGAL::Real_timer timer;
    timer.start();
    report.tasks = Task_farm(m_world, m_number_of_threads, [this](const std::size_t k) { return name_of(k); },
                             [this] { m_store.remove_temporary_folder(); })
      (report.weights, [&](const std::size_t k) { return do_task(k, shares[k], false); });
    work_with_what_is_left(report);
    report.seconds_of_work = timer.time();
    m_shifts.assign(1, 0);
    for(const Task_report& task : report.tasks)
      m_shifts.push_back(m_shifts.back() + task.new_vertices);
    m_reports.push_back(report);
  }

  // The tasks whose share of the vertices was too small come one after the other.
  void work_with_what_is_left(Round_report& report) const
  {
    for(std::size_t k = 0; k < report.tasks.size(); ++k)
      if(report.tasks[k].was_full)
        report.tasks[k] = Task_farm(m_world, 1, [&](const std::size_t) { return name_of(k); },
                                    [this] { m_store.remove_temporary_folder(); })
          ({ report.weights[k] },
           [&](const std::size_t) { return do_task(k, number_left(report.tasks), true); }).front();
  }

  // Of vertices that may be inserted after some tasks of the round.
  std::size_t number_left(const std::vector<Task_report>& tasks) const
  {
    const std::uint64_t number = number_after(tasks), max_number = m_max_number_of_vertices;
    return static_cast<std::size_t>(max_number - (std::min)(max_number, number));
  }

  std::uint64_t number_after(const std::vector<Task_report>& tasks) const
  {
    std::uint64_t number = m_plan.number_of_vertices_in_mesh;
    for(const Task_report& task : tasks)
      number += static_cast<std::uint64_t>(task.gained_vertices);
    return number;
  }

  // The result has two records: the report, and the cells. There is none if more new vertices are needed, unless it is
  // the last try.
  Task_report do_task(const std::size_t k, const std::size_t max_number_of_new_vertices, const bool is_last_try) const
  {
    Bytes report_bytes, cells;
    Task_report report;
    if(m_store.load(result_name(k), 0, report_bytes) && m_store.load(result_name(k), 1, cells))
    {
      report = Byte_reader(report_bytes).get<Task_report>();
      report.is_stored = true;
      return report;
    }
    Join_parts join;
    for(const std::uint32_t p : m_plan.tasks[k].parts)
      join.add(load(parts_name(m_round, p), record(p, k)));
    Part part = join.joined();
    CGAL::Boundary_recovery_3::internal::Mesh_visitor_3<Tr> visitor;
    const std::size_t number_of_vertices = static_cast<std::size_t>(m_plan.number_of_vertices);
    report.gained_vertices = - static_cast<std::int64_t>(part.vertices.size());
    const auto work_report = m_work(part, m_rounds[m_round], number_of_vertices, max_number_of_new_vertices, visitor,
                                    (std::numeric_limits<double>::infinity)());
    report.is_field_resolved = work_report.filling.is_field_resolved;
    if(work_report.was_full && ! is_last_try)
      return task_to_be_done_again();
    check(work_report.filling);
    report.gained_vertices += static_cast<std::int64_t>(part.vertices.size());
    for(const auto& v : part.vertices)
      report.new_vertices += v.number >= m_plan.number_of_vertices;
    report.tetrahedra = part.number_of_cells();
    cells = Part_bytes<Tr>::from_part(part);
    report.bytes = cells.size();
    report_bytes.clear();
    Byte_writer(report_bytes).put(report);
    m_store.save(result_name(k), { report_bytes, cells });
    return report;
  }

  static Task_report task_to_be_done_again()
  {
    Task_report report;
    report.was_full = true;
    return report;
  }

  template <typename Filling>
  void check(const Filling& filling) const
  {
    for(const auto& invalid : filling.invalid_sizes)
      throw std::runtime_error("a size is no positive number: " + std::to_string(invalid.size) + ' ' + invalid.message);
    if(! filling)
      throw std::runtime_error("the mesh needs more than " + std::to_string(m_max_number_of_vertices) + " vertices");
  }

  // What MPI is called for is done by the thread that called this.
  void plan_next()
  {
    CGAL::Real_timer timer;
    timer.start();
    Round_plan next;
    next.number_of_parts = m_plan.number_of_parts;
    next.number_of_vertices_in_mesh = number_after(m_reports.back().tasks);
    next.is_field_resolved = is_field_resolved();
    next.number_of_vertices = m_plan.number_of_vertices + m_shifts.back();
    if(m_rounds[m_round + 1].works_on_parts())
      plan_parts(next);
    else
      plan_zones(m_rounds[m_round + 1], next);
    m_exchange.wait(); // all parts are there
    if(m_exchange.is_first())
    {
      m_store.save(plan_name(m_round + 1), { next.bytes() });
      remove_files_of_round();
    }
    m_exchange.wait();
    set_plan(next);
    m_reports.back().seconds_of_plan = timer.time();
  }

  void plan_parts(Round_plan& plan) const
  {
    const std::vector<std::uint32_t> own = own_parts();
    std::vector<std::array<std::uint64_t, 2> > numbers_of_cells(own.size());
    for_each(own, [&](const std::size_t k)
    {
      const Part part = part_after_round(own[k]);
      save(own[k], m_round + 1, Part(), { part });
      numbers_of_cells[k] = {{ own[k], part.number_of_cells() }};
    });
    m_exchange.gather(numbers_of_cells);
    std::sort(numbers_of_cells.begin(), numbers_of_cells.end());
    for(const auto& [p, number] : numbers_of_cells)
      if(number > 0)
        plan.tasks.push_back({ { static_cast<std::uint32_t>(p) }, number, static_cast<std::uint32_t>(p) });
  }

  // Each part is loaded twice, so that it need not be kept.
  void plan_zones(const Round& round, Round_plan& plan) const
  {
    const std::vector<std::uint32_t> own = own_parts();
    std::vector<Seam_part> seam_parts(own.size(), Seam_part(0, Part()));
    for_each(own, [&](const std::size_t k)
    {
      seam_parts[k] = m_work.seam_part(own[k], part_after_round(own[k]), round);
    });
    Seams seams(seam_parts, round.number_of_layers, m_exchange);
    for(const auto& zone : seams.find_zones(round.number_of_parts, round.max_number_of_connected_vertices()))
      plan.tasks.push_back({ zone.parts, zone.number_of_cells, zone.owner });
    for_each(own, [&](const std::size_t k)
    {
      Part left = part_after_round(own[k]);
      std::vector<Part> pieces;
      for(auto& group : Split_part()(left, seam_parts[k].zone_of_cell))
        pieces.push_back(std::move(group.second));
      save(own[k], m_round + 1, left, pieces);
    });
  }

  // Where parts are small, zones are as large as several of them, and their owners have got all cells of some other
  // parts. In the end, these get shares of the largest ones.
  void share_with_empty_parts()
  {
    m_shares.clear();
    for(std::size_t p = 0; p < number_of_parts(); ++p)
      m_shares.push_back({ p, 0 });
    m_numbers_of_shares.assign(number_of_parts(), 1);
    const std::vector<std::uint32_t> own = own_parts();
    if(m_exchange.do_all_agree(std::none_of(own.begin(), own.end(), [this](const auto p) { return is_empty(p); })))
      return;
    std::vector<std::array<std::size_t, 2> > numbers_of_cells;
    for(const std::uint32_t p : own)
      numbers_of_cells.push_back({{ p, part_after_round(p).number_of_cells() }});
    m_exchange.gather(numbers_of_cells);
    std::sort(numbers_of_cells.begin(), numbers_of_cells.end());
    const auto cells_of_share = [this](const auto& n) { return n[1] / m_numbers_of_shares[n[0]]; };
    for(const auto& [p, number] : numbers_of_cells)
      if(number == 0)
      {
        const std::size_t largest = (*std::max_element(numbers_of_cells.begin(), numbers_of_cells.end(),
          [&](const auto& x, const auto& y) { return cells_of_share(x) < cells_of_share(y); }))[0];
        m_shares[p] = { largest, m_numbers_of_shares[largest]++ };
      }
  }

  // after the round that was done last
  bool is_empty(const std::size_t p) const
  {
    return std::none_of(m_tasks_of_part[p].begin(), m_tasks_of_part[p].end(),
                        [&](const std::size_t k) { return m_plan.tasks[k].owner == p; })
           && load(parts_name(m_round, p), 0).number_of_cells() == 0;
  }

  // Shares are compact: cells are divided by place.
  static std::vector<std::uint32_t> shares_of_cells(const Part& part, const std::size_t number_of_shares)
  {
    namespace internal = CGAL::Boundary_recovery_3::internal;
    std::vector<internal::Coordinates_3> centroids;
    internal::Divide_space_3 space(number_of_shares, 0);
    for(std::size_t cell = 0; cell < part.number_of_cells(); ++cell)
    {
      centroids.push_back(internal::centroid(part.corners(cell)));
      space.add(centroids.back(), 1);
    }
    space();
    std::vector<std::uint32_t> shares;
    for(const auto& c : centroids)
      shares.push_back(space.part_of(c) - 1u);
    return shares;
  }

  std::vector<std::uint32_t> own_parts() const
  {
    std::vector<std::uint32_t> parts;
    for(std::uint32_t p = 0; p < number_of_parts(); ++p)
      if(is_own(p))
        parts.push_back(p);
    return parts;
  }

  // Does `work(k)` for each part of a list. How large parts are, only their files know.
  template <typename Do>
  static void for_each(const std::vector<std::uint32_t>& parts, const Do& work)
  {
    typedef CGAL::Boundary_recovery_3::internal::Concurrency_tag_of<Tr> Concurrency_tag;
    CGAL::Boundary_recovery_3::internal::for_each_task(std::vector<std::size_t>(parts.size(), 1), work,
                                                       Concurrency_tag());
  }

  void remove_files_of_round() const
  {
    for(std::size_t p = 0; p < number_of_parts(); ++p)
      m_store.remove(parts_name(m_round, p));
    for(std::size_t k = 0; k < m_plan.tasks.size(); ++k)
      m_store.remove(result_name(k));
    m_store.remove(plan_name(m_round));
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_DISTRIBUTED_MESHING_H

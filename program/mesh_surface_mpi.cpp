// Meshes what a surface bounds in sub-domains, with the processes of MPI on one or more machines.
// `mesh_surface_mpi --help` tells the options.
//
// Rank 0 recovers the boundary, fills the domain coarsely, and divides it into parts. What is done with the parts, and
// with the seams between them, is handed out to all the ranks. The parts are files that all of them see. With several
// threads, a rank works on several parts at once.

#include <CGAL/make_boundary_constrained_mesh_3.h>

#include "byte_string.h"
#include "default_flow.h"
#include "distributed_meshing.h"
#include "domain.h"
#include "domain_quality.h"
#include "domain_sides.h"
#include "interruption.h"
#include "lower_case.h"
#include "mesh_size.h"
#include "mesh_surface_mpi_options.h"
#include "mpi_exchange.h"
#include "named_regions.h"
#include "output_buffer.h"
#include "part_piece.h"
#include "part_store.h"
#include "print_mesh.h"
#include "program.h"
#include "second_order.h"
#include "task_farm.h"
#include "whole_file.h"
#include "write_mesh_report.h"

#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/Cell_quality_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Field_point_insertion_3.h>
#include <CGAL/Boundary_recovery_3/internal/meshing/Boundary_constrained_meshing_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Decomposition_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Part_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Work_on_part_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Real_timer.h>

#include <boost/mpi/communicator.hpp>
#include <boost/mpi/environment.hpp>

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace internal = CGAL::Boundary_recovery_3::internal;

typedef CGAL::Exact_predicates_inexact_constructions_kernel           Kernel;
typedef Kernel::Point_3                                               Point;
typedef CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type Triangulation;
typedef CGAL::Boundary_constrained_mesh_result_3<Triangulation>       Result;
typedef CGAL::Boundary_recovery_3::Dihedral_angle_quality_3           Quality;
typedef CGAL::Boundary_recovery_3::Meshing_status                     Status;
typedef Mesh_size<Triangulation>                                      Size;
typedef internal::Mesh_part_3<Triangulation>                          Part;
typedef internal::Any_size_field_3<Kernel, Size>                      Any_size;
typedef internal::Work_on_part_3<Triangulation, Quality>              Work;

class Mpi_mesher
{
  typedef Distributed_meshing<Triangulation, Work> Meshing;

  const boost::mpi::communicator& m_world;
  const Mpi_exchange m_exchange;
  const Mpi_options& m_options;
  Program<Point>& m_program;
  Size m_size;
  Part_store m_store;          // where the parts are
  std::vector<Sides> m_sides;  // of the triangles of the surface
  std::map<int, std::string> m_region_names;
  std::vector<Round_report> m_reports;
  Mesh_quality m_quality;
  bool m_is_field_resolved = true;
  std::size_t m_number_of_tetrahedra = 0;
  std::vector<double> m_memory; // of each rank, its peak in bytes
  CGAL::Real_timer m_division_timer, m_meshing_timer, m_output_timer;

public:
  Mpi_mesher(const boost::mpi::communicator& world, const Mpi_options& options, Program<Point>& program)
    : m_world(world), m_exchange(world), m_options(options), m_program(program)
  { }

  ~Mpi_mesher()
  {
    if(m_exchange.is_first())
      m_store.remove_temporary_folder();
  }

  // returns the exit status, the same one on all ranks
  int operator()()
  {
    std::string message;
    if(! m_exchange.do_all_agree(read(message)) || ! have_all_the_same_input(message) ||
       ! m_exchange.do_all_agree(open_store(message)))
      return tell(message);
    const Any_size size = this->size();
    const Work work(size, Quality(), m_options.min_angle, m_options.effort);
    Meshing meshing(m_world, m_store, work, rounds(), m_options.maximum_number_of_vertices,
                    m_options.number_of_threads);
    m_division_timer.start();
    const int status = meshing.resume() ? int(success) : divide(meshing);
    m_division_timer.stop();
    if(status != success) // it is that of all ranks, but is told once
      return status;
    m_meshing_timer.start();
    meshing.run();
    m_meshing_timer.stop();
    m_reports = meshing.reports();
    m_is_field_resolved = meshing.is_field_resolved();
    gather_memory();
    m_output_timer.start();
    const bool are_written = write_outputs(meshing, message);
    m_output_timer.stop();
    if(! m_exchange.do_all_agree(are_written) || ! m_exchange.do_all_agree(write_report(message)))
      return tell(message);
    print_summary();
    return success;
  }

private:
  const Size m_no_size = Size::unbounded();

  Any_size size() const { return Any_size(m_options.insert_field_points ? m_size : m_no_size); }

  std::vector<internal::Subdomain_round> rounds() const
  {
    std::vector<internal::Subdomain_round> rounds = internal::filling_rounds();
    if(m_options.improve_quality && m_options.insert_field_points)
      for(const auto& round : internal::improving_rounds())
        rounds.push_back(round);
    return rounds;
  }

  int tell(const std::string& message) const
  {
    return message.empty() ? int(usage_or_file_error) : m_program.fail(message);
  }

  bool read(std::string& message)
  {
    if(! m_program.keeps_inputs(input_files(m_options)) || ! m_program.read_surface(default_flow<Point>))
      message = m_program.message();
    else if(m_size.read(m_options, message) && m_exchange.is_first() && ! m_program.can_write())
      message = m_program.message();
    if(! message.empty())
      return false;
    m_program.prepare_surface();
    m_program.add_places(m_options.regions, m_options.voids);
    m_size.set_surface(m_program.surface(), m_options);
    return true;
  }

  std::uint64_t key() const
  {
    std::vector<std::string> files = input_files(m_options);
    files.erase(files.begin()); // of the surface, it counts what was made of it
    return key_of_mesh(m_program.surface(), m_options, BOUNDARY_RECOVERY_3_VERSION, files);
  }

  bool have_all_the_same_input(std::string& message) const
  {
    const std::vector<std::uint64_t> keys = m_exchange.gathered(key());
    for(std::size_t r = 1; r < keys.size(); ++r)
      if(keys[r] != keys[0])
      {
        message = "rank " + std::to_string(r) + " has another surface, or other sizes or options, than rank 0";
        return false;
      }
    return true;
  }

  // If nothing is to be kept, the folder is a temporary one.
  bool open_store(std::string& message)
  {
    try
    {
      std::string folder = m_options.work;
      if(folder.empty())
      {
        const long process = m_exchange.gathered(static_cast<long>(::getpid())).front();
        folder = (std::filesystem::temp_directory_path() / ("mesh_surface_mpi_" + std::to_string(process))).string();
      }
      m_store = Part_store(folder, key(), ! m_options.work.empty());
    }
    catch(const std::exception& e)
    {
      message = e.what();
    }
    return message.empty();
  }

  // Some numbers are of vertices that are gone.
  struct Numbers_of_vertices
  {
    std::size_t first_free = 0;
    std::size_t in_mesh = 0;
  };

  // Rank 0 recovers the boundary, and divides what it bounds.
  int divide(Meshing& meshing)
  {
    std::vector<Part> parts;
    Numbers_of_vertices numbers;
    int status = success;
    if(m_exchange.is_first())
      status = divide(parts, numbers);
    m_exchange.wait();
    status = m_exchange.gathered(status).front();
    if(status == success)
      meshing.begin(std::move(parts), numbers.first_free, numbers.in_mesh);
    return status;
  }

  int divide(std::vector<Part>& parts, Numbers_of_vertices& numbers)
  {
    const Surface<Point>& surface = m_program.surface();
    Triangulation tr;
    Result result = CGAL::make_boundary_constrained_mesh_3(tr, surface.points, surface.faces, Size::unbounded(),
                                                           CGAL::parameters::list_defects(m_options.list_defects),
                                                           CGAL::parameters::improve_quality(false),
                                                           CGAL::parameters::void_points(surface.voids));
    if(result.recovery.status == CGAL::Boundary_recovery_3::Recovery_status::invalid_input)
    {
      Domain<Point> nothing;
      m_program.use_numbers_of_file(result.recovery, nothing);
      return m_program.refuse_input(result.recovery);
    }
    Named_regions regions;
    regions.find(tr, surface.regions);
    if(! regions.message().empty() || ! result.invalid_void_points.empty())
    {
      m_program.fail(regions.message().empty() ? "a place that is to be empty is outside, or on the surface"
                                               : regions.message());
      return invalid_input;
    }
    const std::string reason = reason_for_no_mesh(result, m_options.maximum_number_of_vertices);
    if(! reason.empty())
      return cannot_mesh(reason);
    store_sides(tr, result, regions);
    const internal::Hold_recovered_vertices_3<Triangulation> hold(tr, result.recovery);
    return divide(tr, result, parts, numbers);
  }

  int divide(Triangulation& tr, const Result& result, std::vector<Part>& parts, Numbers_of_vertices& numbers)
  {
    constexpr double forever = std::numeric_limits<double>::infinity();
    const Any_size size = this->size();
    internal::Mesh_visitor_3<Triangulation> visitor;
    auto domain = internal::domain_with_edges(tr, result.constrained_edges);
    internal::Field_point_insertion_3<Triangulation> insertion(tr, domain, size, visitor);
    const auto forecast = insertion.forecast_only(m_options.maximum_number_of_vertices, forever);
    if(! forecast.invalid_sizes.empty())
      return refuse(forecast.invalid_sizes.front());
    if(! forecast)
      return cannot_mesh("there would be about "
                         + std::to_string(static_cast<std::uint64_t>(forecast.forecast_of_vertices)) + " points");
    const std::size_t n = m_options.number_of_subdomains;
    const auto filling = internal::Fill_background_3<Triangulation>(size, forecast.forecast_of_cells, n)
      (tr, domain, visitor, m_options.maximum_number_of_vertices, forever);
    if(filling.status == Status::too_large)
      return cannot_mesh("there would be about "
                         + std::to_string(static_cast<std::uint64_t>(filling.forecast_of_vertices)) + " points");
    internal::Decomposition_3<Triangulation> decomposition(tr);
    parts = decomposition.divide(size, domain, result.constrained_edges, n, result.recovery.vertices);
    numbers = { decomposition.number_of_vertices(), tr.number_of_vertices() };
    return success;
  }

  int cannot_mesh(const std::string& reason) const
  {
    m_program.fail("there is no mesh: " + reason);
    return incomplete_or_stopped;
  }

  template <typename InvalidSize>
  int refuse(const InvalidSize& invalid) const
  {
    m_program.fail("invalid input, a size is " + std::to_string(invalid.size) + ' ' + invalid.message);
    return invalid_input;
  }

  // What is on both sides of each triangle, and the names of regions, are needed again for the output.
  void store_sides(const Triangulation& tr, const Result& result, const Named_regions& regions) const
  {
    const Domain<Point> domain = make_meshed_domain(tr, result);
    const std::vector<Sides> sides = find_sides(domain);
    std::vector<Sides> sides_of_faces(m_program.surface().faces.size(), Sides{{ 0, 0 }});
    for(std::size_t t = 0; t < sides.size(); ++t)
      sides_of_faces.at(domain.triangle_numbers[t]) = sides[t];
    Bytes bytes;
    Byte_writer writer(bytes);
    writer.put(sides_of_faces);
    for(const auto& [region, name] : regions.names())
    {
      writer.put(region);
      writer.put(std::vector<char>(name.begin(), name.end()));
    }
    m_store.save("sides", { bytes });
  }

  void load_sides()
  {
    Bytes bytes;
    if(! m_store.load("sides", 0, bytes))
      throw std::runtime_error(m_store.file_of("sides") + " is not there, or not as it was written");
    Byte_reader reader(bytes);
    reader.get(m_sides);
    while(! reader.is_at_end())
    {
      const int region = reader.get<int>();
      std::vector<char> name;
      reader.get(name);
      m_region_names[region].assign(name.begin(), name.end());
    }
    if(m_sides.size() != m_program.surface().faces.size())
      throw std::runtime_error(m_store.file_of("sides") + " is of another surface");
  }

  bool write_outputs(const Meshing& meshing, std::string& message)
  {
    load_sides();
    m_program.set_patches();
    std::vector<std::string> merged, pieces;
    for(const std::string& file : m_options.outputs)
      (lower_case_extension(file) == ".pvtu" ? pieces : merged).push_back(file);
    if(! m_exchange.do_all_agree(write_pieces(meshing, pieces)))
      message = "cannot write " + pieces.front() + ", or its pieces";
    else if(m_exchange.is_first())
    {
      for(const std::string& file : pieces)
        if(! write_names_of_pieces(file, meshing.number_of_parts()))
          message = "cannot write " + file;
      if(! merged.empty())
        write_merged(meshing, merged, message);
    }
    return message.empty();
  }

  static std::string name_of_piece(const std::string& file, const std::size_t part)
  {
    return std::filesystem::path(file).stem().string() + '_' + std::to_string(part + 1) + ".vtu";
  }

  // Those of the parts of this rank; these are measured, too.
  bool write_pieces(const Meshing& meshing, const std::vector<std::string>& files)
  {
    const Part_pieces<Part, Point> pieces(m_program.surface(), m_sides);
    std::vector<Mesh_quality> qualities;
    bool are_written = true;
    for(std::size_t p = 0; p < meshing.number_of_parts(); ++p)
    {
      if(! meshing.is_own(p))
        continue;
      Vtu_piece numbers;
      numbers.part = static_cast<int>(p) + 1;
      Domain<Point> piece = pieces.piece(meshing.part(p), p == 0, numbers.numbers);
      piece.region_names = m_region_names;
      m_number_of_tetrahedra += piece.tetrahedra.size();
      CGAL::Boundary_recovery_3::internal::with_threads(m_options.number_of_threads, [&]
      {
        qualities.push_back(measure_quality(piece));
      });
      for(const std::string& file : files)
      {
        Whole_file whole((std::filesystem::path(file).parent_path() / name_of_piece(file, p)).string());
        Output_buffer os(whole.name());
        Vtu_writer<Point>(os, piece, &numbers)();
        are_written = os.close() && whole.finish() && are_written;
      }
    }
    m_exchange.gather(qualities);
    for(const Mesh_quality& quality : qualities)
      m_quality += quality;
    std::size_t sum = 0;
    for(const std::size_t n : m_exchange.gathered(m_number_of_tetrahedra))
      sum += n;
    m_number_of_tetrahedra = sum;
    return are_written;
  }

  // It is written when all of them are there.
  static bool write_names_of_pieces(const std::string& file, const std::size_t number_of_pieces)
  {
    std::vector<std::string> names;
    for(std::size_t p = 0; p < number_of_pieces; ++p)
      names.push_back(name_of_piece(file, p));
    Whole_file whole(file);
    Output_buffer os(whole.name());
    write_pvtu(os, names);
    return os.close() && whole.finish();
  }

  void write_merged(const Meshing& meshing, const std::vector<std::string>& files, std::string& message) const
  {
    const Part_pieces<Part, Point> pieces(m_program.surface(), m_sides);
    Domain<Point> domain = pieces.surface();
    domain.region_names = m_region_names;
    std::vector<Point_number> positions;
    std::vector<int> parts;
    for(std::size_t p = 0; p < meshing.number_of_parts(); ++p)
    {
      const Part part = meshing.part(p);
      pieces.add_to(domain, positions, part);
      if(m_options.pieces)
        parts.insert(parts.end(), part.number_of_cells(), static_cast<int>(p) + 1);
    }
    if(m_options.order == 2)
      add_edge_points(domain);
    for(const std::string& file : files)
      if(! write_whole_domain(file, domain, parts))
        message = "cannot write " + file;
  }

  void gather_memory()
  {
    rusage usage = {};
    getrusage(RUSAGE_SELF, &usage);
    m_memory = m_exchange.gathered(1024. * double(usage.ru_maxrss));
  }

  std::size_t number_of_stored() const
  {
    std::size_t number = 0;
    for(const Round_report& round : m_reports)
      for(const Task_report& task : round.tasks)
        number += task.is_stored;
    return number;
  }

  std::size_t number_of_tasks() const
  {
    std::size_t number = 0;
    for(const Round_report& round : m_reports)
      number += round.tasks.size();
    return number;
  }

  bool write_report(std::string& message)
  {
    if(! m_exchange.is_first() || m_program.write_report([&](Json_writer& json) { write_entries(json); }))
      return true;
    message = m_program.message();
    return false;
  }

  void write_entries(Json_writer& json) const
  {
    write_options(json, m_options);
    json.entry("number_of_ranks", m_exchange.size());
    json.entry("is_field_resolved", m_is_field_resolved);
    json.entry("number_of_tetrahedra", m_number_of_tetrahedra);
    write_quality(json, m_quality);
    json.entry("number_of_tasks", number_of_tasks());
    json.entry("number_of_stored_tasks", number_of_stored());
    json.entry("seconds_division", m_division_timer.time());
    json.entry("seconds_meshing", m_meshing_timer.time());
    json.entry("seconds_output", m_output_timer.time());
    json.key("peak_memory_of_ranks");
    json.list(m_memory, [&](const double bytes) { json.value(bytes); });
    json.key("rounds");
    json.objects(m_reports, [&](const Round_report& round)
    {
      json.entry("number_of_parts_that_meet", round.round.number_of_parts); // 1: parts; 0: around bad tetrahedra
      json.entry("improves", round.round.improves);
      json.entry("seconds_tasks", round.seconds_of_work);
      json.entry("seconds_seams", round.seconds_of_plan);
      json.key("tasks");
      std::size_t i = 0;
      json.objects(round.tasks, [&](const Task_report& task)
      {
        json.entry("weight", round.weights[i++]);
        json.entry("rank", task.rank);
        json.entry("seconds", task.seconds);
        json.entry("bytes", static_cast<std::size_t>(task.bytes));
        json.entry("tetrahedra", static_cast<std::size_t>(task.tetrahedra));
        json.entry("is_stored", task.is_stored);
      });
    });
  }

  void print_summary() const
  {
    if(! m_exchange.is_first() || m_options.quiet)
      return;
    print_quality(std::cout, m_quality);
    print_whether_field_is_resolved(std::cout, m_is_field_resolved);
    std::cout << m_options.number_of_subdomains << " sub-domains, " << m_number_of_tetrahedra << " tetrahedra; "
              << number_of_tasks() << " tasks, " << number_of_stored() << " of them from an earlier run\n"
              << "seconds: division " << m_division_timer.time() << ", meshing " << m_meshing_timer.time()
              << ", output " << m_output_timer.time() << std::endl;
    if(m_options.outputs.empty())
      std::cout << "no mesh is written; -o OUTPUT does that" << std::endl;
  }
};

int main(int argc, char* argv[])
{
  boost::mpi::environment environment(argc, argv, boost::mpi::threading::funneled, false);
  const boost::mpi::communicator world;
  Mpi_options options;
  Mpi_command_line command_line(options);
  const std::string rank = (world.rank() == 0) ? "" : ", rank " + std::to_string(world.rank());
  Program<Point> program("mesh_surface_mpi" + rank, options);
  const bool is_to_run = command_line.parse(argc, argv);
  if(! command_line.message().empty())
    return world.rank() == 0 ? program.fail(command_line.message()) : int(usage_or_file_error);
  if(world.rank() == 0)
    std::cout << command_line.text();
  if(! is_to_run)
    return success;
  options.quiet = options.quiet || world.rank() != 0;
  if(boost::mpi::environment::thread_level() < boost::mpi::threading::funneled)
    return world.rank() == 0 ? program.fail("MPI allows for no threads but its own") : int(usage_or_file_error);
  Interruption::prepare();
  try
  {
    return Mpi_mesher(world, options, program)();
  }
  catch(const std::exception& e) // such as memory that is exhausted: the other ranks would wait for this one
  {
    program.fail(e.what());
    boost::mpi::environment::abort(usage_or_file_error);
  }
}

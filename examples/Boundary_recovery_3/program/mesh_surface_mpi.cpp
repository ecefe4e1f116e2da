// Meshes the regions that a surface bounds, each by itself, with the processes of MPI on one or more machines.
// `mesh_surface_mpi --help` tells the options.
//
// Every rank reads the surface, recovers its boundary and divides it, and all have the same result. Rank 0 hands out
// the regions. A mesh stays where it was made, in the memory or in the folder of --work; what all ranks are told is
// only how many points each has, from which the numbers of all points follow.

#include <CGAL/make_boundary_constrained_mesh_3.h>

#include "byte_string.h"
#include "default_flow.h"
#include "domain.h"
#include "domain_quality.h"
#include "domain_sides.h"
#include "mesh_size.h"
#include "mesh_surface_mpi_options.h"
#include "print_mesh.h"
#include "program.h"
#include "subdomain.h"
#include "task_farm.h"
#include "task_store.h"
#include "write_mesh_report.h"

#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Real_timer.h>

#include <boost/mpi/communicator.hpp>
#include <boost/mpi/environment.hpp>

#include <sys/resource.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel           Kernel;
typedef Kernel::Point_3                                               Point;
typedef CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type Triangulation;
typedef CGAL::Boundary_constrained_mesh_result_3<Triangulation>       Result;
typedef Mesh_size<Triangulation>                                      Size;
typedef Subdomain_mesh<Point>                                         Mesh;

// the regions of the triangulation
Domain<Point> make_domain(const Triangulation& tr, const Result& result)
{
  Domain<Point> domain = Domain_builder<Triangulation>(tr)(result.recovery, result.recovery.surface_facets(),
    [](const Triangulation::Cell_handle c) { return c->subdomain_index() == 0 ? -1 : c->subdomain_index(); });
  domain.number_of_regions = result.number_of_regions;
  return domain;
}

class Mpi_mesher
{
  const boost::mpi::communicator& m_world;
  const Mpi_options& m_options;
  Program<Point>& m_program;
  Size m_size;
  Domain<Point> m_boundary;              // after the recovery, without field points
  std::vector<Sides> m_sides;            // of its triangles
  std::vector<Subdomain> m_subdomains;
  Task_store m_store;
  std::map<std::size_t, Bytes> m_meshes; // those made here, if nothing is stored
  std::vector<Task_report> m_reports;
  std::vector<double> m_memory;          // of each rank, its peak in bytes
  CGAL::Real_timer m_division_timer, m_meshing_timer, m_output_timer;

public:
  Mpi_mesher(const boost::mpi::communicator& world, const Mpi_options& options, Program<Point>& program)
    : m_world(world), m_options(options), m_program(program)
  { }

  // returns the exit status, the same one on all ranks
  int operator()()
  {
    std::string message;
    if(! do_all_agree(read(message)) || ! have_all_the_same_input(message))
      return message.empty() ? usage_or_file_error : m_program.fail(message);
    m_division_timer.start();
    const int status = divide();
    m_division_timer.stop();
    if(status != success) // it is that of all ranks, but is told once
      return status;
    if(! do_all_agree(open_store(message)))
      return message.empty() ? usage_or_file_error : m_program.fail(message);
    mesh_subdomains();
    gather_memory();
    m_output_timer.start();
    const bool are_written = write_outputs(message);
    m_output_timer.stop();
    if(! do_all_agree(are_written) || ! do_all_agree(write_report(message)))
      return message.empty() ? usage_or_file_error : m_program.fail(message);
    print_summary();
    return success;
  }

private:
  bool is_first() const { return m_world.rank() == 0; }

  // whether all ranks did what they had to
  bool do_all_agree(const bool is_done) const
  {
    const int is_done_here = is_done;
    int is_done_everywhere = 0;
    wait_for_all(m_world);
    MPI_Allreduce(&is_done_here, &is_done_everywhere, 1, MPI_INT, MPI_MIN, m_world);
    return is_done_everywhere != 0;
  }

  bool read(std::string& message)
  {
    if(! m_program.keeps_inputs(input_files(m_options)) || ! m_program.read_surface(default_flow<Point>))
      message = m_program.message();
    else if(m_size.read(m_options, message) && is_first() && ! m_program.can_write())
      message = m_program.message();
    if(! message.empty())
      return false;
    m_program.prepare_surface();
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
    const std::uint64_t own = key();
    std::vector<std::uint64_t> keys(static_cast<std::size_t>(m_world.size()));
    MPI_Allgather(&own, 1, MPI_UINT64_T, keys.data(), 1, MPI_UINT64_T, m_world);
    for(std::size_t r = 1; r < keys.size(); ++r)
      if(keys[r] != keys[0])
      {
        message = "rank " + std::to_string(r) + " has another surface, or other sizes or options, than rank 0";
        return false;
      }
    return true;
  }

  // recovers the boundary and divides what it bounds
  int divide()
  {
    const Surface<Point>& surface = m_program.surface();
    Triangulation tr;
    Result result = CGAL::make_boundary_constrained_mesh_3(tr, surface.points, surface.faces, Size::unbounded(),
                                                           CGAL::parameters::list_defects(m_options.list_defects),
                                                           CGAL::parameters::improve_quality(false));
    if(result.recovery.status == CGAL::Boundary_recovery_3::Recovery_status::invalid_input)
    {
      Domain<Point> nothing;
      m_program.use_numbers_of_file(result.recovery, nothing);
      return is_first() ? m_program.refuse_input(result.recovery) : int(invalid_input);
    }
    const std::string reason = reason_for_no_mesh(result);
    if(! reason.empty())
    {
      if(is_first())
        m_program.fail("there is no mesh: " + reason);
      return incomplete_or_stopped;
    }
    m_boundary = make_domain(tr, result);
    if(m_boundary.points.size() < surface.points.size() ||
       ! std::equal(surface.points.begin(), surface.points.end(), m_boundary.points.begin()))
      throw std::runtime_error("points of the surface are not in its triangulation");
    m_subdomains = Domain_divider<Point, Size>(m_boundary, m_size)();
    m_sides = find_sides(m_boundary);
    m_boundary.tetrahedra = { };
    m_boundary.regions = { };
    return success;
  }

  bool open_store(std::string& message)
  {
    try
    {
      if(! m_options.work.empty())
        m_store = Task_store(m_options.work, key());
    }
    catch(const std::exception& e)
    {
      message = e.what();
    }
    return message.empty();
  }

  void mesh_subdomains()
  {
    std::vector<double> weights;
    for(const Subdomain& subdomain : m_subdomains)
      weights.push_back(subdomain.weight);
    m_meshing_timer.start();
    m_reports = Task_farm(m_world)(weights, [this](const std::size_t i) { return do_task(i); });
    m_meshing_timer.stop();
  }

  Task_report do_task(const std::size_t i)
  {
    Task_report report;
    Bytes bytes;
    report.is_stored = m_store.is_used() && m_store.load(i, bytes);
    if(! report.is_stored)
      bytes = make_mesh(i).bytes();
    const Mesh mesh = Mesh::from_bytes(bytes, m_subdomains[i]);
    report.bytes = bytes.size();
    report.points = mesh.points.size();
    report.tetrahedra = mesh.tetrahedra.size();
    if(! m_store.is_used())
      m_meshes[i] = std::move(bytes);
    else if(! report.is_stored)
      m_store.save(i, bytes);
    return report;
  }

  Mesh make_mesh(const std::size_t i) const
  {
    const Subdomain& subdomain = m_subdomains[i];
    std::vector<Point> points;
    for(const Point_number v : subdomain.points)
      points.push_back(m_program.surface().points[v]);
    Triangulation tr;
    const Result result = CGAL::make_boundary_constrained_mesh_3(
      tr, points, subdomain.triangles, m_options.insert_field_points ? m_size : Size::unbounded(),
      CGAL::parameters::maximum_number_of_vertices(m_options.maximum_number_of_vertices),
      CGAL::parameters::improve_quality(m_options.improve_quality && m_options.insert_field_points),
      CGAL::parameters::min_dihedral_angle(m_options.min_angle));
    for(const auto& invalid : result.filling.invalid_sizes)
      throw std::runtime_error("a size is no positive number: " + std::to_string(invalid.size) + ' ' + invalid.message);
    const std::string reason = reason_for_no_mesh(result);
    if(! reason.empty())
      throw std::runtime_error(reason);
    const Domain<Point> domain = make_domain(tr, result);
    if(domain.number_of_regions != 1 || domain.triangles.size() != subdomain.triangles.size() ||
       domain.points.size() < points.size() || ! std::equal(points.begin(), points.end(), domain.points.begin()))
      throw std::runtime_error("its mesh does not have the surface of the sub-domain");
    Mesh mesh;
    mesh.points.assign(domain.points.begin() + static_cast<std::ptrdiff_t>(points.size()), domain.points.end());
    mesh.tetrahedra = domain.tetrahedra;
    mesh.number_of_steiner_points = domain.number_of_steiner_points;
    return mesh;
  }

  // calls the function, on the rank that has it or, for the merged mesh, on rank 0, for each mesh in turn
  template <typename F>
  void for_each_mesh(const bool is_for_first, const F& f)
  {
    for(std::size_t i = 0; i < m_subdomains.size(); ++i)
    {
      const int owner = m_reports[i].rank;
      Bytes bytes;
      if(m_store.is_used() && (is_for_first ? is_first() : owner == m_world.rank()))
      {
        if(! m_store.load(i, bytes))
          throw std::runtime_error("the result of sub-domain " + std::to_string(i + 1) + " is not in " +
                                   m_options.work + " any more");
      }
      else if(! m_store.is_used() && owner == m_world.rank())
        bytes = m_meshes.at(i);
      if(is_for_first && ! m_store.is_used() && owner != 0)
        pass_to_first(owner, m_reports[i].bytes, bytes);
      if(is_for_first ? is_first() : owner == m_world.rank())
        f(i, Mesh::from_bytes(bytes, m_subdomains[i]));
    }
  }

  // in messages of at most a gigabyte: MPI counts with integers of 32 bits
  void pass_to_first(const int owner, const std::uint64_t size, Bytes& bytes) const
  {
    constexpr std::uint64_t longest = std::uint64_t(1) << 30;
    constexpr int tag = 3;
    if(is_first())
      bytes.resize(static_cast<std::size_t>(size));
    for(std::uint64_t begin = 0; begin < size; begin += longest)
    {
      const int n = static_cast<int>((std::min)(longest, size - begin));
      if(is_first())
        MPI_Recv(bytes.data() + begin, n, MPI_BYTE, owner, tag, m_world, MPI_STATUS_IGNORE);
      else if(m_world.rank() == owner)
        MPI_Send(bytes.data() + begin, n, MPI_BYTE, 0, tag, m_world);
    }
  }

  bool write_outputs(std::string& message)
  {
    std::vector<std::uint64_t> numbers;
    for(const Task_report& report : m_reports)
      numbers.push_back(report.points);
    const Divided_mesh<Point> whole(m_program.surface(), m_subdomains, numbers);
    for(std::size_t& patch : m_boundary.patches) // these begin with 1
      patch = m_program.surface().file_face(patch - 1) + 1;
    std::vector<std::string> merged;
    for(const std::string& file : m_options.outputs)
      if(read_surface_internal::lower_case_extension(file) != ".pvtu")
        merged.push_back(file);
      else if(! write_pieces(whole, file))
        message = "cannot write " + file + ", or its pieces";
    if(! merged.empty())
      write_merged(whole, merged, message);
    return message.empty();
  }

  // The file that names the pieces is written when all of them are there.
  bool write_pieces(const Divided_mesh<Point>& whole, const std::string& file)
  {
    const std::filesystem::path path(file);
    const auto name_of = [&](const std::size_t i)
    {
      return path.stem().string() + '_' + std::to_string(i + 1) + ".vtu";
    };
    bool are_written = true;
    for_each_mesh(false, [&](const std::size_t i, const Mesh& mesh)
    {
      Vtu_piece numbers;
      numbers.part = static_cast<int>(i) + 1;
      const Domain<Point> piece = whole.piece(i, mesh, m_boundary, m_sides, numbers.numbers);
      Output_buffer os((path.parent_path() / name_of(i)).string());
      Vtu_writer<Point>(os, piece, &numbers)();
      are_written = os.close() && are_written;
    });
    are_written = do_all_agree(are_written);
    if(! are_written || ! is_first())
      return are_written;
    std::vector<std::string> names;
    for(std::size_t i = 0; i < m_subdomains.size(); ++i)
      names.push_back(name_of(i));
    Output_buffer os(file);
    write_pvtu(os, names);
    return os.close();
  }

  void write_merged(const Divided_mesh<Point>& whole, const std::vector<std::string>& files, std::string& message)
  {
    Domain<Point> domain;
    std::vector<int> parts;
    domain.points = m_program.surface().points;
    domain.triangles = m_boundary.triangles;
    domain.patches = m_boundary.patches;
    domain.number_of_regions = m_boundary.number_of_regions;
    for_each_mesh(true, [&](const std::size_t i, const Mesh& mesh)
    {
      whole.add_to(domain, i, mesh);
      if(m_options.pieces)
        parts.insert(parts.end(), mesh.tetrahedra.size(), static_cast<int>(i) + 1);
    });
    for(const std::string& file : files)
      if(is_first() && ! write_domain(file, read_surface_internal::lower_case_extension(file), domain, parts))
        message = "cannot write " + file;
  }

  void gather_memory()
  {
    rusage usage = {};
    getrusage(RUSAGE_SELF, &usage);
    const double bytes = 1024. * double(usage.ru_maxrss);
    m_memory.resize(static_cast<std::size_t>(m_world.size()));
    MPI_Allgather(&bytes, 1, MPI_DOUBLE, m_memory.data(), 1, MPI_DOUBLE, m_world);
  }

  template <typename Number>
  std::size_t sum(const Number& number) const
  {
    std::size_t sum = 0;
    for(const Task_report& report : m_reports)
      sum += static_cast<std::size_t>(number(report));
    return sum;
  }

  std::size_t number_of_tetrahedra() const { return sum([](const Task_report& r) { return r.tetrahedra; }); }
  std::size_t number_of_stored() const { return sum([](const Task_report& r) { return r.is_stored; }); }

  bool write_report(std::string& message)
  {
    if(! is_first() || m_program.write_report([&](Json_writer& json) { write_entries(json); }))
      return true;
    message = m_program.message();
    return false;
  }

  void write_entries(Json_writer& json) const
  {
    write_options(json, m_options);
    json.entry("number_of_ranks", m_world.size());
    json.entry("number_of_tetrahedra", number_of_tetrahedra());
    json.entry("number_of_stored_subdomains", number_of_stored());
    json.entry("seconds_division", m_division_timer.time());
    json.entry("seconds_meshing", m_meshing_timer.time());
    json.entry("seconds_output", m_output_timer.time());
    json.key("peak_memory_of_ranks");
    json.list(m_memory, [&](const double bytes) { json.value(bytes); });
    json.key("subdomains");
    std::size_t i = 0;
    json.objects(m_reports, [&](const Task_report& report)
    {
      json.entry("weight", m_subdomains[i++].weight);
      json.entry("rank", report.rank);
      json.entry("seconds", report.seconds);
      json.entry("bytes", static_cast<std::size_t>(report.bytes));
      json.entry("points", static_cast<std::size_t>(report.points));
      json.entry("tetrahedra", static_cast<std::size_t>(report.tetrahedra));
      json.entry("is_stored", report.is_stored);
    });
  }

  void print_summary() const
  {
    if(! is_first() || m_options.quiet)
      return;
    std::cout << m_subdomains.size() << " sub-domains, " << number_of_stored() << " of them from an earlier run; "
              << number_of_tetrahedra() << " tetrahedra\n"
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
  Mpi_command_line command_line(argc, argv, options);
  const std::string rank = (world.rank() == 0) ? "" : ", rank " + std::to_string(world.rank());
  Program<Point> program("mesh_surface_mpi" + rank, options);
  if(! command_line.parse())
    return world.rank() == 0 ? program.fail(command_line.message()) : int(usage_or_file_error);
  if(options.help)
  {
    if(world.rank() == 0)
      std::cout << mpi_usage;
    return success;
  }
  options.quiet = options.quiet || world.rank() != 0;
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

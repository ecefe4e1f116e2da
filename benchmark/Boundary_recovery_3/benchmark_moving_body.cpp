// A store leaves the pylon of a wing, as in [CZZ+17, Section 5.2.3]: the mesh of the air follows, and where cells have
// become bad, holes are meshed anew. Arguments: about how many CELLS (default: 100000), how many STEPS (default: 36,
// and not more, as the box ends there), and, for pictures, a PREFIX (default: none) of files that are to be written:
// the mesh before and after each step, PREFIX01_before.mesh and so on.
// Prints a row for each remeshing, and sums. The exit status is 1 if anything failed or a mesh is not valid.

#include "mesh_files_br3.h"
#include "mesh_motion_br3.h"
#include "moving_body_br3.h"
#include "peak_memory_br3.h"
#include "remeshed_mesh_br3.h"
#include "remeshing_account_br3.h"

#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/Real_timer.h>
#include <CGAL/make_boundary_constrained_mesh_3.h>
#include <CGAL/remesh_holes.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <string>
#include <unordered_map>
#include <vector>

using br3_benchmark::Account;
using br3_benchmark::Kernel;
using br3_benchmark::Mesh;
using br3_benchmark::Mesh_files;
using br3_benchmark::Point;
using br3_benchmark::Scene;
using br3_benchmark::Tetrahedron;
using br3_benchmark::Triangle;

typedef CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type Triangulation;
typedef CGAL::Boundary_constrained_mesh_result_3<Triangulation>       Meshing_result;
typedef CGAL::Hole_remeshing_result_3<Kernel::Point_3>                Remeshing_result;

// Cells below the first angle make a remeshing necessary, and those below the second one are replaced then.
const double alarming_angle = 10, least_angle = 15;
const double radius = 0.4;
const Point start = {{ 1.5, 0, -1.35 }}; // of the middle of the store, which leaves a gap of half its radius

// Measured: sizes grow away from the surface, so that the number of cells goes with less than the square of the size
// there.
Scene make_scene(const double number_of_cells)
{
  const double size = 104 * std::pow(number_of_cells, -0.578);
  Scene scene;
  scene.add(br3_benchmark::box({{ -5, -5.5, -18 }}, {{ 8, 5.5, 3 }}, (std::min)(8 * size, 2.)), false);
  scene.add(br3_benchmark::wing_with_pylon(size), true);
  scene.add(br3_benchmark::store(radius, size), true);
  return scene;
}

// Where the store is after some steps: half of its diameter down in each, and its nose goes down, too.
void place_store(Scene& scene, const std::vector<Kernel::Point_3>& at_origin, const int number_of_steps)
{
  const double depth = number_of_steps * radius, pitch = number_of_steps * 0.08;
  const double c = std::cos(pitch), s = std::sin(pitch);
  for(std::size_t v = scene.first_moving_point; v < at_origin.size(); ++v)
  {
    const Kernel::Point_3& p = at_origin[v];
    scene.points[v] = Kernel::Point_3(start[0] + c * p.x() - s * p.z(), start[1] + p.y(),
                                      start[2] + s * p.x() + c * p.z() - depth);
  }
}

// The cells of the air as arrays.
Mesh arrays_of(const Triangulation& tr, const Scene& scene, const Meshing_result& result)
{
  Mesh mesh;
  std::unordered_map<Triangulation::Vertex_handle, std::size_t> number;
  for(const auto c : tr.finite_cell_handles())
    if(c->subdomain_index() != 0)
    {
      Tetrahedron t;
      for(int i = 0; i < 4; ++i)
      {
        const auto inserted = number.emplace(c->vertex(i), mesh.points.size());
        if(inserted.second)
          mesh.points.push_back(c->vertex(i)->point());
        t[std::size_t(i)] = inserted.first->second;
      }
      mesh.tetrahedra.push_back(t);
    }
  for(const Triangle& t : scene.triangles)
  {
    Triangle facet;
    for(std::size_t i = 0; i < 3; ++i)
      facet[i] = number[result.recovery.vertices[t[i]]];
    mesh.facets.push_back(facet);
  }
  return mesh;
}

// Moves the vertices of the surface to where they are in the scene, and the others with them.
bool move(Mesh& mesh, const Scene& scene)
{
  std::vector<bool> is_fixed(mesh.points.size(), false);
  std::vector<Point> displacements(mesh.points.size(), Point{{ 0, 0, 0 }}), points;
  for(const Kernel::Point_3& p : mesh.points)
    points.push_back(br3_benchmark::coordinates(p));
  std::vector<Kernel::Point_3> targets = mesh.points;
  for(std::size_t i = 0; i < mesh.facets.size(); ++i)
    for(std::size_t j = 0; j < 3; ++j)
    {
      const std::size_t v = mesh.facets[i][j];
      targets[v] = scene.points[scene.triangles[i][j]];
      displacements[v] = br3_benchmark::difference(br3_benchmark::coordinates(targets[v]), points[v]);
      is_fixed[v] = true;
    }
  if(! br3_benchmark::Spring_motion(points, mesh.tetrahedra, is_fixed)(displacements))
    return false;
  for(std::size_t v = 0; v < points.size(); ++v)
    mesh.points[v] = is_fixed[v] ? targets[v]
                                 : mesh.points[v] + Kernel::Vector_3(displacements[v][0], displacements[v][1],
                                                                     displacements[v][2]);
  return true;
}

// Replaces bad cells. Where a hole ends, it may leave new ones, which are in the middle of the hole of another round.
bool remesh(Mesh& mesh, const Scene& scene, const int step, const Mesh_files& files, Account& account)
{
  double angle = mesh.smallest_angle();
  if(angle >= alarming_angle && mesh.has_positive_cells_only())
  {
    files.write(step, "after", mesh);
    return true;
  }
  ++account.steps;
  for(int round = 0; round < 3 && (round == 0 || angle < alarming_angle); ++round)
  {
    const Remeshing_result result = CGAL::remesh_holes(mesh.points, mesh.tetrahedra,
      CGAL::parameters::min_dihedral_angle(least_angle), CGAL::parameters::constrained_facets(mesh.facets));
    const Mesh new_mesh{ result.points, result.tetrahedra, result.facets };
    const double new_angle = new_mesh.smallest_angle();
    br3_benchmark::print_row(step, mesh.tetrahedra.size(), angle, new_angle, result);
    if(! result || ! new_mesh.is_valid(scene))
    {
      std::cerr << (result ? "the mesh is not valid: " : "") << result << std::endl;
      return false;
    }
    account.add(mesh.tetrahedra.size(), result);
    if(round == 0)
      files.write_before(step, mesh, result.old_cells, least_angle);
    mesh = new_mesh;
    files.write_after(step, mesh, result.number_of_kept_cells);
    angle = new_angle;
  }
  account.smallest_angle = (std::min)(account.smallest_angle, angle);
  return true;
}

// Moves the store step by step, and remeshes where that makes cells bad.
bool run(Mesh& mesh, Scene& scene, const std::vector<Kernel::Point_3>& at_origin, const int number_of_steps,
         const Mesh_files& files, Account& account)
{
  CGAL::Real_timer timer;
  files.write(0, "after", mesh);
  for(int step = 1; step <= number_of_steps; ++step)
  {
    place_store(scene, at_origin, step);
    timer.start();
    const bool is_moved = move(mesh, scene);
    timer.stop();
    if(! is_moved)
      std::cerr << "step " << step << ": the springs have no solution" << std::endl;
    if(! is_moved || ! remesh(mesh, scene, step, files, account))
      return false;
  }
  std::cout << "moving the vertices took " << std::setprecision(1) << timer.time() << " s" << std::endl;
  return account.remeshings > 0;
}

int main(int argc, char** argv)
{
  const double number_of_cells = argc > 1 ? std::stod(argv[1]) : 1e5;
  const int number_of_steps = argc > 2 ? (std::min)(std::stoi(argv[2]), 36) : 36;

  const Mesh_files files(argc > 3 ? argv[3] : "");

  Scene scene = make_scene(number_of_cells);
  const std::vector<Kernel::Point_3> at_origin = scene.points;
  place_store(scene, at_origin, 0);
  Triangulation tr;
  const Meshing_result result = CGAL::make_boundary_constrained_mesh_3(tr, scene.points, scene.triangles);
  Mesh mesh;
  if(result)
    mesh = arrays_of(tr, scene, result);
  if(! result || ! mesh.is_valid(scene))
  {
    std::cerr << "the full mesh: " << result << std::endl;
    return EXIT_FAILURE;
  }
  double seconds = result.seconds;
  for(const auto& report : result.phases)
    if(report.phase == CGAL::Boundary_recovery_3::Phase::quality_improvement)
      seconds -= report.seconds;
  const double seconds_per_cell = seconds / double(mesh.tetrahedra.size());
  std::cout << std::fixed << std::setprecision(3) << scene.triangles.size() << " triangles, " << mesh.tetrahedra.size()
            << " cells in " << result.seconds << " s, without improvement " << seconds << " s; smallest angle "
            << std::setprecision(1) << mesh.smallest_angle() << std::endl;

  br3_benchmark::print_head();
  Account account;
  const bool is_done = run(mesh, scene, at_origin, number_of_steps, files, account);
  if(account.remeshings > 0)
    br3_benchmark::print_sums(account, seconds_per_cell);
  std::cout << "largest memory: " << br3_benchmark::peak_memory() << " MB" << std::endl;
  return is_done ? EXIT_SUCCESS : EXIT_FAILURE;
}

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/make_boundary_constrained_mesh_3.h>
#include <CGAL/remesh_holes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <unordered_map>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel           Kernel;
typedef Kernel::Point_3                                               Point;
typedef Kernel::Vector_3                                              Vector;
typedef CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type Triangulation;
typedef CGAL::Boundary_constrained_mesh_result_3<Triangulation>       Meshing_result;
typedef CGAL::Hole_remeshing_result_3<Point>                          Result;
typedef std::array<std::size_t, 3>                                    Triangle;
typedef std::array<std::size_t, 4>                                    Tetrahedron;

const Point start(1.5, 0, -1.35); // the middle of the store, which is below the pylon of a wing
const Vector fall(0, 0, -0.4);    // in a step: half of its diameter
const double turn = 0.08;         // in a step: its nose goes down

// The air, as a solver has it: the first points are those of the surface.
struct Mesh
{
  std::vector<Point> points;
  std::vector<Tetrahedron> tetrahedra;
  std::vector<Triangle> surface;

  // The vertices of the surface keep their numbers.
  Mesh(const Triangulation& tr, const Meshing_result& result, const std::vector<Triangle>& surface)
    : surface(surface)
  {
    std::unordered_map<Triangulation::Vertex_handle, std::size_t> number;
    const auto add = [&](const Triangulation::Vertex_handle v)
    {
      if(number.emplace(v, points.size()).second)
        points.push_back(v->point());
      return number[v];
    };
    for(const auto v : result.recovery.vertices)
      add(v);
    for(const auto c : tr.finite_cell_handles())
      if(c->subdomain_index() != 0)
        tetrahedra.push_back({{ add(c->vertex(0)), add(c->vertex(1)), add(c->vertex(2)), add(c->vertex(3)) }});
  }

  std::size_t number_of_inverted_cells() const
  {
    return std::size_t(std::count_if(tetrahedra.begin(), tetrahedra.end(), [this](const Tetrahedron& t)
    {
      return CGAL::orientation(points[t[0]], points[t[1]], points[t[2]], points[t[3]]) != CGAL::POSITIVE;
    }));
  }

  double volume() const
  {
    double sum = 0;
    for(const Tetrahedron& t : tetrahedra)
      sum += CGAL::volume(points[t[0]], points[t[1]], points[t[2]], points[t[3]]);
    return sum;
  }
};

// The surface moves as it has to, and each other vertex as its neighbors do on the average.
void move(Mesh& mesh, const std::vector<Vector>& motion_of_surface)
{
  std::vector<std::vector<std::size_t> > neighbors(mesh.points.size());
  for(const Tetrahedron& t : mesh.tetrahedra)
    for(const std::size_t u : t)
      for(const std::size_t v : t)
        if(u != v)
          neighbors[u].push_back(v); // as often as there are cells at the edge
  std::vector<Vector> motion(mesh.points.size(), CGAL::NULL_VECTOR);
  std::copy(motion_of_surface.begin(), motion_of_surface.end(), motion.begin());
  for(int sweep = 0; sweep < 100; ++sweep)
    for(std::size_t v = motion_of_surface.size(); v < motion.size(); ++v)
    {
      Vector sum = CGAL::NULL_VECTOR;
      for(const std::size_t u : neighbors[v])
        sum = sum + motion[u];
      motion[v] = sum / double(neighbors[v].size());
    }
  for(std::size_t v = 0; v < motion.size(); ++v)
    mesh.points[v] = mesh.points[v] + motion[v];
}

// Where a point of the store is after so many steps.
Point place(const Point& p, const int step)
{
  const Vector d = p - start;
  const double c = std::cos(step * turn), s = std::sin(step * turn);
  return start + double(step) * fall + Vector(c * d.x() - s * d.z(), d.y(), s * d.x() + c * d.z());
}

int main()
{
  std::vector<Point> points; // of the box, the wing with its pylon, and the store
  std::vector<Triangle> triangles;
  if(! CGAL::IO::read_polygon_soup(CGAL::data_file_path("meshes/store_br3.off"), points, triangles))
    return EXIT_FAILURE;
  Triangulation tr;
  const Meshing_result full_mesh = CGAL::make_boundary_constrained_mesh_3(tr, points, triangles);
  if(! full_mesh)
    return EXIT_FAILURE;
  Mesh mesh(tr, full_mesh, triangles);
  const double volume = mesh.volume();
  std::cout << mesh.tetrahedra.size() << " cells" << std::endl;

  // There is nothing else where it is in the beginning.
  const auto is_store = [](const Point& p) { return std::abs(p.y()) < 0.5 && p.z() < -0.8 && p.z() > -2; };
  std::size_t number_of_remeshings = 0;
  for(int step = 1; step <= 10; ++step)
  {
    std::vector<Vector> motion(points.size(), CGAL::NULL_VECTOR);
    for(std::size_t v = 0; v < points.size(); ++v)
      if(is_store(points[v]))
        motion[v] = place(points[v], step) - mesh.points[v];
    move(mesh, motion);
    const std::size_t number_of_inverted_cells = mesh.number_of_inverted_cells();

    //! [remesh]
    // The triangles of the surface are named, so that they come back in their order, with new numbers of vertices.
    const Result result = CGAL::remesh_holes(mesh.points, mesh.tetrahedra,
                                             CGAL::parameters::min_dihedral_angle(8.),
                                             CGAL::parameters::constrained_facets(mesh.surface));
    if(! result)
    {
      std::cerr << "step " << step << ": " << result << std::endl;
      return EXIT_FAILURE;
    }
    mesh.points = result.points;
    mesh.tetrahedra = result.tetrahedra;
    mesh.surface = result.facets;
    //! [remesh]

    std::cout << "step " << step << ": " << result << ", smallest new angle " << result.smallest_new_angle << ", "
              << number_of_inverted_cells << " inverted cells before" << std::endl;
    number_of_remeshings += result.number_of_holes > 0;

    // Vertices of the surface have to stay, and the first ones stay the first ones.
    if(mesh.surface != triangles || mesh.number_of_inverted_cells() > 0 ||
       std::abs(mesh.volume() - volume) > 1e-6 * volume)
      return EXIT_FAILURE;
  }
  std::cout << number_of_remeshings << " remeshings" << std::endl;
  return number_of_remeshings >= 3 ? EXIT_SUCCESS : EXIT_FAILURE;
}

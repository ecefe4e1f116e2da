#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/make_boundary_constrained_mesh_3.h>
#include <CGAL/remesh_holes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <map>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel           Kernel;
typedef Kernel::Point_3                                               Point;
typedef Kernel::Vector_3                                              Vector;
typedef CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type Triangulation;
typedef CGAL::Hole_remeshing_result_3<Point>                          Result;

// A channel, and a cube in it, which is not meshed: both with squares of half a unit, which are two triangles.
struct Surface
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3> > triangles;
  std::map<std::array<int, 3>, std::size_t> number;

  std::size_t vertex(const std::array<int, 3>& p)
  {
    const auto inserted = number.emplace(p, points.size());
    if(inserted.second)
      points.emplace_back(p[0] / 2., p[1] / 2., p[2] / 2.);
    return inserted.first->second;
  }

  void add_box(const std::array<int, 3>& low, const std::array<int, 3>& high, const bool is_outward)
  {
    for(std::size_t axis = 0; axis < 3; ++axis)
      for(const bool is_high : { false, true })
      {
        const std::size_t j = (axis + 1) % 3, k = (axis + 2) % 3;
        for(int u = low[j]; u < high[j]; ++u)
          for(int v = low[k]; v < high[k]; ++v)
          {
            const auto corner = [&](const int du, const int dv)
            {
              std::array<int, 3> p;
              p[axis] = (is_high ? high : low)[axis];
              p[j] = u + du;
              p[k] = v + dv;
              return vertex(p);
            };
            std::array<std::size_t, 4> square = {{ corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1) }};
            if(is_high != is_outward)
              std::swap(square[1], square[3]);
            triangles.push_back({{ square[0], square[1], square[2] }});
            triangles.push_back({{ square[0], square[2], square[3] }});
          }
      }
  }
};

// What a solver knows at the vertices.
double linear(const Point& p) { return 3 * p.x() - 2 * p.y() + p.z() / 2; }
double smooth(const Point& p) { return std::sin(p.x()) * std::cos(p.y()); }

int main()
{
  Surface surface;
  surface.add_box({{ 0, 0, 0 }}, {{ 16, 8, 8 }}, true);
  surface.add_box({{ 2, 3, 3 }}, {{ 4, 5, 5 }}, false);
  Triangulation tr;
  if(! CGAL::make_boundary_constrained_mesh_3(tr, surface.points, surface.triangles))
    return EXIT_FAILURE;

  // The mesh as a solver has it.
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 4> > tetrahedra;
  std::map<Triangulation::Vertex_handle, std::size_t> number;
  for(const auto v : tr.finite_vertex_handles())
  {
    number[v] = points.size();
    points.push_back(v->point());
  }
  for(const auto c : tr.finite_cell_handles())
    if(c->subdomain_index() != 0)
      tetrahedra.push_back({{ number[c->vertex(0)], number[c->vertex(1)],
                              number[c->vertex(2)], number[c->vertex(3)] }});
  std::cout << tetrahedra.size() << " cells" << std::endl;

  const Vector motion(0.2, 0, 0);
  Point center(1.5, 2, 2); // of the cube
  std::size_t number_of_remeshings = 0;
  double worst_linear = 0, worst_smooth = 0, worst_share_of_bound = 0;
  for(int step = 0; step < 20; ++step)
  {
    // The vertices of the cube move by `motion`, the others the less the farther they are away.
    for(Point& p : points)
    {
      const Vector d = p - center;
      const double distance = (std::max)({ std::abs(d.x()), std::abs(d.y()), std::abs(d.z()) }) - 0.5;
      const double share = (std::max)(0., 1 - (std::max)(0., distance));
      if(share > 0)
        p = p + share * motion;
    }
    center = center + motion;

    //! [remesh]
    // Cells below 10 degrees are replaced, and two layers around them.
    const Result result = CGAL::remesh_holes(points, tetrahedra, CGAL::parameters::min_dihedral_angle(10.));
    if(! result)
    {
      std::cerr << result << std::endl;
      return EXIT_FAILURE;
    }
    if(result.number_of_holes == 0)
      continue;

    // The solution: vertices that stayed have theirs, new ones interpolate it in the old cell where they are.
    std::vector<double> solution(result.points.size());
    for(std::size_t v = 0; v < result.points.size(); ++v)
      if(v < result.number_of_kept_vertices)
        solution[v] = smooth(points[result.old_vertices[v]]);
      else
      {
        const auto& location = result.locations[v - result.number_of_kept_vertices];
        for(std::size_t i = 0; i < 4; ++i)
          solution[v] += location.coordinates[i] * smooth(points[tetrahedra[location.cell][i]]);
      }
    //! [remesh]

    std::cout << "step " << step << ": " << result << ", smallest new angle " << result.smallest_new_angle << std::endl;
    for(std::size_t v = result.number_of_kept_vertices; v < result.points.size(); ++v)
    {
      const auto& location = result.locations[v - result.number_of_kept_vertices];
      double value = 0, bound = 0;
      for(std::size_t i = 0; i < 4; ++i)
      {
        const Point& p = points[tetrahedra[location.cell][i]];
        value += location.coordinates[i] * linear(p);
        // By the theorem of Taylor, as second derivatives of the smooth function are 1 at most in all directions.
        bound += location.coordinates[i] * CGAL::squared_distance(p, result.points[v]) / 2;
      }
      const double error = std::abs(solution[v] - smooth(result.points[v]));
      worst_linear = (std::max)(worst_linear, std::abs(value - linear(result.points[v])));
      worst_smooth = (std::max)(worst_smooth, error);
      if(error > 1e-12)
        worst_share_of_bound = (std::max)(worst_share_of_bound, error / bound);
    }
    points = result.points;
    tetrahedra = result.tetrahedra;
    ++number_of_remeshings;
  }

  std::cout << number_of_remeshings << " remeshings; the interpolation is wrong by " << worst_linear
            << " at most for a linear function, by " << worst_smooth << " for a smooth one: at most "
            << worst_share_of_bound << " times as much as the old cells allow" << std::endl;
  return number_of_remeshings > 0 && worst_linear < 1e-12 && worst_share_of_bound < 1 ? EXIT_SUCCESS : EXIT_FAILURE;
}

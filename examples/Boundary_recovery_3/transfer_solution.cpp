#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Random.h>
#include <CGAL/remesh_holes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <utility>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3                                     Point;
typedef Kernel::Vector_3                                    Vector;
typedef CGAL::Hole_remeshing_result_3<Point>                Result;
typedef std::array<std::size_t, 4>                          Tetrahedron;

// The unit cube as n * n * n cubes, each of which is six tetrahedra around a diagonal.
struct Mesh
{
  std::vector<Point> points;
  std::vector<Tetrahedron> tetrahedra;

  explicit Mesh(const std::size_t n)
  {
    for(std::size_t i = 0; i <= n; ++i)
      for(std::size_t j = 0; j <= n; ++j)
        for(std::size_t k = 0; k <= n; ++k)
          points.emplace_back(double(i) / double(n), double(j) / double(n), double(k) / double(n));
    const std::array<std::size_t, 3> strides = {{ (n + 1) * (n + 1), n + 1, 1 }};
    for(std::size_t v = 0; v < points.size(); ++v)
      if(points[v].x() < 1 && points[v].y() < 1 && points[v].z() < 1)
        for(std::size_t a = 0; a < 3; ++a)
          for(std::size_t b = 0; b < 3; ++b)
            if(a != b)
            {
              Tetrahedron t = {{ v, v + strides[a], v + strides[a] + strides[b],
                                 v + strides[0] + strides[1] + strides[2] }};
              if(b != (a + 1) % 3)
                std::swap(t[1], t[2]);
              tetrahedra.push_back(t);
            }
  }
};

// What a solver knows at the vertices.
double linear(const Point& p) { return 3 * p.x() - 2 * p.y() + p.z() / 2; }
double smooth(const Point& p) { return std::sin(4 * p.x()) * std::cos(3 * p.y()) * std::exp(p.z()); }

//! [transfer]
// The value at a new vertex, from those at the vertices of the old cell that it is in.
template <typename Function>
double interpolated(const Function& function, const Mesh& old_mesh, const Result& result, const std::size_t new_vertex)
{
  const auto& location = result.locations[new_vertex - result.number_of_kept_vertices];
  double value = 0;
  for(std::size_t i = 0; i < 4; ++i)
    value += location.coordinates[i] * function(old_mesh.points[old_mesh.tetrahedra[location.cell][i]]);
  return value;
}
//! [transfer]

// How wrong the interpolation is: at most for the linear function, and as root mean square for the smooth one.
struct Errors
{
  double linear = 0, smooth = 0;
};

// All vertices in a ball move at random, by more than half of the size, and then new cells are put there.
bool transfer(const std::size_t n, Errors& errors)
{
  Mesh mesh(n);
  CGAL::Random random(1);
  for(Point& p : mesh.points)
    if(CGAL::squared_distance(p, Point(0.5, 0.5, 0.5)) < 0.3 * 0.3)
      p = p + (0.6 / double(n)) * Vector(random.uniform_real(-1., 1.), random.uniform_real(-1., 1.),
                                         random.uniform_real(-1., 1.));

  const Result result = CGAL::remesh_holes(mesh.points, mesh.tetrahedra, CGAL::parameters::min_dihedral_angle(20.));
  if(! result)
    return false;
  const std::size_t number_of_new_vertices = result.points.size() - result.number_of_kept_vertices;
  for(std::size_t v = result.number_of_kept_vertices; v < result.points.size(); ++v)
  {
    const double of_linear = interpolated(linear, mesh, result, v) - linear(result.points[v]);
    const double of_smooth = interpolated(smooth, mesh, result, v) - smooth(result.points[v]);
    errors.linear = (std::max)(errors.linear, std::abs(of_linear));
    errors.smooth += of_smooth * of_smooth;
  }
  errors.smooth = std::sqrt(errors.smooth / double(number_of_new_vertices));
  std::cout << mesh.tetrahedra.size() << " cells, " << result.number_of_inverted_cells << " of them inverted; "
            << number_of_new_vertices << " new vertices, errors " << errors.linear << " and " << errors.smooth
            << std::endl;
  return number_of_new_vertices > 0 && result.number_of_inverted_cells > 0;
}

int main()
{
  Errors previous;
  for(const std::size_t n : { 8, 16, 32 })
  {
    Errors errors;
    if(! transfer(n, errors) || errors.linear > 1e-14)
      return EXIT_FAILURE;
    if(n > 8)
    {
      const double order = std::log2(previous.smooth / errors.smooth);
      std::cout << "the order is " << order << std::endl;
      if(order < 1.8)
        return EXIT_FAILURE;
    }
    previous = errors;
  }
  return EXIT_SUCCESS;
}

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/make_boundary_constrained_mesh_3.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel           Kernel;
typedef Kernel::Point_3                                               Point_3;
typedef CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type Triangulation;
typedef std::array<std::size_t, 3>                                    Triangle;

using namespace CGAL::Boundary_recovery_3;

// Tells how a call ended, and returns whether it is as expected.
template <typename Result>
bool is_as_expected(const char* what, const Result& result, const Meshing_status expected)
{
  std::cout << what << ": " << to_string(result.status) << std::endl;
  if(result.status == Meshing_status::invalid_input)
  {
    for(const auto& defect : result.recovery.defects) // in the numbers of the input
      std::cout << "  " << defect << std::endl;
    for(const auto& invalid : result.filling.invalid_sizes)
      std::cout << "  " << invalid << std::endl;
  }
  if(result.status == Meshing_status::too_large)
    std::cout << "  about " << result.filling.forecast_of_vertices << " vertices and "
              << result.filling.forecast_of_cells << " cells are to be expected" << std::endl;
  return result.status == expected;
}

int main()
{
  std::vector<Point_3> points;
  std::vector<Triangle> triangles;
  if(! CGAL::IO::read_polygon_soup(CGAL::data_file_path("meshes/cube_br3.off"), points, triangles))
    return EXIT_FAILURE;
  bool is_right = true;

  // A field that has no size in a part of the cube.
  const auto with_a_hole = [](const Point_3& p)
  {
    return p.x() < 0.5 ? 0.2 : std::numeric_limits<double>::quiet_NaN();
  };
  Triangulation tr;
  is_right &= is_as_expected("no size", CGAL::make_boundary_constrained_mesh_3(tr, points, triangles, with_a_hole),
                             Meshing_status::invalid_input);

  // A size that takes far more vertices than we want. This is known before the first one is inserted.
  tr.clear();
  const auto large = CGAL::make_boundary_constrained_mesh_3(tr, points, triangles, 0.001,
                                                            CGAL::parameters::maximum_number_of_vertices(100000));
  is_right &= is_as_expected("small size", large, Meshing_status::too_large)
           && large.filling.number_of_field_points == 0;

  // A cube without one of its triangles bounds nothing.
  tr.clear();
  const std::vector<Triangle> open(triangles.begin() + 1, triangles.end());
  is_right &= is_as_expected("open surface", CGAL::make_boundary_constrained_mesh_3(tr, points, open, 0.2),
                             Meshing_status::no_region);

  // Another triangle, which pierces the upper side of the cube.
  tr.clear();
  const std::size_t n = points.size();
  points.insert(points.end(), { Point_3(0.2, 0.7, 2), Point_3(0.4, 0.7, 2), Point_3(0.3, 0.8, 0.5) });
  triangles.push_back({{ n, n + 1, n + 2 }});
  is_right &= is_as_expected("intersections", CGAL::make_boundary_constrained_mesh_3(tr, points, triangles, 0.2),
                             Meshing_status::invalid_input);

  return is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}

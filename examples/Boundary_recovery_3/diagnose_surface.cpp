#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/recover_boundary.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <set>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3                                     Point;
typedef CGAL::Delaunay_triangulation_3<Kernel>              Triangulation;
typedef std::array<std::size_t, 3>                          Triangle;

// Writes the triangles that are named in defects to a file that any viewer can show.
template <typename Result>
std::size_t write_offending_triangles(const char* file, const Result& result,
                                      const std::vector<Point>& points, const std::vector<Triangle>& triangles)
{
  std::set<std::size_t> offending; // positions in `triangles`
  for(const auto& defect : result.defects)
    for(const auto& simplex : defect.simplices)
      if(simplex.dimension == 2)
        offending.insert(simplex.index);

  std::vector<Triangle> selected;
  for(const std::size_t t : offending)
    selected.push_back(triangles[t]);
  return CGAL::IO::write_polygon_soup(file, points, selected, CGAL::parameters::stream_precision(17))
       ? selected.size() : 0;
}

int main()
{
  // A cube, and a needle that pierces one of the two triangles of its upper side with three of its own.
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  if(! CGAL::IO::read_polygon_soup(CGAL::data_file_path("meshes/cube_br3.off"), points, triangles))
    return EXIT_FAILURE;
  const std::size_t a = points.size(), b = a + 1, c = a + 2, d = a + 3;
  points.insert(points.end(), { Point(.2, .7, 2), Point(.4, .7, 2), Point(.3, .9, 2), Point(.3, .8, .5) });
  triangles.insert(triangles.end(), { {{ a, b, c }}, {{ a, d, b }}, {{ b, d, c }}, {{ c, d, a }} });

  //! [diagnosis]
  // Intersections are looked for first, and nothing is flipped if there are any.
  Triangulation tr;
  const auto result = CGAL::recover_boundary(tr, points, triangles, CGAL::parameters::list_defects(true));
  std::cout << to_string(result.status) << std::endl;
  for(const auto& defect : result.defects)
    std::cout << "  " << defect << std::endl;
  //! [diagnosis]

  const std::size_t n = write_offending_triangles("offending_triangles.off", result, points, triangles);
  std::cout << n << " triangles are in offending_triangles.off" << std::endl;

  // The file is to be read again, and the surface is to be good without the needle.
  std::vector<Point> file_points;
  std::vector<Triangle> file_triangles;
  const bool is_written = CGAL::IO::read_polygon_soup("offending_triangles.off", file_points, file_triangles)
                       && file_triangles.size() == n;
  triangles.resize(triangles.size() - 4);
  tr.clear();
  const bool is_cube_good = bool(CGAL::recover_boundary(tr, points, triangles));
  const bool is_refused = result.status == CGAL::Boundary_recovery_3::Recovery_status::invalid_input;
  return is_refused && n == 4 && is_written && is_cube_good ? EXIT_SUCCESS : EXIT_FAILURE;
}

#ifndef BOUNDARY_RECOVERY_3_PROGRAM_ORIENT_TRIANGLES_H
#define BOUNDARY_RECOVERY_3_PROGRAM_ORIENT_TRIANGLES_H

#include "disjoint_sets.h"
#include "triangle_soup.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

#include <algorithm>
#include <cstddef>
#include <vector>

// Notes which triangles are turned over. CGAL copies visitors, so the list is elsewhere.
struct Orientation_visitor
  : public CGAL::Polygon_mesh_processing::Default_orientation_visitor
{
  std::vector<bool>* is_reversed;

  explicit Orientation_visitor(std::vector<bool>& is_reversed) : is_reversed(&is_reversed) { }

  void polygon_orientation_reversed(const std::size_t i) { (*is_reversed)[i] = ! (*is_reversed)[i]; }
};

// Turns triangles with a common edge alike, if no third one has that edge. CGAL turns them as the first one of a piece;
// here they are turned as most of them are. Returns the sources of those that are turned over, in ascending order if
// the triangles are so.
template <typename Point>
std::vector<std::size_t> orient_triangles(Triangle_soup<Point>& soup)
{
  // CGAL gives each piece vertices of its own: pieces are what shares vertices
  Triangle_soup<Point> oriented = soup;
  std::vector<bool> is_reversed(soup.triangles.size(), false);
  CGAL::Polygon_mesh_processing::orient_polygon_soup(
    oriented.points, oriented.triangles, CGAL::parameters::visitor(Orientation_visitor(is_reversed)));

  const std::size_t n = oriented.points.size();
  std::vector<std::size_t> size(n, 0), number_of_reversed(n, 0), sources;
  Disjoint_sets pieces(n);
  for(const Sourced_triangle& t : oriented.triangles)
  {
    pieces.union_set(t[0], t[1]);
    pieces.union_set(t[0], t[2]);
  }
  for(std::size_t i = 0; i < is_reversed.size(); ++i)
  {
    const std::size_t piece = pieces.find_set(oriented.triangles[i][0]);
    ++size[piece];
    number_of_reversed[piece] += is_reversed[i];
  }
  for(std::size_t i = 0; i < is_reversed.size(); ++i)
  {
    const std::size_t piece = pieces.find_set(oriented.triangles[i][0]);
    if(is_reversed[i] == (2 * number_of_reversed[piece] > size[piece]))
      continue;
    std::reverse(soup.triangles[i].begin(), soup.triangles[i].end());
    sources.push_back(soup.triangles[i].source);
  }
  sources.erase(std::unique(sources.begin(), sources.end()), sources.end());
  return sources;
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_ORIENT_TRIANGLES_H

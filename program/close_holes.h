#ifndef BOUNDARY_RECOVERY_3_PROGRAM_CLOSE_HOLES_H
#define BOUNDARY_RECOVERY_3_PROGRAM_CLOSE_HOLES_H

#include "boundary_loops.h"
#include "fill_loop.h"
#include "find_intersections.h"
#include "surface.h"
#include "surface_changes.h"
#include "triangle_soup.h"

#include <CGAL/Kernel_traits.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

// Closes the loops of a surface that are not too long, each by itself, by CGAL's hole filling, with no new point. Loops
// whose triangles would cross the surface, or those of a loop before, stay open: nobody knows what is wanted there.
template <typename Point>
class Hole_closer
{
  typedef typename CGAL::Kernel_traits<Point>::Kernel Kernel;
  typedef std::vector<std::size_t>                    Triangle;

  Surface<Point>& m_surface;
  std::map<Vertex_numbers, Open_edge> m_edges;
  std::set<Triangle> m_sorted_faces;    // each with its vertices in ascending order
  std::vector<Triangle> m_proper_faces; // those with an area, each once
  std::vector<Hole> m_holes;

public:
  explicit Hole_closer(Surface<Point>& surface) : m_surface(surface) { }

  // Loops longer than `max_length` stay. Returns all the loops.
  std::vector<Hole> operator()(const double max_length)
  {
    const std::vector<Open_edge> edges = open_edges(m_surface.faces);
    for(const Open_edge& e : edges)
      m_edges.emplace(e.vertices, e);
    for(const Triangle& face : m_surface.faces)
      if(is_new_and_proper(face))
        m_proper_faces.push_back(face);
    for(const Boundary_loop& loop : find_boundary_loops(m_surface.points, edges).loops)
      m_holes.push_back(make_hole(loop, max_length));
    refuse_crossing_holes();
    for(const Hole& hole : m_holes)
      if(hole.state == Hole_state::closed)
        add(hole);
    return std::move(m_holes);
  }

private:
  static Triangle sorted(Triangle t)
  {
    std::sort(t.begin(), t.end());
    return t;
  }

  // whether a triangle has an area and was not asked for before
  bool is_new_and_proper(const Triangle& t)
  {
    const auto point = [&](const int i) -> const Point& { return m_surface.points[t[i]]; };
    return ! Kernel().collinear_3_object()(point(0), point(1), point(2)) && m_sorted_faces.insert(sorted(t)).second;
  }

  Hole make_hole(const Boundary_loop& loop, const double max_length)
  {
    Hole hole;
    hole.loop = loop;
    if(! loop.is_closed)
      hole.state = Hole_state::chain;
    else if(loop.length > max_length)
      hole.state = Hole_state::too_long;
    else if(! fill(hole))
      hole.state = Hole_state::not_filled;
    return hole;
  }

  // A lone triangle would be filled by itself, what is along a line by triangles without area.
  bool fill(Hole& hole)
  {
    triangulate(hole);
    orient(hole);
    return ! hole.triangles.empty() && std::all_of(hole.triangles.begin(), hole.triangles.end(),
                                                   [&](const Triangle& t) { return is_new_and_proper(t); });
  }

  // The triangles beside the hole make its filling go on as they do.
  void triangulate(Hole& hole)
  {
    const std::vector<std::size_t>& v = hole.loop.vertices;
    std::vector<Point> opposite;
    for(std::size_t i = 0; i < v.size(); ++i)
    {
      const Open_edge& e = m_edges.at(std::minmax(v[i], v[(i + 1) % v.size()]));
      opposite.push_back(m_surface.points[e.opposite]);
      hole.neighbors.push_back(e.triangle);
    }
    for(const auto& t : fill_loop(m_surface.points, v, opposite))
      hole.triangles.emplace_back(t.begin(), t.end());
  }

  // turns the triangles as most of their neighbors are
  void orient(Hole& hole) const
  {
    const std::vector<std::size_t>& v = hole.loop.vertices;
    std::size_t number_along = 0;
    for(std::size_t i = 0; i < v.size(); ++i)
      number_along += goes_along(m_surface.faces[hole.neighbors[i]], v[i], v[(i + 1) % v.size()]);
    if(2 * number_along > v.size())
      for(Triangle& t : hole.triangles)
        std::reverse(t.begin(), t.end());
  }

  // New triangles come first: of too many intersections, those of the first triangles are listed.
  void refuse_crossing_holes()
  {
    Triangle_soup<Point> soup;
    soup.points = m_surface.points;
    for(std::size_t h = 0; h < m_holes.size(); ++h)
      if(m_holes[h].state == Hole_state::closed)
        for(const Triangle& t : m_holes[h].triangles)
          soup.triangles.push_back(Sourced_triangle({{ t[0], t[1], t[2] }}, h));
    if(soup.triangles.empty())
      return;
    for(const Triangle& t : m_proper_faces)
      soup.triangles.push_back(Sourced_triangle({{ t[0], t[1], t[2] }}, m_holes.size()));
    for(const auto& pair : Intersection_finder<Point>(soup).pairs())
      refuse(soup.triangles[pair[0]].source, soup.triangles[pair[1]].source);
  }

  // Of two holes that cross, the second one stays open, unless the first one does.
  void refuse(const std::size_t first, const std::size_t second)
  {
    if(first == m_holes.size() || m_holes[first].state != Hole_state::closed)
      return;
    m_holes[second == m_holes.size() ? first : second].state = Hole_state::crossing;
  }

  // that of all the neighbors, or none
  int patch_around(const Hole& hole) const
  {
    const int patch = m_surface.patches[hole.neighbors[0]];
    return std::all_of(hole.neighbors.begin(), hole.neighbors.end(),
                       [&](const std::size_t f) { return m_surface.patches[f] == patch; }) ? patch : 0;
  }

  void add(const Hole& hole)
  {
    const int patch = patch_around(hole);
    for(const Triangle& t : hole.triangles)
    {
      m_surface.faces.push_back(t);
      m_surface.file_faces.push_back(Surface<Point>::no_face);
      m_surface.patches.push_back(patch);
    }
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_CLOSE_HOLES_H

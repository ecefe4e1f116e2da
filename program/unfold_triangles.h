#ifndef BOUNDARY_RECOVERY_3_PROGRAM_UNFOLD_TRIANGLES_H
#define BOUNDARY_RECOVERY_3_PROGRAM_UNFOLD_TRIANGLES_H

#include "boundary_loops.h"
#include "fill_loop.h"
#include "find_intersections.h"
#include "triangle_soup.h"

#include <CGAL/Kernel_traits.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

// Unfolds a surface where it is folded flat, as if a vertex had been moved over an edge: triangles that intersect and
// are in one plane, as far as the tolerance tells, are replaced by others with the same border. Were they divided where
// they intersect, thin gaps would stay between the layers of the fold. What would intersect again, or has more than one
// border, stays as it is.
template <typename Point>
class Triangle_unfolder
{
  typedef typename CGAL::Kernel_traits<Point>::Kernel Kernel;
  typedef typename Kernel::Vector_3                   Vector;

  // triangles of the soup, and those in their place
  struct Fold
  {
    std::vector<std::size_t> triangles;
    std::vector<Sourced_triangle> replacement;
  };

  Triangle_soup<Point>& m_soup;
  const double m_tolerance;

public:
  Triangle_unfolder(Triangle_soup<Point>& soup, const double tolerance) : m_soup(soup), m_tolerance(tolerance) { }

  // returns the sources of the triangles that are replaced, in ascending order
  std::vector<std::size_t> operator()()
  {
    std::vector<Fold> folds;
    for(const auto& triangles : find_folds())
    {
      folds.push_back(Fold{ triangles, {} });
      replace(folds.back());
    }
    drop_bad(folds);
    std::vector<std::size_t> sources;
    for(const Fold& fold : folds)
      for(const std::size_t t : fold.triangles)
        sources.push_back(m_soup.triangles[t].source);
    m_soup = unfolded(folds);
    std::sort(sources.begin(), sources.end());
    sources.erase(std::unique(sources.begin(), sources.end()), sources.end());
    return sources;
  }

private:
  // sets of triangles, each connected by pairs that intersect in one plane
  std::vector<std::vector<std::size_t> > find_folds() const
  {
    const std::size_t n = m_soup.triangles.size();
    std::vector<std::size_t> rank(n), parent(n);
    boost::disjoint_sets<std::size_t*, std::size_t*> sets(rank.data(), parent.data());
    for(std::size_t t = 0; t < n; ++t)
      sets.make_set(t);
    for(const auto& pair : Intersection_finder<Point>(m_soup).pairs())
      if(are_in_one_plane(pair[0], pair[1]) || are_in_one_plane(pair[1], pair[0]))
        sets.union_set(pair[0], pair[1]);
    std::map<std::size_t, std::vector<std::size_t> > members;
    for(std::size_t t = 0; t < n; ++t)
      members[sets.find_set(t)].push_back(t);
    std::vector<std::vector<std::size_t> > folds;
    for(const auto& set : members)
      if(set.second.size() > 1)
        folds.push_back(set.second);
    std::sort(folds.begin(), folds.end());
    return folds;
  }

  const Point& point(const std::size_t triangle, const int i) const
  {
    return m_soup.points[m_soup.triangles[triangle][i]];
  }

  // whether the vertices of one triangle are close to the plane of the other one
  bool are_in_one_plane(const std::size_t plane, const std::size_t triangle) const
  {
    const Vector normal = CGAL::cross_product(point(plane, 1) - point(plane, 0), point(plane, 2) - point(plane, 0));
    const double length = std::sqrt(normal.squared_length());
    for(int i = 0; i < 3; ++i)
      if(! (std::abs(normal * (point(triangle, i) - point(plane, 0))) <= m_tolerance * length))
        return false;
    return true;
  }

  // no replacement is found if the border is not one loop
  void replace(Fold& fold) const
  {
    std::vector<Sourced_triangle> triangles;
    for(const std::size_t t : fold.triangles)
      triangles.push_back(m_soup.triangles[t]);
    const std::vector<Open_edge> edges = open_edges(triangles);
    const Boundary_loops border = find_boundary_loops(m_soup.points, edges);
    if(border.loops.size() != 1 || ! border.loops[0].is_closed)
      return;
    std::vector<std::size_t> loop = border.loops[0].vertices;
    if(! goes_along(triangles[triangle_at(edges, loop[0], loop[1])], loop[0], loop[1]))
      std::reverse(loop.begin(), loop.end());
    for(const auto& t : fill_loop(m_soup.points, loop))
      fold.replacement.push_back(Sourced_triangle(t, source_of(t, triangles, edges)));
  }

  static std::size_t triangle_at(const std::vector<Open_edge>& edges, const std::size_t v, const std::size_t w)
  {
    const Vertex_numbers vertices = std::minmax(v, w);
    const auto edge = std::lower_bound(edges.begin(), edges.end(), vertices, [](const Open_edge& e, const auto& edge)
                                       { return e.vertices < edge; });
    return edge != edges.end() && edge->vertices == vertices ? edge->triangle : std::size_t(-1);
  }

  // that of the triangle that has had an edge of it on the border, or else of the first one
  static std::size_t source_of(const std::array<std::size_t, 3>& t, const std::vector<Sourced_triangle>& triangles,
                               const std::vector<Open_edge>& edges)
  {
    for(int i = 0; i < 3; ++i)
    {
      const std::size_t triangle = triangle_at(edges, t[i], t[(i + 1) % 3]);
      if(triangle != std::size_t(-1))
        return triangles[triangle].source;
    }
    return triangles[0].source;
  }

  // forgets folds without a replacement, and those whose replacement intersects anything
  void drop_bad(std::vector<Fold>& folds) const
  {
    const auto drop = [&](const auto& is_bad)
    { folds.erase(std::remove_if(folds.begin(), folds.end(), is_bad), folds.end()); };

    drop([](const Fold& fold) { return fold.replacement.empty(); });
    const Triangle_soup<Point> soup = unfolded(folds);
    std::vector<bool> is_bad(soup.triangles.size(), false);
    for(const auto& pair : Intersection_finder<Point>(soup).pairs())
      is_bad[pair[0]] = is_bad[pair[1]] = true;
    std::size_t first = 0; // replacements come first
    drop([&](const Fold& fold)
    {
      const auto begin = is_bad.begin() + first, end = begin + fold.replacement.size();
      first += fold.replacement.size();
      return std::find(begin, end, true) != end;
    });
  }

  // the replacements, then all that is not replaced
  Triangle_soup<Point> unfolded(const std::vector<Fold>& folds) const
  {
    std::vector<bool> is_replaced(m_soup.triangles.size(), false);
    Triangle_soup<Point> soup;
    soup.points = m_soup.points;
    for(const Fold& fold : folds)
    {
      soup.triangles.insert(soup.triangles.end(), fold.replacement.begin(), fold.replacement.end());
      for(const std::size_t t : fold.triangles)
        is_replaced[t] = true;
    }
    for(std::size_t t = 0; t < is_replaced.size(); ++t)
      if(! is_replaced[t])
        soup.triangles.push_back(m_soup.triangles[t]);
    return soup;
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_UNFOLD_TRIANGLES_H

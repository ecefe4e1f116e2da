#ifndef BOUNDARY_RECOVERY_3_PROGRAM_UNFOLD_TRIANGLES_H
#define BOUNDARY_RECOVERY_3_PROGRAM_UNFOLD_TRIANGLES_H

#include "boundary_loops.h"
#include "disjoint_sets.h"
#include "fill_loop.h"
#include "find_intersections.h"
#include "triangle_soup.h"

#include <CGAL/Kernel_traits.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

// Unfolds a surface where it is folded flat, as if a vertex had been moved over an edge: triangles that intersect and
// are in one plane, as far as the tolerance tells, are replaced by others with the same border, and so are triangles
// beside them that are folded at an edge. Were they divided where they intersect, thin gaps would stay between the
// layers of the fold. What would intersect again, or has more than one border, stays as it is.
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
      folds.push_back(Fold{ triangles, {} });
    do
      for(Fold& fold : folds)
        replace(fold);
    while(grow(folds)); // there is an end: there are so many triangles
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
  // Folds that do not touch any intersection may be thin edges that are meant.
  std::vector<std::vector<std::size_t> > find_folds() const
  {
    const std::size_t n = m_soup.triangles.size();
    Disjoint_sets sets(n);
    std::vector<bool> is_folded(n, false), has_intersection(n, false);
    const auto unite = [&](const std::size_t s, const std::size_t t)
    {
      sets.union_set(s, t);
      is_folded[s] = is_folded[t] = true;
    };
    for(const auto& pair : Intersection_finder<Point>(m_soup).pairs())
      if(are_in_one_plane(m_soup.triangles[pair[0]], m_soup.triangles[pair[1]]))
      {
        unite(pair[0], pair[1]);
        has_intersection[pair[0]] = true;
      }
    visit_neighbors(m_soup, [&](const Triangle_edge& e, const Triangle_edge& f)
    {
      if(is_folded_at(e, f))
        unite(e.triangle, f.triangle);
    });
    visit_neighbors(m_soup, [&](const Triangle_edge& e, const Triangle_edge& f)
    {
      if(is_folded[e.triangle] && is_folded[f.triangle])
        sets.union_set(e.triangle, f.triangle);
    });
    return sets_with(sets, has_intersection);
  }

  // calls `visit` with the edges of each two triangles that have an edge in common, are the only ones, and in one plane
  template <typename Visit>
  void visit_neighbors(const Triangle_soup<Point>& soup, const Visit& visit) const
  {
    visit_edges(soup.triangles, [&](const auto edge, const std::size_t number)
    {
      if(number == 2 && are_in_one_plane(soup.triangles[edge->triangle], soup.triangles[(edge + 1)->triangle]))
        visit(*edge, *(edge + 1));
    });
  }

  // whether both triangles are on the same side of the edge
  bool is_folded_at(const Triangle_edge& e, const Triangle_edge& f) const
  {
    const Point& p = m_soup.points[e.vertices.first];
    const Vector edge = m_soup.points[e.vertices.second] - p;
    return CGAL::cross_product(edge, m_soup.points[e.opposite] - p) *
           CGAL::cross_product(edge, m_soup.points[f.opposite] - p) > 0;
  }

  // the sets that have a marked triangle
  std::vector<std::vector<std::size_t> > sets_with(Disjoint_sets& sets, const std::vector<bool>& is_marked) const
  {
    std::map<std::size_t, std::vector<std::size_t> > members;
    for(std::size_t t = 0; t < is_marked.size(); ++t)
      members[sets.find_set(t)].push_back(t);
    std::vector<std::vector<std::size_t> > result;
    for(const auto& set : members)
      if(std::any_of(set.second.begin(), set.second.end(), [&](const std::size_t t) { return is_marked[t]; }))
        result.push_back(set.second);
    std::sort(result.begin(), result.end());
    return result;
  }

  // whether the vertices of one triangle are close to the plane of the other one
  bool are_in_one_plane(const Sourced_triangle& s, const Sourced_triangle& t) const
  {
    return is_in_plane(s, t) || is_in_plane(t, s);
  }

  bool is_in_plane(const Sourced_triangle& triangle, const Sourced_triangle& plane) const
  {
    const Point& p = m_soup.points[plane[0]];
    const Vector normal = CGAL::cross_product(m_soup.points[plane[1]] - p, m_soup.points[plane[2]] - p);
    const double length = std::sqrt(normal.squared_length());
    return std::all_of(triangle.begin(), triangle.end(), [&](const std::size_t v)
                       { return std::abs(normal * (m_soup.points[v] - p)) <= m_tolerance * length; });
  }

  // no replacement is found if the border is not one loop
  void replace(Fold& fold) const
  {
    fold.replacement.clear();
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

  // adds triangles that are folded at the border of a replacement; returns whether there are any
  bool grow(std::vector<Fold>& folds) const
  {
    std::vector<std::size_t> owners; // of the triangles when folds are replaced: the fold, then the old position
    for(std::size_t f = 0; f < folds.size(); ++f)
      owners.insert(owners.end(), folds[f].replacement.size(), f);
    const std::size_t number_of_new_triangles = owners.size();
    const std::vector<bool> is_replaced = replaced(folds);
    for(std::size_t t = 0; t < is_replaced.size(); ++t)
      if(! is_replaced[t])
        owners.push_back(t);
    std::map<std::size_t, std::size_t> added; // triangles, and their folds
    visit_neighbors(unfolded(folds), [&](const Triangle_edge& e, const Triangle_edge& f)
    {
      const auto [first, second] = std::minmax(e.triangle, f.triangle);
      if(first < number_of_new_triangles && second >= number_of_new_triangles && is_folded_at(e, f))
        added.emplace(owners[second], owners[first]);
    });
    for(const auto& triangle : added)
      folds[triangle.second].triangles.push_back(triangle.first);
    return ! added.empty();
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

  std::vector<bool> replaced(const std::vector<Fold>& folds) const
  {
    std::vector<bool> result(m_soup.triangles.size(), false);
    for(const Fold& fold : folds)
      if(! fold.replacement.empty())
        for(const std::size_t t : fold.triangles)
          result[t] = true;
    return result;
  }

  // the replacements, then all that is not replaced
  Triangle_soup<Point> unfolded(const std::vector<Fold>& folds) const
  {
    Triangle_soup<Point> soup;
    soup.points = m_soup.points;
    for(const Fold& fold : folds)
      soup.triangles.insert(soup.triangles.end(), fold.replacement.begin(), fold.replacement.end());
    const std::vector<bool> is_replaced = replaced(folds);
    for(std::size_t t = 0; t < is_replaced.size(); ++t)
      if(! is_replaced[t])
        soup.triangles.push_back(m_soup.triangles[t]);
    return soup;
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_UNFOLD_TRIANGLES_H

// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_GROWING_CAVITY_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_GROWING_CAVITY_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/cavity/Candidate_tetrahedra_3.h>
#include <CGAL/Boundary_recovery_3/internal/cavity/Cavity_3.h>
#include <CGAL/Boundary_recovery_3/internal/cavity/Face_matching.h>
#include <CGAL/Boundary_recovery_3/internal/cavity/Tetrahedralization_search.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Functions that let a `Cavity_3` grow. A cavity *spans* a cell if all four vertices of the cell are in the cavity.
 * Spanned cells behind a face of the boundary are added, until there are none left. A cavity never grows through
 * constrained facets or through the hull: what is behind these faces has nothing to do with what is in front.
 */

// Adds the cells that the cavity spans. Only faces of the cells from position `first_new` on are looked behind.
template <typename Cavity>
void add_spanned_cells(Cavity& cavity, const std::size_t first_new = 0)
{
  for(std::size_t k = first_new; k < cavity.cells().size(); ++k) // it grows
    for(int i = 0; i < 4; ++i)
    {
      const auto c = cavity.cells()[k];
      const auto n = c->neighbor(i);
      if(! cavity.contains(n) && cavity.contains(n->vertex(n->index(c))) && ! cavity.is_closed(c, i))
        cavity.add(n);
    }
}

// Adds a vertex that is behind a face, with all the cells that it brings.
template <typename Cavity>
void add_spanning_vertex(Cavity& cavity, const typename Cavity::Vertex_handle x)
{
  std::vector<typename Cavity::Cell_handle> cells;
  for(const auto& f : cavity.boundary())
    if(f.vertex_behind == x)
      cells.push_back(f.cell_behind);
  const std::size_t before = cavity.cells().size();
  for(const auto c : cells)
    cavity.add(c);
  internal::add_spanned_cells(cavity, before);
}

// The vertices behind faces that are not closed, those behind the largest number of such faces first.
template <typename Cavity>
typename Cavity::Vertices vertices_behind(Cavity& cavity)
{
  typedef typename Cavity::Vertex_handle Vertex_handle;
  Simplex_index_3<Vertex_handle, 1> known;
  std::vector<std::pair<std::size_t, Vertex_handle> > counts;
  for(const auto& f : cavity.boundary())
  {
    if(f.vertex_behind == Vertex_handle())
      continue;
    const auto inserted = known.insert({{ f.vertex_behind }});
    if(inserted.second)
      counts.push_back({ 0, f.vertex_behind });
    ++counts[inserted.first].first;
  }
  std::stable_sort(counts.begin(), counts.end(), [](const auto& x, const auto& y) { return x.first > y.first; });
  typename Cavity::Vertices result;
  for(const auto& c : counts)
    result.push_back(c.second);
  return result;
}

/*
 * Searches for tetrahedra that fill a cavity around a Steiner point without using this point. As long as there are
 * none, the cavity grows to twice as many vertices, by those that touch it most, and the search is repeated.
 */
template <typename Tr>
class Growing_cavity_3
  : public Tetrahedralization_search
{
public:
  typedef typename Tr::Vertex_handle           Vertex_handle;
  typedef typename Tr::Cell_handle             Cell_handle;
  typedef Vertex_predicates_3<Tr>              Predicates;
  typedef Constraints_3<Tr>                    Constraints;
  typedef Cavity_3<Tr, Constraints>            Cavity;
  typedef Candidate_tetrahedra_3<Tr>           Candidates;
  typedef typename Candidates::Tetrahedron     Tetrahedron;
  typedef std::vector<Vertex_handle>           Vertices;

  Growing_cavity_3(const Tr& tr, const Predicates& predicates, const Constraints& constraints)
    : m_constraints(constraints), m_cavity(tr, constraints), m_candidates(predicates)
  { }

  // Searches for tetrahedra that fill a cavity around the star of v without v. The tetrahedra need not use the
  // `points`, which may be deleted. Returns `NONE` if constraints and the hull enclose a cavity that cannot be filled,
  // and `GAVE_UP` if a bound was reached or the context says stop.
  template <typename Context>
  Outcome operator()(const std::vector<Cell_handle>& star, const Vertex_handle v, const Vertices& points,
                     const Bounds& bounds, Context& context)
  {
    start(star);
    while(number_of_vertices() <= bounds.vertices && context.go_further())
    {
      const Outcome outcome = reconnect(v, points, bounds);
      if(outcome == FOUND)
        collect_result(v);
      if(outcome != NONE || internal::vertices_behind(m_cavity).empty())
        return outcome;
      if(! grow(bounds, context))
        return GAVE_UP;
    }
    return GAVE_UP;
  }

  // The cells to be replaced, by which tetrahedra, and the points that are then gone.
  const std::vector<Cell_handle>& cells() const { return m_cavity.cells(); }
  const std::vector<Tetrahedron>& tetrahedra() const { return m_tetrahedra; }
  const Vertices& dropped_points() const { return m_dropped_points; }

  // The vertices of the largest cavity that was searched.
  const Vertices& vertices() { return m_cavity.vertices(); }

private:
  void start(const std::vector<Cell_handle>& star)
  {
    m_cavity.clear();
    for(const Cell_handle c : star)
      m_cavity.add(c);
    internal::add_spanned_cells(m_cavity);
  }

  // Without the point.
  std::size_t number_of_vertices() { return m_cavity.vertices().size() - 1; }

  Outcome reconnect(const Vertex_handle v, const Vertices& points, const Bounds& bounds)
  {
    std::vector<std::array<Vertex_handle, 2> > edges;
    std::vector<typename Candidates::Vertex_triple> facets;
    internal::collect_constraints(m_constraints, m_cavity.cells(), edges, facets);
    if(! m_candidates.collect(m_cavity.cells(), edges, facets, points, v, bounds.tetrahedra))
      return GAVE_UP;
    return m_matching(m_candidates.number_of_sides(), m_candidates.tetrahedra(), m_candidates.boundary(),
                      bounds.steps);
  }

  void collect_result(const Vertex_handle v)
  {
    m_tetrahedra.clear();
    Vertices used;
    for(const std::size_t t : m_matching.selection())
    {
      m_tetrahedra.push_back(m_candidates.vertices_of_tetrahedron(t));
      used.insert(used.end(), m_tetrahedra.back().begin(), m_tetrahedra.back().end());
    }
    m_dropped_points.assign(1, v);
    for(const Vertex_handle w : m_candidates.vertices())
      if(! internal::contains(used, w))
        m_dropped_points.push_back(w);
  }

  // Adds vertices to the cavity, with the cells that it spans then. Returns false if no vertex was added, or if there
  // would be too many tetrahedra by an estimate: their number mostly grows with the square of the number of vertices,
  // or faster.
  template <typename Context>
  bool grow(const Bounds& bounds, Context& context)
  {
    const std::size_t before = number_of_vertices();
    const std::size_t wanted = (std::min)(2 * before, bounds.vertices);
    if(m_candidates.tetrahedra().size() * wanted / before * wanted / before > bounds.tetrahedra)
      return false;
    while(number_of_vertices() < wanted && context.go_further())
    {
      const Vertices vertices = internal::vertices_behind(m_cavity);
      if(vertices.empty())
        break;
      internal::add_spanning_vertex(m_cavity, vertices.front());
    }
    return number_of_vertices() > before;
  }

  const Constraints& m_constraints;
  Cavity m_cavity;
  Candidates m_candidates;
  Face_matching m_matching;
  std::vector<Tetrahedron> m_tetrahedra;
  Vertices m_dropped_points;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_GROWING_CAVITY_3_H

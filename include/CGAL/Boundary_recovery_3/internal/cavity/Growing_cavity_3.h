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

#include <CGAL/Bbox_3.h>
#include <CGAL/enum.h>

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
 * none, the cavity grows, and the search is repeated.
 *
 * A cavity can grow towards its *dead ends*: if no tetrahedra fill it, this follows from some faces that make no
 * tetrahedron with any vertex of the cavity. The next vertices are those outside that make tetrahedra with these faces,
 * see "Tuning constants" in the manual.
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

  // How a cavity grows.
  enum Growth
  {
    AROUND,           // to twice as many vertices, those that touch it most
    TOWARD_DEAD_ENDS  // by a third, to where it has to; one vertex at a time takes longer, and is of no more use
  };

  Growing_cavity_3(const Tr& tr, const Predicates& predicates, const Constraints& constraints)
    : m_predicates(predicates), m_constraints(constraints), m_cavity(tr, constraints),
      m_candidates(predicates)
  { }

  // Searches for tetrahedra that fill a cavity around the star of v without v. The tetrahedra need not use the
  // `points`, which may be deleted. Returns `NONE` if constraints and the hull enclose a cavity that cannot be filled,
  // and `GAVE_UP` if a bound was reached or the context says stop.
  template <typename Context>
  Outcome operator()(const std::vector<Cell_handle>& star, const Vertex_handle v, const Vertices& points,
                     const Growth growth, const Bounds& bounds, Context& context)
  {
    start(star);
    while(number_of_vertices() <= bounds.vertices && context.go_further())
    {
      const Outcome outcome = reconnect(v, points, bounds);
      if(outcome == FOUND)
        collect_result(v);
      if(outcome != NONE || internal::vertices_behind(m_cavity).empty())
        return outcome;
      if(! grow(growth, bounds, context))
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
  typedef typename Candidates::Vertex_triple   Vertex_triple;

  // What hides the vertices behind the boundary of the cavity from its faces.
  class Obstacles
  {
  public:
    typedef std::vector<typename Cavity::Boundary_face> Faces;

    Obstacles(const Faces& faces, const Predicates& predicates) : m_faces(faces), m_predicates(predicates)
    {
      for(const auto& f : m_faces)
        m_boxes.push_back(m_predicates.bbox(f.face[0]) + m_predicates.bbox(f.face[1]) + m_predicates.bbox(f.face[2]));
    }

    // For each of the faces, whether x is on its positive side and sees its three vertices. Constrained facets and hull
    // facets on the boundary block the view; if `with_open_faces`, so do all other faces of the boundary, except those
    // that x is right behind.
    std::vector<char> are_seen(const Vertex_handle x, const std::vector<Vertex_triple>& faces,
                               const bool with_open_faces) const
    {
      std::vector<std::pair<Vertex_handle, bool> > known; // many of the faces share vertices
      const auto is_seen = [&](const Vertex_handle w)
      {
        const auto it = std::find_if(known.begin(), known.end(), [&](const auto& k) { return k.first == w; });
        if(it != known.end())
          return it->second;
        known.push_back({ w, sees(x, w, with_open_faces) });
        return known.back().second;
      };
      std::vector<char> result;
      for(const Vertex_triple& f : faces)
        result.push_back(m_predicates.orientation(f[0], f[1], f[2], x) == POSITIVE
                         && std::all_of(f.begin(), f.end(), is_seen));
      return result;
    }

  private:
    bool sees(const Vertex_handle x, const Vertex_handle w, const bool with_open_faces) const
    {
      const Bbox_3 box = m_predicates.bbox(w) + m_predicates.bbox(x);
      for(std::size_t i = 0; i < m_faces.size(); ++i)
      {
        const Vertex_handle behind = m_faces[i].vertex_behind;
        const Vertex_triple& f = m_faces[i].face;
        if((behind == Vertex_handle() || (with_open_faces && behind != x)) && CGAL::do_overlap(box, m_boxes[i])
           && m_predicates.segment_pierces_triangle(w, x, f[0], f[1], f[2]))
          return false;
      }
      return true;
    }

    Faces m_faces;
    const Predicates& m_predicates;
    std::vector<Bbox_3> m_boxes;
  };

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
    std::vector<Vertex_triple> facets;
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
  bool grow(const Growth growth, const Bounds& bounds, Context& context)
  {
    const std::size_t before = number_of_vertices();
    const std::size_t wanted = (std::min)(growth == AROUND ? 2 * before : before + before / 3 + 1, bounds.vertices);
    if(m_candidates.tetrahedra().size() * wanted / before * wanted / before > bounds.tetrahedra)
      return false;
    std::vector<Vertex_triple> faces;
    if(growth == TOWARD_DEAD_ENDS)
      faces = dead_ends();
    while(number_of_vertices() < wanted && context.go_further())
    {
      const Vertex_handle x = next_vertex(faces);
      if(x == Vertex_handle())
        break;
      internal::add_spanning_vertex(m_cavity, x);
    }
    return number_of_vertices() > before;
  }

  std::vector<Vertex_triple> dead_ends() const
  {
    std::vector<Vertex_triple> result;
    for(const Face_matching::Side s : m_matching.dead_ends())
      result.push_back(m_candidates.vertices_of_side(s));
    return result;
  }

  // The vertex behind the boundary that sees the most of the `faces`, and most likely makes tetrahedra with them. The
  // faces that it sees are taken out of the list. If no vertex sees a face, the same without regard to open faces of
  // the boundary, since the cavity may grow beyond them; then no face is taken out. If that finds no vertex, or if
  // there are no `faces`, the vertex behind the most boundary faces; none if all boundary faces are closed.
  Vertex_handle next_vertex(std::vector<Vertex_triple>& faces)
  {
    const Vertices vertices = internal::vertices_behind(m_cavity);
    if(vertices.empty() || faces.empty())
      return vertices.empty() ? Vertex_handle() : vertices.front();
    const Obstacles obstacles(m_cavity.boundary(), m_predicates);
    for(const bool with_open_faces : { true, false })
    {
      Vertex_handle best;
      std::vector<char> seen_from_best;
      std::ptrdiff_t most = 0;
      for(const Vertex_handle x : vertices)
      {
        std::vector<char> seen = obstacles.are_seen(x, faces, with_open_faces);
        const std::ptrdiff_t number = std::count(seen.begin(), seen.end(), true);
        if(number <= most)
          continue;
        most = number;
        best = x;
        seen_from_best = std::move(seen);
      }
      if(most == 0)
        continue;
      if(with_open_faces)
        take_out(seen_from_best, faces);
      return best;
    }
    return vertices.front();
  }

  static void take_out(const std::vector<char>& marks, std::vector<Vertex_triple>& faces)
  {
    std::vector<Vertex_triple> result;
    for(std::size_t i = 0; i < faces.size(); ++i)
      if(! marks[i])
        result.push_back(faces[i]);
    faces = std::move(result);
  }

  const Predicates& m_predicates;
  const Constraints& m_constraints;
  Cavity m_cavity;
  Candidates m_candidates;
  Face_matching m_matching;
  std::vector<Tetrahedron> m_tetrahedra;
  Vertices m_dropped_points;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_GROWING_CAVITY_3_H

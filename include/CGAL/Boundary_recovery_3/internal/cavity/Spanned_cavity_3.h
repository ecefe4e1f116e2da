// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_SPANNED_CAVITY_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_SPANNED_CAVITY_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * The cells of the mesh that some vertices span around the ball of a vertex: those of the ball, and those behind faces
 * of the cavity that have no other vertices, as long as there are such. What is behind a constrained face has nothing
 * to do with what is in front of it, so the cavity does not grow through these, nor through the hull.
 */
template <typename Tr>
class Spanned_cavity_3
{
public:
  typedef typename Tr::Vertex_handle           Vertex_handle;
  typedef typename Tr::Cell_handle             Cell_handle;
  typedef Constraints_3<Tr>                    Constraints;
  typedef std::array<Vertex_handle, 3>         Triangle;

  // A face of the boundary, seen from inside, and the vertex of the cell behind it; none if it is closed: constrained,
  // or on the hull.
  struct Boundary_face
  {
    Triangle face;
    Vertex_handle vertex_behind;
    Cell_handle cell_behind;
  };

  Spanned_cavity_3(const Tr& tr, const Constraints& constraints) : m_tr(tr), m_constraints(constraints) { }

  // Starts with the ball of v, and the cells between its vertices.
  void initialize(const std::vector<Cell_handle>& ball, const Vertex_handle v)
  {
    m_cells.clear();
    m_index_of_cell = Index<Cell_handle>();
    m_index_of_vertex = Index<Vertex_handle>();
    m_boundary.clear();
    for(const Vertex_handle w : internal::vertices_without(ball, v))
      m_index_of_vertex.insert({{ w }});
    for(const Cell_handle c : ball)
      add_cell(c);
    add_spanned_cells(0);
  }

  // Adds a vertex that is behind a face, with all the cells that it brings.
  void add(const Vertex_handle x)
  {
    m_index_of_vertex.insert({{ x }});
    const std::size_t before = m_cells.size();
    for(const Boundary_face& f : m_boundary)
      if(f.vertex_behind == x)
        add_cell(f.cell_behind);
    add_spanned_cells(before);
  }

  const std::vector<Cell_handle>& cells() const { return m_cells; }

  // Of those that span the cavity; the one whose ball it started with is not among them.
  std::size_t number_of_vertices() const { return m_index_of_vertex.size(); }

  const std::vector<Boundary_face>& boundary() const { return m_boundary; }

  // The vertices behind faces that are not closed, those behind the largest number of such faces first.
  std::vector<Vertex_handle> vertices_behind() const
  {
    Index<Vertex_handle> known;
    std::vector<std::pair<std::size_t, Vertex_handle> > counts;
    for(const Boundary_face& f : m_boundary)
    {
      if(f.vertex_behind == Vertex_handle())
        continue;
      const auto inserted = known.insert({{ f.vertex_behind }});
      if(inserted.second)
        counts.push_back({ 0, f.vertex_behind });
      ++counts[inserted.first].first;
    }
    std::stable_sort(counts.begin(), counts.end(), [](const auto& x, const auto& y) { return x.first > y.first; });
    std::vector<Vertex_handle> result;
    for(const auto& c : counts)
      result.push_back(c.second);
    return result;
  }

private:
  template <typename Handle>
  using Index = Simplex_index_3<Handle, 1>;

  bool contains(const Cell_handle c) const { return m_index_of_cell[{{ c }}] != m_index_of_cell.none; }
  bool contains(const Vertex_handle v) const { return m_index_of_vertex[{{ v }}] != m_index_of_vertex.none; }

  void add_cell(const Cell_handle c)
  {
    if(m_index_of_cell.insert({{ c }}).second)
      m_cells.push_back(c);
  }

  // Adds what is behind the cells from the given one on, which are new, and updates the boundary.
  void add_spanned_cells(const std::size_t first_new)
  {
    std::vector<Boundary_face> faces; // of the new cells
    for(std::size_t k = first_new; k < m_cells.size(); ++k) // it grows
      for(int i = 0; i < 4; ++i)
      {
        const Cell_handle c = m_cells[k];
        if(contains(c->neighbor(i)))
          continue;
        faces.push_back(boundary_face(c, i));
        if(faces.back().vertex_behind != Vertex_handle() && contains(faces.back().vertex_behind))
          add_cell(c->neighbor(i));
      }
    m_boundary.insert(m_boundary.end(), faces.begin(), faces.end());
    m_boundary.erase(std::remove_if(m_boundary.begin(), m_boundary.end(),
                                    [this](const Boundary_face& f) { return contains(f.cell_behind); }),
                     m_boundary.end());
  }

  Boundary_face boundary_face(const Cell_handle c, const int i) const
  {
    const Cell_handle n = c->neighbor(i);
    Boundary_face result = { internal::facet_vertices(c, i), Vertex_handle(), n };
    const Triangle& f = result.face;
    if(! m_tr.is_infinite(n) && ! m_constraints.is_constrained(f[0], f[1], f[2]))
      result.vertex_behind = n->vertex(n->index(c));
    return result;
  }

  const Tr& m_tr;
  const Constraints& m_constraints;
  std::vector<Cell_handle> m_cells;
  Index<Cell_handle> m_index_of_cell;
  Index<Vertex_handle> m_index_of_vertex;
  std::vector<Boundary_face> m_boundary;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_SPANNED_CAVITY_3_H

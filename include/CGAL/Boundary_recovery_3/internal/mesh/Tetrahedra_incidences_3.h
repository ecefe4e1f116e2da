// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_TETRAHEDRA_INCIDENCES_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_TETRAHEDRA_INCIDENCES_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Triangulation_utils_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Which tetrahedra of a mesh, given by arrays, are at a vertex, and which two are at a facet.
 *
 * A facet is named by the number of its side: 4 c + i is that at the tetrahedron c, opposite to its vertex i.
 */
class Tetrahedra_incidences_3
{
public:
  typedef std::array<std::size_t, 4> Tetrahedron;
  typedef std::array<std::size_t, 3> Facet;
  typedef std::pair<std::size_t, std::size_t> Side_pair;

  static constexpr std::size_t none = std::size_t(-1);

  // A part of an array.
  struct Range
  {
    const std::size_t* first;
    const std::size_t* last;

    const std::size_t* begin() const { return first; }
    const std::size_t* end() const { return last; }
    std::size_t size() const { return static_cast<std::size_t>(last - first); }
  };

  // The tetrahedra name vertices that exist, none of them twice. They have to outlive this object.
  Tetrahedra_incidences_3(const std::size_t number_of_vertices, const std::vector<Tetrahedron>& tetrahedra)
    : m_tetrahedra(tetrahedra)
  {
    collect_stars(number_of_vertices);
    match_facets();
  }

  // The tetrahedra at a vertex, in their order.
  Range cells(const std::size_t v) const
  {
    return Range{ m_star_cells.data() + m_star_begin[v], m_star_cells.data() + m_star_begin[v + 1] };
  }

  // Another side of the same facet; none on the boundary of the mesh.
  std::size_t opposite(const std::size_t side) const { return m_opposite[side]; }

  // The vertices of a facet; the tetrahedron of this side is on the positive side of it, unless it is inverted.
  Facet facet(const std::size_t side) const
  {
    const Tetrahedron& t = m_tetrahedra[side / 4];
    const int i = static_cast<int>(side % 4);
    return {{ t[Utils::vertex_triple_index(i, 0)], t[Utils::vertex_triple_index(i, 1)],
              t[Utils::vertex_triple_index(i, 2)] }};
  }

  bool has_vertex(const std::size_t cell, const std::size_t v) const
  {
    const Tetrahedron& t = m_tetrahedra[cell];
    return t[0] == v || t[1] == v || t[2] == v || t[3] == v;
  }

  // A side of the facet with these vertices, in any order, or none.
  std::size_t find(Facet vertices) const
  {
    std::sort(vertices.begin(), vertices.end(), [this](const std::size_t u, const std::size_t v)
    {
      return cells(u).size() < cells(v).size();
    });
    for(const std::size_t c : cells(vertices[0]))
      if(has_vertex(c, vertices[1]) && has_vertex(c, vertices[2]))
        return 4 * c + index_of_other_vertex(c, vertices);
    return none;
  }

  bool has_edge(const std::size_t u, const std::size_t v) const
  {
    const bool is_u_shorter = cells(u).size() < cells(v).size();
    const Range star = cells(is_u_shorter ? u : v);
    return std::any_of(star.begin(), star.end(),
                       [&](const std::size_t c) { return has_vertex(c, is_u_shorter ? v : u); });
  }

  // Facets that more than two tetrahedra have, each by two of its sides.
  const std::vector<Side_pair>& nonmanifold_facets() const { return m_nonmanifold; }

  // Facets that have two tetrahedra on the same side, by the order of their vertices.
  const std::vector<Side_pair>& inconsistent_facets() const { return m_inconsistent; }

private:
  typedef Triangulation_utils_3 Utils;

  // a facet without its smallest vertex
  struct Facet_at_vertex
  {
    std::size_t u, v;
    std::size_t twice_side; // plus 1 if u and v are in the order of `facet(side)`

    std::size_t side() const { return twice_side / 2; }
    bool is_positive() const { return twice_side % 2 == 1; }

    bool operator<(const Facet_at_vertex& f) const
    {
      return u != f.u ? u < f.u : v != f.v ? v < f.v : twice_side < f.twice_side;
    }

    bool is_same_facet(const Facet_at_vertex& f) const { return u == f.u && v == f.v; }
  };

  std::size_t index_of_other_vertex(const std::size_t cell, const Facet& facet) const
  {
    std::size_t i = 0;
    while(std::find(facet.begin(), facet.end(), m_tetrahedra[cell][i]) != facet.end())
      ++i;
    return i;
  }

  void collect_stars(const std::size_t number_of_vertices)
  {
    m_star_begin.assign(number_of_vertices + 2, 0);
    for(const Tetrahedron& t : m_tetrahedra)
      for(const std::size_t v : t)
        ++m_star_begin[v + 2];
    for(std::size_t v = 2; v < m_star_begin.size(); ++v)
      m_star_begin[v] += m_star_begin[v - 1];
    m_star_cells.resize(4 * m_tetrahedra.size());
    for(std::size_t c = 0; c < m_tetrahedra.size(); ++c)
      for(const std::size_t v : m_tetrahedra[c])
        m_star_cells[m_star_begin[v + 1]++] = c;
    m_star_begin.pop_back();
  }

  // Facets are sorted around their smallest vertices: there are few at each of them.
  void match_facets()
  {
    m_opposite.assign(4 * m_tetrahedra.size(), none);
    std::vector<Facet_at_vertex> facets;
    for(std::size_t v = 0; v + 1 < m_star_begin.size(); ++v)
    {
      collect_facets(v, facets);
      std::sort(facets.begin(), facets.end());
      for(std::size_t k = 0, next; k < facets.size(); k = next)
      {
        for(next = k + 1; next < facets.size() && facets[next].is_same_facet(facets[k]); )
          ++next;
        match(facets, k, next);
      }
    }
  }

  // Those that have no smaller vertex: at a cell with one smaller vertex, that opposite to it; with two, none.
  void collect_facets(const std::size_t v, std::vector<Facet_at_vertex>& facets) const
  {
    facets.clear();
    for(const std::size_t c : cells(v))
    {
      const Tetrahedron& t = m_tetrahedra[c];
      std::size_t number_of_smaller = 0, smaller = 0, own = 0;
      for(std::size_t i = 0; i < 4; ++i)
        if(t[i] < v)
        {
          ++number_of_smaller;
          smaller = i;
        }
        else if(t[i] == v)
          own = i;
      if(number_of_smaller == 1)
        facets.push_back(facet_at_vertex(c, smaller, own));
      else if(number_of_smaller == 0)
        for(std::size_t i = 0; i < 4; ++i)
          if(i != own)
            facets.push_back(facet_at_vertex(c, i, own));
    }
  }

  // That opposite to the vertex i of a cell, without its vertex `own`.
  Facet_at_vertex facet_at_vertex(const std::size_t cell, const std::size_t i, const std::size_t own) const
  {
    // the two vertices that follow `own` in the order of the facet
    static constexpr std::size_t others[4][4][2] = { { { 0, 0 }, { 3, 2 }, { 1, 3 }, { 2, 1 } },
                                                     { { 2, 3 }, { 0, 0 }, { 3, 0 }, { 0, 2 } },
                                                     { { 3, 1 }, { 0, 3 }, { 0, 0 }, { 1, 0 } },
                                                     { { 1, 2 }, { 2, 0 }, { 0, 1 }, { 0, 0 } } };
    const Tetrahedron& t = m_tetrahedra[cell];
    const std::size_t p = t[others[i][own][0]], q = t[others[i][own][1]];
    return { (std::min)(p, q), (std::max)(p, q), 2 * (4 * cell + i) + (p < q ? 1 : 0) };
  }

  void match(const std::vector<Facet_at_vertex>& facets, const std::size_t first, const std::size_t last)
  {
    if(last - first == 1)
      return;
    const Facet_at_vertex& f = facets[first];
    const Facet_at_vertex& g = facets[first + 1];
    if(last - first > 2)
      m_nonmanifold.emplace_back(f.side(), g.side());
    else if(f.is_positive() == g.is_positive())
      m_inconsistent.emplace_back(f.side(), g.side());
    for(std::size_t k = first; k < last; ++k)
      m_opposite[facets[k].side()] = k == first ? g.side() : f.side();
  }

  const std::vector<Tetrahedron>& m_tetrahedra;
  std::vector<std::size_t> m_star_begin; // of each vertex, in the following list
  std::vector<std::size_t> m_star_cells;
  std::vector<std::size_t> m_opposite;
  std::vector<Side_pair> m_nonmanifold;
  std::vector<Side_pair> m_inconsistent;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_TETRAHEDRA_INCIDENCES_3_H

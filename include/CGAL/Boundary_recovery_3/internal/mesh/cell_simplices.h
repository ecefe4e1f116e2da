// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_CELL_SIMPLICES_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_CELL_SIMPLICES_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <CGAL/Triangulation_utils_3.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

// The vertices of the facet opposite to the vertex i of a cell, which is on the positive side of it.
template <typename Cell_handle>
auto facet_vertices(const Cell_handle c, const int i)
{
  typedef Triangulation_utils_3 Utils;
  return std::array<decltype(c->vertex(0)), 3>{{ c->vertex(Utils::vertex_triple_index(i, 0)),
                                                 c->vertex(Utils::vertex_triple_index(i, 1)),
                                                 c->vertex(Utils::vertex_triple_index(i, 2)) }};
}

// Of the triangulation. Its own function goes through all cells, but only those around one vertex are infinite.
template <typename Tr>
std::size_t number_of_finite_cells(const Tr& tr)
{
  if(tr.dimension() < 3)
    return 0;
  std::size_t number_of_infinite_cells = 0;
  tr.tds().incident_cells(tr.infinite_vertex(), boost::make_function_output_iterator(
    [&number_of_infinite_cells](const typename Tr::Cell_handle) { ++number_of_infinite_cells; }));
  return tr.number_of_cells() - number_of_infinite_cells;
}

// Whether all vertices of the simplex are vertices of the cell.
template <typename Cell_handle, typename Vertex_handle, std::size_t N>
bool has_vertices(const Cell_handle c, const std::array<Vertex_handle, N>& simplex)
{
  std::size_t i = 0;
  while(i < N && c->has_vertex(simplex[i]))
    ++i;
  return i == N;
}

// The index of the vertex of a cell that is opposite to a facet of it, which is given by its vertices.
template <typename Cell_handle, typename VertexRange>
int index_of_opposite_vertex(const Cell_handle c, const VertexRange& facet)
{
  int i = 0;
  while(internal::contains(facet, c->vertex(i)))
    ++i;
  return i;
}

// The vertices of some cells, in the order in which they are met, without v.
template <typename CellRange, typename Vertex_handle>
std::vector<Vertex_handle> vertices_without(const CellRange& cells, const Vertex_handle v)
{
  Simplex_index_3<Vertex_handle, 1> known;
  std::vector<Vertex_handle> result;
  for(const auto c : cells)
    for(int i = 0; i < 4; ++i)
      if(c->vertex(i) != v && known.insert({{ c->vertex(i) }}).second)
        result.push_back(c->vertex(i));
  return result;
}

// For each facet of some cells that has none of them behind it, calls `work` with the cell and the index of the facet.
template <typename CellRange, typename Work>
void for_each_outer_facet(const CellRange& cells, const Work& work)
{
  typedef std::decay_t<decltype(*std::begin(cells))> Cell_handle;
  Simplex_index_3<Cell_handle, 1> inner;
  for(const Cell_handle c : cells)
    inner.insert({{ c }});
  for(const Cell_handle c : cells)
    for(int i = 0; i < 4; ++i)
      if(inner[{{ c->neighbor(i) }}] == inner.none)
        work(c, i);
}

// Collects the cells around v. Returns whether all of them are finite.
template <typename Tr>
bool collect_star(const Tr& tr, const typename Tr::Vertex_handle v, std::vector<typename Tr::Cell_handle>& star)
{
  star.clear();
  tr.incident_cells(v, std::back_inserter(star));
  return std::none_of(star.begin(), star.end(), [&](const typename Tr::Cell_handle c) { return tr.is_infinite(c); });
}

// The faces of the star of v, that is, of the cells around v, seen from inside.
template <typename Cell_handle, typename Vertex_handle>
std::vector<std::array<Vertex_handle, 3> > faces_of_star(const std::vector<Cell_handle>& star, const Vertex_handle v)
{
  std::vector<std::array<Vertex_handle, 3> > faces;
  for(const Cell_handle c : star)
    faces.push_back(internal::facet_vertices(c, c->index(v)));
  return faces;
}

// The vertices of a cell, with x in the place of v.
template <typename Cell_handle, typename Vertex_handle>
std::array<Vertex_handle, 4> with_exchanged_vertex(const Cell_handle c, const Vertex_handle v, const Vertex_handle x)
{
  std::array<Vertex_handle, 4> result;
  for(int i = 0; i < 4; ++i)
    result[i] = c->vertex(i) == v ? x : c->vertex(i);
  return result;
}

/*
 * A walk from cell to cell around an edge, in one of both directions.
 */
template <typename Tr>
class Edge_walk_3
{
public:
  typedef typename Tr::Vertex_handle Vertex_handle;
  typedef typename Tr::Cell_handle   Cell_handle;
  typedef typename Tr::Facet         Facet;

  // Of the vertices of the cell that are not on the edge, `across` is the one opposite to the facet that is crossed
  // first, and `kept` the other one.
  Edge_walk_3(const Cell_handle cell, const int across, const int kept)
    : m_cell(cell), m_across(across), m_kept(cell->vertex(kept))
  { }

  Cell_handle cell() const { return m_cell; }

  // The next facet, opposite to a vertex of the cell that is not on the edge.
  int next_facet() const { return m_across; }

  // The vertex of the next facet that is not on the edge.
  Vertex_handle apex() const { return m_kept; }

  void operator++()
  {
    const Cell_handle next = m_cell->neighbor(m_across);
    const Vertex_handle entered = next->vertex(next->index(m_cell));
    m_across = next->index(m_kept);
    m_kept = entered;
    m_cell = next;
  }

private:
  Cell_handle m_cell;
  int m_across;
  Vertex_handle m_kept;
};

// Reaches cells from a seed over facets: `is_open` tells for a cell that was reached and the index of a facet whether
// to look behind it. `add` is called with the seed and with each cell that is found, maybe several times; it has to
// return whether the cell is new, and to remember it then. The order depends on the cells' neighbors only.
template <typename Cell_handle, typename Is_open, typename Add>
void flood_fill(const Cell_handle seed, const Is_open& is_open, const Add& add)
{
  std::vector<Cell_handle> front;
  const auto reach = [&](const Cell_handle c)
  {
    if(add(c))
      front.push_back(c);
  };
  reach(seed);
  while(! front.empty())
  {
    const Cell_handle c = front.back();
    front.pop_back();
    for(int i = 0; i < 4; ++i)
      if(is_open(c, i))
        reach(c->neighbor(i));
  }
}

/*
 * Calls `found(index, cell, i)` for each facet of these cells that is in a table of facets, by `table.look_up()`, if
 * the cell behind it is one of them, too. What the filter is sure of is not looked up, and the others are some at a
 * time. Which of its two cells a facet is found at depends on addresses; what is found does not.
 */
template <typename CellRange, typename Vertex_handle, typename Table, typename Found>
void find_facets(const CellRange& cells, const Facet_filter_3<Vertex_handle>& filter, const Table& table,
                 const Found& found)
{
  constexpr std::size_t number_at_a_time = 1024; // so that waits for memory overlap
  typedef std::decay_t<decltype(*std::begin(cells))> Cell_handle;
  std::vector<std::pair<Cell_handle, int> > facets;
  std::vector<std::array<Vertex_handle, 3> > triples;
  std::vector<std::size_t> indices;
  const auto look_up = [&]
  {
    table.look_up(triples, indices);
    for(std::size_t k = 0; k < indices.size(); ++k)
      if(indices[k] != std::size_t(-1))
        found(indices[k], facets[k].first, facets[k].second);
    facets.clear();
    triples.clear();
  };
  for(const Cell_handle c : cells)
  {
    unsigned bits = filter.candidates_from_below(c);
    for(int i = 0; bits != 0; bits >>= 1, ++i)
      if((bits & 1) != 0)
      {
        facets.emplace_back(c, i);
        triples.push_back(internal::facet_vertices(c, i));
      }
    if(facets.size() >= number_at_a_time)
      look_up();
  }
  look_up();
}

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_CELL_SIMPLICES_H

// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_REPLACE_CELLS_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_REPLACE_CELLS_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <CGAL/assertions.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Glues the cells that fill a polyhedron to the cells around it and to each other, by means of a hash table of the
 * facets that were met once: for large polyhedra, and for those whose old cells go before new ones come.
 *
 * All the memory is allocated by the constructor.
 */
template <typename Tr>
class Open_facets_3
{
public:
  typedef typename Tr::Vertex_handle    Vertex_handle;
  typedef typename Tr::Cell_handle      Cell_handle;

  // So many cells are going to fill the place of the old ones, which are still there.
  template <typename CellRange>
  Open_facets_3(const CellRange& old_cells, const std::size_t number_of_new_cells)
  {
    internal::for_each_outer_facet(old_cells, [this](const Cell_handle c, const int i)
    {
      const Cell_handle n = c->neighbor(i);
      m_facets.push_back(Facet{ n, n->index(c) });
    });
    // each inner facet is one of two new cells
    const std::size_t n = m_facets.size() + 2 * number_of_new_cells;
    m_facets.reserve(n);
    m_index.reserve(n);
    for(const Facet& f : m_facets)
      m_index.insert(internal::facet_vertices(f.cell, f.index));
  }

  // Makes the facet i of the new cell c adjacent to that with the same vertices, or opens it.
  void glue(Tr& tr, const Cell_handle c, const int i)
  {
    const auto inserted = m_index.insert(internal::facet_vertices(c, i));
    if(inserted.second)
      m_facets.push_back(Facet{ c, i });
    else
    {
      const Facet& f = m_facets[inserted.first];
      tr.tds().set_adjacency(c, i, f.cell, f.index);
      ++m_number_of_adjacencies;
    }
  }

  // Whether no facet is open.
  bool empty() const { return m_number_of_adjacencies == m_facets.size(); }

private:
  struct Facet
  {
    Cell_handle cell;
    int index;
  };

  Simplex_index_3<Vertex_handle, 3> m_index;
  std::vector<Facet> m_facets; // by these numbers
  std::size_t m_number_of_adjacencies = 0;
};

/*
 * Vertices that are created before the cells that are going to have them. Those without a cell go with this object: so
 * none is left where memory is lacking, or a visitor throws.
 */
template <typename Tr>
class New_vertices_3
{
public:
  typedef typename Tr::Vertex_handle    Vertex_handle;
  typedef typename Tr::Cell_handle      Cell_handle;

  explicit New_vertices_3(Tr& tr) : m_tr(tr) { }

  New_vertices_3(const New_vertices_3&) = delete;
  New_vertices_3& operator=(const New_vertices_3&) = delete;

  ~New_vertices_3()
  {
    for(const Vertex_handle v : m_vertices)
      if(v != Vertex_handle() && v->cell() == Cell_handle())
        m_tr.tds().delete_vertex(v);
  }

  Vertex_handle create(const typename Tr::Point& p)
  {
    m_vertices.emplace_back();
    m_vertices.back() = m_tr.tds().create_vertex();
    m_vertices.back()->set_point(p);
    return m_vertices.back();
  }

  // Whether they have cells or not, they stay.
  void keep() { m_vertices.clear(); }

private:
  Tr& m_tr;
  std::vector<Vertex_handle> m_vertices;
};

/*
 * Exchanges a set of cells for another one that fills the same polyhedron.
 *
 * Combinatorial only: the caller knows that the new cells, given by four vertices each, are positively oriented
 * (infinite cells: consistently so), and that their outer facets are those of the old cells.
 *
 * If memory is lacking, the triangulation stays as it is: new cells are glued only when all of them are there.
 */
template <typename Tr>
class Replace_cells
{
public:
  typedef typename Tr::Vertex_handle    Vertex_handle;
  typedef typename Tr::Cell_handle      Cell_handle;
  typedef std::array<Vertex_handle, 4>  Tetrahedron;
  typedef boost::container::small_vector<Cell_handle, 32> Cells;

  // The new cells of the last replacement, in the order in which they were given.
  const Cells& new_cells() const { return m_new_cells; }

  // As below, and tells a visitor which cells go and come. The vertices in `dropped` go with the old cells.
  template <typename CellRange, typename TetrahedronRange, typename Visitor,
            typename VertexRange = std::array<Vertex_handle, 0> >
  void operator()(Tr& tr, const CellRange& old_cells, const TetrahedronRange& tetrahedra, Visitor& visitor,
                  const VertexRange& dropped = VertexRange())
  {
    visitor.before_cells_removal(old_cells);
    (*this)(tr, old_cells, tetrahedra);
    for(const Vertex_handle v : dropped)
      tr.tds().delete_vertex(v);
    visitor.after_cells_creation(m_new_cells);
  }

  template <typename CellRange, typename TetrahedronRange>
  const Cells& operator()(Tr& tr, const CellRange& old_cells, const TetrahedronRange& tetrahedra)
  {
    if((std::max)(old_cells.size(), tetrahedra.size()) > max_number_for_lists)
    {
      Open_facets_3<Tr> open_facets(old_cells, tetrahedra.size());
      replace(tr, old_cells, tetrahedra, [&](const Cell_handle c, const int i) { open_facets.glue(tr, c, i); });
      CGAL_postcondition(open_facets.empty());
    }
    else
    {
      open_outer_facets(old_cells, tetrahedra.size());
      replace(tr, old_cells, tetrahedra, [&](const Cell_handle c, const int i) { this->glue(tr, c, i); });
      CGAL_postcondition(m_open_facets.empty());
    }
    return m_new_cells;
  }

private:
  struct Open_facet
  {
    Open_facet(const std::array<Vertex_handle, 3>& vertices, const Cell_handle cell, const int index)
      : hash(Simplex_hash()(vertices)), vertices(vertices), cell(cell), index(index)
    { }

    bool has_vertices_of(const Open_facet& other) const
    {
      return hash == other.hash && internal::is_permutation(vertices, other.vertices);
    }

    std::uint64_t hash; // tells most facets apart
    std::array<Vertex_handle, 3> vertices;
    Cell_handle cell;
    int index;
  };

  // With so many cells, lists are faster than hash tables.
  static constexpr std::size_t max_number_for_lists = 64;

  template <typename CellRange, typename TetrahedronRange, typename Glue>
  void replace(Tr& tr, const CellRange& old_cells, const TetrahedronRange& tetrahedra, const Glue& glue_facet)
  {
    create_cells(tr, tetrahedra);
    auto c = m_new_cells.begin();
    for(const Tetrahedron& t : tetrahedra)
    {
      for(int i = 0; i < 4; ++i)
      {
        t[i]->set_cell(*c);
        glue_facet(*c, i);
      }
      ++c;
    }
    for(const Cell_handle old : old_cells)
      tr.tds().delete_cell(old);
  }

  // All of them, or none.
  template <typename TetrahedronRange>
  void create_cells(Tr& tr, const TetrahedronRange& tetrahedra)
  {
    m_new_cells.clear();
    m_new_cells.reserve(tetrahedra.size());
    try {
      for(const Tetrahedron& t : tetrahedra)
        m_new_cells.push_back(tr.tds().create_cell(t[0], t[1], t[2], t[3]));
    } catch(...) {
      for(const Cell_handle c : m_new_cells)
        tr.tds().delete_cell(c);
      throw;
    }
  }

  // The facets of the cells around the polyhedron, seen from outside. There will be room for the inner facets, too:
  // each is one of two new cells.
  template <typename CellRange>
  void open_outer_facets(const CellRange& old_cells, const std::size_t number_of_new_cells)
  {
    m_open_facets.clear();
    for(const Cell_handle c : old_cells)
      for(int i = 0; i < 4; ++i)
      {
        const Cell_handle n = c->neighbor(i);
        if(! internal::contains(old_cells, n))
          m_open_facets.emplace_back(internal::facet_vertices(c, i), n, n->index(c));
      }
    m_open_facets.reserve(m_open_facets.size() + 2 * number_of_new_cells);
  }

  // Makes the facet i of c adjacent to the open facet with the same vertices, or opens it.
  // The list is short (a shell has 2m outer facets), so a search from its end beats any table.
  void glue(Tr& tr, const Cell_handle c, const int i)
  {
    const Open_facet facet(internal::facet_vertices(c, i), c, i);
    for(std::size_t k = m_open_facets.size(); k-- > 0; )
      if(m_open_facets[k].has_vertices_of(facet))
      {
        tr.tds().set_adjacency(c, i, m_open_facets[k].cell, m_open_facets[k].index);
        m_open_facets[k] = m_open_facets.back();
        m_open_facets.pop_back();
        return;
      }
    m_open_facets.push_back(facet);
  }

  boost::container::small_vector<Open_facet, 64> m_open_facets;
  Cells m_new_cells;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_REPLACE_CELLS_H

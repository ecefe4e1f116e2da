// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHELL_FAILED_EDGE_REMOVALS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHELL_FAILED_EDGE_REMOVALS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Shell_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * The removals by recursive shell transformations that failed. Lost constraints beside each other, and the branches of
 * one recursion, ask for the same removals again: half of all the shells would be visited in removals that failed at
 * the same shell before, and one in two hundred of these would succeed then, where something changed farther away, or
 * something else is allowed.
 *
 * Of an edge, the last failure is known. The shell is told by a digest of the vertices of its skirt polygon, so it does
 * not matter who changes the mesh in between. It has 64 bits: that two polygons of an edge have the same one does not
 * happen, and would leave out one removal.
 */
template <typename Tr>
class Failed_edge_removals_3
{
public:
  typedef typename Tr::Vertex_handle  Vertex_handle;
  typedef Shell_3<Tr>                 Shell;

  // A removal of the supporting edge of a shell, or of its face with a vertex, if there is one.
  struct Removal
  {
    std::size_t edge;
    std::uint64_t skirt_polygon;
    Vertex_handle vertex_of_face;
  };

  Removal removal(const Shell& shell, const Vertex_handle vertex_of_face)
  {
    std::uint64_t sum = 0;
    for(int i = 0; i < shell.degree(); ++i)
      sum += internal::hash_share(shell.vertex(i));
    const auto inserted = m_edges.insert({{ shell.a(), shell.b() }});
    if(inserted.second)
      m_failures.emplace_back();
    return { inserted.first, sum, vertex_of_face };
  }

  // Whether it failed with at least so many levels of recursion. If so, sets whether more levels might have helped.
  bool contains(const Removal& removal, const int number_of_levels, bool& was_cut_off) const
  {
    const Failure& f = m_failures[removal.edge];
    if(f.skirt_polygon != removal.skirt_polygon || f.vertex_of_face != removal.vertex_of_face
       || (f.was_cut_off && f.number_of_levels < number_of_levels))
      return false;
    was_cut_off = f.was_cut_off;
    return true;
  }

  void insert(const Removal& removal, const int number_of_levels, const bool was_cut_off)
  {
    m_failures[removal.edge] = { removal.skirt_polygon, removal.vertex_of_face, number_of_levels, was_cut_off };
  }

private:
  struct Failure
  {
    std::uint64_t skirt_polygon = 0;
    Vertex_handle vertex_of_face;
    int number_of_levels = -1; // any number may help: none is known yet
    bool was_cut_off = true;
  };

  Simplex_index_3<Vertex_handle, 2> m_edges;
  std::vector<Failure> m_failures; // by number of edge
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHELL_FAILED_EDGE_REMOVALS_3_H

// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_CONVERT_TO_REMESHING_TRIANGULATION_H
#define CGAL_BOUNDARY_RECOVERY_3_CONVERT_TO_REMESHING_TRIANGULATION_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Constrained_edge_map_3.h>

#include <CGAL/Cartesian_converter.h>
#include <CGAL/Unique_hash_map.h>
#include <CGAL/assertions.h>

#include <array>
#include <type_traits>
#include <vector>

namespace CGAL::Boundary_recovery_3 {
namespace internal {

/*
 * Copies a triangulation into one with other vertices, cells, and maybe another kernel, with the indices that both
 * have. `copy_tds()` would give cells of CGAL 5.5 time stamps that nobody has set.
 */
template <typename Source, typename Target>
class Copy_mesh_3
{
public:
  typedef typename Target::Vertex_handle Vertex_handle;

  Copy_mesh_3(const Source& source, Target& target)
    : m_source(source), m_target(target), m_vertex(Vertex_handle(), source.number_of_vertices()),
      m_cell(Cell_handle(), source.tds().number_of_cells())
  {
    target.tds().clear();
    target.tds().set_dimension(source.dimension());
    for(const Source_vertex_handle v : source.all_vertex_handles())
      copy_vertex(v);
    target.set_infinite_vertex(m_vertex[source.infinite_vertex()]);
    for(const Source_cell_handle c : source.all_cell_handles())
      copy_cell(c);
    for(const Source_vertex_handle v : source.all_vertex_handles())
      m_vertex[v]->set_cell(m_cell[v->cell()]);
    for(const Source_cell_handle c : source.all_cell_handles())
      for(int i = 0; i < 4; ++i)
        m_cell[c]->set_neighbor(i, m_cell[c->neighbor(i)]);
  }

  // The copy of a vertex.
  Vertex_handle operator[](const typename Source::Vertex_handle v) const { return m_vertex[v]; }

private:
  typedef typename Source::Vertex_handle  Source_vertex_handle;
  typedef typename Source::Cell_handle    Source_cell_handle;
  typedef typename Target::Cell_handle    Cell_handle;
  typedef typename Source::Geom_traits    Source_traits;
  typedef typename Target::Geom_traits    Target_traits;

  void copy_vertex(const Source_vertex_handle v)
  {
    const Vertex_handle w = m_target.tds().create_vertex();
    m_vertex[v] = w;
    if(v == m_source.infinite_vertex())
      return;
    if constexpr(std::is_same<typename Source_traits::Point_3, typename Target_traits::Point_3>::value)
      w->set_point(v->point());
    else
      w->set_point(Cartesian_converter<Source_traits, Target_traits>()(v->point()));
    w->set_dimension(v->in_dimension());
    w->set_index(v->index());
  }

  void copy_cell(const Source_cell_handle c)
  {
    const Cell_handle d = m_target.tds().create_cell(m_vertex[c->vertex(0)], m_vertex[c->vertex(1)],
                                                     m_vertex[c->vertex(2)], m_vertex[c->vertex(3)]);
    m_cell[c] = d;
    d->set_subdomain_index(c->subdomain_index());
    for(int i = 0; i < 4; ++i)
      d->set_surface_patch_index(i, c->surface_patch_index(i));
  }

  const Source& m_source;
  Target& m_target;
  Unique_hash_map<Source_vertex_handle, Vertex_handle> m_vertex; // for looking up only
  Unique_hash_map<Source_cell_handle, Cell_handle> m_cell;       // the same
};

} // namespace internal

/*!
 * \ingroup PkgBoundaryRecovery3Functions
 *
 * \brief copies a mesh, with all indices, into a triangulation of the type of CGAL's tetrahedral remeshing.
 *
 * \code
 * CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<Kernel> remeshing_tr;
 * const auto edges =
 *   CGAL::Boundary_recovery_3::convert_to_remeshing_triangulation(tr, remeshing_tr, result.constrained_edges);
 * CGAL::tetrahedral_isotropic_remeshing(
 *   remeshing_tr, size, CGAL::parameters::remesh_boundaries(false).edge_is_constrained_map(edges));
 * \endcode
 *
 * The remeshing, complexes and writers of files also accept a triangulation of the type
 * `Boundary_constrained_mesh_triangulation_3::type` as it is. But then the result of the remeshing depends on addresses
 * in memory, and changes from run to run, since vertices and cells of this type have no time stamps.
 *
 * \tparam Source an instance of `CGAL::Triangulation_3`, or of a class derived from it, whose vertices and cells are
 *         models of `MeshVertexBase_3` and `MeshCellBase_3`
 * \tparam Target the same, such as `Tetrahedral_remeshing::Remeshing_triangulation_3`. The kernel may be a different
 *         one: the remeshing does not compile with exact constructions, so a triangulation with exact constructions is
 *         copied to one over `Exact_predicates_inexact_constructions_kernel`. Coordinates are then rounded, and
 *         `target.is_valid()` tells whether all cells kept their orientation.
 * \tparam EdgeRange a model of `ConstRange` whose value type is an array of two vertex handles of `Source`
 *
 * \param source the triangulation, marked by `mark_domain()`
 * \param target the copy, with vertices and cells in the same order. The previous contents are lost.
 * \param constrained_edges the edges to keep in addition to the edges of facets on the surface, such as
 *        `Boundary_constrained_mesh_result_3::constrained_edges`
 *
 * \return the copies of these edges, for the named parameter `edge_is_constrained_map`
 *
 * \pre The dimension of `source` is 3.
 */
template <typename Source, typename Target,
          typename EdgeRange = std::vector<std::array<typename Source::Vertex_handle, 2> > >
Constrained_edge_map_3<Target>
convert_to_remeshing_triangulation(const Source& source, Target& target,
                                   const EdgeRange& constrained_edges = EdgeRange())
{
  CGAL_precondition(source.dimension() == 3);
  const internal::Copy_mesh_3<Source, Target> copy(source, target);
  std::vector<std::array<typename Target::Vertex_handle, 2> > edges;
  for(const auto& e : constrained_edges)
    edges.push_back({{ copy[e[0]], copy[e[1]] }});
  return Constrained_edge_map_3<Target>(edges);
}

} // namespace CGAL::Boundary_recovery_3

#endif // CGAL_BOUNDARY_RECOVERY_3_CONVERT_TO_REMESHING_TRIANGULATION_H

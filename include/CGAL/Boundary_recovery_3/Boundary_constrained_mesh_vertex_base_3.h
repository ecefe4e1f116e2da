// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_BOUNDARY_CONSTRAINED_MESH_VERTEX_BASE_3_H
#define CGAL_BOUNDARY_RECOVERY_3_BOUNDARY_CONSTRAINED_MESH_VERTEX_BASE_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Triangulation_vertex_base_3.h>

namespace CGAL {
namespace Boundary_recovery_3 {

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief a vertex base with what CGAL's mesh packages want to know of a vertex, and nothing else.
 *
 * The members have the names, and the meaning, that they have in `MeshVertexBase_3`, so that the same code takes
 * vertices of triangulations over CGAL's own bases. A vertex has 56 bytes over
 * `Exact_predicates_inexact_constructions_kernel`, without threads.
 *
 * \tparam GT the geometric traits
 * \tparam Vb the vertex base that it is derived from
 *
 * \cgalModels{TriangulationVertexBase_3}
 */
template <typename GT, typename Vb = Triangulation_vertex_base_3<GT> >
class Boundary_constrained_mesh_vertex_base_3
  : public Vb
{
public:
  typedef typename GT::FT FT; ///< the number type of sizes
  typedef int Index;          ///< the type of the index

  /// rebinds it to a triangulation data structure.
  template <typename TDS>
  struct Rebind_TDS
  {
    /// the rebound type
    typedef Boundary_constrained_mesh_vertex_base_3<GT, typename Vb::template Rebind_TDS<TDS>::Other> Other;
  };

  using Vb::Vb;

  /// returns the dimension of what the vertex is on: 0: a corner, 1: a constrained edge that is no edge of a triangle,
  /// 2: the surface, 3: the domain or what is outside of it, -1: not known.
  int in_dimension() const { return m_dimension; }

  /// sets the dimension.
  void set_dimension(const int dimension) { m_dimension = dimension; }

  /// returns the number of the region, patch, edge or corner, according to the dimension.
  Index index() const { return m_index; }

  /// sets that number.
  void set_index(const Index index) { m_index = index; }

  /// returns the size that cells should have here; 0: not known.
  FT meshing_info() const { return m_size; }

  /// sets the size.
  void set_meshing_info(const FT& size) { m_size = size; }

private:
  FT m_size = FT(0);
  Index m_index = 0;
  int m_dimension = -1;
};

} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_BOUNDARY_CONSTRAINED_MESH_VERTEX_BASE_3_H

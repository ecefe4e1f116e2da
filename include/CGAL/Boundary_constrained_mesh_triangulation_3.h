// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_CONSTRAINED_MESH_TRIANGULATION_3_H
#define CGAL_BOUNDARY_CONSTRAINED_MESH_TRIANGULATION_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Triangulation_cell_base_3.h>
#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/Triangulation_vertex_base_3.h>
#include <CGAL/tags.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace CGAL {
namespace Boundary_recovery_3 {

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief a vertex base with the dimension, the index and the size that CGAL's mesh packages read from vertices.
 *
 * The members have the names and the meaning of the members of `MeshVertexBase_3`, so that the same code works with
 * CGAL's own vertex bases. A vertex has 56 bytes over `Exact_predicates_inexact_constructions_kernel`, without threads.
 *
 * \tparam GT the geometric traits
 * \tparam Vb the base class, a vertex base
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

  /// returns the dimension of the place of the vertex: 0: a corner, 1: a constrained edge that is no edge of a
  /// triangle, 2: the surface, 3: the inside or outside of the domain, -1: not known.
  int in_dimension() const { return m_dimension; }

  /// sets the dimension.
  void set_dimension(const int dimension) { m_dimension = static_cast<signed char>(dimension); }

  /// returns the number of the region, patch, edge or corner, according to the dimension.
  Index index() const { return m_index; }

  /// sets that number.
  void set_index(const Index index) { m_index = index; }

  /// returns the size asked for at the vertex; 0: not known.
  FT meshing_info() const { return m_size; }

  /// sets the size.
  void set_meshing_info(const FT& size) { m_size = size; }

  /// returns the number of the part of the mesh that owns the vertex while several threads change the mesh; 0: none.
  std::uint16_t part() const { return m_part; }

  /// sets that number.
  void set_part(const std::uint16_t part) { m_part = part; }

  /// \name Facets of a Complex
  /// `Mesh_complex_3_in_triangulation_3` remembers here two numbers of the facets of the complex around the vertex.
  /// @{

  /// returns whether the two numbers are known.
  bool is_c2t3_cache_valid() const { return m_is_complex_known; }

  /// forgets these numbers.
  void invalidate_c2t3_cache() { m_is_complex_known = false; }

  /// sets these numbers.
  void set_c2t3_cache(const std::size_t number_of_facets, const std::size_t number_of_components)
  {
    m_number_of_facets = static_cast<std::uint32_t>(number_of_facets);
    m_number_of_components = static_cast<std::uint32_t>(number_of_components);
    m_is_complex_known = true;
  }

  /// returns how many facets of the complex have this vertex.
  std::size_t cached_number_of_incident_facets() const { return m_number_of_facets; }

  /// returns the number of components of these facets, where common edges at this vertex connect facets.
  std::size_t cached_number_of_components() const { return m_number_of_components; }

  /// @}

private:
  FT m_size = FT(0);
  Index m_index = 0;
  std::uint32_t m_number_of_facets = 0;
  std::uint32_t m_number_of_components = 0;
  signed char m_dimension = -1;
  bool m_is_complex_known = false;
  std::uint16_t m_part = 0;
};

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief a cell base with the region of the cell and the patches of its facets, which CGAL's mesh packages read from
 * cells.
 *
 * The members have the names and the meaning of the members of `MeshCellBase_3`, so that the same code works with
 * CGAL's own cell bases. A cell has 88 bytes over `Exact_predicates_inexact_constructions_kernel`, without threads.
 *
 * \tparam GT the geometric traits
 * \tparam Cb the base class, a cell base
 *
 * \cgalModels{TriangulationCellBase_3}
 */
template <typename GT, typename Cb = Triangulation_cell_base_3<GT> >
class Boundary_constrained_mesh_cell_base_3
  : public Cb
{
public:
  typedef typename GT::FT FT;      ///< the number type of qualities
  typedef int Subdomain_index;     ///< the type of the number of a region
  typedef int Surface_patch_index; ///< the type of the number of a patch

  /// rebinds it to a triangulation data structure.
  template <typename TDS>
  struct Rebind_TDS
  {
    /// the rebound type
    typedef Boundary_constrained_mesh_cell_base_3<GT, typename Cb::template Rebind_TDS<TDS>::Other> Other;
  };

  using Cb::Cb;

  /// returns the region of the cell; 0: outside.
  Subdomain_index subdomain_index() const { return m_subdomain; }

  /// sets the region.
  void set_subdomain_index(const Subdomain_index index) { m_subdomain = index; }

  /// returns the patch of the facet opposite to the vertex `i`; 0: none.
  Surface_patch_index surface_patch_index(const int i) const { return m_patches[i]; }

  /// sets the patch of the facet opposite to the vertex `i`.
  void set_surface_patch_index(const int i, const Surface_patch_index index) { m_patches[i] = index; }

  /// returns whether the facet opposite to the vertex `i` is on the surface.
  bool is_facet_on_surface(const int i) const { return m_patches[i] != 0; }

  /// \name Qualities
  /// CGAL's remeshing remembers the quality of cells if it can. Here it cannot, and computes the quality again.
  /// @{

  /// returns `false`.
  bool is_cache_valid() const { return false; }

  /// returns 0.
  FT sliver_value() const { return FT(0); }

  /// does nothing.
  void set_sliver_value(const FT& /* quality */) { }

  /// does nothing.
  void reset_cache_validity() const { }

  /// @}

private:
  Subdomain_index m_subdomain = 0;
  std::array<Surface_patch_index, 4> m_patches = {{ 0, 0, 0, 0 }};
};

namespace internal {

// Several threads work on parts of such a triangulation by default. All that CGAL itself does with it is sequential.
struct Parts_tag
  : public Sequential_tag
{ };

} // namespace internal

} // namespace Boundary_recovery_3

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief provides the best triangulation type for `make_boundary_constrained_mesh_3()`.
 *
 * \tparam Kernel a model of `BoundaryRecoveryTraits_3`
 * \tparam ConcurrencyTag `Sequential_tag`, or `Parallel_tag` for as many threads as there are, unless the parameter
 *         `number_of_threads` of `make_boundary_constrained_mesh_3()` tells another number. The containers of both
 *         types are sequential ones, so the mesh does not depend on threads.
 */
template <typename Kernel, typename ConcurrencyTag = Sequential_tag>
struct Boundary_constrained_mesh_triangulation_3
{
private:
  typedef Boundary_recovery_3::Boundary_constrained_mesh_vertex_base_3<Kernel> Vb;
  typedef Boundary_recovery_3::Boundary_constrained_mesh_cell_base_3<Kernel>   Cb;
  typedef std::conditional_t<std::is_same<ConcurrencyTag, Parallel_tag>::value,
                             Boundary_recovery_3::internal::Parts_tag, ConcurrencyTag> Tag;

public:
  /// a Delaunay triangulation whose vertices and cells carry the indices of CGAL's mesh packages
  typedef Delaunay_triangulation_3<Kernel, Triangulation_data_structure_3<Vb, Cb, Tag> > type;
};

} // namespace CGAL

#endif // CGAL_BOUNDARY_CONSTRAINED_MESH_TRIANGULATION_3_H

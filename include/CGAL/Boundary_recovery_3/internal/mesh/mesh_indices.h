// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_MESH_INDICES_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_MESH_INDICES_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/number_utils.h>

#include <array>
#include <type_traits>
#include <utility>

namespace CGAL::Boundary_recovery_3::internal {

// Whether cells carry the indices of CGAL's mesh cells: a region, and a mark on each facet.
template <typename Cell, typename = void>
struct Has_cell_indices : std::false_type { };

template <typename Cell>
struct Has_cell_indices<Cell, std::void_t<decltype(std::declval<Cell&>().set_subdomain_index(
                                                     std::declval<const Cell&>().subdomain_index())),
                                          decltype(std::declval<Cell&>().set_surface_patch_index(
                                                     0, std::declval<const Cell&>().surface_patch_index(0)))> >
  : std::true_type
{ };

// Whether vertices carry those of CGAL's mesh vertices: the dimension of what they are on, and its index.
template <typename Vertex, typename = void>
struct Has_vertex_indices : std::false_type { };

template <typename Vertex>
struct Has_vertex_indices<Vertex, std::void_t<decltype(std::declval<Vertex&>().set_dimension(
                                                         std::declval<const Vertex&>().in_dimension())),
                                              decltype(std::declval<Vertex&>().set_index(
                                                         std::declval<const Vertex&>().index()))> >
  : std::true_type
{ };

// Whether vertices have a place for a size, as those of CGAL's Mesh_3.
template <typename Vertex, typename = void>
struct Has_meshing_info : std::false_type { };

template <typename Vertex>
struct Has_meshing_info<Vertex, std::void_t<decltype(std::declval<Vertex&>().set_meshing_info(
                                                       std::declval<const Vertex&>().meshing_info()))> >
  : std::true_type
{ };

// To be made in functions that write them.
template <typename Tr>
struct Require_mesh_indices
{
  static_assert(Has_cell_indices<typename Tr::Cell>::value && Has_vertex_indices<typename Tr::Vertex>::value,
                "Cells and vertices of this triangulation have no room for regions and patches; those of "
                "CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type do.");
};

// A mesh index that is made of another, or of a number. What cannot be made is the default one.
template <typename Index, typename T>
Index mesh_index(const T& value)
{
  if constexpr(std::is_constructible<Index, const T&>::value)
    return Index(value);
  else
    return Index();
}

// A vertex that carries indices is on something of that dimension, which has that index.
template <typename Vertex, typename T>
void set_vertex_indices(Vertex& v, const int dimension, const T& index)
{
  v.set_dimension(dimension);
  v.set_index(internal::mesh_index<std::decay_t<decltype(v.index())> >(index));
}

/*
 * A copy of the indices that a cell carries, so that another cell with the same vertices in the same order can have
 * them. If cells carry none, it is empty.
 */
template <typename Cell, bool has_indices = Has_cell_indices<Cell>::value>
struct Cell_indices
{
  explicit Cell_indices(const Cell&) { }

  void give_to(Cell&) const { }
};

template <typename Cell>
struct Cell_indices<Cell, true>
{
  typedef std::decay_t<decltype(std::declval<const Cell&>().subdomain_index())>      Subdomain_index;
  typedef std::decay_t<decltype(std::declval<const Cell&>().surface_patch_index(0))> Surface_patch_index;

  explicit Cell_indices(const Cell& c)
    : subdomain(c.subdomain_index()),
      patches{{ c.surface_patch_index(0), c.surface_patch_index(1), c.surface_patch_index(2),
                c.surface_patch_index(3) }}
  { }

  void give_to(Cell& c) const
  {
    c.set_subdomain_index(subdomain);
    for(int i = 0; i < 4; ++i)
      c.set_surface_patch_index(i, patches[i]);
  }

  Subdomain_index subdomain;
  std::array<Surface_patch_index, 4> patches;
};

// The same for a vertex.
template <typename Vertex, bool has_indices = Has_vertex_indices<Vertex>::value>
struct Vertex_indices
{
  explicit Vertex_indices(const Vertex&) { }

  void give_to(Vertex&) const { }
};

template <typename Vertex>
struct Vertex_indices<Vertex, true>
{
  explicit Vertex_indices(const Vertex& v) : dimension(v.in_dimension()), index(v.index()) { }

  void give_to(Vertex& v) const
  {
    v.set_dimension(dimension);
    v.set_index(index);
  }

  int dimension;
  std::decay_t<decltype(std::declval<const Vertex&>().index())> index;
};

// The size that the mesh should have at a vertex; 0 if it is not known, or there is no place for it.
template <typename Vertex>
double vertex_size([[maybe_unused]] const Vertex& v)
{
  if constexpr(Has_meshing_info<Vertex>::value)
    return CGAL::to_double(v.meshing_info());
  else
    return 0;
}

// And its size, if there is a place for it.
template <typename Vertex, bool has_info = Has_meshing_info<Vertex>::value>
struct Vertex_size
{
  explicit Vertex_size(const Vertex&) { }

  void give_to(Vertex&) const { }
};

template <typename Vertex>
struct Vertex_size<Vertex, true>
{
  explicit Vertex_size(const Vertex& v) : size(v.meshing_info()) { }

  void give_to(Vertex& v) const { v.set_meshing_info(size); }

  std::decay_t<decltype(std::declval<const Vertex&>().meshing_info())> size;
};

// Cells of Mesh_3 and of the remeshing remember their circumcenters and qualities.
template <typename Cell>
auto forget_circumcenter(Cell& c, int) -> decltype(c.invalidate_weighted_circumcenter_cache())
{
  c.invalidate_weighted_circumcenter_cache();
}

template <typename Cell>
void forget_circumcenter(Cell&, long) { }

template <typename Cell>
auto forget_quality(Cell& c, int) -> decltype(c.reset_cache_validity())
{
  c.reset_cache_validity();
}

template <typename Cell>
void forget_quality(Cell&, long) { }

// To be called for each cell at a vertex that moved.
template <typename Cell>
void forget_shape(Cell& c)
{
  internal::forget_circumcenter(c, 0);
  internal::forget_quality(c, 0);
}

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_MESH_INDICES_H

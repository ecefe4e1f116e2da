// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_MARK_DOMAIN_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_MARK_DOMAIN_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/Region_labeller_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/mesh_indices.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

// Numbers of cells, kept in the cells themselves, in the place of their region, where they are found at once.
template <typename Tr>
class Numbers_in_cells_3
{
public:
  typedef typename Tr::Cell_handle Cell_handle;

  void set(const Cell_handle c, const std::size_t number)
  {
    c->set_subdomain_index(static_cast<int>(static_cast<std::uint32_t>(number)));
  }

  std::size_t operator[](const Cell_handle c) const { return static_cast<std::uint32_t>(c->subdomain_index()); }
};

/*
 * Those facets that have no patch get one that no other facet has, all the same: the smallest positive number that is
 * left.
 */
template <typename Patch>
void complete_patches(std::vector<Patch>& patches)
{
  if constexpr(std::is_integral<Patch>::value)
  {
    if(std::find(patches.begin(), patches.end(), Patch(0)) == patches.end())
      return;
    std::vector<Patch> known = patches;
    std::sort(known.begin(), known.end());
    Patch free = 1;
    for(const Patch patch : known)
      if(patch == free)
        ++free;
    std::replace(patches.begin(), patches.end(), Patch(0), free);
  }
}

/*
 * Writes into a triangulation what CGAL's mesh packages want to know: the regions that facets separate, the patches of
 * these, and the dimensions of vertices.
 */
template <typename Tr>
class Mark_domain_3
{
public:
  typedef typename Tr::Vertex                        Vertex;
  typedef typename Tr::Vertex_handle                 Vertex_handle;
  typedef typename Tr::Cell_handle                   Cell_handle;
  typedef Cell_indices<typename Tr::Cell>            Indices;
  typedef typename Indices::Subdomain_index          Subdomain_index;
  typedef typename Indices::Surface_patch_index      Surface_patch_index;
  typedef std::array<Vertex_handle, 2>               Vertex_pair;

  explicit Mark_domain_3(Tr& tr) : m_tr(tr) { }

  // `patches` has one entry for each facet, `curves` one for each edge, unless it is empty: then they are numbered.
  // Returns the number of regions.
  template <typename FacetRange>
  int operator()(const FacetRange& facets, std::vector<Surface_patch_index> patches,
                 const std::vector<Vertex_pair>& edges = { }, const std::vector<std::size_t>& curves = { }) const
  {
    if(m_tr.dimension() < 3)
      return 0;
    internal::complete_patches(patches);
    const Labeller labeller(m_tr, facets);
    const int number_of_regions = labeller.label([&](const Cell_handle c, const int region) { start(c, region); });
    for(const Vertex_handle v : m_tr.finite_vertex_handles())
      internal::set_vertex_indices(*v, 3, v->cell()->subdomain_index());
    for(auto f = labeller.facets().rbegin(); f != labeller.facets().rend(); ++f) // so that the first one wins
      if(f->found)
        mark_facet(f->facet.first, f->facet.second, patches[f->index]);
    for(std::size_t e = edges.size(); e-- > 0; )
      for(const Vertex_handle v : edges[e])
        internal::set_vertex_indices(*v, 1, static_cast<int>(curves.empty() ? e + 1 : curves[e]));
    return number_of_regions;
  }

private:
  typedef std::conditional_t<std::is_same<Subdomain_index, int>::value, Numbers_in_cells_3<Tr>,
                             Numbers_beside_cells_3<Tr> >  Cell_numbers;
  typedef Region_labeller_3<Tr, Cell_numbers>              Labeller;

  void start(const Cell_handle c, const int region) const
  {
    c->set_subdomain_index(m_tr.is_infinite(c) ? Subdomain_index() : Subdomain_index(region));
    for(int i = 0; i < 4; ++i)
      c->set_surface_patch_index(i, Surface_patch_index());
  }

  void mark_facet(const Cell_handle c, const int i, const Surface_patch_index& patch) const
  {
    const Cell_handle neighbor = c->neighbor(i);
    c->set_surface_patch_index(i, patch);
    neighbor->set_surface_patch_index(neighbor->index(c), patch);
    for(const Vertex_handle v : internal::facet_vertices(c, i))
      internal::set_vertex_indices(*v, 2, patch);
  }

  Tr& m_tr;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_MARK_DOMAIN_3_H

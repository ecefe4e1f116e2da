// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_REMESH_CELLS_H
#define CGAL_REMESH_CELLS_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Hole_remeshing_result_3.h>
#include <CGAL/Boundary_recovery_3/Mesh_indices_keeper_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Moved_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Remesh_arrays_3.h>
#include <CGAL/Boundary_recovery_3/internal/input/input_conversion.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Mark_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Replace_cells.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/mesh_indices.h>
#include <CGAL/Boundary_recovery_3/internal/util/bare_point.h>
#include <CGAL/Boundary_recovery_3/parameters.h>
#include <CGAL/remesh_holes.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Unique_hash_map.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {

namespace Boundary_recovery_3 {
namespace internal {

/*
 * The work behind remesh_cells(): the finite cells are made arrays, these are remeshed, and what is new is put into the
 * triangulation in the place of what is gone.
 */
template <typename Tr, typename NamedParameters>
class Remesh_triangulation_3
{
public:
  typedef typename Tr::Vertex_handle              Vertex_handle;
  typedef typename Tr::Cell_handle                Cell_handle;
  typedef typename Tr::Geom_traits::Point_3       Point_3;
  typedef typename Kernel_traits<Point_3>::Kernel Kernel;
  typedef Moved_mesh_3<Point_3>                   Mesh;
  typedef Cell_remeshing_result_3<Tr>             Result;

  Remesh_triangulation_3(Tr& tr, const NamedParameters& np)
    : m_tr(tr), m_np(np), m_vertices(tr.finite_vertex_handles().begin(), tr.finite_vertex_handles().end()),
      m_cells(tr.finite_cell_handles().begin(), tr.finite_cell_handles().end())
  { }

  template <typename SizingField>
  Result operator()(const SizingField& size)
  {
    typedef Remesh_arrays_3<Kernel, NamedParameters> Remesh_arrays;
    typename Remesh_arrays::Options options;
    options.has_unfilled_region = true; // what is outside of the domain
    options.is_selected = [this](const std::size_t c) { return is_selected(m_cells[c]); };
    Remesh_arrays::set_sizes(size, options);

    Result result;
    static_cast<typename Remesh_arrays::Result&>(result) = Remesh_arrays(m_np)(mesh(), options);
    for(std::size_t v = 0; v < result.number_of_kept_vertices; ++v)
      result.vertices.push_back(m_vertices[result.old_vertices[v]]);
    for(std::size_t c = 0; c < result.number_of_kept_cells; ++c)
      result.cells.push_back(m_cells[result.old_cells[c]]);
    if(result.number_of_holes > 0 && result)
      put_into_triangulation(result);
    return result;
  }

private:
  typedef typename Mark_domain_3<Tr>::Subdomain_index Subdomain_index;

  bool is_selected(const Cell_handle c) const
  {
    if constexpr(parameters::is_default_parameter<NamedParameters, internal_np::cell_selector_t>::value)
      return false;
    else
    {
      const auto map = parameters::get_parameter(m_np, internal_np::cell_selector);
      using boost::get;
      return get(map, c);
    }
  }

  Mesh mesh() const
  {
    Mesh mesh;
    Unique_hash_map<Vertex_handle, std::size_t> number(std::size_t(-1)); // for looking up only
    for(const Vertex_handle v : m_vertices)
    {
      number[v] = mesh.points.size();
      mesh.points.push_back(internal::bare_point<Point_3>(v->point()));
    }
    for(const Cell_handle c : m_cells)
    {
      mesh.tetrahedra.push_back({{ number[c->vertex(0)], number[c->vertex(1)], number[c->vertex(2)],
                                   number[c->vertex(3)] }});
      mesh.regions.push_back(static_cast<int>(c->subdomain_index()));
      for(int i = 0; i < 4; ++i)
        if(c->is_facet_on_surface(i) && is_first_side(c, i, number))
          mesh.facets.push_back({{ number[c->vertex((i + 1) % 4)], number[c->vertex((i + 2) % 4)],
                                   number[c->vertex((i + 3) % 4)] }});
    }
    internal::for_each_constrained_edge(m_np, [&](const Vertex_handle u, const Vertex_handle v)
    {
      mesh.edges.push_back({{ number[u], number[v] }});
    });
    return mesh;
  }

  // So that facets are named once.
  template <typename Numbers>
  bool is_first_side(const Cell_handle c, const int i, const Numbers& number) const
  {
    return m_tr.is_infinite(c->neighbor(i)) || number[c->vertex(i)] <= number[m_tr.mirror_vertex(c, i)];
  }

  void put_into_triangulation(Result& result)
  {
    const std::vector<Cell_handle> old_cells = unnamed(m_cells, result.old_cells);
    const std::vector<Vertex_handle> old_vertices = unnamed(m_vertices, result.old_vertices);
    New_vertices_3<Tr> new_vertices(m_tr);
    for(std::size_t v = result.number_of_kept_vertices; v < result.points.size(); ++v)
      result.vertices.push_back(new_vertices.create(typename Tr::Point(result.points[v])));
    std::vector<std::array<Vertex_handle, 4> > tetrahedra;
    for(std::size_t c = result.number_of_kept_cells; c < result.tetrahedra.size(); ++c)
    {
      const auto& t = result.tetrahedra[c];
      tetrahedra.push_back({{ result.vertices[t[0]], result.vertices[t[1]], result.vertices[t[2]],
                              result.vertices[t[3]] }});
    }
    Mesh_indices_keeper_3<Tr> keep_patches(m_tr);
    Replace_cells<Tr> replace;
    replace(m_tr, old_cells, tetrahedra, keep_patches, old_vertices);
    result.cells.insert(result.cells.end(), replace.new_cells().begin(), replace.new_cells().end());
    mark(result);
  }

  // What has no place in the new mesh.
  template <typename Handle>
  static std::vector<Handle> unnamed(const std::vector<Handle>& handles, const std::vector<std::size_t>& positions)
  {
    std::vector<char> is_named(handles.size(), false);
    for(const std::size_t k : positions)
      if(k != Result::no_index)
        is_named[k] = true;
    std::vector<Handle> result;
    for(std::size_t k = 0; k < handles.size(); ++k)
      if(! is_named[k])
        result.push_back(handles[k]);
    return result;
  }

  void mark(const Result& result) const
  {
    for(std::size_t c = result.number_of_kept_cells; c < result.cells.size(); ++c)
    {
      const Subdomain_index region(result.regions[c]);
      result.cells[c]->set_subdomain_index(region);
      for(const std::size_t v : result.tetrahedra[c])
        if(v >= result.number_of_kept_vertices)
          internal::set_vertex_indices(*result.vertices[v], 3, region);
    }
  }

  Tr& m_tr;
  const NamedParameters& m_np;
  const std::vector<Vertex_handle> m_vertices;
  const std::vector<Cell_handle> m_cells;
};

template <typename Tr, typename SizingField, typename NamedParameters>
Cell_remeshing_result_3<Tr> remesh_cells_of_triangulation(Tr& tr, const SizingField& size, const NamedParameters& np)
{
  return Remesh_triangulation_3<Tr, NamedParameters>(tr, np)(size);
}

} // namespace internal
} // namespace Boundary_recovery_3

/*!
 * \ingroup PkgBoundaryRecovery3Functions
 *
 * \brief replaces the bad cells of a triangulation whose vertices were moved, and some cells around them; everything
 * else stays.
 *
 * The work is that of `remesh_holes()`, on a triangulation with the indices of CGAL's mesh packages, as
 * `make_boundary_constrained_mesh_3()` and CGAL's remeshing leave it. Since then, vertices were moved by
 * `Vertex::set_point()`, so that the triangulation is no longer valid. The result is valid if its hull is convex.
 *
 * Constrained are the facets for which `is_facet_on_surface()` holds, facets between cells of different
 * `subdomain_index()`, facets of the hull, and the edges of `constrained_edges`. Other vertices may go. Cells outside
 * of the domain, in the region 0, are bad only if they are flat, inverted or selected; the new cells there have no
 * field points. Cells outside of the holes, and vertices that stay, keep their handles. New cells and vertices get
 * regions, patches and dimensions.
 *
 * \tparam Triangulation an instance of `Triangulation_3`, or of a class derived from it, whose vertices are models of
 *         `MeshVertexBase_3`, and whose cells are models of `MeshCellBase_3` with an integer as `Subdomain_index`
 * \tparam SizingField a number type, or a model of `MeshDomainField_3`
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tr the triangulation
 * \param size the lengths of new edges, as for `insert_field_points()`. Without this argument, sizes are those of the
 *        old mesh at the same place.
 * \param np an optional sequence of named parameters: `min_dihedral_angle`, `number_of_layers`, `improve_quality`,
 *        `maximum_running_time` and `visitor` of `remesh_holes()`, and those listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{cell_is_selected_map}
 *     \cgalParamDescription{cells that are bad, whatever their shape}
 *     \cgalParamType{a model of `ReadablePropertyMap` with `Triangulation::Cell_handle` as key type and `bool` as value
 *                    type}
 *     \cgalParamDefault{no cell}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{constrained_edges}
 *     \cgalParamDescription{edges that stay, in addition to the edges of constrained facets}
 *     \cgalParamType{a `ConstRange` whose value type is an array of two vertex handles}
 *     \cgalParamDefault{no edges}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return the status and counts, see `remesh_holes()`. If the status is not `meshed`, the triangulation is unchanged.
 *
 * \pre the dimension of `tr` is 3, and its data structure is valid: `tr.tds().is_valid()`.
 */
#ifdef DOXYGEN_RUNNING
template <typename Triangulation, typename SizingField,
          typename NamedParameters = parameters::Default_named_parameters>
Cell_remeshing_result_3<Triangulation>
remesh_cells(Triangulation& tr, const SizingField& size,
             const NamedParameters& np = parameters::default_values());
#else
template <typename Triangulation, typename SizingField, typename ... NPs,
          Boundary_recovery_3::internal::Enable_if_sizes<SizingField>* = nullptr,
          Boundary_recovery_3::internal::Enable_if_named_parameters<NPs...>* = nullptr>
Cell_remeshing_result_3<Triangulation>
remesh_cells(Triangulation& tr, const SizingField& size, const NPs& ... nps)
{
  namespace BR3 = Boundary_recovery_3::internal;
  return BR3::remesh_cells_of_triangulation(tr, size, BR3::merge_all(nps...));
}
#endif

/*!
 * \ingroup PkgBoundaryRecovery3Functions
 *
 * \brief replaces the bad cells of a triangulation whose vertices were moved, with the sizes of the old mesh.
 *
 * See the overload with a size field.
 */
#ifdef DOXYGEN_RUNNING
template <typename Triangulation, typename NamedParameters = parameters::Default_named_parameters>
Cell_remeshing_result_3<Triangulation>
remesh_cells(Triangulation& tr, const NamedParameters& np = parameters::default_values());
#else
template <typename Triangulation, typename ... NPs,
          Boundary_recovery_3::internal::Enable_if_named_parameters<NPs...>* = nullptr>
Cell_remeshing_result_3<Triangulation> remesh_cells(Triangulation& tr, const NPs& ... nps)
{
  namespace BR3 = Boundary_recovery_3::internal;
  return BR3::remesh_cells_of_triangulation(tr, BR3::Sizes_of_old_mesh(), BR3::merge_all(nps...));
}
#endif

} // namespace CGAL

#endif // CGAL_REMESH_CELLS_H

// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_WRITE_DOMAIN_MEDIT_H
#define CGAL_BOUNDARY_RECOVERY_3_WRITE_DOMAIN_MEDIT_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/mesh_indices.h>
#include <CGAL/Boundary_recovery_3/internal/util/Medit_writer.h>
#include <CGAL/Boundary_recovery_3/internal/util/bare_point.h>
#include <CGAL/Boundary_recovery_3/internal/util/for_each_task.h>

#include <CGAL/Unique_hash_map.h>
#include <CGAL/tags.h>

#include <boost/io/ios_state.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <ios>
#include <limits>
#include <map>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

typedef std::uint32_t Point_number; // half as long as std::size_t: a mesh has millions of them

// The tetrahedra of a domain as a soup: what is written to files.
template <typename Point>
struct Domain_soup_3
{
  // input vertices in their order, then Steiner points, then field points by their regions; only those that are used
  std::vector<Point> points;
  std::vector<std::array<Point_number, 4> > tetrahedra;
  std::vector<int> regions;                             // of each tetrahedron
  std::vector<std::array<Point_number, 3> > triangles;  // the input faces that are in the triangulation, or their parts
  std::vector<std::size_t> triangle_numbers;            // of each triangle: the number of its face
  std::size_t number_of_steiner_points = 0; // those at tetrahedra of the domain
  std::size_t number_of_field_points = 0;   // and what the improvement made of them
};

// Collects a domain from a triangulation after its boundary was recovered. Numbers of vertices are looked up by all
// threads if the tag says so.
template <typename Tr, typename ConcurrencyTag = Sequential_tag>
class Domain_builder_3
{
  typedef typename Tr::Vertex_handle        Vertex_handle;
  typedef typename Tr::Cell_handle          Cell_handle;
  typedef typename Tr::Geom_traits::Point_3 Point;

  static constexpr Point_number no_number = (std::numeric_limits<Point_number>::max)();

  // What has a point; the last one counts.
  enum Use : char { nothing, facet_or_outside, region_inside };

  const Tr& m_tr;
  Domain_soup_3<Point> m_domain;
  Unique_hash_map<Vertex_handle, Point_number> m_number;
  std::vector<Use> m_uses; // of the points

public:
  explicit Domain_builder_3(const Tr& tr) : m_tr(tr), m_number(no_number, tr.number_of_vertices())
  {
    if(tr.number_of_vertices() >= no_number)
      throw std::length_error("the mesh has too many vertices to be written");
  }

  // `region` tells the region that a cell is in, 0 for the outside, a negative number if it is not to be taken; maybe
  // by several threads
  template <typename Result, typename Facets, typename Region>
  Domain_soup_3<Point> operator()(const Result& result, const Facets& facets, const Region& region)
  {
    m_domain.points.reserve(m_tr.number_of_vertices());
    for(const Vertex_handle v : result.vertices)
      add_vertex(v);
    const std::size_t first_steiner_point = m_domain.points.size();
    for(const Vertex_handle v : result.steiner_vertices)
      add_vertex(v);
    const std::size_t first_field_point = m_domain.points.size();
    add_field_points(region);
    m_uses.assign(m_domain.points.size(), nothing);
    add_tetrahedra(region);
    add_triangles(facets);
    m_domain.number_of_steiner_points = number_of_points_inside(first_steiner_point, first_field_point);
    m_domain.number_of_field_points = number_of_points_inside(first_field_point, m_uses.size());
    drop_unused_points();
    return std::move(m_domain);
  }

private:
  // Equal input points are one vertex; the vertex of a point may be missing.
  void add_vertex(const Vertex_handle v)
  {
    if(v == Vertex_handle())
      return;
    Point_number& number = m_number[v];
    if(number != no_number)
      return;
    number = static_cast<Point_number>(m_domain.points.size());
    m_domain.points.push_back(internal::bare_point<Point>(v->point()));
  }

  // All the cells of a field point are in one region. Those of a region come together, as Gmsh's files have them. Any
  // other vertices are added, too, as a cell may have them: where regions meet without a facet that has a patch.
  template <typename Region>
  void add_field_points(const Region& region)
  {
    typedef std::pair<int, Vertex_handle> Placed_vertex;
    std::map<int, std::vector<Vertex_handle> > vertices;
    internal::take_each(m_tr.finite_vertex_handles(), [&](const Vertex_handle v)
    {
      return m_number.is_defined(v) ? std::nullopt : std::make_optional(Placed_vertex(region(v->cell()), v));
    },
    [&](const Placed_vertex& placed) { vertices[placed.first].push_back(placed.second); }, ConcurrencyTag());
    for(const auto& [r, vertices_of_region] : vertices)
      for(const Vertex_handle v : vertices_of_region)
        add_vertex(v);
  }

  template <typename Region>
  void add_tetrahedra(const Region& region)
  {
    typedef std::pair<std::array<Point_number, 4>, int> Tetrahedron;
    m_domain.tetrahedra.reserve(m_tr.number_of_cells());
    m_domain.regions.reserve(m_tr.number_of_cells());
    const Unique_hash_map<Vertex_handle, Point_number>& number = m_number;
    internal::take_each(m_tr.finite_cell_handles(), [&](const Cell_handle c) -> std::optional<Tetrahedron>
    {
      const int r = region(c);
      if(r < 0)
        return std::nullopt;
      const auto vertex = [&](const int i) { return number[c->vertex(i)]; };
      return Tetrahedron({{ vertex(0), vertex(1), vertex(2), vertex(3) }}, r);
    },
    [this](const Tetrahedron& t)
    {
      m_domain.tetrahedra.push_back(t.first);
      m_domain.regions.push_back(t.second);
      use(t.first, t.second > 0 ? region_inside : facet_or_outside);
    }, ConcurrencyTag());
  }

  template <typename Facets>
  void add_triangles(const Facets& facets)
  {
    for(const auto& facet : facets)
    {
      m_domain.triangles.push_back({{ m_number[facet[0]], m_number[facet[1]], m_number[facet[2]] }});
      m_domain.triangle_numbers.push_back(facet.index);
      use(m_domain.triangles.back(), facet_or_outside);
    }
  }

  template <typename Simplex>
  void use(const Simplex& simplex, const Use use)
  {
    for(const Point_number i : simplex)
      m_uses[i] = (std::max)(m_uses[i], use);
  }

  // Of those between two numbers.
  std::size_t number_of_points_inside(const std::size_t first, const std::size_t last) const
  {
    return std::size_t(std::count(m_uses.begin() + first, m_uses.begin() + last, region_inside));
  }

  void drop_unused_points()
  {
    if(std::find(m_uses.begin(), m_uses.end(), nothing) == m_uses.end())
      return;
    std::vector<Point_number> number(m_uses.size(), no_number);
    Point_number number_of_points = 0;
    for(std::size_t i = 0; i < m_uses.size(); ++i)
      if(m_uses[i] != nothing)
      {
        m_domain.points[number_of_points] = m_domain.points[i];
        number[i] = number_of_points++;
      }
    m_domain.points.erase(m_domain.points.begin() + number_of_points, m_domain.points.end());
    const auto renumber = [&](auto& simplices)
    {
      for(auto& simplex : simplices)
        for(Point_number& i : simplex)
          i = number[i];
    };
    renumber(m_domain.tetrahedra);
    renumber(m_domain.triangles);
  }
};

// The facets of a triangulation that have a patch, each once. Nothing depends on addresses.
template <typename Tr>
class Marked_facets_3
{
  typedef typename Tr::Vertex_handle          Vertex_handle;
  typedef typename Tr::Cell_handle            Cell_handle;
  typedef typename Tr::Geom_traits::Point_3   Point_3;
  typedef Cell_indices<typename Tr::Cell>     Indices;
  typedef Surface_facet_3<Vertex_handle>      Facet;

  const Tr& m_tr;

public:
  explicit Marked_facets_3(const Tr& tr) : m_tr(tr) { }

  // In ascending order of their patches, which are their indices. They turn outward from the region with the larger
  // number.
  std::vector<Facet> operator()() const
  {
    std::vector<Facet> facets;
    if(m_tr.dimension() == 3)
      for(const Cell_handle c : m_tr.all_cell_handles())
        for(int i = 0; i < 4; ++i)
          add_facet(c, i, facets);
    std::stable_sort(facets.begin(), facets.end(), [](const Facet& f, const Facet& g) { return f.index < g.index; });
    return facets;
  }

  // the patch of a facet; 0 if it is no facet
  int patch(const Facet& facet) const
  {
    Cell_handle c;
    int i, j, k;
    return m_tr.dimension() == 3 && m_tr.is_facet(facet[0], facet[1], facet[2], c, i, j, k)
           ? int(c->surface_patch_index(6 - i - j - k)) : 0;
  }

private:
  // from one of the two sides
  void add_facet(const Cell_handle c, const int i, std::vector<Facet>& facets) const
  {
    if(c->surface_patch_index(i) == typename Indices::Surface_patch_index() || m_tr.is_infinite(c, i))
      return;
    const Facet facet{ {{ vertex(c, i, 0), vertex(c, i, 1), vertex(c, i, 2) }},
                       static_cast<std::size_t>(c->surface_patch_index(i)) };
    const int here = int(c->subdomain_index()), there = int(c->neighbor(i)->subdomain_index());
    if(here != there ? here < there : is_turned_to_larger_points(facet))
      facets.push_back(facet);
  }

  // in the orientation that has its front in the cell
  static Vertex_handle vertex(const Cell_handle c, const int i, const int j)
  {
    return c->vertex(Tr::vertex_triple_index(i, j));
  }

  // true for one of the two orientations of a facet
  bool is_turned_to_larger_points(const Facet& facet) const
  {
    const auto is_smaller = [&](const std::size_t i, const std::size_t j)
    {
      return m_tr.geom_traits().compare_xyz_3_object()(internal::bare_point<Point_3>(facet[i]->point()),
                                                       internal::bare_point<Point_3>(facet[j]->point())) == SMALLER;
    };
    const int number_of_ascents = is_smaller(0, 1) + is_smaller(1, 2) + is_smaller(2, 0);
    return number_of_ascents == 2;
  }
};

// Which vertices come first.
template <typename Vertex_handle>
struct Vertices_in_order
{
  std::vector<Vertex_handle> vertices, steiner_vertices;
};

// If the result of the recovery is an empty one, the marked facets are taken, and their vertices come first.
template <typename Tr>
void write_domain_MEDIT(std::ostream& os, const Tr& tr, const Boundary_recovery_result_3<Tr>& recovery)
{
  static_cast<void>(Require_mesh_indices<Tr>());
  typedef Cell_indices<typename Tr::Cell> Indices;
  static_assert(std::is_convertible<typename Indices::Subdomain_index, int>::value
                && std::is_convertible<typename Indices::Surface_patch_index, int>::value,
                "MEDIT's files have numbers of regions and patches.");
  const Marked_facets_3<Tr> marked_facets(tr);
  std::vector<Surface_facet_3<typename Tr::Vertex_handle> > facets = recovery.surface_facets();
  Vertices_in_order<typename Tr::Vertex_handle> vertices{ recovery.vertices, recovery.steiner_vertices };
  if(facets.empty())
  {
    facets = marked_facets();
    for(const auto& facet : facets)
      vertices.vertices.insert(vertices.vertices.end(), facet.begin(), facet.end());
  }
  std::vector<int> patches;
  for(const auto& facet : facets)
    patches.push_back(marked_facets.patch(facet));
  const auto domain = Domain_builder_3<Tr>(tr)(vertices, facets, [](const typename Tr::Cell_handle c)
                                               { return c->subdomain_index() == 0 ? -1 : int(c->subdomain_index()); });

  const boost::io::ios_all_saver saver(os);
  os.unsetf(std::ios_base::floatfield);
  os.precision(std::numeric_limits<double>::max_digits10);
  Medit_writer<std::ostream> writer(os);
  writer.write_vertices(domain.points.size(), [&](const std::size_t i) -> const auto& { return domain.points[i]; });
  writer.write_simplices("Triangles", domain.triangles.size(),
                         [&](const std::size_t i, const auto& f) { f(domain.triangles[i]); }, patches);
  writer.write_simplices("Tetrahedra", domain.tetrahedra.size(),
                         [&](const std::size_t i, const auto& f) { f(domain.tetrahedra[i]); }, domain.regions);
  writer.write_end();
}

} // namespace internal
} // namespace Boundary_recovery_3

namespace IO {

/*!
 * \ingroup PkgBoundaryRecovery3Functions
 *
 * \brief writes the marked domain of a triangulation in MEDIT's text format (`.mesh`), which Gmsh, mmg and meshio read.
 *
 * The file has
 * - the vertices of the domain and of the constrained facets, with all digits: coordinates of the type `double` are
 *   read back bit for bit;
 * - each constrained facet once, with its patch as reference, as `mark_domain()` writes it;
 * - the cells of the domain, with their region as reference, positively oriented. Cells outside, in region 0, are left
 *   out.
 *
 * By contrast, `CGAL::IO::write_MEDIT()` writes all vertices of the triangulation, and with \cgal 5 each facet twice,
 * with the regions on both sides.
 *
 * \tparam Triangulation an instance of `CGAL::Triangulation_3`, or of a class derived from it, such as
 *         `Boundary_constrained_mesh_triangulation_3::type`, whose vertices and cells are models of `MeshVertexBase_3`
 *         and `MeshCellBase_3`; regions and patches are integers, from 1
 *
 * \param os the stream
 * \param tr the triangulation, after `make_boundary_constrained_mesh_3()`, `mark_domain()` or any of the steps after it
 * \param recovery the result of the boundary recovery in `tr`, such as `Boundary_constrained_mesh_result_3::recovery`.
 *        With this argument, the vertices of the input that are in the mesh come first, in their order, and facets have
 *        the order and the orientation of the input. Without this argument, facets are in the order of their patches,
 *        and face away from the region with the larger number; the vertices of the facets come first, in the order of
 *        the facets.
 *
 * \return `true` iff the stream had no error
 *
 * \pre There are fewer than 2<sup>32</sup> - 1 vertices, else `std::length_error` is thrown.
 */
template <typename Triangulation>
bool write_domain_MEDIT(std::ostream& os, const Triangulation& tr,
                        const Boundary_recovery_result_3<Triangulation>& recovery
                          = Boundary_recovery_result_3<Triangulation>())
{
  Boundary_recovery_3::internal::write_domain_MEDIT(os, tr, recovery);
  return os.good();
}

/*!
 * \ingroup PkgBoundaryRecovery3Functions
 *
 * \brief writes the marked domain of a triangulation to the file `fname`, see the function above.
 *
 * \return `true` iff the whole file was written
 */
template <typename Triangulation>
bool write_domain_MEDIT(const std::string& fname, const Triangulation& tr,
                        const Boundary_recovery_result_3<Triangulation>& recovery
                          = Boundary_recovery_result_3<Triangulation>())
{
  std::ofstream os(fname);
  const bool is_written = IO::write_domain_MEDIT(os, tr, recovery);
  os.close();
  return is_written && os.good();
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_WRITE_DOMAIN_MEDIT_H

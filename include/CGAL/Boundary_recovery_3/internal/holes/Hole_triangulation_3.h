// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_HOLE_TRIANGULATION_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_HOLE_TRIANGULATION_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/Constrained_edge_map_3.h>
#include <CGAL/Boundary_recovery_3/Meshing_visitor_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Field_point_insertion_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Hole_surface_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Moved_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Selected_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Tetrahedra_incidences_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Improve_quality_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Cell_shape_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/distances_3.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Cone_minimum_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>
#include <CGAL/Boundary_recovery_3/parameters.h>
#include <CGAL/improve_mesh_quality.h>
#include <CGAL/recover_boundary.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Writes into a triangulation which cells are inside of a hole, and in which region: both sides of each facet of its
 * surface are known. Where they contradict each other, the surface bounds no such hole: it is turned inside out.
 */
template <typename Tr>
class Label_hole_3
{
public:
  typedef typename Tr::Vertex_handle   Vertex_handle;
  typedef typename Tr::Cell_handle     Cell_handle;
  typedef std::array<Vertex_handle, 3> Facet;

  explicit Label_hole_3(Tr& tr) : m_tr(tr) { }

  // The facets are in the triangulation; `regions` has for each of them the region on its positive side, and that on
  // the other one, 0 being outside. Returns false if they contradict each other.
  bool operator()(const std::vector<Facet>& facets, const std::vector<std::array<int, 2> >& regions)
  {
    for(const Facet& f : facets)
      m_index.insert(f);
    std::vector<Cell_handle> seeds;
    for(const Cell_handle c : m_tr.all_cell_handles())
      c->set_subdomain_index(m_tr.is_infinite(c) ? 0 : int(unknown));
    for(const Cell_handle c : m_tr.all_cell_handles())
      if(! label_by_facets(c, facets, regions, seeds))
        return false;
    for(const Cell_handle c : seeds)
      if(! spread(c))
        return false;
    return true;
  }

private:
  static constexpr int unknown = -1;

  // A cell is on the positive side of its facets, as `facet_vertices()` has them. Each facet is looked up once.
  bool label_by_facets(const Cell_handle c, const std::vector<Facet>& facets,
                       const std::vector<std::array<int, 2> >& regions, std::vector<Cell_handle>& seeds)
  {
    for(int i = 0; i < 4; ++i)
    {
      const Cell_handle n = c->neighbor(i);
      if(n < c)
        continue;
      const Facet f = internal::facet_vertices(c, i);
      const std::size_t k = m_index[f];
      c->set_surface_patch_index(i, k == m_index.none ? 0 : 1);
      n->set_surface_patch_index(m_tr.mirror_index(c, i), k == m_index.none ? 0 : 1);
      if(k == m_index.none)
        continue;
      const int side = is_rotation(f, facets[k]) ? 0 : 1;
      if(! label(c, regions[k][side], seeds) || ! label(n, regions[k][1 - side], seeds))
        return false;
    }
    return true;
  }

  // Returns false if it has another region.
  static bool label(const Cell_handle c, const int region, std::vector<Cell_handle>& seeds)
  {
    if(c->subdomain_index() != unknown && c->subdomain_index() != region)
      return false;
    c->set_subdomain_index(region);
    seeds.push_back(c);
    return true;
  }

  // Returns false if there is a cell of another region.
  bool spread(const Cell_handle seed)
  {
    const int region = seed->subdomain_index();
    bool is_consistent = true, is_first = true;
    const auto is_open = [](const Cell_handle c, const int i)
    {
      return ! c->is_facet_on_surface(i) && c->neighbor(i)->subdomain_index() != c->subdomain_index();
    };
    internal::flood_fill(seed, is_open, [&](const Cell_handle c)
    {
      is_consistent = is_consistent && (c->subdomain_index() == unknown || c->subdomain_index() == region);
      const bool is_new = is_first || c->subdomain_index() == unknown;
      is_first = false;
      if(is_new)
        c->set_subdomain_index(region);
      return is_new;
    });
    return is_consistent;
  }

  Tr& m_tr;
  Simplex_index_3<Vertex_handle, 3> m_index;
};

/*
 * The sizes of the old mesh in a hole: at each vertex the mean length of the edges of the cells there, of those that
 * are not bad if there are any, carried from there into space.
 *
 * Lengths differ from one vertex to the next, and the smallest ones would win everywhere: a mesh that is remeshed again
 * and again would get finer and finer. Therefore all edges of these cells count, and not only those at the vertex.
 */
class Old_sizes_3
{
public:
  // See "Tuning constants" in the manual.
  static constexpr double grading = 0.3;
  static constexpr double size_per_mean_length = 0.95;

  // `is_bad` has an entry for each tetrahedron of the mesh, `cells` are those of the hole.
  template <typename Point_3>
  Old_sizes_3(const Moved_mesh_3<Point_3>& mesh, const Tetrahedra_incidences_3& incidences,
              const std::vector<char>& is_bad, const std::vector<std::size_t>& cells)
    : m_cones(sites(mesh, incidences, is_bad, cells), grading)
  { }

  double operator()(const Coordinates_3& p) const { return m_cones(p); }

private:
  typedef Cone_minimum_3::Site Site;

  // The mean length of all edges, and that of the edges of good cells; each edge as often as there are cells at it.
  struct Mean
  {
    std::array<double, 2> sums = {{ 0, 0 }};
    std::array<std::size_t, 2> numbers = {{ 0, 0 }};

    void add(const double length, const bool is_good)
    {
      sums[is_good] += length;
      ++numbers[is_good];
    }

    double operator()() const
    {
      const std::size_t k = numbers[1] > 0 ? 1 : 0;
      return numbers[k] > 0 ? sums[k] / static_cast<double>(numbers[k]) : 0;
    }
  };

  template <typename Point_3>
  static std::vector<Site> sites(const Moved_mesh_3<Point_3>& mesh, const Tetrahedra_incidences_3& incidences,
                                 const std::vector<char>& is_bad, const std::vector<std::size_t>& cells)
  {
    Simplex_index_3<std::size_t, 1> known;
    std::vector<Site> result;
    for(const std::size_t c : cells)
      for(const std::size_t v : mesh.tetrahedra[c])
        if(known.insert({{ v }}).second)
        {
          const double length = mean_length(mesh, incidences, is_bad, v);
          if(length > 0) // else all of its neighbors are at its place
            result.push_back(Site{ internal::coordinates_of(mesh.points[v]), size_per_mean_length * length });
        }
    return result;
  }

  template <typename Point_3>
  static double mean_length(const Moved_mesh_3<Point_3>& mesh, const Tetrahedra_incidences_3& incidences,
                            const std::vector<char>& is_bad, const std::size_t v)
  {
    Mean mean;
    for(const std::size_t c : incidences.cells(v))
    {
      const std::array<Coordinates_3, 4> p = mesh.corners(c);
      for(const auto& e : edges_of_cell)
        mean.add(std::sqrt(internal::squared_distance(p[std::size_t(e[0])], p[std::size_t(e[1])])), ! is_bad[c]);
    }
    return mean();
  }

  Cone_minimum_3 m_cones;
};

// Asks somebody whether to go on, and tells nothing.
template <typename Tr>
struct Hole_visitor_3 final
  : public Mesh_visitor_3<Tr>
{
  explicit Hole_visitor_3(const std::function<bool()>& question) : question(question) { }

  bool go_further() override { return question(); }

  std::function<bool()> question;
};

// A size field of any type, so that one mesher is compiled for all of them.
template <typename Point_3>
struct Hole_sizes_3
{
  std::function<double(const Point_3&, int)> size; // at a place in a region, with a local number
  double largest_grading;
  bool are_old; // those of the old mesh: as many cells as there were will do

  double operator()(const Point_3& p, const int /* dimension */, const int region) const { return size(p, region); }

  double grading() const { return largest_grading; }
};

/*
 * The triangulation that a hole is meshed in, from the recovery of its boundary to the improvement.
 */
template <typename Kernel>
class Hole_triangulation_3
{
public:
  typedef typename Kernel::Point_3                                        Point_3;
  typedef typename Boundary_constrained_mesh_triangulation_3<Kernel>::type Tr;
  typedef typename Tr::Vertex_handle                                      Vertex_handle;
  typedef typename Tr::Cell_handle                                        Cell_handle;
  typedef Hole_surface_3<Point_3>                                         Surface;
  typedef Boundary_recovery_result_3<Tr>                                  Recovery;
  typedef Field_points_result_3<Tr>                                       Filling;
  typedef Quality_improvement_result_3<Tr>                                Improvement;

  explicit Hole_triangulation_3(const std::function<bool()>& can_go_further) : m_visitor(can_go_further) { }

  // `list_defects`: intersections are looked for first, as for `recover_boundary()`.
  Recovery recover(const Surface& surface, const bool list_defects)
  {
    const Recovery recovery = recover_boundary(
      m_tr, surface.points, surface.facets, parameters::constrained_edges(surface.edges),
      parameters::list_defects(list_defects), parameters::visitor(std::ref(m_visitor)));
    m_vertices = recovery.vertices;
    m_facets = recovery.facets;
    m_steiner_vertices = recovery.steiner_vertices;
    return recovery;
  }

  // After a recovery that did not fail. Cells of the region `unfilled` get no field points; -1: none. Returns false if
  // the surface is turned inside out.
  bool mark(const Surface& surface, const int unfilled)
  {
    if(! Label_hole_3<Tr>(m_tr)(m_facets, surface.regions_of_sides))
      return false;
    std::vector<std::array<Vertex_handle, 2> > edges;
    for(const auto& e : surface.edges)
      edges.push_back({{ m_vertices[e[0]], m_vertices[e[1]] }});
    m_edges = Constrained_edge_map_3<Tr>(edges);
    set_dimensions();
    for(const Vertex_handle v : m_steiner_vertices)
      m_number_of_steiner_points += v->cell()->subdomain_index() != 0 ? 1 : 0;
    set_aside(unfilled);
    return true;
  }

  // There may be thousands of holes: what is asked for a forecast would take more time than the filling.
  Filling fill(const Hole_sizes_3<Point_3>& sizes)
  {
    auto domain = internal::selected_domain(m_tr, parameters::edge_is_constrained_map(m_edges));
    const Any_size_field_3<Kernel, Hole_sizes_3<Point_3> > size(sizes);
    const Forecast_effort effort = sizes.are_old ? Forecast_effort::none : Forecast_effort::small;
    Field_point_insertion_3<Tr> insert(m_tr, domain, size, m_visitor, effort);
    return insert((std::numeric_limits<std::size_t>::max)(), std::numeric_limits<double>::infinity());
  }

  Improvement improve(const double min_dihedral_angle)
  {
    return improve_mesh_quality(m_tr, parameters::min_dihedral_angle(min_dihedral_angle),
                                parameters::edge_is_constrained_map(m_edges).visitor(std::ref(m_visitor)));
  }

  // The positions in the surface of the vertices of cells that the improvement left below an angle.
  std::vector<std::size_t> vertices_of_bad_cells(const Improvement& improvement, const double min_dihedral_angle) const
  {
    Simplex_index_3<Vertex_handle, 1> index; // for looking up only
    for(const Vertex_handle v : m_vertices)
      index.insert({{ v }});
    std::vector<std::size_t> result;
    for(const auto& bad : improvement.certificate.cells)
      for(int i = 0; i < 4 && bad.min_dihedral_angle < min_dihedral_angle; ++i)
      {
        const std::size_t k = index[{{ bad.cell->vertex(i) }}];
        if(k != index.none)
          result.push_back(k);
      }
    return result;
  }

  // Those in the hole, after the recovery.
  std::size_t number_of_steiner_points() const { return m_number_of_steiner_points; }

  const std::vector<Vertex_handle>& vertices() const { return m_vertices; }

  // With those outside of the hole, too.
  std::size_t number_of_vertices() const { return m_tr.number_of_vertices(); }
  std::size_t number_of_cells() const { return m_tr.tds().number_of_cells(); }

  // Calls `work(c, region)` for the cells in the hole, with local numbers of regions.
  template <typename Work>
  void for_each_cell(const Work& work) const
  {
    for(const Cell_handle c : m_tr.finite_cell_handles())
      if(c->subdomain_index() != 0)
        work(c, c->subdomain_index());
    for(const Cell_handle c : m_unfilled_cells)
      work(c, m_unfilled);
  }

private:
  // Steiner points are free.
  void set_dimensions()
  {
    for(const Vertex_handle v : m_tr.finite_vertex_handles())
      v->set_dimension(3);
    for(const Vertex_handle v : m_vertices)
      v->set_dimension(1);
    for(const auto& f : m_facets)
      for(const Vertex_handle v : f)
        v->set_dimension(2);
  }

  // For the mesher, they are outside; it changes nothing there.
  void set_aside(const int unfilled)
  {
    m_unfilled = unfilled;
    for(const Cell_handle c : m_tr.finite_cell_handles())
      if(c->subdomain_index() == unfilled)
      {
        c->set_subdomain_index(0);
        m_unfilled_cells.push_back(c);
      }
  }

  Hole_visitor_3<Tr> m_visitor;
  Tr m_tr;
  std::vector<Vertex_handle> m_vertices; // of the surface
  std::vector<std::array<Vertex_handle, 3> > m_facets;
  std::vector<Vertex_handle> m_steiner_vertices; // of the recovery, those outside of the hole included
  std::size_t m_number_of_steiner_points = 0;
  Constrained_edge_map_3<Tr> m_edges;
  int m_unfilled = -1;
  std::vector<Cell_handle> m_unfilled_cells;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_HOLE_TRIANGULATION_3_H

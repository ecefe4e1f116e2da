// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_SURFACE_SIZING_FIELD_3_H
#define CGAL_BOUNDARY_RECOVERY_3_SURFACE_SIZING_FIELD_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Cone_minimum_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3 {
namespace internal {

// By how much sizes from a surface grow per length unless the caller says so, see "Tuning constants" in the manual.
constexpr double default_surface_grading = 0.3;

// A surface as a size field sees it: the places of its vertices, its triangles, and all edges, each once. Neither their
// orientation nor their order tells anything.
struct Sized_surface_3
{
  std::vector<Coordinates_3> points;
  std::vector<std::array<std::size_t, 3> > triangles;
  std::vector<std::pair<std::size_t, std::size_t> > edges;

  void add_triangle(std::array<std::size_t, 3> t)
  {
    std::sort(t.begin(), t.end());
    triangles.push_back(t);
    edges.emplace_back(t[0], t[1]);
    edges.emplace_back(t[1], t[2]);
    edges.emplace_back(t[0], t[2]);
  }

  void remove_duplicates()
  {
    sort_and_unify(triangles);
    sort_and_unify(edges);
  }

private:
  template <typename Simplex>
  static void sort_and_unify(std::vector<Simplex>& simplices)
  {
    std::sort(simplices.begin(), simplices.end());
    simplices.erase(std::unique(simplices.begin(), simplices.end()), simplices.end());
  }
};

// The region of a cell, 0 outside of the convex hull, whatever is written there.
template <typename Tr>
typename Tr::Cell::Subdomain_index region_of(const Tr& tr, const typename Tr::Cell_handle c)
{
  return tr.is_infinite(c) ? typename Tr::Cell::Subdomain_index() : c->subdomain_index();
}

// Those of facets that are marked, or are between two regions, and of other edges, given by pairs of vertices.
template <typename Tr, typename VertexPairRange>
Sized_surface_3 sized_surface_and(const Tr& tr, const VertexPairRange& edges)
{
  Sized_surface_3 surface;
  Simplex_index_3<typename Tr::Vertex_handle, 1> numbers;
  const auto number = [&](const typename Tr::Vertex_handle v)
  {
    const auto inserted = numbers.insert({{ v }});
    if(inserted.second)
      surface.points.push_back(coordinates_of(v->point()));
    return inserted.first;
  };
  // from both sides: which one CGAL's iterator over facets takes depends on addresses
  if(tr.dimension() == 3)
    for(const auto c : tr.finite_cell_handles())
      for(int i = 0; i < 4; ++i)
        if(c->is_facet_on_surface(i) || region_of(tr, c) != region_of(tr, c->neighbor(i)))
        {
          const auto f = internal::facet_vertices(c, i);
          surface.add_triangle({{ number(f[0]), number(f[1]), number(f[2]) }});
        }
  for(const auto& edge : edges)
  {
    const std::size_t first = number(edge[0]), second = number(edge[1]);
    surface.edges.push_back(std::minmax(first, second));
  }
  surface.remove_duplicates();
  return surface;
}

template <typename PointRange, typename TriangleRange>
Sized_surface_3 sized_surface(const PointRange& points, const TriangleRange& triangles)
{
  Sized_surface_3 surface;
  for(const auto& p : points)
    surface.points.push_back(coordinates_of(p));
  for(const auto& t : triangles)
    surface.add_triangle({{ std::size_t(t[0]), std::size_t(t[1]), std::size_t(t[2]) }});
  surface.remove_duplicates();
  return surface;
}

/*
 * The sizes that a surface has at its vertices: the mean length of the edges there, unless the triangles around say
 * otherwise. Those have means that are weighted by area, spread from triangles to vertices twice. Over the length of an
 * edge, sizes may grow by the grading. Where the means by area are larger than that, the vertex is one of a few that
 * are close together on a coarse surface, as on isosurfaces, and these means count.
 *
 * Edges without length and triangles without area do not count. Vertices without edges have the size 0.
 */
class Surface_vertex_sizes_3
{
public:
  Surface_vertex_sizes_3(const Sized_surface_3& surface, const double grading)
    : m_surface(surface), m_frame(box_of(surface.points)), m_sizes(surface.points.size())
  {
    find_mean_lengths();
    const Numbers by_area = means_by_area();
    for(std::size_t v = 0; v < m_sizes.size(); ++v)
      if(by_area[v] > (1 + grading) * m_sizes[v])
        m_sizes[v] = by_area[v];
  }

  double operator[](const std::size_t v) const { return m_frame.from_frame(m_sizes[v]); }

private:
  typedef std::vector<double> Numbers;

  // The weighted mean, at each vertex, of what is added there.
  struct Means
  {
    Numbers sums, weights;

    explicit Means(const std::size_t n) : sums(n), weights(n) { }

    void add(const std::size_t v, const double x, const double weight)
    {
      sums[v] += weight * x;
      weights[v] += weight;
    }

    // Replaces those numbers for which there is one.
    void put_into(Numbers& numbers) const
    {
      for(std::size_t v = 0; v < numbers.size(); ++v)
        if(weights[v] > 0)
          numbers[v] = sums[v] / weights[v];
    }
  };

  static Axis_box_3 box_of(const std::vector<Coordinates_3>& points)
  {
    Axis_box_3 box;
    for(const Coordinates_3& p : points)
      box.add(p);
    return box;
  }

  Coordinates_3 point(const std::size_t v) const { return m_frame.to_frame(m_surface.points[v]); }

  void find_mean_lengths()
  {
    Means means(m_sizes.size());
    for(const auto& [u, v] : m_surface.edges)
    {
      const double length = internal::distance(point(u), point(v));
      means.add(u, length, length > 0);
      means.add(v, length, length > 0);
    }
    means.put_into(m_sizes);
  }

  // Spread twice: all triangles at a vertex may be small, and only those around them large.
  Numbers means_by_area() const
  {
    Numbers of_triangles;
    for(const auto& [u, v, w] : m_surface.triangles)
      of_triangles.push_back(mean(internal::distance(point(u), point(v)), internal::distance(point(v), point(w)),
                                  internal::distance(point(w), point(u))));
    const Numbers once = spread_by_area(of_triangles);
    for(std::size_t k = 0; k < of_triangles.size(); ++k)
    {
      const auto& [u, v, w] = m_surface.triangles[k];
      of_triangles[k] = mean(once[u], once[v], once[w]);
    }
    return spread_by_area(of_triangles);
  }

  Numbers spread_by_area(const Numbers& of_triangles) const
  {
    Means means(m_sizes.size());
    for(std::size_t k = 0; k < of_triangles.size(); ++k)
    {
      const auto& t = m_surface.triangles[k];
      const Coordinates_3 normal = cross_product(difference(point(t[1]), point(t[0])),
                                                 difference(point(t[2]), point(t[0])));
      for(const std::size_t v : t)
        means.add(v, of_triangles[k], std::sqrt(dot_product(normal, normal)));
    }
    Numbers at_vertices(m_sizes);
    means.put_into(at_vertices);
    return at_vertices;
  }

  static double mean(const double x, const double y, const double z) { return (x + y + z) / 3; }

  const Sized_surface_3& m_surface;
  Unit_frame_3 m_frame;
  Numbers m_sizes; // in this frame
};

// Where the surface has a size. `grading` is by how much sizes grow per length.
inline std::vector<Cone_minimum_3::Site> sites_of_surface(const Sized_surface_3& surface, const double grading)
{
  const Surface_vertex_sizes_3 sizes(surface, grading);
  std::vector<Cone_minimum_3::Site> sites;
  for(std::size_t v = 0; v < surface.points.size(); ++v)
    if(sizes[v] > 0)
      sites.push_back(Cone_minimum_3::Site{ surface.points[v], sizes[v] });
  return sites;
}

} // namespace internal

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief a size field that continues the sizes of a surface: at each vertex of the surface the mean length of its edges
 * there, carried into space, where sizes grow with the distance.
 *
 * The size at a point `p` is the smallest \f$ h_q + g |pq| \f$ of all vertices `q` of the surface, where \f$ h_q \f$ is
 * the size of the surface at `q`, and `g` is the *grading*. Hence sizes at two places differ by at most `g` times the
 * distance of the places.
 *
 * The size of the surface at `q` is the mean length \f$ m_q \f$ of its edges there, unless `q` belongs to a few small
 * triangles on a coarse surface, as isosurfaces have them. A second mean \f$ a_q \f$ tells: each triangle has the mean
 * length of its edges; each vertex gets the mean of its triangles, weighted by area, each triangle the mean of its
 * vertices, and each vertex again the mean of its triangles, \f$ a_q \f$. If \f$ a_q > (1 + g) m_q \f$, the surface
 * grows faster than sizes may over the length of an edge, and the size is \f$ a_q \f$. Vertices without edges, edges
 * without length and triangles without area do not count. If nothing counts, all sizes are infinite. No mesh can have
 * such sizes.
 *
 * Sizes are computed in floating point numbers, and depend on `p` only. Several threads may call the field at the same
 * time.
 *
 * \tparam Tr an instance of `CGAL::Triangulation_3`, or of a class derived from it; the field needs its traits only
 *
 * \cgalModels{MeshDomainField_3}
 */
template <typename Tr>
class Surface_sizing_field_3
{
public:
  typedef double                            FT;      ///< the number type of sizes
  typedef typename Tr::Geom_traits::Point_3 Point_3; ///< the point type
  typedef int                               Index;   ///< the type of the number of a region

  /// the grading if none is given: 0.3. \hideinitializer
  static constexpr double default_grading = internal::default_surface_grading;

  /*!
   * \brief takes the surface from the indices of the cells of a triangulation: facets for which `is_facet_on_surface()`
   * is true, and facets between cells with different `subdomain_index()`.
   *
   * The triangulation is not used after the construction.
   *
   * \param tr the triangulation; its cells have these two functions of `MeshCellBase_3`
   * \param grading the largest growth of sizes per length, without unit
   * \pre `grading` is not negative, and finite.
   */
  explicit Surface_sizing_field_3(const Tr& tr, const double grading = default_grading)
    : Surface_sizing_field_3(tr, grading, std::vector<std::array<typename Tr::Vertex_handle, 2> >())
  { }

  /*!
   * \brief takes the surface from the indices of the cells of a triangulation, with further edges, such as constrained
   * edges without facets.
   *
   * \tparam VertexPairRange a range of pairs `e` of vertices `e[0]` and `e[1]`
   * \param tr the triangulation; see above
   * \param grading the largest growth of sizes per length, without unit
   * \param edges the edges, some of which may be edges of the surface
   * \pre `grading` is not negative, and finite.
   */
  template <typename VertexPairRange>
  Surface_sizing_field_3(const Tr& tr, const double grading, const VertexPairRange& edges)
    : m_sizes(internal::sites_of_surface(internal::sized_surface_and(tr, edges), grading), grading)
  {
    CGAL_precondition(grading >= 0 && grading < internal::Axis_box_3::infinity());
  }

  /*!
   * \brief takes the surface from points and triangles.
   *
   * \tparam PointRange a range of `Point_3` with random access
   * \tparam TriangleRange a range of index triples; indices of points count from 0
   * \param points the points
   * \param triangles the triangles, in any order and orientation
   * \param grading the largest growth of sizes per length, without unit
   * \pre `grading` is not negative, and finite. All indices of the triangles name points.
   */
  template <typename PointRange, typename TriangleRange>
  Surface_sizing_field_3(const PointRange& points, const TriangleRange& triangles,
                         const double grading = default_grading)
    : m_sizes(internal::sites_of_surface(internal::sized_surface(points, triangles), grading), grading)
  {
    CGAL_precondition(grading >= 0 && grading < internal::Axis_box_3::infinity());
  }

  /// returns the size at `p`.
  FT operator()(const Point_3& p) const { return m_sizes(internal::coordinates_of(p)); }

  /// returns the size at `p`, which is the same for all dimensions and indices.
  template <typename AnyIndex>
  FT operator()(const Point_3& p, const int /* dimension */, const AnyIndex& /* index */) const { return (*this)(p); }

  /// returns a lower bound of the sizes within a distance `radius` of `p`: the smallest one.
  FT least_size_around(const Point_3& p, const double radius, const int /* index */) const
  {
    return m_sizes.around(internal::coordinates_of(p), radius);
  }

  /// returns the largest growth of sizes per length.
  double grading() const { return m_sizes.grading(); }

private:
  internal::Cone_minimum_3 m_sizes;
};

} // namespace CGAL::Boundary_recovery_3

#endif // CGAL_BOUNDARY_RECOVERY_3_SURFACE_SIZING_FIELD_3_H

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

#include <CGAL/Boundary_recovery_3/internal/sizing/Cone_minimum_3.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/surface_sizes.h>

#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief a size field that continues the sizes of a surface: at each vertex of the surface the mean length of its edges
 * there, carried into space, where sizes grow with the distance.
 *
 * The size at a point `p` is the smallest \f$ h_q + g |pq| \f$ of all vertices `q` of the surface, where \f$ h_q \f$ is
 * the size of the surface at `q`, and `g` is the *grading*. Hence no size is larger than another one plus `g` times the
 * distance.
 *
 * The size of the surface at `q` is the mean length \f$ m_q \f$ of its edges there, unless `q` belongs to a few small
 * triangles on a coarse surface, as isosurfaces have them. To see that, a triangle first has the mean length of its
 * edges; then a vertex has the mean of its triangles, weighted by area, a triangle the mean of its vertices, and a
 * vertex again the mean of its triangles, \f$ a_q \f$. If \f$ a_q > (1 + g) m_q \f$, that is, if the surface grows
 * faster than sizes may over the length of an edge, \f$ a_q \f$ is the size. Vertices without edges, edges without
 * length and triangles without area do not count. If nothing does, the size is infinite, which no mesh can have.
 *
 * Sizes are computed in floating point numbers, and depend on `p` alone. Several threads may ask at the same time.
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

  /*!
   * \brief takes the surface from the indices in the cells of a triangulation: facets for which `is_facet_on_surface()`
   * is true, or the two cells at which have different values of `subdomain_index()`.
   *
   * The triangulation is not used afterwards.
   *
   * \param tr the triangulation; its cells are models of `MeshCellBase_3`, as far as these functions go
   * \param grading by how much sizes grow per length, without unit; 0.3 by default
   * \pre `grading` is not negative, and finite.
   */
  explicit Surface_sizing_field_3(const Tr& tr, const double grading = internal::default_surface_grading)
    : Surface_sizing_field_3(tr, grading, std::vector<std::array<typename Tr::Vertex_handle, 2> >())
  { }

  /*!
   * \brief takes the surface from the indices in the cells of a triangulation, and counts other edges as well, such as
   * constrained ones that no facet has.
   *
   * \tparam VertexPairRange a range of pairs `e` of vertices `e[0]` and `e[1]`
   * \param tr the triangulation; see above
   * \param grading by how much sizes grow per length, without unit
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
   * \tparam TriangleRange a range of triples of numbers of points, from 0
   * \param points the points
   * \param triangles the triangles; neither their orientation nor their order matters
   * \param grading by how much sizes grow per length, without unit; 0.3 by default
   * \pre `grading` is not negative, and finite. All points that the triangles name are there.
   */
  template <typename PointRange, typename TriangleRange>
  Surface_sizing_field_3(const PointRange& points, const TriangleRange& triangles,
                         const double grading = internal::default_surface_grading)
    : m_sizes(internal::sites_of_surface(internal::sized_surface(points, triangles), grading), grading)
  {
    CGAL_precondition(grading >= 0 && grading < internal::Axis_box_3::infinity());
  }

  /// returns the size at `p`.
  FT operator()(const Point_3& p) const { return m_sizes(internal::coordinates_of(p)); }

  /// returns the size at `p`, which is the same for all dimensions and indices.
  template <typename AnyIndex>
  FT operator()(const Point_3& p, const int /* dimension */, const AnyIndex& /* index */) const { return (*this)(p); }

  /// returns a number that no size within a distance `radius` of `p` is below: the smallest one.
  FT least_size_around(const Point_3& p, const double radius, const int /* index */) const
  {
    return m_sizes.around(internal::coordinates_of(p), radius);
  }

  /// returns by how much sizes grow per length, at most.
  double grading() const { return m_sizes.grading(); }

private:
  internal::Cone_minimum_3 m_sizes;
};

} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_SURFACE_SIZING_FIELD_3_H

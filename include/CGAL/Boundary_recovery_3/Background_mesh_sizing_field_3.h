// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_BACKGROUND_MESH_SIZING_FIELD_3_H
#define CGAL_BOUNDARY_RECOVERY_3_BACKGROUND_MESH_SIZING_FIELD_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Background_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Tetrahedra_incidences_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Mesh_interpolation_3.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3 {
namespace internal {

/*
 * Makes sizes at the vertices of a mesh smaller where they grow along an edge by more than `grading` times its length.
 * The smallest one of all sizes is final, and so on: each vertex is settled once, as in a search for shortest paths.
 */
inline void grade_sizes(const std::vector<Coordinates_3>& points,
                        const std::vector<std::array<std::size_t, 4> >& tetrahedra,
                        const double grading, std::vector<double>& sizes)
{
  typedef std::pair<double, std::size_t> Sized_vertex;
  const Tetrahedra_incidences_3 incidences(points.size(), tetrahedra);
  std::vector<Sized_vertex> all;
  for(std::size_t v = 0; v < points.size(); ++v)
    all.emplace_back(sizes[v], v);
  std::priority_queue<Sized_vertex, std::vector<Sized_vertex>, std::greater<Sized_vertex> >
    queue(std::greater<Sized_vertex>(), std::move(all));
  while(! queue.empty())
  {
    const double size = queue.top().first;
    const std::size_t v = queue.top().second;
    queue.pop();
    if(size > sizes[v])
      continue; // it was made smaller meanwhile
    for(const std::size_t c : incidences.cells(v))
      for(const std::size_t w : tetrahedra[c])
      {
        const Coordinates_3 d = difference(points[v], points[w]);
        const double carried = size + grading * std::hypot(d[0], d[1], d[2]);
        if(carried < sizes[w])
          queue.emplace(sizes[w] = carried, w);
      }
  }
}

} // namespace internal

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief a size field that interpolates the sizes at the vertices of a tetrahedral mesh.
 *
 * Inside a tetrahedron, sizes are interpolated linearly. Where tetrahedra overlap, as in a soup, the smallest size
 * wins. Tetrahedra without volume are ignored. Outside the mesh, the nearest point of its boundary counts; the boundary
 * consists of the facets of only one tetrahedron. Hence all sizes are between the smallest and the largest size of the
 * vertices. If the mesh is not valid, all sizes are NaN; if no tetrahedron has a volume, all sizes are infinite. No
 * mesh can have such sizes.
 *
 * With a *grading*, sizes at vertices are reduced, from small to large, until no size grows along an edge of the mesh
 * by more than the grading times the length of the edge. Between the vertices of thin cells, sizes can grow faster.
 * Hence the field has no member function `grading()`, but it has `least_size_around()`, a bound for the sizes near a
 * place.
 *
 * Sizes are computed in floating point numbers, and depend on the point only. Several threads may call the field at the
 * same time.
 *
 * \tparam GT the geometric traits
 *
 * \cgalModels{MeshDomainField_3}
 */
template <typename GT>
class Background_mesh_sizing_field_3
{
public:
  typedef double                FT;      ///< the number type of sizes
  typedef typename GT::Point_3  Point_3; ///< the point type
  typedef int                   Index;   ///< the type of the number of a region
  typedef Background_mesh_3<GT> Mesh;    ///< the type of the mesh

  /*!
   * \brief makes the field of a mesh. The mesh is not used after the construction.
   *
   * \param mesh the mesh
   * \param grading the largest growth of sizes per length along edges, without unit; infinity: no limit
   */
  explicit Background_mesh_sizing_field_3(const Mesh& mesh,
                                          const double grading = std::numeric_limits<double>::infinity())
    : m_is_valid(mesh.is_valid() && grading >= 0),
      m_interpolation(make_interpolation(m_is_valid ? mesh : Mesh(), grading))
  { }

  /// returns whether the mesh is valid, and the grading is not negative.
  bool is_valid() const { return m_is_valid; }

  /// returns the size at `p`.
  FT operator()(const Point_3& p) const
  {
    return m_is_valid ? m_interpolation(internal::coordinates_of(p)) : std::numeric_limits<double>::quiet_NaN();
  }

  /// returns the size at `p`, which is the same for all dimensions and indices.
  template <typename AnyIndex>
  FT operator()(const Point_3& p, const int /* dimension */, const AnyIndex& /* index */) const { return (*this)(p); }

  /// returns a lower bound of the sizes within a distance `radius` of `p`. The smaller the radius, the nearer is the
  /// bound to the size at `p`.
  FT least_size_around(const Point_3& p, const double radius, const int /* index */) const
  {
    return m_is_valid ? m_interpolation.least_around(internal::coordinates_of(p), radius)
                      : std::numeric_limits<double>::quiet_NaN();
  }

private:
  static internal::Mesh_interpolation_3 make_interpolation(const Mesh& mesh, const double grading)
  {
    std::vector<internal::Coordinates_3> points;
    points.reserve(mesh.points.size());
    for(const Point_3& p : mesh.points)
      points.push_back(internal::coordinates_of(p));
    std::vector<double> sizes = mesh.sizes;
    if(grading < std::numeric_limits<double>::infinity())
      internal::grade_sizes(points, mesh.tetrahedra, grading, sizes);
    return internal::Mesh_interpolation_3(points, mesh.tetrahedra, sizes);
  }

  bool m_is_valid;
  internal::Mesh_interpolation_3 m_interpolation;
};

} // namespace CGAL::Boundary_recovery_3

#endif // CGAL_BOUNDARY_RECOVERY_3_BACKGROUND_MESH_SIZING_FIELD_3_H

// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_SOURCE_SIZING_FIELD_3_H
#define CGAL_BOUNDARY_RECOVERY_3_SOURCE_SIZING_FIELD_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Size_source_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Source_minimum_3.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief a size field of sources: the size at a point is the smallest one of all sources there, and of the background.
 *
 * Sources may be anywhere, also outside of the domain. If one of them, or the background, is not valid, no size is:
 * they are all NaN, which no mesh can have. If there is no source, and no background, sizes are infinite, as bad.
 *
 * Sizes are computed in floating point numbers, and depend on the point alone. Several threads may ask at the same
 * time.
 *
 * \tparam GT the geometric traits
 *
 * \cgalModels{MeshDomainField_3}
 *
 * \sa `read_size_sources()`
 */
template <typename GT>
class Source_sizing_field_3
{
public:
  typedef double               FT;      ///< the number type of sizes
  typedef typename GT::Point_3 Point_3; ///< the point type
  typedef int                  Index;   ///< the type of the number of a region
  typedef Size_source_3<GT>    Source;  ///< the type of sources

  /*!
   * \brief makes the field of some sources.
   *
   * \param sources the sources
   * \param background a size that is nowhere exceeded, in the unit of the coordinates; infinity for none
   */
  explicit Source_sizing_field_3(const std::vector<Source>& sources,
                                 const double background = std::numeric_limits<double>::infinity())
    : m_is_valid(background > 0 && std::all_of(sources.begin(), sources.end(),
                                               [](const Source& source) { return source.is_valid(); })),
      m_sizes(m_is_valid ? sources : std::vector<Source>(), background)
  { }

  /// returns whether all sources are valid, and the background is positive.
  bool is_valid() const { return m_is_valid; }

  /// returns the size at `p`.
  FT operator()(const Point_3& p) const
  {
    return m_is_valid ? m_sizes(internal::coordinates_of(p)) : std::numeric_limits<double>::quiet_NaN();
  }

  /// returns the size at `p`, which is the same for all dimensions and indices.
  template <typename AnyIndex>
  FT operator()(const Point_3& p, const int /* dimension */, const AnyIndex& /* index */) const { return (*this)(p); }

  /// returns a number that no size within a distance `radius` of `p` is below: the smallest one.
  FT least_size_around(const Point_3& p, const double radius, const int /* index */) const
  {
    return m_is_valid ? m_sizes.around(internal::coordinates_of(p), radius) : std::numeric_limits<double>::quiet_NaN();
  }

  /// returns by how much sizes grow per length, at most; infinity if some double, and there is no background.
  double grading() const { return m_sizes.grading(); }

private:
  bool m_is_valid;
  internal::Source_minimum_3<GT> m_sizes;
};

} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_SOURCE_SIZING_FIELD_3_H

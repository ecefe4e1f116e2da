// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_BOUNDED_SIZING_FIELD_3_H
#define CGAL_BOUNDARY_RECOVERY_3_BOUNDED_SIZING_FIELD_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/sizing/Size_query_3.h>

#include <algorithm>

namespace CGAL {
namespace Boundary_recovery_3 {

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief a size field with the sizes of another one, but none below or above two bounds.
 *
 * Sizes that are not positive, or NaN, stay as they are, so that they are noticed.
 *
 * \tparam GT the geometric traits
 * \tparam Field a function of a point, a model of `MeshDomainField_3` whose indices can be made of numbers, or a
 *         `std::reference_wrapper` of one. It is copied.
 *
 * \cgalModels{MeshDomainField_3}
 */
template <typename GT, typename Field>
class Bounded_sizing_field_3
{
public:
  typedef double               FT;      ///< the number type of sizes
  typedef typename GT::Point_3 Point_3; ///< the point type
  typedef int                  Index;   ///< the type of the number of a region

  /*!
   * \param field the field
   * \param lower the smallest size, in the unit of the coordinates; 0 for any
   * \param upper the largest size, infinity for any. It wins if it is below `lower`.
   */
  Bounded_sizing_field_3(const Field& field, const double lower, const double upper)
    : m_field(field), m_lower(lower), m_upper(upper)
  { }

  /// returns the size at `p`.
  FT operator()(const Point_3& p, const int dimension, const Index& index) const
  {
    const double size = internal::size_of_field<GT>(m_field, p, dimension, index);
    return size > 0 ? (std::min)((std::max)(size, m_lower), m_upper) : size;
  }

  /// returns a number that no size within a distance `radius` of `p` is below, 0 if the field does not tell.
  FT least_size_around(const Point_3& p, const double radius, const int index) const
  {
    const double least = internal::least_size_of_field_around<GT>(m_field, p, radius, index);
    return least > 0 ? (std::min)((std::max)(least, m_lower), m_upper) : 0;
  }

  /// returns by how much sizes grow per length, at most; infinity if the field does not tell.
  double grading() const { return internal::grading_of_field<GT>(m_field); }

private:
  Field m_field;
  double m_lower;
  double m_upper;
};

/// \ingroup PkgBoundaryRecovery3Functions
/// returns a size field between bounds, with a copy of the field; pass `std::cref(field)` for a field that is large.
template <typename GT, typename Field>
Bounded_sizing_field_3<GT, Field> make_bounded_sizing_field(const Field& field, const double lower, const double upper)
{
  return Bounded_sizing_field_3<GT, Field>(field, lower, upper);
}

} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_BOUNDED_SIZING_FIELD_3_H

// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_MINIMUM_SIZING_FIELD_3_H
#define CGAL_BOUNDARY_RECOVERY_3_MINIMUM_SIZING_FIELD_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/sizing/Size_query_3.h>

#include <algorithm>
#include <limits>
#include <tuple>

namespace CGAL {
namespace Boundary_recovery_3 {

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief a size field that is the minimum of other ones.
 *
 * Where one of them has a size that is not positive, or NaN, the minimum has it, too.
 *
 * \tparam GT the geometric traits
 * \tparam Fields number types, functions of a point, models of `MeshDomainField_3` whose indices can be made of
 *         numbers, or `std::reference_wrapper`s of such. They are copied.
 *
 * \cgalModels{MeshDomainField_3}
 *
 * \sa `make_minimum_sizing_field()`
 */
template <typename GT, typename ... Fields>
class Minimum_sizing_field_3
{
public:
  typedef double               FT;      ///< the number type of sizes
  typedef typename GT::Point_3 Point_3; ///< the point type
  typedef int                  Index;   ///< the type of the number of a region

  /// makes the minimum of some fields.
  explicit Minimum_sizing_field_3(const Fields& ... fields) : m_fields(fields...) { }

  /// returns the size at `p`.
  FT operator()(const Point_3& p, const int dimension, const Index& index) const
  {
    double smallest = std::numeric_limits<double>::infinity();
    const auto add = [&](const double size)
    {
      if(! (size >= smallest)) // NaN is less than all
        smallest = size;
      return smallest > 0;
    };
    const auto add_all = [&](const Fields& ... fields)
    {
      return (add(internal::size_of_field<GT>(fields, p, dimension, index)) && ...);
    };
    std::apply(add_all, m_fields);
    return smallest;
  }

  /// returns a number that no size within a distance `radius` of `p` is below, 0 if one of the fields does not tell.
  FT least_size_around(const Point_3& p, const double radius, const int index) const
  {
    const auto smallest = [&](const Fields& ... fields)
    {
      return (std::min)({ std::numeric_limits<double>::infinity(),
                          internal::least_size_of_field_around<GT>(fields, p, radius, index)... });
    };
    return std::apply(smallest, m_fields);
  }

  /// returns by how much sizes grow per length, at most; infinity if one of the fields does not tell.
  double grading() const
  {
    const auto largest = [](const Fields& ... fields)
    {
      return (std::max)({ 0., internal::grading_of_field<GT>(fields)... });
    };
    return std::apply(largest, m_fields);
  }

private:
  std::tuple<Fields...> m_fields;
};

/// \ingroup PkgBoundaryRecovery3Functions
/// returns the minimum of some size fields, with copies of them; pass `std::cref(field)` for one that is large.
template <typename GT, typename ... Fields>
Minimum_sizing_field_3<GT, Fields...> make_minimum_sizing_field(const Fields& ... fields)
{
  return Minimum_sizing_field_3<GT, Fields...>(fields...);
}

} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_MINIMUM_SIZING_FIELD_3_H

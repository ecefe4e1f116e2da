// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_REGION_SIZING_FIELD_3_H
#define CGAL_BOUNDARY_RECOVERY_3_REGION_SIZING_FIELD_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/sizing/Size_query_3.h>

#include <algorithm>
#include <functional>
#include <map>

namespace CGAL {
namespace Boundary_recovery_3 {

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief a size field that asks another one in each region of the domain.
 *
 * Fields are numbers, functions of a point, models of `MeshDomainField_3` whose indices can be made of numbers, or
 * `std::reference_wrapper`s of such. They are copied.
 *
 * \tparam GT the geometric traits
 *
 * \cgalModels{MeshDomainField_3}
 */
template <typename GT>
class Region_sizing_field_3
{
public:
  typedef double               FT;      ///< the number type of sizes
  typedef typename GT::Point_3 Point_3; ///< the point type
  typedef int                  Index;   ///< the type of the number of a region

  /// makes a field with the same sizes in all regions, as long as `set_field()` is not called.
  template <typename Field>
  explicit Region_sizing_field_3(const Field& field) : m_default(make_part(field)) { }

  /// sets the sizes in a region.
  template <typename Field>
  void set_field(const int region, const Field& field) { m_parts[region] = make_part(field); }

  /// returns the size at `p` in the region `index`. On the surface, where `dimension` is not 3, it is the smallest size
  /// of all regions, as there the index is not one of a region.
  FT operator()(const Point_3& p, const int dimension, const Index& index) const
  {
    if(dimension == 3)
    {
      const auto found = m_parts.find(index);
      return (found != m_parts.end() ? found->second : m_default).size(p, dimension, index);
    }
    double smallest = m_default.size(p, dimension, index);
    for(const auto& part : m_parts)
      smallest = (std::min)(smallest, part.second.size(p, dimension, index));
    return smallest;
  }

  /// returns a number that no size within a distance `radius` of `p` is below in the region `index`, 0 if the field
  /// there does not tell.
  FT least_size_around(const Point_3& p, const double radius, const int index) const
  {
    const auto found = m_parts.find(index);
    return (found != m_parts.end() ? found->second : m_default).least_size(p, radius, index);
  }

  /// returns by how much sizes grow per length inside of a region, at most; infinity if one of the fields does not
  /// tell.
  double grading() const
  {
    double largest = m_default.grading;
    for(const auto& part : m_parts)
      largest = (std::max)(largest, part.second.grading);
    return largest;
  }

private:
  struct Part
  {
    std::function<double(const Point_3&, int, int)> size;
    std::function<double(const Point_3&, double, int)> least_size;
    double grading;
  };

  template <typename Field>
  static Part make_part(const Field& field)
  {
    const auto size = [field](const Point_3& p, const int dimension, const int index)
    {
      return internal::size_of_field<GT>(field, p, dimension, index);
    };
    const auto least_size = [field](const Point_3& p, const double radius, const int index)
    {
      return internal::least_size_of_field_around<GT>(field, p, radius, index);
    };
    return Part{ size, least_size, internal::grading_of_field<GT>(field) };
  }

  Part m_default;
  std::map<int, Part> m_parts;
};

} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_REGION_SIZING_FIELD_3_H

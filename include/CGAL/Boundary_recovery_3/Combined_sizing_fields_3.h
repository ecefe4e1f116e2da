// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_COMBINED_SIZING_FIELDS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_COMBINED_SIZING_FIELDS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/sizing/Size_query_3.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <tuple>

namespace CGAL::Boundary_recovery_3 {

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief a size field: at each place the smallest size of several fields.
 *
 * A size that is not positive, or NaN, of one field is the size of the minimum, too.
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

  /// makes the minimum of the given fields.
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

  /// returns a lower bound of the sizes within a distance `radius` of `p`; 0 if one of the fields has no bound.
  FT least_size_around(const Point_3& p, const double radius, const int index) const
  {
    const auto smallest = [&](const Fields& ... fields)
    {
      return (std::min)({ std::numeric_limits<double>::infinity(),
                          internal::least_size_of_field_around<GT>(fields, p, radius, index)... });
    };
    return std::apply(smallest, m_fields);
  }

  /// returns the largest growth of sizes per length; infinity if one of the fields has none.
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
/// returns the minimum of size fields. The fields are copied; pass `std::cref(field)` for a large one.
template <typename GT, typename ... Fields>
Minimum_sizing_field_3<GT, Fields...> make_minimum_sizing_field(const Fields& ... fields)
{
  return Minimum_sizing_field_3<GT, Fields...>(fields...);
}

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief a size field: the sizes of another field, between two bounds.
 *
 * Sizes that are not positive, or NaN, stay as they are, so that the error is noticed.
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
   * \param lower the smallest size, in the unit of the coordinates; 0: no bound
   * \param upper the largest size; infinity: no bound. `upper` wins if it is below `lower`.
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

  /// returns a lower bound of the sizes within a distance `radius` of `p`; 0 if the field has no bound.
  FT least_size_around(const Point_3& p, const double radius, const int index) const
  {
    const double least = internal::least_size_of_field_around<GT>(m_field, p, radius, index);
    return least > 0 ? (std::min)((std::max)(least, m_lower), m_upper) : 0;
  }

  /// returns the largest growth of sizes per length; infinity if the field has none.
  double grading() const { return internal::grading_of_field<GT>(m_field); }

private:
  Field m_field;
  double m_lower;
  double m_upper;
};

/// \ingroup PkgBoundaryRecovery3Functions
/// returns a size field between bounds. The field is copied; pass `std::cref(field)` for a large one.
template <typename GT, typename Field>
Bounded_sizing_field_3<GT, Field> make_bounded_sizing_field(const Field& field, const double lower, const double upper)
{
  return Bounded_sizing_field_3<GT, Field>(field, lower, upper);
}

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief a size field with a field of its own for each region of the domain.
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

  /// makes a field with the same sizes in all regions, until `set_field()` is called.
  template <typename Field>
  explicit Region_sizing_field_3(const Field& field) : m_default(make_part(field)) { }

  /// sets the sizes in a region.
  template <typename Field>
  void set_field(const int region, const Field& field) { m_parts[region] = make_part(field); }

  /// returns the size at `p` in the region `index`. If `dimension` is not 3, `p` is on the surface, and the index is
  /// not that of a region; the size is then the smallest one of all regions.
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

  /// returns a lower bound of the sizes in the region `index` within a distance `radius` of `p`; 0 if the field of the
  /// region has no bound.
  FT least_size_around(const Point_3& p, const double radius, const int index) const
  {
    const auto found = m_parts.find(index);
    return (found != m_parts.end() ? found->second : m_default).least_size(p, radius, index);
  }

  /// returns the largest growth of sizes per length inside a region; infinity if one of the fields has none.
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

} // namespace CGAL::Boundary_recovery_3

#endif // CGAL_BOUNDARY_RECOVERY_3_COMBINED_SIZING_FIELDS_3_H

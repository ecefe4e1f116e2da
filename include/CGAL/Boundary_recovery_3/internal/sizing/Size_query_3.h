// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIZING_SIZE_QUERY_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIZING_SIZE_QUERY_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_constrained_mesh_result_3.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <functional>
#include <limits>
#include <type_traits>
#include <utility>

namespace CGAL::Boundary_recovery_3::internal {

// What a size field is, as far as its type tells how to ask it.
enum class Size_field_kind
{
  number,       // the same size everywhere
  domain_field, // f(p, dimension, index), and the index is a number, or made of one where the function is called
  index_field,  // the same, but the index has to be made of the number beforehand
  function,     // f(p)
  none          // nothing of this
};

// Whether a field names a type of indices that can be made of numbers, by a conversion that has to be asked for.
template <typename Field, typename Point, typename = void>
struct Is_index_field : std::false_type { };

template <typename Field, typename Point>
struct Is_index_field<Field, Point, std::void_t<typename Field::Index> >
  : std::conjunction<std::is_constructible<typename Field::Index, int>,
                     std::is_invocable<const Field&, const Point&, int, const typename Field::Index&> >
{ };

template <typename Field, typename Point, typename FT>
constexpr Size_field_kind size_field_kind()
{
  if constexpr(std::is_invocable_v<const Field&, const Point&, int, int>)
    return Size_field_kind::domain_field;
  else if constexpr(Is_index_field<Field, Point>::value)
    return Size_field_kind::index_field;
  else if constexpr(std::is_invocable_v<const Field&, const Point&>)
    return Size_field_kind::function;
  else if constexpr(std::is_arithmetic_v<Field> || std::is_convertible_v<const Field&, FT>)
    return Size_field_kind::number;
  else
    return Size_field_kind::none;
}

// Whether a field has a member function `grading()`, as ours have.
template <typename Field, typename = void>
struct Has_grading : std::false_type { };

template <typename Field>
struct Has_grading<Field, std::void_t<decltype(double(std::declval<const Field&>().grading()))> > : std::true_type { };

// By how much the sizes of a field grow per length, at most; infinite if nobody knows.
template <typename Point, typename FT, typename Field>
double grading_of(const Field& field)
{
  if constexpr(size_field_kind<Field, Point, FT>() == Size_field_kind::number)
    return 0;
  else if constexpr(Has_grading<Field>::value)
    return field.grading();
  else
    return std::numeric_limits<double>::infinity();
}

// The size that a field has at a place, as the nearest floating point number.
template <typename FT, typename Field, typename Point>
double size_at(const Field& field, const Point& p, const int dimension, const int index)
{
  static constexpr Size_field_kind kind = size_field_kind<Field, Point, FT>();
  static_assert(kind != Size_field_kind::none,
                "a size field is a number, a function f(p), or a model of MeshDomainField_3, f(p, dimension, index)");
  if constexpr(kind == Size_field_kind::number)
    return CGAL::to_double(std::conditional_t<std::is_arithmetic_v<Field>, Field, FT>(field));
  else if constexpr(kind == Size_field_kind::domain_field)
    return CGAL::to_double(field(p, dimension, index));
  else if constexpr(kind == Size_field_kind::index_field)
    return CGAL::to_double(field(p, dimension, typename Field::Index(index)));
  else
    return CGAL::to_double(field(p));
}

// Whether a field has a member function `least_size_around()`, as ours have.
template <typename Field, typename Point, typename = void>
struct Has_least_size_around : std::false_type { };

template <typename Field, typename Point>
struct Has_least_size_around<Field, Point, std::void_t<decltype(double(std::declval<const Field&>().least_size_around(
                                             std::declval<const Point&>(), 0., 0)))> >
  : std::true_type { };

// A number that no size of a field within a distance of a place is below; 0 if nobody knows.
template <typename FT, typename Field, typename Point>
double least_size_around(const Field& field, const Point& p, const double radius, const int index)
{
  if constexpr(Has_least_size_around<Field, Point>::value)
    return field.least_size_around(p, radius, index);
  else
  {
    const double grading = grading_of<Point, FT>(field);
    return grading < std::numeric_limits<double>::infinity()
         ? (std::max)(0., size_at<FT>(field, p, 3, index) - grading * radius) // 0 also if there is no size
         : 0;
  }
}

// What is behind a reference wrapper.
template <typename Field>
struct Unwrapped_field { typedef Field type; };

template <typename Field>
struct Unwrapped_field<std::reference_wrapper<Field> > { typedef std::remove_const_t<Field> type; };

// The same for a field, or a reference wrapper of one.
template <typename GT, typename Field>
double size_of_field(const Field& field, const typename GT::Point_3& p, const int dimension, const int index)
{
  const typename Unwrapped_field<Field>::type& unwrapped = field;
  return size_at<typename GT::FT>(unwrapped, p, dimension, index);
}

template <typename GT, typename Field>
double grading_of_field(const Field& field)
{
  const typename Unwrapped_field<Field>::type& unwrapped = field;
  return grading_of<typename GT::Point_3, typename GT::FT>(unwrapped);
}

template <typename GT, typename Field>
double least_size_of_field_around(const Field& field, const typename GT::Point_3& p, const double radius,
                                  const int index)
{
  const typename Unwrapped_field<Field>::type& unwrapped = field;
  return least_size_around<typename GT::FT>(unwrapped, p, radius, index);
}

/*
 * A size field as everything below the entry functions knows it: the type of the caller's field is no parameter of
 * templates there.
 */
template <typename Point_3>
class Size_field_3
{
public:
  virtual ~Size_field_3() = default;

  // The size at a place, whatever the caller returns for it.
  virtual double operator()(const Point_3& p, int dimension, int index) const = 0;

  // A number that no size within a distance of a place is below; 0 if nobody knows.
  virtual double least_size_around(const Point_3& p, double radius, int index) const = 0;

  // By how much the sizes grow per length, at most; infinite if nobody knows.
  virtual double grading() const = 0;

  // Whether all sizes are the same number.
  virtual bool is_constant() const { return false; }

  // Whether the field tells bounds of its sizes better than by its grading.
  virtual bool tells_least_sizes() const { return false; }
};

// Hands on all questions to a size field of another type, of whatever kind, or to what such a wrapper refers to. It
// keeps a reference to the field only.
template <typename GT, typename SizingField>
class Any_size_field_3 final
  : public Size_field_3<typename GT::Point_3>
{
public:
  typedef typename GT::Point_3                        Point_3;
  typedef typename GT::FT                             FT;
  typedef typename Unwrapped_field<SizingField>::type Field;

  explicit Any_size_field_3(const SizingField& field) : m_field(field) { }

  double operator()(const Point_3& p, const int dimension, const int index) const override
  {
    return internal::size_at<FT>(m_field, p, dimension, index);
  }

  double least_size_around(const Point_3& p, const double radius, const int index) const override
  {
    return internal::least_size_around<FT>(m_field, p, radius, index);
  }

  double grading() const override { return internal::grading_of<Point_3, FT>(m_field); }

  bool is_constant() const override { return size_field_kind<Field, Point_3, FT>() == Size_field_kind::number; }

  bool tells_least_sizes() const override { return Has_least_size_around<Field, Point_3>::value; }

private:
  const Field& m_field;
};

/*
 * Asks a size field, and watches what it answers.
 *
 * A field may return anything, and may throw. The first place where there is no size is remembered, and from then on
 * the field is not asked again: all sizes are NaN, and the work ends with what is known about that place.
 */
template <typename Tr>
class Size_query_3
{
public:
  typedef typename Tr::Geom_traits::Point_3 Point_3;
  typedef typename Tr::Geom_traits::FT      FT;
  typedef Size_field_3<Point_3>             Field;

  // It keeps a reference to the field only.
  explicit Size_query_3(const Field& field)
    : m_field(&field), m_grading(field.grading()), m_is_constant(field.is_constant())
  { }

  bool is_constant() const { return m_is_constant; }
  bool tells_least_sizes() const { return m_field->tells_least_sizes(); }

  // The size at p; NaN if there is none here, or was none somewhere before.
  double operator()(const Point_3& p, const int dimension, const int index)
  {
    if(! m_is_valid)
      return std::numeric_limits<double>::quiet_NaN();
    ++m_number_of_queries;
    return m_scale == 1 ? check(p, ask(p, dimension, index)) : scaled_size(p, dimension, index);
  }

  // A number that no size within a distance of p is below; 0 if nobody knows, or if the field throws, as it will where
  // sizes are asked.
  double least_size_around(const Point_3& p, const double radius, const int index)
  {
    ++m_number_of_queries;
    try
    {
      return m_scale * m_field->least_size_around(place_in_field(p), radius / m_scale, index);
    }
    catch(...)
    {
      return 0;
    }
  }

  // From now on, places and sizes are larger by this power of two than the field knows them.
  void set_scale(const double scale) { m_scale = scale; }

  // Whether the field had a size wherever it was asked.
  bool is_valid() const { return m_is_valid; }

  // The first place where it had none.
  const Invalid_size_3<Point_3>& invalid_size() const { return m_invalid; }

  // By how much the sizes grow per length, at most: 0 for a number, infinity if the field does not tell.
  double grading() const { return m_grading; }

  std::size_t number_of_queries() const { return m_number_of_queries; }

private:
  Point_3 place_in_field(const Point_3& p) const
  {
    const FT f(1 / m_scale);
    return m_scale == 1 ? p : Point_3(p.x() * f, p.y() * f, p.z() * f);
  }

  // The largest number stays what it is, since it has a meaning of its own; no other size leaves the range of numbers.
  double scaled_size(const Point_3& p, const int dimension, const int index)
  {
    typedef std::numeric_limits<double> Limits;
    const Point_3 q = place_in_field(p);
    const double size = check(q, ask(q, dimension, index));
    return size < (Limits::max)() ? (std::max)((Limits::min)(), (std::min)((Limits::max)(), size * m_scale)) : size;
  }

  // NaN if the field throws.
  double ask(const Point_3& p, const int dimension, const int index)
  {
    try
    {
      return (*m_field)(p, dimension, index);
    }
    catch(const std::exception& e)
    {
      m_invalid.message = e.what();
    }
    catch(...)
    { }
    return std::numeric_limits<double>::quiet_NaN();
  }

  double check(const Point_3& p, const double size)
  {
    if(size > 0 && size < std::numeric_limits<double>::infinity())
      return size;
    m_is_valid = false;
    m_invalid.point = p;
    m_invalid.size = size;
    return std::numeric_limits<double>::quiet_NaN();
  }

  const Field* m_field;
  double m_grading;
  bool m_is_constant;
  double m_scale = 1;
  bool m_is_valid = true;
  Invalid_size_3<Point_3> m_invalid = Invalid_size_3<Point_3>();
  std::size_t m_number_of_queries = 0;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIZING_SIZE_QUERY_3_H

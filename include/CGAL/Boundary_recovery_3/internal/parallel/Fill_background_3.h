// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_FILL_BACKGROUND_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_FILL_BACKGROUND_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/filling/Field_point_insertion_3.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Size_query_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Fills a domain coarsely: what is divided into sub-domains then. The smaller these are, the finer it has to be, for
 * seams are about as thick as its cells.
 */
template <typename Tr, typename SizingField>
class Fill_background_3
{
public:
  Fill_background_3(const SizingField& size, const double forecast_of_cells, const std::size_t number_of_subdomains)
    : m_field{ size, coarseness(forecast_of_cells, number_of_subdomains) }
  { }

  template <typename Domain, typename Visitor>
  Field_points_result_3<Tr> operator()(Tr& tr, Domain& domain, Visitor& visitor,
                                       const std::size_t max_number_of_vertices, const double seconds_left) const
  {
    Field_point_insertion_3<Tr, Domain, Coarse_field, Visitor> insertion(tr, domain, m_field, visitor,
                                                                         Forecast_effort::none);
    insertion.ignore_sizes_of_walls();
    insertion.leave_sizes_of_field();
    return insertion(max_number_of_vertices, seconds_left);
  }

private:
  // See "Tuning constants" in the manual.
  static constexpr double background_coarseness = 8;
  static constexpr double background_cells_per_subdomain = 1000;

  struct Coarse_field
  {
    double operator()(const typename Tr::Geom_traits::Point_3& p, const int dimension, const int index) const
    {
      return factor * internal::size_of_field<typename Tr::Geom_traits>(field, p, dimension, index);
    }

    double least_size_around(const typename Tr::Geom_traits::Point_3& p, const double radius, const int index) const
    {
      return factor * internal::least_size_of_field_around<typename Tr::Geom_traits>(field, p, radius, index);
    }

    double grading() const { return factor * internal::grading_of_field<typename Tr::Geom_traits>(field); }

    const SizingField& field;
    double factor;
  };

  static double coarseness(const double forecast_of_cells, const std::size_t number_of_subdomains)
  {
    const double number = background_cells_per_subdomain * static_cast<double>(number_of_subdomains);
    return (std::max)(1., (std::min)(background_coarseness, std::cbrt(forecast_of_cells / number)));
  }

  const Coarse_field m_field;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_FILL_BACKGROUND_3_H

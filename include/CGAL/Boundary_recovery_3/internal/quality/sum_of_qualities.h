// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_SUM_OF_QUALITIES_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_SUM_OF_QUALITIES_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Mesh_quality_3.h>
#include <CGAL/Boundary_recovery_3/Quality_improvement_result_3.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

// That of a mesh whose cells are those of all these meshes together.
inline Mesh_quality_3 sum_of_qualities(const std::vector<Mesh_quality_3>& qualities)
{
  Mesh_quality_3 sum;
  double radius_ratios = 0, edges_in_size = 0;
  for(const Mesh_quality_3& q : qualities)
  {
    if(q.number_of_cells == 0)
      continue;
    if(sum.number_of_cells == 0)
    {
      sum.min_dihedral_angle = q.min_dihedral_angle;
      sum.max_dihedral_angle = q.max_dihedral_angle;
      sum.min_radius_ratio = q.min_radius_ratio;
    }
    sum.min_dihedral_angle = (std::min)(sum.min_dihedral_angle, q.min_dihedral_angle);
    sum.max_dihedral_angle = (std::max)(sum.max_dihedral_angle, q.max_dihedral_angle);
    sum.min_radius_ratio = (std::min)(sum.min_radius_ratio, q.min_radius_ratio);
    sum.number_of_cells += q.number_of_cells;
    sum.number_of_sized_edges += q.number_of_sized_edges;
    for(std::size_t i = 0; i < sum.numbers_of_cells_below.size(); ++i)
      sum.numbers_of_cells_below[i] += q.numbers_of_cells_below[i];
    for(std::size_t i = 0; i < sum.numbers_of_cells_above.size(); ++i)
      sum.numbers_of_cells_above[i] += q.numbers_of_cells_above[i];
    for(std::size_t i = 0; i < sum.histogram.size(); ++i)
      sum.histogram[i] += q.histogram[i];
    radius_ratios += q.mean_radius_ratio * static_cast<double>(q.number_of_cells);
    if(q.number_of_sized_edges > 0)
      edges_in_size += q.share_of_edges_in_size * static_cast<double>(q.number_of_sized_edges);
  }
  if(sum.number_of_cells > 0)
    sum.mean_radius_ratio = radius_ratios / static_cast<double>(sum.number_of_cells);
  if(sum.number_of_sized_edges > 0)
    sum.share_of_edges_in_size = edges_in_size / static_cast<double>(sum.number_of_sized_edges);
  return sum;
}

// If there was no time for them, the result says so.
template <typename Tr>
void set_last_figures(Quality_improvement_result_3<Tr>& result, const std::optional<Mesh_quality_3>& figures)
{
  result.is_measured = bool(figures);
  if(figures)
    result.after = *figures;
}

// What was changed elsewhere at the same time: there are as many rounds as where there are most.
inline void add_counts(Quality_improvement_counts& sum, const Quality_improvement_counts& counts)
{
  sum.number_of_rounds = (std::max)(sum.number_of_rounds, counts.number_of_rounds);
  sum.number_of_removed_edges += counts.number_of_removed_edges;
  sum.number_of_removed_facets += counts.number_of_removed_facets;
  sum.number_of_moved_vertices += counts.number_of_moved_vertices;
  sum.number_of_inserted_points += counts.number_of_inserted_points;
  sum.number_of_removed_vertices += counts.number_of_removed_vertices;
}

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_SUM_OF_QUALITIES_H

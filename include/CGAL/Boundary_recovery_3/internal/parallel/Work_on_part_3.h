// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_WORK_ON_PART_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_WORK_ON_PART_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Quality_improvement_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Field_point_insertion_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Ordinary_scale_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Mesh_part_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Part_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Seam_part_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Seams_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Improve_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Measure_quality_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Cell_shape_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/distances_3.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Vertex_sizes_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

// What is done at the same time: the parts, or zones of cells around their seams, are filled, and maybe improved.
struct Subdomain_round
{
  bool works_on_parts() const { return number_of_parts == 1; }
  bool repairs() const { return number_of_parts == 0; }

  // What is bad for good is better not cut.
  std::size_t max_number_of_connected_vertices() const
  {
    return repairs() && improves ? std::size_t(-1) : Seams_3<>::max_number_of_connected_vertices;
  }

  // Cells with smaller angles are improved once more in the end. See "Tuning constants" in the manual.
  static constexpr double angle_to_be_repaired = 20;

  std::size_t number_of_parts; // that meet in a zone; 1: the parts themselves; 0: zones are around what is repaired
  int         number_of_layers;
  bool        improves;
};

// The parts, then their seams. In the end, what is not as it should be where parts or zones met is done again, without
// anything near it that has to stay; and so is what is not where the zones of that met.
inline std::vector<Subdomain_round> rounds_with_repairs(const int layers_at_seams, const int layers_of_repairs,
                                                        const bool improve)
{
  constexpr int number_of_repairs = 3;
  std::vector<Subdomain_round> rounds;
  for(std::size_t number_of_parts = 1; number_of_parts <= Seams_3<>::last_round; ++number_of_parts)
    rounds.push_back({ number_of_parts, layers_at_seams, improve });
  rounds.insert(rounds.end(), number_of_repairs, { 0, layers_of_repairs, improve });
  return rounds;
}

inline std::vector<Subdomain_round> filling_rounds()
{
  constexpr int layers_to_be_filled = 3;
  return rounds_with_repairs(layers_to_be_filled, layers_to_be_filled, false);
}

inline std::vector<Subdomain_round> improving_rounds()
{
  constexpr int layers_to_be_improved = 2;
  constexpr int layers_to_be_repaired = 4;
  return rounds_with_repairs(layers_to_be_improved, layers_to_be_repaired, true);
}

// How many new vertices each task of a round may have, so that all together are not more than `number`.
inline std::vector<std::size_t> shares_of_vertices(const std::size_t number, const std::vector<std::size_t>& weights)
{
  const std::size_t sum = std::accumulate(weights.begin(), weights.end(), std::size_t(0));
  std::vector<std::size_t> shares;
  for(const std::size_t weight : weights) // no overflow while the cells of all tasks times those of one are below 2^64
    shares.push_back(number / sum * weight + number % sum * weight / sum);
  return shares;
}

// What is told of the work on a part of a mesh.
template <typename Tr>
struct Part_report_3
{
  Field_points_result_3<Tr>  filling;
  std::optional<Mesh_quality_3> before; // the improvement; only in its first round, if there was time
  Quality_improvement_counts counts;
  bool                       is_stopped = false;
  bool                       was_full = false; // vertices were not inserted, for there may be no more
};

/*
 * Steps 6 and 7 for a part of a mesh. What the part becomes depends on nothing else but the round, so it does not
 * matter who does it, or when.
 */
template <typename Tr, typename Quality>
class Work_on_part_3
{
public:
  typedef Mesh_part_3<Tr>   Part;
  typedef Part_report_3<Tr> Report;
  typedef Size_field_3<typename Tr::Geom_traits::Point_3> Size_field;

  Work_on_part_3(const Size_field& size, const Quality& quality, const double min_dihedral_angle,
                 const Improvement_effort effort)
    : m_size(size), m_quality(quality), m_min_dihedral_angle(min_dihedral_angle), m_effort(effort)
  { }

  // New vertices get numbers from the first one that is free. There are so many vertices more at most; a round that
  // improves does without others.
  Report operator()(Part& part, const Subdomain_round& round, const std::size_t first_new_number,
                    const std::size_t max_number_of_new_vertices, Mesh_visitor_3<Tr>& visitor,
                    const double seconds_left) const
  {
    Part_triangulation_3<Tr> triangulation(std::move(part));
    Tr& tr = triangulation.triangulation();
    Domain domain = internal::domain_of_part(tr, triangulation.constrained_edges());
    const std::size_t max_number = (std::max)(max_number_of_new_vertices,
                                              tr.number_of_vertices() + max_number_of_new_vertices); // no overflow
    Report report;
    report.filling = filled(tr, domain, round, max_number, visitor, seconds_left);
    report.was_full = report.filling.status == Meshing_status::too_large;
    if(round.improves)
    {
      if(report.was_full)
        report.filling.status = Meshing_status::meshed;
      improve(tr, domain, round, max_number, visitor, seconds_left, report);
    }
    part = triangulation.part(first_new_number);
    return report;
  }

  // What is told of a part if the work has been stopped, so that it stays as it is.
  static Report stopped(const Subdomain_round& round)
  {
    Report report;
    report.is_stopped = true;
    if(! round.improves)
      report.filling.status = Meshing_status::stopped;
    return report;
  }

  // What has to be known of a part to find the zones of a round.
  Seam_part_3 seam_part(const std::size_t index, const Part& part, const Subdomain_round& round) const
  {
    Seam_part_3 result(index, part);
    for(std::size_t c = 0; round.repairs() && c < part.number_of_cells(); ++c)
      if(is_where_parts_met(part, c) && (round.improves ? is_bad(part, c) : is_too_large(part, c)))
        result.add_start(part, c);
    return result;
  }

private:
  typedef Selected_domain_3<Tr> Domain;

  // Whether parts or zones met at a cell.
  static bool is_where_parts_met(const Part& part, const std::size_t cell)
  {
    return part.vertex(cell, 0).may_be_shared || part.vertex(cell, 1).may_be_shared ||
           part.vertex(cell, 2).may_be_shared || part.vertex(cell, 3).may_be_shared;
  }

  bool is_bad(const Part& part, const std::size_t cell) const
  {
    return m_quality(part.corners(cell))
             < m_quality.of_angle((std::min)(Subdomain_round::angle_to_be_repaired, m_min_dihedral_angle));
  }

  // Whether a cell is left from the background mesh: an edge is longer than any that the filling leaves. Those between
  // vertices of constraints are not looked at, for they may have to stay.
  static bool is_too_large(const Part& part, const std::size_t cell)
  {
    const auto edges = internal::tetrahedron_edges(part.corners(cell));
    return std::any_of(edges.begin(), edges.end(), [&](const Tetrahedron_edge_3& e)
    {
      const auto& u = part.vertex(cell, static_cast<std::size_t>(e.i));
      const auto& v = part.vertex(cell, static_cast<std::size_t>(e.j));
      const double size = (CGAL::to_double(u.size) + CGAL::to_double(v.size)) / 2;
      return (u.indices.dimension == 3 || v.indices.dimension == 3)
          && e.length > Length_rules::longest * size;
    });
  }

  // The walls of zones are mostly faces of cells that are as large as they should be, some a bit smaller.
  Field_points_result_3<Tr> filled(Tr& tr, Domain& domain, const Subdomain_round& round,
                                   const std::size_t max_number, Mesh_visitor_3<Tr>& visitor,
                                   const double seconds_left) const
  {
    Field_point_insertion_3<Tr> insertion(tr, domain, m_size, visitor, Forecast_effort::none);
    insertion.leave_sizes_of_field();
    if(! round.works_on_parts())
      insertion.ignore_sizes_of_walls();
    return insertion(max_number, seconds_left);
  }

  // What was left beside zones that met is filled now.
  void improve(Tr& tr, Domain& domain, const Subdomain_round& round, const std::size_t max_number,
               Mesh_visitor_3<Tr>& visitor, const double seconds_left, Report& report) const
  {
    Recovery_context<Tr> context(visitor);
    context.set_maximum_running_time(seconds_left);
    if(round.works_on_parts())
      report.before = Measure_quality_3<Tr>(tr, domain)(
        [](const typename Tr::Cell_handle, const Cell_angles_3&) { },
        [&context] { return context.can_finish_after_short_step(); });
    const Ordinary_scale_3<Tr> scale(tr);
    Improve_domain_3<Tr, Quality> improve_domain(tr, domain, m_quality, context);
    if(! round.works_on_parts())
      improve_domain.be_strict();
    // what walls of parts did to cells beside them can be mended, and there are few of these
    improve_domain.set_effort(round.works_on_parts() ? m_effort : Improvement_effort::high);
    improve_domain.set_max_number_of_vertices(max_number);
    improve_domain(m_min_dihedral_angle);
    report.counts = improve_domain.counts();
    report.is_stopped = context.is_stopped();
    report.was_full = (report.was_full || improve_domain.was_full()) && ! report.is_stopped;
  }

  const Size_field& m_size;
  const Quality m_quality;
  const double m_min_dihedral_angle;
  const Improvement_effort m_effort;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_WORK_ON_PART_3_H

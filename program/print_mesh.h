#ifndef BOUNDARY_RECOVERY_3_PROGRAM_PRINT_MESH_H
#define BOUNDARY_RECOVERY_3_PROGRAM_PRINT_MESH_H

#include "domain_quality.h"
#include "edge_lengths.h"
#include "print_improvement.h"
#include "print_summary.h"
#include "round_number.h"

#include <CGAL/Boundary_recovery_3/Boundary_constrained_mesh_result_3.h>

#include <algorithm>
#include <cstddef>
#include <iomanip>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

// prints the phases after the recovery
inline void print_meshing_phases(std::ostream& os, const std::vector<CGAL::Boundary_recovery_3::Phase_report>& phases)
{
  os << std::left << std::setw(26) << "phase" << std::right << std::setw(12) << "vertices" << std::setw(24) << "cells"
     << std::setw(22) << "seconds" << '\n';
  for(const auto& phase : phases)
    os << std::left << std::setw(26) << to_string(phase.phase) << std::right << std::setw(12)
       << phase.number_of_vertices << std::setw(24) << phase.number_of_cells << std::setw(22) << phase.seconds << '\n';
}

// prints a bar for each ten degrees, and how many tetrahedra have small or large angles
inline void print_quality(std::ostream& os, const Mesh_quality& quality)
{
  std::size_t sum = 0, largest = 1;
  for(const std::size_t n : quality.histogram)
  {
    sum += n;
    largest = (std::max)(largest, n);
  }
  os << "dihedral angles from " << quality.smallest_angle << " to " << quality.largest_angle << " degrees\n";
  for(std::size_t i = 0; i < quality.histogram.size(); ++i)
  {
    const double begin = double(i) * Mesh_quality::degrees_per_bin;
    const double share = double(quality.histogram[i]) / double((std::max)(sum, std::size_t(1)));
    os << std::setw(6) << begin << " to " << std::setw(3) << begin + Mesh_quality::degrees_per_bin << std::setw(9)
       << std::fixed << std::setprecision(2) << 100 * share << std::defaultfloat << std::setprecision(3) << " %  "
       << std::string((60 * quality.histogram[i] + largest - 1) / largest, '#') << '\n';
  }
  os << "tetrahedra with an angle ";
  for(std::size_t i = 0; i < quality.below.size(); ++i)
    os << (i == 0 ? "below " : ", ") << Mesh_quality::small_angles[i] << ": " << quality.below[i];
  for(std::size_t i = 0; i < quality.above.size(); ++i)
    os << (i == 0 ? "; above " : ", ") << Mesh_quality::large_angles[i] << ": " << quality.above[i];
  os << '\n';
}

inline void print_edges(std::ostream& os, const Edge_lengths& edges)
{
  if(edges.number_of_edges == 0)
    return;
  os << "edges inside: " << edges.number_of_edges << ", " << 100 * edges.share_in_range()
     << " % of them within [0.71, 1.41] of the size, " << edges.number_below << " shorter, " << edges.number_above
     << " longer; on average " << edges.mean() << " of it, at most " << edges.maximum << '\n';
}

// whether the tetrahedra were improved, at least for a while
template <typename Result>
bool is_improved(const Result& result)
{
  return result.improvement.before.number_of_cells > 0 || result.improvement.counts.number_of_rounds > 0;
}

// what would be too much: vertices, if there may be so many, or else the memory
template <typename Result>
std::string reason_for_too_large(const Result& result, const std::size_t max_number_of_vertices)
{
  const std::string what = "it would have about " + round_number(result.filling.forecast_of_vertices) +
                           " vertices and " + round_number(result.filling.forecast_of_cells) + " tetrahedra, ";
  const bool is_limited = max_number_of_vertices < (std::numeric_limits<std::size_t>::max)();
  if(is_limited && result.filling.forecast_of_vertices > double(max_number_of_vertices))
    return what + "and " + std::to_string(max_number_of_vertices) + " vertices are allowed";
  return what + "which do not fit into the memory";
}

// why there is no mesh of the domain, which may have so many vertices; empty if there is one
template <typename Result>
std::string reason_for_no_mesh(const Result& result, const std::size_t max_number_of_vertices)
{
  using CGAL::Boundary_recovery_3::Meshing_status;

  switch(result.status)
  {
    case Meshing_status::meshed:
      return std::string();
    case Meshing_status::no_region:
      return "the surface bounds no region";
    case Meshing_status::incomplete:
      return "the surface is not recovered, " + count(result.recovery.missing_edges.size(), "edge") + " and " +
             count(result.recovery.missing_facets.size(), "facet") + " are missing: --report lists them";
    case Meshing_status::invalid_input:
      return "the input is invalid";
    case Meshing_status::too_large:
      return reason_for_too_large(result, max_number_of_vertices);
    case Meshing_status::stopped:
      return result.number_of_regions > 0 ? std::string() : "the work was stopped before the surface was recovered";
  }
  return std::string();
}

// what is not done if the time limit ended the work, and there is a mesh; empty if all is
template <typename Result>
std::string reason_for_unfinished_mesh(const Result& result)
{
  if(result.status != CGAL::Boundary_recovery_3::Meshing_status::stopped)
    return std::string();
  return std::string("the time limit ended the work before the mesh was ") +
         (result.filling ? "improved as far as possible" : "filled");
}

// prints whether all sizes of the field were seen, unless they were
inline void print_whether_field_is_resolved(std::ostream& os, const bool is_field_resolved)
{
  if(! is_field_resolved)
    os << "small sizes between the places that were asked may have been missed\n";
}

// prints the table at the end of `mesh_surface`
template <typename Result, typename Domain>
void print_mesh(std::ostream& os, const Result& result, const Domain& domain, const Mesh_quality& quality,
                const Edge_lengths& edges, const std::vector<Bad_tetrahedron>& bad_tetrahedra, const double seconds)
{
  const std::streamsize precision = os.precision(3);
  print_phases(os, result.recovery.phases);
  print_meshing_phases(os, result.phases);
  if(! domain.tetrahedra.empty())
  {
    print_quality(os, quality);
    print_edges(os, edges);
  }
  if(is_improved(result))
    print_improvement(os, result.improvement, bad_tetrahedra, domain);
  print_whether_field_is_resolved(os, result.filling.is_field_resolved);
  if(result.number_of_subdomains > 1)
    os << result.number_of_subdomains << " sub-domains\n";
  os << to_string(result.status) << ": " << count(domain.points.size(), "point") << ", "
     << count(domain.number_of_field_points, "field point") << " and "
     << count(domain.number_of_steiner_points, "Steiner point") << " among them, and " << domain.tetrahedra.size()
     << " tetrahedra in " << count(static_cast<std::size_t>(domain.number_of_regions), "region") << "; "
     << seconds << " seconds" << std::endl;
  os.precision(precision);
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_PRINT_MESH_H

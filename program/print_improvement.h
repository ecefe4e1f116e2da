#ifndef BOUNDARY_RECOVERY_3_PROGRAM_PRINT_IMPROVEMENT_H
#define BOUNDARY_RECOVERY_3_PROGRAM_PRINT_IMPROVEMENT_H

#include "bad_tetrahedra.h"
#include "print_summary.h"

#include <CGAL/Boundary_recovery_3/Quality_improvement_result_3.h>

#include <algorithm>
#include <cstddef>
#include <ostream>
#include <vector>

// prints what makes a tetrahedron bad, and where it is
template <typename Domain>
void print_bad_tetrahedron(std::ostream& os, const Bad_tetrahedron& bad, const Domain& domain)
{
  using CGAL::Boundary_recovery_3::Bad_cell_reason;

  const auto& p = domain.points[bad.edge[0]];
  const auto& q = domain.points[bad.edge[1]];
  os << "  " << bad.min_dihedral_angle << " degrees at (" << p.x() / 2 + q.x() / 2 << ' ' << p.y() / 2 + q.y() / 2
     << ' ' << p.z() / 2 + q.z() / 2 << ')';
  if(bad.reason == Bad_cell_reason::forced)
    os << ", forced: triangles of the surface meet at " << bad.surface_angle << " degrees";
  else if(bad.reason == Bad_cell_reason::gap)
    os << ", gap: two triangles of the surface are " << bad.distance << " apart, which allows no more than "
       << bad.surface_angle << " degrees";
  else if(bad.reason == Bad_cell_reason::needle)
    os << ", needle: a triangle of the surface has an angle of " << bad.surface_angle << " degrees";
  else if(bad.facets.size() == 2)
    os << ", not improved: flat on two triangles of the surface that meet at " << bad.surface_angle << " degrees";
  else if(! bad.facets.empty())
    os << ", not improved: a triangle beside it has an angle of " << bad.surface_angle << " degrees";
  os << '\n';
}

// whether a needle is the reason of an angle that few solvers like
inline bool needles_matter(const std::vector<Bad_tetrahedron>& bad_tetrahedra)
{
  static constexpr double small_angle = 10;
  return std::any_of(bad_tetrahedra.begin(), bad_tetrahedra.end(), [](const Bad_tetrahedron& bad)
  {
    return bad.reason == CGAL::Boundary_recovery_3::Bad_cell_reason::needle && bad.min_dihedral_angle < small_angle;
  });
}

inline void print_remedy_for_needles(std::ostream& os, const std::vector<Bad_tetrahedron>& bad_tetrahedra)
{
  if(needles_matter(bad_tetrahedra))
    os << "needles of the surface are what stays bad: --remesh-surface replaces its triangles\n";
}

// prints what was done, how many tetrahedra are below the target for which reason, and the worst ones
template <typename Improvement, typename Domain>
void print_improvement(std::ostream& os, const Improvement& improvement,
                       const std::vector<Bad_tetrahedron>& bad_tetrahedra, const Domain& domain)
{
  using CGAL::Boundary_recovery_3::Bad_cell_reason;
  static constexpr std::size_t number_of_shown = 5;

  const auto& counts = improvement.counts;
  os << "improved";
  if(improvement.before.number_of_cells > 0)
    os << " from " << improvement.before.min_dihedral_angle << " and " << improvement.before.max_dihedral_angle
       << " degrees";
  os << ": " << count(counts.number_of_removed_edges, "edge") << " and "
     << count(counts.number_of_removed_facets, "facet") << " removed, vertices moved "
     << count(counts.number_of_moved_vertices, "time") << ", " << counts.number_of_inserted_points << " inserted and "
     << counts.number_of_removed_vertices << " removed\n";
  const auto& certificate = improvement.certificate;
  if(! certificate.is_complete)
  {
    os << "there was no time left to tell why tetrahedra are below " << certificate.min_dihedral_angle << " degrees\n";
    return;
  }
  os << "tetrahedra below " << certificate.min_dihedral_angle << " degrees: "
     << certificate.number_of_cells(Bad_cell_reason::forced) << " forced by the surface, "
     << certificate.number_of_cells(Bad_cell_reason::gap) << " in gaps of it, "
     << certificate.number_of_cells(Bad_cell_reason::needle) << " at needles of it, "
     << certificate.number_of_cells(Bad_cell_reason::not_improved) << " not improved\n";
  for(std::size_t i = 0; i < bad_tetrahedra.size() && i < number_of_shown; ++i)
    print_bad_tetrahedron(os, bad_tetrahedra[i], domain);
  if(bad_tetrahedra.size() > number_of_shown)
    os << "  and " << bad_tetrahedra.size() - number_of_shown << " more: --report lists them\n";
  print_remedy_for_needles(os, bad_tetrahedra);
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_PRINT_IMPROVEMENT_H

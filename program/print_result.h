#ifndef BOUNDARY_RECOVERY_3_PROGRAM_PRINT_RESULT_H
#define BOUNDARY_RECOVERY_3_PROGRAM_PRINT_RESULT_H

#include "bad_tetrahedra.h"
#include "domain_quality.h"
#include "edge_lengths.h"
#include "print_mesh.h"
#include "print_summary.h"
#include "surface.h"

#include <CGAL/Boundary_recovery_3/Quality_improvement_result_3.h>

#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

// Prints what a user wants to know, each in a line: what came in, and what came out. What developers want to know is in
// print_mesh.h.

// prints the size of a surface, and its patches
template <typename Point>
void print_surface(std::ostream& os, const std::string& name, const Surface<Point>& surface)
{
  static constexpr std::size_t number_of_shown = 8;

  os << name << ": " << count(surface.faces.size(), "triangle") << ", " << count(surface.points.size(), "point");
  std::size_t shown = 0;
  for(const auto& [number, patch] : surface.patch_names)
    if(shown++ < number_of_shown)
      os << (shown == 1 ? "; " + count(surface.patch_names.size(), "named patch", "named patches") + ": " : ", ")
         << patch;
  os << (shown > number_of_shown ? ", ..." : "") << std::endl;
}

// how many tetrahedra stay bad, for which reasons, and where the worst one is
template <typename Improvement, typename Domain>
void print_bad_tetrahedra(std::ostream& os, const Improvement& improvement, const std::vector<Bad_tetrahedron>& bad,
                          const Domain& domain)
{
  using CGAL::Boundary_recovery_3::Bad_cell_reason;
  static constexpr std::pair<Bad_cell_reason, const char*> reasons[] = {
    { Bad_cell_reason::forced, "forced by the surface" }, { Bad_cell_reason::gap, "in gaps of the surface" },
    { Bad_cell_reason::needle, "at needles of the surface" }, { Bad_cell_reason::not_improved, "not improved" } };
  const auto& certificate = improvement.certificate;
  if(! certificate.is_complete)
    return print_improvement(os, improvement, bad, domain);
  os << "below " << certificate.min_dihedral_angle << " degrees: " << certificate.cells.size();
  for(const auto& [reason, words] : reasons)
    if(certificate.number_of_cells(reason) > 0)
      os << ", " << certificate.number_of_cells(reason) << ' ' << words;
  os << '\n';
  if(bad.empty())
    return;
  os << "the worst one:";
  print_bad_tetrahedron(os, bad[0], domain);
  print_remedy_for_needles(os, bad);
}

// prints a mesh, its angles, lengths and what stays bad, and how long it took
template <typename Result, typename Domain>
void print_result(std::ostream& os, const Result& result, const Domain& domain, const Mesh_quality& quality,
                  const Edge_lengths& edges, const std::vector<Bad_tetrahedron>& bad, const double seconds)
{
  const std::streamsize precision = os.precision(3);
  os << "mesh: " << count(domain.tetrahedra.size(), "tetrahedron", "tetrahedra") << " in "
     << count(static_cast<std::size_t>(domain.number_of_regions), "region") << ", "
     << count(domain.points.size(), "point") << ": "
     << domain.number_of_field_points + domain.number_of_steiner_points << " added inside";
  if(domain.number_of_steiner_points > 0)
    os << ", " << domain.number_of_steiner_points << " of them to keep the surface";
  os << '\n';
  if(! domain.tetrahedra.empty())
    os << "dihedral angles: from " << quality.smallest_angle << " to " << quality.largest_angle << " degrees\n";
  if(is_improved(result))
    print_bad_tetrahedra(os, result.improvement, bad, domain);
  if(edges.number_of_edges > 0)
    os << "edges inside: " << std::round(100 * edges.share_in_range())
       << " % are as long as was asked for, within a factor of 1.41\n";
  print_whether_field_is_resolved(os, result.filling.is_field_resolved);
  os << to_string(result.status) << " in " << seconds << " seconds" << std::endl;
  os.precision(precision);
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_PRINT_RESULT_H

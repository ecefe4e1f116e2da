#ifndef BOUNDARY_RECOVERY_3_PROGRAM_REPORT_REMESHING_H
#define BOUNDARY_RECOVERY_3_PROGRAM_REPORT_REMESHING_H

#include "print_summary.h"
#include "surface_changes.h"
#include "write_report.h"

#include <algorithm>
#include <array>
#include <ostream>
#include <string>

// prints what became of the triangles
inline void print_remeshing(std::ostream& os, const Remeshing_changes& changes)
{
  os << "remeshing of the surface: ";
  if(! changes.is_possible)
    os << "nothing is done, as the surface is not valid" << std::endl;
  else if(changes.is_too_fine)
    os << "nothing is done, as edges of " << changes.largest_edge << " would be too many" << std::endl;
  else if(! changes.is_remeshed)
    os << "nothing is done, as what came out was not valid in " << count(changes.number_of_attempts, "attempt")
       << std::endl;
  if(! changes.is_remeshed)
    return;
  os << count(changes.number_of_triangles[0], "triangle") << " with angles of at least " << changes.smallest_angle[0]
     << " degrees became " << changes.number_of_triangles[1] << " with at least " << changes.smallest_angle[1]
     << "\n  the old and the new surface are at most "
     << (std::max)(changes.distances[0], changes.distances[1]) << " from each other; " << changes.tolerance
     << " is allowed\n";
  if(changes.number_of_kept_triangles > 0)
    os << "  " << count(changes.number_of_kept_triangles, "triangle")
       << " had to stay: others would intersect, or be too far away\n";
  os.flush();
}

// writes the same
inline void write_remeshing(Json_writer& json, const Remeshing_changes& changes)
{
  json.key("remeshing");
  json.begin('{');
  json.entry("is_possible", changes.is_possible);
  json.entry("is_too_fine", changes.is_too_fine);
  json.entry("is_remeshed", changes.is_remeshed);
  json.entry("tolerance", changes.tolerance);
  json.entry("largest_edge", changes.largest_edge);
  json.entry("number_of_attempts", changes.number_of_attempts);
  json.before_and_after("number_of_triangles", changes.number_of_triangles);
  json.before_and_after("smallest_angle_of_triangles", changes.smallest_angle);
  json.entry("distance_to_input", changes.distances[0]);
  json.entry("distance_from_input", changes.distances[1]);
  json.entry("number_of_kept_triangles", changes.number_of_kept_triangles);
  json.end('}');
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_REPORT_REMESHING_H

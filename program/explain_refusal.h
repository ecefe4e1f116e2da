#ifndef BOUNDARY_RECOVERY_3_PROGRAM_EXPLAIN_REFUSAL_H
#define BOUNDARY_RECOVERY_3_PROGRAM_EXPLAIN_REFUSAL_H

#include "can_resolve_intersections.h"
#include "command_line.h"
#include "open_surface.h"
#include "print_summary.h"

#include <CGAL/Boundary_recovery_3/enumerations.h>
#include <CGAL/version.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <ostream>
#include <string>

typedef CGAL::Boundary_recovery_3::Input_defect_kind Defect_kind;

// whether a repair looks for defects of that kind at all
inline bool is_repairable(const Defect_kind kind)
{
  return kind == Defect_kind::degenerate_facet || kind == Defect_kind::duplicate_facet ||
         kind == Defect_kind::intersecting_constraints;
}

// how many defects there are of each kind that is listed
template <typename Result>
std::map<Defect_kind, std::size_t> count_defects(const Result& result)
{
  std::map<Defect_kind, std::size_t> numbers;
  for(const auto& defect : result.defects)
    ++numbers[defect.kind];
  return numbers;
}

// prints how many defects there are, of which kinds, and examples
template <typename Result>
void print_defects(std::ostream& os, const Result& result)
{
  const std::size_t n = result.number_of_defects, listed = result.defects.size();
  const std::size_t shown = (std::min)(listed, number_of_examples);
  os << "invalid input, " << (n > listed ? "at least " : "") << count(n, "defect");
  std::string separator = ": ";
  for(const auto& kind : count_defects(result))
  {
    os << separator << kind.second << ' ' << kind.first;
    separator = ", ";
  }
  os << '\n';
  for(std::size_t i = 0; i < shown; ++i)
    os << "  " << result.defects[i] << '\n';
  if(n > shown)
    os << "  and " << n - shown << " more: --report lists " << (n > listed ? "the first " + std::to_string(listed)
                                                                         : std::string("all of them")) << '\n';
}

// prints which option may help against the defects
template <typename Result>
void print_remedy(std::ostream& os, const Result& result, const Common_options& options)
{
  const std::map<Defect_kind, std::size_t> numbers = count_defects(result);
  if(numbers.count(Defect_kind::not_a_triangle) > 0 && ! options.repair)
    os << "--repair divides polygons that are not flat\n";
  else if(! std::all_of(numbers.begin(), numbers.end(), [](const auto& kind) { return is_repairable(kind.first); }))
    os << "the file has to be corrected: no option does that\n";
  else
  {
    os << (options.repair ? "--repair was not enough; a larger --tolerance may help" : "--repair may help");
    if(numbers.count(Defect_kind::intersecting_constraints) > 0 && ! can_resolve_intersections)
      os << "; with CGAL 6.0 or later it also divides triangles that intersect, but this program is compiled with CGAL "
         << CGAL_VERSION_STR;
    os << '\n';
  }
}

// prints where a surface ends that bounds nothing, and which option may help
inline void print_open_surface(std::ostream& os, const Open_surface& open, const Common_options& options)
{
  print_loops(os, open.boundary);
  if(open.boundary.loops.empty())
    return;
  if(options.max_hole_length >= 0)
    os << "--close-holes leaves these open: --report tells why\n";
  else
    os << "--close-holes may help, or " << (options.repair ? "a larger --tolerance" : "--repair")
       << " where points that should be equal are a little apart\n";
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_EXPLAIN_REFUSAL_H

#ifndef BOUNDARY_RECOVERY_3_PROGRAM_REPORT_HOLES_H
#define BOUNDARY_RECOVERY_3_PROGRAM_REPORT_HOLES_H

#include "open_surface.h"
#include "print_summary.h"
#include "surface.h"
#include "surface_changes.h"
#include "write_report.h"

#include <cstddef>
#include <ostream>
#include <vector>

// prints what was added, and the longest loops that stay open, with the reason
inline void print_holes(std::ostream& os, const std::vector<Hole>& holes)
{
  std::size_t number_closed = 0, number_of_triangles = 0;
  for(const Hole& hole : holes)
    if(hole.state == Hole_state::closed)
    {
      ++number_closed;
      number_of_triangles += hole.triangles.size();
    }
  os << "holes: " << count(number_closed, "loop") << " closed, by " << count(number_of_triangles, "triangle") << '\n';
  std::size_t number_open = holes.size() - number_closed, shown = 0;
  for(const Hole& hole : holes)
    if(hole.state != Hole_state::closed && shown++ < number_of_examples)
    {
      print_loop(os, hole.loop);
      os << "    stays open: " << to_string(hole.state) << '\n';
    }
  if(number_open > number_of_examples)
    os << "  and " << number_open - number_of_examples << " more stay open: --report lists all of them\n";
  os.flush();
}

template <typename Point>
void write_holes(Json_writer& json, const std::vector<Hole>& holes, const Surface<Point>& surface)
{
  json.key("holes");
  json.objects(holes, [&](const Hole& hole)
  {
    write_loop(json, hole.loop, surface);
    json.entry("state", to_string(hole.state));
    json.entry("number_of_added_triangles", hole.state == Hole_state::closed ? hole.triangles.size() : std::size_t(0));
  });
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_REPORT_HOLES_H

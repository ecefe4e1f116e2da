#ifndef BOUNDARY_RECOVERY_3_PROGRAM_PRINT_SUMMARY_H
#define BOUNDARY_RECOVERY_3_PROGRAM_PRINT_SUMMARY_H

#include "domain_quality.h"

#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>
#include <CGAL/Boundary_recovery_3/Meshing_visitor_3.h>

#include <cstddef>
#include <iomanip>
#include <ostream>
#include <string>
#include <vector>

// prints a line when a phase ends
class Progress_printer
  : public CGAL::Default_meshing_visitor_3
{
  std::ostream& m_os;
  bool m_is_on;

public:
  Progress_printer(std::ostream& os, const bool is_on) : m_os(os), m_is_on(is_on) { }

  void on_phase_end(const CGAL::Boundary_recovery_3::Phase_report& phase)
  {
    if(m_is_on)
      m_os << "... " << to_string(phase.phase) << ": " << phase.lost_edges << " edges and "
           << phase.lost_facets << " facets are lost, " << phase.seconds << " s" << std::endl;
  }
};

// how long the call took, and how long without the Delaunay insertion
struct Seconds
{
  double total;
  double recovery;
};

// The phases are not all: before points are added, the input is proved to be valid.
inline Seconds make_seconds(const double total, const std::vector<CGAL::Boundary_recovery_3::Phase_report>& phases)
{
  Seconds seconds = { total, total };
  for(const auto& phase : phases)
    if(phase.phase == CGAL::Boundary_recovery_3::Phase::insertion)
      seconds.recovery -= phase.seconds;
  return seconds;
}

// prints what was lost after each phase, and how many that phase recovered; a negative number of these means that the
// triangulation was put back, since points did not do
inline void print_phases(std::ostream& os, const std::vector<CGAL::Boundary_recovery_3::Phase_report>& phases)
{
  using CGAL::Boundary_recovery_3::Phase;

  const auto difference = [](const std::size_t before, const std::size_t after)
  { return static_cast<long long>(before) - static_cast<long long>(after); };

  os << std::left << std::setw(26) << "phase" << std::right << std::setw(12) << "lost edges" << std::setw(11)
     << "recovered" << std::setw(13) << "lost facets" << std::setw(11) << "recovered" << std::setw(11)
     << "seconds" << '\n';
  const CGAL::Boundary_recovery_3::Phase_report* before = nullptr;
  for(const auto& phase : phases)
  {
    if(phase.phase == Phase::insertion) // nothing has been searched yet
    {
      os << std::left << std::setw(26) << to_string(phase.phase) << std::right << std::setw(58) << phase.seconds
         << '\n';
      continue;
    }
    os << std::left << std::setw(26) << to_string(phase.phase) << std::right
       << std::setw(12) << phase.lost_edges
       << std::setw(11) << (before ? difference(before->lost_edges, phase.lost_edges) : 0)
       << std::setw(13) << phase.lost_facets
       << std::setw(11) << (before ? difference(before->lost_facets, phase.lost_facets) : 0)
       << std::setw(11) << phase.seconds << '\n';
    before = &phase;
  }
}

// prints the tables of [CZZ+17, Section 5.1.2]
inline void print_levels(std::ostream& os,
                         const std::vector<CGAL::Boundary_recovery_3::Recursion_level_report>& levels)
{
  os << std::left << std::setw(26) << "phase" << std::right << std::setw(6) << "l_max" << std::setw(9) << "n1"
     << std::setw(9) << "n2" << std::setw(9) << "n3" << std::setw(9) << "n4" << '\n';
  for(const auto& level : levels)
  {
    os << std::left << std::setw(26) << to_string(level.phase) << std::right << std::setw(6);
    if(level.max_recursion_level < 0)
      os << "start";
    else
      os << level.max_recursion_level;
    os << std::setw(9) << level.n1 << std::setw(9) << level.n2 << std::setw(9) << level.n3
       << std::setw(9) << level.n4 << '\n';
  }
}

// a number and what it counts
inline std::string count(const std::size_t n, const std::string& noun, const std::string& plural)
{
  return std::to_string(n) + ' ' + (n == 1 ? noun : plural);
}

inline std::string count(const std::size_t n, const std::string& noun) { return count(n, noun, noun + 's'); }

// prints the table at the end of the program
template <typename Result, typename Domain>
void print_summary(std::ostream& os, const Result& result, const Domain& domain,
                   const Mesh_quality& quality, const Seconds& seconds)
{
  const std::streamsize precision = os.precision(3);
  print_phases(os, result.phases);
  os << to_string(result.status) << ": " << result.missing_edges.size() << " of " << result.number_of_edges
     << " edges and " << result.missing_facets.size() << " of " << result.number_of_facets << " facets are missing\n";
  if(! result.unrepresentable_constraints.empty())
    os << count(result.unrepresentable_constraints.size(), "constraint")
       << " would take points for which there are no floating point numbers: --report lists them\n";
  os << "Steiner points: " << result.number_of_constraint_points << " put on constraints, "
     << result.number_of_steiner_points << " after splitting, " << result.steiner_vertices.size() << " left, "
     << domain.number_of_steiner_points << " of them in the domain\n"
     << "mesh: " << count(domain.points.size(), "point") << ", " << domain.tetrahedra.size() << " tetrahedra in "
     << count(static_cast<std::size_t>(domain.number_of_regions), "region") << '\n';
  if(domain.is_convex_hull)
    os << "no region can be told from the outside: the tetrahedra are those of the convex hull\n";
  os << "dihedral angles from " << quality.smallest_angle << " to " << quality.largest_angle << " degrees, "
     << seconds.total << " seconds, " << seconds.recovery
     << " of them for the recovery" << std::endl;
  os.precision(precision);
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_PRINT_SUMMARY_H

#ifndef BOUNDARY_RECOVERY_3_PROGRAM_PROGRESS_BAR_H
#define BOUNDARY_RECOVERY_3_PROGRAM_PROGRESS_BAR_H

#include "round_number.h"

#include <CGAL/Boundary_recovery_3/Meshing_visitor_3.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <ostream>
#include <string>

// Draws a bar for the phase that runs, on a terminal, and takes it away when the phase ends. What takes less than a
// blink is not shown.
class Progress_bar
  : public CGAL::Default_meshing_visitor_3
{
  typedef std::chrono::steady_clock Clock;

  static constexpr std::size_t width = 40;
  static constexpr std::chrono::milliseconds pause{100};

  std::ostream& m_os;
  const bool m_is_quiet;
  const bool m_is_on;
  Clock::time_point m_last = Clock::now(); // when the line was changed last
  std::size_t m_length = 0;                // of what stands in the line

public:
  Progress_bar(std::ostream& os, const bool is_quiet, const bool is_terminal)
    : m_os(os), m_is_quiet(is_quiet), m_is_on(! is_quiet && is_terminal)
  { }

  // The forecast is told at once, on a terminal or not.
  void on_phase_end(const CGAL::Boundary_recovery_3::Phase_report& report)
  {
    clear();
    if(report.phase == CGAL::Boundary_recovery_3::Phase::forecast && ! m_is_quiet)
      m_os << "about " << round_number(double(report.number_of_cells)) << " tetrahedra are to be expected" << std::endl;
  }

  void on_progress(const CGAL::Boundary_recovery_3::Phase phase, const std::size_t done, const std::size_t total)
  {
    if(! m_is_on || total == 0 || Clock::now() - m_last < pause)
      return;
    const double share = (std::min)(double(done) / double(total), 1.);
    const std::size_t filled = static_cast<std::size_t>(width * share);
    show(to_string(phase) + (" [" + std::string(filled, '#')) + std::string(width - filled, '.') + "] " +
         std::to_string(static_cast<int>(100 * share)) + " %");
  }

private:
  void clear() { show(std::string()); }

  void show(const std::string& line)
  {
    const std::size_t rest = m_length > line.size() ? m_length - line.size() : 0;
    if(! line.empty() || m_length > 0)
      m_os << '\r' << line << std::string(rest, ' ') << (line.empty() ? "\r" : "") << std::flush;
    m_length = line.size();
    m_last = Clock::now();
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_PROGRESS_BAR_H

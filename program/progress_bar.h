#ifndef BOUNDARY_RECOVERY_3_PROGRAM_PROGRESS_BAR_H
#define BOUNDARY_RECOVERY_3_PROGRAM_PROGRESS_BAR_H

#include "interruption.h"
#include "terminal.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <ostream>
#include <string>

// One line of a terminal that tells what is done, and which share of all. Before anything else is printed, it has to be
// cleared. What takes less than a blink is not shown.
class Progress_bar
{
  typedef std::chrono::steady_clock Clock;

  static constexpr std::size_t longest_bar = 40;
  static constexpr std::size_t length_of_words = 12, length_of_number = 11; // with blanks, brackets and ^C
  static constexpr std::chrono::milliseconds pause{50};

  std::ostream& m_os;
  const bool m_is_on;
  Clock::time_point m_last = Clock::now(); // when the line was changed last
  std::size_t m_length = 0;                // of what stands in the line

public:
  // `is_on` says whether there is anybody to look at it
  Progress_bar(std::ostream& os, const bool is_on) : m_os(os), m_is_on(is_on) { }
  ~Progress_bar() { clear(); }

  // whether it is time to draw it again
  bool is_due() const { return m_is_on && Clock::now() - m_last >= pause; }

  void draw(const std::string& words, const double share)
  {
    if(! m_is_on)
      return;
    const std::size_t bar = length_of_bar(), filled = static_cast<std::size_t>(double(bar) * share);
    std::string line = words + std::string(words.size() < length_of_words ? length_of_words - words.size() : 1, ' ');
    if(bar > 0)
      line += '[' + std::string(filled, '#') + std::string(bar - filled, '.') + "] ";
    show(line + std::to_string(static_cast<int>(100 * share)) + " %");
  }

  void clear()
  {
    if(m_length > 0)
      show(std::string());
  }

private:
  // such that the line is shorter than that of the terminal
  static std::size_t length_of_bar()
  {
    const std::size_t columns = terminal_columns(), others = length_of_words + length_of_number;
    return columns > others ? (std::min)(longest_bar, columns - others) : 0;
  }

  void show(const std::string& line)
  {
    const std::size_t rest = m_length > line.size() ? m_length - line.size() : 0;
    Interruption::length_of_line = (std::max)(m_length, line.size());
    m_os << '\r' << line << std::string(rest, ' ') << (line.empty() ? "\r" : "") << std::flush;
    m_length = line.size();
    Interruption::length_of_line = m_length;
    m_last = Clock::now();
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_PROGRESS_BAR_H

#ifndef BOUNDARY_RECOVERY_3_PROGRAM_PROGRESS_BAR_H
#define BOUNDARY_RECOVERY_3_PROGRAM_PROGRESS_BAR_H

#include "interruption.h"
#include "terminal.h"

#include <algorithm>
#include <cstddef>
#include <ostream>
#include <string>

// One line of a terminal that tells what is done, and which share of all. Before anything else is printed, it has to be
// cleared.
class Progress_bar
{
  static constexpr std::size_t longest_bar = 40;
  static constexpr std::size_t length_of_words = 12, length_of_number = 11; // with blanks, brackets and ^C

  std::ostream& m_os;
  std::size_t m_length = 0; // of what stands in the line

public:
  explicit Progress_bar(std::ostream& os) : m_os(os) { }

  void draw(const std::string& words, const double share)
  {
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
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_PROGRESS_BAR_H

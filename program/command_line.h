#ifndef BOUNDARY_RECOVERY_3_PROGRAM_COMMAND_LINE_H
#define BOUNDARY_RECOVERY_3_PROGRAM_COMMAND_LINE_H

#include "read_surface.h"
#include "write_domain.h"

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

// What the user of any of the programs may ask for.
struct Common_options
{
  std::string input;                // empty: the default surface
  std::vector<std::string> outputs;
  std::string report;
  double time_limit = (std::numeric_limits<double>::infinity)();
  bool repair = false;
  double tolerance = -1;            // for the repair; -1: that of single precision
  double patch_angle = 40;          // in degrees
  bool list_defects = false;
  bool quiet = false;
  bool timing = false;
  bool help = false;
};

// Reads the arguments of a program from left to right. What only one program has is in a derived class.
class Command_line
{
  const std::vector<std::string> m_arguments;
  std::size_t m_next = 0;
  std::string m_message;
  Common_options& m_options;

public:
  Command_line(const int argc, const char* const argv[], Common_options& options)
    : m_arguments(argv + (argc > 0 ? 1 : 0), argv + argc), m_options(options)
  { }

  virtual ~Command_line() = default;

  // returns `false` if the arguments make no sense; `message()` says why
  bool parse()
  {
    while(m_message.empty() && m_next < m_arguments.size())
      parse_argument(m_arguments[m_next++]);
    if(m_message.empty() && m_options.tolerance >= 0 && ! m_options.repair)
      refuse("--tolerance is for --repair only");
    if(m_message.empty())
      check_combination();
    return m_message.empty();
  }

  const std::string& message() const { return m_message; }

protected:
  enum class Number_kind { not_negative, positive, integer };

  // takes an option that only this program has; returns `false` if it has no such option
  virtual bool parse_own_option(const std::string& option) = 0;

  // whether the program writes files of that kind, besides what all of them do
  virtual bool is_own_format(const std::string& /* extension */) { return false; }

  // refuses options that do not go together
  virtual void check_combination() { }

  void refuse(const std::string& message) { m_message = message; }

  std::string value_after(const std::string& option)
  {
    if(m_next < m_arguments.size() && ! m_arguments[m_next].empty())
      return m_arguments[m_next++];
    refuse(option + " needs a value");
    return std::string();
  }

  double number_after(const std::string& option, const Number_kind kind,
                      const double bound = (std::numeric_limits<double>::max)())
  {
    static constexpr const char* names[] = { "a number that is not negative", "a positive number",
                                             "a number that is not negative and integer" };
    const std::string text = value_after(option);
    if(! m_message.empty())
      return 0;
    char* end = nullptr;
    const double x = std::strtod(text.c_str(), &end);
    const bool good = *end == '\0' && std::isfinite(x) && x >= 0 && x <= bound &&
                      (kind != Number_kind::positive || x > 0) && (kind != Number_kind::integer || x == std::floor(x));
    if(! good)
      refuse(option + " needs " + names[static_cast<int>(kind)] + ", not " + text);
    return good ? x : 0;
  }

private:
  void parse_argument(const std::string& argument)
  {
    if(argument.empty() || argument[0] != '-')
      parse_input(argument);
    else if(! parse_common_option(argument) && ! parse_own_option(argument))
      refuse("unknown option: " + argument + " (try --help)");
  }

  bool parse_common_option(const std::string& option)
  {
    if(option == "-o")
      parse_output(option);
    else if(option == "--time-limit")
      m_options.time_limit = number_after(option, Number_kind::not_negative);
    else if(option == "--report")
      m_options.report = value_after(option);
    else if(option == "--repair")
      m_options.repair = true;
    else if(option == "--tolerance")
      m_options.tolerance = number_after(option, Number_kind::not_negative);
    else if(option == "--list-defects")
      m_options.list_defects = true;
    else if(option == "--timing")
      m_options.timing = true;
    else if(option == "--quiet")
      m_options.quiet = true;
    else if(option == "--help" || option == "-h")
      m_options.help = true;
    else
      return false;
    return true;
  }

  void parse_input(const std::string& file)
  {
    if(file.empty())
      refuse("an argument is empty (try --help)");
    else if(! m_options.input.empty())
      refuse("more than one input: " + m_options.input + " and " + file);
    else
      m_options.input = file;
  }

  void parse_output(const std::string& option)
  {
    const std::string file = value_after(option);
    const std::string extension = read_surface_internal::lower_case_extension(file);
    if(m_message.empty() && ! is_output_format(extension) && ! is_own_format(extension))
      refuse("unknown output format: " + file + " (known are " + known_output_formats + ')');
    m_options.outputs.push_back(file);
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_COMMAND_LINE_H

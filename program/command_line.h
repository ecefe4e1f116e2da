#ifndef BOUNDARY_RECOVERY_3_PROGRAM_COMMAND_LINE_H
#define BOUNDARY_RECOVERY_3_PROGRAM_COMMAND_LINE_H

#include "help_formatter.h"
#include "lower_case.h"
#include "surface.h"
#include "write_domain.h"

#include <CGAL/version.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iomanip>
#include <limits>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#ifndef BOUNDARY_RECOVERY_3_VERSION // our CMakeLists.txt tells the version of the package
#define BOUNDARY_RECOVERY_3_VERSION "unknown"
#endif

// What the user of any of the programs may ask for.
struct Common_options
{
  std::string input;                // empty: the default surface
  std::vector<std::string> outputs;
  std::string report;
  double time_limit = (std::numeric_limits<double>::infinity)();
  bool repair = false;
  double tolerance = -1;            // for the repair; -1: that of single precision
  bool fuse = false;                // as a part of the repair
  double patch_angle = default_patch_angle; // in degrees
  double max_hole_length = -1;      // of loops that are closed; negative: none is
  double largest_edge = -1;         // of the surface that is remeshed; 0: as its shape allows; negative: it stays
  bool list_defects = false;
  bool quiet = false;
  bool timing = false;
};

// what the help of each program says of its input
constexpr const char* input_text =
  "INPUT is a surface of triangles or polygons: .off, .ply, .stl, .obj, .msh, .mesh, .poly or .smesh; without it, the\n"
  "program takes a surface of its own.";

// Reads the arguments of a program by CLI11. What only one program has is in a derived class.
class Command_line
{
  CLI::App m_app;
  const std::shared_ptr<Help_formatter> m_formatter;
  Common_options& m_options;
  std::string m_message, m_text;

public:
  // `before_name` is what stands before the name of the program in a command
  Command_line(const std::string& name, const std::string& description, Common_options& options,
               const std::string& before_name = "")
    : m_app(description, name),
      m_formatter(std::make_shared<Help_formatter>(before_name + name + " [INPUT] [options]")), m_options(options)
  {
    m_app.formatter(m_formatter);
    m_app.add_option("INPUT", m_options.input)->check(is_not_empty());
  }

  virtual ~Command_line() = default;

  // returns `false` if the arguments make no sense, and `message()` says why, or if `text()` is all that is asked for
  bool parse(const int argc, const char* const argv[])
  {
    try
    {
      m_app.parse(reversed(argc, argv)); // as CLI11 wants it
      check_combination();
    }
    catch(const CLI::CallForHelp&)
    {
      m_text = m_app.help();
    }
    catch(const CLI::CallForVersion& version)
    {
      m_text = std::string(version.what()) + '\n';
    }
    catch(const CLI::Error& error)
    {
      m_message = std::string(error.what()) + " (try --help)";
    }
    return m_message.empty() && m_text.empty();
  }

  const std::string& message() const { return m_message; }
  const std::string& text() const { return m_text; }

protected:
  enum class Number_kind { not_negative, positive, integer };

  // whether the program writes files of that kind, besides what all of them do
  virtual bool is_own_format(const std::string& /* extension */) const { return false; }

  // refuses options that do not go together
  virtual void check_combination() { }

  [[noreturn]] static void refuse(const std::string& message) { throw CLI::ValidationError(message); }

  bool is_given(const std::string& option) const { return m_app.count(option) > 0; }

  void remove_option(const std::string& option) { m_app.remove_option(m_app.get_option(option)); }

  // begins a group of options, of which the help has a text
  void begin_group(const std::string& group, const std::string& text = "")
  {
    m_app.option_defaults()->group(group);
    if(! text.empty())
      m_formatter->explain_group(group, text);
  }

  void set_notes(const std::string& notes) { m_app.footer(notes); }

  CLI::Option* add_flag(const std::string& option, bool& is_set, const std::string& description)
  {
    return m_app.add_flag(option, is_set, description);
  }

  // a flag that something is not to be done
  void add_negative_flag(const std::string& option, bool& is_done, const std::string& description)
  {
    m_app.add_flag_callback(option, [&] { is_done = false; }, description);
  }

  // an option whose value the help calls `value`
  template <typename T>
  CLI::Option* add_option(const std::string& option, const std::string& value, T& result,
                          const std::string& description)
  {
    return m_app.add_option(option, result, description)->option_text(value)->check(is_not_empty());
  }

  template <typename T>
  CLI::Option* add_number(const std::string& option, const std::string& value, T& result, const Number_kind kind,
                          const std::string& description, const double bound = (std::numeric_limits<double>::max)())
  {
    return add_option(option, value, result, description)->check(is_number(kind, bound));
  }

  template <typename Enumeration>
  using Choices = std::vector<std::pair<std::string, Enumeration> >;

  template <typename Enumeration>
  CLI::Option* add_choice(const std::string& option, const Choices<Enumeration>& choices, Enumeration& result,
                          const std::string& description)
  {
    std::string names;
    for(const auto& choice : choices)
      names += (names.empty() ? "" : "|") + choice.first;
    const auto set = [option, names, choices, &result](const std::string& name)
    {
      const auto choice = std::find_if(choices.begin(), choices.end(), [&](const auto& c) { return c.first == name; });
      if(choice == choices.end())
        refuse(option + " is one of " + names);
      result = choice->second;
    };
    return m_app.add_option_function<std::string>(option, set, description)->option_text(names);
  }

  // what all programs write
  void add_output_options()
  {
    begin_group("output");
    add_option("-o", "OUTPUT", m_options.outputs,
               std::string("write the mesh: ") + known_output_formats + ";\nand by libgmsh, where it is there: "
               + formats_of_gmsh + "; may be repeated")
      ->expected(1)->take_all()->check(is_output());
  }

  void add_surface_options()
  {
    begin_group("surfaces that are not valid");
    CLI::Option* const repair =
      add_flag("--repair", m_options.repair, "merge points; drop, turn, unfold and divide triangles and polygons");
    add_number("--tolerance", "X", m_options.tolerance, Number_kind::not_negative,
               "repair: merge points whose coordinates differ by at most X, where that helps;\n"
               "without this option, X is four units in the last place of the largest coordinate\n"
               "in single precision; 0 merges none")->needs(repair);
    add_flag("--fuse", m_options.fuse,
             "repair: make one body of closed bodies that overlap: what is inside of any of them is\n"
             "inside, so bodies inside of others disappear")->needs(repair);
    add_number("--close-holes", "[LENGTH]", m_options.max_hole_length, Number_kind::not_negative,
               "close loops of open edges by triangles between their vertices: all loops, or only those\n"
               "whose edges are together at most so long; loops stay open whose triangles would cross\n"
               "the surface");
    add_flag("--list-defects", m_options.list_defects,
             "look for intersections before anything else, and mesh nothing if there are any;\n"
             "--report lists all of them");
  }

  void add_message_options()
  {
    begin_group("messages");
    add_option("--report", "FILE.json", m_options.report,
               "write a report with sizes, times, the quality of the mesh, the tetrahedra with small\n"
               "angles and their reasons, and all that is wrong or missing");
    add_flag("--timing", m_options.timing, timing_text());
    add_own_message_options();
    add_flag("--quiet", m_options.quiet,
             "print errors and limits that ended the work only, and what --timing asks for");
    const std::string version = m_app.get_name() + " " BOUNDARY_RECOVERY_3_VERSION " with CGAL " CGAL_VERSION_STR;
    m_app.set_version_flag("--version", version, "print the version");
    m_app.set_help_flag("-h,--help", "print this text");
  }

  void add_time_limit(const std::string& description)
  {
    add_number("--time-limit", "SECONDS", m_options.time_limit, Number_kind::not_negative, description);
  }

  // adds what only this program tells
  virtual void add_own_message_options() { }

private:
  // The number after some options may be left out. CLI11 would take what comes next for it.
  static std::vector<std::string> reversed(const int argc, const char* const argv[])
  {
    std::vector<std::string> arguments;
    for(int i = 1; i < argc; ++i)
    {
      arguments.push_back(argv[i]);
      const auto number = default_numbers().find(arguments.back());
      if(number != default_numbers().end() && ! (i + 1 < argc && is_like_number(argv[i + 1])))
        arguments.push_back(number->second);
    }
    std::reverse(arguments.begin(), arguments.end());
    return arguments;
  }

  static const std::map<std::string, std::string>& default_numbers()
  {
    static const std::map<std::string, std::string> numbers = { { "--close-holes", "1e308" },
                                                                { "--remesh-surface", "0" } };
    return numbers;
  }

  static bool is_like_number(const std::string& text)
  {
    char* end = nullptr;
    std::strtod(text.c_str(), &end);
    return ! text.empty() && *end == '\0';
  }

  virtual std::string timing_text() const = 0;

  static CLI::Validator is_not_empty()
  {
    return CLI::Validator([](const std::string& text) { return std::string(text.empty() ? "it is empty" : ""); }, "");
  }

  static CLI::Validator is_number(const Number_kind kind, const double bound)
  {
    const auto check = [kind, bound](const std::string& text) -> std::string
    {
      static constexpr const char* names[] = { "a number that is not negative", "a positive number",
                                               "an integer that is not negative" };
      char* end = nullptr;
      const double x = std::strtod(text.c_str(), &end);
      const bool good = *end == '\0' && ! text.empty() && std::isfinite(x) && x >= 0 && x <= bound &&
                        (kind != Number_kind::positive || x > 0) &&
                        (kind != Number_kind::integer || x == std::floor(x));
      if(good)
        return "";
      std::ostringstream os;
      os << "it needs " << names[static_cast<int>(kind)];
      if(std::isfinite(x) && x > bound)
        os << std::setprecision(16) << " and at most " << bound;
      os << ", not " << text;
      return os.str();
    };
    return CLI::Validator(check, "");
  }

  CLI::Validator is_output() const
  {
    const auto check = [this](const std::string& file) -> std::string
    {
      const std::string extension = lower_case_extension(file);
      if(is_output_format(extension) || is_own_format(extension))
        return "";
      const std::string no_gmsh = reason_for_no_gmsh();
      const std::string reason = is_format_of_gmsh(extension) ? no_gmsh : "unknown output format";
      const std::string others = no_gmsh.empty() ? std::string(", ") + formats_of_gmsh : "";
      return reason.empty() ? "" : reason + ": " + file + " (known are " + known_output_formats + others + ')';
    };
    return CLI::Validator(check, "");
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_COMMAND_LINE_H

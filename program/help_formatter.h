#ifndef BOUNDARY_RECOVERY_3_PROGRAM_HELP_FORMATTER_H
#define BOUNDARY_RECOVERY_3_PROGRAM_HELP_FORMATTER_H

#include <CLI/CLI.hpp>

#include <map>
#include <sstream>
#include <string>
#include <vector>

// Prints the help of a program with a text before each group of options; `make_man_page.py` reads it. Lines of all
// texts end where they are to end.
class Help_formatter
  : public CLI::Formatter
{
  const std::string m_usage;
  std::map<std::string, std::string> m_texts; // of groups of options

public:
  explicit Help_formatter(const std::string& usage) : m_usage(usage) { column_width(25); }

  void explain_group(const std::string& group, const std::string& text) { m_texts[group] = text; }

  std::string make_help(const CLI::App* app, std::string, CLI::AppFormatMode) const override
  {
    return "usage: " + m_usage + '\n' + app->get_description() + '\n' + make_all_groups(app) + app->get_footer() + '\n';
  }

  std::string make_all_groups(const CLI::App* app) const
  {
    std::string result;
    for(const std::string& group : app->get_groups())
      result += make_group(group, false, app->get_options([&](const CLI::Option* option)
                           { return option->get_group() == group && option->nonpositional(); }));
    return result;
  }

  // only the value: what an option needs is told in words
  std::string make_option_opts(const CLI::Option* option) const override
  {
    return option->get_option_text().empty() ? std::string() : ' ' + option->get_option_text();
  }

  std::string make_group(const std::string group, bool, const std::vector<const CLI::Option*> options) const override
  {
    const auto text = m_texts.find(group);
    std::ostringstream os;
    if(! options.empty())
      os << group << ':' << (text == m_texts.end() ? "" : ' ' + text->second) << '\n';
    for(const CLI::Option* option : options)
      os << make_option(option, false);
    return os.str();
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_HELP_FORMATTER_H

#ifndef BOUNDARY_RECOVERY_3_PROGRAM_WRITE_REPORT_H
#define BOUNDARY_RECOVERY_3_PROGRAM_WRITE_REPORT_H

#include "utf8.h"

#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>
#include <CGAL/number_utils.h>
#include <CGAL/version.h>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

// Writes JSON: objects and lists with their commas, strings that are escaped, numbers that are never NaN.
class Json_writer
{
  std::ostream& m_os;
  std::vector<bool> m_is_first; // for each open object or list: whether nothing is in it yet

public:
  explicit Json_writer(std::ostream& os) : m_os(os) { m_os.precision(17); }

  void begin(const char bracket)
  {
    m_os << bracket;
    m_is_first.push_back(true);
  }

  void end(const char bracket)
  {
    m_os << bracket;
    m_is_first.pop_back();
  }

  // goes on to the next element of a list
  void next()
  {
    if(! m_is_first.back())
      m_os << (m_is_first.size() < 3 ? ",\n " : ", ");
    m_is_first.back() = false;
  }

  // goes on to the next entry of an object
  void key(const std::string& name)
  {
    next();
    value(name);
    m_os << ": ";
  }

  void value(const double x)
  {
    if(std::isfinite(x))
      m_os << x;
    else
      m_os << "null";
  }

  void value(const std::size_t n) { m_os << n; }
  void value(const int n) { m_os << n; }

  // the largest number there is stands for none
  void number_or_null(const std::size_t n)
  {
    if(n != static_cast<std::size_t>(-1))
      value(n);
    else
      m_os << "null";
  }

  void value(const bool b) { m_os << (b ? "true" : "false"); }
  void value(const char* text) { value(std::string(text)); }

  void value(const std::string& text)
  {
    m_os << '"';
    for(const char c : as_utf8(text))
    {
      if(c == '"' || c == '\\')
        m_os << '\\' << c;
      else if(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f)
        m_os << c;
      else
      {
        char code[8];
        std::snprintf(code, sizeof(code), "\\u%04x", static_cast<unsigned int>(c));
        m_os << code;
      }
    }
    m_os << '"';
  }

  template <typename Point>
  void point(const Point& p)
  {
    begin('[');
    for(int i = 0; i < 3; ++i)
    {
      next();
      value(CGAL::to_double(p[i]));
    }
    end(']');
  }

  template <typename T>
  void entry(const std::string& name, const T& x)
  {
    key(name);
    value(x);
  }

  // two entries, with these endings of the name
  template <typename Numbers>
  void before_and_after(const std::string& name, const Numbers& numbers)
  {
    entry(name + "_before", numbers[0]);
    entry(name + "_after", numbers[1]);
  }

  // a list; `write` is called for each element
  template <typename Range, typename Write>
  void list(const Range& range, const Write& write)
  {
    begin('[');
    for(const auto& element : range)
    {
      next();
      write(element);
    }
    end(']');
  }

  // a list of objects; `write` writes the entries of each
  template <typename Range, typename Write>
  void objects(const Range& range, const Write& write)
  {
    list(range, [&](const auto& element)
    {
      begin('{');
      write(element);
      end('}');
    });
  }
};

// Writes what `recover_boundary()` returned, in the indices of the file.
template <typename Result>
class Report_writer
{
  typedef typename Result::Point_3        Point;
  typedef typename Result::Input_simplex  Input_simplex;
  typedef typename Result::Input_defect   Input_defect;

  Json_writer& m_json;

public:
  explicit Report_writer(Json_writer& json) : m_json(json) { }

  void operator()(const Result& result)
  {
    write_counts(result);
    write_phases(result);
    write_levels(result);
    m_json.key("missing_edges");
    m_json.list(result.missing_edges, [&](const Input_simplex& s) { write_simplex(s); });
    m_json.key("missing_facets");
    m_json.list(result.missing_facets, [&](const Input_simplex& s) { write_simplex(s); });
    m_json.key("unrepresentable_constraints");
    m_json.list(result.unrepresentable_constraints, [&](const Input_simplex& s) { write_simplex(s); });
    m_json.key("defects");
    m_json.objects(result.defects, [&](const Input_defect& defect)
    {
      m_json.entry("kind", to_string(defect.kind));
      m_json.key("simplices");
      m_json.list(defect.simplices, [&](const Input_simplex& s) { write_simplex(s); });
    });
    m_json.key("steiner_points");
    m_json.list(result.steiner_vertices, [&](const typename Result::Vertex_handle v) { m_json.point(v->point()); });
  }

private:
  void write_counts(const Result& result)
  {
    m_json.entry("number_of_edges", result.number_of_edges);
    m_json.entry("number_of_facets", result.number_of_facets);
    m_json.entry("number_of_defects", result.number_of_defects);
    m_json.entry("number_of_missing_edges", result.missing_edges.size());
    m_json.entry("number_of_missing_facets", result.missing_facets.size());
    m_json.entry("number_of_constraint_points", result.number_of_constraint_points);
    m_json.entry("number_of_steiner_points", result.number_of_steiner_points);
    m_json.entry("number_of_steiner_points_left", result.steiner_vertices.size());
    m_json.entry("number_of_split_edges", number_of_constraints(result.parts_of_edges));
    m_json.entry("number_of_split_facets", number_of_constraints(result.parts_of_facets));
    m_json.entry("number_of_inserted_vertices", result.number_of_inserted_vertices);
    m_json.entry("number_of_shell_transformations", result.number_of_shell_transformations);
  }

  // The parts of one constraint come one after the other.
  template <typename Parts>
  static std::size_t number_of_constraints(const Parts& parts)
  {
    std::size_t n = 0;
    for(std::size_t i = 0; i < parts.size(); ++i)
      if(i == 0 || parts[i].constraint.vertices != parts[i - 1].constraint.vertices)
        ++n;
    return n;
  }

  void write_phases(const Result& result)
  {
    m_json.key("phases");
    m_json.objects(result.phases, [&](const CGAL::Boundary_recovery_3::Phase_report& phase)
    {
      m_json.entry("name", to_string(phase.phase));
      m_json.entry("lost_edges", phase.lost_edges);
      m_json.entry("lost_facets", phase.lost_facets);
      m_json.entry("seconds", phase.seconds);
    });
  }

  void write_levels(const Result& result)
  {
    m_json.key("levels");
    m_json.objects(result.levels, [&](const CGAL::Boundary_recovery_3::Recursion_level_report& level)
    {
      m_json.entry("phase", to_string(level.phase));
      m_json.entry("max_recursion_level", level.max_recursion_level);
      m_json.entry("n1", level.n1);
      m_json.entry("n2", level.n2);
      m_json.entry("n3", level.n3);
      m_json.entry("n4", level.n4);
    });
  }

  void write_simplex(const Input_simplex& simplex)
  {
    static constexpr const char* names[] = { "vertex", "edge", "facet" };
    m_json.begin('{');
    m_json.entry("simplex", simplex.dimension < 0 ? "nothing" : names[simplex.dimension]);
    if(simplex.index != Input_simplex::no_index)
      m_json.entry("index", simplex.index);
    m_json.key("vertices");
    m_json.list(simplex.vertices, [&](const std::size_t v) { m_json.value(v); });
    m_json.key("points");
    m_json.list(simplex.points, [&](const Point& p) { m_json.point(p); });
    m_json.end('}');
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_WRITE_REPORT_H

#ifndef BOUNDARY_RECOVERY_3_PYTHON_MODULE_TYPES_H
#define BOUNDARY_RECOVERY_3_PYTHON_MODULE_TYPES_H

// The types that all functions of the module work with: one kernel, one triangulation, one visitor.

#include "plain_interface.h"

#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/Meshing_visitor_3.h>
#include <CGAL/Boundary_recovery_3/Quality_improvement_result_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace boundary_recovery {

namespace BR3 = CGAL::Boundary_recovery_3;

typedef CGAL::Exact_predicates_inexact_constructions_kernel           Kernel;
typedef Kernel::Point_3                                               Point_3;
typedef CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type Triangulation;
typedef Triangulation::Vertex_handle                                  Vertex_handle;
typedef Triangulation::Cell_handle                                    Cell_handle;

// A range over rows that are not copied. `Row` makes a value of the number of a row.
template <typename Row>
class Row_range
{
  Row m_row;
  std::size_t m_size;

public:
  typedef boost::transform_iterator<Row, boost::counting_iterator<std::size_t> > const_iterator;
  typedef const_iterator                                                         iterator;

  explicit Row_range(const Row& row) : m_row(row), m_size(row.size()) { }

  const_iterator begin() const { return { boost::counting_iterator<std::size_t>(0), m_row }; }
  const_iterator end() const { return { boost::counting_iterator<std::size_t>(m_size), m_row }; }
  std::size_t size() const { return m_size; }
  auto operator[](const std::size_t i) const { return m_row(i); }
};

struct Point_row
{
  typedef Point_3 result_type;
  Point_rows rows;
  std::size_t size() const { return rows.size; }
  Point_3 operator()(const std::size_t i) const { return Point_3(rows(i, 0), rows(i, 1), rows(i, 2)); }
};

template <std::size_t N>
struct Index_row
{
  typedef std::array<std::size_t, N> result_type;
  Index_rows rows;
  std::size_t size() const { return rows.size; }

  result_type operator()(const std::size_t i) const
  {
    result_type row;
    for(std::size_t j = 0; j < N; ++j)
      row[j] = rows(i, j);
    return row;
  }
};

typedef Row_range<Point_row>     Points;
typedef Row_range<Index_row<2> > Edges;
typedef Row_range<Index_row<3> > Triangles;
typedef Row_range<Index_row<4> > Tetrahedra;

inline Points as_points(const Point_rows& rows) { return Points(Point_row{ rows }); }

template <std::size_t N>
Row_range<Index_row<N> > as_rows(const Index_rows& rows) { return Row_range<Index_row<N> >(Index_row<N>{ rows }); }

// The only visitor: asks the user whether the work is to go on, and tells how far it is.
class Visitor
  : public CGAL::Default_meshing_visitor_3
{
  Watch& m_watch;

public:
  explicit Visitor(Watch& watch) : m_watch(watch) { }

  void on_phase_begin(const BR3::Phase phase) { m_watch.tell(to_string(phase), 0, true); }
  void on_phase_end(const BR3::Phase_report& report) { m_watch.tell(to_string(report.phase), 1, true); }
  bool go_further() { return m_watch.go_further(); }

  void on_progress(const BR3::Phase phase, const std::size_t done, const std::size_t total)
  {
    if(total > 0)
      m_watch.tell(to_string(phase), (std::min)(double(done) / double(total), 1.), false);
  }
};

// Says which value of an enumeration has a name; the names of others are an error.
template <typename Enumeration>
Enumeration value_named(const std::string& name, const std::initializer_list<Enumeration> values)
{
  std::string names;
  for(const Enumeration value : values)
  {
    if(name == to_string(value))
      return value;
    names += names.empty() ? to_string(value) : std::string(", ") + to_string(value);
  }
  throw std::invalid_argument("'" + name + "' is none of: " + names);
}

inline BR3::Improvement_effort effort_of(const Options& options)
{
  typedef BR3::Improvement_effort Effort;
  return value_named(options.effort, { Effort::low, Effort::normal, Effort::high });
}

inline void set_point(Rows<double>& rows, const std::size_t i, const Point_3& p)
{
  double* const row = rows[i];
  row[0] = p.x();
  row[1] = p.y();
  row[2] = p.z();
}

template <typename Input_simplex>
Simplex plain_simplex(const Input_simplex& simplex)
{
  Simplex result;
  result.dimension = simplex.dimension;
  if(simplex.index != Input_simplex::no_index)
    result.index = static_cast<std::int64_t>(simplex.index);
  result.vertices.assign(simplex.vertices.begin(), simplex.vertices.end());
  for(const auto& p : simplex.points)
    result.coordinates.insert(result.coordinates.end(), { p.x(), p.y(), p.z() });
  return result;
}

template <typename Input_defect>
std::vector<Defect> plain_defects(const std::vector<Input_defect>& defects)
{
  std::vector<Defect> result;
  for(const auto& defect : defects)
  {
    result.push_back({ to_string(defect.kind), { } });
    for(const auto& simplex : defect.simplices)
      result.back().simplices.push_back(plain_simplex(simplex));
  }
  return result;
}

inline std::vector<Record> plain_phases(const std::vector<BR3::Phase_report>& phases)
{
  std::vector<Record> result;
  for(const BR3::Phase_report& phase : phases)
  {
    Record record;
    record.add("phase", to_string(phase.phase));
    record.add("seconds", phase.seconds);
    record.add("lost_edges", phase.lost_edges);
    record.add("lost_facets", phase.lost_facets);
    record.add("number_of_vertices", phase.number_of_vertices);
    record.add("number_of_cells", phase.number_of_cells);
    record.add("number_of_holes", phase.number_of_holes);
    result.push_back(record);
  }
  return result;
}

inline std::vector<Record> plain_quality(const BR3::Mesh_quality_3& quality)
{
  Record record;
  record.add("number_of_cells", quality.number_of_cells);
  record.add("min_dihedral_angle", quality.min_dihedral_angle);
  record.add("max_dihedral_angle", quality.max_dihedral_angle);
  record.add("mean_radius_ratio", quality.mean_radius_ratio);
  record.add("min_radius_ratio", quality.min_radius_ratio);
  record.add("share_of_edges_in_size", quality.share_of_edges_in_size);
  record.add("histogram", std::vector<double>(quality.histogram.begin(), quality.histogram.end()));
  return { record };
}

} // namespace boundary_recovery

#endif // BOUNDARY_RECOVERY_3_PYTHON_MODULE_TYPES_H

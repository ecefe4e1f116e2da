// Judges what recover_boundary() did to a triangulation, from the definition and in rational numbers: no predicate of
// CGAL and no part of the library decides anything. A fault is thrown as a Complaint.

#ifndef BR3_TEST_BRUTE_FORCE_CHECKER_H
#define BR3_TEST_BRUTE_FORCE_CHECKER_H

#include "brute_force_input_br3.h"

#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Lazy_exact_nt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace br3_test {

struct Complaint : public std::runtime_error { using std::runtime_error::runtime_error; };

inline void require(const bool condition, const char* what)
{
  if(! condition)
    throw Complaint(what);
}

typedef CGAL::Exact_rational Rational;
struct Rational_point { Rational x[3]; };

inline Rational_point operator-(const Rational_point& p, const Rational_point& q)
{
  return { { p.x[0] - q.x[0], p.x[1] - q.x[1], p.x[2] - q.x[2] } };
}

inline bool operator==(const Rational_point& p, const Rational_point& q)
{
  return p.x[0] == q.x[0] && p.x[1] == q.x[1] && p.x[2] == q.x[2];
}

inline Rational_point cross(const Rational_point& u, const Rational_point& v)
{
  Rational_point n;
  for(int i = 0; i < 3; ++i)
    n.x[i] = u.x[(i + 1) % 3] * v.x[(i + 2) % 3] - u.x[(i + 2) % 3] * v.x[(i + 1) % 3];
  return n;
}

inline Rational dot(const Rational_point& u, const Rational_point& v)
{
  return u.x[0] * v.x[0] + u.x[1] * v.x[1] + u.x[2] * v.x[2];
}

// Six times the signed volume.
inline Rational volume(const Rational_point& p, const Rational_point& q, const Rational_point& r,
                       const Rational_point& s)
{
  return dot(cross(q - p, r - p), s - p);
}

template <typename FT>
Rational to_rational_number(const FT& x) { return Rational(x); }

template <typename ET>
Rational to_rational_number(const CGAL::Lazy_exact_nt<ET>& x) { return Rational(CGAL::exact(x)); }

template <typename Point_3>
Rational_point to_rational(const Point_3& p)
{
  return { { to_rational_number(p.x()), to_rational_number(p.y()), to_rational_number(p.z()) } };
}

inline Rational_point to_rational(const Coordinates& c)
{
  return { { Rational(c[0]), Rational(c[1]), Rational(c[2]) } };
}

// What is known of an input before any recovery: the defects, and the volume of the convex hull of all the points.
struct Expectation
{
  explicit Expectation(const Plc& plc)
    : input(plc), has_simple_defect(input.has_simple_defect())
  {
    if(has_simple_defect)
      return;
    defects = input.intersecting_pairs();
    if(defects.empty())
      defects = input.vertices_on_constraints();

    typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
    CGAL::Delaunay_triangulation_3<K> delaunay;
    for(const auto* points : { &plc.points, &plc.earlier_points })
      for(const Coordinates& c : *points)
        delaunay.insert(K::Point_3(c[0], c[1], c[2]));
    for(const auto c : delaunay.finite_cell_handles())
      hull_volume += volume(to_rational(c->vertex(0)->point()), to_rational(c->vertex(1)->point()),
                            to_rational(c->vertex(2)->point()), to_rational(c->vertex(3)->point()));
  }

  bool is_invalid() const { return has_simple_defect || ! defects.empty(); }

  Brute_force_input input;
  bool has_simple_defect;
  std::set<std::set<Simplex> > defects;
  Rational hull_volume = 0;
};

template <typename Tr>
class Brute_force_checker
{
public:
  typedef typename Tr::Vertex_handle Vertex_handle;
  typedef typename Tr::Point         Point;
  typedef CGAL::Boundary_recovery_result_3<Tr> Result;
  typedef CGAL::Boundary_recovery_3::Recovery_mode Mode;
  typedef CGAL::Boundary_recovery_3::Recovery_status Status;
  typedef std::vector<std::pair<Vertex_handle, Point> > Earlier_vertices;

  // `earlier` are the vertices and their points before the recovery, in the order of the earlier points of `plc`.
  Brute_force_checker(const Plc& plc, const Expectation& expectation, const Mode mode, const Tr& tr,
                      const Earlier_vertices& earlier, const Result& result)
    : m_plc(plc), m_expectation(expectation), m_mode(mode), m_tr(tr), m_earlier(earlier), m_result(result)
  {
    for(const Vertex_handle v : tr.finite_vertex_handles())
    {
      m_index.emplace(&*v, m_points.size());
      m_points.push_back(to_rational(v->point()));
    }
  }

  void operator()()
  {
    if(m_tr.dimension() == 3)
      check_mesh();
    check_vertices();
    if(m_expectation.is_invalid())
      check_refusal();
    else
      check_account();
  }

private:
  static constexpr bool is_exact = std::is_same<typename CGAL::Algebraic_structure_traits<
    typename Tr::Geom_traits::FT>::Is_exact, CGAL::Tag_true>::value;

  // Points on constraints have positions that doubles need not be able to represent.
  bool may_be_rounded() const
  {
    return ! is_exact && m_mode == Mode::conforming && ! m_result.steiner_vertices.empty();
  }

  std::size_t index(const Vertex_handle v) const
  {
    const auto it = m_index.find(&*v);
    require(it != m_index.end(), "a vertex is not in the triangulation");
    return it->second;
  }

  void check_mesh()
  {
    require(m_tr.tds().is_valid(), "the data structure is not valid");
    Rational total = 0;
    for(const auto c : m_tr.finite_cell_handles())
    {
      std::array<std::size_t, 4> v;
      for(int i = 0; i < 4; ++i)
        v[i] = index(c->vertex(i));
      const Rational six_times = volume(m_points[v[0]], m_points[v[1]], m_points[v[2]], m_points[v[3]]);
      require(six_times > 0, "a cell is flat or inverted");
      total += six_times;
      std::sort(v.begin(), v.end());
      add_faces(v);
    }
    if(may_be_rounded())
      return; // points of the hull may have moved
    if(! m_expectation.has_simple_defect)
      require(total == m_expectation.hull_volume, "the cells do not fill the convex hull");
    check_hull();
  }

  void add_faces(const std::array<std::size_t, 4>& v)
  {
    for(int i = 0; i < 4; ++i)
      for(int j = i + 1; j < 4; ++j)
      {
        m_mesh_edges.insert({ v[i], v[j] });
        for(int k = j + 1; k < 4; ++k)
          m_mesh_facets.insert({ v[i], v[j], v[k] });
      }
  }

  void check_hull() const
  {
    for(const auto c : m_tr.all_cell_handles())
      if(m_tr.is_infinite(c))
      {
        const int k = c->index(m_tr.infinite_vertex());
        std::vector<Rational_point> f;
        for(int i = 0; i < 4; ++i)
          if(i != k)
            f.push_back(m_points[index(c->vertex(i))]);
        const auto inside = c->neighbor(k);
        const Rational side = volume(f[0], f[1], f[2], m_points[index(inside->vertex(inside->index(c)))]);
        for(const Rational_point& p : m_points)
          require(volume(f[0], f[1], f[2], p) * side >= 0, "the hull is not convex");
      }
  }

  // Every vertex is there for a reason, and earlier ones stay where they were.
  void check_vertices() const
  {
    std::set<std::size_t> known;
    for(const auto& v : m_earlier)
    {
      known.insert(index(v.first));
      require(v.first->point() == v.second, "an earlier vertex has moved");
    }
    const std::size_t number_of_earlier = known.size();
    if(m_expectation.is_invalid())
    {
      require(m_result.vertices.empty(), "vertices are given for an invalid input");
      for(const Coordinates& c : m_plc.points)
        for(std::size_t i = 0; i < m_points.size(); ++i)
          if(m_points[i] == to_rational(c))
            known.insert(i);
    }
    else
    {
      require(m_result.vertices.size() == m_plc.points.size(), "not every input point has its vertex");
      for(std::size_t i = 0; i < m_plc.points.size(); ++i)
      {
        known.insert(index(m_result.vertices[i]));
        require(to_rational(m_result.vertices[i]->point()) == to_rational(m_plc.points[i]), "a vertex is elsewhere");
      }
      require(m_result.number_of_inserted_vertices == known.size() - number_of_earlier, "insertions are miscounted");
    }
    for(const Vertex_handle v : m_result.steiner_vertices)
      require(known.insert(index(v)).second, "a Steiner vertex is an input vertex, or is listed twice");
    require(known.size() == m_points.size(), "a vertex is neither an input vertex nor a listed Steiner vertex");
    require(m_mode != Mode::flips_only || m_result.steiner_vertices.empty(), "a Steiner vertex without permission");
    require(m_tr.number_of_vertices() == m_points.size(), "vertices are miscounted");
  }

  // An invalid input: the status and, if it is so by intersections, all the pairs.
  void check_refusal() const
  {
    require(m_result.status == Status::invalid_input, "an invalid input was accepted");
    require(! m_result.defects.empty(), "an input was refused without a reason");
    if(m_expectation.has_simple_defect)
      return;
    std::set<std::set<Simplex> > defects;
    for(const auto& defect : m_result.defects)
    {
      require(defect.kind == CGAL::Boundary_recovery_3::Input_defect_kind::intersecting_constraints, "a wrong defect");
      require(defect.simplices.size() == 2, "a defect is not a pair");
      std::set<Simplex> pair;
      for(const auto& s : defect.simplices)
        pair.insert(to_simplex(s));
      require(defects.insert(pair).second, "a pair is listed twice");
    }
    require(defects == m_expectation.defects, "the list of pairs that intersect is wrong");
  }

  // The sorted vertex indices. Earlier vertices that are no input points are known by their coordinates only.
  template <typename Input_simplex>
  Simplex to_simplex(const Input_simplex& s) const
  {
    Simplex result = s.vertices;
    std::sort(result.begin(), result.end());
    if(result.empty())
      for(std::size_t i = 0; i < m_plc.earlier_points.size(); ++i)
        if(to_rational(m_plc.earlier_points[i]) == to_rational(s.points.front()))
          return { m_plc.points.size() + i };
    return result;
  }

  void check_account()
  {
    require(m_result.status != Status::invalid_input, "a valid input was refused");
    require(m_result.status != Status::stopped, "the recovery takes for ever");
    require(m_result.defects.empty(), "a valid input has defects");
    const std::set<Simplex> edges = m_expectation.input.all_edges();
    require(m_result.number_of_edges == edges.size(), "constrained edges are miscounted");
    require(m_result.number_of_facets == m_plc.triangles.size(), "constrained facets are miscounted");

    std::set<Simplex> missing;
    for(const auto& e : m_result.missing_edges)
      require(e.dimension == 1 && missing.insert(to_simplex(e)).second, "an edge is listed twice");
    for(const Simplex& e : edges)
      check_constraint(e, missing);
    for(const auto& f : m_result.missing_facets)
    {
      require(f.dimension == 2 && f.vertices == m_plc.triangles.at(f.index), "a missing facet is described wrongly");
      require(missing.insert(to_simplex(f)).second, "a facet is listed twice");
    }
    for(Simplex t : m_plc.triangles)
    {
      std::sort(t.begin(), t.end());
      check_constraint(t, missing);
    }
    require(missing.empty(), "something is missing that was never asked for");
    const bool is_all_there = m_result.missing_edges.empty() && m_result.missing_facets.empty();
    require((m_result.status == Status::recovered) == is_all_there, "the status contradicts the lists");
    require(is_all_there || ! must_be_complete(), "a valid input was not recovered");
    const bool is_explained = ! m_result.unrepresentable_constraints.empty();
    require(m_mode == Mode::flips_only || is_all_there || is_explained, "points failed for no reason");
    require(! is_explained || (! is_all_there && m_mode != Mode::flips_only), "points were said to fail, but did not");
  }

  // Where coordinates differ by rounding errors only, no number may fit between two constraints.
  bool must_be_complete() const { return m_mode != Mode::flips_only && (is_exact || has_integer_coordinates()); }

  bool has_integer_coordinates() const
  {
    return std::all_of(m_plc.points.begin(), m_plc.points.end(), [](const Coordinates& p)
    {
      return std::all_of(p.begin(), p.end(), [](const double x) { return std::floor(x) == x; });
    });
  }

  // Takes the constraint off the list iff it is missing, and looks for points on it.
  void check_constraint(const Simplex& constraint, std::set<Simplex>& missing) const
  {
    Simplex s;
    for(const std::size_t v : constraint)
      s.push_back(index(m_result.vertices[v]));
    std::sort(s.begin(), s.end());
    const bool is_listed = missing.erase(constraint) > 0;
    if(m_mode == Mode::conforming && ! m_result.steiner_vertices.empty())
    {
      // Rounded points are beside the constraint, so the union cannot be seen by coordinates.
      if(is_exact)
        require(is_union(s) != is_listed, is_listed ? "a constraint is there, but is listed as missing"
                                                    : "a constraint is not there, and is not listed as missing");
      return;
    }
    const bool is_there = s.size() == 2 ? m_mesh_edges.count(s) > 0 : m_mesh_facets.count(s) > 0;
    require(is_there != is_listed, is_listed ? "a constraint is there, but is listed as missing"
                                             : "a constraint is not there, and is not listed as missing");
    for(const Vertex_handle v : m_result.steiner_vertices)
      require(! is_on(index(v), s), "a Steiner vertex is on a constraint");
  }

  bool is_on(const std::size_t v, const Simplex& s) const
  {
    const Rational_point& p = m_points[s[0]];
    const Rational_point& q = m_points[s[1]];
    const Rational_point& x = m_points[v];
    const Rational_point zero = { { 0, 0, 0 } };
    if(s.size() == 2)
      return cross(q - p, x - p) == zero && dot(x - p, x - q) <= 0;
    const Rational_point& r = m_points[s[2]];
    const Rational_point n = cross(q - p, r - p);
    return dot(n, x - p) == 0 && dot(n, cross(q - p, x - p)) >= 0 && dot(n, cross(r - q, x - q)) >= 0
        && dot(n, cross(p - r, x - r)) >= 0;
  }

  // Length or area, up to a factor, of the projection on the i-th axis or along it.
  Rational measure(const Simplex& s, const int i) const
  {
    const Rational_point d = m_points[s[1]] - m_points[s[0]];
    return CGAL::abs(s.size() == 2 ? d.x[i] : cross(d, m_points[s[2]] - m_points[s[0]]).x[i]);
  }

  // Whether the mesh edges or facets on the constraint fill it: they do not overlap, so their measures tell.
  bool is_union(const Simplex& constraint) const
  {
    int axis = 0;
    while(measure(constraint, axis) == 0)
      ++axis;
    std::vector<bool> is_vertex_on(m_points.size());
    for(std::size_t v = 0; v < m_points.size(); ++v)
      is_vertex_on[v] = is_on(v, constraint);
    Rational sum = 0;
    for(const Simplex& s : constraint.size() == 2 ? m_mesh_edges : m_mesh_facets)
      if(std::all_of(s.begin(), s.end(), [&](const std::size_t v) { return is_vertex_on[v]; }))
        sum += measure(s, axis);
    return sum == measure(constraint, axis);
  }

  const Plc& m_plc;
  const Expectation& m_expectation;
  const Mode m_mode;
  const Tr& m_tr;
  const Earlier_vertices& m_earlier;
  const Result& m_result;
  std::map<const void*, std::size_t> m_index;
  std::vector<Rational_point> m_points;
  std::set<Simplex> m_mesh_edges, m_mesh_facets;
};

} // namespace br3_test

#endif // BR3_TEST_BRUTE_FORCE_CHECKER_H

// Judges whether mesh edges and mesh facets make up a constraint: combinatorially, and in rational numbers where the
// positions are exact.

#ifndef BR3_TEST_CONSTRAINT_PARTS_CHECKER_H
#define BR3_TEST_CONSTRAINT_PARTS_CHECKER_H

#include "brute_force_checker_br3.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

namespace br3_test {

template <typename Tr>
class Constraint_parts_checker
{
public:
  typedef typename Tr::Vertex_handle       Vertex_handle;
  typedef std::vector<Vertex_handle>       Vertices;
  typedef std::set<std::set<const void*> > Edges;

  explicit Constraint_parts_checker(const Tr& tr) : m_tr(tr) { }

  // The parts are mesh edges and lead from one end to the other without visiting a vertex twice.
  void check_edge(const Vertices& edge, const std::vector<Vertices>& parts) const
  {
    std::set<const void*> vertices;
    for(const Vertices& part : parts)
    {
      typename Tr::Cell_handle c;
      int i, j;
      require(part.size() == 2 && m_tr.is_edge(part[0], part[1], c, i, j), "a part of an edge is not in the mesh");
      vertices.insert({ &*part[0], &*part[1] });
    }
    require(vertices.size() == parts.size() + 1, "the parts of an edge are no tree");
    require(is_path(parts, edge), "the parts of an edge do not lead from one end to the other");
    if(is_exact)
      check_measures(edge, parts);
  }

  // The parts are mesh facets that form a disk whose rim is `rim`, the parts of the three edges.
  void check_facet(const Vertices& facet, const std::vector<Vertices>& parts, const Edges& rim) const
  {
    std::set<const void*> vertices;
    Edges edges, open;
    for(const Vertices& part : parts)
    {
      typename Tr::Cell_handle c;
      int i, j, k;
      require(part.size() == 3 && m_tr.is_facet(part[0], part[1], part[2], c, i, j, k),
              "a part of a facet is not in the mesh");
      for(int l = 0; l < 3; ++l)
      {
        vertices.insert(&*part[l]);
        const std::set<const void*> e = { &*part[l], &*part[(l + 1) % 3] };
        edges.insert(e);
        if(! open.insert(e).second)
          open.erase(e);
      }
    }
    require(open == rim, "the parts of a facet do not have the rim of the facet");
    require(vertices.size() + parts.size() == edges.size() + 1, "the parts of a facet are no disk");
    if(is_exact)
      check_measures(facet, parts);
  }

  // A part of a facet has its orientation.
  static void check_orientation(const Vertices& facet, const Vertices& part)
  {
    if(is_exact)
      require(share_of(points(part), points(facet)) > 0, "a part is turned the other way than its facet");
  }

  static std::set<const void*> edge(const Vertex_handle v, const Vertex_handle w) { return { &*v, &*w }; }

private:
  static constexpr bool is_exact = std::is_same<typename CGAL::Algebraic_structure_traits<
    typename Tr::Geom_traits::FT>::Is_exact, CGAL::Tag_true>::value;

  // Ends are where one part is, all other vertices are between two.
  static bool is_path(const std::vector<Vertices>& parts, const Vertices& edge)
  {
    std::set<const void*> odd;
    std::multiset<const void*> all;
    for(const Vertices& part : parts)
      for(const Vertex_handle v : part)
      {
        all.insert(&*v);
        if(! odd.insert(&*v).second)
          odd.erase(&*v);
      }
    return odd == std::set<const void*>{ &*edge[0], &*edge[1] }
        && std::all_of(all.begin(), all.end(), [&](const void* v) { return all.count(v) <= 2; });
  }

  // The parts are on the constraint, none is degenerate, and together they are as long or large as it.
  void check_measures(const Vertices& constraint, const std::vector<Vertices>& parts) const
  {
    const std::vector<Rational_point> whole = points(constraint);
    Rational sum = 0;
    for(const Vertices& part : parts)
    {
      const std::vector<Rational_point> p = points(part);
      for(const Rational_point& x : p)
        require(is_on(x, whole), "a part is not on its constraint");
      const Rational share = share_of(p, whole);
      require(share != 0, "a part is degenerate");
      sum += CGAL::abs(share);
    }
    require(sum == 1, "the parts do not fill the constraint, or overlap");
  }

  static std::vector<Rational_point> points(const Vertices& vertices)
  {
    std::vector<Rational_point> result;
    for(const Vertex_handle v : vertices)
      result.push_back(to_rational(v->point()));
    return result;
  }

  static bool is_on(const Rational_point& x, const std::vector<Rational_point>& s)
  {
    const Rational_point zero = { { 0, 0, 0 } };
    if(s.size() == 2)
      return cross(s[1] - s[0], x - s[0]) == zero && dot(x - s[0], x - s[1]) <= 0;
    const Rational_point n = normal(s);
    if(dot(n, x - s[0]) != 0)
      return false;
    for(int i = 0; i < 3; ++i)
      if(dot(n, cross(s[(i + 1) % 3] - s[i], x - s[i])) < 0)
        return false;
    return true;
  }

  static Rational_point normal(const std::vector<Rational_point>& s) { return cross(s[1] - s[0], s[2] - s[0]); }

  // Length or area in units of the constraint, with a sign.
  static Rational share_of(const std::vector<Rational_point>& part, const std::vector<Rational_point>& whole)
  {
    const Rational_point u = whole.size() == 2 ? part[1] - part[0] : normal(part);
    const Rational_point v = whole.size() == 2 ? whole[1] - whole[0] : normal(whole);
    return dot(u, v) / dot(v, v);
  }

  const Tr& m_tr;
};

// Looks at what the result says of the parts of split constraints, after a recovery in the mode `conforming`.
template <typename Tr>
class Result_parts_checker
{
public:
  typedef CGAL::Boundary_recovery_result_3<Tr>  Result;
  typedef typename Result::Constraint_part      Part;
  typedef Constraint_parts_checker<Tr>          Checker;
  typedef typename Checker::Vertices            Vertices;
  typedef typename Checker::Edges               Edges;

  Result_parts_checker(const Plc& plc, const Tr& tr, const Result& result)
    : m_plc(plc), m_checker(tr), m_result(result)
  { }

  // Constraints that are not named consist of themselves.
  void operator()() const
  {
    check_names(m_result.parts_of_edges, m_plc.edges, 2);
    check_names(m_result.parts_of_facets, m_plc.triangles, 3);
    for(const Part& part : m_result.parts_of_facets)
      m_checker.check_orientation(vertices(part.constraint.vertices), part.vertices);
    for(const Simplex& e : Brute_force_input(m_plc).all_edges())
      m_checker.check_edge(vertices(e), parts(m_result.parts_of_edges, e));
    for(const Simplex& t : m_plc.triangles)
      m_checker.check_facet(vertices(t), parts(m_result.parts_of_facets, t), rim(t));
    check_steiner_vertices();
  }

private:
  void check_names(const std::vector<Part>& parts, const std::vector<Simplex>& all, const std::size_t size) const
  {
    for(const Part& part : parts)
    {
      const auto& c = part.constraint;
      require(part.vertices.size() == size && c.vertices.size() == size && c.points.size() == size,
              "a part or its constraint has a wrong number of vertices");
      require(c.dimension == static_cast<int>(size) - 1, "the constraint of a part has a wrong dimension");
      if(size == 3 || c.index != c.no_index)
        require(c.index < all.size() && all[c.index] == c.vertices, "the constraint of a part is not the caller's");
      for(std::size_t i = 0; i < size; ++i)
        require(to_rational(c.points[i]) == to_rational(m_plc.points[c.vertices[i]]), "a constraint is elsewhere");
    }
  }

  Vertices vertices(const Simplex& s) const
  {
    Vertices result;
    for(const std::size_t v : s)
      result.push_back(m_result.vertices[v]);
    return result;
  }

  std::vector<Vertices> parts(const std::vector<Part>& all, Simplex s) const
  {
    std::vector<Vertices> result;
    std::sort(s.begin(), s.end());
    for(const Part& part : all)
    {
      Simplex c = part.constraint.vertices;
      std::sort(c.begin(), c.end());
      if(c == s)
        result.push_back(part.vertices);
    }
    return result.empty() ? std::vector<Vertices>{ vertices(s) } : result;
  }

  Edges rim(const Simplex& t) const
  {
    Edges result;
    for(int i = 0; i < 3; ++i)
      for(const Vertices& part : parts(m_result.parts_of_edges, { t[i], t[(i + 1) % 3] }))
        result.insert(Checker::edge(part[0], part[1]));
    return result;
  }

  // Each of them is on a constraint.
  void check_steiner_vertices() const
  {
    std::set<const void*> on_constraints;
    for(const auto* parts : { &m_result.parts_of_edges, &m_result.parts_of_facets })
      for(const Part& part : *parts)
        for(const auto v : part.vertices)
          on_constraints.insert(&*v);
    for(const auto v : m_result.steiner_vertices)
      require(on_constraints.count(&*v) == 1, "a Steiner vertex is on no constraint");
  }

  const Plc& m_plc;
  Checker m_checker;
  const Result& m_result;
};

} // namespace br3_test

#endif // BR3_TEST_CONSTRAINT_PARTS_CHECKER_H

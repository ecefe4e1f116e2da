// Sets of constraints for the tests of what takes any of them.

#ifndef BR3_TEST_CONSTRAINT_SETS_H
#define BR3_TEST_CONSTRAINT_SETS_H

#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <vector>

namespace br3_test {

// The least that operations want of a set of constraints: sets of vertices. The edges of its facets are in it, too.
template <typename Vertex_handle>
struct Constraint_set
{
  typedef std::set<Vertex_handle> Simplex;

  void insert(const Simplex& s)
  {
    simplices.insert(s);
    if(s.size() == 3)
      for(const Vertex_handle v : s)
        simplices.insert(with_exchanged({ v }, s, Vertex_handle()));
  }

  bool is_constrained(const Vertex_handle u, const Vertex_handle v) const { return simplices.count({ u, v }) == 1; }

  bool is_constrained(const Vertex_handle u, const Vertex_handle v, const Vertex_handle w) const
  {
    return simplices.count({ u, v, w }) == 1;
  }

  void split(const Vertex_handle a, const Vertex_handle b, const Vertex_handle v) { split({ a, b }, v); }

  void split(const Vertex_handle a, const Vertex_handle b, const Vertex_handle c, const Vertex_handle v)
  {
    split({ a, b, c }, v);
  }

  std::set<Simplex> simplices;

private:
  // With v, if it is any, in the place of vertices.
  static Simplex with_exchanged(const Simplex& vertices, Simplex s, const Vertex_handle v)
  {
    for(const Vertex_handle w : vertices)
      s.erase(w);
    if(v != Vertex_handle())
      s.insert(v);
    return s;
  }

  void split(const Simplex& cut, const Vertex_handle v)
  {
    const std::set<Simplex> old = simplices;
    for(const Simplex& s : old)
      if(std::includes(s.begin(), s.end(), cut.begin(), cut.end()))
      {
        simplices.erase(s);
        for(const Vertex_handle w : cut)
          insert(with_exchanged({ w }, s, v));
      }
  }
};

// Answers for simplices of the mesh only, as marks in its cells do.
template <typename Tr>
class Constraints_in_mesh
{
public:
  typedef typename Tr::Vertex_handle  Vertex_handle;
  typedef typename Tr::Cell_handle    Cell_handle;

  Constraints_in_mesh(const Tr& tr, Constraint_set<Vertex_handle>& constraints)
    : m_tr(tr), m_constraints(constraints)
  { }

  bool is_constrained(const Vertex_handle u, const Vertex_handle v) const
  {
    Cell_handle c;
    int i, j;
    return m_tr.is_edge(u, v, c, i, j) && m_constraints.is_constrained(u, v);
  }

  bool is_constrained(const Vertex_handle u, const Vertex_handle v, const Vertex_handle w) const
  {
    Cell_handle c;
    int i, j, k;
    return m_tr.is_facet(u, v, w, c, i, j, k) && m_constraints.is_constrained(u, v, w);
  }

  template <typename ... Vertex_handles>
  void split(const Vertex_handles ... v) { m_constraints.split(v ...); }

private:
  const Tr& m_tr;
  Constraint_set<Vertex_handle>& m_constraints;
};

template <typename Tr>
CGAL::Boundary_recovery_3::internal::Constraints_3<Tr>
numbered(const Constraint_set<typename Tr::Vertex_handle>& constraints)
{
  CGAL::Boundary_recovery_3::internal::Constraints_3<Tr> result;
  for(const auto& s : constraints.simplices)
  {
    const std::vector<typename Tr::Vertex_handle> v(s.begin(), s.end());
    if(s.size() == 2)
      result.insert(v[0], v[1]);
    else
      result.insert(v[0], v[1], v[2]);
  }
  return result;
}

// The reverse.
template <typename Tr>
Constraint_set<typename Tr::Vertex_handle>
without_numbers(const CGAL::Boundary_recovery_3::internal::Constraints_3<Tr>& constraints)
{
  typedef std::set<typename Tr::Vertex_handle> Simplex;
  Constraint_set<typename Tr::Vertex_handle> result;
  for(std::size_t e = 0; e < constraints.edges().size(); ++e)
    if(! constraints.is_edge_erased(e))
      result.simplices.insert(Simplex(constraints.edges()[e].begin(), constraints.edges()[e].end()));
  for(std::size_t f = 0; f < constraints.facets().size(); ++f)
    if(! constraints.is_facet_erased(f))
      result.simplices.insert(Simplex(constraints.facets()[f].begin(), constraints.facets()[f].end()));
  return result;
}

} // namespace br3_test

#endif // BR3_TEST_CONSTRAINT_SETS_H

// The optimal covering mesh of a shell, by looking at every one of them.
//
// Written from the definitions of [CZZ+17, Section 3], not from the dynamic programs that compute the same in the
// library: all cores, all triangulations of all rings, each judged as a set of tetrahedra, faces and edges.

#ifndef BR3_TEST_REFERENCE_COVERING_MESH_H
#define BR3_TEST_REFERENCE_COVERING_MESH_H

#include "reference_geometry_br3.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace br3_test {

// A simplex of a shell as a set of bits: i for p_i, m for a, m + 1 for b.
typedef unsigned Mask;
typedef std::array<int, 3> Triangle;

// Everything that the search for a covering mesh is given.
struct Shell_problem
{
  enum Quality { NONE, WORST_ELEMENT, FEWEST_INTERSECTIONS };

  Lattice_point a, b;
  Lattice_points ring;
  int h = -1;                        // position of the infinite vertex, -1: none

  int f = -1;                        // the face a b p_f is to be avoided, -1: none
  bool keeps_edge = false;           // ab stays
  std::vector<bool> is_kept;         // the face a b p_i stays
  Quality quality = NONE;
  std::vector<Lattice_points> brc1;  // segments that no new entity may intersect
  std::vector<Lattice_points> brc2;  // triangles that no new entity may intersect
  std::vector<Lattice_points> lost;  // segments and triangles whose intersections are counted
  std::vector<Mask> ancestors;       // edges of the shell that get no new face

  int degree() const { return static_cast<int>(ring.size()); }
};

// One covering mesh.
struct Covering_mesh
{
  std::vector<int> core;
  std::vector<Triangle> triangles;
  std::vector<Mask> tetrahedra;
  std::vector<Mask> new_entities;      // edges and faces that the present covering mesh does not have
  std::vector<Mask> interior_entities; // edges and faces that are not on the boundary of the shell

  bool has_edge() const { return ! core.empty(); }
  bool has_face(const int i) const { return std::find(core.begin(), core.end(), i) != core.end(); }
};

struct Shell_solution
{
  std::vector<int> core;
  std::vector<Triangle> triangles;
  std::size_t number_of_valid = 0;     // covering meshes, without the present one
  std::size_t number_of_optimal = 0;
};

// All triangulations of a polygon with n vertices, as triangles (i, k, j) with i < k < j.
inline const std::vector<std::vector<Triangle> >& polygon_triangulations(const int n)
{
  static std::map<int, std::vector<std::vector<Triangle> > > all;
  const auto found = all.find(n);
  if(found != all.end())
    return found->second;
  std::vector<std::vector<Triangle> > result;
  if(n == 2)
    result.push_back(std::vector<Triangle>());
  for(int k = 1; k + 1 < n; ++k) // the triangle at the side (0, n - 1)
    for(const auto& first : polygon_triangulations(k + 1))
      for(const auto& second : polygon_triangulations(n - k))
      {
        std::vector<Triangle> triangulation(1, Triangle{{ 0, k, n - 1 }});
        triangulation.insert(triangulation.end(), first.begin(), first.end());
        for(const Triangle& t : second)
          triangulation.push_back({{ t[0] + k, t[1] + k, t[2] + k }});
        result.push_back(triangulation);
      }
  return all[n] = result;
}

class Reference_search
{
public:
  // Enumerates all covering meshes with positive elements.
  explicit Reference_search(const Shell_problem& geometry) : m_problem(geometry), m(geometry.degree())
  {
    judge_tetrahedra();
    for(Mask core = 0; core < (Mask(1) << m); ++core)
      enumerate(core);
  }

  // The present covering mesh is one of them, and the only one if the shell cannot be reduced.
  std::size_t number_of_positive_covering_meshes() const { return m_meshes.size(); }
  const std::vector<Covering_mesh>& meshes() const { return m_meshes; }

  // How often the lost constraints intersect the inside of the shell when covered by `mesh`.
  int number_of_intersections(const Shell_problem& problem, const Covering_mesh& mesh) const
  {
    int n = 0;
    for(const Mask entity : mesh.interior_entities)
      for(const Lattice_points& c : problem.lost)
        n += intersects(entity, c);
    return n;
  }

  // Solves the problem for the shell of the constructor; only what is not geometry may differ.
  Shell_solution operator()(const Shell_problem& problem)
  {
    m_problem = problem;
    find_forbidden_entities();
    Shell_solution solution;
    const Covering_mesh* best = nullptr;
    std::array<int, 3> best_vector;
    for(const Covering_mesh& mesh : m_meshes)
    {
      if(! is_valid(mesh))
        continue;
      if(static_cast<int>(mesh.core.size()) != m)
        ++solution.number_of_valid;
      const std::array<int, 3> v = quality_vector(mesh);
      const bool is_better = best == nullptr || v > best_vector;
      if(is_better)
        solution.number_of_optimal = 0;
      if(is_better || (v == best_vector && mesh.core < best->core))
      {
        best = &mesh;
        best_vector = v;
      }
      if(v == best_vector)
        ++solution.number_of_optimal;
    }
    assert(best != nullptr); // at least the present one
    solution.core = best->core;
    const int n = static_cast<int>(best->core.size());
    if(n == 0)
      triangulate_ring(0, m, solution.triangles);
    for(int c = 0; c < n; ++c)
    {
      const int i = best->core[c], j = best->core[(c + 1) % n];
      triangulate_ring(i, (j - i + m) % m + 1, solution.triangles);
    }
    return solution;
  }

private:
  // ---- geometry ----

  Mask bit(const int i) const { return Mask(1) << i; }
  Mask a() const { return bit(m); }
  Mask b() const { return bit(m + 1); }
  bool is_finite(const Mask s) const { return m_problem.h < 0 || (s & bit(m_problem.h)) == 0; }

  const Lattice_point& point(const int i) const
  {
    return i == m ? m_problem.a : i == m + 1 ? m_problem.b : m_problem.ring[i];
  }

  Lattice_points points(const Mask s) const
  {
    Lattice_points result;
    for(int i = 0; i < m + 2; ++i)
      if(s & bit(i))
        result.push_back(point(i));
    return result;
  }

  // The tetrahedron is given in the order that makes a positive one positive. That of an infinite cell is positive if
  // no vertex of the shell is in front of its finite facet, and one is behind it: the hull stays convex.
  bool is_positive(std::array<int, 4> t) const
  {
    const auto h = std::find(t.begin(), t.end(), m_problem.h);
    if(m_problem.h < 0 || h == t.end())
      return volume(point(t[0]), point(t[1]), point(t[2]), point(t[3])) > 0;
    const int k = static_cast<int>(h - t.begin());
    std::array<int, 3> facet = {{ t[(k + 1) % 4], t[(k + 2) % 4], t[(k + 3) % 4] }};
    if(k % 2 == 0) // (facet, h) has to be an even permutation of t
      std::swap(facet[0], facet[1]);
    bool is_something_behind = false;
    for(int i = 0; i < m + 2; ++i)
      if(i != m_problem.h)
      {
        const Wide side = volume(point(facet[0]), point(facet[1]), point(facet[2]), point(i));
        if(side > 0)
          return false;
        is_something_behind |= side < 0;
      }
    return is_something_behind;
  }

  // Validity and quality of the tetrahedra that any covering mesh can have.
  void judge_tetrahedra()
  {
    for(int i = 0; i < m; ++i)
      for(int j = 0; j < m; ++j)
      {
        if(j == i)
          continue;
        judge({{ m, m + 1, i, j }}, m_is_core_positive[std::make_pair(i, j)]);
        for(int k = i + 1; k < j; ++k)
        {
          bool is_positive_at_a, is_positive_at_b;
          judge({{ i, k, j, m + 1 }}, is_positive_at_b);
          judge({{ i, j, k, m }}, is_positive_at_a);
          m_is_triangle_positive[bit(i) | bit(k) | bit(j)] = is_positive_at_a && is_positive_at_b;
        }
      }
    std::vector<Exact_quality> sorted;
    for(const auto& q : m_qualities)
      sorted.push_back(q.second);
    std::sort(sorted.begin(), sorted.end());
    for(const auto& q : m_qualities)
      m_ranks[q.first] = static_cast<int>(std::lower_bound(sorted.begin(), sorted.end(), q.second) - sorted.begin());
  }

  // 72 sqrt(3) V / (sum of squared lengths)^(3/2), in a form that can be compared exactly.
  struct Exact_quality
  {
    boost::multiprecision::cpp_int squared_volume, cubed_sum;

    friend bool operator<(const Exact_quality& x, const Exact_quality& y)
    {
      return x.squared_volume * y.cubed_sum < y.squared_volume * x.cubed_sum;
    }
  };

  void judge(const std::array<int, 4>& t, bool& is_tetrahedron_positive)
  {
    is_tetrahedron_positive = is_positive(t);
    const Mask s = bit(t[0]) | bit(t[1]) | bit(t[2]) | bit(t[3]);
    if(! is_tetrahedron_positive || ! is_finite(s))
      return;
    Wide sum = 0;
    for(int i = 0; i < 4; ++i)
      for(int j = 0; j < i; ++j)
        sum += dot(point(t[i]) - point(t[j]), point(t[i]) - point(t[j]));
    const Wide v = volume(point(t[0]), point(t[1]), point(t[2]), point(t[3]));
    const boost::multiprecision::cpp_int big_v(v), big_sum(sum);
    m_qualities[s] = { big_v * big_v, big_sum * big_sum * big_sum };
  }

  // ---- enumeration ----

  void enumerate(const Mask core_mask)
  {
    Covering_mesh mesh;
    for(int i = 0; i < m; ++i)
      if(core_mask & bit(i))
        mesh.core.push_back(i);
    const int n = static_cast<int>(mesh.core.size());
    if(n == 1 || n == 2)
      return;
    for(int c = 0; c < n; ++c)
    {
      const int i = mesh.core[c], j = mesh.core[(c + 1) % n];
      if(! m_is_core_positive[std::make_pair(i, j)])
        return;
      mesh.tetrahedra.push_back(a() | b() | bit(i) | bit(j));
    }
    enumerate_rings(mesh, 0);
  }

  // Adds all triangulations of the rings from number c on.
  void enumerate_rings(const Covering_mesh& mesh, const int c)
  {
    const int n = static_cast<int>(mesh.core.size());
    if(c == (std::max)(n, 1))
    {
      m_meshes.push_back(mesh);
      find_entities(m_meshes.back());
      return;
    }
    const int i = n == 0 ? 0 : mesh.core[c];
    const int size = n == 0 ? m : (mesh.core[(c + 1) % n] - i + m) % m + 1;
    for(const auto& triangulation : polygon_triangulations(size))
    {
      Covering_mesh next(mesh);
      bool is_positive = true;
      for(const Triangle& t : triangulation)
      {
        const Triangle s = {{ (t[0] + i) % m, (t[1] + i) % m, (t[2] + i) % m }};
        const Mask mask = bit(s[0]) | bit(s[1]) | bit(s[2]);
        if(! m_is_triangle_positive[mask])
        {
          is_positive = false;
          break;
        }
        next.triangles.push_back(s);
        next.tetrahedra.push_back(mask | a());
        next.tetrahedra.push_back(mask | b());
      }
      if(is_positive)
        enumerate_rings(next, c + 1);
    }
  }

  // What is inside: faces of two tetrahedra, and edges of no face of one tetrahedron only.
  void find_entities(Covering_mesh& mesh) const
  {
    std::map<Mask, int> faces;
    std::map<Mask, bool> is_edge_inside;
    for(const Mask t : mesh.tetrahedra)
      for(int i = 0; i < m + 2; ++i)
        if(t & bit(i))
          ++faces[t & ~bit(i)];
    for(const int number : { 2, 1 })
      for(const auto& f : faces)
        if(f.second == number)
          for(int i = 0; i < m + 2; ++i)
            if(f.first & bit(i))
              is_edge_inside[f.first & ~bit(i)] = number == 2;
    for(const auto& f : faces)
    {
      assert(f.second <= 2);
      if(f.second == 2)
        add_entity(mesh, f.first);
    }
    for(const auto& e : is_edge_inside)
      if(e.second)
        add_entity(mesh, e.first);
  }

  void add_entity(Covering_mesh& mesh, const Mask entity) const
  {
    mesh.interior_entities.push_back(entity);
    if((entity & (a() | b())) != (a() | b()))
      mesh.new_entities.push_back(entity);
  }

  // ---- validity and quality ----

  bool intersects(const Mask entity, const Lattice_points& c) const
  {
    if(! is_finite(entity))
      return false;
    const Lattice_points e = points(entity);
    if(e.size() == 2)
      return c.size() == 2 ? do_cross(c[0], c[1], e[0], e[1]) : does_pierce(e[0], e[1], c[0], c[1], c[2]);
    return c.size() == 2 && does_pierce(c[0], c[1], e[0], e[1], e[2]);
  }

  void find_forbidden_entities()
  {
    m_is_forbidden.clear();
    m_counts.clear();
    for(const Covering_mesh& mesh : m_meshes)
      for(const Mask entity : mesh.interior_entities)
      {
        if(m_counts.count(entity) != 0)
          continue;
        bool is_forbidden = false;
        for(const auto* constraints : { &m_problem.brc1, &m_problem.brc2 })
          for(const Lattice_points& c : *constraints)
            is_forbidden |= intersects(entity, c);
        if(points(entity).size() == 3)
          for(const Mask e : m_problem.ancestors)
            is_forbidden |= (entity & e) == e;
        m_is_forbidden[entity] = is_forbidden;
        m_counts[entity] = 0;
        for(const Lattice_points& c : m_problem.lost)
          m_counts[entity] += intersects(entity, c);
      }
  }

  bool is_valid(const Covering_mesh& mesh) const
  {
    if(m_problem.keeps_edge && ! mesh.has_edge())
      return false;
    for(int i = 0; i < m; ++i)
      if(m_problem.is_kept[i] && ! mesh.has_face(i))
        return false;
    return std::none_of(mesh.new_entities.begin(), mesh.new_entities.end(),
                        [this](const Mask e) { return m_is_forbidden.at(e); });
  }

  int quality(const std::vector<Mask>& tetrahedra, const std::vector<Mask>& entities) const
  {
    int q = m_problem.quality == Shell_problem::WORST_ELEMENT ? (std::numeric_limits<int>::max)() : 0;
    if(m_problem.quality == Shell_problem::WORST_ELEMENT)
      for(const Mask t : tetrahedra)
        if(is_finite(t))
          q = (std::min)(q, m_ranks.at(t));
    if(m_problem.quality == Shell_problem::FEWEST_INTERSECTIONS)
      for(const Mask e : entities)
        q -= m_counts.at(e);
    return q;
  }

  std::array<int, 3> quality_vector(const Covering_mesh& mesh) const
  {
    const int q = quality(mesh.tetrahedra, mesh.interior_entities);
    const int q1 = m_problem.f < 0 || ! mesh.has_face(m_problem.f);
    const int q2 = - static_cast<int>(mesh.core.size());
    if(m_problem.quality == Shell_problem::FEWEST_INTERSECTIONS)
      return {{ q, q1, q2 }};
    return {{ q1, q2, q }};
  }

  // ---- ties ----

  // The best triangulation of the ring of `size` vertices from i: of those with the best value, the one with the
  // first apex; then the same for the two smaller rings.
  void triangulate_ring(const int i, const int size, std::vector<Triangle>& triangles) const
  {
    if(size == 2)
      return;
    int best_apex = -1, best_value = 0;
    for(const auto& triangulation : polygon_triangulations(size))
    {
      std::vector<Mask> tetrahedra, entities;
      bool is_valid = true;
      for(const Triangle& t : triangulation)
      {
        const Mask x = bit((t[0] + i) % m), y = bit((t[1] + i) % m), z = bit((t[2] + i) % m);
        tetrahedra.push_back(x | y | z | a());
        tetrahedra.push_back(x | y | z | b());
        entities.push_back(x | y | z);
        if(t[2] - t[0] + 1 < size)
          for(const Mask end : { Mask(0), a(), b() })
            entities.push_back(x | z | end);
        is_valid &= m_is_triangle_positive.at(x | y | z) && is_allowed(triangulation, i, size);
      }
      if(! is_valid)
        continue;
      const int value = quality(tetrahedra, entities);
      const int apex = triangulation.front()[1];
      if(best_apex < 0 || value > best_value || (value == best_value && apex < best_apex))
      {
        best_apex = apex;
        best_value = value;
      }
    }
    assert(best_apex > 0);
    triangles.push_back({{ i, (i + best_apex) % m, (i + size - 1) % m }});
    triangulate_ring(i, best_apex + 1, triangles);
    triangulate_ring((i + best_apex) % m, size - best_apex, triangles);
  }

  // Whether the triangulation of a ring has no forbidden entity. One that no positive covering mesh has is not
  // forbidden; the ring then is not that of the optimum in any case.
  bool is_allowed(const std::vector<Triangle>& triangulation, const int i, const int size) const
  {
    for(const Triangle& t : triangulation)
    {
      const Mask x = bit((t[0] + i) % m), y = bit((t[1] + i) % m), z = bit((t[2] + i) % m);
      if(is_forbidden(x | y | z))
        return false;
      if(t[2] - t[0] + 1 < size)
        for(const Mask end : { Mask(0), a(), b() })
          if(is_forbidden(x | z | end))
            return false;
    }
    return true;
  }

  bool is_forbidden(const Mask entity) const
  {
    const auto found = m_is_forbidden.find(entity);
    return found != m_is_forbidden.end() && found->second;
  }

  Shell_problem m_problem;
  const int m;
  std::map<std::pair<int, int>, bool> m_is_core_positive;
  std::map<Mask, bool> m_is_triangle_positive;
  std::map<Mask, Exact_quality> m_qualities;
  std::map<Mask, int> m_ranks;
  std::vector<Covering_mesh> m_meshes;
  std::map<Mask, bool> m_is_forbidden;
  std::map<Mask, int> m_counts;
};

} // namespace br3_test

#endif // BR3_TEST_REFERENCE_COVERING_MESH_H

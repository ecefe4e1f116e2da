// Shell transformations: what they do to the triangulation, and that they do nothing else to it.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "reference_covering_mesh.h"

#include <CGAL/Boundary_recovery_3/Meshing_visitor_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Shell_transformation_3.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <iostream>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace BR = CGAL::Boundary_recovery_3;
using namespace br3_test;

// How often each kind of case was met; main() checks that all of them were.
std::map<std::string, int> number_of;

typedef std::array<int, 4> Tetrahedron; // sorted indices, -1 for the infinite vertex
typedef std::set<Tetrahedron> Tetrahedra;

template <typename Cell_handle>
Tetrahedron tetrahedron(const Cell_handle c)
{
  Tetrahedron t;
  for(int i = 0; i < 4; ++i)
    t[i] = c->vertex(i)->info();
  std::sort(t.begin(), t.end());
  return t;
}

// Six times the signed volume of a cell, 0 if it is infinite.
template <typename Cell_handle>
Wide volume(const Lattice_points& points, const Cell_handle c)
{
  if(tetrahedron(c)[0] < 0)
    return 0;
  return volume(points[c->vertex(0)->info()], points[c->vertex(1)->info()],
                points[c->vertex(2)->info()], points[c->vertex(3)->info()]);
}

// Delaunay or not.
template <typename Kernel, typename Tds, typename Lock>
bool is_valid_triangulation(const CGAL::Triangulation_3<Kernel, Tds, Lock>& tr)
{
  return tr.CGAL::template Triangulation_3<Kernel, Tds, Lock>::is_valid();
}

// Keeps a copy of the triangulation from what it is told, and a number in each cell.
template <typename Tr>
class Mirror
  : public CGAL::Default_meshing_visitor_3
{
public:
  typedef typename Tr::Cell_handle Cell_handle;

  Mirror(const Tr& tr, const Lattice_points& points) : m_tr(tr), m_points(points)
  {
    for(auto c = tr.all_cells_begin(); c != tr.all_cells_end(); ++c)
      insert(c);
  }

  template <typename CellRange>
  void before_cells_removal(const CellRange& cells)
  {
    assert(! m_is_inside);
    m_is_inside = true;
    m_volume = 0;
    for(const Cell_handle c : cells)
    {
      assert(m_tr.tds().is_cell(c));
      m_volume += volume(m_points, c);
      assert(m_tetrahedra.erase(tetrahedron(c)) == 1);
      assert(m_numbers.erase(c->info()) == 1);
    }
  }

  template <typename CellRange>
  void after_cells_creation(const CellRange& cells)
  {
    assert(m_is_inside);
    m_is_inside = false;
    ++m_number_of_calls;
    for(const Cell_handle c : cells)
    {
      assert(m_tr.tds().is_cell(c));
      const Wide v = volume(m_points, c);
      assert(v > 0 || m_tr.is_infinite(c));
      m_volume -= v;
      insert(c);
    }
    assert(m_volume == 0);
  }

  // Compares the copy with the triangulation. Cells that were not replaced have the number that they got at first.
  void check() const
  {
    assert(! m_is_inside);
    Tetrahedra tetrahedra;
    for(auto c = m_tr.all_cells_begin(); c != m_tr.all_cells_end(); ++c)
    {
      assert(tetrahedra.insert(tetrahedron(c)).second);
      assert(m_numbers.at(c->info()) == tetrahedron(c));
    }
    assert(tetrahedra == m_tetrahedra && m_numbers.size() == tetrahedra.size());
  }

  const Tetrahedra& tetrahedra() const { return m_tetrahedra; }
  std::size_t number_of_calls() const { return m_number_of_calls; }

private:
  void insert(const Cell_handle c)
  {
    assert(m_tetrahedra.insert(tetrahedron(c)).second);
    c->info() = m_next_number++;
    m_numbers[c->info()] = tetrahedron(c);
  }

  const Tr& m_tr;
  const Lattice_points& m_points;
  Tetrahedra m_tetrahedra;
  std::map<int, Tetrahedron> m_numbers;
  int m_next_number = 0;
  bool m_is_inside = false;
  Wide m_volume = 0;
  std::size_t m_number_of_calls = 0;
};

// Condition 2 of [CZZ+17, Section 3.2] for the root of the recursion, seen from outside: when another shell
// gets a new covering mesh, none of the new faces has the root edge.
template <typename Tr>
struct Root_watch
  : public BR::No_shell_validity_3
{
  typedef typename Tr::Vertex_handle Vertex_handle;
  typedef BR::Shell_3<Tr> Shell;

  const std::set<Vertex_handle>* root; // its ends, empty if there is no root

  explicit Root_watch(const std::set<Vertex_handle>& root) : root(&root) { }

  void check_face(const std::set<Vertex_handle>& face) const
  {
    assert(! std::includes(face.begin(), face.end(), root->begin(), root->end()));
  }

  bool is_valid_covering_mesh(const Shell& s, const BR::Partial_triangulation& k) const
  {
    assert(k.core_size() < s.degree() && (k.core_size() == 0 || k.core_size() >= 3));
    assert(static_cast<int>(k.triangles.size()) == s.degree() - (k.core.empty() ? 2 : k.core_size()));
    if(root->empty() || *root == std::set<Vertex_handle>{ s.a(), s.b() })
      return true;
    ++number_of["covering meshes of other shells than that of the root"];
    for(const auto& t : k.triangles)
    {
      check_face({ s.vertex(t[0]), s.vertex(t[1]), s.vertex(t[2]) });
      if(t[2] != s.previous(t[0]))
        for(const Vertex_handle end : { s.a(), s.b() })
          check_face({ end, s.vertex(t[0]), s.vertex(t[2]) });
    }
    return true;
  }
};

template <typename Tr_>
class Tester
{
public:
  typedef Tr_ Tr;
  typedef typename Tr::Vertex_handle Vertex_handle;
  typedef typename Tr::Cell_handle   Cell_handle;
  typedef typename Tr::Edge          Edge;
  typedef typename Tr::Facet         Facet;
  typedef BR::Shell_3<Tr>            Shell;
  typedef BR::internal::Constraints_3<Tr>           Constraints;
  typedef BR::Kept_constraints_3<Constraints>       Kept_constraints;
  typedef BR::Shell_validity_conjunction_3<Kept_constraints, Root_watch<Tr> > Validity;

  Tester(Tr& tr, const Lattice_points& points, std::mt19937& rng)
    : m_tr(tr), m_points(points), m_rng(rng), m_vertices(finite_vertices(tr)), m_volume(total_volume()),
      m_mirror(tr, m_points)
  { }

  // Keeps some of the edges and facets, where every facet keeps its edges.
  void choose_constraints(const int number_of_edges, const int number_of_facets)
  {
    const auto cells = finite_cells(m_tr);
    for(int k = 0; k < number_of_edges + number_of_facets; ++k)
    {
      const Cell_handle c = cells[random_int(m_rng, static_cast<int>(cells.size()))];
      const int i = random_int(m_rng, 4);
      if(k < number_of_edges)
        m_constraints.insert(c->vertex(i), c->vertex((i + 1) % 4));
      else
        m_constraints.insert(c->vertex(i), c->vertex((i + 1) % 4), c->vertex((i + 2) % 4));
    }
  }

  // Transforms the shell of each edge once, and compares with the reference.
  template <typename Quality>
  void transform_all(const Quality& quality, const Shell_problem::Quality kind)
  {
    typedef CGAL::Shell_transformation_3<Tr, Quality, Validity, Mirror<Tr> > Transformation;
    Transformation transformation(m_tr, quality, validity(), m_mirror);
    for(const auto& e : all_edges())
    {
      Cell_handle c;
      int i, j;
      if(! m_tr.is_edge(e.first, e.second, c, i, j))
        continue;
      const Shell shell(m_tr, c, i, j);
      const int f = random_int(m_rng, 2) == 0 ? -1 : random_int(m_rng, shell.degree());
      Tetrahedra expected;
      const int n = expected_core_size(shell, f, kind, expected);
      const auto outcome = transformation(Edge(c, i, j), f < 0 ? Vertex_handle() : shell.vertex(f));
      assert(n < 0 || m_mirror.tetrahedra() == expected);
      check_outcome(outcome == transformation.REMOVED, outcome == transformation.REDUCED, shell.degree(), n, e);
    }
    assert(transformation.number_of_transformations() == m_mirror.number_of_calls() - m_number_of_calls);
    check();
  }

  // Removes edges and facets with recursion.
  template <typename Quality>
  void remove_all(const Quality& quality)
  {
    typedef CGAL::Shell_transformation_3<Tr, Quality, Validity, Mirror<Tr> > Transformation;
    Transformation transformation(m_tr, quality, validity(), m_mirror);
    for(const auto& e : all_edges())
      if(random_int(m_rng, 2) == 0)
        remove_edge(transformation, e);
    assert(transformation.number_of_transformations() == m_mirror.number_of_calls() - m_number_of_calls);
    check();
    for(const auto& f : all_facets())
      if(random_int(m_rng, 4) == 0)
        remove_facet(transformation, f);
    assert(transformation.number_of_transformations() == m_mirror.number_of_calls() - m_number_of_calls);
    check();
  }

  // Edges at the infinite vertex are refused.
  void check_infinite_edges()
  {
    CGAL::Shell_transformation_3<Tr> transformation(m_tr, BR::Worst_element_quality_3<Tr>(m_tr));
    const Tetrahedra before = m_mirror.tetrahedra();
    std::vector<Cell_handle> cells;
    m_tr.incident_cells(m_tr.infinite_vertex(), std::back_inserter(cells));
    for(const Cell_handle c : cells)
    {
      const int i = c->index(m_tr.infinite_vertex()), j = (i + 1) % 4;
      assert(transformation(Edge(c, i, j)) == transformation.UNCHANGED);
      assert(! transformation.remove_edge(Edge(c, j, i), 3));
      ++number_of["infinite edge refused"];
    }
    assert(transformation.number_of_transformations() == 0);
    m_mirror.check();
    assert(m_mirror.tetrahedra() == before);
  }

  const Tetrahedra& tetrahedra() const { return m_mirror.tetrahedra(); }

private:
  Validity validity()
  {
    m_number_of_calls = m_mirror.number_of_calls();
    m_root.clear();
    return Validity(Kept_constraints(m_constraints), Root_watch<Tr>(m_root));
  }

  // By indices, so that the order does not depend on the container.
  std::vector<std::pair<Vertex_handle, Vertex_handle> > all_edges() const
  {
    std::set<std::pair<int, int> > indices;
    for(auto e = m_tr.finite_edges_begin(); e != m_tr.finite_edges_end(); ++e)
      indices.insert(std::minmax({ e->first->vertex(e->second)->info(), e->first->vertex(e->third)->info() }));
    std::vector<std::pair<Vertex_handle, Vertex_handle> > edges;
    for(const auto& e : indices)
      edges.push_back(std::make_pair(m_vertices[e.first], m_vertices[e.second]));
    return edges;
  }

  std::vector<std::array<Vertex_handle, 3> > all_facets() const
  {
    std::set<std::array<int, 3> > indices;
    for(auto f = m_tr.finite_facets_begin(); f != m_tr.finite_facets_end(); ++f)
    {
      std::array<int, 3> t;
      for(int i = 0; i < 3; ++i)
        t[i] = f->first->vertex((f->second + i + 1) % 4)->info();
      std::sort(t.begin(), t.end());
      indices.insert(t);
    }
    std::vector<std::array<Vertex_handle, 3> > facets;
    for(const auto& t : indices)
      facets.push_back({{ m_vertices[t[0]], m_vertices[t[1]], m_vertices[t[2]] }});
    return facets;
  }

  // The size of the optimal core, and all cells as they have to be after the transformation; -1 if the shell is too
  // large.
  int expected_core_size(const Shell& shell, const int f, const Shell_problem::Quality kind, Tetrahedra& expected) const
  {
    const int m = shell.degree();
    if(m > 9)
      return -1;
    Shell_problem problem;
    problem.a = m_points[shell.a()->info()];
    problem.b = m_points[shell.b()->info()];
    problem.h = shell.infinite_index();
    problem.f = f;
    problem.quality = kind;
    problem.keeps_edge = m_constraints.is_constrained(shell.a(), shell.b());
    for(int i = 0; i < m; ++i)
    {
      problem.ring.push_back(i == problem.h ? Lattice_point{ 0, 0, 0 } : m_points[shell.vertex(i)->info()]);
      problem.is_kept.push_back(m_constraints.is_constrained(shell.a(), shell.b(), shell.vertex(i)));
    }
    const Shell_solution solution = Reference_search(problem)(problem);
    expected = m_mirror.tetrahedra();
    for(int i = 0; i < m; ++i)
      expected.erase(tetrahedron(shell.cell(i)));
    const int n = static_cast<int>(solution.core.size());
    for(int c = 0; c < n; ++c)
    {
      const int i = solution.core[c], j = solution.core[(c + 1) % n];
      insert(expected, { shell.a(), shell.b(), shell.vertex(i), shell.vertex(j) });
    }
    for(const Triangle& t : solution.triangles)
      for(const Vertex_handle end : { shell.a(), shell.b() })
        insert(expected, { shell.vertex(t[0]), shell.vertex(t[1]), shell.vertex(t[2]), end });
    return n;
  }

  static void insert(Tetrahedra& tetrahedra, const std::array<Vertex_handle, 4>& vertices)
  {
    Tetrahedron t;
    for(int i = 0; i < 4; ++i)
      t[i] = vertices[i]->info();
    std::sort(t.begin(), t.end());
    assert(tetrahedra.insert(t).second);
  }

  void check_outcome(const bool is_removed, const bool is_reduced, const int degree, const int n,
                     const std::pair<Vertex_handle, Vertex_handle>& e)
  {
    const bool is_hull_edge = this->is_hull_edge(e.first, e.second);
    Cell_handle c;
    int i, j;
    assert(m_tr.is_edge(e.first, e.second, c, i, j) == ! is_removed);
    const int new_degree = is_removed ? 0 : Shell(m_tr, c, i, j).degree();
    assert(n < 0 || n == new_degree);
    assert(is_reduced == (! is_removed && new_degree < degree));
    ++number_of[is_removed ? "shell removed" : is_reduced ? "shell reduced" : "shell unchanged"];
    if(is_hull_edge)
      ++number_of["hull edge stays"];
    if(m_constraints.is_constrained(e.first, e.second))
      ++number_of[is_reduced ? "shell of constrained edge reduced" : "shell of constrained edge unchanged"];
  }

  bool is_hull_edge(const Vertex_handle u, const Vertex_handle v) const
  {
    Cell_handle c;
    int i, j;
    return m_tr.is_edge(u, v, c, i, j) && Shell(m_tr, c, i, j).infinite_index() != Shell::none;
  }

  template <typename Transformation>
  void remove_edge(Transformation& transformation, const std::pair<Vertex_handle, Vertex_handle>& e)
  {
    m_root = { e.first, e.second };
    for(int l_max = 0; l_max < 4; ++l_max)
    {
      Cell_handle c;
      int i, j;
      if(! m_tr.is_edge(e.first, e.second, c, i, j))
        return;
      const bool was_on_hull = is_hull_edge(e.first, e.second);
      const int degree = Shell(m_tr, c, i, j).degree();
      const bool has_few_shells = random_int(m_rng, 4) == 0;
      transformation.set_max_number_of_shells(has_few_shells ? 1 : Transformation::default_max_number_of_shells);
      const std::size_t before = transformation.number_of_transformations();
      const bool is_removed = transformation.remove_edge(Edge(c, i, j), l_max);
      assert(is_removed == ! m_tr.is_edge(e.first, e.second, c, i, j));
      assert(is_removed || Shell(m_tr, c, i, j).degree() <= degree);
      assert(! has_few_shells || transformation.number_of_transformations() <= before + 1);
      if(m_constraints.is_constrained(e.first, e.second))
      {
        assert(! is_removed);
        ++number_of["constrained edge refused"];
      }
      ++number_of[is_removed ? "edge removed at level " + std::to_string(l_max) : "edge not removed"];
      if(is_removed && was_on_hull)
        ++number_of["hull edge removed"];
    }
  }

  template <typename Transformation>
  void remove_facet(Transformation& transformation, const std::array<Vertex_handle, 3>& f)
  {
    m_root.clear();
    for(int l_max = 0; l_max < 3; ++l_max)
    {
      Cell_handle c;
      int i, j, k;
      if(! m_tr.is_facet(f[0], f[1], f[2], c, i, j, k))
        return;
      const std::size_t bound = random_int(m_rng, 4) == 0 ? 6 : Transformation::default_max_number_of_shells;
      transformation.set_max_number_of_shells(bound);
      const std::size_t shells = transformation.number_of_shells();
      const bool is_removed = transformation.remove_facet(Facet(c, 6 - i - j - k), l_max);
      assert(transformation.number_of_shells() - shells <= bound + 3); // the first one too many of each edge counts
      assert(is_removed == ! m_tr.is_facet(f[0], f[1], f[2], c, i, j, k));
      if(m_constraints.is_constrained(f[0], f[1], f[2]))
      {
        assert(! is_removed);
        ++number_of["constrained facet refused"];
      }
      ++number_of[is_removed ? "facet removed at level " + std::to_string(l_max) : "facet not removed"];
    }
  }

  Wide total_volume() const
  {
    Wide v = 0;
    for(auto c = m_tr.finite_cells_begin(); c != m_tr.finite_cells_end(); ++c)
      v += volume(m_points, Cell_handle(c));
    return v;
  }

  void check() const
  {
    m_mirror.check();
    assert(m_tr.tds().is_valid());
    assert(is_valid_triangulation(m_tr));
    assert(total_volume() == m_volume);
    assert(finite_vertices(m_tr) == m_vertices);
    check_hull();
    for(const auto& e : m_constraints.edges())
    {
      Cell_handle c;
      int i, j;
      assert(m_tr.is_edge(e[0], e[1], c, i, j));
    }
    for(const auto& f : m_constraints.facets())
    {
      Cell_handle c;
      int i, j, k;
      assert(m_tr.is_facet(f[0], f[1], f[2], c, i, j, k));
    }
  }

  // No vertex is in front of a facet of the hull.
  void check_hull() const
  {
    std::vector<Cell_handle> cells;
    m_tr.incident_cells(m_tr.infinite_vertex(), std::back_inserter(cells));
    for(const Cell_handle c : cells)
    {
      const int k = c->index(m_tr.infinite_vertex());
      std::array<int, 3> f;
      for(int i = 0; i < 3; ++i)
        f[i] = c->vertex(Tr::vertex_triple_index(k, i))->info();
      assert(! is_zero(cross(m_points[f[1]] - m_points[f[0]], m_points[f[2]] - m_points[f[0]])));
      // the triple is oriented such that the fourth vertex, here the outside, is on its positive side
      for(const Lattice_point& p : m_points)
        assert(volume(m_points[f[0]], m_points[f[1]], m_points[f[2]], p) <= 0);
    }
  }

  Tr& m_tr;
  const Lattice_points m_points;
  std::mt19937& m_rng;
  const std::vector<Vertex_handle> m_vertices;
  const Wide m_volume;
  Mirror<Tr> m_mirror;
  Constraints m_constraints;
  std::set<Vertex_handle> m_root;
  std::size_t m_number_of_calls = 0;
};

// All of it on one point set. Returns the cells at the end.
template <typename Kernel>
Tetrahedra test_points(const Lattice_points& points, const int divisor, const int number_of_constraints,
                       const unsigned seed)
{
  // a Delaunay triangulation, and the base class, are equally good
  typedef typename Triangulations<Kernel>::Delaunay Tr;
  std::mt19937 rng(seed);
  Tr tr;
  insert_points(tr, points, divisor);
  if(tr.dimension() < 3)
    return Tetrahedra();
  flip_at_random<Kernel>(tr, random_int(rng, 50), rng);
  Tester<Tr> tester(tr, points, rng);
  tester.choose_constraints(number_of_constraints, number_of_constraints / 2);
  tester.check_infinite_edges();
  if(random_int(rng, 2) == 0)
    tester.remove_all(BR::No_shell_quality_3());
  if(divisor == 1) // otherwise the quality is rounded, and no reference knows it
    tester.transform_all(BR::Worst_element_quality_3<Tr>(tr), Shell_problem::WORST_ELEMENT);
  tester.transform_all(BR::No_shell_quality_3(), Shell_problem::NONE);
  tester.remove_all(BR::Worst_element_quality_3<Tr>(tr));
  return tester.tetrahedra();
}

// Every point set twice: nothing may depend on addresses.
template <typename Kernel>
void test_twice(const Lattice_points& points, const int divisor, const int number_of_constraints, std::mt19937& rng)
{
  const unsigned seed = static_cast<unsigned>(rng());
  const Tetrahedra first = test_points<Kernel>(points, divisor, number_of_constraints, seed);
  const std::vector<int> something_else(1000 + random_int(rng, 1000)); // moves what comes behind it in memory
  assert(test_points<Kernel>(points, divisor, number_of_constraints, seed) == first);
  assert(! something_else.empty());
}

template <typename Kernel>
void test_kernel(const int n, const int divisor, const unsigned seed)
{
  std::mt19937 rng(seed);
  for(int k = 0; k < n; ++k)
  {
    test_twice<Kernel>(random_points(30, 2000, rng), divisor, k % 3 * 8, rng);
    test_twice<Kernel>(random_points(25, 5, rng), divisor, k % 3 * 8, rng);
    test_twice<Kernel>(grid_points(3, 3, 3, 100, rng), divisor, k % 3 * 8, rng);
    test_twice<Kernel>(grid_points(4, 3, 3, 80, rng), divisor, (k + 1) % 3 * 8, rng);
    test_twice<Kernel>(ring_points(10, k % 2 == 0, false, rng), divisor, k % 3, rng);
  }
}

// The usual triangulation, without anything in its vertices and cells, and with the default arguments.
template <typename Kernel>
void test_default_bases()
{
  typedef CGAL::Delaunay_triangulation_3<Kernel> Tr;
  std::mt19937 rng(5);
  Tr tr;
  for(const Lattice_point& p : random_points(60, 12, rng))
    tr.insert(typename Tr::Point(static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)));
  CGAL::Shell_transformation_3<Tr> transformation(tr, BR::Worst_element_quality_3<Tr>(tr));
  assert(&transformation.triangulation() == &tr);
  std::vector<std::pair<typename Tr::Vertex_handle, typename Tr::Vertex_handle> > edges;
  for(auto e = tr.finite_edges_begin(); e != tr.finite_edges_end(); ++e)
    edges.push_back(std::make_pair(e->first->vertex(e->second), e->first->vertex(e->third)));
  int number_of_removals = 0;
  for(const auto& e : edges)
  {
    typename Tr::Cell_handle c;
    int i, j;
    if(tr.is_edge(e.first, e.second, c, i, j) && transformation.remove_edge(typename Tr::Edge(c, i, j), 2))
    {
      assert(! tr.is_edge(e.first, e.second, c, i, j));
      ++number_of_removals;
    }
  }
  assert(number_of_removals > 50 && transformation.number_of_transformations() > 50);
  assert(is_valid_triangulation(tr));
}

template <typename Function>
bool is_refused(const Function& function)
{
  try
  {
    function();
  }
  catch(const CGAL::Precondition_exception&)
  {
    return true;
  }
  return false;
}

// Triangulations of dimension 1 and 2 have no shells.
template <typename Kernel>
void test_dimension()
{
  typedef CGAL::Delaunay_triangulation_3<Kernel> Tr;
  typedef typename Tr::Point Point;
  const auto handler = CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) { });
  Tr tr;
  tr.insert(Point(0, 0, 0));
  tr.insert(Point(1, 0, 0));
  for(int dimension = 1; dimension < 3; ++dimension)
  {
    assert(tr.dimension() == dimension);
    CGAL::Shell_transformation_3<Tr> transformation(tr, BR::Worst_element_quality_3<Tr>(tr));
    const typename Tr::Edge e = *tr.finite_edges_begin();
    assert(is_refused([&]() { transformation(e); }));
    assert(is_refused([&]() { transformation.remove_edge(e, 0); }));
    if(dimension == 2)
      assert(is_refused([&]() { transformation.remove_facet(*tr.finite_facets_begin(), 0); }));
    tr.insert(Point(0, 1, 0));
  }
  tr.insert(Point(0, 0, 1));
  CGAL::Shell_transformation_3<Tr> transformation(tr, BR::Worst_element_quality_3<Tr>(tr));
  assert(! is_refused([&]() { assert(! transformation.remove_edge(*tr.finite_edges_begin(), 3)); }));
  CGAL::set_error_handler(handler);
}

// No test may pass because nothing was tested.
void check_that_all_was_met()
{
  for(const auto& n : number_of)
    std::cout << n.second << "\t" << n.first << std::endl;
  for(const std::string what : { "shell removed", "shell reduced", "shell unchanged",
                                 "hull edge stays", "hull edge removed",
                                 "shell of constrained edge reduced", "shell of constrained edge unchanged",
                                 "edge removed at level 0", "edge removed at level 1", "edge removed at level 2",
                                 "edge not removed", "facet removed at level 0", "facet removed at level 1",
                                 "facet not removed", "constrained edge refused", "constrained facet refused",
                                 "infinite edge refused", "covering meshes of other shells than that of the root" })
    assert(number_of[what] >= 20);
}

int main()
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel EPICK;
  typedef CGAL::Exact_predicates_exact_constructions_kernel   EPECK;
  test_kernel<EPICK>(3, 1, 11);
  test_kernel<EPECK>(1, 1, 12);
  test_kernel<EPECK>(1, 3, 13); // coordinates that are not doubles
  test_default_bases<EPICK>();
  test_default_bases<EPECK>();
  test_dimension<EPICK>();
  test_dimension<EPECK>();
  check_that_all_was_met();
  return 0;
}

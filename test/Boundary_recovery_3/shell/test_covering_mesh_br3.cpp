// The search for the optimal covering mesh of a shell, against the enumeration of all covering meshes.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "reference_covering_mesh.h"

#include <CGAL/Boundary_recovery_3/Shell_3.h>
#include <CGAL/Boundary_recovery_3/Shell_quality_3.h>
#include <CGAL/Boundary_recovery_3/Shell_validity_3.h>
#include <CGAL/Boundary_recovery_3/internal/lost/Recursive_recovery_3.h>
#include <CGAL/Boundary_recovery_3/internal/shell/Covering_mesh_search_3.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace BR = CGAL::Boundary_recovery_3;
using namespace br3_test;

// How often each kind of case was met; main() checks that all of them were.
std::map<std::string, int> number_of;

constexpr int max_degree = 9;

// Condition 2 of [CZZ+17, Section 3.2] for given edges, from the definition: the new face of a triangle, and the two
// of a chord.
template <typename Tr>
struct Ancestors
  : public BR::No_shell_validity_3
{
  typedef typename Tr::Vertex_handle Vertex_handle;
  typedef BR::Shell_3<Tr> Shell;

  std::vector<std::array<Vertex_handle, 2> > edges;

  bool is_valid_face(const std::set<Vertex_handle>& face) const
  {
    for(const auto& e : edges)
      if(face.count(e[0]) != 0 && face.count(e[1]) != 0)
        return false;
    return true;
  }

  bool is_valid_triangle(const Shell& s, const int i, const int k, const int j) const
  {
    return is_valid_face({ s.vertex(i), s.vertex(k), s.vertex(j) });
  }

  bool is_valid_chord(const Shell& s, const int i, const int j) const
  {
    return is_valid_face({ s.a(), s.vertex(i), s.vertex(j) }) && is_valid_face({ s.b(), s.vertex(i), s.vertex(j) });
  }
};

// A quality of a user, a sum of doubles: the order in which they are added changes the value a little.
template <typename Tr>
struct Sum_of_qualities
{
  typedef double Value;
  typedef BR::Shell_3<Tr> Shell;
  static constexpr bool is_first_in_vector = true;

  explicit Sum_of_qualities(const Tr& tr) : worst(tr) { }

  Value best() const { return 0; }
  Value combine(const Value x, const Value y) const { return x + y; }
  Value of_triangle(const Shell& s, const int i, const int k, const int j) const
  {
    return limit(worst.of_triangle(s, i, k, j));
  }

  Value of_chord(const Shell&, int, int) const { return 0.1; }
  Value of_core_edge(const Shell& s, const int i, const int j) const { return limit(worst.of_core_edge(s, i, j)); }
  Value of_core_vertex(const Shell&, int) const { return - 0.3; }
  Value of_supporting_edge(const Shell&) const { return 0.7; }
  static Value limit(const Value x) { return (std::min)(x, 1.); } // infinite cells have no finite quality

  BR::Worst_element_quality_3<Tr> worst;
};

template <typename Tr_>
class Tester
{
public:
  typedef Tr_ Tr;
  typedef typename Tr::Vertex_handle Vertex_handle;
  typedef typename Tr::Cell_handle   Cell_handle;
  typedef BR::Shell_3<Tr>            Shell;
  typedef BR::internal::Intersection_table_3<Tr, 2>  Edge_table;
  typedef BR::internal::Intersection_table_3<Tr, 3>  Facet_table;

  Tester(const Tr& tr, const Lattice_points& points, std::mt19937& rng)
    : m_tr(tr), m_points(points), m_vertices(finite_vertices(tr)), m_predicates(tr), m_rng(rng)
  { }

  // Checks about one of `stride` finite edges, or just the edge of the first two points.
  void check_edges(const int stride, const bool first_two_points_only)
  {
    for(auto e = m_tr.finite_edges_begin(); e != m_tr.finite_edges_end(); ++e)
    {
      const int i = e->first->vertex(e->second)->info(), j = e->first->vertex(e->third)->info();
      if(first_two_points_only ? i + j == 1 : random_int(m_rng, stride) == 0)
        check_shell(*e);
    }
  }

private:
  // ---- the shell itself ----

  void check_shell(const typename Tr::Edge& e)
  {
    m_shell.assign(m_tr, e.first, e.second, e.third);
    const int m = m_shell.degree();
    assert(m_shell.a() == e.first->vertex(e.second) && m_shell.b() == e.first->vertex(e.third));
    assert(m_shell.cell(0) == e.first);
    std::set<Cell_handle> cells(m_shell.cells().begin(), m_shell.cells().end());
    std::size_t number_of_cells = 0;
    for(auto c = m_tr.all_cells_begin(); c != m_tr.all_cells_end(); ++c)
      if(c->has_vertex(m_shell.a()) && c->has_vertex(m_shell.b()))
      {
        ++number_of_cells;
        assert(cells.count(c) == 1);
      }
    assert(static_cast<int>(number_of_cells) == m && static_cast<int>(cells.size()) == m);
    m_geometry = Shell_problem();
    m_geometry.a = m_points[m_shell.a()->info()];
    m_geometry.b = m_points[m_shell.b()->info()];
    m_geometry.is_kept.assign(m, false);
    m_geometry.h = m_shell.infinite_index();
    for(int i = 0; i < m; ++i)
    {
      const Vertex_handle p = m_shell.vertex(i);
      const int n = m_shell.next(i);
      assert(m_tr.is_infinite(p) == (i == m_geometry.h) && m_shell.index(p) == i);
      assert(n == (i + 1) % m && m_shell.previous(n) == i);
      assert(m_shell.cell(i)->has_vertex(p) && m_shell.cell(i)->has_vertex(m_shell.vertex(n)));
      m_geometry.ring.push_back(m_tr.is_infinite(p) ? Lattice_point{ 0, 0, 0 } : m_points[p->info()]);
    }
    for(int i = 0; i < m; ++i)
      if(i != m_geometry.h && m_shell.next(i) != m_geometry.h)
        assert(volume(m_geometry.a, m_geometry.b, m_geometry.ring[i], m_geometry.ring[(i + 1) % m]) > 0);
    if(m > max_degree)
      return;
    ++number_of["degree " + std::to_string(m)];
    Reference_search reference(m_geometry);
    if(reference.number_of_positive_covering_meshes() > 1 || random_int(m_rng, 10) == 0)
    {
      for(int k = 0; k < 6; ++k)
        check_random_problem(reference);
      check_sum(reference);
    }
  }

  // What comes out is a covering mesh, however the values are rounded.
  void check_sum(const Reference_search& reference)
  {
    const Sum_of_qualities<Tr> quality(m_tr);
    const BR::No_shell_validity_3 validity;
    BR::internal::Covering_mesh_search_3<Tr, Sum_of_qualities<Tr>, BR::No_shell_validity_3>
      search(m_predicates, quality, validity);
    if(! search(m_shell, Shell::none, false, [](int) { return false; }))
      return;
    const BR::Partial_triangulation& k = search.partial_triangulation();
    const std::vector<int> core(k.core.begin(), k.core.end());
    const std::set<Triangle> triangles(k.triangles.begin(), k.triangles.end());
    bool is_found = false;
    for(const Covering_mesh& mesh : reference.meshes())
      is_found |= mesh.core == core && std::set<Triangle>(mesh.triangles.begin(), mesh.triangles.end()) == triangles;
    assert(is_found);
    ++number_of[core.empty() ? "sum of doubles, removed" : "sum of doubles, reduced"];
  }

  // ---- random problems for one shell ----

  Vertex_handle random_vertex(const bool of_shell)
  {
    while(of_shell)
    {
      const int i = random_int(m_rng, m_shell.degree() + 2);
      if(i != m_shell.infinite_index())
        return i == m_shell.degree() ? m_shell.a() : i > m_shell.degree() ? m_shell.b() : m_shell.vertex(i);
    }
    return m_vertices[random_int(m_rng, static_cast<int>(m_vertices.size()))];
  }

  // The distinct ends of a segment, or corners of a triangle.
  template <std::size_t N>
  std::array<Vertex_handle, N> random_simplex()
  {
    std::array<Vertex_handle, N> s;
    std::set<Vertex_handle> distinct;
    while(distinct.size() < N)
    {
      distinct.clear();
      for(std::size_t i = 0; i < N; ++i)
        distinct.insert(s[i] = random_vertex(random_int(m_rng, 2) == 0));
    }
    return s;
  }

  template <std::size_t N>
  Lattice_points points_of(const std::array<Vertex_handle, N>& s) const
  {
    Lattice_points result;
    for(const Vertex_handle v : s)
      result.push_back(m_points[v->info()]);
    return result;
  }

  void check_random_problem(Reference_search& reference)
  {
    Shell_problem problem = m_geometry;
    const int m = problem.degree();
    if(random_int(m_rng, 2) == 0)
      problem.f = random_int(m_rng, m);
    if(random_int(m_rng, 3) == 0)
    {
      problem.keeps_edge = true;
      for(int i = random_int(m_rng, 3); i > 0; --i)
        problem.is_kept[random_int(m_rng, m)] = true;
    }
    choose_quality(problem, reference);
  }

  void choose_quality(Shell_problem& problem, Reference_search& reference)
  {
    const int choice = random_int(m_rng, 4);
    if(choice == 0)
    {
      problem.quality = Shell_problem::NONE;
      choose_validity(problem, reference, BR::No_shell_quality_3());
    }
    else if(choice == 1)
    {
      problem.quality = Shell_problem::WORST_ELEMENT;
      choose_validity(problem, reference, BR::Worst_element_quality_3<Tr>(m_tr));
    }
    else if(choice == 2)
      choose_lost_constraints<2>(problem, reference);
    else
      choose_lost_constraints<3>(problem, reference);
  }

  template <std::size_t N>
  void choose_lost_constraints(Shell_problem& problem, Reference_search& reference)
  {
    typedef BR::internal::Intersection_table_3<Tr, N> Table;
    problem.quality = Shell_problem::FEWEST_INTERSECTIONS;
    std::vector<std::array<Vertex_handle, N> > constraints;
    for(int i = random_int(m_rng, 8) == 0 ? 40 : 3 + random_int(m_rng, 8); i > 0; --i)
    {
      constraints.push_back(random_simplex<N>());
      problem.lost.push_back(points_of(constraints.back()));
    }
    Table table(m_tr);
    table.set_constraints(constraints);
    check_counts<Table>(problem, reference, table);
    choose_validity(problem, reference, BR::Fewest_intersections_quality_3<Tr, Table>(table));
  }

  // BRC3 and BRC4 judge covering meshes as a whole: compares the counts, and tries some covering meshes.
  template <typename Table>
  void check_counts(const Shell_problem& problem, const Reference_search& reference, Table& table)
  {
    const BR::BRC3<Tr, Table> brc3(table);
    const auto& meshes = reference.meshes();
    int present = -1;
    for(const Covering_mesh& mesh : meshes)
      if(static_cast<int>(mesh.core.size()) == problem.degree())
        present = reference.number_of_intersections(problem, mesh);
    assert(brc3.number_of_intersections(m_shell) == present);
    for(int k = 0; k < 4; ++k)
    {
      const Covering_mesh& mesh = meshes[random_int(m_rng, static_cast<int>(meshes.size()))];
      BR::Partial_triangulation partial;
      partial.core.assign(mesh.core.begin(), mesh.core.end());
      partial.triangles.assign(mesh.triangles.begin(), mesh.triangles.end());
      const int n = reference.number_of_intersections(problem, mesh);
      assert(brc3.number_of_intersections(m_shell, partial) == n);
      assert(brc3.is_valid_covering_mesh(m_shell, partial) == (n <= present));
      ++number_of[n > present ? "BRC3 or BRC4 refuses" : n < present ? "BRC3 or BRC4 likes" : "BRC3 or BRC4 accepts"];
    }
  }

  template <typename Quality>
  void choose_validity(Shell_problem& problem, Reference_search& reference, const Quality& quality)
  {
    const int choice = random_int(m_rng, 5);
    const auto segment = random_simplex<2>();
    const auto triangle = random_simplex<3>();
    const BR::BRC1<Tr> brc1(m_tr, segment[0], segment[1]);
    const BR::BRC2<Tr> brc2(m_tr, triangle[0], triangle[1], triangle[2]);
    if(choice == 1 || choice == 3)
      problem.brc1.push_back(points_of(segment));
    if(choice == 2 || choice == 3)
      problem.brc2.push_back(points_of(triangle));
    if(choice == 0)
      check(problem, reference, quality, BR::No_shell_validity_3(), "");
    else if(choice == 1)
      check(problem, reference, quality, brc1, "BRC1 matters");
    else if(choice == 2)
      check(problem, reference, quality, brc2, "BRC2 matters");
    else if(choice == 3)
      check(problem, reference, quality,
            BR::Shell_validity_conjunction_3<BR::BRC1<Tr>, BR::BRC2<Tr> >(brc1, brc2), "BRC1 and BRC2 matter");
    else
      check(problem, reference, quality, random_ancestors(problem), "ancestor edges matter");
  }

  // One or two of the edges on the boundary of the shell.
  Ancestors<Tr> random_ancestors(Shell_problem& problem)
  {
    Ancestors<Tr> ancestors;
    const int m = problem.degree();
    for(int k = 1 + random_int(m_rng, 2); k > 0; --k)
    {
      const int i = random_int(m_rng, m), j = random_int(m_rng, 3) == 0 ? m_shell.next(i) : m + random_int(m_rng, 2);
      if(i == problem.h || j == problem.h)
        continue;
      problem.ancestors.push_back((Mask(1) << i) | (Mask(1) << j));
      const Vertex_handle other = j < m ? m_shell.vertex(j) : j == m ? m_shell.a() : m_shell.b();
      ancestors.edges.push_back({{ m_shell.vertex(i), other }});
    }
    return ancestors;
  }

  // ---- the comparison ----

  template <typename Quality, typename Validity>
  void check(const Shell_problem& problem, Reference_search& reference,
             const Quality& quality, const Validity& validity, const std::string& what)
  {
    const int m = problem.degree();
    BR::internal::Covering_mesh_search_3<Tr, Quality, Validity> search(m_predicates, quality, validity);
    const bool is_changed = search(m_shell, problem.f, problem.keeps_edge,
                                   [&](const int i) { return problem.is_kept[i]; });
    const Shell_solution solution = reference(problem);
    assert(is_changed == (static_cast<int>(solution.core.size()) < m));
    if(is_changed)
    {
      const BR::Partial_triangulation& k = search.partial_triangulation();
      assert(k.core_size() == static_cast<int>(k.core.size()));
      assert(std::vector<int>(k.core.begin(), k.core.end()) == solution.core);
      assert(std::vector<Triangle>(k.triangles.begin(), k.triangles.end()) == solution.triangles);
    }
    check_only_if_done(search, problem, solution);
    count(problem, reference, solution, what);
  }

  // A search among those covering meshes only that avoid the face, or lose ab.
  template <typename Search>
  void check_only_if_done(Search& search, const Shell_problem& problem, const Shell_solution& solution)
  {
    const bool is_found = search(m_shell, problem.f, problem.keeps_edge,
                                 [&](const int i) { return problem.is_kept[i]; }, true);
    const auto is_done = [&](const auto& core)
    {
      return core.empty() || (problem.f >= 0 && std::find(core.begin(), core.end(), problem.f) == core.end());
    };
    const BR::Partial_triangulation& k = search.partial_triangulation();
    assert(! is_found || is_done(k.core));
    assert(is_found || ! is_done(solution.core));
    if(is_found && (problem.quality != Shell_problem::FEWEST_INTERSECTIONS || is_done(solution.core)))
    {
      assert(std::vector<int>(k.core.begin(), k.core.end()) == solution.core);
      assert(std::vector<Triangle>(k.triangles.begin(), k.triangles.end()) == solution.triangles);
    }
    ++number_of[is_found ? "done" : "not to be done"];
  }

  static bool are_equal(const Shell_solution& x, const Shell_solution& y)
  {
    return x.core == y.core && x.triangles == y.triangles;
  }

  // Solves the problem again without one of its conditions, to see whether it made a difference.
  void count(const Shell_problem& problem, Reference_search& reference, const Shell_solution& solution,
             const std::string& what)
  {
    static const char* const names[3] = { "no quality", "worst element", "fewest intersections" };
    const int n = static_cast<int>(solution.core.size()), m = problem.degree();
    const std::string name = names[problem.quality];
    ++number_of[name];
    ++number_of[name + (n == 0 ? ", removed" : n < m ? ", reduced" : ", unchanged")];
    if(problem.h >= 0)
      ++number_of[n == 0 ? "hull, removed" : n < m ? "hull, reduced" : "hull, unchanged"];
    if(solution.number_of_optimal > 1)
      ++number_of[name + ", tie"];
    if(n == m && solution.number_of_valid > 0)
      ++number_of[name + ", the present one is the best one"];
    Shell_problem other = problem;
    other.brc1.clear();
    other.brc2.clear();
    other.ancestors.clear();
    if(! what.empty() && ! are_equal(reference(other), solution))
      ++number_of[what];
    other = problem;
    other.f = -1;
    if(problem.f >= 0 && ! are_equal(reference(other), solution))
      ++number_of[name + ", the face to avoid matters"];
    other = problem;
    other.keeps_edge = false;
    other.is_kept.assign(m, false);
    if(problem.keeps_edge && ! are_equal(reference(other), solution))
      ++number_of["kept edge or faces matter"];
    other = problem;
    other.is_kept.assign(m, false);
    if(problem.keeps_edge && ! are_equal(reference(other), solution))
      ++number_of["kept faces matter"];
    other = problem;
    other.quality = Shell_problem::NONE;
    if(! are_equal(reference(other), solution))
      ++number_of[name + ", quality matters"];
  }

  const Tr& m_tr;
  const Lattice_points m_points;
  const std::vector<Vertex_handle> m_vertices;
  const BR::internal::Vertex_predicates_3<Tr> m_predicates;
  std::mt19937& m_rng;
  Shell m_shell;
  Shell_problem m_geometry;
};

// Tests shells of the Delaunay triangulation of some points, and again after random flips.
template <typename Kernel>
void test_points(const Lattice_points& points, const int stride, const bool is_ring, std::mt19937& rng)
{
  typedef typename Triangulations<Kernel>::Delaunay       Delaunay;
  typedef typename Triangulations<Kernel>::Triangulation  Triangulation;
  Delaunay tr;
  insert_points(tr, points);
  if(tr.dimension() < 3)
    return;
  Tester<Triangulation>(tr, points, rng).check_edges(stride, is_ring);
  number_of["flips"] += flip_at_random<Kernel>(tr, is_ring ? 5 : 60, rng);
  Tester<Triangulation>(tr, points, rng).check_edges(stride, is_ring);
}

template <typename Kernel>
void test_kernel(const int n, const unsigned seed)
{
  std::mt19937 rng(seed);
  for(int k = 0; k < n; ++k)
  {
    test_points<Kernel>(random_points(40, 4000, rng), 4, false, rng);
    test_points<Kernel>(random_points(30, 8, rng), 3, false, rng);
    test_points<Kernel>(grid_points(3, 3, 3, 100, rng), 3, false, rng);
    test_points<Kernel>(grid_points(4, 4, 3, 70, rng), 3, false, rng);
    for(int size = 3; size <= max_degree; ++size)
    {
      test_points<Kernel>(ring_points(size, true, true, rng), 1, true, rng);
      for(int i = 0; i < 4; ++i)
      {
        test_points<Kernel>(ring_points(size, true, false, rng), 1, true, rng);
        test_points<Kernel>(ring_points(size, false, true, rng), 1, true, rng);
        test_points<Kernel>(ring_points(size, false, false, rng), 1, true, rng);
      }
    }
  }
}

// No test may pass because nothing was tested.
void check_that_all_was_met()
{
  for(const auto& n : number_of)
    std::cout << n.second << "\t" << n.first << std::endl;
  for(int degree = 3; degree <= max_degree; ++degree)
    assert(number_of["degree " + std::to_string(degree)] >= 50);
  for(const std::string name : { "no quality", "worst element", "fewest intersections" })
  {
    for(const std::string what : { "", ", removed", ", reduced", ", unchanged", ", the face to avoid matters" })
      assert(number_of[name + what] >= 50);
    if(name != "no quality")
      assert(number_of[name + ", quality matters"] >= 50);
  }
  assert(number_of["no quality, tie"] >= 50);
  assert(number_of["worst element, tie"] >= 20);
  assert(number_of["fewest intersections, tie"] >= 50);
  assert(number_of["fewest intersections, the present one is the best one"] >= 50);
  for(const std::string what : { "BRC1 matters", "BRC2 matters", "BRC1 and BRC2 matter", "ancestor edges matter",
                                 "kept edge or faces matter", "kept faces matter", "done", "not to be done",
                                 "hull, removed", "hull, reduced", "hull, unchanged",
                                 "BRC3 or BRC4 refuses", "BRC3 or BRC4 accepts", "BRC3 or BRC4 likes", "flips",
                                 "sum of doubles, removed", "sum of doubles, reduced" })
    assert(number_of[what] >= 50);
}

// Rings around an edge that are so large that every bit of a set of positions counts. All of it is convex, so an edge
// that may go does, and a core has three vertices, with or without any given one.
template <typename Quality>
void test_large_ring(const int m)
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  typedef Triangulations<Kernel>::Delaunay Tr;
  Tr tr;
  const Tr::Vertex_handle a = tr.insert(Kernel::Point_3(0, 0, -1)), b = tr.insert(Kernel::Point_3(0, 0, 1));
  for(int i = 0; i < m; ++i)
    tr.insert(Kernel::Point_3(9 * std::cos(6.28 * i / m), 9 * std::sin(6.28 * i / m), 0));
  Tr::Cell_handle c;
  int i, j;
  assert(tr.is_edge(a, b, c, i, j));
  const BR::Shell_3<Tr> shell(tr, c, i, j);
  assert(shell.degree() == m);

  const BR::internal::Vertex_predicates_3<Tr> predicates(tr);
  const Quality quality(tr);
  const BR::No_shell_validity_3 validity;
  BR::internal::Covering_mesh_search_3<Tr, Quality, BR::No_shell_validity_3> search(predicates, quality, validity);
  const auto none_is_kept = [](int) { return false; };
  const BR::Partial_triangulation& k = search.partial_triangulation();
  for(const int f : { -1, 0, 31, 32, m - 1 })
  {
    assert(search(shell, f, false, none_is_kept));
    assert(k.core.empty() && static_cast<int>(k.triangles.size()) == m - 2);
    assert(search(shell, f, true, none_is_kept));
    assert(k.core_size() == 3 && static_cast<int>(k.triangles.size()) == m - 3);
    assert(std::find(k.core.begin(), k.core.end(), f) == k.core.end());
  }
  const auto some_are_kept = [m](const int p) { return p == 0 || p == 1 || p == m / 2 || p >= m - 2; };
  assert(search(shell, -1, true, some_are_kept));
  assert((std::vector<int>(k.core.begin(), k.core.end()) == std::vector<int>{ 0, 1, m / 2, m - 2, m - 1 }));
}

int main()
{
  typedef Triangulations<CGAL::Exact_predicates_inexact_constructions_kernel>::Delaunay Delaunay;
  for(const int m : { 24, 33, 63, 64 })
    test_large_ring<BR::Worst_element_quality_3<Delaunay> >(m);
  test_kernel<CGAL::Exact_predicates_inexact_constructions_kernel>(20, 1);
  test_kernel<CGAL::Exact_predicates_exact_constructions_kernel>(2, 2);
  check_that_all_was_met();
  return 0;
}

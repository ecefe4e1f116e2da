// Maps, size fields, cell qualities and visitors that throw, at one call after the other: the mesh is valid then, and
// nothing is left behind. And those who say no: the improvement stops soon, and what there is no time for is left out.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "mesh_validity_br3.h"

#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/Cell_quality_3.h>
#include <CGAL/Boundary_recovery_3/Meshing_visitor_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Unique_hash_map.h>
#include <CGAL/improve_mesh_quality.h>
#include <CGAL/insert_field_points.h>
#include <CGAL/make_boundary_constrained_mesh_3.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <chrono>
#include <cstddef>
#include <functional>
#include <iostream>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace BR3 = CGAL::Boundary_recovery_3;
namespace parameters = CGAL::parameters;
typedef CGAL::Exact_predicates_inexact_constructions_kernel      K;
typedef CGAL::Boundary_constrained_mesh_triangulation_3<K>::type Tr;
typedef Tr::Vertex_handle                                        Vertex_handle;
typedef Tr::Cell_handle                                          Cell_handle;
typedef std::pair<Vertex_handle, Vertex_handle>                  Edge;

struct Interruption { };

// Counts calls, and throws at one of them.
struct Counter
{
  void operator()()
  {
    if(number++ == last)
      throw Interruption();
  }

  std::size_t number = 0, last = std::size_t(-1);
};

enum Source { selection, edges, quality, size, visitor, number_of_sources };
const char* const names[] = { "selection", "edges", "quality", "size", "visitor" };

// What the code of a user knows.
struct User
{
  void call(const Source s) { counters[s](); }

  std::array<Counter, number_of_sources> counters;
  CGAL::Unique_hash_map<Cell_handle, bool> is_unselected{ false };
  Edge constrained_edge;

  // of the visitor
  bool says_no = false, sleeps = false;
  std::size_t number_of_questions = 0, last_question = std::size_t(-1);
  std::size_t qualities_at_question = 0;
};

struct Selection_map
{
  typedef Cell_handle                      key_type;
  typedef bool                             value_type;
  typedef bool                             reference;
  typedef boost::read_write_property_map_tag category;

  friend bool get(const Selection_map& map, const Cell_handle c)
  {
    map.user->call(selection);
    if(map.user->says_no && std::exchange(map.user->sleeps, false))
      std::this_thread::sleep_for(std::chrono::milliseconds(200));
    return ! map.user->is_unselected[c];
  }

  friend void put(const Selection_map& map, const Cell_handle c, const bool is_selected)
  {
    map.user->call(selection);
    map.user->is_unselected[c] = ! is_selected;
  }

  User* user;
};

struct Edge_map
{
  typedef Edge                             key_type;
  typedef bool                             value_type;
  typedef bool                             reference;
  typedef boost::readable_property_map_tag category;

  friend bool get(const Edge_map& map, const Edge& e)
  {
    map.user->call(edges);
    return e == map.user->constrained_edge;
  }

  User* user;
};

struct Quality
{
  double operator()(const std::array<std::array<double, 3>, 4>& corners) const
  {
    user->call(quality);
    return of_corners(corners);
  }

  double of_angle(const double degrees) const { return of_corners.of_angle(degrees); }

  User* user;
  BR3::Dihedral_angle_quality_3 of_corners = BR3::Dihedral_angle_quality_3();
};

struct Size
{
  double operator()(const K::Point_3&) const
  {
    user->call(size);
    return length;
  }

  User* user;
  double length;
};

// Says no to one question, and from then on.
struct Visitor
  : public CGAL::Default_meshing_visitor_3
{
  explicit Visitor(User& user) : user(user) { }

  void on_progress(const BR3::Phase phase, std::size_t, std::size_t)
  {
    if(! BR3::internal::is_of_recovery(phase))
      user.call(visitor);
  }

  bool go_further()
  {
    user.call(visitor);
    user.qualities_at_question = user.counters[quality].number;
    user.says_no = user.says_no || user.number_of_questions++ == user.last_question;
    return ! user.says_no;
  }

  template <typename CellRange>
  void before_cells_removal(const CellRange&) { user.call(visitor); }

  template <typename CellRange>
  void after_cells_creation(const CellRange&) { user.call(visitor); }

  User& user;
};

const std::vector<K::Point_3> points = { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 2, 2, 0 },
                                         { 0, 0, 2 }, { 2, 0, 2 }, { 0, 2, 2 }, { 2, 2, 2 } };
const std::vector<std::array<std::size_t, 3> > triangles
  = { {{ 0, 2, 3 }}, {{ 0, 3, 1 }}, {{ 4, 5, 7 }}, {{ 4, 7, 6 }}, {{ 0, 1, 5 }}, {{ 0, 5, 4 }},
      {{ 2, 6, 7 }}, {{ 2, 7, 3 }}, {{ 0, 4, 6 }}, {{ 0, 6, 2 }}, {{ 1, 3, 7 }}, {{ 1, 7, 5 }} };

// A cube, filled; nine tenths of the cells are selected, and an inner edge is constrained.
struct Scene
{
  explicit Scene(const double length)
  {
    User nobody;
    Visitor no_visitor(nobody);
    assert(make(*this, nobody, length, 1, false));
  }

  Scene(const Scene& other, User& user) : tr(other.tr)
  {
    std::size_t number = 0;
    for(const Cell_handle c : tr.finite_cell_handles())
    {
      user.is_unselected[c] = ++number % 10 == 0;
      for(int i = 0; i < 3; ++i)
        if(c->vertex(i)->in_dimension() == 3 && c->vertex(i + 1)->in_dimension() == 3)
          user.constrained_edge = Edge(c->vertex(i), c->vertex(i + 1));
    }
  }

  static CGAL::Boundary_constrained_mesh_result_3<Tr> make(Scene& scene, User& user, const double length,
                                                           const int number_of_subdomains, const bool improve)
  {
    Visitor visitor(user);
    return CGAL::make_boundary_constrained_mesh_3(
      scene.tr, points, triangles, Size{ &user, length }, parameters::cell_quality(Quality{ &user }),
      parameters::number_of_subdomains(number_of_subdomains), parameters::improve_quality(improve),
      parameters::visitor(std::ref(visitor)));
  }

  CGAL::Boundary_recovery_3::Field_points_result_3<Tr> fill(User& user, const double length)
  {
    Visitor visitor(user);
    return CGAL::insert_field_points(tr, Size{ &user, length },
                                     parameters::cell_is_selected_map(Selection_map{ &user })
                                       .edge_is_constrained_map(Edge_map{ &user }).visitor(std::ref(visitor)));
  }

  CGAL::Quality_improvement_result_3<Tr> improve(User& user, const double degrees)
  {
    Visitor visitor(user);
    return CGAL::improve_mesh_quality(tr, parameters::min_dihedral_angle(degrees),
                                      parameters::improvement_effort(BR3::Improvement_effort::high),
                                      parameters::cell_quality(Quality{ &user }),
                                      parameters::cell_is_selected_map(Selection_map{ &user })
                                        .edge_is_constrained_map(Edge_map{ &user }).visitor(std::ref(visitor)));
  }

  Tr tr;
};

// --- who throws -----------------------------------------------------------------------------------------------------

bool are_marks_clear(const Tr& tr)
{
  const auto cells = tr.all_cell_handles();
  return std::all_of(cells.begin(), cells.end(), [](const Cell_handle c) { return c->tds_data().is_clear(); });
}

// Each vertex has a cell that has it, and what the mesher writes into vertices.
bool are_vertices_in_order(const Tr& tr)
{
  std::set<Vertex_handle> vertices;
  for(const Cell_handle c : tr.all_cell_handles())
    for(int i = 0; i < 4; ++i)
      vertices.insert(c->vertex(i));
  for(const Vertex_handle v : tr.finite_vertex_handles())
    if(vertices.count(v) == 0 || ! v->cell()->has_vertex(v) || v->in_dimension() < 0 || v->in_dimension() > 3
       || v->meshing_info() < 0)
      return false;
  return vertices.size() == tr.number_of_vertices() + 1;
}

// As CGAL searches for edges with marks of its own.
bool are_edges_found(const Tr& tr)
{
  std::set<Edge> edges;
  for(const Tr::Edge& e : tr.finite_edges())
  {
    const Vertex_handle u = e.first->vertex(e.second), v = e.first->vertex(e.third);
    edges.insert(Edge((std::min)(u, v), (std::max)(u, v)));
  }
  Cell_handle c;
  int i, j;
  for(const Vertex_handle u : tr.finite_vertex_handles())
    for(const Vertex_handle v : tr.finite_vertex_handles())
      if(u < v && tr.is_edge(u, v, c, i, j) != (edges.count(Edge(u, v)) == 1))
        return false;
  return true;
}

void check(const Tr& tr)
{
  assert(tr.dimension() == 3 && are_marks_clear(tr) && are_vertices_in_order(tr) && are_edges_found(tr));
  assert(br3_test::is_valid_mesh(tr));
  std::size_t number_of_sides = 0;
  for(const Cell_handle c : tr.finite_cell_handles())
  {
    assert(c->subdomain_index() == 1);
    for(int i = 0; i < 4; ++i)
    {
      number_of_sides += c->is_facet_on_surface(i);
      assert(c->is_facet_on_surface(i) == tr.is_infinite(c->neighbor(i)));
    }
  }
  assert(number_of_sides == 12);
}

// `work` gets a scene and a user. All calls throw of those who make few, else some of them.
template <typename Work>
void test_exceptions(const Scene& scene, const std::string& name, const Work& work)
{
  User undisturbed;
  {
    Scene copy(scene, undisturbed);
    work(copy, undisturbed);
  }
  for(int s = 0; s < number_of_sources; ++s)
  {
    const std::size_t number = undisturbed.counters[s].number, step = number / 12 + 1;
    std::size_t number_of_exceptions = 0;
    for(std::size_t k = 0; k < number; k += k < 4 ? 1 : step, ++number_of_exceptions)
    {
      User user;
      user.counters[s].last = k;
      Scene copy(scene, user);
      try {
        work(copy, user);
        assert(s == size || user.counters[s].number <= k); // what a field throws is told in the result
      } catch(const Interruption&) { }
      check(copy.tr);
      assert(user.constrained_edge == Edge() || copy.tr.tds().is_edge(user.constrained_edge.first,
                                                                      user.constrained_edge.second));
    }
    std::cout << name << ": " << number_of_exceptions << " of " << number << " calls of " << names[s] << " threw"
              << std::endl;
  }
}

void test_exceptions(const Scene& scene)
{
  test_exceptions(scene, "filling", [](Scene& s, User& user) { s.fill(user, 0.5); });
  test_exceptions(scene, "improvement", [](Scene& s, User& user) { s.improve(user, 28); });
}

// --- who says no ----------------------------------------------------------------------------------------------------

template <typename Result>
std::string text(const Result& result)
{
  std::ostringstream os;
  os << result;
  return os.str();
}

bool are_equal(const BR3::Mesh_quality_3& a, const BR3::Mesh_quality_3& b)
{
  return a.number_of_cells == b.number_of_cells && a.min_dihedral_angle == b.min_dihedral_angle
      && a.max_dihedral_angle == b.max_dihedral_angle && a.histogram == b.histogram
      && a.mean_radius_ratio == b.mean_radius_ratio && a.number_of_sized_edges == b.number_of_sized_edges;
}

// After a no, there is little work, wherever that is; before the first change, the first figures are the last ones.
void test_stops(const Scene& scene)
{
  User undisturbed;
  Scene whole(scene, undisturbed);
  assert(whole.improve(undisturbed, 28));
  const std::size_t number = undisturbed.number_of_questions;
  std::size_t most = 0;
  for(std::size_t k = 0; k < number; k += number / 8 + 1)
  {
    User user;
    user.last_question = k;
    Scene copy(scene, user);
    const auto result = copy.improve(user, 28);
    assert(user.says_no && result.status == BR3::Meshing_status::stopped);
    assert(result.is_measured && result.certificate.is_complete && result.after.number_of_cells > 0);
    assert(text(result).find("not measured") == std::string::npos);
    if(k == 0)
      assert(result.counts.number_of_rounds == 0 && are_equal(result.before, result.after));
    most = (std::max)(most, user.counters[quality].number - user.qualities_at_question);
    assert(br3_test::is_valid_mesh(copy.tr));
  }
  std::cout << "at most " << most << " qualities after one of " << number << " questions" << std::endl;
  assert(number > 100 && most < 100);
}

// After a no, the selection of the cells takes so long that nobody waits for figures.
void test_late_figures(const Scene& scene)
{
  for(const std::size_t last_question : { 0, 100 })
  {
    User user;
    user.last_question = last_question;
    user.sleeps = true;
    Scene copy(scene, user);
    const auto result = copy.improve(user, 20);
    assert(result.status == BR3::Meshing_status::stopped && result.certificate.min_dihedral_angle == 20);
    assert(! result.is_measured && result.after.number_of_cells == 0);
    assert(! result.certificate.is_complete && result.certificate.cells.empty());
    assert((result.before.number_of_cells > 0) == (last_question > 0));
    assert(text(result).find("not measured") != std::string::npos);
    assert(text(result).find("no certificate") != std::string::npos);
  }
}

int main()
{
  const Scene small(0.9), large(0.24);
  assert(large.tr.number_of_finite_cells() > 2 * 1024); // after so many, the clock is looked at
  test_exceptions(small);
  test_stops(small);
  test_late_figures(large);
  return 0;
}

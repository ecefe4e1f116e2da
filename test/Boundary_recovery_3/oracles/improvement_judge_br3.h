// Random constrained meshes to be improved, and a slow judge of what an operation did to one.

#ifndef BR3_TEST_IMPROVEMENT_JUDGE_H
#define BR3_TEST_IMPROVEMENT_JUDGE_H

#include "brute_force_checker_br3.h"
#include "random_numbers_br3.h"

#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Selected_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Improved_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Mesh_visitor_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/bare_point.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace br3_test {

// Edges that are constrained, asked for in both orders.
template <typename Vertex_handle>
struct Edge_set_map
{
  typedef std::pair<Vertex_handle, Vertex_handle> key_type;
  typedef bool                                    value_type;
  typedef bool                                    reference;
  typedef boost::readable_property_map_tag        category;

  const std::set<key_type>* edges;

  friend bool get(const Edge_set_map& map, const key_type& e) { return map.edges->count(e) > 0; }
};

// The quality of a cell is a random number: also cells that are inverted may be good.
inline double random_quality(std::array<std::array<double, 3>, 4> corners)
{
  std::sort(corners.begin(), corners.end());
  double sum = 0;
  for(const auto& p : corners)
    for(const double x : p)
      sum = 17.25 * sum + x;
  return sum * 97 - std::floor(sum * 97);
}

struct Improvement_options
{
  bool is_grid = false;     // cospherical points instead of random ones
  double size = 0;          // 0: there are none; else they are up to twice as large
  bool has_walls = true;    // beside the hull: two regions, a part that is outside, sheets, edges, a selection
  int number_of_points = 60;
};

// Patches are numbers, or pairs of them where Mesh_3 made the triangulation. There is none if it is 0.
template <typename Patch>
Patch make_patch(const int number)
{
  if constexpr(std::is_same<Patch, std::pair<int, int> >::value)
    return Patch(0, number);
  else
    return static_cast<Patch>(number);
}

template <typename Patch>
int number_of_patch(const Patch& patch)
{
  if constexpr(std::is_same<Patch, std::pair<int, int> >::value)
    return patch.second;
  else
    return static_cast<int>(patch);
}

// Two regions with jagged facets between them, and a part of the convex hull that is outside; sheets, constrained
// edges, and cells that are not selected.
template <typename Kernel,
          typename Tr_ = typename CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type>
struct Improvement_scene
{
  typedef Tr_                                                                    Tr;
  typedef typename Tr::Vertex_handle                                             Vertex_handle;
  typedef typename Tr::Cell_handle                                               Cell_handle;
  typedef typename Tr::Point                                                     Point; // with a weight, maybe
  typedef typename Tr::Cell::Surface_patch_index                                 Patch;
  typedef std::pair<Vertex_handle, Vertex_handle>                                Edge;
  typedef std::map<Cell_handle, bool>                                            Selection;
  typedef boost::associative_property_map<Selection>                             Selection_map;
  typedef Edge_set_map<Vertex_handle>                                            Edge_map;
  typedef CGAL::Boundary_recovery_3::internal::Selected_domain_3<Tr>             Domain;

  Improvement_scene(const unsigned seed, const Improvement_options& options) : rng(seed)
  {
    if(options.is_grid)
      insert_grid();
    else
      insert_random_points(options.number_of_points);
    flip_randomly(options.is_grid ? 60 : 20);
    for(const Cell_handle c : tr.finite_cell_handles())
    {
      c->set_subdomain_index(options.has_walls ? region_at(c) : 1);
      selection[c] = ! options.has_walls || random_int(30) > 0;
    }
    if(options.has_walls)
      mark_facets_and_edges();
    if(options.size > 0)
      for(const Vertex_handle v : tr.finite_vertex_handles())
        v->set_meshing_info(options.size * (1 + random_int(100) * 0.01));
    if(seed % 2 == 0)
      set_dimensions();
  }

  Improvement_scene(const Improvement_scene&) = delete;
  Improvement_scene& operator=(const Improvement_scene&) = delete;

  int random_int(const int n) { return br3_test::random_int(rng, n); }

  Domain domain()
  {
    Domain domain(tr);
    domain.select(Selection_map(selection));
    domain.constrain_edges(Edge_map{ &edges });
    return domain;
  }

  bool is_selected(const Cell_handle c) const
  {
    const auto it = selection.find(c);
    return it != selection.end() && it->second;
  }

  bool contains(const Cell_handle c) const
  {
    return ! tr.is_infinite(c) && c->subdomain_index() != 0 && is_selected(c);
  }

  // The domain is the hull of what was inserted.
  void select_all()
  {
    selection.clear();
    for(const Cell_handle c : tr.finite_cell_handles())
    {
      c->set_subdomain_index(1);
      selection[c] = true;
    }
  }

  // Nothing but a vertex of 2 n cells: between two poles and the n corners of a polygon.
  Vertex_handle make_vertex_inside_of_polygon(const int n)
  {
    tr.clear();
    const Vertex_handle v = tr.insert(Point(0, 0, 0));
    for(const int z : { -1, 1 })
      tr.insert(Point(0, 0, z));
    for(int i = 0; i < n; ++i)
    {
      const double angle = 2 * CGAL_PI * i / n;
      tr.insert(Point(std::cos(angle), std::sin(angle), 0));
    }
    select_all();
    return v;
  }

  std::vector<Cell_handle> cells() const
  {
    return std::vector<Cell_handle>(tr.finite_cell_handles().begin(), tr.finite_cell_handles().end());
  }

  std::mt19937 rng;
  Tr tr;
  Selection selection;
  std::set<Edge> edges;

private:
  void insert_random_points(const int n)
  {
    for(int i = 0; i < 8; ++i)
      insert(i & 1, (i >> 1) & 1, (i >> 2) & 1);
    for(int i = 8; i < n; ++i)
    {
      const double x = random_int(1024) / 1024., y = random_int(1024) / 1024., z = random_int(1024) / 1024.;
      insert(x, y, z);
    }
  }

  void insert(const double x, const double y, const double z)
  {
    tr.insert(Point(typename Tr::Geom_traits::Point_3(x, y, z)));
  }

  void insert_grid()
  {
    for(int i = 0; i < 64; ++i)
      insert(i % 4 * 0.375, i / 4 % 4 * 0.375, i / 16 * 0.125);
  }

  void flip_randomly(const int n)
  {
    for(int k = 0; k < n; ++k)
    {
      const std::vector<Cell_handle> all = cells();
      const Cell_handle c = all[static_cast<std::size_t>(random_int(static_cast<int>(all.size())))];
      const int i = random_int(4);
      if(! tr.flip(c, i))
        tr.flip(c, i, (i + 1 + random_int(3)) % 4);
    }
  }

  int region_at(const Cell_handle c) const
  {
    double x = 0, y = 0;
    for(int i = 0; i < 4; ++i)
    {
      x += CGAL::to_double(c->vertex(i)->point().x()) / 4;
      y += CGAL::to_double(c->vertex(i)->point().y()) / 4;
    }
    return x + y > 1.7 ? 0 : x < 0.35 ? 2 : 1;
  }

  // The order of finite_facets() and finite_edges() depends on addresses.
  void mark_facets_and_edges()
  {
    for(const Cell_handle c : tr.finite_cell_handles())
      for(int i = 0; i < 4; ++i)
      {
        const bool is_between = c->subdomain_index() != c->neighbor(i)->subdomain_index();
        const Patch patch = make_patch<Patch>(1 + random_int(9));
        if(random_int(is_between ? 2 : 150) == 0)
        {
          c->set_surface_patch_index(i, patch);
          c->neighbor(i)->set_surface_patch_index(tr.mirror_index(c, i), patch);
        }
        if(random_int(150) == 0)
          edges.insert({ c->vertex(i), c->vertex((i + 1) % 4) });
      }
  }

  void set_dimensions()
  {
    for(const Vertex_handle v : tr.finite_vertex_handles())
      v->set_dimension(random_int(5) == 0 ? 0 : 3);
    for(const Cell_handle c : tr.finite_cell_handles())
      for(int i = 0; i < 4; ++i)
        for(int j = 0; j < 4; ++j)
          if(i != j && (c->is_facet_on_surface(i) || c->subdomain_index() != c->neighbor(i)->subdomain_index()))
            c->vertex(j)->set_dimension(2);
  }
};

// All that there is in a mesh.
template <typename Scene>
struct Improvement_picture
{
  typedef std::array<const void*, 4>           Four;
  typedef std::array<const void*, 3>           Three;
  typedef std::array<const void*, 2>           Two;
  typedef std::array<double, 3>                Place;
  typedef typename Scene::Vertex_handle        Vertex_handle;
  typedef typename Scene::Cell_handle          Cell_handle;
  typedef std::tuple<const void*, Four, int, std::array<int, 4>, bool>      Cell_row;
  typedef std::decay_t<decltype(std::declval<Vertex_handle>()->index())>    Index;
  typedef std::tuple<const void*, Place, int, Index, double>                Vertex_row;

  struct Cell
  {
    std::array<Place, 4> corners; // in the order of the cell
    std::array<Vertex_handle, 4> vertices;
    int region;
    bool is_in_domain;
  };

  explicit Improvement_picture(const Scene& scene)
  {
    for(const Vertex_handle v : scene.tr.finite_vertex_handles())
      vertices.emplace_back(&*v, place(v), v->in_dimension(), v->index(), CGAL::to_double(v->meshing_info()));
    for(const Cell_handle c : scene.tr.all_cell_handles())
    {
      Four four;
      std::array<int, 4> patches;
      for(int i = 0; i < 4; ++i)
      {
        four[i] = &*c->vertex(i);
        patches[i] = number_of_patch(c->surface_patch_index(i));
      }
      cells.emplace_back(&*c, four, static_cast<int>(c->subdomain_index()), patches, scene.is_selected(c));
    }
  }

  static Place place(const Vertex_handle v)
  {
    return CGAL::Boundary_recovery_3::internal::coordinates_of(v->point());
  }

  bool operator==(const Improvement_picture& other) const
  {
    return vertices == other.vertices && cells == other.cells;
  }

  std::vector<Vertex_row> vertices;
  std::vector<Cell_row> cells;
};

// What may be known of an operation: which edges that are too long or too short it may make.
enum class Lengths_slack
{
  none,
  edges_that_go,       // no more extreme than these
  longest_edge,        // no longer than the longest one of the cells that go, and no shorter than is allowed
  all_edges            // no more extreme than those of the cells that go
};

template <typename Scene, typename Mesh>
class Improvement_judge
{
public:
  typedef Improvement_picture<Scene>       Picture;
  typedef typename Picture::Two            Two;
  typedef typename Picture::Three          Three;
  typedef typename Picture::Four           Four;
  typedef typename Picture::Place          Place;
  typedef typename Picture::Cell           Cell;
  typedef typename Scene::Vertex_handle    Vertex_handle;
  typedef typename Scene::Cell_handle      Cell_handle;
  typedef typename Scene::Tr::Geom_traits::Point_3               Point_3;
  typedef std::pair<Four, std::array<Place, 4> > Cell_key; // by sorted vertices
  typedef std::map<Cell_key, Cell>         Cells;

  Improvement_judge(const Scene& scene, const Mesh& mesh) : m_scene(scene), m_mesh(mesh), m_picture(scene) { }

  // To be called before each operation.
  void remember()
  {
    m_picture = Picture(m_scene);
    m_is_known = false;
  }

  bool is_unchanged() const { return m_picture == Picture(m_scene); }

  // The state that was remembered is worked out only if needed: to be called before an operation that will be done.
  void remember_all()
  {
    remember();
    m_cells = cells();
    m_walls = walls();
    m_frozen = frozen();
    m_lengths = lengths(m_cells);
    m_is_known = true;
  }

  // What an operation did since remember_all() is right, also if it makes cells worse, in sum by less than this.
  void check(const Lengths_slack slack, const double tolerated_loss = 0) const
  {
    check_constraints();
    const Cells after = cells();
    Cells gone, come;
    const auto is_before = [](const auto& x, const auto& y) { return x.first < y.first; };
    std::set_difference(m_cells.begin(), m_cells.end(), after.begin(), after.end(), std::inserter(gone, gone.end()),
                        is_before);
    std::set_difference(after.begin(), after.end(), m_cells.begin(), m_cells.end(), std::inserter(come, come.end()),
                        is_before);
    check_exchange(gone, come, tolerated_loss);
    check_lengths(gone, come, after, slack);
  }

  // What many of them did is.
  void check_all() const
  {
    check_constraints();
    std::map<int, Rational> volumes;
    for(const auto& c : m_cells)
      volumes[c.second.region] += volume_before(c.second);
    for(const auto& c : cells())
    {
      const Rational v = volume(c.second);
      assert(v > 0);
      volumes[c.second.region] -= v;
    }
    for(const auto& v : volumes)
      assert(v.second == 0);
  }

  // Vertices that may be moved, and may go.
  bool is_free(const Vertex_handle v) const { return frozen().count(&*v) == 0; }

private:
  static constexpr double rounding = 1e-9;

  void check_constraints() const
  {
    assert(m_is_known && m_scene.tr.tds().is_valid());
    for(const Cell_handle c : m_scene.tr.all_cell_handles())
      assert(c->tds_data().is_clear());
    assert(walls() == m_walls);
    check_selection();
    check_frozen_vertices();
    for(const auto& e : m_scene.edges)
      assert(m_scene.tr.tds().is_edge(e.first, e.second));
  }

  Cells cells() const
  {
    Cells result;
    for(const Cell_handle c : m_scene.tr.finite_cell_handles())
    {
      Cell cell;
      Cell_key key;
      for(int i = 0; i < 4; ++i)
      {
        cell.vertices[i] = c->vertex(i);
        cell.corners[i] = Picture::place(c->vertex(i));
        key.first[i] = &*c->vertex(i);
      }
      std::sort(key.first.begin(), key.first.end());
      for(int i = 0; i < 4; ++i)
        for(int j = 0; j < 4; ++j)
          if(key.first[i] == &*c->vertex(j))
            key.second[i] = cell.corners[j];
      cell.region = static_cast<int>(c->subdomain_index());
      cell.is_in_domain = m_scene.contains(c);
      const bool is_new = result.emplace(key, cell).second;
      assert(is_new);
    }
    return result;
  }

  static Three triple(const Cell_handle c, const int i)
  {
    Three t = {{ &*c->vertex((i + 1) % 4), &*c->vertex((i + 2) % 4), &*c->vertex((i + 3) % 4) }};
    std::sort(t.begin(), t.end());
    return t;
  }

  bool is_wall(const Cell_handle c, const int i) const
  {
    const Cell_handle n = c->neighbor(i);
    return c->is_facet_on_surface(i) || c->subdomain_index() != n->subdomain_index()
        || m_scene.contains(c) != m_scene.contains(n);
  }

  // With the patch, and the regions on both sides.
  std::map<Three, std::array<int, 3> > walls() const
  {
    std::map<Three, std::array<int, 3> > result;
    for(const Cell_handle c : m_scene.tr.all_cell_handles())
      for(int i = 0; i < 4; ++i)
      {
        const Cell_handle n = c->neighbor(i);
        assert(c->surface_patch_index(i) == n->surface_patch_index(n->index(c)));
        const int r = static_cast<int>(c->subdomain_index()), s = static_cast<int>(n->subdomain_index());
        if(is_wall(c, i))
          result[triple(c, i)] = {{ number_of_patch(c->surface_patch_index(i)), (std::min)(r, s), (std::max)(r, s) }};
      }
    return result;
  }

  std::map<const void*, Place> frozen() const
  {
    std::map<const void*, Place> result;
    const auto add = [&](const Vertex_handle v)
    {
      if(v != m_scene.tr.infinite_vertex())
        result[&*v] = Picture::place(v);
    };
    for(const Cell_handle c : m_scene.tr.all_cell_handles())
      for(int i = 0; i < 4; ++i)
        for(int j = 0; j < 4; ++j)
          if(! m_scene.contains(c) || (i != j && is_wall(c, i)))
            add(c->vertex(j));
    for(const auto& e : m_scene.edges)
    {
      add(e.first);
      add(e.second);
    }
    for(const Vertex_handle v : m_scene.tr.finite_vertex_handles())
      if(v->in_dimension() >= 0 && v->in_dimension() < 3)
        add(v);
    return result;
  }

  std::map<Two, double> lengths(const Cells& all) const
  {
    std::map<Two, double> result;
    for(const auto& c : all)
      for(int i = 0; i < 4; ++i)
        for(int j = 0; j < 4; ++j)
          result[{{ &*c.second.vertices[i], &*c.second.vertices[j] }}] = distance(c.second, i, j);
    return result;
  }

  static double distance(const Cell& c, const int i, const int j)
  {
    return std::sqrt(std::pow(c.corners[i][0] - c.corners[j][0], 2) + std::pow(c.corners[i][1] - c.corners[j][1], 2) +
                     std::pow(c.corners[i][2] - c.corners[j][2], 2));
  }

  void check_selection() const
  {
    std::size_t there = 0, selected = 0;
    for(const Cell_handle c : m_scene.tr.finite_cell_handles())
      there += m_scene.is_selected(c);
    for(const auto& entry : m_scene.selection)
      selected += entry.second;
    assert(there == selected);
  }

  void check_frozen_vertices() const
  {
    std::size_t number = 0;
    for(const Vertex_handle v : m_scene.tr.finite_vertex_handles())
    {
      const auto it = m_frozen.find(&*v);
      if(it == m_frozen.end())
        continue;
      ++number;
      assert(it->second == Picture::place(v));
    }
    assert(number == m_frozen.size());
  }

  static Rational volume(const Cell& c)
  {
    std::array<Rational_point, 4> p;
    for(int i = 0; i < 4; ++i)
      p[i] = br3_test::to_rational(CGAL::Boundary_recovery_3::internal::bare_point<Point_3>(c.vertices[i]->point()));
    return br3_test::volume(p[0], p[1], p[2], p[3]);
  }

  static Rational volume_before(const Cell& c)
  {
    return br3_test::volume(br3_test::to_rational(c.corners[0]), br3_test::to_rational(c.corners[1]),
                            br3_test::to_rational(c.corners[2]), br3_test::to_rational(c.corners[3]));
  }

  // Cells of one region of the domain are exchanged for better ones, or for good ones, or are not much worse in sum.
  void check_exchange(const Cells& gone, const Cells& come, const double tolerated_loss) const
  {
    assert(! gone.empty() && ! come.empty());
    Rational sum = 0;
    double worst = 2, badness = 0, worst_after = 2, badness_after = 0;
    const int region = gone.begin()->second.region;
    for(const auto& c : gone)
    {
      assert(c.second.is_in_domain && c.second.region == region);
      sum += volume_before(c.second);
      worst = (std::min)(worst, m_mesh.quality(c.second.corners));
      badness += lack(m_mesh.quality(c.second.corners));
    }
    for(const auto& c : come)
    {
      assert(c.second.is_in_domain && c.second.region == region);
      const Rational v = volume(c.second);
      assert(v > 0);
      sum -= v;
      worst_after = (std::min)(worst_after, m_mesh.quality(c.second.corners));
      badness_after += lack(m_mesh.quality(c.second.corners));
    }
    assert(sum == 0);
    assert(worst_after >= (std::min)(least_quality(worst), m_mesh.enough()) - rounding);
    assert(badness_after < badness + tolerated_loss + 1e-14);
  }

  double lack(const double quality) const
  {
    const int power = m_mesh.measure_of_badness().is_lenient() ? 1 : 3;
    return quality < m_mesh.enough() ? std::pow((m_mesh.enough() - quality) / m_mesh.enough(), power) : 0;
  }

  // Where that is tolerated, a fifth of the worst one that goes; but nothing below the floor.
  double least_quality(const double worst) const
  {
    const auto& measure = m_mesh.measure_of_badness();
    if(! measure.is_lenient() || worst <= measure.floor())
      return worst;
    return (std::max)(worst / 5, measure.floor());
  }

  void check_lengths(const Cells& gone, const Cells& come, const Cells& after, const Lengths_slack slack) const
  {
    const auto lengths_after = lengths(after);
    double shortest = 1e9, longest = 0;
    for(const auto& c : gone)
      for(int i = 0; i < 4; ++i)
        for(int j = 0; j < i; ++j)
          if(slack != Lengths_slack::edges_that_go
             || lengths_after.count({{ &*c.second.vertices[i], &*c.second.vertices[j] }}) == 0)
          {
            const double d = distance(c.second, i, j);
            shortest = (std::min)(shortest, slack == Lengths_slack::longest_edge ? 1e9 : d);
            longest = (std::max)(longest, d);
          }
    for(const auto& c : come)
      for(int i = 0; i < 4; ++i)
        for(int j = 0; j < i; ++j)
        {
          const double d = distance(c.second, i, j);
          const auto range = m_mesh.allowed_lengths().at(c.second.vertices[i], c.second.vertices[j]);
          double least = range.least, largest = range.largest;
          const auto before = m_lengths.find({{ &*c.second.vertices[i], &*c.second.vertices[j] }});
          if(before != m_lengths.end())
          {
            least = (std::min)(least, before->second);
            largest = (std::max)(largest, before->second);
          }
          else if(slack != Lengths_slack::none)
          {
            least = (std::min)(least, shortest);
            largest = (std::max)(largest, longest);
          }
          assert(d >= least * (1 - rounding) && d <= largest * (1 + rounding));
        }
  }

  const Scene& m_scene;
  const Mesh& m_mesh;
  Picture m_picture;
  bool m_is_known = false;
  Cells m_cells;
  std::map<Three, std::array<int, 3> > m_walls;
  std::map<const void*, Place> m_frozen;
  std::map<Two, double> m_lengths;
};

// A scene that is to be improved, where cells of the quality `enough` are good enough. The quality may be changed.
template <typename Scene_, typename Quality_>
struct Improvement_trial
{
  typedef Scene_                                              Scene;
  typedef Quality_                                            Quality;
  typedef typename Scene::Domain                              Domain;
  typedef CGAL::Boundary_recovery_3::internal::Mesh_visitor_3<typename Scene::Tr>            Visitor;
  typedef CGAL::Boundary_recovery_3::internal::Improved_mesh_3<typename Scene::Tr, Quality>  Mesh;

  Improvement_trial(const unsigned seed, const Improvement_options& options, const Quality& q, const double enough)
    : scene(seed, options), domain(scene.domain()), quality(q), mesh(scene.tr, domain, quality, visitor)
  {
    mesh.set_enough(enough);
    for(const auto c : scene.cells())
      if(scene.contains(c))
        mesh.add_lengths(c);
    mesh.spread_lengths([] { return true; });
  }

  Scene scene;
  Domain domain;
  Quality quality;
  Visitor visitor;
  Mesh mesh;
};

// Tries an operation on the cells of the domain, which the judge watches. `attempt` returns whether it was done.
// Returns how often that was so.
template <typename Scene, typename Mesh, typename Attempt>
int try_on_all_cells(Scene& scene, const Mesh& mesh, const Lengths_slack slack, const Attempt& attempt,
                     const double tolerated_loss = 0)
{
  Improvement_judge<Scene, Mesh> judge(scene, mesh);
  int number = 0;
  judge.remember_all();
  for(const auto c : scene.cells())
    if(scene.tr.tds().cells().is_used(c) && scene.contains(c))
    {
      if(attempt(c))
      {
        ++number;
        judge.check(slack, tolerated_loss);
        judge.remember_all();
      }
      else
        assert(judge.is_unchanged());
    }
  return number;
}

} // namespace br3_test

#endif // BR3_TEST_IMPROVEMENT_JUDGE_H

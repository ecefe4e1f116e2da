// A mesh that local operations change, with constraints and exact positions, and exact checks of what they did: against
// the cells that go and come by definition, everything else has to stay.

#ifndef BR3_TEST_CHANGING_MESH_H
#define BR3_TEST_CHANGING_MESH_H

#include "random_triangulations_br3.h"

#include <CGAL/Boundary_recovery_3/Boundary_recovery_visitor_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Exact_positions_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Mesh_editor_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/mesh_validity.h>
#include <CGAL/Lazy_exact_nt.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <map>
#include <random>
#include <set>
#include <utility>
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

template <typename Number>
Number exact_number(const Number& x) { return x; }

template <typename Number>
Number exact_number(const CGAL::Lazy_exact_nt<Number>& x) { return x.exact(); }

struct Interruption { };

// Remembers what it was told last, and interrupts one of the next calls if it is asked to.
struct Change_recorder
  : public CGAL::Default_boundary_recovery_visitor_3
{
  typedef std::vector<const void*> Addresses;

  template <typename CellRange>
  void before_cells_removal(const CellRange& cells)
  {
    count_down();
    removed = addresses(cells);
  }

  template <typename CellRange>
  void after_cells_creation(const CellRange& cells)
  {
    created = addresses(cells);
    count_down();
  }

  void count_down()
  {
    if(number_of_calls_left > 0 && --number_of_calls_left == 0)
      throw Interruption();
  }

  template <typename CellRange>
  static Addresses addresses(const CellRange& cells)
  {
    Addresses result;
    for(const auto c : cells)
      result.push_back(&*c);
    return result;
  }

  Addresses removed, created;
  int number_of_calls_left = 0; // until it throws; it never does if there are none
};

template <typename Kernel, bool has_exact_positions_>
struct Changing_mesh
{
  static constexpr bool has_exact_positions = has_exact_positions_;

  typedef typename Triangulations<Kernel>::Delaunay                 Tr;
  typedef typename Tr::Vertex_handle                                Vertex_handle;
  typedef typename Tr::Cell_handle                                  Cell_handle;
  typedef typename Tr::Point                                        Point;
  typedef CGAL::Boundary_recovery_3::internal::Exact_positions_3<Tr>    Positions;
  typedef CGAL::Boundary_recovery_3::internal::Vertex_predicates_3<Tr>  Predicates;
  typedef CGAL::Boundary_recovery_3::internal::Mesh_editor_3<Tr, Change_recorder>  Editor;
  typedef Constraint_set<Vertex_handle>                             Constraints;
  typedef typename Constraints::Simplex                             Simplex;
  typedef std::array<Vertex_handle, 4>                              Tetrahedron;
  typedef std::vector<Tetrahedron>                                  Tetrahedra;
  typedef std::vector<Vertex_handle>                                Vertices;
  typedef std::vector<Cell_handle>                                  Cells;
  typedef decltype(exact_number(std::declval<typename Positions::Exact_FT>()))  Number;
  typedef std::array<Number, 3>                                     Exact_point;

  Changing_mesh(const Lattice_points& points, const int number_of_flips, std::mt19937& rng)
    : predicates(tr, has_exact_positions ? &positions : nullptr), editor(tr, recorder)
  {
    insert_points(tr, points);
    if(number_of_flips > 0)
      flip_at_random(tr, number_of_flips, rng);
  }

  // About one of n facets, and of n edges.
  void insert_random_constraints(const int n, std::mt19937& rng)
  {
    for(const Cell_handle c : tr.finite_cell_handles())
      for(int i = 0; i < 4; ++i)
        if(random_int(rng, n) == 0)
        {
          Simplex s = vertices_of(c);
          s.erase(c->vertex(i));
          if(random_int(rng, 2) == 0)
            s.erase(s.begin());
          constraints.insert(s);
        }
  }

  // --- what there is, by definition ---------------------------------------------------------------------------------

  static Tetrahedron tetrahedron(const Cell_handle c)
  {
    return {{ c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3) }};
  }

  static Simplex vertices_of(const Tetrahedron& t) { return Simplex(t.begin(), t.end()); }
  static Simplex vertices_of(const Cell_handle c) { return vertices_of(tetrahedron(c)); }

  static Tetrahedron with_exchanged(const Cell_handle c, const Vertex_handle v, const Vertex_handle x)
  {
    Tetrahedron t = tetrahedron(c);
    std::replace(t.begin(), t.end(), v, x);
    return t;
  }

  // All of them that have the simplex, infinite ones, too.
  Cells cells_with(const Simplex& simplex) const
  {
    Cells result;
    for(const Cell_handle c : tr.all_cell_handles())
    {
      const Simplex vertices = vertices_of(c);
      if(std::includes(vertices.begin(), vertices.end(), simplex.begin(), simplex.end()))
        result.push_back(c);
    }
    return result;
  }

  bool is_infinite(const Tetrahedron& t) const { return std::count(t.begin(), t.end(), tr.infinite_vertex()) > 0; }

  bool is_any_infinite(const Cells& cells) const
  {
    return std::any_of(cells.begin(), cells.end(), [&](const Cell_handle c) { return tr.is_infinite(c); });
  }

  Exact_point exact_point(const Vertex_handle v) const
  {
    const auto p = positions(v);
    return {{ exact_number(p.x()), exact_number(p.y()), exact_number(p.z()) }};
  }

  // Six times the signed volume.
  Number volume(const Tetrahedron& t) const
  {
    std::array<Exact_point, 4> p;
    std::transform(t.begin(), t.end(), p.begin(), [&](const Vertex_handle v) { return exact_point(v); });
    for(std::size_t i = 1; i < 4; ++i)
      for(std::size_t k = 0; k < 3; ++k)
        p[i][k] -= p[0][k];
    Number result(0);
    for(std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
      result += p[1][k] * (p[2][l] * p[3][m] - p[2][m] * p[3][l]);
    }
    return result;
  }

  bool are_positive(const Tetrahedra& tetrahedra) const
  {
    return std::all_of(tetrahedra.begin(), tetrahedra.end(),
                       [&](const Tetrahedron& t) { return is_infinite(t) || volume(t) > 0; });
  }

  // Of the finite ones, all of which are positive.
  Number total_volume(const Tetrahedra& tetrahedra) const
  {
    Number sum(0);
    for(const Tetrahedron& t : tetrahedra)
      if(! is_infinite(t))
      {
        const Number v = volume(t);
        assert(v > 0);
        sum += v;
      }
    return sum;
  }

  bool are_all_constraints_there() const
  {
    std::set<Simplex> there;
    for(const Cell_handle c : tr.finite_cell_handles())
      for(int i = 0; i < 4; ++i)
      {
        Simplex s = vertices_of(c);
        s.erase(c->vertex(i));
        there.insert(s);
        for(int j = 0; j < i; ++j)
          there.insert({ c->vertex(i), c->vertex(j) });
      }
    return std::includes(there.begin(), there.end(), constraints.simplices.begin(), constraints.simplices.end());
  }

  // --- changes ------------------------------------------------------------------------------------------------------

  // Puts a vertex at a point, if there are numbers for it.
  bool place(const Vertex_handle v, const Exact_point& p)
  {
    if constexpr(has_exact_positions || Positions::is_kernel_exact)
    {
      typedef typename Positions::Exact_FT FT;
      positions.set(v, typename Positions::Exact_point_3(FT(p[0]), FT(p[1]), FT(p[2])));
    }
    else
      v->set_point(Point(CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])));
    return exact_point(v) == p;
  }

  // A point inside the simplex. Vertices that are given several times attract it.
  Exact_point random_point(const Vertices& simplex, std::mt19937& rng) const
  {
    const int total = has_exact_positions ? 21 : 16;
    std::vector<int> weights(simplex.size(), 1);
    for(std::size_t k = simplex.size(); k < static_cast<std::size_t>(total); ++k)
      ++weights[static_cast<std::size_t>(random_int(rng, static_cast<int>(weights.size())))];
    Exact_point result = {{ Number(0), Number(0), Number(0) }};
    for(std::size_t i = 0; i < simplex.size(); ++i)
    {
      const Exact_point p = exact_point(simplex[i]);
      for(std::size_t k = 0; k < 3; ++k)
        result[k] += p[k] * weights[i] / total;
    }
    return result;
  }

  // At a point inside the simplex. It is none if there are no numbers for that.
  Vertex_handle create_vertex(const Vertices& simplex, std::mt19937& rng)
  {
    const Exact_point p = random_point(simplex, rng);
    const Vertex_handle v = editor.create_vertex();
    if(place(v, p))
      return v;
    delete_vertex(v);
    return Vertex_handle();
  }

  void delete_vertex(const Vertex_handle v)
  {
    positions.erase(v);
    editor.delete_vertex(v);
  }

  Tr tr;
  Positions positions;
  Predicates predicates;
  Change_recorder recorder;
  Editor editor;
  Constraints constraints;
};

// The cells with their vertices and neighbors, and the vertices with their points.
template <typename Mesh>
struct Mesh_record
{
  typedef const void* Address;
  struct Cell
  {
    bool operator==(const Cell& other) const { return vertices == other.vertices && neighbors == other.neighbors; }

    std::array<Address, 4> vertices, neighbors;
  };

  explicit Mesh_record(const Mesh& mesh)
  {
    for(const auto c : mesh.tr.all_cell_handles())
      for(int i = 0; i < 4; ++i)
      {
        cells[&*c].vertices[static_cast<std::size_t>(i)] = &*c->vertex(i);
        cells[&*c].neighbors[static_cast<std::size_t>(i)] = &*c->neighbor(i);
      }
    for(auto v = mesh.tr.tds().vertices().begin(); v != mesh.tr.tds().vertices().end(); ++v)
      if(v != mesh.tr.infinite_vertex())
        points.emplace(&*v, v->point());
  }

  bool operator==(const Mesh_record& other) const { return cells == other.cells && points == other.points; }

  std::map<Address, Cell> cells;
  std::map<Address, typename Mesh::Point> points; // with those that are in no cell
};

// The cells that are going to be replaced, and the tetrahedra that are to come in their place.
template <typename Mesh>
class Expected_change
{
public:
  typedef typename Mesh::Cell_handle    Cell_handle;
  typedef typename Mesh::Vertex_handle  Vertex_handle;
  typedef typename Mesh::Cells          Cells;
  typedef typename Mesh::Tetrahedron    Tetrahedron;
  typedef typename Mesh::Tetrahedra     Tetrahedra;
  typedef typename Mesh::Vertices       Vertices;

  Expected_change(Mesh& mesh, const Cells& old_cells, const Tetrahedra& tetrahedra,
                  const Vertices& dropped = Vertices())
    : m_mesh(mesh), m_before(mesh)
  {
    Tetrahedra old_tetrahedra;
    for(const Cell_handle c : old_cells)
    {
      m_old_cells.insert(&*c);
      old_tetrahedra.push_back(Mesh::tetrahedron(c));
    }
    assert(m_old_cells.size() == old_cells.size());
    for(const Tetrahedron& t : tetrahedra)
      m_new_simplices.insert(addresses(t));
    assert(mesh.total_volume(old_tetrahedra) == mesh.total_volume(tetrahedra));
    for(const Vertex_handle v : dropped)
    {
      m_dropped.insert(&*v);
      mesh.positions.erase(v);
    }
  }

  // If the visitor throws, either nothing or all has happened; it is thrown again.
  template <typename Change>
  void make(const Change& change)
  {
    m_mesh.recorder.removed.clear();
    m_mesh.recorder.created.clear();
    try {
      change();
    } catch(const Interruption&) {
      if(m_mesh.recorder.removed.empty())
        assert(m_before == Record(m_mesh));
      else
        check();
      throw;
    }
    check();
    assert(m_mesh.are_all_constraints_there());
  }

private:
  typedef Mesh_record<Mesh>           Record;
  typedef typename Record::Address    Address;
  typedef std::set<Address>           Addresses;

  static std::multiset<Address> addresses(const Tetrahedron& t)
  {
    std::multiset<Address> result;
    for(const Vertex_handle v : t)
      result.insert(&*v);
    return result;
  }

  void check() const
  {
    const Record now(m_mesh);
    check_old_cells(now);
    check_new_cells();
    std::map<Address, typename Mesh::Point> points = m_before.points;
    for(const Address v : m_dropped)
      assert(points.erase(v) == 1);
    assert(now.points == points);
    assert(m_mesh.tr.tds().is_valid());
    assert(CGAL::Boundary_recovery_3::internal::is_mesh_valid(m_mesh.tr, m_mesh.predicates));
  }

  void check_old_cells(const Record& now) const
  {
    for(const auto& c : m_before.cells)
    {
      if(m_old_cells.count(c.first) == 1)
        continue;
      const auto it = now.cells.find(c.first);
      assert(it != now.cells.end() && it->second.vertices == c.second.vertices);
      for(std::size_t i = 0; i < 4; ++i)
        if(m_old_cells.count(c.second.neighbors[i]) == 0)
          assert(it->second.neighbors[i] == c.second.neighbors[i]);
    }
    assert(now.cells.size() == m_before.cells.size() - m_old_cells.size() + m_new_simplices.size());
  }

  void check_new_cells() const
  {
    Addresses new_cells;
    std::multiset<std::multiset<Address> > simplices;
    Tetrahedra tetrahedra;
    for(const Cell_handle c : m_mesh.tr.all_cell_handles())
      if(m_before.cells.count(&*c) == 0 || m_old_cells.count(&*c) == 1)
      {
        new_cells.insert(&*c);
        tetrahedra.push_back(Mesh::tetrahedron(c));
        simplices.insert(addresses(tetrahedra.back()));
      }
    assert(simplices == m_new_simplices);
    assert(m_mesh.are_positive(tetrahedra));
    check_told_cells(m_mesh.recorder.removed, m_old_cells);
    check_told_cells(m_mesh.recorder.created, new_cells);
    check_told_cells(Change_recorder::addresses(m_mesh.editor.new_cells()), new_cells);
  }

  // Each of them once.
  static void check_told_cells(const Change_recorder::Addresses& told, const Addresses& expected)
  {
    assert(told.size() == expected.size() && Addresses(told.begin(), told.end()) == expected);
  }

  Mesh& m_mesh;
  const Record m_before;
  Addresses m_old_cells, m_dropped;
  std::multiset<std::multiset<Address> > m_new_simplices;
};

} // namespace br3_test

#endif // BR3_TEST_CHANGING_MESH_H

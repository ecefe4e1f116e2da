// A mesh that local operations change, with constraints and exact positions, and what there is in it by definition.

#ifndef BR3_TEST_CHANGING_MESH_H
#define BR3_TEST_CHANGING_MESH_H

#include "constraint_sets_br3.h"
#include "random_triangulations_br3.h"

#include <CGAL/Boundary_recovery_3/Meshing_visitor_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Exact_positions_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Mesh_editor_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Mesh_visitor_3.h>
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

template <typename Number>
Number exact_number(const Number& x) { return x; }

template <typename Number>
Number exact_number(const CGAL::Lazy_exact_nt<Number>& x) { return x.exact(); }

struct Interruption { };

// Remembers what it was told last, and interrupts one of the next calls if it is asked to.
struct Change_recorder
  : public CGAL::Default_meshing_visitor_3
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
  typedef CGAL::Boundary_recovery_3::internal::Any_visitor_3<Tr, Change_recorder&>  Any_recorder;
  typedef CGAL::Boundary_recovery_3::internal::Mesh_editor_3<Tr>    Editor;
  typedef Constraint_set<Vertex_handle>                             Constraints;
  typedef typename Constraints::Simplex                             Simplex;
  typedef std::array<Vertex_handle, 4>                              Tetrahedron;
  typedef std::vector<Tetrahedron>                                  Tetrahedra;
  typedef std::vector<Vertex_handle>                                Vertices;
  typedef std::vector<Cell_handle>                                  Cells;
  typedef decltype(exact_number(std::declval<typename Positions::Exact_FT>()))  Number;
  typedef std::array<Number, 3>                                     Exact_point;

  Changing_mesh(const Lattice_points& points, const int number_of_flips, std::mt19937& rng)
    : predicates(tr, has_exact_positions ? &positions : nullptr), any_recorder(recorder),
      editor(tr, any_recorder)
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
            s.erase(c->vertex((i + 1) % 4));
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

  static bool is_face(const Simplex& face, const Simplex& s)
  {
    return std::includes(s.begin(), s.end(), face.begin(), face.end());
  }

  // All of them that have the simplex, infinite ones, too.
  Cells cells_with(const Simplex& simplex) const
  {
    Cells result;
    for(const Cell_handle c : tr.all_cell_handles())
      if(is_face(simplex, vertices_of(c)))
        result.push_back(c);
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
  Any_recorder any_recorder; // hands on everything to `recorder`
  Editor editor;
  Constraints constraints;
};

} // namespace br3_test

#endif // BR3_TEST_CHANGING_MESH_H

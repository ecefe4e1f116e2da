// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// Points of the input and vertices of the triangulation: which are at the same place, which can be inserted, and which
// are on constraints that are not theirs.

#undef NDEBUG

#include "random_triangulations_br3.h"
#include "reference_geometry_br3.h"
#include "stopping_visitor_br3.h"

#include <CGAL/Boundary_recovery_3/internal/input/Constraint_intersections_3.h>
#include <CGAL/Boundary_recovery_3/internal/input/Indexed_input_3.h>
#include <CGAL/Boundary_recovery_3/internal/input/Input_diagnosis_3.h>
#include <CGAL/Boundary_recovery_3/internal/input/Vertex_location.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace internal = CGAL::Boundary_recovery_3::internal;
using namespace br3_test;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Epick;
typedef CGAL::Exact_predicates_exact_constructions_kernel   Epeck;

template <typename Tr>
using Context = internal::Recovery_context<Tr>;

template <typename K>
typename K::Point_3 to_point(const Lattice_point& p)
{
  return typename K::Point_3(static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z));
}

// All the places of a lattice that has a vertex at some of them, also where the triangulation is not Delaunay.
template <typename K>
void test_location(std::mt19937& rng)
{
  typedef typename Triangulations<K>::Delaunay Tr;
  Tr tr;
  assert(internal::Vertex_location<Tr>(tr)(typename K::Point_3(CGAL::ORIGIN)) == typename Tr::Vertex_handle());
  const Lattice_points points = random_points(100, 6, rng);
  insert_points(tr, points);
  flip_at_random<K>(tr, 30, rng);
  const internal::Vertex_location<Tr> location(tr);
  const auto vertices = finite_vertices(tr);
  for(int x = -1; x <= 6; ++x)
    for(int y = -1; y <= 6; ++y)
      for(int z = -1; z <= 6; ++z)
      {
        const Lattice_point place = { x, y, z };
        const auto is_here = [&](const Lattice_point& p) { return p.x == x && p.y == y && p.z == z; };
        const auto it = std::find_if(points.begin(), points.end(), is_here);
        assert(location(to_point<K>(place)) == (it == points.end() ? typename Tr::Vertex_handle()
                                                                   : vertices[it - points.begin()]));
      }
}

// Against the definition: no vertex is inside the sphere of a cell.
template <typename K>
bool are_spheres_empty(const typename Triangulations<K>::Delaunay& tr)
{
  for(const auto c : tr.finite_cell_handles())
    for(const auto v : tr.finite_vertex_handles())
      if(tr.side_of_sphere(c, v->point()) == CGAL::ON_BOUNDED_SIDE)
        return false;
  return true;
}

template <typename K>
void test_can_insert(std::mt19937& rng)
{
  typedef Triangulations<K> Types;
  int number_of_true = 0;
  for(int round = 0; round < 60; ++round)
  {
    typename Types::Delaunay tr;
    assert(internal::can_insert(tr));
    insert_points(tr, round % 2 == 0 ? random_points(20, 1000, rng) : grid_points(3, 3, 2, 100, rng));
    assert(internal::can_insert(tr));
    flip_at_random<K>(tr, 1 + round % 3, rng);
    const bool is_delaunay = are_spheres_empty<K>(tr);
    assert(internal::can_insert(tr) == is_delaunay);
    number_of_true += is_delaunay;
  }
  assert(number_of_true > 5 && number_of_true < 55);
  assert(! internal::can_insert(typename Types::Triangulation()));
}

// Some points are known before, and some are there twice.
template <typename K>
void test_insertion(std::mt19937& rng)
{
  typedef typename Triangulations<K>::Delaunay Tr;
  Tr tr;
  std::vector<typename K::Point_3> points;
  std::vector<typename Tr::Vertex_handle> vertices;
  std::set<Lattice_point> known, all;
  for(int i = 0; i < 300; ++i)
  {
    const Lattice_point p = { random_int(rng, 7), random_int(rng, 7), random_int(rng, 7) };
    points.push_back(to_point<K>(p));
    all.insert(p);
    vertices.push_back(i % 4 == 0 ? tr.insert(points.back()) : typename Tr::Vertex_handle());
    if(i % 4 == 0)
      known.insert(p);
  }
  Stopping_visitor<Tr> visitor;
  Context<Tr> context(visitor);
  assert(internal::insert_points(tr, points, vertices, context) == all.size() - known.size());
  assert(tr.number_of_vertices() == all.size() && tr.is_valid());
  for(std::size_t i = 0; i < points.size(); ++i)
    assert(vertices[i]->point() == points[i]);
}

// After a no, the points that are left have no vertices.
void test_stopped_insertion(std::mt19937& rng)
{
  typedef Triangulations<Epick>::Delaunay Tr;
  std::vector<Epick::Point_3> points;
  for(const Lattice_point& p : random_points(3000, 1 << 20, rng))
    points.push_back(to_point<Epick>(p));
  for(const std::size_t last_question : { 0, 1, 2 })
  {
    Tr tr;
    std::vector<Tr::Vertex_handle> vertices(points.size());
    Stopping_visitor<Tr> visitor;
    visitor.last_question = last_question;
    Context<Tr> context(visitor);
    const std::size_t n = internal::insert_points(tr, points, vertices, context);
    assert(context.is_stopped() && n == tr.number_of_vertices() && n < points.size());
    assert((n == 0) == (last_question == 0));
    assert(n == points.size() - std::count(vertices.begin(), vertices.end(), Tr::Vertex_handle()));
  }
}

// Random triangles and segments between vertices of a small lattice, of which the first are not of the input.
template <typename K>
class Constraints_among_vertices
{
public:
  typedef typename Triangulations<K>::Delaunay     Tr;
  typedef typename Tr::Vertex_handle               Vertex_handle;
  typedef internal::Indexed_input_3<typename K::Point_3> Input;
  typedef internal::Recovery_diagnosis<K>          Diagnosis;
  typedef typename Diagnosis::Simplex              Simplex;

  static constexpr std::size_t number_of_others = 10;

  explicit Constraints_among_vertices(std::mt19937& rng)
    : m_points(random_points(60, 5, rng))
  {
    insert_points(m_tr, m_points);
    const std::vector<Vertex_handle> all = finite_vertices(m_tr);
    m_vertices.assign(all.begin() + number_of_others, all.end());
    for(const Vertex_handle v : m_vertices)
      m_input.points.push_back(v->point());
    for(int k = 0; k < 40; ++k)
    {
      const std::size_t a = random_vertex(rng), b = random_vertex(rng), c = random_vertex(rng);
      if(k % 3 == 0 && a != b)
        m_input.edges.push_back({{ a, b }});
      else if(! is_zero(cross(point(b) - point(a), point(c) - point(a))))
        m_input.facets.push_back({{ a, b, c }});
    }
    for(std::size_t f = 0; f < m_input.facets.size(); ++f)
      m_constraints.push_back(internal::describe_facet(m_input, f));
    for(std::size_t e = 0; e < m_input.edges.size(); ++e)
      m_constraints.push_back(internal::describe_edge(m_input, e));
  }

  // Returns the number of vertices on constraints.
  std::size_t check() const
  {
    const K kernel;
    Diagnosis diagnosis(m_input, kernel);
    Stopping_visitor<Tr> patient, impatient;
    impatient.last_question = 0;
    Context<Tr> context(patient), stopped_context(impatient);
    std::set<std::pair<std::size_t, std::size_t> > found; // constraints, and vertices by their points
    for(const auto& d : diagnosis.vertices_on_constraints(m_constraints, m_tr, m_vertices, context))
      assert(found.emplace(position(d.simplices[1]), lattice_index(d.simplices[0])).second);
    assert(found == expected());
    stopped_context.go_further();
    assert(diagnosis.vertices_on_constraints(m_constraints, m_tr, m_vertices, stopped_context).empty());

    const std::size_t n = diagnosis.intersecting_pairs(m_constraints, context).size();
    std::size_t number = 0;
    internal::Constraint_intersections_3<K>(m_input, kernel).defects(context, n, number);
    assert(number == n && n > 0);
    assert(diagnosis.intersecting_pairs({}, context).empty());
    return found.size();
  }

private:
  const Lattice_point& point(const std::size_t v) const { return m_points[number_of_others + v]; }

  std::size_t random_vertex(std::mt19937& rng) const
  {
    return static_cast<std::size_t>(random_int(rng, static_cast<int>(m_vertices.size())));
  }

  std::size_t position(const Simplex& constraint) const
  {
    return constraint.dimension == 2 ? constraint.index : m_input.facets.size() + constraint.index;
  }

  // Vertices that are not of the input have no index.
  std::size_t lattice_index(const Simplex& vertex) const
  {
    for(std::size_t i = 0; i < m_points.size(); ++i)
      if(to_point<K>(m_points[i]) == vertex.points.at(0))
      {
        assert(vertex.dimension == 0 && (vertex.index == i - number_of_others || i < number_of_others));
        assert(vertex.vertices.size() == (i < number_of_others ? 0 : 1));
        return i;
      }
    assert(false);
    return m_points.size();
  }

  std::set<std::pair<std::size_t, std::size_t> > expected() const
  {
    std::set<std::pair<std::size_t, std::size_t> > result;
    for(std::size_t k = 0; k < m_constraints.size(); ++k)
      for(std::size_t i = 0; i < m_points.size(); ++i)
        if(is_on(m_points[i], m_constraints[k].vertices))
          result.emplace(k, i);
    return result;
  }

  bool is_on(const Lattice_point& p, const std::vector<std::size_t>& v) const
  {
    if(v.size() == 2)
      return is_in_open_segment(point(v[0]), point(v[1]), p);
    return is_in_triangle(point(v[0]), point(v[1]), point(v[2]), p, true)
        && ! is_zero(p - point(v[0])) && ! is_zero(p - point(v[1])) && ! is_zero(p - point(v[2]));
  }

  const Lattice_points m_points;
  Tr m_tr;
  std::vector<Vertex_handle> m_vertices;
  Input m_input;
  std::vector<Simplex> m_constraints;
};

template <typename K>
void test(const unsigned seed)
{
  std::mt19937 rng(seed);
  test_location<K>(rng);
  test_can_insert<K>(rng);
  test_insertion<K>(rng);
  std::size_t number_of_vertices_on_constraints = 0;
  for(int round = 0; round < 20; ++round)
    number_of_vertices_on_constraints += Constraints_among_vertices<K>(rng).check();
  assert(number_of_vertices_on_constraints > 100);
}

// Vertices that are in no triangulation: all that the search asks for is where they are. Handles count how often they
// are compared.
struct Loose_vertex
{
  Epick::Point_3 p;

  const Epick::Point_3& point() const { return p; }
};

struct Loose_handle
{
  typedef std::forward_iterator_tag iterator_category;
  typedef Loose_vertex              value_type;
  typedef std::ptrdiff_t            difference_type;
  typedef const Loose_vertex*       pointer;
  typedef const Loose_vertex&       reference;

  const Loose_vertex* v;

  const Loose_vertex* operator->() const { return v; }
  const Loose_vertex& operator*() const { return *v; }

  friend bool operator==(const Loose_handle x, const Loose_handle y)
  {
    ++number_of_comparisons;
    return x.v == y.v;
  }

  static std::size_t number_of_comparisons;
};

std::size_t Loose_handle::number_of_comparisons = 0;

struct Loose_vertices
{
  typedef Loose_handle Vertex_handle;

  std::vector<Vertex_handle> handles;

  const std::vector<Vertex_handle>& finite_vertex_handles() const { return handles; }
};

// Points on one facet, each of which is a defect: they are not compared with all vertices.
void test_many_defects()
{
  typedef internal::Recovery_diagnosis<Epick> Diagnosis;
  const std::size_t n = 1000;
  internal::Indexed_input_3<Epick::Point_3> input;
  input.facets.push_back({{ 0, 1, 2 }});
  std::vector<Loose_vertex> vertices = { { Epick::Point_3(0, 0, 0) }, { Epick::Point_3(n, 0, 0) },
                                         { Epick::Point_3(0, n, 0) } };
  for(std::size_t i = 1; i < n; ++i)
    vertices.push_back({ Epick::Point_3(static_cast<double>(i), .5, 0) });
  Loose_vertices tr;
  for(const Loose_vertex& v : vertices)
  {
    tr.handles.push_back(Loose_handle{ &v });
    input.points.push_back(v.point());
  }
  const std::vector<Diagnosis::Simplex> constraints(1, internal::describe_facet(input, 0));
  const Epick kernel;
  Diagnosis diagnosis(input, kernel);
  Stopping_visitor<Triangulations<Epick>::Delaunay> patient; // of any triangulation
  Context<Triangulations<Epick>::Delaunay> context(patient);
  const auto defects = diagnosis.vertices_on_constraints(constraints, tr, tr.handles, context);
  assert(defects.size() == n - 1);
  for(std::size_t i = 0; i < defects.size(); ++i)
    assert(defects[i].simplices[0].index == i + 3);
  assert(Loose_handle::number_of_comparisons < 20 * n);
}

int main()
{
  test<Epick>(1);
  test<Epeck>(2);
  std::mt19937 rng(3);
  test_stopped_insertion(rng);
  test_many_defects();
  std::cout << "done" << std::endl;
}

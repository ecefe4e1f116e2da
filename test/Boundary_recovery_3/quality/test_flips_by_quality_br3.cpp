// Removal of edges and of facets, led by quality, on random constrained meshes, judged after each step; against brute
// force; and the removal of facets as the inverse of that of an edge.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "improvement_judge_br3.h"
#include "mesh_validity_br3.h"

#include <CGAL/Boundary_recovery_3/Cell_quality_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Flip_bad_cell_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Retriangulate_facets_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Skirt_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <iterator>
#include <limits>
#include <set>
#include <vector>

namespace BR3 = CGAL::Boundary_recovery_3;
namespace internal = BR3::internal;
using br3_test::Improvement_options;
using br3_test::Lengths_slack;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef br3_test::Improvement_scene<Kernel>                 Scene;
typedef Scene::Tr                                           Tr;
typedef Scene::Vertex_handle                                Vertex_handle;
typedef Scene::Cell_handle                                  Cell_handle;
typedef std::array<std::array<double, 3>, 4>                Corners;

// One of two models, or random, or what a test wishes: cells with the edge on the axis and two points that are side by
// side around it are good.
struct Quality
{
  int kind = 0;
  std::vector<std::array<double, 3> > ring = {}; // of the edge on the axis, whose ends are at x = y = 0
  double of_ring_cells = 1;
  double shift = 0; // for other random qualities

  double operator()(const Corners& corners) const
  {
    return kind == 0 ? BR3::Dihedral_angle_quality_3()(corners)
         : kind == 1 ? BR3::Volume_length_quality_3()(corners)
         : kind == 2 ? br3_test::random_quality(shifted(corners)) : wish(corners);
  }

  Corners shifted(Corners corners) const
  {
    for(auto& p : corners)
      p[0] += shift;
    return corners;
  }

  double wish(const Corners& corners) const
  {
    std::vector<std::size_t> places;
    for(const auto& p : corners)
    {
      const auto it = std::find(ring.begin(), ring.end(), p);
      if(it != ring.end())
        places.push_back(static_cast<std::size_t>(it - ring.begin()));
    }
    if(places.size() != 2)
      return 0.5;
    const std::size_t d = places[0] > places[1] ? places[0] - places[1] : places[1] - places[0];
    return d == 1 || d + 1 == ring.size() ? of_ring_cells : 0.1;
  }
};

typedef br3_test::Improvement_trial<Scene, Quality>   Trial;
typedef Trial::Mesh                                   Mesh;

struct Improvement
  : public Trial
{
  Improvement(const unsigned seed, const Improvement_options& options, const int kind, const double degrees)
    : Trial(seed, options, Quality{ kind },
            kind == 0 ? BR3::Dihedral_angle_quality_3().of_angle(degrees)
          : kind == 1 ? BR3::Volume_length_quality_3().of_angle(degrees) : 0.9)
  { }
};

// All steps on random meshes. Returns how many there were of each kind.
std::array<int, 4> test_all_steps(const unsigned seed)
{
  Improvement_options options;
  options.is_grid = seed % 4 == 0;
  options.size = seed % 3 == 0 ? 0.06 : seed % 3 == 1 ? 0.4 : 0;
  std::array<int, 4> number = {{ 0, 0, 0, 0 }};
  const int kind = seed / 2 % 3;
  const double degrees = 10 + seed % 5 * 10;
  {
    Improvement t(seed, options, kind, degrees);
    internal::Remove_bad_edge_3<Mesh> remove(t.mesh);
    for(int i = 0; i < 4; ++i)
      for(int j = 0; j < i; ++j)
        number[0] += try_on_all_cells(t.scene, t.mesh, Lengths_slack::edges_that_go, [&](const Cell_handle c)
                                      { return remove.find(c, i, j, 0) && remove.apply(); });
  }
  {
    Improvement t(seed, options, kind, degrees);
    internal::Remove_bad_facet_3<Mesh> remove(t.mesh);
    for(int i = 0; i < 4; ++i)
      number[1] += try_on_all_cells(t.scene, t.mesh, Lengths_slack::none, [&](const Cell_handle c)
                                    { return remove.find(c, i, 0) && remove.apply(); });
  }
  {
    Improvement t(seed, options, kind, degrees);
    internal::Flip_bad_cell_3<Mesh> flip(t.mesh);
    number[2] = try_on_all_cells(t.scene, t.mesh, Lengths_slack::edges_that_go,
                                 [&](const Cell_handle c) { return flip.find(c) && flip.apply(); });
  }
  {
    Improvement t(seed, options, kind, degrees);
    internal::Retriangulate_facets_3<Mesh> retriangulate(t.mesh);
    number[3] = try_on_all_cells(t.scene, t.mesh, Lengths_slack::edges_that_go,
                                 [&](const Cell_handle c) { return retriangulate.find(c) && retriangulate.apply(); });
  }
  return number;
}

// ------------------------------------------------ the removal of an edge, by brute force

// An edge on the axis, and n points around it, at different distances and heights, if wished so.
void insert_ring(Improvement& t, const int n, const bool is_random = false)
{
  static const int circle[12][2] = { {25, 0}, {20, 15}, {15, 20}, {0, 25}, {-15, 20}, {-20, 15},
                                     {-25, 0}, {-20, -15}, {-15, -20}, {0, -25}, {15, -20}, {20, -15} };
  Tr& tr = t.scene.tr;
  tr.clear();
  const double height = is_random ? 12 : 4; // the sphere around the edge is empty
  tr.insert(Tr::Point(0, 0, height));
  tr.insert(Tr::Point(0, 0, -height));
  t.quality.ring.clear();
  for(int k = 0; k < n; ++k)
  {
    const double scale = is_random ? 0.25 * (2 + t.scene.random_int(4)) : 1;
    const double z = is_random ? 0.25 * (t.scene.random_int(16) - 8) : 0.25 * (k % 3);
    const double x = circle[12 * k / n][0] * scale, y = circle[12 * k / n][1] * scale;
    t.quality.ring.push_back({{ x, y, z }});
    tr.insert(Tr::Point(x, y, z));
  }
  t.scene.edges.clear();
  t.scene.select_all();
  assert(is_random || tr.number_of_finite_cells() == static_cast<std::size_t>(n));
}

std::array<int, 2> ends_on_axis(const Cell_handle c)
{
  std::array<int, 2> ends = {{ -1, -1 }};
  for(int i = 0; i < 4; ++i)
    if(c->vertex(i)->point().x() == 0 && c->vertex(i)->point().y() == 0)
      ends[c->vertex(i)->point().z() > 0] = i;
  return ends;
}


typedef std::vector<std::array<int, 3> > Triangles;

// All triangulations of the polygon of the vertices i to j.
std::vector<Triangles> triangulations(const int i, const int j)
{
  if(j == i + 1)
    return { Triangles() };
  std::vector<Triangles> result;
  for(int k = i + 1; k < j; ++k)
    for(const Triangles& left : triangulations(i, k))
      for(const Triangles& right : triangulations(k, j))
      {
        Triangles all = left;
        all.insert(all.end(), right.begin(), right.end());
        all.push_back({{ i, k, j }});
        result.push_back(all);
      }
  return result;
}

// The vertices around an edge, seen counterclockwise from b; none if a facet at it must stay.
std::vector<Vertex_handle> ring_of(const Improvement& t, const Vertex_handle a, const Vertex_handle b)
{
  std::vector<std::array<Vertex_handle, 2> > sides;
  for(const Cell_handle c : t.scene.cells())
    if(c->has_vertex(a) && c->has_vertex(b))
    {
      std::vector<Vertex_handle> others;
      for(int i = 0; i < 4; ++i)
        if(c->vertex(i) != a && c->vertex(i) != b)
        {
          others.push_back(c->vertex(i));
          if(t.domain.is_wall(c, i) || ! t.scene.contains(c))
            return { };
        }
      if(CGAL::orientation(a->point(), b->point(), others[0]->point(), others[1]->point()) != CGAL::POSITIVE)
        std::swap(others[0], others[1]);
      sides.push_back({{ others[0], others[1] }});
    }
  std::vector<Vertex_handle> ring(1, sides[0][0]);
  while(ring.size() < sides.size())
    for(const auto& side : sides)
      if(side[0] == ring.back() && ring.size() < sides.size())
        ring.push_back(side[1]);
  return ring;
}

double badness(const Mesh& mesh, const Vertex_handle p, const Vertex_handle q, const Vertex_handle r,
               const Vertex_handle s, double& worst)
{
  const double x = mesh.quality({{ Mesh::coordinates(p), Mesh::coordinates(q), Mesh::coordinates(r),
                                   Mesh::coordinates(s) }});
  worst = (std::min)(worst, x);
  return mesh.badness(x);
}

void check_edge(Improvement& t, internal::Remove_bad_edge_3<Mesh>& remove, const Cell_handle c, const int i,
                const int j, std::array<int, 2>& number)
{
  const Vertex_handle a = c->vertex(i), b = c->vertex(j);
  const auto ring = ring_of(t, a, b);
  const bool is_found = remove.find(c, i, j, 0);
  if(ring.empty() || t.domain.is_constrained_edge(a, b))
    assert(! is_found);
  if(ring.empty() || t.domain.is_constrained_edge(a, b) || ring.size() > 9)
    return;
  const int m = static_cast<int>(ring.size());
  double before = 0, worst_before = 2;
  for(int k = 0; k < m; ++k)
    before += badness(t.mesh, a, b, ring[k], ring[(k + 1) % m], worst_before);
  const double length = std::sqrt(CGAL::to_double(CGAL::squared_distance(a->point(), b->point())));
  double least = std::numeric_limits<double>::infinity();
  for(const Triangles& triangles : triangulations(0, m - 1))
  {
    double sum = 0, worst = 2;
    bool is_possible = true;
    for(const auto& f : triangles)
    {
      sum += badness(t.mesh, ring[f[0]], ring[f[1]], ring[f[2]], b, worst) +
             badness(t.mesh, ring[f[0]], ring[f[2]], ring[f[1]], a, worst);
      for(int k = 0; k < 3; ++k)
      {
        const int u = f[k], v = f[(k + 1) % 3], d = u < v ? v - u : u - v;
        is_possible = is_possible && (d == 1 || d == m - 1 || t.mesh.is_edge_in_size(ring[u], ring[v], length));
      }
    }
    if(is_possible && worst >= worst_before)
      least = (std::min)(least, sum);
  }
  ++number[is_found];
  if(is_found)
    assert(std::abs(remove.gain() - (before - least)) < 1e-12);
  else
    assert(! (least < before - 1e-12));
  if(is_found && ! remove.find(c, i, j, remove.gain() * 0.999))
    assert(false);
  assert(! remove.find(c, i, j, (before - (std::min)(least, before)) * 1.001 + 1e-12));
}

double badness_of_all(const Improvement& t)
{
  double sum = 0;
  for(const Cell_handle c : t.scene.cells())
    sum += t.mesh.badness(t.mesh.quality(c));
  return sum;
}

// Of all edges and facets of a cell, that one goes that helps most.
void test_best_flip()
{
  int number = 0;
  for(unsigned seed = 0; seed < 3; ++seed)
  {
    Improvement t(seed + 20, Improvement_options(), static_cast<int>(seed % 2), 30);
    internal::Remove_bad_edge_3<Mesh> remove_edge(t.mesh);
    internal::Remove_bad_facet_3<Mesh> remove_facet(t.mesh);
    internal::Flip_bad_cell_3<Mesh> flip(t.mesh);
    for(const Cell_handle c : t.scene.cells())
    {
      if(! t.scene.tr.tds().cells().is_used(c) || ! t.scene.contains(c))
        continue;
      double gain = 0;
      for(int i = 0; i < 4; ++i)
      {
        for(int j = 0; j < i; ++j)
          if(remove_edge.find(c, i, j, 0))
            gain = (std::max)(gain, remove_edge.gain());
        if(remove_facet.find(c, i, 0))
          gain = (std::max)(gain, remove_facet.gain());
      }
      const double before = badness_of_all(t);
      const bool is_done = flip.find(c);
      assert(! is_done || std::abs(flip.gain() - gain) < 1e-12);
      const bool is_applied = is_done && flip.apply();
      assert(is_applied == is_done);
      assert(is_done == (gain > 1e-10));
      assert(std::abs(before - badness_of_all(t) - gain) < 1e-9);
      number += is_done;
    }
  }
  assert(number > 50);
}

void test_best_removal_of_edge()
{
  std::array<int, 2> number = {{ 0, 0 }};
  for(unsigned seed = 0; seed < 6; ++seed)
  {
    Improvement_options options;
    options.is_grid = seed % 4 == 3;
    options.size = seed % 3 == 0 ? 0.06 : seed % 3 == 1 ? 0.4 : 0;
    Improvement t(seed + 70, options, seed % 3 == 0, 35);
    internal::Remove_bad_edge_3<Mesh> remove(t.mesh);
    for(const Cell_handle c : t.scene.cells())
      if(t.scene.contains(c))
        for(int i = 0; i < 4; ++i)
          check_edge(t, remove, c, i, (i + 1) % 4, number);
  }
  assert(number[0] > 100 && number[1] > 100);
  number = {{ 0, 0 }};
  for(unsigned seed = 0; seed < 200; ++seed) // larger rings
  {
    Improvement t(seed, Improvement_options(), static_cast<int>(seed % 3), 60);
    internal::Remove_bad_edge_3<Mesh> remove(t.mesh);
    insert_ring(t, 5 + static_cast<int>(seed % 5), true);
    for(const Vertex_handle v : t.scene.tr.finite_vertex_handles())
      v->set_meshing_info(seed % 4 == 0 ? 10 : 0);
    for(const Cell_handle c : t.scene.cells())
    {
      const auto ends = ends_on_axis(c);
      if(ends[0] >= 0 && ends[1] >= 0)
        check_edge(t, remove, c, ends[0], ends[1], number);
    }
  }
  assert(number[1] > 20);
}

// ------------------------------------------------ the removal of facets is the inverse

std::set<std::set<Vertex_handle> > vertex_sets(const Tr& tr)
{
  std::set<std::set<Vertex_handle> > result;
  for(const Cell_handle c : tr.finite_cell_handles())
    result.insert({ c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3) });
  return result;
}

void test_inverse(const int n)
{
  Improvement t(1, Improvement_options(), 3, 30);
  insert_ring(t, n);
  Tr& tr = t.scene.tr;
  t.mesh.set_enough(1);
  const auto before = vertex_sets(tr);
  internal::Remove_bad_edge_3<Mesh> remove_edge(t.mesh);
  internal::Remove_bad_facet_3<Mesh> remove_facet(t.mesh);
  t.quality.of_ring_cells = 0.2; // cells with the edge are bad
  const Cell_handle c = tr.finite_cells_begin();
  const auto ends = ends_on_axis(c);
  const bool is_removed = remove_edge.find(c, ends[0], ends[1], 0) && remove_edge.apply();
  assert(is_removed && tr.number_of_finite_cells() == static_cast<std::size_t>(2 * (n - 2)));
  assert(vertex_sets(tr) != before && tr.tds().is_valid());
  t.quality.of_ring_cells = 0.9; // they are good, but others with both ends are not
  const Cell_handle d = tr.finite_cells_begin();
  const auto apices = ends_on_axis(d);
  const int apex = (std::max)(apices[0], apices[1]);
  const bool are_too_many = n - 2 > remove_facet.max_number_of_facets;
  const bool is_put_back = remove_facet.find(d, apex, 0) && remove_facet.apply();
  assert(is_put_back != are_too_many);
  if(are_too_many)
    return;
  assert(vertex_sets(tr) == before && tr.tds().is_valid());
  assert(remove_facet.new_cells().size() == static_cast<std::size_t>(n));
}

// ------------------------------------------------ facets between two vertices, by brute force

// By how much the cells between a polygon and two vertices could be less bad; all cells are there.
double best_gain(const Improvement& t, const std::vector<Vertex_handle>& ring, const Vertex_handle a,
                 const Vertex_handle b)
{
  double worst_before = 2;
  for(const Cell_handle c : t.scene.tr.finite_cell_handles())
    worst_before = (std::min)(worst_before, t.mesh.quality(c));
  double least = badness_of_all(t);
  for(const Triangles& triangles : triangulations(0, static_cast<int>(ring.size()) - 1))
  {
    double sum = 0, worst = 2;
    for(const auto& f : triangles)
      sum += badness(t.mesh, ring[f[0]], ring[f[1]], ring[f[2]], b, worst) +
             badness(t.mesh, ring[f[0]], ring[f[2]], ring[f[1]], a, worst);
    if(worst >= worst_before)
      least = (std::min)(least, sum);
  }
  return badness_of_all(t) - least;
}

// When the edge on the axis is gone, qualities become random ones: of all triangulations of the polygon around it, the
// best one is found from any of the cells, unless something else is even better. Returns whether that was one at all.
bool test_best_retriangulation(const unsigned seed)
{
  Improvement t(seed, Improvement_options(), 3, 30);
  insert_ring(t, 5 + static_cast<int>(seed % 5));
  t.mesh.set_enough(1);
  Tr& tr = t.scene.tr;
  internal::Remove_bad_edge_3<Mesh> remove_edge(t.mesh);
  t.quality.of_ring_cells = 0.2;
  for(const Cell_handle c : t.scene.cells())
  {
    const auto ends = ends_on_axis(c);
    if(ends[0] < 0 || ends[1] < 0)
      continue;
    const Vertex_handle a = c->vertex(ends[0]), b = c->vertex(ends[1]);
    const auto ring = ring_of(t, a, b);
    const bool is_removed = remove_edge.find(c, ends[0], ends[1], 0) && remove_edge.apply();
    assert(is_removed);
    t.quality.kind = 2;
    t.quality.shift = seed / 4096.;
    t.mesh.set_enough(0.9);
    const double gain = best_gain(t, ring, a, b), before = badness_of_all(t);
    internal::Retriangulate_facets_3<Mesh> retriangulate(t.mesh);
    for(const Cell_handle d : t.scene.cells())
    {
      const bool is_found = retriangulate.find(d);
      assert(is_found ? retriangulate.gain() > gain - 1e-12 : gain < 1e-9);
    }
    if(gain < 1e-9)
      return false;
    const Cell_handle d = tr.finite_cells_begin();
    const bool is_best = retriangulate.find(d) && std::abs(retriangulate.gain() - gain) < 1e-12;
    if(! is_best || ! retriangulate.apply()) // random qualities may be best where cells are not positively oriented
      return false;
    assert(tr.tds().is_valid() && std::abs(before - badness_of_all(t) - gain) < 1e-12);
    return true;
  }
  return false;
}

int main()
{
  std::array<int, 4> number = {{ 0, 0, 0, 0 }};
  for(unsigned seed = 0; seed < 16; ++seed)
  {
    const auto more = test_all_steps(seed);
    for(int i = 0; i < 4; ++i)
      number[i] += more[i];
  }
  int number_of_best_ones = 0;
  for(unsigned seed = 0; seed < 1000; ++seed)
    number_of_best_ones += test_best_retriangulation(seed);
  std::cout << number[0] << " edges, " << number[1] << " facets, " << number[2] << " of either; " << number[3]
            << " retriangulations; " << number_of_best_ones << " of the whole mesh" << std::endl;
  assert(number[0] > 100 && number[1] > 100 && number[2] > 100 && number[3] > 100);
  assert(number_of_best_ones > 20);
  test_best_removal_of_edge();
  test_best_flip();
  for(int n = 3; n <= 12; ++n)
    test_inverse(n);
}

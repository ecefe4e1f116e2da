// Removals that failed are not tried again at the same shell, with what that depends on.

#undef NDEBUG // the checks are assertions, also in a Release build

#include <CGAL/Boundary_recovery_3/Meshing_visitor_3.h>
#include <CGAL/Boundary_recovery_3/Shell_3.h>
#include <CGAL/Boundary_recovery_3/Shell_quality_3.h>
#include <CGAL/Boundary_recovery_3/Shell_validity_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/shell/Failed_edge_removals_3.h>
#include <CGAL/Shell_transformation_3.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Random.h>
#include <CGAL/point_generators_3.h>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <utility>
#include <vector>

namespace BR = CGAL::Boundary_recovery_3;

typedef CGAL::Exact_predicates_inexact_constructions_kernel  Kernel;
typedef CGAL::Delaunay_triangulation_3<Kernel>               Tr;
typedef Tr::Vertex_handle                                    Vertex_handle;
typedef BR::Shell_3<Tr>                                      Shell;
typedef BR::internal::Vertex_predicates_3<Tr>                Predicates;
typedef BR::internal::Failed_edge_removals_3<Tr>             Failed_removals;
typedef CGAL::Shell_transformation_3<Tr, BR::Worst_element_quality_3<Tr> >  Transformation;
typedef std::pair<Vertex_handle, Vertex_handle>              Vertex_pair;

Tr triangulation_of_random_points(const int n)
{
  CGAL::Random random(5);
  CGAL::Random_points_in_cube_3<Kernel::Point_3> points(1, random);
  Tr tr;
  for(int i = 0; i < n; ++i)
    tr.insert(*points++);
  return tr;
}

std::vector<Vertex_pair> finite_edges(const Tr& tr)
{
  std::vector<Vertex_pair> result;
  for(const Tr::Edge& e : tr.finite_edges())
    result.emplace_back(e.first->vertex(e.second), e.first->vertex(e.third));
  return result;
}

Tr::Edge edge(const Tr& tr, const Vertex_pair& e)
{
  Tr::Edge result;
  assert(tr.is_edge(e.first, e.second, result.first, result.second, result.third));
  return result;
}

Shell shell(const Tr& tr, const Vertex_pair& e)
{
  const Tr::Edge mesh_edge = edge(tr, e);
  return Shell(tr, mesh_edge.first, mesh_edge.second, mesh_edge.third);
}

bool contains(Failed_removals& failed, const Shell& s, const Vertex_handle v, const int number_of_levels)
{
  bool was_cut_off = false;
  return failed.contains(failed.removal(s, v), number_of_levels, was_cut_off);
}

void test_table()
{
  Tr tr = triangulation_of_random_points(30);
  const Vertex_pair ab = finite_edges(tr).front();
  const Shell s = shell(tr, ab), reversed = shell(tr, { ab.second, ab.first });
  Failed_removals failed;
  assert(! contains(failed, s, Vertex_handle(), 0));
  failed.insert(failed.removal(s, Vertex_handle()), 3, true);
  assert(contains(failed, s, Vertex_handle(), 2) && contains(failed, reversed, Vertex_handle(), 3));
  assert(! contains(failed, s, Vertex_handle(), 4)); // more levels may help
  assert(! contains(failed, s, s.vertex(0), 3));     // nor is this a removal of the edge
  bool was_cut_off = false;
  assert(failed.contains(failed.removal(s, Vertex_handle()), 3, was_cut_off) && was_cut_off);

  failed.insert(failed.removal(s, s.vertex(0)), 3, false);
  assert(contains(failed, s, s.vertex(0), 100) && ! contains(failed, s, s.vertex(1), 0));
  assert(! contains(failed, s, Vertex_handle(), 3)); // the last failure counts
  assert(failed.contains(failed.removal(s, s.vertex(0)), 3, was_cut_off) && ! was_cut_off);

  const auto a = ab.first->point(), b = ab.second->point();
  const Vertex_handle v = tr.insert(CGAL::midpoint(a, b)); // edges at a have other shells now
  assert(! contains(failed, shell(tr, { ab.first, v }), s.vertex(0), 0));
}

// The edges of which a removal fails that changes nothing: they are asked for again.
void test_transformation()
{
  Tr tr = triangulation_of_random_points(200);
  CGAL::Default_meshing_visitor_3 visitor;
  BR::No_shell_validity_3 validity;
  Transformation with_memory(tr, BR::Worst_element_quality_3<Tr>(tr), visitor, Predicates(tr));
  Transformation without(tr, BR::Worst_element_quality_3<Tr>(tr));
  int number_of_failures = 0, number_cut_off = 0;
  for(const Vertex_pair& e : finite_edges(tr))
  {
    Tr::Edge mesh_edge;
    if(! tr.is_edge(e.first, e.second, mesh_edge.first, mesh_edge.second, mesh_edge.third))
      continue;
    const std::size_t changes = with_memory.number_of_transformations();
    if(with_memory.remove_edge(mesh_edge, 1, validity) || with_memory.number_of_transformations() != changes)
      continue;
    ++number_of_failures;
    const bool was_cut_off = with_memory.was_cut_off();
    const std::size_t shells = with_memory.number_of_shells();
    assert(! with_memory.remove_edge(edge(tr, e), 1, validity) && with_memory.number_of_shells() == shells);
    assert(with_memory.was_cut_off() == was_cut_off);
    assert(! without.remove_edge(edge(tr, e), 1) && without.number_of_transformations() == 0);
    if(was_cut_off)
    {
      ++number_cut_off;
      with_memory.remove_edge(edge(tr, e), 2, validity);
      assert(with_memory.number_of_shells() > shells);
    }
    else
      assert(! with_memory.remove_edge(edge(tr, e), 2, validity) && with_memory.number_of_shells() == shells);
    assert(tr.tds().is_valid());
  }

  std::cout << number_of_failures << " failures, " << number_cut_off << " cut off" << std::endl;
  assert(number_of_failures > 50 && number_cut_off > 10 && number_cut_off < number_of_failures);

  // With a new vertex in one of its cells, the shell of an edge is another one.
  const std::vector<Vertex_pair> edges = finite_edges(tr);
  const auto e = std::find_if(edges.begin(), edges.end(), [&](const Vertex_pair& e)
  {
    const std::size_t changes = with_memory.number_of_transformations();
    return ! with_memory.remove_edge(edge(tr, e), 1, validity) && with_memory.number_of_transformations() == changes
        && shell(tr, e).infinite_index() == Shell::none;
  });
  assert(e != edges.end());
  const std::size_t shells = with_memory.number_of_shells();
  assert(! with_memory.remove_edge(edge(tr, *e), 1, validity) && with_memory.number_of_shells() == shells);
  const Tr::Cell_handle c = edge(tr, *e).first;
  const Kernel::Point_3 center = CGAL::centroid(tr.tetrahedron(c));
  tr.tds().insert_in_cell(c)->set_point(center);
  with_memory.remove_edge(edge(tr, *e), 1, validity);
  assert(with_memory.number_of_shells() > shells);
}

int main()
{
  test_table();
  test_transformation();
  return 0;
}

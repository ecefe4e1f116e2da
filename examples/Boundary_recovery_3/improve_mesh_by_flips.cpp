#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Random.h>
#include <CGAL/Shell_transformation_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Delaunay_triangulation_3<Kernel>              Delaunay_triangulation;
typedef CGAL::Triangulation_3<Kernel, Delaunay_triangulation::Triangulation_data_structure> Triangulation;
typedef Triangulation::Vertex_handle                        Vertex_handle;
typedef Triangulation::Cell_handle                          Cell_handle;
typedef Triangulation::Edge                                 Edge;

//! [models]
// The worst tetrahedron counts more than the number of tetrahedra around the edge.
struct Quality
  : public CGAL::Boundary_recovery_3::Worst_element_quality_3<Triangulation>
{
  using CGAL::Boundary_recovery_3::Worst_element_quality_3<Triangulation>::Worst_element_quality_3;
  static constexpr bool is_first_in_vector = true;
};

// A covering mesh that only has fewer tetrahedra around the edge is not worth it: the worst one is to be better.
struct Improvement
  : public CGAL::Boundary_recovery_3::No_shell_validity_3
{
  typedef CGAL::Boundary_recovery_3::Partial_triangulation Partial_triangulation;

  explicit Improvement(const Quality& quality) : quality(quality) { }

  bool is_valid_covering_mesh(const Quality::Shell& s, const Partial_triangulation& k) const
  {
    double before = quality.best(), after = quality.best();
    for(int i = 0; i < s.degree(); ++i)
      before = quality.combine(before, quality.of_core_edge(s, i, s.next(i)));
    for(const auto& t : k.triangles)
      after = quality.combine(after, quality.of_triangle(s, t[0], t[1], t[2]));
    for(int c = 0; c < k.core_size(); ++c)
      after = quality.combine(after, quality.of_core_edge(s, k.core[c], k.core[(c + 1) % k.core_size()]));
    return before < after;
  }

  Quality quality;
};
//! [models]

typedef CGAL::Shell_transformation_3<Triangulation, Quality, Improvement> Shell_transformation;

struct Statistics
{
  double worst = 1;
  std::size_t number_of_bad_cells = 0;
  double volume = 0;
};

Statistics statistics(const Triangulation& tr)
{
  const Quality quality(tr);
  Statistics s;
  for(const Cell_handle c : tr.finite_cell_handles())
  {
    const double q = quality.of_tetrahedron(c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3));
    s.worst = (std::min)(s.worst, q);
    s.number_of_bad_cells += q < 0.2;
    s.volume += tr.tetrahedron(c).volume();
  }
  std::cout << tr.number_of_finite_cells() << " tetrahedra, " << s.number_of_bad_cells
            << " of a quality below 0.2, the worst of " << s.worst << std::endl;
  return s;
}

// Transforms the shell of each edge once. Edges that went with others are left out.
std::size_t improve(Triangulation& tr, Shell_transformation& transformation)
{
  std::vector<std::array<Vertex_handle, 2> > edges;
  for(const Edge& e : tr.finite_edges())
    edges.push_back({{ e.first->vertex(e.second), e.first->vertex(e.third) }});

  const std::size_t before = transformation.number_of_transformations();
  Edge e;
  for(const auto& v : edges)
    if(tr.is_edge(v[0], v[1], e.first, e.second, e.third))
      transformation(e);
  return transformation.number_of_transformations() - before;
}

int main()
{
  // A Delaunay triangulation of random points has many slivers.
  CGAL::Random random(17);
  std::vector<Kernel::Point_3> points;
  for(int i = 0; i < 1000; ++i)
  {
    const double x = random.get_double(), y = random.get_double();
    points.emplace_back(x, y, random.get_double());
  }

  // Flips destroy the Delaunay property, so the type is not to claim it.
  Triangulation tr = Delaunay_triangulation(points.begin(), points.end());
  const Statistics before = statistics(tr);
  const Quality quality(tr);
  Shell_transformation transformation(tr, quality, Improvement(quality));
  // This ends: tetrahedra are replaced only by ones that are all better than the worst of them.
  while(const std::size_t n = improve(tr, transformation))
    std::cout << n << " transformations" << std::endl;
  const Statistics after = statistics(tr);

  const bool is_better = after.worst > before.worst && after.number_of_bad_cells < before.number_of_bad_cells;
  const bool is_same_domain = tr.is_valid() && tr.number_of_vertices() == points.size()
                           && std::abs(after.volume - before.volume) < 1e-9;
  return is_better && is_same_domain ? EXIT_SUCCESS : EXIT_FAILURE;
}

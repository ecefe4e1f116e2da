// insert_field_points() on a triangulation that Mesh_3 made: points with weights, and indices that are variants.

#undef NDEBUG // the checks are assertions, also in a Release build

#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Triangulation_3.h>
#include <CGAL/insert_field_points.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/tetrahedral_remeshing.h>

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <set>

typedef CGAL::Exact_predicates_inexact_constructions_kernel        K;
typedef K::Point_3                                                 Point;
typedef CGAL::Labeled_mesh_domain_3<K>                             Domain;
typedef CGAL::Mesh_triangulation_3<Domain>::type                   Mesh_tr;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Mesh_tr>           Complex;
typedef CGAL::Mesh_criteria_3<Mesh_tr>                             Criteria;
typedef CGAL::Triangulation_3<Mesh_tr::Geom_traits, Mesh_tr::Triangulation_data_structure> Tr;
typedef Tr::Vertex_handle                                          Vertex_handle;

// A ball in a ball.
int region(const Point& p)
{
  const double d = p.x() * p.x() + p.y() * p.y() + p.z() * p.z();
  return d > 1 ? 0 : d > 0.3 ? 1 : 2;
}

std::set<std::set<Vertex_handle> > surface(const Tr& tr)
{
  std::set<std::set<Vertex_handle> > result;
  for(auto f = tr.finite_facets_begin(); f != tr.finite_facets_end(); ++f)
    if(f->first->is_facet_on_surface(f->second))
    {
      std::set<Vertex_handle> vertices;
      for(int i = 1; i < 4; ++i)
        vertices.insert(f->first->vertex((f->second + i) % 4));
      result.insert(vertices);
    }
  return result;
}

std::array<double, 3> volumes(const Tr& tr)
{
  std::array<double, 3> result = {{ 0, 0, 0 }};
  for(const Tr::Cell_handle c : tr.finite_cell_handles())
  {
    std::array<Point, 4> p;
    for(int i = 0; i < 4; ++i)
      p[i] = CGAL::Boundary_recovery_3::internal::bare_point<Point>(c->vertex(i)->point());
    assert(CGAL::orientation(p[0], p[1], p[2], p[3]) == CGAL::POSITIVE);
    result[c->subdomain_index()] += CGAL::volume(p[0], p[1], p[2], p[3]);
  }
  return result;
}

int main()
{
  namespace params = CGAL::parameters;
  const Domain domain(params::function = region, params::bounding_object = K::Sphere_3(CGAL::ORIGIN, 4.));
  const Criteria criteria(params::facet_angle = 25, params::facet_size = 0.4, params::facet_distance = 0.1);
  const Complex complex = CGAL::make_mesh_3<Complex>(domain, criteria, params::no_perturb(), params::no_exude());
  Tr tr = CGAL::convert_to_triangulation_3(complex);

  const auto surface_before = surface(tr);
  const auto volumes_before = volumes(tr);
  const std::size_t n = tr.number_of_vertices();
  const auto size = [](const Point&, const int dimension, const int region)
  {
    assert(dimension == 3);
    return region == 1 ? 0.25 : 0.2;
  };
  const auto result = CGAL::insert_field_points(tr, size);
  assert(result && result.number_of_field_points > 100);
  assert(tr.number_of_vertices() == n + result.number_of_field_points && tr.tds().is_valid());
  assert(! surface_before.empty() && surface(tr) == surface_before);
  const auto volumes_after = volumes(tr);
  for(int r = 0; r < 3; ++r)
    assert(std::abs(volumes_after[r] - volumes_before[r]) < 1e-12);
  return EXIT_SUCCESS;
}

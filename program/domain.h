#ifndef BOUNDARY_RECOVERY_3_PROGRAM_DOMAIN_H
#define BOUNDARY_RECOVERY_3_PROGRAM_DOMAIN_H

#include <CGAL/Boundary_recovery_3/write_domain_MEDIT.h>

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

using CGAL::Boundary_recovery_3::internal::Point_number;

// The tetrahedra of the domain as a soup, with what files tell of them.
template <typename Point>
struct Domain
  : public CGAL::Boundary_recovery_3::internal::Domain_soup_3<Point>
{
  std::vector<int> patches;                             // of each triangle, 0 if it is in none
  std::map<int, std::string> patch_names, region_names; // of those that have one
  int number_of_regions = 0;
  bool is_convex_hull = false; // no region can be told from the outside: all tetrahedra are here, as region 1

  // Of second order: the points in the middle of edges, which are numbered after the others, and those of each simplex,
  // in the order of VTK. Empty if the mesh is of first order.
  std::vector<Point> edge_points;
  std::vector<std::array<Point_number, 6> > edges_of_tetrahedra;
  std::vector<std::array<Point_number, 3> > edges_of_triangles;

  bool is_second_order() const { return ! edge_points.empty(); }
  std::size_t number_of_nodes() const { return this->points.size() + edge_points.size(); }

  const Point& node(const std::size_t i) const
  {
    return i < this->points.size() ? this->points[i] : edge_points[i - this->points.size()];
  }
};

// collects a domain from a triangulation after its boundary was recovered, by all threads, see `Domain_builder_3`
template <typename Tr, typename Result, typename Facets, typename Region>
Domain<typename Tr::Geom_traits::Point_3>
build_domain(const Tr& tr, const Result& result, const Facets& facets, const Region& region)
{
  namespace internal = CGAL::Boundary_recovery_3::internal;
  typedef typename Tr::Geom_traits::Point_3 Point;

  Domain<Point> domain;
  static_cast<internal::Domain_soup_3<Point>&>(domain) =
    internal::Domain_builder_3<Tr, internal::Concurrency_tag_of<Tr> >(tr)(result, facets, region);
  return domain;
}

// the regions of a triangulation, as its cells have them after it was meshed
template <typename Tr, typename Result>
Domain<typename Tr::Geom_traits::Point_3> make_meshed_domain(const Tr& tr, const Result& result)
{
  auto domain = build_domain(tr, result.recovery, result.recovery.surface_facets(),
                             [](const typename Tr::Cell_handle c)
                             { return c->subdomain_index() == 0 ? -1 : c->subdomain_index(); });
  domain.number_of_regions = result.number_of_regions;
  return domain;
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_DOMAIN_H

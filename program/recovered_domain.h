#ifndef BOUNDARY_RECOVERY_3_PROGRAM_RECOVERED_DOMAIN_H
#define BOUNDARY_RECOVERY_3_PROGRAM_RECOVERED_DOMAIN_H

#include "domain.h"

#include <CGAL/Boundary_recovery_3/label_regions.h>

#include <CGAL/Unique_hash_map.h>

#include <algorithm>
#include <utility>

// Where a facet is missing the outside may flow in, and what is left as regions are a few bubbles: then a facet
// beside the gap has the outside on both sides.
template <typename Tr, typename Facets, typename Region>
bool has_leak(const Tr& tr, const Facets& facets, const Region& region)
{
  const auto is_outside = [&](const typename Tr::Cell_handle c) { return tr.is_infinite(c) || region(c) == 0; };
  return std::any_of(facets.begin(), facets.end(), [&](const auto& facet)
  {
    typename Tr::Cell_handle c;
    int i, j, k;
    return tr.is_facet(facet[0], facet[1], facet[2], c, i, j, k) &&
           is_outside(c) && is_outside(c->neighbor(6 - i - j - k));
  });
}

// the domain after the boundary was recovered, or the convex hull where no region can be told from the outside
template <typename Tr, typename Result>
Domain<typename Tr::Point> make_recovered_domain(const Tr& tr, const Result& result, const bool keep_exterior)
{
  typedef typename Tr::Cell_handle                Cell_handle;
  typedef CGAL::Unique_hash_map<Cell_handle, int> Region_map;

  const auto facets = result.surface_facets();
  Region_map regions(0);
  int number_of_regions =
    CGAL::Boundary_recovery_3::label_regions(tr, facets, boost::associative_property_map<Region_map>(regions));
  const auto region_of = [&known = std::as_const(regions)](const Cell_handle c) { return known[c]; }; // by any thread
  if(! result.missing_facets.empty() && has_leak(tr, facets, region_of))
    number_of_regions = 0;

  auto domain = build_domain(tr, result, facets, [&](const Cell_handle c)
  {
    const int region = (number_of_regions == 0) ? 1 : region_of(c);
    return (region == 0 && ! keep_exterior) ? -1 : region;
  });
  domain.number_of_regions = number_of_regions;
  domain.is_convex_hull = number_of_regions == 0;
  return domain;
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_RECOVERED_DOMAIN_H

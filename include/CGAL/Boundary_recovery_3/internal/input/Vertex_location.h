// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_INPUT_VERTEX_LOCATION_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_INPUT_VERTEX_LOCATION_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/Triangulation_3.h>
#include <CGAL/enum.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

// Only a triangulation that is Delaunay by type and in fact can take new points by Delaunay insertion. Not asked by
// is_valid(), where an assertion fails if it is not.
template <typename GT, typename TDS, typename Lp, typename SLDS>
bool can_insert(const Delaunay_triangulation_3<GT, TDS, Lp, SLDS>& tr)
{
  if(tr.dimension() < 3)
    return true;
  for(const auto& f : tr.finite_facets()) // from one side, which tells the same as from the other
  {
    const auto v = tr.mirror_vertex(f.first, f.second);
    if(! tr.is_infinite(f.first) && ! tr.is_infinite(v) && tr.side_of_sphere(f.first, v->point()) == ON_BOUNDED_SIDE)
      return false;
  }
  return true;
}

template <typename GT, typename TDS, typename SLDS>
bool can_insert(const Triangulation_3<GT, TDS, SLDS>&) { return false; }

/*
 * Finds points among the vertices of a triangulation by their exact coordinates.
 *
 * By sorting and not by location walks, which are slow and may not end in a triangulation that is not Delaunay.
 */
template <typename Tr>
class Vertex_location
{
public:
  typedef typename Tr::Vertex_handle         Vertex_handle;
  typedef typename Tr::Geom_traits::Point_3  Point_3;

  explicit Vertex_location(const Tr& tr)
    : m_compare(tr.geom_traits().compare_xyz_3_object())
  {
    m_vertices.reserve(tr.number_of_vertices());
    for(const Vertex_handle v : tr.finite_vertex_handles())
      m_vertices.push_back(v);
    std::sort(m_vertices.begin(), m_vertices.end(),
              [&](const Vertex_handle v, const Vertex_handle w) { return is_less(v->point(), w->point()); });
  }

  // The vertex at p, or the default handle.
  Vertex_handle operator()(const Point_3& p) const
  {
    const auto it = std::lower_bound(m_vertices.begin(), m_vertices.end(), p,
                                     [&](const Vertex_handle v, const Point_3& q) { return is_less(v->point(), q); });
    return it != m_vertices.end() && ! is_less(p, (*it)->point()) ? *it : Vertex_handle();
  }

private:
  bool is_less(const Point_3& p, const Point_3& q) const { return m_compare(p, q) == SMALLER; }

  typename Tr::Geom_traits::Compare_xyz_3 m_compare;
  std::vector<Vertex_handle> m_vertices;
};

/*
 * Inserts the points whose vertex is the default handle, in spatial order, and stores their vertices.
 * Returns the number of new vertices.
 */
template <typename Tr, typename Context>
std::size_t insert_points(Tr& tr, const std::vector<typename Tr::Geom_traits::Point_3>& points,
                          std::vector<typename Tr::Vertex_handle>& vertices, Context& context)
{
  typedef typename Tr::Geom_traits::Point_3 Point_3;
  typedef typename Pointer_property_map<Point_3>::const_type Point_map;
  typedef Spatial_sort_traits_adapter_3<typename Tr::Geom_traits, Point_map> Sort_traits;
  static constexpr std::size_t batch = 1024;      // points between two questions whether to go further
  static constexpr std::size_t work_per_cell = 4; // in the units of Recursive_recovery_3

  std::vector<std::size_t> order;
  for(std::size_t i = 0; i < points.size(); ++i)
    if(vertices[i] == typename Tr::Vertex_handle())
      order.push_back(i);
  CGAL::spatial_sort(order.begin(), order.end(), Sort_traits(make_property_map(points), tr.geom_traits()));

  const std::size_t before = tr.number_of_vertices();
  typename Tr::Cell_handle hint;
  for(std::size_t k = 0, number_of_cells = 0; k < order.size(); ++k)
  {
    if(k % batch == 0)
    {
      const std::size_t n = tr.tds().number_of_cells(); // there may be very many of them where lines of points cross
      context.add_work(work_per_cell * (n - (std::min)(n, number_of_cells)));
      number_of_cells = (std::max)(n, number_of_cells);
      if(! context.go_further())
        break;
    }
    vertices[order[k]] = tr.insert(points[order[k]], hint);
    hint = vertices[order[k]]->cell();
  }
  return tr.number_of_vertices() - before;
}

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_INPUT_VERTEX_LOCATION_H

#ifndef BOUNDARY_RECOVERY_3_PROGRAM_TRIANGULATE_FACET_H
#define BOUNDARY_RECOVERY_3_PROGRAM_TRIANGULATE_FACET_H

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Projection_traits_3.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

// Divides a facet into triangles, by CGAL's constrained Delaunay triangulation in the plane of the facet. Its edges are
// given as polygons; those of two points are edges inside.
template <typename Point>
class Facet_triangulation
{
  typedef typename CGAL::Kernel_traits<Point>::Kernel                                   Kernel;
  typedef typename Kernel::Vector_3                                                     Vector;
  typedef CGAL::Projection_traits_3<Kernel>                                             Traits;
  typedef CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Traits>              Vertex_base;
  typedef CGAL::Triangulation_face_base_with_info_2<bool, Traits,
            CGAL::Constrained_triangulation_face_base_2<Traits> >                       Face_base;
  typedef CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>                  Tds;
  typedef CGAL::Constrained_Delaunay_triangulation_2<Traits, Tds, CGAL::No_constraint_intersection_tag>
                                                                                        Triangulation;
  typedef typename Triangulation::Face_handle                                           Face_handle;

public:
  typedef std::vector<std::size_t>   Polygon;
  typedef std::array<std::size_t, 3> Triangle;

  Facet_triangulation(const std::vector<Point>& points, const std::vector<Polygon>& polygons)
    : m_points(points), m_polygons(polygons),
      m_largest(*std::max_element(polygons.begin(), polygons.end(),
                                  [](const Polygon& p, const Polygon& q) { return p.size() < q.size(); })),
      m_normal(normal(points, m_largest))
  { }

  // whether all points are as close to the plane of the largest polygon
  bool is_flat(const double tolerance) const
  {
    const double length = std::sqrt(m_normal.squared_length());
    Vector sum = CGAL::NULL_VECTOR;
    for(const std::size_t v : m_largest)
      sum = sum + (m_points[v] - CGAL::ORIGIN);
    const Point center = CGAL::ORIGIN + sum / double(m_largest.size());
    return std::all_of(m_polygons.begin(), m_polygons.end(), [&](const Polygon& polygon)
    {
      return std::all_of(polygon.begin(), polygon.end(), [&](const std::size_t v)
                         { return std::abs((m_points[v] - center) * m_normal) <= tolerance * length; });
    });
  }

  // The triangles, turned as the largest polygon is, between the edges and outside of the holes. None if edges cross,
  // if points fall together, or if there is no area.
  std::vector<Triangle> operator()(const std::vector<Point>& holes = { }) const
  {
    if(m_normal == CGAL::NULL_VECTOR)
      return { };
    Triangulation triangulation{Traits(m_normal)};
    try
    {
      if(! insert_edges(triangulation))
        return { };
    }
    catch(const typename Triangulation::Intersection_of_constraints_exception&)
    {
      return { };
    }
    for(const Face_handle f : triangulation.all_face_handles())
      f->info() = true;
    flood(triangulation.infinite_face());
    for(const Point& hole : holes)
      flood(triangulation.locate(hole));
    std::vector<Triangle> triangles;
    for(const Face_handle f : triangulation.finite_face_handles())
      if(f->info())
        triangles.push_back(turned({{ f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info() }}));
    return triangles;
  }

private:
  // of Newell, as long as the double area
  static Vector normal(const std::vector<Point>& points, const Polygon& polygon)
  {
    Vector sum = CGAL::NULL_VECTOR;
    for(std::size_t i = 0; i < polygon.size(); ++i)
      sum = sum + CGAL::cross_product(points[polygon[i]] - points[polygon[0]],
                                      points[polygon[(i + 1) % polygon.size()]] - points[polygon[0]]);
    return sum;
  }

  bool insert_edges(Triangulation& triangulation) const
  {
    for(const Polygon& polygon : m_polygons)
    {
      std::vector<typename Triangulation::Vertex_handle> vertices;
      for(const std::size_t v : polygon)
      {
        const std::size_t before = triangulation.number_of_vertices();
        vertices.push_back(triangulation.insert(m_points[v]));
        if(triangulation.number_of_vertices() > before)
          vertices.back()->info() = v;
        else if(vertices.back()->info() != v)
          return false;
      }
      for(std::size_t i = 0; i < vertices.size(); ++i)
        if(vertices[i] != vertices[(i + 1) % vertices.size()])
          triangulation.insert_constraint(vertices[i], vertices[(i + 1) % vertices.size()]);
    }
    return triangulation.dimension() == 2;
  }

  // takes away what is connected with a face
  static void flood(const Face_handle start)
  {
    std::vector<Face_handle> stack(1, start);
    while(! stack.empty())
    {
      const Face_handle f = stack.back();
      stack.pop_back();
      if(! f->info())
        continue;
      f->info() = false;
      for(int i = 0; i < 3; ++i)
        if(! f->is_constrained(i))
          stack.push_back(f->neighbor(i));
    }
  }

  Triangle turned(Triangle t) const
  {
    if(normal(m_points, Polygon(t.begin(), t.end())) * m_normal < 0)
      std::swap(t[1], t[2]);
    return t;
  }

  const std::vector<Point>& m_points;
  const std::vector<Polygon>& m_polygons;
  const Polygon& m_largest;
  const Vector m_normal;
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_TRIANGULATE_FACET_H

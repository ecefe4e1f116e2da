#ifndef BOUNDARY_RECOVERY_3_PROGRAM_BAD_TETRAHEDRA_H
#define BOUNDARY_RECOVERY_3_PROGRAM_BAD_TETRAHEDRA_H

#include "domain.h"

#include <CGAL/Boundary_recovery_3/Quality_improvement_result_3.h>
#include <CGAL/Unique_hash_map.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <vector>

// A tetrahedron below the target angle, in the numbers of the mesh that is written, from 0.
struct Bad_tetrahedron
{
  // a constrained facet, and the triangle of the input that it is, or is a part of
  struct Facet
  {
    static constexpr std::size_t no_triangle = static_cast<std::size_t>(-1);

    std::array<Point_number, 3> points;
    std::size_t triangle = no_triangle; // its position in the file
  };

  std::size_t tetrahedron;
  double min_dihedral_angle;
  std::array<Point_number, 2> edge; // where this angle is
  CGAL::Boundary_recovery_3::Bad_cell_reason reason;
  std::vector<Facet> facets;
  double surface_angle;
  double distance; // of a gap
};

// Tells the bad cells of a triangulation, and what makes them so, in the numbers of the domain that was made of it.
// Only these cells are numbered, and those of the facets that are named.
template <typename Tr>
class Bad_tetrahedra_list
{
  typedef typename Tr::Cell_handle                       Cell_handle;
  typedef typename Tr::Vertex_handle                     Vertex_handle;
  typedef CGAL::Boundary_recovery_3::Bad_cell_3<Tr>      Bad_cell;
  typedef Domain<typename Tr::Point>                     Mesh;

  const Mesh& m_domain;
  const std::vector<Bad_cell>& m_cells;
  CGAL::Unique_hash_map<Cell_handle, std::size_t>        m_number; // of the tetrahedra, for looking up only
  std::map<std::array<Point_number, 3>, std::size_t>     m_triangles;

public:
  // The triangles of the domain have the numbers of the file already.
  Bad_tetrahedra_list(const Tr& tr, const Mesh& domain, const std::vector<Bad_cell>& cells)
    : m_domain(domain), m_cells(cells), m_number(0, cells.size())
  {
    if(cells.empty())
      return;
    for(const Bad_cell& cell : cells)
    {
      m_number[cell.cell] = 0;
      for(int i = 0; i < cell.number_of_facets(); ++i)
        m_number[cell.facets[i].first] = 0;
    }
    number_cells(tr);
    for(std::size_t i = 0; i < domain.triangles.size(); ++i)
      m_triangles.emplace(sorted(domain.triangles[i]), domain.triangle_numbers[i]);
  }

  std::vector<Bad_tetrahedron> operator()() const
  {
    std::vector<Bad_tetrahedron> result;
    for(const Bad_cell& cell : m_cells)
    {
      Bad_tetrahedron bad;
      bad.tetrahedron = m_number[cell.cell];
      bad.min_dihedral_angle = cell.min_dihedral_angle;
      bad.edge = {{ point_number(cell.cell, cell.edge[0]), point_number(cell.cell, cell.edge[1]) }};
      bad.reason = cell.reason;
      for(int i = 0; i < cell.number_of_facets(); ++i)
        bad.facets.push_back(facet(cell.facets[i].first, cell.facets[i].second));
      bad.surface_angle = cell.surface_angle;
      bad.distance = cell.distance;
      result.push_back(bad);
    }
    return result;
  }

private:
  void number_cells(const Tr& tr)
  {
    std::size_t n = 0;
    for(const Cell_handle c : tr.finite_cell_handles())
      if(c->subdomain_index() != 0)
      {
        if(m_number.is_defined(c))
          m_number[c] = n;
        ++n;
      }
  }

  static std::array<Point_number, 3> sorted(std::array<Point_number, 3> points)
  {
    std::sort(points.begin(), points.end());
    return points;
  }

  // Tetrahedra have their vertices in the order of the cells.
  Point_number point_number(const Cell_handle c, const Vertex_handle v) const
  {
    return m_domain.tetrahedra[m_number[c]][static_cast<std::size_t>(c->index(v))];
  }

  Bad_tetrahedron::Facet facet(const Cell_handle c, const int i) const
  {
    const auto& t = m_domain.tetrahedra[m_number[c]];
    Bad_tetrahedron::Facet facet;
    facet.points = {{ t[static_cast<std::size_t>((i + 1) % 4)], t[static_cast<std::size_t>((i + 2) % 4)],
                      t[static_cast<std::size_t>((i + 3) % 4)] }};
    const auto known = m_triangles.find(sorted(facet.points));
    if(known != m_triangles.end())
      facet.triangle = known->second;
    return facet;
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_BAD_TETRAHEDRA_H

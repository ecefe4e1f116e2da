#ifndef BOUNDARY_RECOVERY_3_PYTHON_ARRAY_TRIANGULATION_H
#define BOUNDARY_RECOVERY_3_PYTHON_ARRAY_TRIANGULATION_H

#include "module_types.h"

#include <CGAL/Boundary_recovery_3/internal/parallel/Part_triangulation_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace boundary_recovery {

// Makes a triangulation of arrays of tetrahedra, whose union need not be convex: what is outside consists of infinite
// cells at the facets of the boundary. That is enough for whoever changes nothing but cells inside of walls.
//
// Where several parts of the mesh meet in an edge or a vertex of the boundary only, the infinite cells are those of
// each part on its own. So cells around such an edge, as circulators find them, are those of one part.
class Array_triangulation
{
  typedef std::pair<Cell_handle, int> Facet;
  typedef std::array<std::size_t, 3>  Triple;

  struct Hash
  {
    std::size_t operator()(const Triple& t) const
    {
      return (t[0] * 0x9E3779B97F4A7C15u ^ t[1]) * 0xC2B2AE3D27D4EB4Fu ^ t[2];
    }
  };

  Triangulation& m_tr;
  std::vector<Vertex_handle> m_vertices; // of the points; a null handle if no tetrahedron has it
  std::vector<std::array<std::size_t, 4> > m_cells; // positively oriented
  std::vector<Cell_handle> m_handles;
  std::unordered_map<Triple, Facet, Hash> m_open; // facets of which one side is known, by the numbers of their points

public:
  explicit Array_triangulation(Triangulation& tr) : m_tr(tr) { }

  const std::vector<Vertex_handle>& vertices() const { return m_vertices; }

  // Throws if the tetrahedra are no mesh.
  void build(const Points& points, const Tetrahedra& tetrahedra, const std::int64_t* const regions)
  {
    m_tr.tds().clear();
    m_tr.tds().set_dimension(3);
    m_tr.set_infinite_vertex(m_tr.tds().create_vertex());
    add_vertices(points, tetrahedra);
    for(std::size_t t = 0; t < m_cells.size(); ++t)
      add_cell(t, regions == nullptr ? 1 : regions[t]);
    BR3::internal::create_infinite_cells(m_tr, m_handles);
    m_open.clear();
  }

  // The facet of the mesh with these points is constrained.
  void constrain(const Triple& facet)
  {
    const Vertex_handle u = vertex(facet[0]), v = vertex(facet[1]), w = vertex(facet[2]);
    Cell_handle c;
    int i, j, k;
    if(! m_tr.tds().is_facet(u, v, w, c, i, j, k))
      throw std::invalid_argument("facets: no tetrahedron has the triangle " + std::to_string(facet[0]) + " " +
                                  std::to_string(facet[1]) + " " + std::to_string(facet[2]));
    const int l = 6 - i - j - k;
    c->set_surface_patch_index(l, 1);
    c->neighbor(l)->set_surface_patch_index(c->neighbor(l)->index(c), 1);
  }

  Vertex_handle vertex(const std::size_t number) const
  {
    if(number >= m_vertices.size() || m_vertices[number] == Vertex_handle())
      throw std::invalid_argument("no tetrahedron has the point " + std::to_string(number));
    return m_vertices[number];
  }

private:
  void add_vertices(const Points& points, const Tetrahedra& tetrahedra)
  {
    m_vertices.resize(points.size());
    m_cells.reserve(tetrahedra.size());
    for(std::size_t t = 0; t < tetrahedra.size(); ++t)
    {
      auto cell = tetrahedra[t];
      for(const std::size_t v : cell)
        if(v >= points.size())
          throw std::invalid_argument(name_of(t) + " names a point that does not exist");
      const auto sign = CGAL::orientation(points[cell[0]], points[cell[1]], points[cell[2]], points[cell[3]]);
      if(sign == CGAL::COPLANAR)
        throw std::invalid_argument(name_of(t) + " is flat");
      if(sign == CGAL::NEGATIVE)
        std::swap(cell[2], cell[3]);
      m_cells.push_back(cell);
    }
    for(const auto& cell : m_cells)
      for(const std::size_t v : cell)
        if(m_vertices[v] == Vertex_handle())
        {
          m_vertices[v] = m_tr.tds().create_vertex();
          m_vertices[v]->set_point(points[v]);
          m_vertices[v]->set_dimension(3);
        }
  }

  static std::string name_of(const std::size_t t) { return "tetrahedra[" + std::to_string(t) + "]"; }

  void add_cell(const std::size_t t, const std::int64_t region)
  {
    if(region < 1 || region > 2147483647)
      throw std::invalid_argument("regions[" + std::to_string(t) + "] is not positive");
    const auto& v = m_cells[t];
    const Cell_handle c = m_tr.tds().create_cell(m_vertices[v[0]], m_vertices[v[1]], m_vertices[v[2]],
                                                 m_vertices[v[3]]);
    c->set_subdomain_index(static_cast<int>(region));
    m_handles.push_back(c);
    for(int i = 0; i < 4; ++i)
    {
      c->vertex(i)->set_cell(c);
      add_side(t, c, i);
    }
  }

  // Two positively oriented cells at a facet are on different sides of it iff they see it differently oriented.
  void add_side(const std::size_t t, const Cell_handle c, const int i)
  {
    const auto& v = m_cells[t];
    Triple key = {{ v[(i + 1) & 3], v[(i + 2) & 3], v[(i + 3) & 3] }};
    std::sort(key.begin(), key.end());
    const auto inserted = m_open.emplace(key, Facet(c, i));
    if(inserted.second)
      return;
    const Facet other = inserted.first->second;
    if(other.first == Cell_handle() || is_even(c, i) == is_even(other.first, other.second))
      throw std::invalid_argument(name_of(t) + " overlaps another tetrahedron that has a facet in common with it");
    m_tr.tds().set_adjacency(c, i, other.first, other.second);
    inserted.first->second.first = Cell_handle(); // both sides are known
  }

  // whether the points of a facet, in the order of their addresses in the triangulation, turn to the cell
  bool is_even(const Cell_handle c, const int i) const
  {
    std::array<Vertex_handle, 3> v;
    for(int j = 0; j < 3; ++j)
      v[std::size_t(j)] = c->vertex(m_tr.vertex_triple_index(i, j));
    return (v[0] < v[1]) ^ (v[1] < v[2]) ^ (v[0] < v[2]);
  }
};

} // namespace boundary_recovery

#endif // BOUNDARY_RECOVERY_3_PYTHON_ARRAY_TRIANGULATION_H

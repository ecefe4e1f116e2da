#ifndef BOUNDARY_RECOVERY_3_PYTHON_MESH_COLLECTION_H
#define BOUNDARY_RECOVERY_3_PYTHON_MESH_COLLECTION_H

#include "module_types.h"

#include <CGAL/Boundary_recovery_3/Quality_improvement_result_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace boundary_recovery {

// Collects the arrays of a mesh from a triangulation that nobody needs afterwards: the numbers of points are written
// over the indices of vertices.
class Mesh_collection
{
  static constexpr int is_unused = -1, is_used = -2;

  Triangulation& m_tr;
  const bool m_is_outside_wanted;
  std::vector<Vertex_handle> m_vertices; // in the order of their numbers; a null handle is a point that is no vertex's
  std::map<Cell_handle, std::int64_t> m_tetrahedra; // of bad cells, for looking up only

public:
  Mesh_collection(Triangulation& tr, const bool is_outside_wanted) : m_tr(tr), m_is_outside_wanted(is_outside_wanted)
  {
    if(tr.number_of_vertices() >= std::size_t((std::numeric_limits<int>::max)()))
      throw std::length_error("the mesh has too many vertices");
    for(const Vertex_handle v : tr.finite_vertex_handles())
      v->set_index(is_unused);
  }

  std::size_t number_of_points() const { return m_vertices.size(); }
  Vertex_handle vertex(const std::size_t i) const { return m_vertices[i]; }

  // The first points, used or not, in their order: of equal ones, the first one is that of the vertex.
  void add_all(const std::vector<Vertex_handle>& vertices)
  {
    m_vertices.reserve(m_tr.number_of_vertices());
    for(const Vertex_handle v : vertices)
      add(v);
  }

  // Those of these that cells or facets have, then all others that they have, by regions.
  template <typename Vertices, typename Facets>
  std::size_t add_used(const Vertices& vertices, const Facets& facets)
  {
    mark_used(facets);
    const std::size_t before = m_vertices.size();
    for(const Vertex_handle v : vertices)
      if(v->index() == is_used)
        add(v);
    const std::size_t number = m_vertices.size() - before;
    std::vector<Vertex_handle> others;
    for(const Vertex_handle v : m_tr.finite_vertex_handles())
      if(v->index() == is_used)
        others.push_back(v);
    std::stable_sort(others.begin(), others.end(), [](const Vertex_handle u, const Vertex_handle v)
                     { return u->cell()->subdomain_index() < v->cell()->subdomain_index(); });
    for(const Vertex_handle v : others)
      add(v);
    return number;
  }

  void collect_cells(const std::vector<Cell_handle>& bad_cells, Mesh& mesh)
  {
    for(const Cell_handle c : bad_cells)
      m_tetrahedra[c] = -1;
    std::size_t number = 0;
    for(const Cell_handle c : m_tr.finite_cell_handles())
      number += is_wanted(c);
    mesh.tetrahedra = Rows<std::int64_t>(number, 4);
    mesh.regions = Rows<std::int32_t>(number, 1);
    std::size_t t = 0;
    for(const Cell_handle c : m_tr.finite_cell_handles())
      if(is_wanted(c))
      {
        for(int i = 0; i < 4; ++i)
          mesh.tetrahedra[t][i] = c->vertex(i)->index();
        mesh.regions[t][0] = c->subdomain_index();
        remember(c, t++);
      }
  }

  // `original` has the points of the caller, which are the first ones.
  void collect_points(const Point_rows& original, Mesh& mesh) const
  {
    mesh.points = Rows<double>(m_vertices.size(), 3);
    const Point_row row{ original };
    for(std::size_t i = 0; i < m_vertices.size(); ++i)
      set_point(mesh.points, i, i < original.size ? row(i) : m_vertices[i]->point());
  }

  template <typename Facets>
  void collect_facets(const Facets& facets, Mesh& mesh) const
  {
    mesh.triangles = Rows<std::int64_t>(facets.size(), 3);
    mesh.triangle_numbers = Rows<std::int64_t>(facets.size(), 1);
    for(std::size_t i = 0; i < facets.size(); ++i)
    {
      for(std::size_t j = 0; j < 3; ++j)
        mesh.triangles[i][j] = facets[i][j]->index();
      mesh.triangle_numbers[i][0] = static_cast<std::int64_t>(facets[i].index);
    }
  }

  // after the cells, and the facets
  template <typename Certificate>
  void collect_bad_cells(const Certificate& certificate, Mesh& mesh) const
  {
    std::map<std::array<std::int64_t, 3>, std::int64_t> numbers; // of the triangles that are named
    for(const auto& bad : certificate.cells)
    {
      Bad_cell result;
      result.tetrahedron = m_tetrahedra.at(bad.cell);
      result.angle = bad.min_dihedral_angle;
      result.surface_angle = bad.surface_angle;
      result.distance = bad.distance;
      result.edge = {{ bad.edge[0]->index(), bad.edge[1]->index() }};
      result.reason = to_string(bad.reason);
      for(int i = 0; i < bad.number_of_facets(); ++i)
      {
        result.facets.push_back(facet(bad.facets[i].first, bad.facets[i].second));
        numbers.emplace(sorted(result.facets.back()), -1);
      }
      mesh.bad_cells.push_back(result);
    }
    for(std::size_t i = 0; ! numbers.empty() && i < mesh.triangles.size; ++i)
    {
      const std::int64_t* const t = mesh.triangles[i];
      const auto found = numbers.find(sorted({{ t[0], t[1], t[2] }}));
      if(found != numbers.end())
        found->second = mesh.triangle_numbers[i][0];
    }
    for(Bad_cell& bad : mesh.bad_cells)
      for(const auto& f : bad.facets)
        bad.triangles.push_back(numbers[sorted(f)]);
  }

private:
  bool is_wanted(const Cell_handle c) const { return m_is_outside_wanted || c->subdomain_index() != 0; }

  void add(const Vertex_handle v)
  {
    if(v != Vertex_handle() && v->index() < 0)
      v->set_index(static_cast<int>(m_vertices.size()));
    m_vertices.push_back(v);
  }

  template <typename Facets>
  void mark_used(const Facets& facets)
  {
    const auto mark = [](const Vertex_handle v)
    {
      if(v->index() == is_unused)
        v->set_index(is_used);
    };
    for(const auto& facet : facets)
      for(const Vertex_handle v : facet)
        mark(v);
    for(const Cell_handle c : m_tr.finite_cell_handles())
      if(is_wanted(c))
        for(int i = 0; i < 4; ++i)
          mark(c->vertex(i));
  }

  void remember(const Cell_handle c, const std::size_t t)
  {
    if(m_tetrahedra.empty())
      return;
    const auto found = m_tetrahedra.find(c);
    if(found != m_tetrahedra.end())
      found->second = static_cast<std::int64_t>(t);
  }

  static std::array<std::int64_t, 3> facet(const Cell_handle c, const int i)
  {
    return {{ c->vertex((i + 1) % 4)->index(), c->vertex((i + 2) % 4)->index(), c->vertex((i + 3) % 4)->index() }};
  }

  static std::array<std::int64_t, 3> sorted(std::array<std::int64_t, 3> numbers)
  {
    std::sort(numbers.begin(), numbers.end());
    return numbers;
  }
};

template <typename Certificate>
std::vector<Cell_handle> cells_of(const Certificate& certificate)
{
  std::vector<Cell_handle> cells;
  for(const auto& bad : certificate.cells)
    cells.push_back(bad.cell);
  return cells;
}

template <typename Improvement>
Record improvement_record(const Improvement& improvement)
{
  Record record;
  record.add("status", to_string(improvement.status));
  record.add("seconds", improvement.seconds);
  record.add("before", plain_quality(improvement.before));
  record.add("after", plain_quality(improvement.after));
  record.add("is_measured", improvement.is_measured);
  record.add("number_of_rounds", improvement.counts.number_of_rounds);
  record.add("number_of_removed_edges", improvement.counts.number_of_removed_edges);
  record.add("number_of_removed_facets", improvement.counts.number_of_removed_facets);
  record.add("number_of_moved_vertices", improvement.counts.number_of_moved_vertices);
  record.add("number_of_inserted_points", improvement.counts.number_of_inserted_points);
  record.add("number_of_removed_vertices", improvement.counts.number_of_removed_vertices);
  return record;
}

} // namespace boundary_recovery

#endif // BOUNDARY_RECOVERY_3_PYTHON_MESH_COLLECTION_H

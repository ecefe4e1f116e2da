#include "array_triangulation.h"
#include "mesh_collection.h"

#include <CGAL/Boundary_recovery_3/Constrained_edge_map_3.h>
#include <CGAL/improve_mesh_quality.h>

#include <functional>

namespace boundary_recovery {

typedef std::array<Vertex_handle, 2> Vertex_pair;

namespace {

bool is_wall(const Cell_handle c, const int i)
{
  return c->is_facet_on_surface(i) || c->neighbor(i)->subdomain_index() != c->subdomain_index();
}

// The vertices that stay where they are, and stay vertices, are marked by the dimension 2.
void mark_walls(const Triangulation& tr, const std::vector<Vertex_pair>& edges)
{
  for(const Vertex_pair& e : edges)
    for(const Vertex_handle v : e)
      v->set_dimension(2);
  for(const Cell_handle c : tr.finite_cell_handles())
    for(int i = 0; i < 4; ++i)
      if(is_wall(c, i))
        for(int j = 1; j < 4; ++j)
          c->vertex((i + j) & 3)->set_dimension(2);
}

// A facet of the caller, or one between two regions.
struct Wall
  : public std::array<Vertex_handle, 3>
{
  std::size_t index;
};

} // namespace

Mesh improve(const Point_rows& points, const Index_rows& tetrahedra, const std::int64_t* const regions,
             const Index_rows& facets, const Index_rows& edges, const Options& options, Watch& watch)
{
  namespace params = CGAL::parameters;
  Triangulation tr;
  Array_triangulation builder(tr);
  builder.build(as_points(points), as_rows<4>(tetrahedra), regions);
  std::vector<Wall> walls;
  for(const auto& f : as_rows<3>(facets))
  {
    builder.constrain(f);
    walls.push_back({ {{ builder.vertex(f[0]), builder.vertex(f[1]), builder.vertex(f[2]) }}, walls.size() });
  }
  std::vector<Vertex_pair> constrained_edges;
  for(const auto& e : as_rows<2>(edges))
    constrained_edges.push_back({{ builder.vertex(e[0]), builder.vertex(e[1]) }});
  mark_walls(tr, constrained_edges);
  std::vector<std::pair<std::size_t, Vertex_handle> > kept;
  for(std::size_t i = 0; i < points.size; ++i)
    if(builder.vertices()[i] != Vertex_handle() && builder.vertices()[i]->in_dimension() == 2)
      kept.emplace_back(i, builder.vertices()[i]);

  Visitor visitor(watch);
  const auto result = CGAL::improve_mesh_quality(
    tr, params::visitor(std::ref(visitor)).maximum_running_time(options.time_limit)
          .edge_is_constrained_map(BR3::Constrained_edge_map_3<Triangulation>(constrained_edges)),
    params::min_dihedral_angle(options.min_angle), params::improvement_effort(effort_of(options)));

  Mesh mesh;
  mesh.status = to_string(result.status);
  mesh.report = improvement_record(result);
  Mesh_collection collection(tr, false);
  std::vector<Vertex_handle> vertices;
  for(const auto& v : kept)
    vertices.push_back(v.second);
  collection.add_all(vertices);
  collection.add_used(std::vector<Vertex_handle>(), walls);
  collection.collect_points(Point_rows(), mesh);
  collection.collect_cells(cells_of(result.certificate), mesh);
  collection.collect_facets(walls, mesh);
  collection.collect_bad_cells(result.certificate, mesh);
  mesh.point_numbers = Rows<std::int64_t>(mesh.points.size, 1);
  for(std::size_t i = 0; i < mesh.points.size; ++i)
    mesh.point_numbers[i][0] = i < kept.size() ? static_cast<std::int64_t>(kept[i].first) : -1;
  return mesh;
}

} // namespace boundary_recovery

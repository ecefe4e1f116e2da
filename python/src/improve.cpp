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

// A facet of the caller.
struct Wall
  : public std::array<Vertex_handle, 3>
{
  std::size_t index;
};

// A mesh of the caller as a triangulation, and what has to stay in it.
struct Input
{
  Triangulation tr;
  std::vector<Wall> walls;
  std::vector<Vertex_pair> edges;
  std::vector<std::size_t> kept_numbers;     // of the points that stay
  std::vector<Vertex_handle> kept_vertices;  // and their vertices

  Input(const Point_rows& points, const Index_rows& tetrahedra, const std::int64_t* const regions,
        const Index_rows& facets, const Index_rows& edge_rows)
  {
    Array_triangulation builder(tr);
    builder.build(as_points(points), as_rows<4>(tetrahedra), regions);
    for(const auto& f : as_rows<3>(facets))
    {
      builder.constrain(f);
      walls.push_back({ {{ builder.vertex(f[0]), builder.vertex(f[1]), builder.vertex(f[2]) }}, walls.size() });
    }
    for(const auto& e : as_rows<2>(edge_rows))
      edges.push_back({{ builder.vertex(e[0]), builder.vertex(e[1]) }});
    mark_walls(tr, edges);
    for(std::size_t i = 0; i < points.size; ++i)
    {
      const Vertex_handle v = builder.vertices()[i];
      if(v == Vertex_handle() || v->in_dimension() != 2)
        continue;
      kept_numbers.push_back(i);
      kept_vertices.push_back(v);
    }
  }
};

template <typename Certificate>
void collect_mesh(Input& input, const Certificate& certificate, Mesh& mesh)
{
  Mesh_collection collection(input.tr, false);
  collection.add_all(input.kept_vertices);
  collection.add_used(std::vector<Vertex_handle>(), input.walls);
  collection.collect_points(Point_rows(), mesh);
  collection.collect_cells(cells_of(certificate), mesh);
  collection.collect_facets(input.walls, mesh);
  collection.collect_bad_cells(certificate, mesh);
  mesh.point_numbers = Rows<std::int64_t>(mesh.points.size, 1);
  for(std::size_t i = 0; i < mesh.points.size; ++i)
    mesh.point_numbers[i][0] = i < input.kept_numbers.size() ? static_cast<std::int64_t>(input.kept_numbers[i]) : -1;
}

} // namespace

Mesh improve(const Point_rows& points, const Index_rows& tetrahedra, const std::int64_t* const regions,
             const Index_rows& facets, const Index_rows& edges, const Options& options, Watch& watch)
{
  namespace params = CGAL::parameters;
  Input input(points, tetrahedra, regions, facets, edges);
  Visitor visitor(watch);
  const auto result = CGAL::improve_mesh_quality(
    input.tr, params::visitor(std::ref(visitor)).maximum_running_time(options.time_limit)
                .edge_is_constrained_map(BR3::Constrained_edge_map_3<Triangulation>(input.edges)),
    params::min_dihedral_angle(options.min_angle), params::improvement_effort(effort_of(options)));
  Mesh mesh;
  mesh.status = to_string(result.status);
  mesh.report = improvement_record(result);
  collect_mesh(input, result.certificate, mesh);
  return mesh;
}

} // namespace boundary_recovery

// What is around some cells and inside of them, and whether they can be starred, by definition.

#ifndef BR3_TEST_CAVITY_SURROUNDINGS_H
#define BR3_TEST_CAVITY_SURROUNDINGS_H

#include <CGAL/Boundary_recovery_3/internal/operations/star_cavity.h>

#include <algorithm>
#include <cstddef>
#include <set>

namespace br3_test {

template <typename Mesh>
struct Surroundings
{
  typedef typename Mesh::Vertex_handle  Vertex_handle;
  typedef typename Mesh::Cell_handle    Cell_handle;
  typedef typename Mesh::Simplex        Simplex;
  typedef typename Mesh::Tetrahedron    Tetrahedron;
  typedef CGAL::Boundary_recovery_3::internal::Star_obstacle  Star_obstacle;

  Surroundings(const Mesh& mesh, const typename Mesh::Cells& cells, const Vertex_handle v)
    : mesh(mesh), cells(cells), apex(v)
  {
    for(const Cell_handle c : cells)
      for(int i = 0; i < 4; ++i)
      {
        const Vertex_handle w = c->vertex(i);
        if(std::count(inner_vertices.begin(), inner_vertices.end(), w) == 0)
          inner_vertices.push_back(w);
        if(std::count(cells.begin(), cells.end(), c->neighbor(i)) > 0)
          continue;
        Tetrahedron t = Mesh::tetrahedron(c);
        t[static_cast<std::size_t>(i)] = v;
        star.push_back(t);
        Simplex face = Mesh::vertices_of(c);
        face.erase(w);
        outer_faces.insert(face);
      }
    for(const Simplex& f : outer_faces)
      for(const Vertex_handle w : f)
        inner_vertices.erase(std::remove(inner_vertices.begin(), inner_vertices.end(), w), inner_vertices.end());
  }

  // The first one that applies.
  Star_obstacle obstacle_to_star(const typename Mesh::Vertices& droppable) const
  {
    if(! mesh.are_positive(star))
      return Star_obstacle::HIDDEN_FACE;
    for(const Simplex& s : mesh.constraints.simplices)
      if(is_inside(s))
        return Star_obstacle::CONSTRAINT_INSIDE;
    for(const Vertex_handle w : inner_vertices)
      if(w != apex && std::count(droppable.begin(), droppable.end(), w) == 0)
        return Star_obstacle::VERTEX_LOST;
    return Star_obstacle::NONE;
  }

  // Whether it is a face of a cell, but of no outer face.
  bool is_inside(const Simplex& s) const
  {
    return std::any_of(cells.begin(), cells.end(),
                       [&](const Cell_handle c) { return Mesh::is_face(s, Mesh::vertices_of(c)); })
        && std::none_of(outer_faces.begin(), outer_faces.end(), [&](const Simplex& f) { return Mesh::is_face(s, f); });
  }

  const Mesh& mesh;
  const typename Mesh::Cells cells;
  const Vertex_handle apex;
  std::set<Simplex> outer_faces;
  typename Mesh::Tetrahedra star; // from the apex to these
  typename Mesh::Vertices inner_vertices; // in the order of the cells
};

} // namespace br3_test

#endif // BR3_TEST_CAVITY_SURROUNDINGS_H

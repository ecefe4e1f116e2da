#ifndef BOUNDARY_RECOVERY_3_EXAMPLES_ORIENT_PARTS_H
#define BOUNDARY_RECOVERY_3_EXAMPLES_ORIENT_PARTS_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

// The faces of a surface as facets of the triangulation: where there are Steiner points on a face (conforming mode), it
// is a union of facets. These come in any orientation; here they are turned like their face, which `label_regions()`
// needs. Nothing is computed: the edges of the face have a direction, and neighboring parts run through the edge
// between them in opposite directions.
template <typename Result>
class Part_orienter
{
public:
  typedef typename Result::Vertex_handle            Vertex_handle;
  typedef std::array<Vertex_handle, 3>              Facet;

  explicit Part_orienter(const Result& result)
    : m_result(result)
  {
    for(const auto& part : result.parts_of_facets)
      m_parts_of_face[part.constraint.index].push_back({{ part.vertices[0], part.vertices[1], part.vertices[2] }});
    for(std::size_t i = 0; i < result.parts_of_edges.size(); ++i)
      m_parts_of_edge[sorted(result.parts_of_edges[i].constraint.vertices[0],
                             result.parts_of_edges[i].constraint.vertices[1])].push_back(i);
  }

  // the facets that the face with the given number and vertices, which is not missing, consists of
  template <typename Face>
  std::vector<Facet> operator()(const std::size_t number, const Face& face) const
  {
    const auto found = m_parts_of_face.find(number);
    if(found == m_parts_of_face.end())
      return { {{ vertex(face[0]), vertex(face[1]), vertex(face[2]) }} };
    std::vector<Facet> parts = found->second;
    orient(parts, boundary(face));
    return parts;
  }

private:
  typedef std::pair<std::size_t, std::size_t>       Edge_of_input;
  typedef std::pair<const void*, const void*>       Edge; // addresses of vertices, for looking up only

  static Edge_of_input sorted(const std::size_t i, const std::size_t j) { return std::minmax({ i, j }); }
  static Edge edge(const Vertex_handle u, const Vertex_handle v) { return Edge(&*u, &*v); }
  static Edge reverse(const Edge& e) { return Edge(e.second, e.first); }
  static Edge undirected(const Edge& e) { return (std::min)(e, reverse(e)); }

  Vertex_handle vertex(const std::size_t i) const { return m_result.vertices[i]; }

  // the mesh edges around a face, in its direction
  template <typename Face>
  std::vector<Edge> boundary(const Face& face) const
  {
    std::vector<Edge> edges;
    for(int i = 0; i < 3; ++i)
    {
      const std::size_t a = face[i], b = face[(i + 1) % 3];
      const auto found = m_parts_of_edge.find(sorted(a, b));
      if(found == m_parts_of_edge.end())
      {
        edges.push_back(edge(vertex(a), vertex(b)));
        continue;
      }
      const bool is_forward = m_result.parts_of_edges[found->second.front()].vertices[0] == vertex(a);
      for(const std::size_t k : found->second)
      {
        const auto& part = m_result.parts_of_edges[k].vertices;
        edges.push_back(is_forward ? edge(part[0], part[1]) : edge(part[1], part[0]));
      }
    }
    return edges;
  }

  // Turns a part that has one of the edges such that it runs through it, then its neighbors, and so on.
  static void orient(std::vector<Facet>& parts, std::vector<Edge> edges)
  {
    std::map<Edge, std::vector<std::size_t> > parts_at;
    for(std::size_t i = 0; i < parts.size(); ++i)
      for(int k = 0; k < 3; ++k)
        parts_at[undirected(edge_of(parts[i], k))].push_back(i);

    std::vector<bool> is_done(parts.size(), false);
    while(! edges.empty())
    {
      const Edge e = edges.back();
      edges.pop_back();
      for(const std::size_t i : parts_at[undirected(e)])
      {
        if(is_done[i])
          continue;
        is_done[i] = true;
        Facet& part = parts[i];
        if(edge_of(part, 0) != e && edge_of(part, 1) != e && edge_of(part, 2) != e)
          std::swap(part[0], part[1]);
        for(int k = 0; k < 3; ++k)
          edges.push_back(reverse(edge_of(part, k)));
      }
    }
  }

  static Edge edge_of(const Facet& facet, const int k) { return edge(facet[k], facet[(k + 1) % 3]); }

  const Result& m_result;
  std::map<std::size_t, std::vector<Facet> > m_parts_of_face;
  std::map<Edge_of_input, std::vector<std::size_t> > m_parts_of_edge; // positions in `parts_of_edges`
};

#endif // BOUNDARY_RECOVERY_3_EXAMPLES_ORIENT_PARTS_H

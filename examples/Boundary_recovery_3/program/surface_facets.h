#ifndef BOUNDARY_RECOVERY_3_PROGRAM_SURFACE_FACETS_H
#define BOUNDARY_RECOVERY_3_PROGRAM_SURFACE_FACETS_H

#include <array>
#include <cstddef>
#include <map>
#include <vector>

// The faces of a surface as facets of the triangulation: where there are Steiner points on a face (conforming mode), it
// is a union of facets.
template <typename Result>
class Surface_facets
{
public:
  typedef typename Result::Vertex_handle            Vertex_handle;
  typedef std::array<Vertex_handle, 3>              Facet;

  explicit Surface_facets(const Result& result)
    : m_result(result)
  {
    for(const auto& part : result.parts_of_facets)
      m_parts_of_face[part.constraint.index].push_back({{ part.vertices[0], part.vertices[1], part.vertices[2] }});
  }

  // the facets that the face with the given number and vertices, which is not missing, consists of
  template <typename Face>
  std::vector<Facet> operator()(const std::size_t number, const Face& face) const
  {
    const auto found = m_parts_of_face.find(number);
    if(found != m_parts_of_face.end())
      return found->second;
    const std::vector<Vertex_handle>& v = m_result.vertices;
    return { {{ v[face[0]], v[face[1]], v[face[2]] }} };
  }

private:
  const Result& m_result;
  std::map<std::size_t, std::vector<Facet> > m_parts_of_face;
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_SURFACE_FACETS_H

// Makes plain numbers of a triangulation and of the result of recover_boundary(), for Exact_mesh_checker.

#ifndef BR3_TEST_RECOVERED_MESH_H
#define BR3_TEST_RECOVERED_MESH_H

#include "exact_mesh_checker_br3.h"

#include <unordered_map>

namespace br3_test {

template <typename Triangulation, typename Result>
class Recovered_mesh
{
public:
  typedef typename Result::Vertex_handle Vertex_handle;
  typedef CGAL::Boundary_recovery_3::Recovery_mode Mode;

  // `points` and `faces` are what was given to recover_boundary(), the points as triples of doubles.
  Recovered_mesh(const Triangulation& tr, const Result& result, const std::vector<Coordinates>& points,
                 const std::vector<Indexed_mesh::Facet>& faces)
    : m_tr(tr)
  {
    require(result.vertices.size() == points.size(), "not every input point has its vertex");
    for(std::size_t i = 0; i < points.size(); ++i)
    {
      const Rational_point p = add(result.vertices[i]);
      for(int k = 0; k < 3; ++k)
        require(p.x[k] == Rational(points[i][k]), "a vertex is elsewhere");
    }
    m_mesh.number_of_inputs = points.size();
    for(const Vertex_handle v : result.steiner_vertices)
      add(v);
    require(m_mesh.points.size() == tr.number_of_vertices(), "a vertex is neither of the input nor a Steiner vertex");
    for(const auto c : tr.finite_cell_handles())
      m_mesh.cells.push_back({{ index(c->vertex(0)), index(c->vertex(1)), index(c->vertex(2)), index(c->vertex(3)) }});
    m_mesh.surface = faces;
    for(const auto& facet : result.missing_facets)
      m_mesh.missing.insert(facet.index);
    for(const auto& part : result.parts_of_facets)
      m_mesh.parts[part.constraint.index].push_back({{ index(part.vertices[0]), index(part.vertices[1]),
                                                       index(part.vertices[2]) }});
  }

  const Indexed_mesh& mesh() const { return m_mesh; }

  static Exact_mesh_checker::Kind kind(const Mode mode, const Result& result)
  {
    typedef typename CGAL::Algebraic_structure_traits<typename Triangulation::Geom_traits::FT>::Is_exact Is_exact;
    if(mode != Mode::conforming || result.steiner_vertices.empty())
      return Exact_mesh_checker::constrained;
    return Is_exact::value ? Exact_mesh_checker::conforming : Exact_mesh_checker::conforming_rounded;
  }

private:
  std::size_t index(const Vertex_handle v) const
  {
    const auto it = m_index.find(&*v);
    require(it != m_index.end(), "a cell has a vertex that nobody knows");
    return it->second;
  }

  Rational_point add(const Vertex_handle v)
  {
    require(! m_tr.is_infinite(v) && m_index.emplace(&*v, m_mesh.points.size()).second, "a vertex is listed twice");
    const Rational_point p = to_rational(v->point());
    Coordinates c;
    bool is_double = true;
    for(int k = 0; k < 3; ++k)
    {
      c[k] = CGAL::to_double(p.x[k]);
      is_double = is_double && Rational(c[k]) == p.x[k];
    }
    if(! is_double)
      m_mesh.exact_points.emplace(m_mesh.points.size(), p);
    m_mesh.points.push_back(c);
    return p;
  }

  const Triangulation& m_tr;
  std::unordered_map<const void*, std::size_t> m_index; // look-up only
  Indexed_mesh m_mesh;
};

} // namespace br3_test

#endif // BR3_TEST_RECOVERED_MESH_H

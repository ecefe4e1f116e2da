// Moves the inner vertices of a mesh along with those of its boundary, for the benchmarks.

#ifndef BR3_BENCHMARK_MESH_MOTION_H
#define BR3_BENCHMARK_MESH_MOTION_H

#include "mesh_quality_br3.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace br3_benchmark {

// Springs along all edges, the stiffer the shorter they are, hold the inner vertices. `displacements` has what is known
// where `is_fixed` is, and gets the rest. Fails if the solver does not converge.
class Spring_motion
{
  typedef std::array<std::size_t, 4>                    Tetrahedron;
  typedef Eigen::SparseMatrix<double, Eigen::RowMajor> Matrix;
  typedef std::pair<std::size_t, std::size_t>          Edge;

  static constexpr std::size_t no_unknown = std::size_t(-1);

  std::vector<Edge> m_edges;
  std::vector<std::size_t> m_unknowns; // of the vertices
  std::vector<double> m_stiffness;     // of the edges
  int m_number_of_unknowns = 0;

  void collect_edges(const std::vector<Tetrahedron>& tetrahedra)
  {
    m_edges.reserve(6 * tetrahedra.size());
    for(const Tetrahedron& t : tetrahedra)
      for(std::size_t i = 0; i < 4; ++i)
        for(std::size_t j = 0; j < 4; ++j)
          if(t[i] < t[j])
            m_edges.emplace_back(t[i], t[j]);
    std::sort(m_edges.begin(), m_edges.end());
    m_edges.erase(std::unique(m_edges.begin(), m_edges.end()), m_edges.end());
  }

  Matrix matrix() const
  {
    typedef Eigen::Triplet<double> Entry;
    std::vector<Entry> entries;
    entries.reserve(4 * m_edges.size());
    for(std::size_t i = 0; i < m_edges.size(); ++i)
    {
      const std::size_t v = m_unknowns[m_edges[i].first], w = m_unknowns[m_edges[i].second];
      for(const std::size_t u : { v, w })
        if(u != no_unknown)
          entries.emplace_back(int(u), int(u), m_stiffness[i]);
      if(v == no_unknown || w == no_unknown)
        continue;
      entries.emplace_back(int(v), int(w), -m_stiffness[i]);
      entries.emplace_back(int(w), int(v), -m_stiffness[i]);
    }
    Matrix result(m_number_of_unknowns, m_number_of_unknowns);
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

  Eigen::VectorXd right_hand_side(const std::vector<Point>& displacements, const std::size_t axis) const
  {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(m_number_of_unknowns);
    for(std::size_t i = 0; i < m_edges.size(); ++i)
    {
      const std::size_t v = m_edges[i].first, w = m_edges[i].second;
      if(m_unknowns[v] == no_unknown && m_unknowns[w] != no_unknown)
        result[Eigen::Index(m_unknowns[w])] += m_stiffness[i] * displacements[v][axis];
      if(m_unknowns[w] == no_unknown && m_unknowns[v] != no_unknown)
        result[Eigen::Index(m_unknowns[v])] += m_stiffness[i] * displacements[w][axis];
    }
    return result;
  }

public:
  Spring_motion(const std::vector<Point>& points, const std::vector<Tetrahedron>& tetrahedra,
                const std::vector<bool>& is_fixed)
    : m_unknowns(points.size(), no_unknown)
  {
    collect_edges(tetrahedra);
    for(std::size_t v = 0; v < points.size(); ++v)
      if(! is_fixed[v])
        m_unknowns[v] = std::size_t(m_number_of_unknowns++);
    for(const Edge& e : m_edges)
    {
      const Point d = difference(points[e.first], points[e.second]);
      m_stiffness.push_back(1 / std::sqrt(dot(d, d)));
    }
  }

  bool operator()(std::vector<Point>& displacements) const
  {
    if(m_number_of_unknowns == 0)
      return true;
    Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper> solver;
    solver.setTolerance(1e-4);
    const Matrix a = matrix();
    solver.compute(a);
    for(std::size_t axis = 0; axis < 3; ++axis)
    {
      const Eigen::VectorXd x = solver.solve(right_hand_side(displacements, axis));
      if(solver.info() != Eigen::Success)
        return false;
      for(std::size_t v = 0; v < m_unknowns.size(); ++v)
        if(m_unknowns[v] != no_unknown)
          displacements[v][axis] = x[Eigen::Index(m_unknowns[v])];
    }
    return true;
  }
};

} // namespace br3_benchmark

#endif // BR3_BENCHMARK_MESH_MOTION_H

#ifndef BOUNDARY_RECOVERY_3_PROGRAM_BOUNDARY_LOOPS_H
#define BOUNDARY_RECOVERY_3_PROGRAM_BOUNDARY_LOOPS_H

#include "distance_between.h"
#include "triangle_soup.h"

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

// Open edges one after the other, and no vertex twice. Where a sheet is attached to other triangles along a part of its
// border only, the rest is a chain with two ends.
struct Boundary_loop
{
  std::vector<std::size_t> vertices;
  bool is_closed = true;
  double length = 0;
  CGAL::Bbox_3 box;

  std::size_t number_of_edges() const { return vertices.size() - (is_closed ? 0 : 1); }
};

// Where a surface ends.
struct Boundary_loops
{
  std::vector<Boundary_loop> loops; // the longest one first
  std::size_t number_of_branching_vertices = 0; // where loops touch, so that others could be made of the same edges
};

// Makes loops of open edges. Where they branch, the way goes on to the vertex with the smallest number, and what comes
// back to a vertex of the way is cut off as a loop: so no loop touches itself, and the same edges give the same loops.
template <typename Point>
class Boundary_loop_finder
{
  const std::vector<Point>& m_points;
  std::map<std::size_t, std::vector<std::size_t> > m_neighbors; // by edges in no loop yet; the largest one first
  std::vector<std::size_t> m_way;
  std::map<std::size_t, std::size_t> m_position; // of each vertex on the way
  Boundary_loops m_result;

public:
  explicit Boundary_loop_finder(const std::vector<Point>& points) : m_points(points) { }

  Boundary_loops operator()(const std::vector<Open_edge>& edges)
  {
    collect(edges);
    for(const bool ends_only : { true, false }) // a way that has ends begins at one of them
      for(const auto& vertex : m_neighbors)
        while(vertex.second.size() % 2 == 1 || (! ends_only && ! vertex.second.empty()))
          walk(vertex.first);
    std::stable_sort(m_result.loops.begin(), m_result.loops.end(),
                     [](const Boundary_loop& a, const Boundary_loop& b) { return a.length > b.length; });
    return std::move(m_result);
  }

private:
  void collect(const std::vector<Open_edge>& edges)
  {
    for(const Open_edge& e : edges)
    {
      if(e.vertices.first == e.vertices.second) // of a triangle with a repeated vertex
        continue;
      m_neighbors[e.vertices.first].push_back(e.vertices.second);
      m_neighbors[e.vertices.second].push_back(e.vertices.first);
    }
    for(auto& vertex : m_neighbors)
    {
      std::sort(vertex.second.rbegin(), vertex.second.rend());
      m_result.number_of_branching_vertices += vertex.second.size() > 2;
    }
  }

  void walk(const std::size_t start)
  {
    m_way.assign(1, start);
    m_position = { { start, 0 } };
    while(! m_neighbors[m_way.back()].empty())
      step();
    if(m_way.size() > 1)
      add_loop(0, false);
  }

  void step()
  {
    const std::size_t v = m_way.back(), w = m_neighbors[v].back();
    m_neighbors[v].pop_back();
    std::vector<std::size_t>& back = m_neighbors[w];
    back.erase(std::find(back.begin(), back.end(), v));
    const auto visited = m_position.emplace(w, m_way.size());
    if(visited.second)
      m_way.push_back(w);
    else
      cut_off(visited.first->second);
  }

  void cut_off(const std::size_t begin)
  {
    add_loop(begin, true);
    for(std::size_t i = begin + 1; i < m_way.size(); ++i)
      m_position.erase(m_way[i]);
    m_way.resize(begin + 1);
  }

  void add_loop(const std::size_t begin, const bool is_closed)
  {
    Boundary_loop loop;
    loop.vertices.assign(m_way.begin() + begin, m_way.end());
    loop.is_closed = is_closed;
    for(std::size_t i = 0; i < loop.vertices.size(); ++i)
    {
      const Point& p = m_points[loop.vertices[i]];
      loop.box += p.bbox();
      if(i < loop.number_of_edges())
        loop.length += distance_between(p, m_points[loop.vertices[(i + 1) % loop.vertices.size()]]);
    }
    m_result.loops.push_back(loop);
  }
};

template <typename Point>
Boundary_loops find_boundary_loops(const std::vector<Point>& points, const std::vector<Open_edge>& edges)
{
  return Boundary_loop_finder<Point>(points)(edges);
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_BOUNDARY_LOOPS_H

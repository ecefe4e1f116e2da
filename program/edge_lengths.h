#ifndef BOUNDARY_RECOVERY_3_PROGRAM_EDGE_LENGTHS_H
#define BOUNDARY_RECOVERY_3_PROGRAM_EDGE_LENGTHS_H

#include "domain.h"

#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

// How long the edges inside the domain are, those that no triangle of the surface has, in terms of the size that was
// asked for at their midpoints.
struct Edge_lengths
{
  static constexpr double shortest = 0.7071067811865476, longest = 1.4142135623730951; // sqrt(1/2) and sqrt(2)

  std::size_t number_of_edges = 0;
  std::size_t number_in_range = 0; // from `shortest` to `longest`
  std::size_t number_below = 0;
  std::size_t number_above = 0;
  double mean = 0;
  double maximum = 0;

  double share_in_range() const
  {
    return number_of_edges == 0 ? 1 : double(number_in_range) / double(number_of_edges);
  }
};

// Measures each edge once. The edges are sorted by their smaller vertex, and the larger ones are stamped: no hashing.
template <typename Point>
class Edge_meter
{
  typedef std::vector<std::size_t> Begins;

  const Domain<Point>& m_domain;

public:
  explicit Edge_meter(const Domain<Point>& domain) : m_domain(domain) { }

  // `size` tells the size at a point of a region
  template <typename Size>
  Edge_lengths operator()(const Size& size) const
  {
    const std::size_t n = m_domain.points.size();
    std::vector<std::pair<Point_number, int> > edges, surface_edges; // the larger vertices, and a region
    const Begins begins = sort_edges(m_domain.tetrahedra, m_domain.regions, edges);
    const Begins surface_begins =
      sort_edges(m_domain.triangles, std::vector<int>(m_domain.triangles.size(), 0), surface_edges);

    Edge_lengths lengths;
    std::vector<std::size_t> stamps(n, n);
    for(std::size_t v = 0; v < n; ++v)
    {
      for(std::size_t k = surface_begins[v]; k < surface_begins[v + 1]; ++k)
        stamps[surface_edges[k].first] = v;
      for(std::size_t k = begins[v]; k < begins[v + 1]; ++k)
        if(std::exchange(stamps[edges[k].first], v) != v)
          add(m_domain.points[v], m_domain.points[edges[k].first], edges[k].second, size, lengths);
    }
    lengths.mean /= double((std::max)(lengths.number_of_edges, std::size_t(1)));
    return lengths;
  }

private:
  // Lists the edges of simplices, by their smaller vertices; returns where those of each vertex begin.
  template <std::size_t N>
  Begins sort_edges(const std::vector<std::array<Point_number, N> >& simplices, const std::vector<int>& regions,
                    std::vector<std::pair<Point_number, int> >& edges) const
  {
    const auto for_each_edge = [&](const auto& f)
    {
      for(std::size_t s = 0; s < simplices.size(); ++s)
        for(std::size_t i = 0; i < N; ++i)
          for(std::size_t j = i + 1; j < N; ++j)
            f(std::minmax(simplices[s][i], simplices[s][j]), regions[s]);
    };
    Begins begins(m_domain.points.size() + 1, 0);
    for_each_edge([&](const auto& edge, int) { ++begins[edge.first + 1]; });
    for(std::size_t v = 1; v < begins.size(); ++v)
      begins[v] += begins[v - 1];
    edges.resize(begins.back());
    Begins next(begins);
    for_each_edge([&](const auto& edge, const int region) { edges[next[edge.first]++] = { edge.second, region }; });
    return begins;
  }

  template <typename Size>
  static void add(const Point& p, const Point& q, const int region, const Size& size, Edge_lengths& lengths)
  {
    const double h = size(CGAL::midpoint(p, q), 3, region);
    const double length = std::hypot(p.x() - q.x(), p.y() - q.y(), p.z() - q.z()) / h;
    ++lengths.number_of_edges;
    lengths.number_below += length < Edge_lengths::shortest;
    lengths.number_above += length > Edge_lengths::longest;
    lengths.number_in_range += length >= Edge_lengths::shortest && length <= Edge_lengths::longest;
    lengths.mean += length;
    lengths.maximum = (std::max)(lengths.maximum, length);
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_EDGE_LENGTHS_H

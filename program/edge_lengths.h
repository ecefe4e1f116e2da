#ifndef BOUNDARY_RECOVERY_3_PROGRAM_EDGE_LENGTHS_H
#define BOUNDARY_RECOVERY_3_PROGRAM_EDGE_LENGTHS_H

#include "distance_between.h"

#include <CGAL/Boundary_recovery_3/internal/quality/Measure_quality_3.h>

#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <cstddef>
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
  double sum = 0;
  double maximum = 0;

  double mean() const { return sum / double((std::max)(number_of_edges, std::size_t(1))); }

  double share_in_range() const
  {
    return number_of_edges == 0 ? 1 : double(number_in_range) / double(number_of_edges);
  }

  void add(const double length)
  {
    ++number_of_edges;
    number_in_range += length >= shortest && length <= longest;
    number_below += length < shortest;
    number_above += length > longest;
    sum += length;
    maximum = (std::max)(maximum, length);
  }

  Edge_lengths& operator+=(const Edge_lengths& other)
  {
    number_of_edges += other.number_of_edges;
    number_in_range += other.number_in_range;
    number_below += other.number_below;
    number_above += other.number_above;
    sum += other.sum;
    maximum = (std::max)(maximum, other.maximum);
    return *this;
  }
};

// Measures the edges of the regions of a triangulation, by all threads; `size` tells the size at a point of a region.
template <typename Tr, typename Size>
Edge_lengths measure_edges(const Tr& tr, const Size& size)
{
  namespace internal = CGAL::Boundary_recovery_3::internal;
  typedef typename Tr::Cell_handle Cell_handle;

  const internal::Selected_domain_3<Tr> domain(tr);
  const internal::Inner_edges_3<Tr> inner_edges(domain);
  const auto measure = [&](const std::vector<Cell_handle>& cells)
  {
    Edge_lengths lengths;
    for(const Cell_handle c : cells)
      if(domain.contains(c))
        inner_edges.for_each_own_edge(c, internal::Cell_shape_3(internal::corners(c)), [&](const int k)
        {
          if(! inner_edges.is_inner(c, k))
            return;
          const auto& p = c->vertex(internal::edges_of_cell[k][0])->point();
          const auto& q = c->vertex(internal::edges_of_cell[k][1])->point();
          lengths.add(distance_between(p, q) / size(CGAL::midpoint(p, q), 3, c->subdomain_index()));
        });
    return lengths;
  };
  Edge_lengths sum;
  const auto take = [&sum](const Edge_lengths& lengths)
  {
    sum += lengths;
    return true;
  };
  internal::for_each_block(tr.all_cell_handles(), measure, take, internal::Concurrency_tag_of<Tr>());
  return sum;
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_EDGE_LENGTHS_H

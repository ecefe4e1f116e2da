#ifndef BOUNDARY_RECOVERY_3_PROGRAM_SECOND_ORDER_H
#define BOUNDARY_RECOVERY_3_PROGRAM_SECOND_ORDER_H

#include "domain.h"

#include <CGAL/Boundary_recovery_3/number_edge_nodes.h>

#include <CGAL/Kernel/global_functions_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

// makes a mesh one of second order: with a node in the middle of each edge
template <typename Point>
void add_edge_points(Domain<Point>& domain)
{
  auto nodes = CGAL::Boundary_recovery_3::number_edge_nodes(domain.tetrahedra, domain.triangles);
  if(nodes.edges.size() > (std::numeric_limits<Point_number>::max)() - domain.points.size())
    throw std::length_error("the mesh has too many edges to be written as one of second order");
  domain.edge_points.reserve(nodes.edges.size());
  for(const auto& [u, v] : nodes.edges)
    domain.edge_points.push_back(CGAL::midpoint(domain.points[u], domain.points[v]));
  const auto number_after_points = [&](auto& simplices)
  {
    for(auto& edges : simplices)
      for(Point_number& edge : edges)
        edge += static_cast<Point_number>(domain.points.size());
  };
  number_after_points(nodes.tetrahedra);
  number_after_points(nodes.triangles);
  domain.edges_of_tetrahedra = std::move(nodes.tetrahedra);
  domain.edges_of_triangles = std::move(nodes.triangles);
}

// the nodes of a simplex of second order: its corners, then those in the middle of its edges
template <std::size_t M, std::size_t N>
std::array<Point_number, M + N> nodes_of_simplex(const std::array<Point_number, M>& corners,
                                                 const std::array<Point_number, N>& edges)
{
  std::array<Point_number, M + N> nodes;
  std::copy(edges.begin(), edges.end(), std::copy(corners.begin(), corners.end(), nodes.begin()));
  return nodes;
}

// calls the function with the nodes of simplex `i`, in the order of VTK and MEDIT; a mesh of first order has no edges
template <std::size_t M, std::size_t N, typename F>
void with_nodes(const std::vector<std::array<Point_number, M> >& simplices,
                const std::vector<std::array<Point_number, N> >& edges, const std::size_t i, const F& f)
{
  if(edges.empty())
    f(simplices[i]);
  else
    f(nodes_of_simplex(simplices[i], edges[i]));
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_SECOND_ORDER_H

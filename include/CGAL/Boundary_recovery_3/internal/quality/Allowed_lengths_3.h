// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_ALLOWED_LENGTHS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_ALLOWED_LENGTHS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/Selected_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/mesh_indices.h>
#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/shape/distances_3.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Vertex_sizes_3.h>

#include <CGAL/Unique_hash_map.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <queue>
#include <tuple>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * How long edges of the mesh may be, so that the size field holds: neither longer than twice nor shorter than half of
 * the size, as far as sizes are known.
 *
 * But an edge may be as long as a constrained one that has an end in common with it, and as short as the constrained
 * ones nearby, where "nearby" fades with distance: beside a thin triangle of the surface, cells of the right size would
 * be bad.
 */
template <typename Tr>
class Allowed_lengths_3
{
public:
  typedef typename Tr::Vertex_handle Vertex_handle;
  typedef typename Tr::Cell_handle   Cell_handle;

  struct Range
  {
    double least;
    double largest;

    bool contains(const double length) const { return length >= least && length <= largest; }

    void include(const double length)
    {
      least = (std::min)(least, length);
      largest = (std::max)(largest, length);
    }
  };

  explicit Allowed_lengths_3(const Tr& tr)
    : m_tr(tr), m_of_constraints(Range{ std::numeric_limits<double>::infinity(), 0 })
  { }

  // What is not known here is what is known of the whole mesh, which is not to change meanwhile.
  void set_whole(const Allowed_lengths_3& whole) { m_whole = &whole; }

  // The constrained facets of a cell of the domain are taken into account.
  void add(const Selected_domain_3<Tr>& domain, const Cell_handle c)
  {
    if constexpr(Has_meshing_info<typename Tr::Vertex>::value)
      for(int i = 0; i < 4; ++i)
        if(is_wall(domain, c, i))
          add_facet(c, i);
  }

  // Whether add() has something to do.
  static bool has_wall(const Selected_domain_3<Tr>& domain, const Cell_handle c)
  {
    return is_wall(domain, c, 0) || is_wall(domain, c, 1) || is_wall(domain, c, 2) || is_wall(domain, c, 3);
  }

  // To be called when all cells were added. `goes_on` is asked after each vertex; if it says no, nobody may need this.
  template <typename Question>
  void spread(const Question& goes_on)
  {
    spread_least(goes_on);
    spread_largest(goes_on);
    m_constrained_vertices.clear();
  }

  // The size at a vertex; 0: not known.
  static double size(const Vertex_handle v) { return internal::vertex_size(*v); }

  // The length that edges of a vertex have at least.
  double least(const Vertex_handle v) const
  {
    return (std::min)(Length_rules::shortest * size(v), of_constraints(v).least);
  }

  // Where an edge may have this length, edges this far away may be longer by that.
  static double faded(const double least, const double distance) { return least + 0.5 * distance; }

  // Edges of a new vertex may have this length. What is known of a vertex that is gone, whose place it got, is not its.
  void set_least(const Vertex_handle v, const double length) { m_of_constraints[v] = Range{ length, 0 }; }

  // What is known of the constraints at a vertex, for another one that takes its place.
  const Range& of_constraints(const Vertex_handle v) const
  {
    const auto& table = m_whole == nullptr || m_of_constraints.is_defined(v) ? m_of_constraints
                                                                             : m_whole->m_of_constraints;
    return table[v];
  }
  void set_of_constraints(const Vertex_handle v, const Range& range) { m_of_constraints[v] = range; }

  // Of an edge between two vertices.
  Range at(const Vertex_handle u, const Vertex_handle v) const { return at(u, size(v), of_constraints(v)); }

  // Of an edge from u to a new vertex with this size, whose edges may have this length.
  Range at(const Vertex_handle u, const double size, const double least) const
  {
    return at(u, size, Range{ least, 0 });
  }

private:
  Range at(const Vertex_handle u, const double size_at_v, const Range& constraints_at_v) const
  {
    const double size_at_u = size(u);
    if(! (size_at_u > 0 && size_at_v > 0))
      return Range{ 0, std::numeric_limits<double>::infinity() };
    const double mean = 0.5 * (size_at_u + size_at_v);
    const Range& constraints = of_constraints(u);
    return Range{ (std::min)({ Length_rules::shortest * mean, constraints.least, constraints_at_v.least }),
                  (std::max)({ Length_rules::longest * mean, constraints.largest, constraints_at_v.largest }) };
  }

  static double distance(const Vertex_handle u, const Vertex_handle v)
  {
    return internal::distance(internal::coordinates_of(u->point()), internal::coordinates_of(v->point()));
  }

  // Asks the vertices first, if they know; that is cheaper than to ask the cell behind the facet.
  static bool is_wall(const Selected_domain_3<Tr>& domain, const Cell_handle c, const int i)
  {
    if constexpr(Has_vertex_indices<typename Tr::Vertex>::value)
      for(int k = 0; k < 4 && ! domain.has_selection(); ++k)
        if(k != i && c->vertex(k)->in_dimension() == 3)
          return false;
    return domain.is_wall(c, i);
  }

  void add_facet(const Cell_handle c, const int i)
  {
    for(int k = 0; k < 4; ++k)
      if(k != i)
      {
        Range& range = m_of_constraints[c->vertex(k)];
        if(range.largest == 0)
          m_constrained_vertices.push_back(c->vertex(k));
        for(int l = 0; l < 4; ++l)
          if(l != i && l != k)
            range.include(distance(c->vertex(k), c->vertex(l)));
      }
  }

  template <typename Question>
  void spread_least(const Question& goes_on)
  {
    spread([this](const Vertex_handle v) { return - of_constraints(v).least; },
           [this](const Vertex_handle v) { return - least(v); },
           [this](const Vertex_handle v, const double x) { m_of_constraints[v].least = -x; }, 0.5, goes_on);
  }

  template <typename Question>
  void spread_largest(const Question& goes_on)
  {
    spread([this](const Vertex_handle v) { return of_constraints(v).largest; },
           [this](const Vertex_handle v)
           {
             return (std::max)(Length_rules::longest * size(v), of_constraints(v).largest);
           },
           [this](const Vertex_handle v, const double x) { m_of_constraints[v].largest = x; }, 1, goes_on);
  }

  // From the vertices on constraints to those around (Dijkstra), as long as it makes a difference: what fades with
  // distance is larger than what is known there.
  template <typename Value, typename Known, typename Set, typename Question>
  void spread(const Value& value, const Known& known, const Set& set, const double fading, const Question& goes_on)
  {
    typedef std::tuple<double, std::size_t, Vertex_handle> Entry; // the number makes the order independent of addresses
    const auto is_later = [](const Entry& x, const Entry& y)
    {
      return std::get<0>(x) < std::get<0>(y) || (std::get<0>(x) == std::get<0>(y) && std::get<1>(x) > std::get<1>(y));
    };
    std::priority_queue<Entry, std::vector<Entry>, decltype(is_later)> queue(is_later);
    std::size_t number = 0;
    for(const Vertex_handle v : m_constrained_vertices)
      if(value(v) >= known(v))
        queue.emplace(value(v), number++, v);
    std::vector<Vertex_handle> neighbors;
    while(! queue.empty() && goes_on())
    {
      const auto [at_u, k, u] = queue.top();
      queue.pop();
      if(at_u < value(u))
        continue;
      neighbors.clear();
      m_tr.tds().adjacent_vertices(u, std::back_inserter(neighbors));
      for(const Vertex_handle v : neighbors)
      {
        if(m_tr.is_infinite(v))
          continue;
        const double at_v = at_u - fading * distance(u, v);
        if(at_v > known(v))
        {
          set(v, at_v);
          queue.emplace(at_v, number++, v);
        }
      }
    }
  }

  const Tr& m_tr;
  std::vector<Vertex_handle> m_constrained_vertices; // until all is known
  Unique_hash_map<Vertex_handle, Range> m_of_constraints; // for looking up only; [] adds what is not there
  const Allowed_lengths_3* m_whole = nullptr; // where this is about a part of a mesh
};

/*
 * Where a vertex may be, so that the lengths of its edges are allowed. Edges whose lengths are not may stay as they
 * are.
 */
template <typename Tr>
class Allowed_places_3
{
public:
  typedef typename Tr::Vertex_handle Vertex_handle;

  // The vertex v has edges to these vertices.
  template <typename VertexRange>
  void assign(const Allowed_lengths_3<Tr>& lengths, const Vertex_handle v, const VertexRange& neighbors)
  {
    m_limits.clear();
    const Coordinates_3 before = internal::coordinates_of(v->point());
    for(const Vertex_handle u : neighbors)
    {
      const Coordinates_3 p = internal::coordinates_of(u->point());
      auto range = lengths.at(v, u);
      range.include(internal::distance(before, p));
      m_limits.push_back(Limit{ p, range.least * range.least, range.largest * range.largest });
    }
  }

  bool operator()(const Coordinates_3& p) const
  {
    return std::all_of(m_limits.begin(), m_limits.end(), [&](const Limit& limit)
    {
      const double d = internal::squared_distance(p, limit.center);
      return d >= limit.least && d <= limit.largest;
    });
  }

private:
  // Squares of lengths.
  struct Limit
  {
    Coordinates_3 center;
    double least;
    double largest;
  };

  std::vector<Limit> m_limits;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_ALLOWED_LENGTHS_3_H

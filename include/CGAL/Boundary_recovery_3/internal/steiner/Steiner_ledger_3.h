// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_STEINER_LEDGER_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_STEINER_LEDGER_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/geometry/Exact_positions_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * The ledger of Steiner points: of each point on a constraint, which constraint that is, in what order, and where
 * exactly; of each free point, which constraint it came off, and where it is as long as the triangulation cannot store
 * that. It counts how many of both there were.
 *
 * A constrained edge with Steiner points is a chain of vertices from its first to its second. What is on a constraint
 * is known from here, never computed: a mesh facet is a part of a constrained facet iff its three vertices are on it.
 *
 * For the flips, this class stands for the constraints: the parts of constraints are constrained.
 */
template <typename Tr>
class Steiner_ledger_3
{
public:
  typedef typename Tr::Vertex_handle     Vertex_handle;
  typedef Constraints_3<Tr>              Constraints;
  typedef Exact_positions_3<Tr>          Positions;
  typedef std::vector<Vertex_handle>     Vertices;

  // The constraint that a Steiner point is or was on: an edge (dimension 1) or a facet (dimension 2), in its interior.
  struct Carrier
  {
    int dimension;
    std::size_t index;
  };

  explicit Steiner_ledger_3(const Constraints& constraints) : m_constraints(constraints) { }

  Positions& positions() { return m_positions; }
  const Positions& positions() const { return m_positions; }

  // Adds v, on the edge e, behind `previous` in its chain.
  void insert_on_edge(const std::size_t e, const Vertex_handle previous, const Vertex_handle v)
  {
    Vertices& chain = m_chains[e];
    if(chain.empty())
      chain.assign(m_constraints.edges()[e].begin(), m_constraints.edges()[e].end());
    const auto it = std::find(chain.begin(), chain.end(), previous);
    CGAL_assertion(it != chain.end());
    chain.insert(it + 1, v);
    add(v, Carrier{ 1, e });
  }

  // Adds v, in the interior of the facet f.
  void insert_in_facet(const std::size_t f, const Vertex_handle v)
  {
    m_interiors[f].push_back(v);
    add(v, Carrier{ 2, f });
  }

  // Adds v, which came off a constraint, or was put beside it.
  void insert_free(const Vertex_handle v, const Carrier& origin)
  {
    m_free_points.push_back(v);
    m_origins[&*v] = origin;
    ++m_number_of_free_points;
  }

  // Forgets v, which is a Steiner point no longer.
  void erase(const Vertex_handle v)
  {
    m_positions.erase(v);
    if(! is_on_constraint(v))
    {
      erase_from(m_free_points, v);
      m_origins.erase(&*v);
      return;
    }
    const Carrier c = carrier(v);
    erase_from(c.dimension == 1 ? m_chains[c.index] : m_interiors[c.index], v);
    if(c.dimension == 1 && m_chains[c.index].size() == 2)
      m_chains.erase(c.index);
    erase_from(m_points_on_constraints, v);
    m_carriers.erase(&*v);
  }

  // --- the points ---------------------------------------------------------------------------------------------------

  // In the order in which they were inserted.
  const Vertices& points_on_constraints() const { return m_points_on_constraints; }

  // In the order in which they came off constraints. Those that are settled are none of them.
  const Vertices& free_points() const { return m_free_points; }

  // All of them: those on constraints, then the free ones.
  Vertices points() const
  {
    Vertices result = m_points_on_constraints;
    for(const Settled& settled : m_settled)
      result.insert(result.end(), settled.points.begin(), settled.points.end());
    result.insert(result.end(), m_free_points.begin(), m_free_points.end());
    return result;
  }

  bool is_on_constraint(const Vertex_handle v) const { return m_carriers.count(&*v) != 0; }

  bool is_free(const Vertex_handle v) const { return m_origins.count(&*v) != 0; }

  // The constraint that v is on.
  const Carrier& carrier(const Vertex_handle v) const
  {
    CGAL_precondition(is_on_constraint(v));
    return m_carriers.find(&*v)->second;
  }

  // The constraint that v, a free point, came off.
  const Carrier& origin(const Vertex_handle v) const
  {
    CGAL_precondition(is_free(v));
    return m_origins.find(&*v)->second;
  }

  // The number of points that were put on constraints, and of those that came off them, whether they are still there
  // or not.
  std::size_t number_of_constraint_points() const { return m_number_of_constraint_points; }
  std::size_t number_of_free_points() const { return m_number_of_free_points; }

  // --- transactions -------------------------------------------------------------------------------------------------

  // The free points are left alone from now on, until unsettle(); all points that come after that can be taken back.
  // No point is on a constraint. Such transactions may be nested.
  void settle()
  {
    CGAL_precondition(m_points_on_constraints.empty());
    m_settled.emplace_back();
    m_settled.back().points.swap(m_free_points);
    m_settled.back().origins.swap(m_origins);
    m_settled.back().numbers = {{ m_number_of_constraint_points, m_number_of_free_points }};
  }

  void unsettle()
  {
    CGAL_precondition(! m_settled.empty());
    m_settled.back().points.swap(m_free_points);
    m_settled.back().origins.swap(m_origins);
    m_free_points.insert(m_free_points.end(), m_settled.back().points.begin(), m_settled.back().points.end());
    m_origins.insert(m_settled.back().origins.begin(), m_settled.back().origins.end());
    m_settled.pop_back();
  }

  // Forgets all the points since the last settle(), of which the `new_vertices` are all that may have exact positions.
  void take_back(const Vertices& new_vertices)
  {
    for(const Vertices& points : { Vertices(m_points_on_constraints), Vertices(m_free_points) })
      for(const Vertex_handle v : points)
        erase(v);
    for(const Vertex_handle v : new_vertices)
      m_positions.erase(v);
    m_number_of_constraint_points = m_settled.back().numbers[0];
    m_number_of_free_points = m_settled.back().numbers[1];
  }

  // --- constraints and their parts ----------------------------------------------------------------------------------

  // Whether uv is a constrained edge or a part of one.
  bool is_constrained(const Vertex_handle u, const Vertex_handle v) const
  {
    if(m_points_on_constraints.empty() || (! is_on_edge(u) && ! is_on_edge(v)))
      return m_constraints.is_constrained(u, v);
    const Vertices& chain = m_chains.find(carrier(is_on_edge(u) ? u : v).index)->second;
    const auto it = std::find(chain.begin(), chain.end(), u);
    return it != chain.end() && ((it != chain.begin() && *(it - 1) == v) || (it + 1 != chain.end() && *(it + 1) == v));
  }

  // Whether uvw is a constrained facet or a part of one.
  bool is_constrained(const Vertex_handle u, const Vertex_handle v, const Vertex_handle w) const
  {
    if(m_points_on_constraints.empty())
      return m_constraints.is_constrained(u, v, w);
    for(const Vertex_handle x : { u, v, w })
      if(is_on_constraint(x))
      {
        const Carrier c = carrier(x);
        if(c.dimension == 2)
          return is_on_facet(u, c.index) && is_on_facet(v, c.index) && is_on_facet(w, c.index);
        for(const std::size_t f : m_constraints.facets_at_edge(c.index))
          if(is_on_facet(u, f) && is_on_facet(v, f) && is_on_facet(w, f))
            return true;
        return false;
      }
    return m_constraints.is_constrained(u, v, w);
  }

  // Whether v is on the closed facet f.
  bool is_on_facet(const Vertex_handle v, const std::size_t f) const
  {
    const auto it = m_carriers.find(&*v);
    if(it == m_carriers.end())
    {
      const auto& facet = m_constraints.facets()[f];
      return internal::contains(facet, v);
    }
    const auto& edges = m_constraints.edges_of_facet(f);
    return it->second.dimension == 2 ? it->second.index == f
                                     : internal::contains(edges, it->second.index);
  }

  // The edges with Steiner points on them, in increasing order.
  std::vector<std::size_t> split_edges() const
  {
    std::vector<std::size_t> result;
    for(const Vertex_handle v : m_points_on_constraints)
      if(carrier(v).dimension == 1)
        result.push_back(carrier(v).index);
    return sorted(result);
  }

  // The facets with Steiner points on them or on their edges, in increasing order.
  std::vector<std::size_t> split_facets() const
  {
    std::vector<std::size_t> result;
    for(const Vertex_handle v : m_points_on_constraints)
      if(carrier(v).dimension == 2)
        result.push_back(carrier(v).index);
      else
        for(const std::size_t f : m_constraints.facets_at_edge(carrier(v).index))
          result.push_back(f);
    return sorted(result);
  }

  const Constraints& constraints() const { return m_constraints; }

  // The vertices on the edge e, both ends included.
  Vertices vertices_on_edge(const std::size_t e) const
  {
    const auto it = m_chains.find(e);
    if(it != m_chains.end() && ! it->second.empty())
      return it->second;
    return Vertices(m_constraints.edges()[e].begin(), m_constraints.edges()[e].end());
  }

  // The vertices on the closed facet f.
  Vertices vertices_on_facet(const std::size_t f) const
  {
    Vertices result(m_constraints.facets()[f].begin(), m_constraints.facets()[f].end());
    for(const std::size_t e : m_constraints.edges_of_facet(f))
      append_steiner_points(m_chains, e, result);
    append_steiner_points(m_interiors, f, result);
    return result;
  }

  // The vertices before and behind v on its edge.
  std::array<Vertex_handle, 2> neighbors_on_edge(const Vertex_handle v) const
  {
    const Vertices& chain = m_chains.find(carrier(v).index)->second;
    const auto it = std::find(chain.begin(), chain.end(), v);
    return {{ *(it - 1), *(it + 1) }};
  }

private:
  typedef std::unordered_map<std::size_t, Vertices> Vertices_of_constraint; // look-up only
  typedef std::unordered_map<const void*, Carrier>  Carriers;               // look-up only

  // The free points at a settle(), and how many points of both kinds there had been.
  struct Settled
  {
    Vertices points;
    Carriers origins;
    std::array<std::size_t, 2> numbers = {{ 0, 0 }};
  };

  void add(const Vertex_handle v, const Carrier& carrier)
  {
    m_points_on_constraints.push_back(v);
    m_carriers.emplace(&*v, carrier);
    ++m_number_of_constraint_points;
  }

  bool is_on_edge(const Vertex_handle v) const
  {
    const auto it = m_carriers.find(&*v);
    return it != m_carriers.end() && it->second.dimension == 1;
  }

  static std::vector<std::size_t> sorted(std::vector<std::size_t> indices)
  {
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    return indices;
  }

  static void erase_from(Vertices& vertices, const Vertex_handle v)
  {
    vertices.erase(std::find(vertices.begin(), vertices.end(), v));
  }

  void append_steiner_points(const Vertices_of_constraint& of, const std::size_t index, Vertices& result) const
  {
    const auto it = of.find(index);
    if(it == of.end())
      return;
    for(const Vertex_handle v : it->second)
      if(is_on_constraint(v))
        result.push_back(v);
  }

  const Constraints& m_constraints;
  Positions m_positions;
  Vertices m_points_on_constraints;
  Vertices m_free_points;
  Carriers m_origins; // of free points
  std::size_t m_number_of_constraint_points = 0;
  std::size_t m_number_of_free_points = 0;
  std::vector<Settled> m_settled; // the outermost first
  Carriers m_carriers;
  Vertices_of_constraint m_chains;    // of edges, ends included
  Vertices_of_constraint m_interiors; // of facets
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_STEINER_LEDGER_3_H

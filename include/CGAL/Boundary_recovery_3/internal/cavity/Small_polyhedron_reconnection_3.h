// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_SMALL_POLYHEDRON_RECONNECTION_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_SMALL_POLYHEDRON_RECONNECTION_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/cavity/Tetrahedralization_search.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Orientation_table_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/util/bits.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Small polyhedron reconnection: searches a tetrahedralization of a polyhedron that contains given edges and facets.
 *
 * The polyhedron is a set of cells of the mesh, its vertices are all that may be used. The search is exhaustive with
 * pruning, so "none exists" is a proof; its work is bounded, so it may also give up.
 *
 * All geometry is read off a table of orientations. The search takes the face of the front that has the fewest apexes
 * left and tries these. An apex is out if the tetrahedron contained another vertex, or crossed an obstacle: what is
 * required or on the boundary of the polyhedron, and what was chosen before. Obstacles are kept as the edges and faces
 * that they cross, for each edge of the front as the set of its third vertices, so a few operations on bits find all
 * apexes. A face with none left ends the branch.
 */
template <typename Tr>
class Small_polyhedron_reconnection_3
  : public Tetrahedralization_search
{
public:
  typedef typename Tr::Vertex_handle    Vertex_handle;
  typedef typename Tr::Cell_handle      Cell_handle;
  typedef Vertex_predicates_3<Tr>       Predicates;
  typedef std::array<Vertex_handle, 4>  Tetrahedron;

  static constexpr std::size_t max_number_of_vertices = Orientation_table_3<Tr>::max_number_of_vertices;

  // Each tetrahedron that is tried is a step; they are not collected.
  static constexpr Bounds default_bounds = { 28, 0, 2000 };

  explicit Small_polyhedron_reconnection_3(const Predicates& predicates) : m_orientations(predicates) { }

  // Forgets the last polyhedron, of which the orientations that are still of use in the next one are kept. To be called
  // if vertices moved.
  void forget() { m_orientations.forget(); }

  // `cells` are finite cells whose union is a polyhedron; `edges` and `facets` are arrays of vertices of these cells,
  // of simplices inside the polyhedron. `superfluous`, if given, is a vertex inside that is not to be used. The bound
  // on the vertices is max_number_of_vertices at most.
  template <typename CellRange, typename EdgeRange, typename FacetRange>
  Outcome operator()(const CellRange& cells, const EdgeRange& edges, const FacetRange& facets,
                     const Vertex_handle superfluous = Vertex_handle(), const Bounds& bounds = default_bounds)
  {
    m_tetrahedra.clear();
    if(! collect_vertices(cells, superfluous, bounds.vertices))
      return GAVE_UP;
    collect_obstacles(cells, edges, facets);
    return search(bounds.steps);
  }

  // The tetrahedra found, positively oriented.
  const std::vector<Tetrahedron>& tetrahedra() const { return m_tetrahedra; }

private:
  typedef Orientation_table_3<Tr>           Orientations;
  typedef typename Orientations::Edge       Edge;
  typedef typename Orientations::Face       Face;
  typedef typename Orientations::Vertex_set Vertex_set;

  int n() const { return m_orientations.number_of_vertices(); }
  Vertex_handle vertex(const int i) const { return m_orientations.vertices()[i]; }

  template <std::size_t N>
  std::array<int, N> positions(const std::array<Vertex_handle, N>& simplex) const
  {
    std::array<int, N> result;
    std::transform(simplex.begin(), simplex.end(), result.begin(),
                   [this](const Vertex_handle v) { return m_orientations.position(v); });
    return result;
  }

  // Returns false if there are too many.
  template <typename CellRange>
  bool collect_vertices(const CellRange& cells, const Vertex_handle superfluous, const std::size_t max_number)
  {
    const std::vector<Vertex_handle> vertices = internal::vertices_without(cells, superfluous);
    if(vertices.size() > max_number)
    {
      forget();
      return false;
    }
    m_orientations.set_vertices(vertices);
    return true;
  }

  // --- the obstacles ------------------------------------------------------------------------------------------------

  // What must be in the result, because it is on the boundary or required, must not be crossed.
  // That suffices: an edge inside the polyhedron, between two of its vertices, that nothing crosses is in every
  // tetrahedralization.
  template <typename CellRange, typename EdgeRange, typename FacetRange>
  void collect_obstacles(const CellRange& cells, const EdgeRange& edges, const FacetRange& facets)
  {
    const std::size_t number_of_pairs = static_cast<std::size_t>(n()) * n();
    m_edges.clear();
    m_neighbors.assign(n(), 0);
    m_hidden.assign(n(), 0);
    m_open_edges.clear();
    m_is_open.assign(number_of_pairs, false);
    m_pierced.assign(number_of_pairs, 0);
    m_filled.assign(number_of_pairs, 0);
    const std::vector<Face> faces = outer_faces(cells);
    for(const Face& f : faces)
      add_obstacle(f);
    for(const auto& e : edges)
      add_obstacle(positions(e));
    for(const auto& f : facets)
      add_obstacle(positions(f));
    m_changes.clear(); // these are for good
    m_front.clear();
    for(const Face& f : faces)
      add_to_front(f);
  }

  // With the polyhedron on their positive side.
  template <typename CellRange>
  std::vector<Face> outer_faces(const CellRange& cells) const
  {
    std::vector<Face> result;
    internal::for_each_outer_facet(cells, [&](const Cell_handle c, const int i)
    {
      result.push_back(positions(internal::facet_vertices(c, i)));
    });
    return result;
  }

  void add_obstacle(const Edge& e)
  {
    if((m_neighbors[e[0]] & Orientations::set_of(e[1])) != 0)
      return;
    add(Orientations::set_of(e[1]), m_neighbors[e[0]]);
    add(Orientations::set_of(e[0]), m_neighbors[e[1]]);
    for(int a = 0; a < n(); ++a)
      add(m_orientations.ends_of_crossing_edges(e, a), m_hidden[a]);
    for(const Edge& f : m_open_edges)
      add(m_orientations.apexes_of_pierced_faces(e, f), m_pierced[offset(f)]);
    m_edges.push_back(e);
  }

  void add_obstacle(const Face& f)
  {
    for(int k = 0; k < 3; ++k)
      add_obstacle(edge(f, k));
    internal::for_each_bit(m_orientations.sides(f).positive, [&](const int a)
    {
      const Vertex_set ends = m_orientations.ends_of_piercing_edges(f, a);
      add(ends, m_hidden[a]);
      internal::for_each_bit(ends, [&](const int b) { add(Orientations::set_of(a), m_hidden[b]); });
    });
  }

  // From now on until it is taken back, it is known which faces at the edge are pierced. Nobody asks for most of the
  // edges between two vertices.
  void open(const Edge& e)
  {
    if(m_is_open[offset(e)])
      return;
    m_is_open[offset(e)] = true;
    m_open_edges.push_back(e);
    Vertex_set& pierced = m_pierced[offset(e)];
    for(const Edge& f : m_edges)
      pierced |= m_orientations.apexes_of_pierced_faces(f, e);
  }

  static Edge edge(const Face& f, const int k) { return {{ f[k], f[(k + 1) % 3] }}; }

  std::size_t directed_offset(const Edge& e) const { return static_cast<std::size_t>(e[0]) * n() + e[1]; }

  // The same in both directions.
  std::size_t offset(const Edge& e) const
  {
    return directed_offset({{ (std::min)(e[0], e[1]), (std::max)(e[0], e[1]) }});
  }

  // All changes during the search are of this kind, and are noted, to be undone.
  void add(const Vertex_set vertices, Vertex_set& set)
  {
    if((vertices & ~set) == 0)
      return;
    m_changes.push_back({ &set, set });
    set |= vertices;
  }

  // --- the search ---------------------------------------------------------------------------------------------------

  // A face that has no tetrahedron on its positive side yet, and what that may end in, but for later obstacles.
  struct Front_face
  {
    Face face;
    Vertex_set apexes;
  };

  // Depth-first, without recursion: m_choices is the stack of chosen tetrahedra, each with what is left to try instead.
  struct Choice
  {
    Face face;
    int apex;
    Vertex_set alternatives;       // tried after this apex
    std::vector<Front_face> front; // before the choice, as all the following
    std::size_t number_of_edges;
    std::size_t number_of_open_edges;
    std::size_t number_of_changes;
  };

  struct Change
  {
    Vertex_set* set;
    Vertex_set before;
  };

  Outcome search(const std::size_t max_number_of_steps)
  {
    m_choices.clear();
    std::size_t number_of_steps = 0;
    while(! m_front.empty())
    {
      Front_face hardest = hardest_face();
      while(hardest.apexes == 0)
      {
        if(m_choices.empty())
          return NONE;
        hardest = take_back();
      }
      if(++number_of_steps > max_number_of_steps)
        return GAVE_UP;
      choose(hardest);
    }
    for(const Choice& c : m_choices)
      m_tetrahedra.push_back({{ vertex(c.face[0]), vertex(c.face[1]), vertex(c.face[2]), vertex(c.apex) }});
    return FOUND;
  }

  // The face of the front that has the fewest apexes, with these.
  Front_face hardest_face() const
  {
    Front_face result = m_front.front();
    int fewest = n() + 1;
    for(const Front_face& f : m_front)
    {
      const Vertex_set apexes = f.apexes & ~apexes_behind_obstacles(f.face);
      const int number = internal::number_of_bits(apexes);
      if(number >= fewest)
        continue;
      result = { f.face, apexes };
      fewest = number;
      if(fewest == 0)
        break;
    }
    return result;
  }

  // The vertices that make a tetrahedron with the face that crosses an obstacle, or fills a side of a face again.
  Vertex_set apexes_behind_obstacles(const Face& f) const
  {
    Vertex_set result = 0;
    for(int k = 0; k < 3; ++k)
    {
      const Edge e = edge(f, k);
      result |= m_hidden[e[0]] | m_pierced[offset(e)] | m_filled[directed_offset({{ e[1], e[0] }})];
    }
    return result;
  }

  void choose(const Front_face& f)
  {
    Choice choice;
    choice.face = f.face;
    choice.apex = internal::lowest_bit(f.apexes);
    choice.alternatives = f.apexes & ~Orientations::set_of(choice.apex);
    choice.front = m_front;
    choice.number_of_edges = m_edges.size();
    choice.number_of_open_edges = m_open_edges.size();
    choice.number_of_changes = m_changes.size();
    fill(f.face);
    for(int k = 0; k < 3; ++k)
      fill({{ f.face[(k + 1) % 3], f.face[k], choice.apex }});
    m_choices.push_back(std::move(choice));
  }

  // Notes that there is a tetrahedron on the positive side of the face.
  void fill(const Face& f)
  {
    for(int k = 0; k < 3; ++k)
      add(Orientations::set_of(f[(k + 2) % 3]), m_filled[directed_offset(edge(f, k))]);
    const auto it = std::find_if(m_front.begin(), m_front.end(),
                                 [&](const Front_face& g) { return is_rotation(g.face, f); });
    if(it != m_front.end())
    {
      m_front.erase(it);
      return;
    }
    add_obstacle(f);
    add_to_front({{ f[0], f[2], f[1] }});
  }

  void add_to_front(const Face& f)
  {
    for(int k = 0; k < 3; ++k)
      open(edge(f, k));
    Front_face result = { f, 0 };
    internal::for_each_bit(m_orientations.sides(f).positive & ~apexes_behind_obstacles(f), [&](const int v)
    {
      if(! m_orientations.contains_vertex(f, v))
        result.apexes |= Orientations::set_of(v);
    });
    m_front.push_back(result);
  }

  // Undoes the last choice and returns its alternatives.
  Front_face take_back()
  {
    Choice choice = std::move(m_choices.back());
    m_choices.pop_back();
    m_front = std::move(choice.front);
    for(; m_changes.size() > choice.number_of_changes; m_changes.pop_back())
      *m_changes.back().set = m_changes.back().before;
    for(; m_open_edges.size() > choice.number_of_open_edges; m_open_edges.pop_back())
    {
      m_is_open[offset(m_open_edges.back())] = false;
      m_pierced[offset(m_open_edges.back())] = 0;
    }
    m_edges.resize(choice.number_of_edges);
    return { choice.face, choice.alternatives };
  }

  Orientations m_orientations;
  // The obstacles, and what they hide:
  std::vector<Edge> m_edges;           // those that are obstacles
  std::vector<Vertex_set> m_neighbors; // of each vertex, the other ends of these edges
  std::vector<Vertex_set> m_hidden;    // of each vertex, the other ends of the edges that cross an obstacle
  std::vector<Edge> m_open_edges;      // those of all faces that are or were in the front
  std::vector<char> m_is_open;         // of each edge, by offset, whether it is one of these
  std::vector<Vertex_set> m_pierced;   // of each open edge, by offset, the apexes of the faces that an obstacle pierces
  std::vector<Vertex_set> m_filled;    // of each edge, by offset, the apexes of the faces with a chosen tetrahedron
  std::vector<Change> m_changes;
  std::vector<Front_face> m_front;
  std::vector<Choice> m_choices;
  std::vector<Tetrahedron> m_tetrahedra;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_SMALL_POLYHEDRON_RECONNECTION_3_H

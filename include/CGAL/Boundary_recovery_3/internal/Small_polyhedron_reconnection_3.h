// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SMALL_POLYHEDRON_RECONNECTION_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SMALL_POLYHEDRON_RECONNECTION_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/Orientation_table_3.h>
#include <CGAL/Boundary_recovery_3/internal/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/contains.h>

#include <boost/dynamic_bitset.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Small polyhedron reconnection: searches a tetrahedralization of a polyhedron that contains given edges and facets.
 *
 * The polyhedron is a set of cells of the mesh, its vertices are all that may be used. The search is exhaustive with
 * pruning, so "none exists" is a proof; its work is bounded, so it may also give up.
 *
 * All geometry is read off a table of orientations. Candidates are the tetrahedra that contain no other vertex and
 * neither cross the boundary of the polyhedron nor a required simplex. The search takes the face of the front that has
 * the fewest candidates left, tries them, and after each choice drops the candidates that cross it: a face with none
 * left ends the branch.
 */
template <typename Tr>
class Small_polyhedron_reconnection_3
{
public:
  typedef typename Tr::Vertex_handle    Vertex_handle;
  typedef typename Tr::Cell_handle      Cell_handle;
  typedef Vertex_predicates_3<Tr>       Predicates;
  typedef std::array<Vertex_handle, 4>  Tetrahedron;

  enum Outcome
  {
    FOUND,   // tetrahedra() fills the polyhedron
    NONE,    // there is no such tetrahedralization
    GAVE_UP  // the polyhedron has too many vertices, or the search took too many steps
  };

  static constexpr std::size_t max_number_of_vertices = Orientation_table_3<Tr>::max_number_of_vertices;
  static constexpr std::size_t default_max_number_of_steps = 2000;
  static constexpr std::size_t max_number_of_conflict_tests = 50000;

  explicit Small_polyhedron_reconnection_3(const Predicates& predicates) : m_orientations(predicates) { }

  // Forgets the last polyhedron, of which the orientations that are still of use in the next one are kept. To be called
  // if vertices moved.
  void forget() { m_orientations.forget(); }

  // Bound on the number of tetrahedra that are tried in one search.
  void set_max_number_of_steps(const std::size_t n) { m_max_number_of_steps = n; }

  // `cells` are finite cells whose union is a polyhedron; `edges` and `facets` are arrays of vertices of these cells,
  // of simplices inside the polyhedron. `superfluous`, if given, is a vertex inside that is not to be used.
  template <typename CellRange, typename EdgeRange, typename FacetRange>
  Outcome operator()(const CellRange& cells, const EdgeRange& edges, const FacetRange& facets,
                     const Vertex_handle superfluous = Vertex_handle())
  {
    m_tetrahedra.clear();
    if(! collect_vertices(cells, superfluous))
      return GAVE_UP;
    collect_faces(cells);
    collect_required(edges, facets);
    collect_candidates();
    return search();
  }

  // The tetrahedra found, positively oriented.
  const std::vector<Tetrahedron>& tetrahedra() const { return m_tetrahedra; }

private:
  typedef Orientation_table_3<Tr>    Orientations;
  typedef typename Orientations::Edge Edge;
  typedef typename Orientations::Face Face;

  typedef std::array<int, 4> Candidate; // positively oriented

  int n() const { return m_orientations.number_of_vertices(); }
  Vertex_handle vertex(const int i) const { return m_orientations.vertices()[i]; }
  int position(const Vertex_handle v) const { return m_orientations.position(v); }

  template <typename Range, typename Predicate>
  static bool any_of(const Range& range, const Predicate& predicate)
  {
    return std::any_of(range.begin(), range.end(), predicate);
  }

  // Returns false if there are too many.
  template <typename CellRange>
  bool collect_vertices(const CellRange& cells, const Vertex_handle superfluous)
  {
    std::vector<Vertex_handle> vertices;
    for(const Cell_handle c : cells)
      for(int i = 0; i < 4; ++i)
        if(c->vertex(i) != superfluous && ! internal::contains(vertices, c->vertex(i)))
          vertices.push_back(c->vertex(i));
    return m_orientations.set_vertices(vertices);
  }

  static std::array<Edge, 6> edges_of(const Candidate& v)
  {
    return {{ {{ v[0], v[1] }}, {{ v[0], v[2] }}, {{ v[0], v[3] }},
              {{ v[1], v[2] }}, {{ v[1], v[3] }}, {{ v[2], v[3] }} }};
  }

  // The faces, each with the tetrahedron on its positive side.
  static std::array<Face, 4> faces_of(const Candidate& v)
  {
    return {{ {{ v[0], v[1], v[2] }}, {{ v[0], v[3], v[1] }}, {{ v[0], v[2], v[3] }}, {{ v[1], v[3], v[2] }} }};
  }

  // --- the polyhedron ----------------------------------------------------------------------------------------------

  // The outer faces, with the polyhedron on their positive side, are the first front of the search.
  template <typename CellRange>
  void collect_faces(const CellRange& cells)
  {
    m_front.clear();
    m_obstacle_edges.clear();
    m_obstacle_faces.clear();
    m_foreign_edges.clear();
    m_foreign_faces.clear();
    m_edge_state.assign(static_cast<std::size_t>(n()) * n(), 0);
    m_face_state.assign(static_cast<std::size_t>(n()) * n() * n(), 0);
    for(const Cell_handle c : cells)
      for(int i = 0; i < 4; ++i)
      {
        Face f;
        for(int k = 0; k < 3; ++k)
          f[k] = position(c->vertex(Tr::vertex_triple_index(i, k)));
        if(any_of(f, [this](const int p) { return p == n(); }))
          continue; // a face at the superfluous vertex
        if(! internal::contains(cells, c->neighbor(i)))
          m_front.push_back(f);
        state(f) |= in_mesh;
        for(int k = 0; k < 3; ++k)
          state(Edge{{ f[k], f[(k + 1) % 3] }}) |= in_mesh;
      }
    for(const Face& f : m_front)
      add_obstacle(f);
  }

  template <typename EdgeRange, typename FacetRange>
  void collect_required(const EdgeRange& edges, const FacetRange& facets)
  {
    for(const auto& e : edges)
      add_obstacle(Edge{{ position(e[0]), position(e[1]) }});
    for(const auto& f : facets)
      add_obstacle(Face{{ position(f[0]), position(f[1]), position(f[2]) }});
  }

  // Bits of what is known of an edge or a face, in whatever order its vertices are given.
  signed char& state(const Edge& e)
  {
    return m_edge_state[static_cast<std::size_t>((std::min)(e[0], e[1])) * n() + (std::max)(e[0], e[1])];
  }

  signed char& state(Face f)
  {
    std::sort(f.begin(), f.end());
    return m_face_state[key(f)];
  }

  // What must be in the result, because it is on the boundary or required, must not be crossed.
  // That suffices: an edge inside the polyhedron, between two of its vertices, that nothing crosses is in every
  // tetrahedralization.
  // Mesh simplices do not cross each other, so only those obstacles that are not in the mesh have to be tested against
  // them.
  void add_obstacle(const Edge& e)
  {
    add_obstacle(e, m_obstacle_edges, m_foreign_edges);
  }

  void add_obstacle(const Face& f)
  {
    if(! add_obstacle(f, m_obstacle_faces, m_foreign_faces))
      return;
    for(int i = 0; i < 3; ++i)
      add_obstacle(Edge{{ f[i], f[(i + 1) % 3] }});
  }

  template <typename Simplex>
  bool add_obstacle(const Simplex& simplex, std::vector<Simplex>& obstacles, std::vector<Simplex>& foreign)
  {
    signed char& s = state(simplex);
    if((s & obstacle) != 0)
      return false;
    s |= obstacle;
    obstacles.push_back(simplex);
    if((s & in_mesh) == 0)
      foreign.push_back(simplex);
    return true;
  }

  // --- the candidates ------------------------------------------------------------------------------------------------

  void collect_candidates()
  {
    find_uncrossed_edges();
    m_is_pierced.assign(static_cast<std::size_t>(n()) * n() * n(), unknown);
    m_candidates.clear();
    m_candidates_of_face.resize((std::max)(m_candidates_of_face.size(), m_face_state.size()));
    for(const std::size_t face : m_used_faces)
      m_candidates_of_face[face].clear();
    m_used_faces.clear();
    for(int i = 0; i < n(); ++i)
      for(int j = i + 1; j < n(); ++j)
      {
        if(! is_uncrossed(i, j))
          continue;
        for(int k = j + 1; k < n(); ++k)
        {
          if(! is_uncrossed(i, k) || ! is_uncrossed(j, k) || is_pierced_by_obstacle(i, j, k))
            continue;
          for(int l = k + 1; l < n(); ++l)
            if(is_uncrossed(i, l) && is_uncrossed(j, l) && is_uncrossed(k, l))
              add_candidate(i, j, k, l);
        }
      }
  }

  void find_uncrossed_edges()
  {
    m_is_uncrossed.assign(static_cast<std::size_t>(n()) * n(), false);
    for(int i = 0; i < n(); ++i)
      for(int j = i + 1; j < n(); ++j)
      {
        const Edge e = {{ i, j }};
        const bool is_in_mesh = (state(e) & in_mesh) != 0;
        m_is_uncrossed[i * n() + j] =
             ! any_of(is_in_mesh ? m_foreign_edges : m_obstacle_edges,
                      [&](const Edge& o) { return m_orientations.crosses(e, o); })
          && ! any_of(is_in_mesh ? m_foreign_faces : m_obstacle_faces,
                      [&](const Face& o) { return m_orientations.pierces(e, o); });
      }
  }

  bool is_uncrossed(const int i, const int j) const { return m_is_uncrossed[i * n() + j]; }

  // For i < j < k, computed when first asked for.
  bool is_pierced_by_obstacle(const int i, const int j, const int k)
  {
    const Face f = {{ i, j, k }};
    signed char& is_pierced = m_is_pierced[key(f)];
    if(is_pierced == unknown)
      is_pierced = any_of((state(f) & in_mesh) != 0 ? m_foreign_edges : m_obstacle_edges,
                          [&](const Edge& o) { return m_orientations.pierces(o, f); });
    return is_pierced == 1;
  }

  void add_candidate(const int i, const int j, const int k, const int l)
  {
    const int sign = m_orientations.orientation(i, j, k, l);
    if(sign == 0
       || is_pierced_by_obstacle(i, j, l) || is_pierced_by_obstacle(i, k, l) || is_pierced_by_obstacle(j, k, l))
      return;
    const Candidate c = sign > 0 ? Candidate{{ i, j, k, l }} : Candidate{{ i, k, j, l }};
    const std::array<Face, 4> faces = faces_of(c);
    if(m_orientations.contains_vertex(c, faces))
      return;
    for(const Face& f : faces)
    {
      std::vector<int>& candidates = m_candidates_of_face[key(f)];
      if(candidates.empty())
        m_used_faces.push_back(key(f));
      candidates.push_back(static_cast<int>(m_candidates.size()));
    }
    m_candidates.push_back(c);
  }

  // Faces that differ by a rotation only have the same key, those of opposite orientation another one.
  std::size_t key(const Face& f) const
  {
    const int first = static_cast<int>(std::min_element(f.begin(), f.end()) - f.begin());
    return (static_cast<std::size_t>(f[first]) * n() + f[(first + 1) % 3]) * n() + f[(first + 2) % 3];
  }

  // --- the conflicts ------------------------------------------------------------------------------------------------

  typedef boost::dynamic_bitset<> Candidates; // a set of them

  // An edge or a face of candidates, with those at it and those that cross it.
  template <typename Simplex_>
  struct Crossed_simplex
  {
    Simplex_ simplex;
    Candidates at;       // one of whose edges or faces it is
    Candidates crossing; // one of whose edges or faces crosses it; empty until asked for
  };

  typedef Crossed_simplex<Edge> Crossed_edge;
  typedef Crossed_simplex<Face> Crossed_face;

  void collect_simplices_of_candidates()
  {
    m_edges.clear();
    m_faces.clear();
    m_index_of_edge.assign(m_edge_state.size(), -1);
    m_index_of_face.assign(m_face_state.size(), -1);
    for(std::size_t c = 0; c < m_candidates.size(); ++c)
    {
      for(const Edge& e : edges_of(m_candidates[c]))
        crossed_simplex(e).at.set(c);
      for(const Face& f : faces_of(m_candidates[c]))
        crossed_simplex(f).at.set(c);
    }
  }

  // In whatever order the vertices are given.
  Crossed_edge& crossed_simplex(Edge e)
  {
    std::sort(e.begin(), e.end());
    return crossed_simplex(e, m_index_of_edge[static_cast<std::size_t>(e[0]) * n() + e[1]], m_edges);
  }

  Crossed_face& crossed_simplex(Face f)
  {
    std::sort(f.begin(), f.end());
    return crossed_simplex(f, m_index_of_face[key(f)], m_faces);
  }

  template <typename Simplex_>
  Crossed_simplex<Simplex_>& crossed_simplex(const Simplex_& simplex, int& index,
                                             std::vector<Crossed_simplex<Simplex_> >& simplices) const
  {
    if(index < 0)
    {
      index = static_cast<int>(simplices.size());
      simplices.push_back({ simplex, Candidates(m_candidates.size()), Candidates() });
    }
    return simplices[index];
  }

  // The candidates with an edge or a face that crosses the edge.
  const Candidates& candidates_crossing(Crossed_edge& e)
  {
    if(! e.crossing.empty())
      return e.crossing;
    e.crossing.resize(m_candidates.size());
    for(const Crossed_edge& x : m_edges)
      if(m_orientations.crosses(e.simplex, x.simplex))
        e.crossing |= x.at;
    for(const Crossed_face& x : m_faces)
      if(m_orientations.pierces(e.simplex, x.simplex))
        e.crossing |= x.at;
    return e.crossing;
  }

  // The candidates with an edge that pierces the face.
  const Candidates& candidates_crossing(Crossed_face& f)
  {
    if(! f.crossing.empty())
      return f.crossing;
    f.crossing.resize(m_candidates.size());
    for(const Crossed_edge& x : m_edges)
      if(m_orientations.pierces(x.simplex, f.simplex))
        f.crossing |= x.at;
    return f.crossing;
  }

  // The candidates that cannot be in one tetrahedralization with c, c itself included: those on the same side of a
  // common face, and those with an edge or a face that an edge or a face of c crosses.
  const Candidates& conflicts(const int c)
  {
    Candidates& result = m_conflicts[c];
    if(! result.empty())
      return result;
    m_number_of_conflict_tests += m_candidates.size();
    result.resize(m_candidates.size());
    for(const Edge& e : edges_of(m_candidates[c]))
      result |= candidates_crossing(crossed_simplex(e));
    for(const Face& f : faces_of(m_candidates[c]))
    {
      result |= candidates_crossing(crossed_simplex(f));
      for(const int d : m_candidates_of_face[key(f)])
        result.set(d);
    }
    return result;
  }

  // --- the search ---------------------------------------------------------------------------------------------------

  // Depth-first, without recursion: m_choices is the stack of chosen tetrahedra, each with what is left to try instead.
  struct Choice
  {
    int candidate;
    std::vector<int> alternatives; // tried after this one
    std::vector<Face> front;       // before the choice
    Candidates left;               // before the choice
  };

  Outcome search()
  {
    m_choices.clear();
    m_number_of_steps = 0;
    m_number_of_conflict_tests = 0;
    m_conflicts.assign(m_candidates.size(), Candidates());
    collect_simplices_of_candidates();
    m_left.resize(m_candidates.size());
    m_left.set();
    while(! m_front.empty())
    {
      std::vector<int> options = options_of_hardest_face();
      while(options.empty())
      {
        if(m_choices.empty())
          return NONE;
        options = take_back();
      }
      if(++m_number_of_steps > m_max_number_of_steps || m_number_of_conflict_tests > max_number_of_conflict_tests)
        return GAVE_UP;
      choose(options);
    }
    for(const Choice& choice : m_choices)
    {
      const Candidate& v = m_candidates[choice.candidate];
      m_tetrahedra.push_back({{ vertex(v[0]), vertex(v[1]), vertex(v[2]), vertex(v[3]) }});
    }
    return FOUND;
  }

  // The candidates on the front face that has the fewest.
  std::vector<int> options_of_hardest_face() const
  {
    std::vector<int> fewest, options;
    bool is_first = true;
    for(const Face& f : m_front)
    {
      options.clear();
      for(const int c : m_candidates_of_face[key(f)])
        if(m_left.test(c))
          options.push_back(c);
      if(is_first || options.size() < fewest.size())
        fewest.swap(options);
      is_first = false;
      if(fewest.empty())
        break;
    }
    return fewest;
  }

  void choose(std::vector<int>& options)
  {
    Choice choice;
    choice.candidate = options.front();
    choice.alternatives.assign(options.begin() + 1, options.end());
    choice.front = m_front;
    choice.left = m_left;
    for(const Face& f : faces_of(m_candidates[choice.candidate]))
    {
      const auto it = std::find_if(m_front.begin(), m_front.end(), [&](const Face& g) { return key(g) == key(f); });
      if(it != m_front.end())
        m_front.erase(it);
      else
        m_front.push_back(Face{{ f[0], f[2], f[1] }}); // to be filled on its other side
    }
    m_left -= conflicts(choice.candidate);
    m_choices.push_back(std::move(choice));
  }

  // Undoes the last choice and returns its alternatives.
  std::vector<int> take_back()
  {
    Choice choice = std::move(m_choices.back());
    m_choices.pop_back();
    m_front = std::move(choice.front);
    m_left = std::move(choice.left);
    return std::move(choice.alternatives);
  }

  Orientations m_orientations;
  std::size_t m_max_number_of_steps = default_max_number_of_steps;
  std::size_t m_number_of_steps = 0;
  std::size_t m_number_of_conflict_tests = 0;
  std::vector<Edge> m_obstacle_edges;
  std::vector<Face> m_obstacle_faces;
  std::vector<Edge> m_foreign_edges; // the obstacles that are not in the mesh
  std::vector<Face> m_foreign_faces;
  static constexpr signed char in_mesh = 1, obstacle = 2;
  std::vector<signed char> m_edge_state, m_face_state;
  static constexpr signed char unknown = -1;
  std::vector<char> m_is_uncrossed;
  std::vector<signed char> m_is_pierced;
  std::vector<Candidate> m_candidates;
  std::vector<std::vector<int> > m_candidates_of_face;
  std::vector<std::size_t> m_used_faces; // with a candidate
  std::vector<Crossed_edge> m_edges; // those of candidates
  std::vector<Crossed_face> m_faces;
  std::vector<int> m_index_of_edge, m_index_of_face; // in these
  std::vector<Candidates> m_conflicts; // of each candidate, computed when first asked for
  Candidates m_left;                   // those that cross no chosen one
  std::vector<Face> m_front;
  std::vector<Choice> m_choices;
  std::vector<Tetrahedron> m_tetrahedra;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SMALL_POLYHEDRON_RECONNECTION_3_H

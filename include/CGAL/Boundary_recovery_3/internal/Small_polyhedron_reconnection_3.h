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

#include <CGAL/Boundary_recovery_3/internal/Simplex_key_3.h>
#include <CGAL/Boundary_recovery_3/internal/Vertex_predicates_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
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
 * All geometry is read off the table of the orientations of all quadruples of vertices. Candidates are the tetrahedra
 * that contain no other vertex and neither cross the boundary of the polyhedron nor a required simplex. The
 * search takes the face of the front that has the fewest candidates left, tries them, and after each choice drops the
 * candidates that cross it: a face with none left ends the branch.
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

  static constexpr std::size_t max_number_of_vertices = 28;
  static constexpr std::size_t default_max_number_of_steps = 2000;
  static constexpr std::size_t max_number_of_conflict_tests = 50000;

  explicit Small_polyhedron_reconnection_3(const Predicates& predicates) : m_predicates(predicates) { }

  // Bound on the number of tetrahedra that are tried in one search.
  void set_max_number_of_steps(const std::size_t n) { m_max_number_of_steps = n; }

  // `cells` are finite cells whose union is a polyhedron; `edges` and `facets` are arrays of vertices of these cells,
  // of simplices inside the polyhedron. `superfluous`, if given, is a vertex inside that is not to be used.
  template <typename CellRange, typename EdgeRange, typename FacetRange>
  Outcome operator()(const CellRange& cells, const EdgeRange& edges, const FacetRange& facets,
                     const Vertex_handle superfluous = Vertex_handle())
  {
    m_tetrahedra.clear();
    collect_vertices(cells, superfluous);
    if(m_vertices.size() > max_number_of_vertices)
      return GAVE_UP;
    fill_in_orientations();
    collect_boundary(cells);
    collect_required(edges, facets);
    collect_candidates();
    return search();
  }

  // The tetrahedra found, positively oriented.
  const std::vector<Tetrahedron>& tetrahedra() const { return m_tetrahedra; }

private:
  typedef std::array<int, 2> Edge;
  typedef std::array<int, 3> Face;

  struct Candidate
  {
    std::array<int, 4> v; // positively oriented
    int number_of_conflicts = 0; // number of chosen tetrahedra that it crosses
  };

  // --- the geometry, by positions in m_vertices ---------------------------------------------------------------------

  int n() const { return static_cast<int>(m_vertices.size()); }

  template <typename Range, typename Predicate>
  static bool any_of(const Range& range, const Predicate& predicate)
  {
    return std::any_of(range.begin(), range.end(), predicate);
  }

  template <typename CellRange>
  void collect_vertices(const CellRange& cells, const Vertex_handle superfluous)
  {
    m_vertices.clear();
    for(const Cell_handle c : cells)
      for(int i = 0; i < 4; ++i)
        if(c->vertex(i) != superfluous
           && std::find(m_vertices.begin(), m_vertices.end(), c->vertex(i)) == m_vertices.end())
          m_vertices.push_back(c->vertex(i));
  }

  int position(const Vertex_handle v) const
  {
    return static_cast<int>(std::find(m_vertices.begin(), m_vertices.end(), v) - m_vertices.begin());
  }

  // The orientations of all quadruples, in every order, for look-ups without sorting.
  void fill_in_orientations()
  {
    const std::size_t size = m_vertices.size();
    m_orientations.assign(size * size * size * size, 0);
    for(int i = 0; i < n(); ++i)
      for(int j = i + 1; j < n(); ++j)
        for(int k = j + 1; k < n(); ++k)
          for(int l = k + 1; l < n(); ++l)
            store_orientations({{ i, j, k, l }}, static_cast<signed char>(
              m_predicates.orientation(m_vertices[i], m_vertices[j], m_vertices[k], m_vertices[l])));
  }

  // For the even and the odd permutations of v; the last two are swapped to come from one to the other.
  void store_orientations(const std::array<int, 4>& v, const signed char sign)
  {
    static constexpr int even[12][4] = { {0,1,2,3}, {0,2,3,1}, {0,3,1,2}, {1,0,3,2}, {1,2,0,3}, {1,3,2,0},
                                         {2,0,1,3}, {2,1,3,0}, {2,3,0,1}, {3,0,2,1}, {3,1,0,2}, {3,2,1,0} };
    for(const auto& p : even)
    {
      m_orientations[offset(v[p[0]], v[p[1]], v[p[2]], v[p[3]])] = sign;
      m_orientations[offset(v[p[0]], v[p[1]], v[p[3]], v[p[2]])] = static_cast<signed char>(-sign);
    }
  }

  std::size_t offset(const int i, const int j, const int k, const int l) const
  {
    return ((static_cast<std::size_t>(i) * n() + j) * n() + k) * n() + l;
  }

  int orientation(const int i, const int j, const int k, const int l) const
  {
    return m_orientations[offset(i, j, k, l)];
  }

  bool crosses(const Edge& e, const Edge& f) const
  {
    if(e[0] == f[0] || e[0] == f[1] || e[1] == f[0] || e[1] == f[1] || orientation(e[0], e[1], f[0], f[1]) != 0)
      return false;
    // Coplanar: seen from any vertex off their plane, each edge has the ends of the other on opposite sides.
    for(int w = 0; w < n(); ++w)
    {
      const int s = orientation(e[0], e[1], f[0], w), t = orientation(e[0], e[1], f[1], w);
      const int x = orientation(f[0], f[1], e[0], w), y = orientation(f[0], f[1], e[1], w);
      if(s != 0 || t != 0 || x != 0 || y != 0)
        return s * t < 0 && x * y < 0;
    }
    return false;
  }

  bool pierces(const Edge& e, const Face& f) const
  {
    const int side = orientation(e[0], e[1], f[0], f[1]);
    return side != 0
        && orientation(e[0], e[1], f[1], f[2]) == side
        && orientation(e[0], e[1], f[2], f[0]) == side
        && orientation(f[0], f[1], f[2], e[0]) * orientation(f[0], f[1], f[2], e[1]) < 0;
  }

  static std::array<Edge, 6> edges_of(const std::array<int, 4>& v)
  {
    return {{ {{ v[0], v[1] }}, {{ v[0], v[2] }}, {{ v[0], v[3] }},
              {{ v[1], v[2] }}, {{ v[1], v[3] }}, {{ v[2], v[3] }} }};
  }

  // The faces, each with the tetrahedron on its positive side.
  static std::array<Face, 4> faces_of(const std::array<int, 4>& v)
  {
    return {{ {{ v[0], v[1], v[2] }}, {{ v[0], v[3], v[1] }}, {{ v[0], v[2], v[3] }}, {{ v[1], v[3], v[2] }} }};
  }

  // --- the polyhedron ----------------------------------------------------------------------------------------------

  // The outer faces, with the polyhedron on their positive side: the first front of the search.
  template <typename CellRange>
  void collect_boundary(const CellRange& cells)
  {
    m_front.clear();
    m_obstacle_edges.clear();
    m_obstacle_faces.clear();
    for(const Cell_handle c : cells)
      for(int i = 0; i < 4; ++i)
        if(std::find(cells.begin(), cells.end(), c->neighbor(i)) == cells.end())
        {
          Face f;
          for(int k = 0; k < 3; ++k)
            f[k] = position(c->vertex(Tr::vertex_triple_index(i, k)));
          m_front.push_back(f);
          add_obstacle(f);
        }
  }

  template <typename EdgeRange, typename FacetRange>
  void collect_required(const EdgeRange& edges, const FacetRange& facets)
  {
    for(const auto& e : edges)
      add_obstacle(Edge{{ position(e[0]), position(e[1]) }});
    for(const auto& f : facets)
      add_obstacle(Face{{ position(f[0]), position(f[1]), position(f[2]) }});
  }

  // What must be in the result, because it is on the boundary or required, must not be crossed.
  // That suffices: an edge inside the polyhedron, between two of its vertices, that nothing crosses is in every
  // tetrahedralization.
  void add_obstacle(Edge e)
  {
    std::sort(e.begin(), e.end());
    if(std::find(m_obstacle_edges.begin(), m_obstacle_edges.end(), e) == m_obstacle_edges.end())
      m_obstacle_edges.push_back(e);
  }

  void add_obstacle(const Face& f)
  {
    m_obstacle_faces.push_back(f);
    for(int i = 0; i < 3; ++i)
      add_obstacle(Edge{{ f[i], f[(i + 1) % 3] }});
  }

  // --- the candidates ------------------------------------------------------------------------------------------------

  void collect_candidates()
  {
    find_uncrossed_edges();
    m_is_pierced.assign(static_cast<std::size_t>(n()) * n() * n(), unknown);
    m_candidates.clear();
    m_candidates_of_face.resize((std::max)(m_candidates_of_face.size(), static_cast<std::size_t>(n()) * n() * n()));
    for(std::vector<int>& candidates : m_candidates_of_face)
      candidates.clear();
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
        m_is_uncrossed[i * n() + j] =
             ! any_of(m_obstacle_edges, [&](const Edge& o) { return crosses(e, o); })
          && ! any_of(m_obstacle_faces, [&](const Face& o) { return pierces(e, o); });
      }
  }

  bool is_uncrossed(const int i, const int j) const { return m_is_uncrossed[i * n() + j]; }

  // For i < j < k, computed when first asked for.
  bool is_pierced_by_obstacle(const int i, const int j, const int k)
  {
    const Face f = {{ i, j, k }};
    signed char& state = m_is_pierced[key(f)];
    if(state == unknown)
      state = any_of(m_obstacle_edges, [&](const Edge& o) { return pierces(o, f); });
    return state == 1;
  }

  void add_candidate(const int i, const int j, const int k, const int l)
  {
    const int sign = orientation(i, j, k, l);
    if(sign == 0
       || is_pierced_by_obstacle(i, j, l) || is_pierced_by_obstacle(i, k, l) || is_pierced_by_obstacle(j, k, l))
      return;
    Candidate c;
    c.v = sign > 0 ? std::array<int, 4>{{ i, j, k, l }} : std::array<int, 4>{{ i, k, j, l }};
    const std::array<Face, 4> faces = faces_of(c.v);
    for(int w = 0; w < n(); ++w)
      if(contains(faces, c.v, w))
        return;
    for(const Face& f : faces)
      m_candidates_of_face[key(f)].push_back(static_cast<int>(m_candidates.size()));
    m_candidates.push_back(c);
  }

  // Whether w is in the closed tetrahedron, but not one of its vertices.
  bool contains(const std::array<Face, 4>& faces, const std::array<int, 4>& v, const int w) const
  {
    if(std::find(v.begin(), v.end(), w) != v.end())
      return false;
    return std::all_of(faces.begin(), faces.end(),
                       [&](const Face& f) { return orientation(f[0], f[1], f[2], w) >= 0; });
  }

  // Faces that differ by a rotation only have the same key, those of opposite orientation another one.
  std::size_t key(const Face& f) const
  {
    const int first = static_cast<int>(std::min_element(f.begin(), f.end()) - f.begin());
    return (static_cast<std::size_t>(f[first]) * n() + f[(first + 1) % 3]) * n() + f[(first + 2) % 3];
  }

  // The candidates that cannot be in one tetrahedralization with c, c itself included: those on the same side of a
  // common face, and those with an edge or a face that an edge or a face of c crosses.
  std::vector<int> find_conflicts(const Candidate& c)
  {
    const std::array<Edge, 6> edges = edges_of(c.v);
    const std::array<Face, 4> faces = faces_of(c.v);
    m_is_edge_crossed.assign(m_is_uncrossed.size(), unknown);
    m_is_face_crossed.assign(m_is_pierced.size(), unknown);
    std::vector<int> result;
    for(std::size_t d = 0; d < m_candidates.size(); ++d)
    {
      const Candidate& other = m_candidates[d];
      if(any_of(edges_of(other.v), [&](const Edge& e) { return is_crossed(e, edges, faces); })
         || any_of(faces_of(other.v), [&](const Face& f) { return is_crossed(f, edges, faces); }))
        result.push_back(static_cast<int>(d));
    }
    return result;
  }

  bool is_crossed(Edge e, const std::array<Edge, 6>& edges, const std::array<Face, 4>& faces)
  {
    std::sort(e.begin(), e.end());
    signed char& state = m_is_edge_crossed[e[0] * n() + e[1]];
    if(state == unknown)
      state = any_of(edges, [&](const Edge& x) { return crosses(e, x); })
           || any_of(faces, [&](const Face& x) { return pierces(e, x); });
    return state == 1;
  }

  bool is_crossed(const Face& f, const std::array<Edge, 6>& edges, const std::array<Face, 4>& faces)
  {
    signed char& state = m_is_face_crossed[key(f)];
    if(state == unknown)
      state = any_of(faces, [&](const Face& x) { return key(x) == key(f); })
           || any_of(edges, [&](const Edge& x) { return pierces(x, f); });
    return state == 1;
  }

  // --- the search
  // ------------------------------------------------------------------------------------------------------

  // Depth-first, without recursion: m_choices is the stack of chosen tetrahedra, each with what is left to try instead.
  struct Choice
  {
    int candidate;
    std::vector<int> alternatives; // tried after this one
    std::vector<Face> front;       // before the choice
  };

  Outcome search()
  {
    m_choices.clear();
    m_number_of_steps = 0;
    m_number_of_conflict_tests = 0;
    m_conflicts.assign(m_candidates.size(), std::vector<int>());
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
      const std::array<int, 4>& v = m_candidates[choice.candidate].v;
      m_tetrahedra.push_back({{ m_vertices[v[0]], m_vertices[v[1]], m_vertices[v[2]], m_vertices[v[3]] }});
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
        if(m_candidates[c].number_of_conflicts == 0)
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
    const Candidate& c = m_candidates[choice.candidate];
    for(const Face& f : faces_of(c.v))
    {
      const auto it = std::find_if(m_front.begin(), m_front.end(), [&](const Face& g) { return key(g) == key(f); });
      if(it != m_front.end())
        m_front.erase(it);
      else
        m_front.push_back(Face{{ f[0], f[2], f[1] }}); // to be filled on its other side
    }
    for(const int d : conflicts(choice.candidate))
      ++m_candidates[d].number_of_conflicts;
    m_choices.push_back(std::move(choice));
  }

  // Undoes the last choice and returns its alternatives.
  std::vector<int> take_back()
  {
    Choice choice = std::move(m_choices.back());
    m_choices.pop_back();
    for(const int d : conflicts(choice.candidate))
      --m_candidates[d].number_of_conflicts;
    m_front = std::move(choice.front);
    return std::move(choice.alternatives);
  }

  // The candidates in conflict with c, itself included.
  const std::vector<int>& conflicts(const int c)
  {
    std::vector<int>& list = m_conflicts[c];
    if(! list.empty())
      return list;
    m_number_of_conflict_tests += m_candidates.size();
    list = find_conflicts(m_candidates[c]);
    return list;
  }

  const Predicates& m_predicates;
  std::size_t m_max_number_of_steps = default_max_number_of_steps;
  std::size_t m_number_of_steps = 0;
  std::size_t m_number_of_conflict_tests = 0;
  std::vector<Vertex_handle> m_vertices;
  std::vector<signed char> m_orientations;
  std::vector<Edge> m_obstacle_edges;
  std::vector<Face> m_obstacle_faces;
  static constexpr signed char unknown = -1;
  std::vector<char> m_is_uncrossed;
  std::vector<signed char> m_is_pierced;
  std::vector<signed char> m_is_edge_crossed, m_is_face_crossed; // by one candidate
  std::vector<Candidate> m_candidates;
  std::vector<std::vector<int> > m_candidates_of_face;
  std::vector<std::vector<int> > m_conflicts; // computed when first asked for
  std::vector<Face> m_front;
  std::vector<Choice> m_choices;
  std::vector<Tetrahedron> m_tetrahedra;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SMALL_POLYHEDRON_RECONNECTION_3_H

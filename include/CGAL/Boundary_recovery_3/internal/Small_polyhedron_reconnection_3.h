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

#include <CGAL/Boundary_recovery_3/internal/Vertex_predicates_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
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
 * All geometry is read off a table of the orientations of all quadruples of vertices. Candidates are the tetrahedra
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

  // Forgets the last polyhedron, of which the orientations that are still of use in the next one are kept. To be called
  // if vertices moved.
  void forget()
  {
    m_vertices.clear();
  }

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
  typedef std::array<int, 2> Edge;
  typedef std::array<int, 3> Face;

  struct Candidate
  {
    std::array<int, 4> v;     // positively oriented
    std::array<int, 6> edges; // positions in m_is_edge_crossed
    std::array<int, 4> faces; // keys
    int number_of_conflicts = 0; // number of chosen tetrahedra that it crosses
  };

  // --- the geometry, by positions in m_vertices ---------------------------------------------------------------------

  int n() const { return static_cast<int>(m_vertices.size()); }

  template <typename Range, typename Predicate>
  static bool any_of(const Range& range, const Predicate& predicate)
  {
    return std::any_of(range.begin(), range.end(), predicate);
  }

  // Returns false if there are too many. Orientations are kept as far as the vertices are the same as in the last
  // polyhedron.
  template <typename CellRange>
  bool collect_vertices(const CellRange& cells, const Vertex_handle superfluous)
  {
    m_previous_vertices.swap(m_vertices);
    m_vertices.clear();
    for(const Cell_handle c : cells)
      for(int i = 0; i < 4; ++i)
        if(c->vertex(i) != superfluous
           && std::find(m_vertices.begin(), m_vertices.end(), c->vertex(i)) == m_vertices.end())
          m_vertices.push_back(c->vertex(i));
    if(m_vertices.size() > max_number_of_vertices)
    {
      forget();
      return false;
    }
    int same = 0;
    while(same < n() && same < static_cast<int>(m_previous_vertices.size())
          && m_vertices[same] == m_previous_vertices[same])
      ++same;
    fill_in_sides(same);
    return true;
  }

  int position(const Vertex_handle v) const
  {
    return static_cast<int>(std::find(m_vertices.begin(), m_vertices.end(), v) - m_vertices.begin());
  }

  // The vertices on the positive and on the negative side of a face, as bits.
  struct Sides
  {
    std::uint32_t positive = 0, negative = 0;
  };

  static std::uint32_t bit(const int i) { return std::uint32_t(1) << i; }

  Sides& sides(const int i, const int j, const int k) { return m_sides[offset(i, j, k)]; }
  const Sides& sides(const int i, const int j, const int k) const { return m_sides[offset(i, j, k)]; }
  const Sides& sides(const Face& f) const { return sides(f[0], f[1], f[2]); }

  // Does not depend on the number of vertices, so that entries stay where they are.
  static std::size_t offset(const int i, const int j, const int k)
  {
    return (static_cast<std::size_t>(i) * max_number_of_vertices + j) * max_number_of_vertices + k;
  }

  // Orients all the quadruples; those of the first `known` vertices are known.
  void fill_in_sides(const int known)
  {
    m_sides.resize(max_number_of_vertices * max_number_of_vertices * max_number_of_vertices);
    for(int k = known; k < n(); ++k)
      for(int j = 0; j < k; ++j)
        for(int i = 0; i < j; ++i)
          sides(i, j, k) = Sides();
    const std::uint32_t known_bits = bit(known) - 1;
    for(int k = 0; k < known; ++k)
      for(int j = 0; j < k; ++j)
        for(int i = 0; i < j; ++i)
        {
          sides(i, j, k).positive &= known_bits;
          sides(i, j, k).negative &= known_bits;
        }
    for(int l = known; l < n(); ++l)
      for(int k = 0; k < l; ++k)
        for(int j = 0; j < k; ++j)
          for(int i = 0; i < j; ++i)
            store_orientation(i, j, k, l);
    copy_sides_to_permutations();
  }

  void store_orientation(const int i, const int j, const int k, const int l)
  {
    const Orientation o = m_predicates.orientation(m_vertices[i], m_vertices[j], m_vertices[k], m_vertices[l]);
    if(o == ZERO)
      return;
    std::uint32_t Sides::* const even = o == POSITIVE ? &Sides::positive : &Sides::negative;
    std::uint32_t Sides::* const odd = o == POSITIVE ? &Sides::negative : &Sides::positive;
    sides(i, j, k).*even |= bit(l);
    sides(i, j, l).*odd |= bit(k);
    sides(i, k, l).*even |= bit(j);
    sides(j, k, l).*odd |= bit(i);
  }

  void copy_sides_to_permutations()
  {
    for(int k = 0; k < n(); ++k)
      for(int j = 0; j < k; ++j)
        for(int i = 0; i < j; ++i)
        {
          const Sides s = sides(i, j, k);
          Sides reversed;
          reversed.positive = s.negative;
          reversed.negative = s.positive;
          sides(j, k, i) = sides(k, i, j) = s;
          sides(j, i, k) = sides(i, k, j) = sides(k, j, i) = reversed;
        }
  }

  // For distinct i, j, k; 0 if l is one of them.
  int orientation(const int i, const int j, const int k, const int l) const
  {
    const Sides& s = sides(i, j, k);
    return static_cast<int>((s.positive >> l) & 1) - static_cast<int>((s.negative >> l) & 1);
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
    const Sides& s = sides(f);
    if(((((s.positive >> e[0]) & (s.negative >> e[1])) | ((s.negative >> e[0]) & (s.positive >> e[1]))) & 1) == 0)
      return false; // both ends on the same side, or one of them in the plane
    const int side = orientation(e[0], e[1], f[0], f[1]);
    return side != 0
        && orientation(e[0], e[1], f[1], f[2]) == side
        && orientation(e[0], e[1], f[2], f[0]) == side;
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
        if(std::find(cells.begin(), cells.end(), c->neighbor(i)) == cells.end())
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
             ! any_of(is_in_mesh ? m_foreign_edges : m_obstacle_edges, [&](const Edge& o) { return crosses(e, o); })
          && ! any_of(is_in_mesh ? m_foreign_faces : m_obstacle_faces, [&](const Face& o) { return pierces(e, o); });
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
                          [&](const Edge& o) { return pierces(o, f); });
    return is_pierced == 1;
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
    if(contains_vertex(faces, c.v))
      return;
    const std::array<Edge, 6> edges = edges_of(c.v);
    for(int e = 0; e < 6; ++e)
      c.edges[e] = (std::min)(edges[e][0], edges[e][1]) * n() + (std::max)(edges[e][0], edges[e][1]);
    for(int f = 0; f < 4; ++f)
      c.faces[f] = static_cast<int>(key(faces[f]));
    for(const Face& f : faces)
    {
      std::vector<int>& candidates = m_candidates_of_face[key(f)];
      if(candidates.empty())
        m_used_faces.push_back(key(f));
      candidates.push_back(static_cast<int>(m_candidates.size()));
    }
    m_candidates.push_back(c);
  }

  // Whether a vertex is in the closed tetrahedron that is not one of its own.
  bool contains_vertex(const std::array<Face, 4>& faces, const std::array<int, 4>& v) const
  {
    std::uint32_t outside = bit(v[0]) | bit(v[1]) | bit(v[2]) | bit(v[3]);
    for(const Face& f : faces)
      outside |= sides(f).negative;
    return outside != bit(n()) - 1;
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
      bool is_in_conflict = false;
      const std::array<Edge, 6> other_edges = edges_of(other.v);
      for(int e = 0; e < 6 && ! is_in_conflict; ++e)
        is_in_conflict = is_crossed(other_edges[e], m_is_edge_crossed[other.edges[e]], edges, faces);
      const std::array<Face, 4> other_faces = faces_of(other.v);
      for(int f = 0; f < 4 && ! is_in_conflict; ++f)
        is_in_conflict = is_crossed(other_faces[f], m_is_face_crossed[other.faces[f]], edges, c.faces, other.faces[f]);
      if(is_in_conflict)
        result.push_back(static_cast<int>(d));
    }
    return result;
  }

  // `state` is what is known of it.
  bool is_crossed(const Edge& e, signed char& state, const std::array<Edge, 6>& edges,
                  const std::array<Face, 4>& faces) const
  {
    if(state == unknown)
      state = any_of(edges, [&](const Edge& x) { return crosses(e, x); })
           || any_of(faces, [&](const Face& x) { return pierces(e, x); });
    return state == 1;
  }

  // Or is the same face, seen from the same side.
  bool is_crossed(const Face& f, signed char& state, const std::array<Edge, 6>& edges,
                  const std::array<int, 4>& face_keys, const int key) const
  {
    if(state == unknown)
      state = std::find(face_keys.begin(), face_keys.end(), key) != face_keys.end()
           || any_of(edges, [&](const Edge& x) { return pierces(x, f); });
    return state == 1;
  }

  // --- the search ---------------------------------------------------------------------------------------------------

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
  std::vector<Vertex_handle> m_previous_vertices;
  std::vector<Sides> m_sides; // by ordered triples
  std::vector<Edge> m_obstacle_edges;
  std::vector<Face> m_obstacle_faces;
  std::vector<Edge> m_foreign_edges; // the obstacles that are not in the mesh
  std::vector<Face> m_foreign_faces;
  static constexpr signed char in_mesh = 1, obstacle = 2;
  std::vector<signed char> m_edge_state, m_face_state;
  static constexpr signed char unknown = -1;
  std::vector<char> m_is_uncrossed;
  std::vector<signed char> m_is_pierced;
  std::vector<signed char> m_is_edge_crossed, m_is_face_crossed; // by one candidate
  std::vector<Candidate> m_candidates;
  std::vector<std::vector<int> > m_candidates_of_face;
  std::vector<std::size_t> m_used_faces; // with a candidate
  std::vector<std::vector<int> > m_conflicts; // computed when first asked for
  std::vector<Face> m_front;
  std::vector<Choice> m_choices;
  std::vector<Tetrahedron> m_tetrahedra;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SMALL_POLYHEDRON_RECONNECTION_3_H

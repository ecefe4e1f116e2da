// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_SHELL_TRANSFORMATION_3_H
#define CGAL_SHELL_TRANSFORMATION_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Meshing_visitor_3.h>
#include <CGAL/Boundary_recovery_3/Shell_3.h>
#include <CGAL/Boundary_recovery_3/Shell_quality_3.h>
#include <CGAL/Boundary_recovery_3/Shell_validity_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Replace_cells.h>
#include <CGAL/Boundary_recovery_3/internal/shell/Covering_mesh_search_3.h>
#include <CGAL/Boundary_recovery_3/internal/shell/Failed_edge_removals_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <CGAL/assertions.h>
#include <CGAL/enum.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <ostream>
#include <utility>

namespace CGAL {

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief the shell transformation, and its recursive use to remove an edge or a facet from a triangulation.
 *
 * The cells around an edge `ab` are the covering mesh of its shell. A shell transformation replaces them by a better
 * covering mesh, which belongs to a partial triangulation of the skirt polygon. The quality tells which covering mesh
 * is better, and the validity which one is allowed. In any case, all new cells are positively oriented, by an exact
 * predicate, and the convex hull stays as it is. Source: [CZZ+17, Sections 2 and 3].
 *
 * The triangulation is changed in place and is in general no longer Delaunay. Vertices keep their handles. Replaced
 * cells are destroyed; the visitor is told before and after, so that data of cells can be carried over.
 *
 * \tparam Tr an instance of `CGAL::Triangulation_3`, or of a class derived from it. It must be 3-dimensional.
 * \tparam Quality a model of `ShellQuality_3`
 * \tparam Validity a model of `ShellValidity_3`
 * \tparam Visitor a model of `MeshingVisitor_3`; only the replacement of cells is announced
 */
template <typename Tr,
          typename Quality_ = Boundary_recovery_3::Worst_element_quality_3<Tr>,
          typename Validity_ = Boundary_recovery_3::No_shell_validity_3,
          typename Visitor_ = Default_meshing_visitor_3>
class Shell_transformation_3
{
public:
  typedef Tr       Triangulation; ///< the triangulation type
  typedef Quality_ Quality;       ///< the quality type
  typedef Validity_ Validity;     ///< the validity type
  typedef Visitor_ Visitor;       ///< the visitor type
  typedef Boundary_recovery_3::Shell_3<Tr>  Shell; ///< the shell type
  typedef typename Tr::Vertex_handle Vertex_handle; ///< the vertex handle of the triangulation
  typedef typename Tr::Cell_handle   Cell_handle;   ///< the cell handle of the triangulation
  typedef typename Tr::Edge          Edge;          ///< the edge of the triangulation
  typedef typename Tr::Facet         Facet;         ///< the facet of the triangulation

  /// shells of a larger degree are left alone.
  static constexpr int max_degree = 24;

  /// default bound on the number of shells visited in one call of `remove_edge()` or `remove_facet()`, 300.
  static constexpr std::size_t default_max_number_of_shells = 300;

  /// the outcome of a shell transformation
  enum Outcome
  {
    UNCHANGED, ///< the covering mesh is the best one already, or no other one is allowed
    REDUCED,   ///< the degree of the shell is smaller now
    REMOVED    ///< the supporting edge is gone
  };

  /// returns the name of an outcome, as it is spelled in the enumeration.
  friend const char* to_string(const Outcome outcome)
  {
    switch(outcome)
    {
      case UNCHANGED: return "UNCHANGED";
      case REDUCED:   return "REDUCED";
      case REMOVED:   return "REMOVED";
    }
    return "";
  }

  /// writes the name of an outcome.
  friend std::ostream& operator<<(std::ostream& os, const Outcome outcome) { return os << to_string(outcome); }

  /*!
   * \param tr the triangulation to change
   * \param quality which covering mesh is better
   * \param validity which covering meshes are allowed
   * \param visitor the visitor, which is told of old and new cells. It must outlive this object.
   */
  Shell_transformation_3(Tr& tr, const Quality& quality, const Validity& validity, Visitor& visitor)
    : m_tr(tr), m_predicates(tr), m_quality(quality), m_validity(validity), m_visitor(&visitor)
  { }

  /// as above, with a visitor that does nothing.
  Shell_transformation_3(Tr& tr, const Quality& quality, const Validity& validity = Validity())
    : m_tr(tr), m_predicates(tr), m_quality(quality), m_validity(validity), m_visitor(&m_no_visitor)
  { }

#ifndef DOXYGEN_RUNNING
  // As above, without a validity, for only removals that are given one, and with predicates that may know the exact
  // positions of some vertices. Removals that failed at the same shell are not tried again, whatever was allowed then.
  Shell_transformation_3(Tr& tr, const Quality& quality, Visitor& visitor,
                         const Boundary_recovery_3::internal::Vertex_predicates_3<Tr>& predicates)
    : m_tr(tr), m_predicates(predicates), m_quality(quality), m_visitor(&visitor), m_failed_removals(std::in_place)
  { }
#endif

  Shell_transformation_3(const Shell_transformation_3&) = delete;
  Shell_transformation_3& operator=(const Shell_transformation_3&) = delete;

  /*!
   * transforms the shell of an edge once [CZZ+17, Alg.\ 3].
   *
   * \param e the supporting edge. An edge at the infinite vertex, and a constrained edge that cannot be kept, are left
   *        alone.
   * \param p a vertex: the face of `e` and `p` is to be avoided; none if `p` is the default handle
   *
   * \return the outcome; `UNCHANGED` also if there is no such face
   *
   * \pre `tr.dimension() == 3`
   */
  Outcome operator()(const Edge& e, const Vertex_handle p = Vertex_handle())
  {
    CGAL_precondition(m_tr.dimension() == 3);
    const Vertex_handle a = e.first->vertex(e.second), b = e.first->vertex(e.third);
    if(m_tr.is_infinite(a) || m_tr.is_infinite(b))
      return UNCHANGED;
    m_validity_of_call = &validity();
    const Supporting_edge root(a, b, e.first, nullptr, *m_validity_of_call);
    const Shell shell(m_tr, e.first, e.second, e.third);
    const int f = p == Vertex_handle() ? Shell::none : shell.index(p);
    return p != Vertex_handle() && f == Shell::none ? UNCHANGED : transform(shell, root, Ancestors(shell, nullptr), f);
  }

  /*!
   * removes an edge by recursive shell transformations [CZZ+17, Alg.\ 1].
   *
   * \param e the edge
   * \param l_max the maximal recursion level; 0: only the shell of `e` itself is transformed
   *
   * \return whether the edge is gone. If not, cells may have been replaced all the same.
   *
   * \pre `tr.dimension() == 3`
   */
  bool remove_edge(const Edge& e, const int l_max) { return remove_edge(e, l_max, validity()); }

  /// as above, with the condition `validity` instead of the condition of this object.
  bool remove_edge(const Edge& e, const int l_max, const Validity& validity)
  {
    m_validity_of_call = &validity;
    return remove_root(e.first->vertex(e.second), e.first->vertex(e.third), Vertex_handle(), e.first, l_max,
                       m_max_number_of_shells);
  }

  /*!
   * removes a facet by recursive shell transformations around its edges, one after the other [CZZ+17, Alg.\ 4, lines 8
   * to 11].
   *
   * \param f the facet
   * \param l_max the maximal recursion level; 0: only the shells of the edges of `f` are transformed
   *
   * \return whether the facet is gone. If not, cells may have been replaced all the same.
   *
   * \pre `tr.dimension() == 3`
   */
  bool remove_facet(const Facet& f, const int l_max) { return remove_facet(f, l_max, validity()); }

  /// as above, with the condition `validity` instead of the condition of this object.
  bool remove_facet(const Facet& f, const int l_max, const Validity& validity)
  {
    const std::array<Vertex_handle, 3> v = {{ f.first->vertex((f.second + 1) & 3),
                                              f.first->vertex((f.second + 2) & 3),
                                              f.first->vertex((f.second + 3) & 3) }};
    CGAL_precondition(m_tr.dimension() == 3);
    if(validity.is_constrained(v[0], v[1], v[2]))
      return false;
    m_validity_of_call = &validity;
    bool was_cut_off = false;
    Cell_handle c = f.first;
    for(int i = 0; i < 3; ++i)
    {
      if(remove_root(v[i], v[(i + 1) % 3], v[(i + 2) % 3], c, l_max, (m_max_number_of_shells + 2) / 3))
        return true;
      was_cut_off |= m_was_cut_off;
      // The facet is still there, but its cells may have been replaced.
      const Shell shell(m_tr, m_root_cell, m_root_cell->index(v[i]), m_root_cell->index(v[(i + 1) % 3]));
      c = shell.cell(shell.index(v[(i + 2) % 3]));
    }
    m_was_cut_off = was_cut_off;
    return false;
  }

  /// sets the bound on the number of shells visited in one call of `remove_edge()` or `remove_facet()`. Each edge of a
  /// facet has a third of it.
  void set_max_number_of_shells(const std::size_t n) { m_max_number_of_shells = n; }

  /// returns the number of replaced covering meshes so far.
  std::size_t number_of_transformations() const { return m_number_of_transformations; }

  /// returns the number of shells visited so far, in all removals.
  std::size_t number_of_shells() const { return m_total_number_of_shells + m_number_of_shells; }

  /// returns whether the last removal was cut off by the recursion level or by the bound on the number of shells.
  bool was_cut_off() const { return m_was_cut_off; }

  /// returns the triangulation.
  Triangulation& triangulation() { return m_tr; }

  /// returns the validity.
  Validity& validity() { return *m_validity; }

  /// returns the quality.
  Quality& quality() { return m_quality; }

private:
  typedef Boundary_recovery_3::internal::Replace_cells<Tr>  Replace_cells;
  typedef typename Replace_cells::Tetrahedron               Tetrahedron;

  // A node of the edge tree of [CZZ+17, Section 2.2], with its way up to the root.
  // `cell` is one of the cells around the edge; it is kept up to date while cells are replaced.
  struct Supporting_edge
  {
    Supporting_edge(const Vertex_handle a, const Vertex_handle b, const Cell_handle cell, const Supporting_edge* parent,
                    const Validity& validity)
      : a(a), b(b), cell(cell), parent(parent), is_constrained(validity.is_constrained(a, b))
    { }

    bool is_edge_of(const Cell_handle c) const { return c->has_vertex(a) && c->has_vertex(b); }

    const Vertex_handle a, b;
    mutable Cell_handle cell;
    const Supporting_edge* const parent;
    const bool is_constrained; // if not, none of its faces is
  };

  // Where edges of the way up to the root are edges of a shell further down.
  class Ancestors
  {
  public:
    Ancestors() { }
    Ancestors(const Shell& s, const Supporting_edge* const nearest) { assign(s, nearest); }

    void assign(const Shell& s, const Supporting_edge* const nearest)
    {
      m_marks.assign(s.degree(), 0);
      for(const Supporting_edge* x = nearest; x != nullptr; x = x->parent)
      {
        const int i = s.index(x->a), j = s.index(x->b);
        if(i != Shell::none && j != Shell::none)
          mark_edge_of_skirt_polygon(s, i, j);
        else if(i != Shell::none && (x->b == s.a() || x->b == s.b()))
          m_marks[i] |= LINK_EDGE;
        else if(j != Shell::none && (x->a == s.a() || x->a == s.b()))
          m_marks[j] |= LINK_EDGE;
      }
    }

    // Whether the edge from a or b to p_i is one of these.
    bool have_link_edge(const int i) const { return (m_marks[i] & LINK_EDGE) != 0; }

    // Whether the edge from p_i to p_next(i) is one of these.
    bool have_edge_of_skirt_polygon(const int i) const { return (m_marks[i] & EDGE_OF_SKIRT_POLYGON) != 0; }

    // Whether an edge of the cell a b p_i p_next(i) is one of these.
    bool have_edge_of_cell(const Shell& s, const int i) const
    {
      return have_link_edge(i) || have_link_edge(s.next(i)) || have_edge_of_skirt_polygon(i);
    }

  private:
    enum Mark { LINK_EDGE = 1, EDGE_OF_SKIRT_POLYGON = 2 };

    void mark_edge_of_skirt_polygon(const Shell& s, const int i, const int j)
    {
      if(s.next(i) == j)
        m_marks[i] |= EDGE_OF_SKIRT_POLYGON;
      else if(s.next(j) == i)
        m_marks[j] |= EDGE_OF_SKIRT_POLYGON;
    }

    boost::container::small_vector<unsigned char, 32> m_marks; // for each position
  };

  // Condition 2 of [CZZ+17, Section 3.2]: no new supporting face around an ancestor edge. It is the conjunction with
  // the caller's validity that the search for a covering mesh has to obey.
  struct Recursion_validity
  {
    const Validity* validity;
    const Ancestors* ancestors;

    bool is_valid_triangle(const Shell& s, const int i, const int k, const int j) const
    {
      return ! (s.next(i) == k && ancestors->have_edge_of_skirt_polygon(i))
          && ! (s.next(k) == j && ancestors->have_edge_of_skirt_polygon(k))
          && ! (s.next(j) == i && ancestors->have_edge_of_skirt_polygon(j))
          && validity->is_valid_triangle(s, i, k, j);
    }

    bool is_valid_chord(const Shell& s, const int i, const int j) const
    {
      return ! ancestors->have_link_edge(i) && ! ancestors->have_link_edge(j) && validity->is_valid_chord(s, i, j);
    }
  };

  typedef Boundary_recovery_3::internal::Covering_mesh_search_3<Tr, Quality, Recursion_validity> Covering_mesh_search;
  static_assert(max_degree <= Covering_mesh_search::max_degree, "Shells of this degree cannot be searched.");

  // The edge ab, which the cell c has, or its face with p, with so many shells.
  bool remove_root(const Vertex_handle a, const Vertex_handle b, const Vertex_handle p, const Cell_handle c,
                   const int l_max, const std::size_t max_number_of_shells)
  {
    CGAL_precondition(m_tr.dimension() == 3);
    m_was_cut_off = false;
    m_root_cell = c;
    if(m_tr.is_infinite(a) || m_tr.is_infinite(b))
      return false;
    const Supporting_edge root(a, b, c, nullptr, *m_validity_of_call);
    if(p == Vertex_handle() && root.is_constrained)
      return false;
    m_total_number_of_shells += m_number_of_shells;
    m_number_of_shells = 0;
    m_max_number_of_shells_of_edge = max_number_of_shells;
    const bool is_removed = remove(root, p, 0, l_max);
    m_root_cell = root.cell;
    return is_removed;
  }

  // recursiveST(e, f, l, l_max) of [CZZ+17, Alg. 1], where f is the face of e and p, or none if p is the default
  // handle. What failed at the same shell before is not tried again.
  bool remove(const Supporting_edge& e, const Vertex_handle p, const int l, const int l_max)
  {
    Shell shell(m_tr, e.cell, e.cell->index(e.a), e.cell->index(e.b));
    if(! m_failed_removals)
      return transform_repeatedly(shell, e, p, l, l_max);
    const auto removal = m_failed_removals->removal(shell, p);
    const bool was_cut_off = std::exchange(m_was_cut_off, false);
    const bool is_known = m_failed_removals->contains(removal, l_max - l, m_was_cut_off);
    const bool is_removed = ! is_known && transform_repeatedly(shell, e, p, l, l_max);
    if(! is_known && ! is_removed && m_number_of_shells <= m_max_number_of_shells_of_edge)
      m_failed_removals->insert(removal, l_max - l, m_was_cut_off);
    m_was_cut_off |= was_cut_off;
    return is_removed;
  }

  // Its tail recursion is a loop here; the depth of the other recursion is bounded by l_max. The shell is that of e,
  // which is changed.
  bool transform_repeatedly(Shell& shell, const Supporting_edge& e, const Vertex_handle p, const int l, const int l_max)
  {
    Ancestors ancestors;
    while(true)
    {
      const int f = p == Vertex_handle() ? Shell::none : shell.index(p);
      if(p != Vertex_handle() && f == Shell::none)
        return true;
      if(++m_number_of_shells > m_max_number_of_shells_of_edge)
      {
        m_was_cut_off = true;
        return false;
      }
      ancestors.assign(shell, e.parent);
      const Outcome outcome = transform(shell, e, ancestors, f, l == l_max);
      if(outcome == REMOVED)
        return true;
      if(outcome == REDUCED)
      {
        shell.assign(m_tr, e.cell, e.cell->index(e.a), e.cell->index(e.b));
        if(f != Shell::none && shell.index(p) == Shell::none)
          return true;
        ancestors.assign(shell, e.parent);
      }
      if(! reduce_by_link_edges(shell, e, ancestors, l, l_max))
        return false;
      shell.assign(m_tr, e.cell, e.cell->index(e.a), e.cell->index(e.b));
    }
  }

  // Lines 8 to 14 of [CZZ+17, Alg. 1]: returns true as soon as the shell of e shrank. Until then, its cells are those
  // that were there first: they change only if its degree falls, for no new face around an ancestor is allowed.
  bool reduce_by_link_edges(const Shell& shell, const Supporting_edge& e, const Ancestors& ancestors, const int l,
                            const int l_max)
  {
    for(int i = 0; i < shell.degree(); ++i)
      for(const bool at_a : { true, false })
      {
        if(! is_recursable_link_edge(shell, i, at_a, ancestors)
           || (e.is_constrained && m_validity_of_call->is_constrained(shell.a(), shell.b(), shell.vertex(i))))
          continue;
        if(l >= l_max)
        {
          m_was_cut_off = true;
          return false;
        }
        const Vertex_handle apex = at_a ? shell.a() : shell.b();
        const Vertex_handle other = at_a ? shell.b() : shell.a();
        const Supporting_edge link_edge(apex, shell.vertex(i), shell.cell(i), &e, *m_validity_of_call);
        const std::size_t before = m_number_of_transformations;
        remove(link_edge, other, l + 1, l_max);
        if(m_number_of_transformations != before && degree(e) < shell.degree())
          return true;
        if(m_number_of_shells > m_max_number_of_shells_of_edge)
          return false;
      }
    return false;
  }

  int degree(const Supporting_edge& e) const
  {
    int degree = 0;
    Cell_handle c = e.cell;
    do
    {
      ++degree;
      c = c->neighbor(Tr::next_around_edge(c->index(e.a), c->index(e.b)));
    }
    while(c != e.cell);
    return degree;
  }

  // The filters of [CZZ+17, Section 2.2] for the edge from a (or b) to p_i, a link edge of the face a b p_i, with two
  // differences. Flat angles count as reflex, and angles on the hull as flat: in the planes of CAD models everything is
  // flat. Constrained link edges are not filtered out: their shells can be reduced, and their constrained faces stay.
  bool is_recursable_link_edge(const Shell& s, const int i, const bool at_a, const Ancestors& ancestors) const
  {
    const int h = s.infinite_index();
    if(i == h || ancestors.have_edge_of_cell(s, i) || ancestors.have_edge_of_cell(s, s.previous(i)))
      return false;
    const bool is_on_hull = h == s.next(i) || h == s.previous(i);
    return is_on_hull || angle_at_link_edge(s, i, at_a) != NEGATIVE;
  }

  // POSITIVE if the edge from a (or b) to p_i is a reflex edge of the face a b p_i [CZZ+17, Fig. 4], ZERO if flat.
  Orientation angle_at_link_edge(const Shell& s, const int i, const bool at_a) const
  {
    const Vertex_handle p = s.vertex(s.previous(i)), q = s.vertex(s.next(i));
    return at_a ? m_predicates.orientation(s.a(), s.vertex(i), p, q)
                : m_predicates.orientation(s.b(), s.vertex(i), q, p);
  }

  // shellTransformation(a, b, f, P, K_old) of [CZZ+17, Alg. 3], where f is a position in the skirt polygon.
  // If `only_if_done`, a covering mesh that neither loses ab nor avoids f is not worth a change: no recursion follows.
  Outcome transform(const Shell& shell, const Supporting_edge& e, const Ancestors& ancestors, const int f,
                    const bool only_if_done = false)
  {
    if(shell.degree() > max_degree)
      return UNCHANGED;
    m_search_validity = { m_validity_of_call, &ancestors };
    const auto is_kept = [&](const int i)
    {
      return e.is_constrained && m_validity_of_call->is_constrained(shell.a(), shell.b(), shell.vertex(i));
    };
    if(! m_search(shell, f, e.is_constrained, is_kept, only_if_done)
       || ! m_validity_of_call->is_valid_covering_mesh(shell, m_search.partial_triangulation()))
      return UNCHANGED;
    const Boundary_recovery_3::Partial_triangulation& k = m_search.partial_triangulation();
    replace(shell, k, e);
    return k.core.empty() ? REMOVED : REDUCED;
  }

  // Step 8 of [CZZ+17, Alg. 3]. Cells that belong to both covering meshes stay.
  void replace(const Shell& s, const Boundary_recovery_3::Partial_triangulation& k, const Supporting_edge& e)
  {
    m_old_cells.clear();
    m_tetrahedra.clear();
    m_old_cells.assign(s.cells().begin(), s.cells().end());
    for(int c = 0; c < k.core_size(); ++c)
    {
      const int i = k.core[c], j = k.core[c + 1 == k.core_size() ? 0 : c + 1];
      if(j == s.next(i))
        m_old_cells[i] = Cell_handle();
      else
        m_tetrahedra.push_back(Tetrahedron{{ s.a(), s.b(), s.vertex(i), s.vertex(j) }});
    }
    m_old_cells.erase(std::remove(m_old_cells.begin(), m_old_cells.end(), Cell_handle()), m_old_cells.end());
    for(const std::array<int, 3>& t : k.triangles)
    {
      m_tetrahedra.push_back(Tetrahedron{{ s.vertex(t[0]), s.vertex(t[1]), s.vertex(t[2]), s.b() }});
      m_tetrahedra.push_back(Tetrahedron{{ s.vertex(t[0]), s.vertex(t[2]), s.vertex(t[1]), s.a() }});
    }
    m_replacement(m_tr, m_old_cells, m_tetrahedra, *m_visitor);
    ++m_number_of_transformations;
    update_cells(e);
  }

  // Each edge of the way up to the root gets a cell that exists. If its cell is gone, one of the new cells is around
  // it, for they fill the same polyhedron.
  void update_cells(const Supporting_edge& e)
  {
    for(const Supporting_edge* x = &e; x != nullptr; x = x->parent)
      if(Boundary_recovery_3::internal::contains(m_old_cells, x->cell))
        for(const Cell_handle c : m_replacement.new_cells())
          if(x->is_edge_of(c))
          {
            x->cell = c;
            break;
          }
  }

  Tr& m_tr;
  Boundary_recovery_3::internal::Vertex_predicates_3<Tr> m_predicates;
  Quality m_quality;
  std::optional<Validity> m_validity;            // none if every call is given one
  const Validity* m_validity_of_call = nullptr;
  // what the constructor without a visitor points to; other visitors need not be default constructible
  Default_meshing_visitor_3 m_no_visitor;
  Visitor* m_visitor;
  std::optional<Boundary_recovery_3::internal::Failed_edge_removals_3<Tr> > m_failed_removals; // none: all are tried
  Recursion_validity m_search_validity = { nullptr, nullptr };
  Covering_mesh_search m_search{ m_predicates, m_quality, m_search_validity };
  Replace_cells m_replacement;
  boost::container::small_vector<Cell_handle, 32> m_old_cells;
  boost::container::small_vector<Tetrahedron, 32> m_tetrahedra;
  Cell_handle m_root_cell;
  std::size_t m_max_number_of_shells = default_max_number_of_shells;
  std::size_t m_max_number_of_shells_of_edge = 0;
  std::size_t m_number_of_shells = 0;
  std::size_t m_total_number_of_shells = 0; // in the removals before this one
  std::size_t m_number_of_transformations = 0;
  bool m_was_cut_off = false;
};

} // namespace CGAL

#endif // CGAL_SHELL_TRANSFORMATION_3_H

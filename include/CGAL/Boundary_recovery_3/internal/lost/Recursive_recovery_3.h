// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_LOST_RECURSIVE_RECOVERY_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_LOST_RECURSIVE_RECOVERY_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>
#include <CGAL/Boundary_recovery_3/Shell_quality_3.h>
#include <CGAL/Boundary_recovery_3/Shell_validity_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/sort_in_space.h>
#include <CGAL/Boundary_recovery_3/internal/lost/Recover_constraint_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Mesh_editor_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>
#include <CGAL/Shell_transformation_3.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * How often mesh edges and faces are crossed by the lost constraints of one dimension N - 1 (edges for N = 2, facets
 * for N = 3).
 *
 * This is the hash table of [CZZ+17, Section 4.2.1], with one difference. There, entities that come up during a pass
 * are not counted before the next one. Here an entity is counted when it is first asked for, against the lost
 * constraints whose bounding boxes meet its own, and the count is remembered; it depends on the lost constraints only,
 * not on the mesh. Constraints that are close to each other are in blocks with a box each.
 */
template <typename Tr, std::size_t N>
class Intersection_table_3
{
public:
  typedef typename Tr::Vertex_handle    Vertex_handle;
  typedef std::array<Vertex_handle, N>  Constraint;

  explicit Intersection_table_3(const Tr& tr) : m_predicates(tr) { }

  // Sets the lost constraints, and forgets all counts if they changed.
  void set_constraints(const std::vector<Constraint>& constraints)
  {
    if(constraints == m_constraints)
      return;
    m_constraints = constraints;
    m_sorted = constraints;
    internal::sort_in_space(m_sorted, [this](const Constraint& c) { return this->center(c); }, [] { return true; });
    m_boxes.clear();
    m_blocks.clear();
    for(std::size_t i = 0; i < m_sorted.size(); ++i)
    {
      m_boxes.push_back(box(m_sorted[i]));
      if(i % block_size == 0)
        m_blocks.push_back(m_boxes.back());
      else
        m_blocks.back() += m_boxes.back();
    }
    m_edges = Counts<2>();
    m_faces = Counts<3>();
  }

  int number_of_crossings(const Vertex_handle u, const Vertex_handle v)
  {
    return remembered_count(Edge{{ u, v }}, m_edges);
  }

  int number_of_crossings(const Vertex_handle u, const Vertex_handle v, const Vertex_handle w)
  {
    // the edges of a lost facet are mesh edges, so a mesh face crosses the facet only where an edge of this face does
    return N == 3 ? 0 : remembered_count(Face{{ u, v, w }}, m_faces);
  }

private:
  typedef std::array<Vertex_handle, 2> Edge;
  typedef std::array<Vertex_handle, 3> Face;

  template <std::size_t M>
  struct Counts
  {
    Simplex_index_3<Vertex_handle, M> index;
    std::vector<int> numbers; // by the numbers of `index`
  };

  template <std::size_t M>
  int remembered_count(const std::array<Vertex_handle, M>& entity, Counts<M>& counts) const
  {
    const auto inserted = counts.index.insert(entity);
    if(inserted.second)
      counts.numbers.push_back(count(entity));
    return counts.numbers[inserted.first];
  }

  template <std::size_t M>
  Bbox_3 box(const std::array<Vertex_handle, M>& simplex) const
  {
    Bbox_3 b;
    for(const Vertex_handle v : simplex)
      b += m_predicates.point(v).bbox();
    return b;
  }

  std::array<double, 3> center(const Constraint& c) const
  {
    const Bbox_3 b = box(c);
    return {{ (b.xmin() + b.xmax()) / 2, (b.ymin() + b.ymax()) / 2, (b.zmin() + b.zmax()) / 2 }};
  }

  template <std::size_t M>
  int count(const std::array<Vertex_handle, M>& entity) const
  {
    const Bbox_3 b = box(entity);
    int n = 0;
    for(std::size_t k = 0; k < m_blocks.size(); ++k)
      if(do_overlap(b, m_blocks[k]))
        for(std::size_t i = k * block_size; i < (std::min)((k + 1) * block_size, m_sorted.size()); ++i)
          if(do_overlap(b, m_boxes[i]) && crosses(m_sorted[i], entity))
            ++n;
    return n;
  }

  bool crosses(const Edge& c, const Edge& e) const { return m_predicates.segments_cross(c[0], c[1], e[0], e[1]); }

  bool crosses(const Edge& c, const Face& f) const
  {
    return m_predicates.segment_pierces_triangle(c[0], c[1], f[0], f[1], f[2]);
  }

  bool crosses(const Face& c, const Edge& e) const
  {
    return m_predicates.segment_pierces_triangle(e[0], e[1], c[0], c[1], c[2]);
  }

  bool crosses(const Face&, const Face&) const { return false; }

  static constexpr std::size_t block_size = 16;

  Vertex_predicates_3<Tr> m_predicates;
  std::vector<Constraint> m_constraints;
  std::vector<Constraint> m_sorted;      // the same, along a curve
  std::vector<Bbox_3> m_boxes, m_blocks; // of these, and of so many of them each
  Counts<2> m_edges;
  Counts<3> m_faces;
};

/*
 * Recovery of the lost constraints of one dimension N - 1, edges (N = 2) or facets whose edges are mesh edges (N = 3),
 * by recursive shell transformations: [CZZ+17, Alg. 4 and Alg. 5], and the same for facets [CZZ+17, Section 4.2.2].
 *
 * Removes the indices of recovered constraints from the list of lost constraints. The two callings of Alg. 5 append a
 * report to `levels` before their first pass, and after each pass.
 */
template <typename Tr, std::size_t N>
class Recursive_recovery_3
{
public:
  typedef typename Tr::Vertex_handle    Vertex_handle;
  typedef std::array<Vertex_handle, N>  Constraint;
  typedef Constraints_3<Tr>             Constraints;
  typedef Vertex_predicates_3<Tr>       Predicates;
  typedef Recovery_context<Tr>     Context;
  typedef Recursion_level_report        Report;

  // `lost` is in increasing order. All arguments have to outlive this object.
  Recursive_recovery_3(Tr& tr, const Predicates& predicates, const Constraints& constraints, Context& context,
                       std::vector<std::size_t>& lost, std::vector<Report>& levels)
    : m_tr(tr), m_constraints(constraints), m_context(context), m_editor(tr, context.visitor()),
      m_recover(m_editor, predicates, constraints), m_lost(lost), m_levels(levels), m_target_validity{ tr, constraints }
  { }

  // These three return the number of replacements: of covering meshes, and of cavities around crossings.

  // Passes without recursion, which try to remove each crossing edge or facet by cells from an end of the lost edge, or
  // by a single shell transformation. They go on as long as a pass at least halves the number of lost constraints: the
  // others need recursion, and more passes would change the mesh without much use, see "Tuning constants" in the
  // manual.
  std::size_t remove_without_recursion(const Phase phase)
  {
    typedef Shell_transformation_3<Tr, No_shell_quality_3, Target_validity, Mesh_visitor_3<Tr> > Transformation;
    Transformation st(m_tr, No_shell_quality_3(), m_context.visitor(), Predicates(m_tr));
    start(std::size_t(-1));
    for(std::size_t before = std::size_t(-1); ! m_lost.empty() && m_lost.size() <= before / 2; )
    {
      before = m_lost.size();
      sort_lost([](const auto& /* crossings */) { });
      pass(phase, st, m_target_validity, 0);
    }
    return number_of_replacements(st);
  }

  // The first calling of Alg. 5: under BRC1 or BRC2, with the vector [Q', Q'', Q_1].
  std::size_t recover_with_best_cells(const Phase phase, const int max_recursion_level)
  {
    typedef Worst_element_quality_3<Tr> Quality;
    typedef Shell_transformation_3<Tr, Quality, Target_validity, Mesh_visitor_3<Tr> > Transformation;
    Transformation st(m_tr, Quality(m_tr), m_context.visitor(), Predicates(m_tr));
    raise_recursion_level(phase, max_recursion_level, &Report::n1, [&](const int l_max)
    {
      pass(phase, st, m_target_validity, l_max);
    });
    return number_of_replacements(st);
  }

  // The second calling of Alg. 5: under BRC3 or BRC4, which is BRC3 for facets, with the vector [Q_2, Q', Q''].
  std::size_t recover_with_fewest_crossings(const Phase phase, const int max_recursion_level)
  {
    typedef Intersection_table_3<Tr, N> Table;
    typedef Fewest_intersections_quality_3<Tr, Table> Quality;
    typedef Shell_validity_conjunction_3<Kept, BRC3<Tr, Table> > Validity;
    Table table(m_tr);
    const Validity validity{ Kept(m_constraints), BRC3<Tr, Table>(table) };
    Shell_transformation_3<Tr, Quality, Validity, Mesh_visitor_3<Tr> > st(m_tr, Quality(table), m_context.visitor(),
                                                              Predicates(m_tr));
    raise_recursion_level(phase, max_recursion_level, &Report::n2, [&](const int l_max)
    {
      std::vector<Constraint> lost;
      for(const std::size_t i : m_lost)
        lost.push_back(all()[i]);
      table.set_constraints(lost);
      pass(phase, st, [&](const Constraint&) -> const Validity& { return validity; }, l_max);
    });
    return number_of_replacements(st);
  }

private:
  typedef Kept_constraints_3<Constraints> Kept;
  typedef std::conditional_t<N == 2, BRC1<Tr>, BRC2<Tr> > Target_condition;
  typedef Shell_validity_conjunction_3<Kept, Target_condition> Target_validity;

  // Bound on the shells that one calling of Alg. 5 visits, for each constraint that is lost at its start: in planar
  // fans of hundreds of triangles, recursion goes astray.
  static constexpr std::size_t max_number_of_shells_per_constraint = 1000;

  // Units of work: one unit takes about as long as to find one mesh edge or facet that a lost edge crosses.
  static constexpr std::size_t work_per_shell = 10;
  static constexpr std::size_t work_per_crossing = N == 2 ? 1 : 10;

  static constexpr std::size_t never = std::size_t(-1);

  // The last attempt at a constraint that failed.
  struct Failure
  {
    int recursion_level = -1;
    std::size_t number_of_crossings = 0; // that were left
  };

  const std::vector<Constraint>& all() const
  {
    if constexpr(N == 2)
      return m_constraints.edges();
    else
      return m_constraints.facets();
  }

  // Makes the condition BRC1 or BRC2, which depends on the constraint that is being recovered. BRC3 and BRC4 are the
  // same for all lost constraints.
  struct Target_validity_of
  {
    Target_validity operator()(const Constraint& target) const
    {
      return std::apply([this](const auto ... v)
                        {
                          return Target_validity(Kept(this->constraints), Target_condition(this->tr, v...));
                        }, target);
    }

    const Tr& tr;
    const Constraints& constraints;
  };

  void start(const std::size_t max_number_of_shells)
  {
    m_hopeless_since.assign(all().size(), never);
    m_failures.assign(all().size(), Failure());
    m_max_number_of_shells = max_number_of_shells;
    m_number_of_stars_before = m_recover.number_of_stars();
  }

  // recvBndEdgesByST_Wrap of [CZZ+17, Alg. 5]: raises the recursion level from 1 to its maximum, where passes are
  // repeated until nothing is lost, or until one of them did not improve the measure. Levels between them change the
  // mesh without much use.
  template <typename Pass>
  void raise_recursion_level(const Phase phase, const int max_recursion_level, std::size_t Report::* const measure,
                             const Pass& pass)
  {
    start(max_number_of_shells_per_constraint * (m_lost.size() + 20));
    std::size_t best = add_level(phase, -1).*measure;
    for(int l_max = (std::min)(1, max_recursion_level); ! m_lost.empty() && m_context.go_further();
        l_max = max_recursion_level)
    {
      pass(l_max);
      const std::size_t value = add_level(phase, l_max).*measure;
      if(value >= best && l_max == max_recursion_level)
        return;
      best = (std::min)(best, value);
    }
  }

  Report add_level(const Phase phase, const int l_max)
  {
    Report result = count_and_sort_lost();
    result.phase = phase;
    result.max_recursion_level = l_max;
    if(! m_context.is_refuted()) // else it may be unfinished
      m_levels.push_back(result);
    return result;
  }

  // Counts the lost constraints and what they cross, and sorts them for the next pass. n4 counts the crossed
  // mesh entities, each once.
  Report count_and_sort_lost()
  {
    Report result;
    result.n1 = m_lost.size();
    Simplex_index_3<Vertex_handle, 2> crossed_edges;
    Simplex_index_3<Vertex_handle, 3> crossed_facets;
    sort_lost([&](const std::vector<Crossing_3<Tr> >& crossings)
    {
      result.n2 += crossings.size();
      result.n3 = (std::max)(result.n3, crossings.size());
      for(const Crossing_3<Tr>& crossing : crossings)
        if(crossing.dimension == 1)
          crossed_edges.insert({{ crossing.vertices[0], crossing.vertices[1] }});
        else
          crossed_facets.insert(crossing.vertices);
    });
    result.n4 = crossed_edges.size() + crossed_facets.size();
    return result;
  }

  // The order in which the next pass treats the lost constraints. Edges with few crossings come first: they are back
  // after a few flips, and are then out of the way of the others. Facets are treated in input order.
  template <typename Count_crossings>
  void sort_lost(const Count_crossings& count_crossings)
  {
    m_order.clear();
    for(const std::size_t i : m_lost)
    {
      if(m_context.is_refuted())
        break;
      const auto& crossings = m_recover.crossings(all()[i]);
      m_context.add_work(work_per_crossing * crossings.size());
      count_crossings(crossings);
      m_order.emplace_back(N == 2 ? crossings.size() : 0, i);
    }
    std::sort(m_order.begin(), m_order.end());
  }

  // recvBndEdgesByST of [CZZ+17, Alg. 4]. `validity_of` gives the condition under which a constraint is recovered.
  template <typename Transformation, typename Validity_of>
  void pass(const Phase phase, Transformation& st, const Validity_of& validity_of, const int l_max)
  {
    if(m_context.is_refuted())
      return;
    std::size_t done = 0;
    std::vector<std::size_t> still_lost; // whoever examines the input meanwhile sees all that was lost before
    for(const auto& crossings_and_index : m_order)
    {
      const std::size_t i = crossings_and_index.second;
      if(! attempt(st, i, validity_of, l_max))
        still_lost.push_back(i);
      m_context.visitor().on_progress(phase, ++done, m_order.size());
    }
    std::sort(still_lost.begin(), still_lost.end());
    m_lost.swap(still_lost);
  }

  // Since the start: whether it has grown tells whether the mesh has changed.
  template <typename Transformation>
  std::size_t number_of_replacements(const Transformation& st) const
  {
    return st.number_of_transformations() + m_recover.number_of_stars() - m_number_of_stars_before;
  }

  // Does not repeat an attempt that changed nothing and was not cut off, until the mesh has changed; a higher
  // recursion level alone would lead it to the same end. Nor one at the same level before it is worthwhile.
  template <typename Transformation, typename Validity_of>
  bool attempt(Transformation& st, const std::size_t i, const Validity_of& validity_of, const int l_max)
  {
    const std::size_t before = number_of_replacements(st);
    if(m_hopeless_since[i] == before || st.number_of_shells() > m_max_number_of_shells)
      return false;
    const std::size_t shells = st.number_of_shells(), work = m_recover.work_in_crossings();
    const bool is_tried = is_worthwhile(i, l_max);
    const bool is_recovered = is_tried && m_recover(st, all()[i], validity_of(all()[i]), l_max, m_context);
    m_context.add_work(work_per_shell * (st.number_of_shells() - shells)
                       + work_per_crossing * (m_recover.work_in_crossings() - work));
    if(! is_tried)
      return false;
    const bool is_hopeless = ! is_recovered && number_of_replacements(st) == before && ! m_recover.was_cut_off();
    m_hopeless_since[i] = is_hopeless ? before : never;
    m_failures[i] = { l_max, m_recover.crossings().size() };
    return is_recovered;
  }

  // Where recursion failed to recover an edge, it is tried again at a higher level, or once others have taken away some
  // of what the edge crosses: else hardly one in twenty attempts leads further, and those that fail are most of the
  // work.
  bool is_worthwhile(const std::size_t i, const int l_max)
  {
    return N == 3 || l_max == 0 || l_max != m_failures[i].recursion_level
        || m_recover.crossings(all()[i]).size() < m_failures[i].number_of_crossings;
  }

  Tr& m_tr;
  const Constraints& m_constraints;
  Context& m_context;
  Mesh_editor_3<Tr> m_editor;
  Recover_constraint_3<Tr, N> m_recover;
  std::vector<std::size_t>& m_lost;
  std::vector<Report>& m_levels;
  const Target_validity_of m_target_validity;
  std::vector<std::pair<std::size_t, std::size_t> > m_order; // the lost ones, sorted by count_and_sort_lost()
  std::vector<std::size_t> m_hopeless_since; // numbers of replacements, or never, for each constraint
  std::vector<Failure> m_failures;           // for each constraint
  std::size_t m_max_number_of_shells = std::size_t(-1); // in one calling of Alg. 5
  std::size_t m_number_of_stars_before = 0;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_LOST_RECURSIVE_RECOVERY_3_H

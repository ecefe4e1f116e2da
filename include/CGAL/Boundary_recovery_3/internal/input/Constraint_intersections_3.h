// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_INPUT_CONSTRAINT_INTERSECTIONS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_INPUT_CONSTRAINT_INTERSECTIONS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/input/Indexed_input_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/enum.h>
#include <CGAL/intersections.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Keeps the smallest of the elements that are inserted, a bounded number of them, whatever their order. Never stores
 * more than twice that number, so that the time is constant for each on average.
 */
template <typename T>
class Smallest_elements
{
public:
  explicit Smallest_elements(const std::size_t max_number) : m_max_number(max_number) { }

  // Whether x may be among the smallest: if not, whoever has trouble to find out whether it is to be inserted need not.
  bool is_wanted(const T& x) const { return ! m_bound || x < *m_bound; }

  void insert(const T& x)
  {
    ++m_number_of_insertions;
    m_elements.push_back(x);
    if(m_elements.size() / 2 >= m_max_number) // a bound on the number may be the largest number there is
      discard();
  }

  // Counts those that were not kept, too.
  std::size_t number_of_insertions() const { return m_number_of_insertions; }

  // The elements that are kept, in increasing order.
  std::vector<T> sorted() const
  {
    std::vector<T> result = m_elements;
    std::sort(result.begin(), result.end());
    if(result.size() > m_max_number)
      result.resize(m_max_number);
    return result;
  }

private:
  void discard()
  {
    if(m_elements.size() <= m_max_number)
      return;
    const auto first_to_discard = m_elements.begin() + m_max_number;
    std::nth_element(m_elements.begin(), first_to_discard, m_elements.end());
    m_bound = *first_to_discard;
    m_elements.erase(first_to_discard, m_elements.end());
  }

  const std::size_t m_max_number;
  std::vector<T> m_elements;
  std::optional<T> m_bound; // the smallest that was discarded
  std::size_t m_number_of_insertions = 0;
};

// A box with the number of what is in it. CGAL's own boxes number themselves by their address or by a global counter.
// All the boxes of one search have to have different numbers, also where two ranges are searched.
class Numbered_box_3
  : public Box_intersection_d::Box_d<double, 3, Box_intersection_d::ID_NONE>
{
  typedef Box_intersection_d::Box_d<double, 3, Box_intersection_d::ID_NONE> Base;
  std::size_t m_id;

public:
  Numbered_box_3(const Bbox_3& bbox, const std::size_t id) : Base(bbox), m_id(id) { }
  std::size_t id() const { return m_id; }
};

// The callback of a search, which calls `visit` with the numbers of two boxes. Only an exception ends the search early.
template <typename Visit, typename Context>
class Box_pair_callback
{
public:
  struct End_of_search { };

  Box_pair_callback(const Visit& visit, Context& context) : m_visit(visit), m_context(context) { }

  void operator()(const Numbered_box_3& a, const Numbered_box_3& b) const
  {
    if(! m_context.go_further_after_short_step() || ! m_visit(a.id(), b.id()))
      throw End_of_search();
  }

private:
  const Visit& m_visit;
  Context& m_context;
};

// Calls `visit` with the numbers of each two boxes that intersect, one of each range, until it returns false or
// `context` stops. Puts the boxes in another order.
template <typename Visit, typename Context>
void visit_intersecting_boxes(std::vector<Numbered_box_3>& boxes_1, std::vector<Numbered_box_3>& boxes_2,
                              const Visit& visit, Context& context)
{
  typedef Box_pair_callback<Visit, Context> Callback;
  try {
    CGAL::box_intersection_d(boxes_1.begin(), boxes_1.end(), boxes_2.begin(), boxes_2.end(), Callback(visit, context));
  } catch(const typename Callback::End_of_search&) { }
}

// The same for the boxes of one range.
template <typename Visit, typename Context>
void visit_intersecting_boxes(std::vector<Numbered_box_3>& boxes, const Visit& visit, Context& context)
{
  typedef Box_pair_callback<Visit, Context> Callback;
  static constexpr std::ptrdiff_t cutoff = 2000; // that of PMP::self_intersections()
  try {
    CGAL::box_self_intersection_d<Sequential_tag>(boxes.begin(), boxes.end(), Callback(visit, context), cutoff);
  } catch(const typename Callback::End_of_search&) { }
}

/// finds the pairs of constraints that intersect elsewhere than in a common vertex or a common edge: the expensive half
/// of the diagnosis. (PMP::self_intersections() accepts manifold meshes only, no soups and no edges, up to CGAL 6.0.)
/// Vertices at one point count as one vertex here. Left out are degenerate constraints, those with an unknown vertex,
/// edges that are edges of a facet (the facet speaks for them), and repetitions of an edge.
template <typename GT>
class Constraint_intersections_3
{
  typedef typename GT::Point_3     Point_3;
  typedef Indexed_input_3<Point_3> Input;

  // A facet or an edge; those of one constraint list are ordered by dimension, then by index.
  struct Constraint
  {
    int dimension;
    std::size_t index;
    std::array<std::size_t, 3> vertices; // sorted; as representatives; the first `dimension + 1` entries
  };

  typedef Numbered_box_3 Box;

  // A face of a constraint, or a whole one.
  typedef boost::container::small_vector<std::size_t, 3> Vertices;

public:
  typedef std::pair<std::size_t, std::size_t> Position_pair;
  typedef Input_simplex_3<Point_3>            Simplex;
  typedef Input_defect_3<Point_3>             Defect;

  Constraint_intersections_3(const Input& input, const GT& gt)
    : m_input(input), m_gt(gt)
  {
    collect_constraints();
  }

  /// returns the defects, sorted by the dimensions and indices of their two constraints; none if `context` stopped the
  /// search. Of more than `max_number`, the first ones; there are more if `number` is larger then, which counts those
  /// that were found on the way to them.
  ///
  /// What `simple_defects()` reports does not take part. An edge of the input that is an edge of a facet, too, is never
  /// named, since its facet is; of an edge that was given twice, the first one is named.
  template <typename Context>
  std::vector<Defect> defects(Context& context, const std::size_t max_number, std::size_t& number) const
  {
    const Smallest_elements<Position_pair> pairs = intersecting_pairs(context, max_number);
    std::vector<Defect> result;
    number = context.is_stopped() ? 0 : pairs.number_of_insertions();
    if(number == 0)
      return result;
    for(const Position_pair& p : pairs.sorted())
      result.push_back(Defect{ Input_defect_kind::intersecting_constraints,
                               { describe(m_constraints[p.first]), describe(m_constraints[p.second]) } });
    return result;
  }

  /// returns whether one of these constraints takes part in a defect, `false` if `context` stopped the search, or if
  /// this was not known after so many pairs of boxes that intersect.
  template <typename Context>
  bool have_defects(const std::vector<Simplex>& constraints, Context& context, std::size_t max_number_of_pairs) const
  {
    const std::size_t n = m_constraints.size();
    std::vector<Box> some, all = boxes();
    std::vector<char> is_given(n, false);
    for(const Simplex& s : constraints)
    {
      const std::size_t i = position(s);
      if(i == n)
        continue;
      some.emplace_back(bbox(m_constraints[i]), n + i);
      is_given[i] = true;
    }
    bool is_found = false;
    const auto look_on = [&](const std::size_t n_plus_i, const std::size_t j)
    {
      const std::size_t i = n_plus_i - n;
      const bool is_known = is_given[j] && j <= i; // the pair comes twice, or it is none
      is_found = ! is_known && intersect_improperly(i, j);
      return ! is_found && --max_number_of_pairs > 0;
    };
    internal::visit_intersecting_boxes(some, all, look_on, context);
    return is_found;
  }

private:
  void collect_constraints()
  {
    const std::vector<std::size_t> representative = point_representatives(m_input, used_vertices(m_input), m_gt);
    std::vector<Constraint> facets;
    Simplex_index_3<std::size_t, 2> known_edges;

    for(std::size_t i = 0; i < m_input.facets.size(); ++i)
    {
      const auto& f = m_input.facets[i];
      if(! has_geometry(m_input, f) || is_degenerate(m_input, f, m_gt))
        continue;
      Constraint c = { 2, i, {{ representative[f[0]], representative[f[1]], representative[f[2]] }} };
      std::sort(c.vertices.begin(), c.vertices.end());
      facets.push_back(c);
      if(! m_input.edges.empty())
        for(int k = 0; k < 3; ++k)
          known_edges.insert({{ c.vertices[k], c.vertices[(k + 1) % 3] }});
    }

    for(std::size_t i = 0; i < m_input.edges.size(); ++i)
    {
      const auto& e = m_input.edges[i];
      if(! has_geometry(m_input, e) || is_degenerate(m_input, e, m_gt))
        continue;
      const std::size_t v = representative[e[0]], w = representative[e[1]];
      if(known_edges.insert({{ v, w }}).second)
        m_constraints.push_back(Constraint{ 1, i, {{ (std::min)(v, w), (std::max)(v, w), v }} });
    }
    m_constraints.insert(m_constraints.end(), facets.begin(), facets.end());
  }

  // Where the constraint is in the list; its size if another constraint speaks for it.
  std::size_t position(const Simplex& s) const
  {
    const auto comes_before = [](const Constraint& c, const Simplex& s)
    {
      return c.dimension != s.dimension ? c.dimension < s.dimension : c.index < s.index;
    };
    const auto it = std::lower_bound(m_constraints.begin(), m_constraints.end(), s, comes_before);
    const bool is_there = it != m_constraints.end() && it->dimension == s.dimension && it->index == s.index;
    return is_there ? static_cast<std::size_t>(it - m_constraints.begin()) : m_constraints.size();
  }

  std::vector<Box> boxes() const
  {
    std::vector<Box> result;
    result.reserve(m_constraints.size());
    for(std::size_t i = 0; i < m_constraints.size(); ++i)
      result.emplace_back(bbox(m_constraints[i]), i);
    return result;
  }

  // The smallest ones. Most of the time is spent to find out whether two constraints intersect whose boxes do, so it is
  // asked only where it matters.
  template <typename Context>
  Smallest_elements<Position_pair> intersecting_pairs(Context& context, const std::size_t max_number) const
  {
    Smallest_elements<Position_pair> pairs(max_number);
    std::vector<Box> all = boxes();
    const auto collect = [&](const std::size_t i, const std::size_t j)
    {
      const Position_pair pair = std::minmax(i, j);
      if(pairs.is_wanted(pair) && intersect_improperly(i, j))
        pairs.insert(pair);
      return true;
    };
    internal::visit_intersecting_boxes(all, collect, context);
    return pairs;
  }

  // The boxes enclose the exact coordinates.
  Bbox_3 bbox(const Constraint& c) const
  {
    Bbox_3 result;
    for(int i = 0; i <= c.dimension; ++i)
      result += m_gt.construct_bbox_3_object()(point(c.vertices[i]));
    return result;
  }

  // Do they intersect elsewhere than in the simplex spanned by their common vertices?
  bool intersect_improperly(const std::size_t i, const std::size_t j) const
  {
    const Constraint& a = m_constraints[(std::min)(i, j)];
    const Constraint& b = m_constraints[(std::max)(i, j)];
    const Vertices va(a.vertices.begin(), a.vertices.begin() + a.dimension + 1);
    const Vertices vb(b.vertices.begin(), b.vertices.begin() + b.dimension + 1);
    Vertices common, rest_a, rest_b;
    std::set_intersection(va.begin(), va.end(), vb.begin(), vb.end(), std::back_inserter(common));
    std::set_difference(va.begin(), va.end(), common.begin(), common.end(), std::back_inserter(rest_a));
    std::set_difference(vb.begin(), vb.end(), common.begin(), common.end(), std::back_inserter(rest_b));

    switch(common.size())
    {
      case 0:
        return do_intersect(va, vb);
      case 1:
        // Seen from the common vertex, an intersection reaches out as far as the face opposite to it in one of them.
        return do_intersect(rest_a, vb) || do_intersect(rest_b, va);
      case 2:
        // Two facets: an edge with two vertices in common with another constraint is not in the list.
        return is_folded_over(common[0], common[1], rest_a[0], rest_b[0]);
      default:
        // The same facet twice, which is a defect of its own unless it uses different vertices at the same points.
        return ! std::is_permutation(m_input.facets[a.index].begin(), m_input.facets[a.index].end(),
                                     m_input.facets[b.index].begin());
    }
  }

  // Do the facets `pqr` and `pqs` overlap?
  bool is_folded_over(const std::size_t p, const std::size_t q, const std::size_t r, const std::size_t s) const
  {
    return m_gt.orientation_3_object()(point(p), point(q), point(r), point(s)) == COPLANAR &&
           m_gt.coplanar_orientation_3_object()(point(p), point(q), point(r), point(s)) == POSITIVE;
  }

  // Have the two simplices, of which at most one is a vertex, a common point?
  bool do_intersect(const Vertices& a, const Vertices& b) const
  {
    if(a.size() > b.size())
      return do_intersect(b, a);

    const auto intersect = m_gt.do_intersect_3_object();
    const auto has_on = m_gt.has_on_3_object();
    if(b.size() == 2)
      return a.size() == 1 ? has_on(segment(b), point(a[0])) : intersect(segment(a), segment(b));
    switch(a.size())
    {
      case 1:  return has_on(triangle(b), point(a[0]));
      case 2:  return intersect(triangle(b), segment(a));
      default: return intersect(triangle(a), triangle(b));
    }
  }

  const Point_3& point(const std::size_t v) const { return m_input.points[v]; }

  typename GT::Segment_3 segment(const Vertices& v) const
  {
    return m_gt.construct_segment_3_object()(point(v[0]), point(v[1]));
  }

  typename GT::Triangle_3 triangle(const Vertices& v) const
  {
    return m_gt.construct_triangle_3_object()(point(v[0]), point(v[1]), point(v[2]));
  }

  Simplex describe(const Constraint& c) const
  {
    return c.dimension == 1 ? describe_edge(m_input, c.index) : describe_facet(m_input, c.index);
  }

  const Input& m_input;
  const GT& m_gt;
  std::vector<Constraint> m_constraints;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_INPUT_CONSTRAINT_INTERSECTIONS_3_H

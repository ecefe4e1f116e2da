// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_INPUT_INPUT_DIAGNOSIS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_INPUT_INPUT_DIAGNOSIS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/input/Constraint_intersections_3.h>
#include <CGAL/Boundary_recovery_3/internal/input/Indexed_input_3.h>
#include <CGAL/Boundary_recovery_3/internal/lost/Constraint_search_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Unique_hash_map.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

// What is wrong with the input. The first half is cheap: what can be seen without comparing constraints with each
// other. The second half, where constraints are missing after the recovery, compares them.

namespace CGAL::Boundary_recovery_3::internal {

/// the checks behind `simple_defects()`; each appends the defects of one kind, by increasing index.
template <typename GT>
class Input_diagnosis_3
{
  typedef typename GT::Point_3     Point_3;
  typedef Indexed_input_3<Point_3> Input;
  typedef Input_simplex_3<Point_3> Simplex;

public:
  typedef Input_defect_3<Point_3>  Defect;

  Input_diagnosis_3(const Input& input, const GT& gt)
    : m_input(input), m_gt(gt), m_used(used_vertices(input))
  { }

  const std::vector<Defect>& defects() const { return m_defects; }

  void check_empty()
  {
    if(m_input.facets.empty() && m_input.edges.empty())
      report(Input_defect_kind::empty_input);
  }

  /// looks at all points: those that no constraint uses are inserted into the triangulation, too.
  void check_coordinates()
  {
    for(std::size_t v = 0; v < m_input.points.size(); ++v)
      if(! has_finite_coordinates(m_input.points[v]))
        report(Input_defect_kind::non_finite_coordinate, { describe_vertex(m_input, v) });
  }

  void check_indices()
  {
    for(std::size_t e = 0; e < m_input.edges.size(); ++e)
      if(! is_in_range(m_input, m_input.edges[e]))
        report(Input_defect_kind::index_out_of_range, { describe_edge(m_input, e) });
    for(std::size_t f = 0; f < m_input.facets.size(); ++f)
      if(! is_in_range(m_input, m_input.facets[f]))
        report(Input_defect_kind::index_out_of_range, { describe_facet(m_input, f) });
  }

  void check_degenerate_facets()
  {
    for(std::size_t f = 0; f < m_input.facets.size(); ++f)
      if(is_known_to_be_degenerate(m_input.facets[f]))
        report(Input_defect_kind::degenerate_facet, { describe_facet(m_input, f) });
  }

  void check_degenerate_edges()
  {
    for(std::size_t e = 0; e < m_input.edges.size(); ++e)
      if(is_known_to_be_degenerate(m_input.edges[e]))
        report(Input_defect_kind::degenerate_edge, { describe_edge(m_input, e) });
  }

  /// reports each facet that was given before, with the first facet of the same three vertices.
  void check_duplicate_facets()
  {
    const auto hash = [this](const std::size_t f) { return Simplex_hash()(m_input.facets[f]); };
    const auto are_equal = [this](const std::size_t f, const std::size_t g)
    {
      return internal::is_permutation(m_input.facets[f], m_input.facets[g]);
    };
    Hash_index<std::size_t, decltype(hash), decltype(are_equal)> index(hash, are_equal);
    index.reserve(m_input.facets.size());
    Index_pairs pairs;
    for(std::size_t f = 0; f < m_input.facets.size(); ++f)
      if(is_in_range(m_input, m_input.facets[f]))
      {
        const auto inserted = index.insert(f);
        if(! inserted.second)
          pairs.emplace_back(index.keys()[inserted.first], f);
      }

    std::sort(pairs.begin(), pairs.end());
    for(const auto& p : pairs)
      report(Input_defect_kind::duplicate_facet,
             { describe_facet(m_input, p.first), describe_facet(m_input, p.second) });
  }

  /// reports each used vertex that is at the point of another one, with the first used vertex at that point.
  void check_coincident_vertices()
  {
    const std::vector<std::size_t> representative = point_representatives(m_input, m_used, m_gt);
    Index_pairs pairs;
    for(std::size_t v = 0; v < representative.size(); ++v)
      if(representative[v] != v)
        pairs.emplace_back(representative[v], v);

    std::sort(pairs.begin(), pairs.end());
    for(const auto& p : pairs)
      report(Input_defect_kind::coincident_vertices,
             { describe_vertex(m_input, p.first), describe_vertex(m_input, p.second) });
  }

  /// says nothing as long as a vertex is unknown: it might be the one that is off the plane.
  void check_dimension()
  {
    if((! m_input.facets.empty() || ! m_input.edges.empty()) && is_every_vertex_known() && is_flat())
      report(Input_defect_kind::dimension_less_than_3);
  }

private:
  typedef std::vector<std::pair<std::size_t, std::size_t> > Index_pairs;

  void report(const Input_defect_kind kind, std::vector<Simplex> simplices = std::vector<Simplex>())
  {
    m_defects.push_back(Defect{ kind, std::move(simplices) });
  }

  // A repeated index is enough; only for other constraints the coordinates must be good.
  template <typename Vertices>
  bool is_known_to_be_degenerate(const Vertices& vertices) const
  {
    if(! is_in_range(m_input, vertices))
      return false;
    return has_geometry(m_input, vertices) ? is_degenerate(m_input, vertices, m_gt) : has_repeated_vertex(vertices);
  }

  bool is_every_vertex_known() const
  {
    const auto is_known = [&](const auto& simplex) { return has_geometry(m_input, simplex); };
    return std::all_of(m_input.facets.begin(), m_input.facets.end(), is_known) &&
           std::all_of(m_input.edges.begin(), m_input.edges.end(), is_known);
  }

  // Collects points until they span the space. Points that no constraint uses are vertices, too.
  bool is_flat() const
  {
    std::vector<const Point_3*> basis;
    for(std::size_t v = 0; v < m_used.size() && basis.size() < 4; ++v)
      if(has_finite_coordinates(m_input.points[v]) && is_independent(basis, m_input.points[v]))
        basis.push_back(&m_input.points[v]);
    return basis.size() < 4;
  }

  bool is_independent(const std::vector<const Point_3*>& basis, const Point_3& p) const
  {
    switch(basis.size())
    {
      case 0:  return true;
      case 1:  return ! m_gt.equal_3_object()(*basis[0], p);
      case 2:  return ! m_gt.collinear_3_object()(*basis[0], *basis[1], p);
      default: return m_gt.orientation_3_object()(*basis[0], *basis[1], *basis[2], p) != COPLANAR;
    }
  }

  const Input& m_input;
  const GT& m_gt;
  std::vector<char> m_used;
  std::vector<Defect> m_defects;
};

/// returns all the defects of `input` that are cheap to find, by kind in the order of `Input_defect_kind`, then by
/// index. It runs before anything else looks at the input, hence trusts nothing: constraints with an unknown vertex are
/// named once and left out of the checks they would disturb.
///
/// \param check_dimension whether flat input is a defect; it is none if the triangulation has points that may be
///        off the plane
template <typename GT>
std::vector<Input_defect_3<typename GT::Point_3> >
simple_defects(const Indexed_input_3<typename GT::Point_3>& input, const GT& gt, const bool check_dimension = true)
{
  Input_diagnosis_3<GT> diagnosis(input, gt);
  diagnosis.check_empty();
  diagnosis.check_coordinates();
  diagnosis.check_indices();
  diagnosis.check_degenerate_facets();
  diagnosis.check_degenerate_edges();
  diagnosis.check_duplicate_facets();
  diagnosis.check_coincident_vertices();
  if(check_dimension)
    diagnosis.check_dimension();
  return diagnosis.defects();
}

/*
 * Chooses some constraints of many, at random, but the same ones in each run. No rule in the order of the input can
 * keep those that matter out of all samples.
 */
class Constraint_sample
{
public:
  // So many of the facets and edges with these indices of the input; some may come several times. All of them if they
  // are no more.
  template <typename Point_3>
  std::vector<Input_simplex_3<Point_3> > operator()(const Indexed_input_3<Point_3>& input, const Lost_constraints& from,
                                                    const std::size_t number)
  {
    const std::size_t n = from.facets.size() + from.edges.size();
    std::vector<Input_simplex_3<Point_3> > result;
    for(std::size_t k = 0; k < number && k < n; ++k)
    {
      const std::size_t i = n <= number ? k : m_random() % n;
      result.push_back(i < from.facets.size() ? describe_facet(input, from.facets[i])
                                              : describe_edge(input, from.edges[i - from.facets.size()]));
    }
    return result;
  }

private:
  std::minstd_rand m_random; // always the same numbers
};

/*
 * Tells invalid input from difficult input, when constraints are missing after the recovery.
 *
 * Of two constraints that intersect at most one can be in a triangulation. So if any two do, then one that is missing
 * does, and it is enough to compare the missing ones with all. Only if this finds something, all pairs are computed.
 */
template <typename GT>
class Recovery_diagnosis
{
public:
  typedef typename GT::Point_3         Point_3;
  typedef Indexed_input_3<Point_3>     Input;
  typedef Input_defect_3<Point_3>      Defect;
  typedef Input_simplex_3<Point_3>     Simplex;

  // Of more than `max_number_of_defects`, a search returns the first ones.
  Recovery_diagnosis(const Input& input, const GT& gt, const std::size_t max_number_of_defects = std::size_t(-1))
    : m_input(input), m_gt(gt), m_max_number_of_defects(max_number_of_defects)
  { }

  // What the last search found; more than it returned if there are more. The number of pairs is a lower bound then.
  std::size_t number_of_defects() const { return m_number_of_defects; }

  // All pairs of constraints that intersect. None if `context` stopped the search.
  template <typename Context>
  std::vector<Defect> intersecting_pairs(Context& context)
  {
    const Constraint_intersections_3<GT> intersections(m_input, m_gt);
    return intersections.defects(context, m_max_number_of_defects, m_number_of_defects);
  }

  // The same if `missing` are constraints one of which takes part if there are any. Whether there are any is given up
  // after so many pairs of boxes.
  template <typename Context>
  std::vector<Defect> intersecting_pairs(const std::vector<Simplex>& missing, Context& context,
                                         const std::size_t max_number_of_box_pairs = std::size_t(-1))
  {
    m_number_of_defects = 0;
    const Constraint_intersections_3<GT> intersections(m_input, m_gt);
    if(intersections.have_defects(missing, context, max_number_of_box_pairs))
      return intersecting_pairs(context);
    return std::vector<Defect>();
  }

  // The given constraints with a vertex of the triangulation on them that is not theirs; none if `context` stopped the
  // search.
  template <typename Tr, typename Context>
  std::vector<Defect> vertices_on_constraints(const std::vector<Simplex>& constraints, const Tr& tr,
                                              const std::vector<typename Tr::Vertex_handle>& vertices,
                                              Context& context)
  {
    typedef typename Tr::Vertex_handle Vertex_handle;
    std::vector<Vertex_handle> all;
    std::vector<Box> vertex_boxes, constraint_boxes;
    const std::size_t n = constraints.size();
    for(std::size_t i = 0; i < n; ++i)
      constraint_boxes.push_back(Box(bbox(constraints[i].points), i));
    for(const Vertex_handle v : tr.finite_vertex_handles())
    {
      vertex_boxes.push_back(Box(v->point().bbox(), n + all.size()));
      all.push_back(v);
    }
    std::vector<std::pair<std::size_t, std::size_t> > found; // constraint and vertex
    const auto collect = [&](const std::size_t i, const std::size_t n_plus_k)
    {
      if(is_inside(all[n_plus_k - n]->point(), constraints[i]))
        found.push_back(std::make_pair(i, n_plus_k - n));
      return true;
    };
    internal::visit_intersecting_boxes(constraint_boxes, vertex_boxes, collect, context);
    m_number_of_defects = context.is_stopped() ? 0 : found.size();
    std::sort(found.begin(), found.end());
    found.resize((std::min)(m_number_of_defects, m_max_number_of_defects));
    std::vector<Defect> defects;
    if(found.empty())
      return defects;
    const Unique_hash_map<Vertex_handle, std::size_t> index = index_of_vertices(vertices);
    for(const auto& pair : found)
      defects.push_back(Defect{ Input_defect_kind::intersecting_constraints,
                                { describe(all[pair.second], index), constraints[pair.first] } });
    return defects;
  }

private:
  typedef Numbered_box_3 Box;

  // Of vertices of the input; the first one where it has several at one point. Others have no index.
  template <typename Vertex_handle>
  static Unique_hash_map<Vertex_handle, std::size_t> index_of_vertices(const std::vector<Vertex_handle>& vertices)
  {
    Unique_hash_map<Vertex_handle, std::size_t> index(Simplex::no_index, vertices.size());
    for(std::size_t i = vertices.size(); i-- > 0; )
      index[vertices[i]] = i;
    return index;
  }

  template <typename Vertex_handle>
  static Simplex describe(const Vertex_handle v, const Unique_hash_map<Vertex_handle, std::size_t>& index)
  {
    Simplex vertex;
    vertex.dimension = 0;
    vertex.points.assign(1, v->point());
    vertex.index = index[v];
    if(vertex.index != Simplex::no_index)
      vertex.vertices.assign(1, vertex.index);
    return vertex;
  }

  static Bbox_3 bbox(const std::vector<Point_3>& points)
  {
    Bbox_3 b;
    for(const Point_3& p : points)
      b += p.bbox();
    return b;
  }

  // Whether p is in the simplex, but not one of its vertices.
  bool is_inside(const Point_3& p, const Simplex& simplex) const
  {
    for(const Point_3& q : simplex.points)
      if(m_gt.equal_3_object()(p, q))
        return false;
    if(simplex.dimension == 1)
      return m_gt.collinear_3_object()(simplex.points[0], p, simplex.points[1])
          && m_gt.collinear_are_ordered_along_line_3_object()(simplex.points[0], p, simplex.points[1]);
    const auto triangle = m_gt.construct_triangle_3_object()(simplex.points[0], simplex.points[1], simplex.points[2]);
    return m_gt.has_on_3_object()(triangle, p);
  }

  const Input& m_input;
  const GT& m_gt;
  const std::size_t m_max_number_of_defects;
  std::size_t m_number_of_defects = 0;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_INPUT_INPUT_DIAGNOSIS_3_H

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

#include <CGAL/Boundary_recovery_3/internal/input/Indexed_input_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Hash_index.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

// The cheap half of the diagnosis: what can be seen without comparing constraints with each other.
// The other half is `Constraint_intersections_3.h`.

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

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

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_INPUT_INPUT_DIAGNOSIS_3_H

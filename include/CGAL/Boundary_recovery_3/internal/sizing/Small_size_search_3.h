// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIZING_SMALL_SIZE_SEARCH_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIZING_SMALL_SIZE_SEARCH_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/shape/Cell_shape_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Region_sizes_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Searches cells for places where the size field is far smaller than at their centroids, by branch and bound: a cell is
 * bisected until such a place is found, or all pieces are certain, that is, the field is known to be nowhere far
 * smaller in the ball around each. Where the field does not tell bounds, the search is given up for good; in a cell
 * where too many questions would be needed, it ends for this cell. It is not complete from then on. After some places
 * without success, a cell is left, too: there is no room in it.
 */
template <typename Tr>
class Small_size_search_3
{
public:
  typedef typename Tr::Cell_handle     Cell_handle;
  typedef Region_sizes_3<Tr>           Sizes;
  typedef std::array<Coordinates_3, 4> Corners;

  // As parts of the size, see "Tuning constants" in the manual: what is searched for, and what may be missed.
  static constexpr double small = 0.25;
  static constexpr double certain = 0.125;

  explicit Small_size_search_3(Sizes& sizes) : m_sizes(sizes) { }

  // More questions can be asked for each vertex that there is.
  void add_vertices(const std::size_t number) { m_number_of_questions_left += questions_per_vertex * number; }

  // Calls `is_done(p)` for places p in a cell with sizes that are small compared with `size`, until it returns true.
  // Returns whether it did.
  template <typename Is_done>
  bool operator()(const Cell_handle c, const Corners& corners, const double size, const Is_done& is_done)
  {
    std::size_t tries_left = max_number_of_tries;
    m_number_after_cell = m_number_of_questions_left - (std::min)(m_number_of_questions_left, questions_per_cell);
    m_pieces.assign(1, corners);
    m_is_given_up = ! m_is_bounded;
    while(! m_pieces.empty() && ! m_is_given_up && tries_left > 0)
    {
      const Corners piece = m_pieces.back();
      const Coordinates_3 center = internal::centroid(piece);
      const double radius = internal::largest_distance(center, piece);
      m_pieces.pop_back();
      if(m_sizes.known_least_size(c, corners, center, radius) >= certain * size
         || is_certain(center, radius, m_sizes.region(c), size))
        continue;
      const double h = ! m_is_given_up ? m_sizes.of_field(center, m_sizes.region(c)) : 0;
      if(! (h > 0)) // nobody knows, or there is none
        return false;
      const bool is_small = h < small * size;
      if(is_small && is_done(center))
        return true;
      tries_left -= is_small;
      if(! is_small || radius > h) // else all of the piece is nearer to that place than points may be
        bisect(piece);
    }
    return false;
  }

  // Of a part of the mesh.
  void take_over(const Small_size_search_3& part)
  {
    m_is_bounded = m_is_bounded && part.m_is_bounded;
    m_is_complete = m_is_complete && part.m_is_complete;
  }

  // Whether nothing was given up.
  bool is_complete() const { return m_is_complete; }

private:
  static constexpr std::size_t max_number_of_tries = 8;
  static constexpr std::size_t least_number_of_questions = 100000;
  static constexpr std::size_t questions_per_vertex = 2000;
  static constexpr std::size_t questions_per_cell = 100000;

  // Whether sizes are large enough in a ball. The search is given up if no question is left, and for good if the field
  // tells no bound even of the size at the center.
  bool is_certain(const Coordinates_3& center, const double radius, const int region, const double size)
  {
    const bool is_question_left = m_number_of_questions_left > m_number_after_cell;
    m_number_of_questions_left -= is_question_left;
    const double least = m_sizes.least_size_around(center, radius, region);
    m_is_bounded = least > 0 || m_sizes.least_size_around(center, 0, region) > 0;
    m_is_given_up = ! m_is_bounded || ! is_question_left;
    m_is_complete = m_is_complete && ! m_is_given_up;
    return least >= certain * size;
  }

  void bisect(const Corners& piece)
  {
    const Tetrahedron_edge_3 edge = internal::longest_edge(piece);
    const Coordinates_3 middle = internal::midpoint(piece[edge.i], piece[edge.j]);
    for(const int end : { edge.i, edge.j })
    {
      m_pieces.push_back(piece);
      m_pieces.back()[end] = middle;
    }
  }

  Sizes& m_sizes;
  std::vector<Corners> m_pieces; // that have to be looked at
  std::size_t m_number_of_questions_left = least_number_of_questions;
  std::size_t m_number_after_cell = 0; // of questions that have to be left then
  bool m_is_given_up = false; // in this cell
  bool m_is_bounded = true;
  bool m_is_complete = true;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIZING_SMALL_SIZE_SEARCH_3_H

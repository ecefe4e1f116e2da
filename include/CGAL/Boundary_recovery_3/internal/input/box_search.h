// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_INPUT_BOX_SEARCH_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_INPUT_BOX_SEARCH_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/box_intersection_d.h>

#include <cstddef>
#include <vector>

// CGAL's box intersection, as in PMP::self_intersections(), that can be stopped.

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

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

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_INPUT_BOX_SEARCH_H

// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_BOX_HIERARCHY_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_BOX_HIERARCHY_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/filling/Unit_frame_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * A tree of boxes around things in space, in which the thing that makes some value smallest is searched for by branch
 * and bound.
 *
 * The things are brought into an order in which each leaf is a block of `leaf_size` of them, and each node a range of
 * blocks. All leaves but the last are full, and the depth is the logarithm of their number: nothing needs a pointer. The
 * boxes are rounded outwards to single precision, for which coordinates should be those of a unit frame.
 */
class Box_hierarchy_3
{
public:
  static constexpr std::size_t leaf_size = 8;

  // Orders things whose boxes these are; `order()` tells where they went.
  explicit Box_hierarchy_3(const std::vector<Axis_box_3>& boxes = std::vector<Axis_box_3>())
    : m_size(boxes.size()), m_number_of_leaves((boxes.size() + leaf_size - 1) / leaf_size)
  {
    m_order.resize(boxes.size());
    for(std::size_t i = 0; i < boxes.size(); ++i)
      m_order[i] = i;
    if(m_number_of_leaves == 0)
      return;
    m_boxes.resize(2 * m_number_of_leaves - 1);
    for_each_node([&](const Node& node) { m_boxes[node.index] = arrange(boxes, node); });
  }

  bool is_empty() const { return m_boxes.empty(); }
  std::size_t number_of_nodes() const { return m_boxes.size(); }
  std::size_t number_of_leaves() const { return m_number_of_leaves; }

  // The number of the thing at each position.
  const std::vector<std::size_t>& order() const { return m_order; }

  // Frees the memory of the order.
  void forget_order() { std::vector<std::size_t>().swap(m_order); }

  // Calls `visit(node, first, last)` for all nodes, children after their parents, with the positions of the things.
  template <typename Visit>
  void visit_nodes(const Visit& visit) const
  {
    for_each_node([&](const Node& node)
    {
      visit(node.index, node.first * leaf_size, (std::min)(m_size, (node.first + node.size) * leaf_size));
    });
  }

  /*
   * Searches for the smallest value. `bound(node, distance)` is at most what the things in a node have as values, if
   * their boxes are that far away from p; `visit(leaf)` looks at the things in a leaf, and returns the value that those
   * which are still of interest have to fall below.
   */
  template <typename Bound, typename Visit>
  void search(const Coordinates_3& p, const Bound& bound, const Visit& visit) const
  {
    if(is_empty())
      return;
    std::array<Waiting, max_depth> stack;
    std::size_t top = 0;
    double limit = std::numeric_limits<double>::infinity();
    Node node = root();
    for(;;)
    {
      while(node.size > 1)
      {
        Node near = node.left(), far = node.right();
        double near_bound = bound(near.index, distance(near, p)), far_bound = bound(far.index, distance(far, p));
        if(far_bound < near_bound)
        {
          std::swap(near, far);
          std::swap(near_bound, far_bound);
        }
        if(far_bound < limit)
          stack[top++] = Waiting{ far, far_bound };
        if(! (near_bound < limit))
          break;
        node = near;
      }
      if(node.size == 1)
        limit = visit(node.first);
      while(top > 0 && ! (stack[top - 1].bound < limit))
        --top;
      if(top == 0)
        return;
      node = stack[--top].node;
    }
  }

private:
  // a node in the order of a traversal from the root, and the leaves below it
  struct Node
  {
    std::uint32_t index, first, size;

    // the subtree of n leaves has 2 n - 1 nodes
    Node left() const { return Node{ index + 1, first, (size + 1) / 2 }; }
    Node right() const { return Node{ index + 2 * ((size + 1) / 2), first + (size + 1) / 2, size / 2 }; }
  };

  struct Waiting
  {
    Node node;
    double bound;
  };

  struct Box
  {
    std::array<float, 3> lower, upper;
  };

  static constexpr std::size_t max_depth = 33; // of numbers of leaves with 32 bits, one node of each depth may wait

  Node root() const { return Node{ 0, 0, static_cast<std::uint32_t>(m_number_of_leaves) }; }

  // Parents come before their children, left ones before right ones.
  template <typename Function>
  void for_each_node(const Function& function) const
  {
    std::vector<Node> waiting;
    if(m_number_of_leaves > 0)
      waiting.push_back(root());
    while(! waiting.empty())
    {
      const Node node = waiting.back();
      waiting.pop_back();
      function(node);
      if(node.size > 1)
      {
        waiting.push_back(node.right());
        waiting.push_back(node.left());
      }
    }
  }

  // Returns the box of a node, and parts the things below it by their centers, if there are two children.
  Box arrange(const std::vector<Axis_box_3>& boxes, const Node& node)
  {
    const auto position = [&](const std::size_t leaf)
    {
      return m_order.begin() + static_cast<std::ptrdiff_t>((std::min)(leaf * leaf_size, m_size));
    };
    const auto first = position(node.first), last = position(node.first + node.size);
    Axis_box_3 box, centers;
    std::for_each(first, last, [&](const std::size_t i) { box.add(boxes[i]); centers.add(boxes[i].center()); });
    if(node.size > 1)
    {
      const int axis = longest_axis(centers);
      const auto center = [&](const std::size_t i) { return boxes[i].lower[axis] + boxes[i].upper[axis]; };
      std::nth_element(first, position(node.right().first), last, [&](const std::size_t i, const std::size_t j)
      {
        return center(i) != center(j) ? center(i) < center(j) : i < j;
      });
    }
    return round_outwards(box);
  }

  static int longest_axis(const Axis_box_3& box)
  {
    const Coordinates_3 sides = difference(box.upper, box.lower);
    return static_cast<int>(std::max_element(sides.begin(), sides.end()) - sides.begin());
  }

  static Box round_outwards(const Axis_box_3& box)
  {
    static constexpr float infinity = std::numeric_limits<float>::infinity();
    Box result;
    for(int i = 0; i < 3; ++i)
    {
      result.lower[i] = std::nextafter(static_cast<float>(box.lower[i]), - infinity);
      result.upper[i] = std::nextafter(static_cast<float>(box.upper[i]), infinity);
    }
    return result;
  }

  double distance(const Node& node, const Coordinates_3& p) const
  {
    const Box& box = m_boxes[node.index];
    double squared = 0;
    for(int i = 0; i < 3; ++i)
    {
      const double d = (std::max)((std::max)(box.lower[i] - p[i], p[i] - box.upper[i]), 0.);
      squared += d * d;
    }
    return std::sqrt(squared);
  }

  std::size_t m_size;
  std::size_t m_number_of_leaves;
  std::vector<Box> m_boxes;         // of the nodes, parents before their children
  std::vector<std::size_t> m_order;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_BOX_HIERARCHY_3_H

// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHAPE_BOX_HIERARCHY_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHAPE_BOX_HIERARCHY_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * A tree of boxes around things in space, in which those things are found that may make a value smaller.
 *
 * The things are brought into an order in which each leaf is a block of `leaf_size` of them. All leaves but the last
 * are full, and the leaves below a node are parted evenly among its four children. The boxes of the children are side
 * by side, in single precision and rounded outwards, so that the compiler can compute their distances at once;
 * coordinates should be those of a unit frame.
 */
template <std::size_t leaf_size>
class Box_hierarchy_3
{
public:
  static constexpr std::size_t arity = 4;

  // Orders things whose boxes these are; `order()` tells where they went.
  explicit Box_hierarchy_3(const std::vector<Axis_box_3>& boxes = std::vector<Axis_box_3>())
    : m_size(boxes.size()), m_order(boxes.size())
  {
    std::iota(m_order.begin(), m_order.end(), std::size_t(0));
    if(m_size > 0)
      build(boxes);
  }

  std::size_t number_of_leaves() const { return (m_size + leaf_size - 1) / leaf_size; }

  // The number of the thing at each position.
  const std::vector<std::size_t>& order() const { return m_order; }

  // Brings the things themselves into the order, and forgets it.
  template <typename Thing>
  void put_into_order(std::vector<Thing>& things)
  {
    std::vector<Thing> ordered;
    ordered.reserve(things.size());
    for(const std::size_t i : m_order)
      ordered.push_back(things[i]);
    things.swap(ordered);
    forget_order();
  }

  // Frees the memory of the order.
  void forget_order() { std::vector<std::size_t>().swap(m_order); }

  // Children are named by the numbers below this one; some of them name nothing.
  std::size_t number_of_children() const { return arity * m_nodes.size(); }

  // Calls `visit(child, first, last)` with the positions of the things below each child.
  template <typename Visit>
  void visit_children(const Visit& visit) const
  {
    std::vector<Subtree> waiting;
    if(m_size > 0)
      waiting.push_back(Subtree{ 0, 0, number_of_leaves() });
    while(! waiting.empty())
    {
      const Subtree tree = waiting.back();
      waiting.pop_back();
      const Parts parts = parts_of(tree);
      for(std::size_t i = 0; i < arity; ++i)
        if(parts[i] < parts[i + 1])
        {
          visit(arity * tree.node + i, position(parts[i]), position(parts[i + 1]));
          if(parts[i + 1] - parts[i] > 1)
            waiting.push_back(Subtree{ m_nodes[tree.node].children[i], parts[i], parts[i + 1] });
        }
    }
  }

  /*
   * Looks at the things near p, near ones first, roughly. `is_of_interest(child, distance)` is asked whether it is
   * worth while to look there, and once more when its turn has come; no thing below the child is nearer than the root
   * of `distance`. `visit(leaf)` looks at the things in a leaf.
   */
  template <typename Is_of_interest, typename Visit>
  void search(const Coordinates_3& p, const Is_of_interest& is_of_interest, const Visit& visit) const
  {
    if((std::max)({ std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) }) < far_away)
    {
      if(m_size > 0)
        search_tree(Rounded_point(p), is_of_interest, visit);
    }
    else // the squares would be infinite
      for(std::size_t leaf = 0; leaf < number_of_leaves(); ++leaf)
        visit(leaf);
  }

private:
  typedef std::array<float, arity> Floats;

  // the four boxes of the children of a node; those of missing ones have sides of length minus infinity
  struct Node
  {
    std::array<Floats, 3> center, half_side;
    std::array<std::uint32_t, arity> children; // numbers of nodes, or of leaves with a bit set
  };

  // a node, and the range of the leaves below it
  struct Subtree
  {
    std::size_t node, first, last;
  };

  typedef std::array<std::size_t, arity + 1> Parts; // the leaves where the children begin, and the end of the last one

  struct Waiting
  {
    float distance; // squared
    std::uint32_t child, target;
  };

  // a point in single precision, and by how much differences to its coordinates may be wrong because of that
  struct Rounded_point
  {
    explicit Rounded_point(const Coordinates_3& p)
    {
      for(int i = 0; i < 3; ++i)
      {
        point[i] = static_cast<float>(p[i]);
        error[i] = std::abs(point[i]) * relative_error + (std::numeric_limits<float>::min)();
      }
    }

    std::array<float, 3> point, error;
  };

  static constexpr std::uint32_t leaf_bit = 0x80000000u;
  static constexpr std::size_t max_waiting = 64;  // three of each depth but the last, four there
  static constexpr double far_away = 1e18;
  static constexpr float relative_error = 2 * std::numeric_limits<float>::epsilon(); // of a few operations
  static constexpr float rounding = 1 - 1e-6f;    // makes up for that of squares, and of their sums

  std::size_t position(const std::size_t leaf) const { return (std::min)(leaf * leaf_size, m_size); }

  static std::size_t middle_of(const std::size_t first, const std::size_t last)
  {
    return first + (last - first + 1) / 2;
  }

  static Parts parts_of(const Subtree& tree)
  {
    const std::size_t middle = middle_of(tree.first, tree.last);
    return {{ tree.first, middle_of(tree.first, middle), middle, middle_of(middle, tree.last), tree.last }};
  }

  // Nodes come in the order in which a traversal from the root meets them.
  void build(const std::vector<Axis_box_3>& boxes)
  {
    std::vector<std::pair<Subtree, std::uint32_t*> > waiting;
    m_nodes.reserve(number_of_leaves()); // nothing moves
    waiting.emplace_back(Subtree{ 0, 0, number_of_leaves() }, nullptr);
    while(! waiting.empty())
    {
      const Subtree tree = waiting.back().first;
      if(waiting.back().second != nullptr)
        *waiting.back().second = static_cast<std::uint32_t>(m_nodes.size());
      waiting.pop_back();
      m_nodes.emplace_back();
      const Parts parts = arrange(boxes, tree);
      for(std::size_t i = arity; i-- > 0; )
      {
        set_box(m_nodes.back(), i, box_of(boxes, parts[i], parts[i + 1]));
        m_nodes.back().children[i] = leaf_bit | static_cast<std::uint32_t>(parts[i]);
        if(parts[i + 1] > parts[i] + 1)
          waiting.emplace_back(Subtree{ 0, parts[i], parts[i + 1] }, &m_nodes.back().children[i]);
      }
    }
    m_nodes.shrink_to_fit();
  }

  // Parts the things below a node among its children.
  Parts arrange(const std::vector<Axis_box_3>& boxes, const Subtree& tree)
  {
    const Parts parts = parts_of(tree);
    divide(boxes, parts[0], parts[2], parts[4]);
    divide(boxes, parts[0], parts[1], parts[2]);
    divide(boxes, parts[2], parts[3], parts[4]);
    return parts;
  }

  // Brings the things with smaller centers before `middle`.
  void divide(const std::vector<Axis_box_3>& boxes, const std::size_t first, const std::size_t middle,
              const std::size_t last)
  {
    if(first == middle || middle == last)
      return;
    Axis_box_3 centers;
    for(std::size_t k = position(first); k < position(last); ++k)
      centers.add(boxes[m_order[k]].center());
    const int axis = longest_axis(centers);
    const auto center = [&](const std::size_t i) { return boxes[i].lower[axis] + boxes[i].upper[axis]; };
    std::nth_element(place(first), place(middle), place(last), [&](const std::size_t i, const std::size_t j)
    {
      return center(i) != center(j) ? center(i) < center(j) : i < j;
    });
  }

  std::vector<std::size_t>::iterator place(const std::size_t leaf)
  {
    return m_order.begin() + static_cast<std::ptrdiff_t>(position(leaf));
  }

  static int longest_axis(const Axis_box_3& box)
  {
    const Coordinates_3 sides = difference(box.upper, box.lower);
    return static_cast<int>(std::max_element(sides.begin(), sides.end()) - sides.begin());
  }

  Axis_box_3 box_of(const std::vector<Axis_box_3>& boxes, const std::size_t first, const std::size_t last) const
  {
    Axis_box_3 box;
    for(std::size_t k = position(first); k < position(last); ++k)
      box.add(boxes[m_order[k]]);
    return box;
  }

  static void set_box(Node& node, const std::size_t child, const Axis_box_3& box)
  {
    static constexpr float infinity = std::numeric_limits<float>::infinity();
    for(int i = 0; i < 3; ++i)
    {
      const float c = static_cast<float>(box.center()[i]);
      const float half_side = static_cast<float>((std::max)(box.upper[i] - c, c - box.lower[i]));
      node.center[i][child] = c;
      node.half_side[i][child] = box.is_empty() ? - infinity
                               : std::nextafter(half_side, infinity) + std::abs(c) * relative_error;
    }
  }

  template <typename Is_of_interest, typename Visit>
  void search_tree(const Rounded_point& p, const Is_of_interest& is_of_interest, const Visit& visit) const
  {
    std::array<Waiting, max_waiting> stack;
    std::size_t top = 0;
    std::uint32_t target = 0;
    for(;;)
    {
      if((target & leaf_bit) != 0)
        visit(target & ~leaf_bit);
      else
        add_children(target, p, is_of_interest, stack, top);
      do
        if(top-- == 0)
          return;
      while(! is_of_interest(stack[top].child, stack[top].distance));
      target = stack[top].target;
    }
  }

  // The nearest one is put on top.
  template <typename Is_of_interest>
  void add_children(const std::uint32_t n, const Rounded_point& p, const Is_of_interest& is_of_interest,
                    std::array<Waiting, max_waiting>& stack, std::size_t& top) const
  {
    const Node& node = m_nodes[n];
    const Floats distances = squared_distances(node, p);
    const std::size_t bottom = top;
    for(std::uint32_t i = 0; i < arity; ++i)
      if(distances[i] < std::numeric_limits<float>::infinity()
         && is_of_interest(static_cast<std::uint32_t>(arity) * n + i, distances[i]))
      {
        std::size_t k = top++;
        for(; k > bottom && stack[k - 1].distance < distances[i]; --k)
          stack[k] = stack[k - 1];
        stack[k] = Waiting{ distances[i], static_cast<std::uint32_t>(arity) * n + i, node.children[i] };
      }
  }

  // Without comparisons, which compilers do not make of several numbers at once: x + |x| is 0, or 2 x.
  static Floats squared_distances(const Node& node, const Rounded_point& p)
  {
    Floats squares = {{ 0, 0, 0, 0 }};
    for(int i = 0; i < 3; ++i)
      for(std::size_t k = 0; k < arity; ++k)
      {
        const float x = std::abs(node.center[i][k] - p.point[i]) - (node.half_side[i][k] + p.error[i]);
        const float distance = (x + std::abs(x)) / 2;
        squares[k] += distance * distance;
      }
    for(std::size_t k = 0; k < arity; ++k)
      squares[k] *= rounding;
    return squares;
  }

  std::size_t m_size;
  std::vector<std::size_t> m_order;
  std::vector<Node> m_nodes;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHAPE_BOX_HIERARCHY_3_H

// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_FACE_MATCHING_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_FACE_MATCHING_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/cavity/Tetrahedralization_search.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Selects tetrahedra that fill a polyhedron, from nothing but the knowledge at which sides of which faces they are.
 *
 * The inner side of each face of the boundary needs a tetrahedron. Where one is selected, the other side of each of its
 * other faces needs one. No side may have two. This is enough: the boundaries of the selected tetrahedra then add up to
 * that of the polyhedron, and all of them are positively oriented, so a point in no face is in exactly one of them if
 * it is in the polyhedron, and in none if it is not.
 *
 * Propagation: a side without tetrahedra rules out those at the other side of the face, and so on. In large cavities
 * that alone mostly finds that there is no solution. What is left is decided by depth-first search.
 */
class Face_matching
  : public Tetrahedralization_search
{
public:
  // A face has two sides, s and opposite(s).
  typedef std::uint32_t          Side;
  typedef std::array<Side, 4>    Sides;

  static constexpr Side opposite(const Side s) { return s ^ 1; }

  // `tetrahedra` are given by the sides of their faces at which they are, `boundary` by the inner sides; no tetrahedron
  // is at an outer side of the boundary.
  Outcome operator()(const std::size_t number_of_sides, const std::vector<Sides>& tetrahedra,
                     const std::vector<Side>& boundary, const std::size_t max_number_of_steps)
  {
    CGAL_precondition(number_of_sides < no_side && 4 * tetrahedra.size() < no_side);
    initialize(number_of_sides, tetrahedra, boundary);
    CGAL_precondition(std::all_of(boundary.begin(), boundary.end(),
                                  [this](const Side s) { return m_number[opposite(s)] == 0; }));
    return search(max_number_of_steps);
  }

  // The positions of the tetrahedra that were found, in no particular order.
  std::vector<std::size_t> selection() const
  {
    std::vector<std::size_t> result;
    for(const Side s : m_needed)
      result.push_back(first_remaining(s));
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

private:
  typedef std::uint32_t Number; // of tetrahedra, or their positions: there may be many, so memory counts

  static constexpr Side no_side = (std::numeric_limits<Side>::max)();

  void initialize(const std::size_t number_of_sides, const std::vector<Sides>& tetrahedra,
                  const std::vector<Side>& boundary)
  {
    m_tetrahedra = &tetrahedra;
    m_needed = boundary;
    m_is_needed.assign(number_of_sides, false);
    m_is_outer.assign(number_of_sides, false);
    for(const Side s : boundary)
    {
      m_is_needed[s] = true;
      m_is_outer[opposite(s)] = true;
    }
    m_is_removed.assign(tetrahedra.size(), false);
    m_removed.clear();
    sort_by_sides(number_of_sides);
    m_queue.clear();
    for(Side s = 0; s < number_of_sides; ++s)
      if(m_number[s] <= 1 && ! m_is_outer[s])
        m_queue.push_back(s);
  }

  void sort_by_sides(const std::size_t number_of_sides)
  {
    m_number.assign(number_of_sides, 0);
    for(const Sides& sides : *m_tetrahedra)
      for(const Side s : sides)
        ++m_number[s];
    m_first.assign(1, 0);
    for(const Number n : m_number)
      m_first.push_back(m_first.back() + n);
    m_tetrahedra_at.resize(m_first.back());
    std::vector<Number> next(m_first.begin(), m_first.end() - 1);
    for(Number t = 0; t < m_tetrahedra->size(); ++t)
      for(const Side s : (*m_tetrahedra)[t])
        m_tetrahedra_at[next[s]++] = t;
  }

  // Calls `work` with each tetrahedron at the side that is not removed; it may remove that.
  template <typename Work>
  void for_each_at(const Side s, const Work& work) const
  {
    for(Number i = m_first[s]; i < m_first[s + 1]; ++i)
      if(! m_is_removed[m_tetrahedra_at[i]])
        work(m_tetrahedra_at[i]);
  }

  // There has to be one.
  Number first_remaining(const Side s) const
  {
    return *std::find_if(m_tetrahedra_at.begin() + m_first[s], m_tetrahedra_at.begin() + m_first[s + 1],
                         [this](const Number t) { return ! m_is_removed[t]; });
  }

  // --- propagation ---------------------------------------------------------------------------------------------------

  void remove(const Number t)
  {
    m_is_removed[t] = true;
    m_removed.push_back(t);
    for(const Side s : (*m_tetrahedra)[t])
      if(--m_number[s] <= 1)
        m_queue.push_back(s);
  }

  void require(const Side s)
  {
    if(m_is_needed[s])
      return;
    m_is_needed[s] = true;
    m_needed.push_back(s);
    m_queue.push_back(s);
  }

  void select(const Number t)
  {
    for(const Side s : (*m_tetrahedra)[t])
    {
      for_each_at(s, [&](const Number u) { if(u != t) remove(u); });
      if(! m_is_outer[opposite(s)])
        require(opposite(s));
    }
  }

  // Returns false if a side that needs a tetrahedron has none left.
  bool propagate()
  {
    for(std::size_t k = 0; k < m_queue.size(); ++k) // it grows
    {
      const Side s = m_queue[k];
      if(m_number[s] == 0)
      {
        if(m_is_needed[s])
          return false;
        for_each_at(opposite(s), [&](const Number t) { remove(t); });
      }
      else if(m_number[s] == 1 && m_is_needed[s])
        select(first_remaining(s));
    }
    m_queue.clear();
    return true;
  }

  // --- the search ----------------------------------------------------------------------------------------------------

  struct Choice
  {
    Number tetrahedron;
    std::size_t number_of_removed; // before the choice, as the following
    std::size_t number_of_needed;
  };

  // Depth-first, without recursion.
  Outcome search(const std::size_t max_number_of_steps)
  {
    m_choices.clear();
    for(std::size_t number_of_steps = 0; ; )
    {
      while(! propagate())
      {
        if(m_choices.empty())
          return NONE;
        remove(take_back());
      }
      const Side s = hardest_side();
      if(s == no_side)
        return FOUND;
      if(++number_of_steps > max_number_of_steps)
        return GAVE_UP;
      m_choices.push_back({ first_remaining(s), m_removed.size(), m_needed.size() });
      select(m_choices.back().tetrahedron);
    }
  }

  // The side that needs a tetrahedron, has none selected, and has the fewest left.
  Side hardest_side() const
  {
    Side result = no_side;
    for(const Side s : m_needed)
      if(m_number[s] > 1 && (result == no_side || m_number[s] < m_number[result]))
        result = s;
    return result;
  }

  // Undoes the last choice and all that followed from it, and returns it.
  Number take_back()
  {
    m_queue.clear();
    const Choice choice = m_choices.back();
    m_choices.pop_back();
    for(; m_removed.size() > choice.number_of_removed; m_removed.pop_back())
    {
      m_is_removed[m_removed.back()] = false;
      for(const Side s : (*m_tetrahedra)[m_removed.back()])
        ++m_number[s];
    }
    for(; m_needed.size() > choice.number_of_needed; m_needed.pop_back())
      m_is_needed[m_needed.back()] = false;
    return choice.tetrahedron;
  }

  const std::vector<Sides>* m_tetrahedra = nullptr;
  std::vector<Number> m_first;              // of each side, where its tetrahedra begin
  std::vector<Number> m_tetrahedra_at;      // of one side after the other
  std::vector<Number> m_number;             // of the tetrahedra left at each side
  std::vector<char> m_is_removed;           // of each tetrahedron
  std::vector<Number> m_removed;            // in the order of removal
  std::vector<char> m_is_needed;            // of each side, whether it needs a tetrahedron
  std::vector<Side> m_needed;               // in the order in which this was found
  std::vector<char> m_is_outer;             // of each side, whether it is on the boundary, outside
  std::vector<Side> m_queue;                // those to look at
  std::vector<Choice> m_choices;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_FACE_MATCHING_H

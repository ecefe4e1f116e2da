// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHELL_SHELL_ELEMENTS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHELL_SHELL_ELEMENTS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Shell_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/shell/Shell_positivity_3.h>
#include <CGAL/Boundary_recovery_3/internal/shell/position_tables.h>

#include <boost/container/vector.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * What is known of the triangles and chords of the skirt polygon of a shell: whether they are valid, and the values of
 * the triangles. Each is asked for once at most.
 */
template <typename Tr, typename Quality, typename Validity>
class Shell_elements_3
{
public:
  typedef Shell_3<Tr>              Shell;
  typedef Vertex_predicates_3<Tr>  Predicates;
  typedef typename Quality::Value  Value;

  Shell_elements_3(const Predicates& predicates, const Quality& quality, const Validity& validity)
    : m_predicates(predicates), m_quality(quality), m_validity(validity)
  { }

  // Nothing is known yet.
  void assign(const Shell& shell)
  {
    m_shell = &shell;
    m = shell.degree();
    const std::size_t number_of_triangles = m * m * m;
    m_triangles.assign(number_of_triangles, UNKNOWN);
    if(m_triangle_values.size() < number_of_triangles)
      m_triangle_values.resize(number_of_triangles);
    m_known_chords.clear(m);
    m_valid_chords.clear(m);
  }

  // For i < j.
  bool is_valid_chord(const int i, const int j)
  {
    if(! m_known_chords.contains(i, j))
    {
      m_known_chords.insert(i, j);
      if(m_validity.is_valid_chord(*m_shell, i, j))
        m_valid_chords.insert(i, j);
    }
    return m_valid_chords.contains(i, j);
  }

  bool is_valid_triangle(int i, int k, int j)
  {
    unsigned char& state = m_triangles[triangle(i, k, j)];
    if(state == UNKNOWN)
      state = Shell_positivity_3<Tr>(*m_shell, m_predicates).is_triangle_positive(i, k, j)
           && m_validity.is_valid_triangle(*m_shell, i, k, j) ? VALID : INVALID;
    return state != INVALID;
  }

  // Of a valid triangle.
  const Value& triangle_value(int i, int k, int j)
  {
    const int t = triangle(i, k, j);
    if(m_triangles[t] == VALID)
    {
      m_triangles[t] = VALUED;
      m_triangle_values[t] = m_quality.of_triangle(*m_shell, i, k, j);
    }
    return m_triangle_values[t];
  }

private:
  enum Triangle_state { UNKNOWN, INVALID, VALID, VALUED };

  // Where what is known of a triangle is stored. The same one comes in three rotations; this makes i the smallest.
  int triangle(int& i, int& k, int& j) const
  {
    while(k < i || j < i)
    {
      const int first = i;
      i = k; k = j; j = first;
    }
    return (i * m + k) * m + j;
  }

  const Predicates& m_predicates;
  const Quality& m_quality;
  const Validity& m_validity;

  const Shell* m_shell = nullptr;
  int m = 0;
  std::vector<unsigned char> m_triangles;            // what is known of each triangle
  boost::container::vector<Value> m_triangle_values; // of those that are VALUED
  Position_pairs m_known_chords;                     // i < j for which the validity was asked for
  Position_pairs m_valid_chords;                     // those of them that are valid
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHELL_SHELL_ELEMENTS_3_H

// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_MEDIT_WRITER_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_MEDIT_WRITER_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/number_utils.h>

#include <cstddef>

namespace CGAL::Boundary_recovery_3::internal {

// Writes the sections of MEDIT's text format to a stream of the standard library, or to a faster one.
template <typename Stream>
class Medit_writer
{
  Stream& m_os;

public:
  explicit Medit_writer(Stream& os) : m_os(os) { m_os << "MeshVersionFormatted 2\nDimension 3\n"; }

  // `point(i)` is a point without a weight.
  template <typename PointOf>
  void write_vertices(const std::size_t n, const PointOf& point)
  {
    m_os << "Vertices\n" << n << '\n';
    for(std::size_t i = 0; i < n; ++i)
    {
      const auto& p = point(i);
      m_os << CGAL::to_double(p.x()) << ' ' << CGAL::to_double(p.y()) << ' ' << CGAL::to_double(p.z()) << " 0\n";
    }
  }

  // `with_vertices(i, f)` calls a function with the numbers of the vertices of a simplex, from 0; its reference is the
  // number of what it is in.
  template <typename WithVertices, typename References>
  void write_simplices(const char* keyword, const std::size_t n, const WithVertices& with_vertices,
                       const References& references)
  {
    m_os << keyword << '\n' << n << '\n';
    for(std::size_t i = 0; i < n; ++i)
    {
      with_vertices(i, [&](const auto& vertices)
      {
        for(const auto v : vertices)
          m_os << std::size_t(v) + 1 << ' ';
      });
      m_os << references[i] << '\n';
    }
  }

  void write_end() { m_os << "End\n"; }
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_MEDIT_WRITER_H

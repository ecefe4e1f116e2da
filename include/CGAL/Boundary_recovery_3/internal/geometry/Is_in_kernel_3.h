// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_IS_IN_KERNEL_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_IS_IN_KERNEL_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

// Whether none of the faces of a polyhedron is hidden from a point. Where points are tried one after the other, the
// next one is likely to be on the wrong side of the same face, so this is asked for first.
class Is_none_hidden
{
public:
  template <typename FaceRange, typename Is_hidden>
  bool operator()(const FaceRange& faces, const Is_hidden& is_hidden) const
  {
    if(m_last_hidden < faces.size() && is_hidden(faces[m_last_hidden]))
      return false;
    const auto hidden = std::find_if(faces.begin(), faces.end(), is_hidden);
    m_last_hidden = static_cast<std::size_t>(hidden - faces.begin());
    return hidden == faces.end();
  }

private:
  mutable std::size_t m_last_hidden = 0; // the position of a face that the last point did not see
};

/*
 * Decides exactly whether a vertex is in the open visibility kernel of a polyhedron: whether it sees all the faces from
 * inside. Each of the faces has the polyhedron on its positive side.
 */
template <typename Tr>
class Is_in_kernel_3
{
public:
  typedef typename Tr::Vertex_handle     Vertex_handle;
  typedef Vertex_predicates_3<Tr>        Predicates;
  typedef std::array<Vertex_handle, 3>   Vertex_triple;

  explicit Is_in_kernel_3(const Predicates& predicates) : m_predicates(predicates) { }

  bool operator()(const Vertex_handle v, const std::vector<Vertex_triple>& faces) const
  {
    return m_is_none_hidden(faces, [&](const Vertex_triple& f)
    {
      return m_predicates.orientation(f[0], f[1], f[2], v) != POSITIVE;
    });
  }

private:
  const Predicates& m_predicates;
  Is_none_hidden m_is_none_hidden;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_IS_IN_KERNEL_3_H

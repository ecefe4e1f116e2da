// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_IMPROVE_DOMAIN_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_IMPROVE_DOMAIN_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Quality_improvement_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

// Holds the place of the improvement, and changes nothing.
template <typename Tr, typename Domain, typename Quality, typename Visitor>
class Improve_domain_3
{
public:
  Improve_domain_3(Tr& /* tr */, Domain& /* domain */, const Quality& /* quality */,
                   Recovery_context<Visitor>& context)
    : m_context(context)
  { }

  void operator()(const double /* min_dihedral_angle */) { m_context.go_further(); }

  const Quality_improvement_counts& counts() const { return m_counts; }

private:
  Recovery_context<Visitor>& m_context;
  Quality_improvement_counts m_counts;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_IMPROVE_DOMAIN_3_H

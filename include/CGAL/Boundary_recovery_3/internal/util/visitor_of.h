// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_VISITOR_OF_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_VISITOR_OF_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Named_function_parameters.h>

#include <functional>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

template <typename Visitor>
Visitor visitor_to_call(const Visitor& visitor) { return visitor; }

template <typename Visitor>
Visitor& visitor_to_call(const std::reference_wrapper<Visitor>& visitor) { return visitor; }

// The visitor itself if it was given by reference, else a copy that can be called. (`get_parameter_reference()` gives a
// constant object if it was given by value.)
template <typename Default_visitor, typename NamedParameters>
decltype(auto) visitor_of(const NamedParameters& np)
{
  if constexpr(parameters::is_default_parameter<NamedParameters, internal_np::visitor_t>::value)
    return Default_visitor();
  else
    return internal::visitor_to_call(parameters::get_parameter(np, internal_np::visitor));
}

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_VISITOR_OF_H

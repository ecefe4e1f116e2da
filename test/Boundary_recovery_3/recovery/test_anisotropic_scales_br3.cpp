// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors
// Surfaces that are far longer along one axis than along another: extents that differ by hundreds of powers of two have
// no common unit in which products of floating point numbers make sense.

#undef NDEBUG
#define CGAL_NDEBUG // assertions of CGAL take most of the time here

#include "exact_mesh_checker_br3.h"
#include "recovered_mesh_br3.h"
#include "steiner_inputs_br3.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/recover_boundary.h>

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <type_traits>
#include <vector>

using namespace br3_test;
typedef CGAL::Exact_predicates_inexact_constructions_kernel   Kernel;
typedef CGAL::Delaunay_triangulation_3<Kernel>                Triangulation;
typedef CGAL::Boundary_recovery_3::Recovery_mode              Mode;

// Multiplies the coordinates with powers of two, without rounding errors. The result is judged in rational numbers.
void test_scaled(const Plc& plc, const std::array<int, 3>& exponents, const Mode mode)
{
  std::vector<Coordinates> coordinates = plc.points;
  std::vector<Kernel::Point_3> points;
  for(Coordinates& c : coordinates)
  {
    for(int i = 0; i < 3; ++i)
      c[i] = std::ldexp(c[i], exponents[i]);
    points.emplace_back(c[0], c[1], c[2]);
  }
  std::vector<std::array<std::size_t, 3> > faces;
  for(const auto& t : plc.triangles)
    faces.push_back({{ t[0], t[1], t[2] }});

  Triangulation tr;
  const auto result = CGAL::recover_boundary(tr, points, faces, CGAL::parameters::recovery_mode(mode));
  assert(result && result.unrepresentable_constraints.empty() && ! result.steiner_vertices.empty());
  typedef Recovered_mesh<Triangulation, std::decay_t<decltype(result)> > Mesh;
  Exact_mesh_checker(Mesh(tr, result, coordinates, faces).mesh(), Mesh::kind(mode, result))();
}

// Points on such a surface are no floating point numbers.
Plc multiplied(Plc plc, const double x, const double y, const double z)
{
  for(Coordinates& c : plc.points)
    c = {{ x * c[0], y * c[1], z * c[2] }};
  return plc;
}

int main()
{
  const Plc chazelle = multiplied(Notched_box(4, 1).plc(), .7, .7, .07);
  for(const Mode mode : { Mode::constrained, Mode::conforming })
    for(const std::array<int, 3>& exponents : { std::array<int, 3>{{ 0, 0, 0 }}, {{ 200, -200, 0 }}, {{ 300, -300, 0 }},
                                                {{ -300, 300, 0 }}, {{ 0, 300, -300 }}, {{ 0, 0, 280 }},
                                                {{ -300, 0, 0 }} })
      test_scaled(chazelle, exponents, mode);
  std::cout << "done" << std::endl;
}

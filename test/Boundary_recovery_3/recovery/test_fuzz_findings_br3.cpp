// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// What fuzzing found, minimised, each with a name: all the modes and kernels have to do these right for ever.

#undef NDEBUG

#include "recover_and_judge_br3.h"

#include <cassert>
#include <cmath>
#include <iostream>

using br3_test::Fuzz_case;
using br3_test::Recovery_status;

// The result had vertices although the input was found to be invalid, if that was found after the recovery.
void test_no_vertices_for_a_late_refusal()
{
  Fuzz_case c;
  c.plc.points = { {{ 0, 0, 0 }}, {{ 4, 0, 0 }}, {{ 0, 4, 0 }}, {{ 1, 1, -1 }}, {{ 1, 1, 1 }} };
  c.plc.triangles = { { 0, 1, 2 } };
  c.plc.edges = { { 3, 4 } };
  assert(br3_test::recover_and_judge(c) == Recovery_status::invalid_input);
}

// Coplanar constraints were refused, though points of the input that no constraint uses are off their plane.
void test_flat_constraints_and_an_unused_point()
{
  Fuzz_case c;
  c.plc.points = { {{ 0, 0, 0 }}, {{ 4, 0, 0 }}, {{ 0, 4, 0 }}, {{ 0, 0, 4 }} };
  c.plc.triangles = { { 0, 1, 2 } };
  assert(br3_test::recover_and_judge(c) == Recovery_status::recovered);
  c.plc.points[3][2] = 0;
  c.plc.points[3][1] = -4;
  assert(br3_test::recover_and_judge(c) == Recovery_status::invalid_input);
}

// The same with a triangulation of a point that is off the plane.
void test_flat_constraints_and_an_earlier_point()
{
  Fuzz_case c;
  c.plc.points = { {{ 0, 0, 0 }}, {{ 4, 0, 0 }}, {{ 0, 4, 0 }} };
  c.plc.triangles = { { 0, 1, 2 } };
  c.plc.earlier_points = { {{ 0, 0, 4 }} };
  assert(br3_test::recover_and_judge(c) == Recovery_status::recovered);
  c.plc.earlier_points = { {{ 4, 4, 0 }} };
  assert(br3_test::recover_and_judge(c) == Recovery_status::invalid_input);
}

// Multiples of a tenth are nearly coplanar: with a Steiner point at the number next to its position, a cell was
// inverted in the mode conforming, while the numbers around that one would do.
void test_rounding_beside_a_nearly_flat_cell()
{
  const double x = 0.1, y = 0.2, z = 0.30000000000000004;
  Fuzz_case c;
  c.plc.points = { {{ z, 0, z }}, {{ z, x, 0 }}, {{ x, x, z }}, {{ x, z, x }}, {{ x, 0, 0 }},
                   {{ y, 0, z }}, {{ z, z, x }}, {{ y, z, z }}, {{ y, y, 0 }} };
  c.plc.triangles = { { 3, 0, 8 }, { 2, 8, 5 }, { 2, 8, 1 } };
  c.plc.edges = { { 5, 3 } };
  assert(br3_test::recover_and_judge(c) == Recovery_status::recovered);
}

// In nearly flat cells again, three sets of Steiner points in a row had one that no number could take the place of.
void test_more_than_three_attempts()
{
  const double x = 0.1, y = 0.2, z = 0.30000000000000004, w = 0.4;
  Fuzz_case c;
  c.are_points_inserted_before = true;
  c.plc.points = { {{ x, z, z }}, {{ 0, 0, w }}, {{ 0, w, w }}, {{ 0, z, w }}, {{ z, z, 0 }}, {{ z, w, w }},
                   {{ w, y, x }}, {{ x, 0, w }}, {{ w, x, y }}, {{ y, 0, w }}, {{ y, y, z }} };
  c.plc.triangles = { { 3, 8, 7 }, { 4, 10, 2 }, { 7, 8, 6 }, { 4, 0, 1 }, { 9, 8, 7 }, { 6, 2, 5 }, { 2, 4, 3 } };
  c.plc.edges = { { 10, 3 }, { 8, 9 }, { 4, 8 }, { 3, 9 }, { 4, 1 } };
  assert(br3_test::recover_and_judge(c) == Recovery_status::recovered);
}

// Numbers that differ in the last digits leave so little room for Steiner points that the deepest point of the kernel,
// rounded, was outside, and so were the 500 points that were tried beside it. Numbers inside are found exactly now.
void test_kernels_thinner_than_numbers()
{
  const double x = 0.1, y = 0.2, z = 0.30000000000000004, w = 0.4;
  Fuzz_case c;
  c.plc.points = { {{ y, y, 0 }}, {{ x, x, 0 }}, {{ w, x, y }}, {{ w, z, w }}, {{ y, z, x }}, {{ w, z, z }} };
  c.plc.triangles = { { 5, 2, 4 }, { 5, 2, 1 }, { 1, 0, 3 } };
  assert(br3_test::recover_and_judge(c) == Recovery_status::recovered);
  for(const int exponent : { -600, 1200 }) // from one size to the next
  {
    for(auto& p : c.plc.points)
      for(double& coordinate : p)
        coordinate = std::ldexp(coordinate, exponent);
    assert(br3_test::recover_and_judge(c) == Recovery_status::recovered);
  }
  const double u = 1.4210854715202004e-14; // 1 + u, 2 + u, ... are numbers
  c.plc.points = { {{ -2 * u, 1 + 2 * u, 1 + 2 * u }}, {{ -2 * u, 2, 2 - 2 * u }}, {{ 1 + u, 0, 1 + 2 * u }},
                   {{ -u, 0, 2 + 2 * u }}, {{ 2 + 2 * u, 1 - u, 2 - 2 * u }}, {{ 2 + u, 2 + 2 * u, -u }} };
  c.plc.triangles = { { 0, 2, 1 } };
  c.plc.edges = { { 5, 3 }, { 0, 4 } };
  assert(br3_test::recover_and_judge(c) == Recovery_status::recovered);
}

// The same on constraints: a position may be stored by numbers that are farther away than the next ones.
void test_rounding_beyond_the_next_numbers()
{
  const double x = 0.1, y = 0.2, z = 0.30000000000000004, w = 0.4;
  Fuzz_case c;
  c.plc.points = { {{ w, z, 0 }}, {{ 0, y, x }}, {{ x, w, 0 }}, {{ w, 0, .5 }}, {{ z, z, y }}, {{ y, x, y }},
                   {{ y, z, w }}, {{ x, z, .5 }} };
  c.plc.triangles = { { 2, 5, 3 }, { 6, 4, 1 }, { 0, 7, 6 } };
  assert(br3_test::recover_and_judge(c) == Recovery_status::recovered);
}

// Multiples of a tenth are so nearly coplanar that no number fits where a Steiner point is needed, and other Steiner
// points do not help. The result says so (br3_test::Brute_force_checker looks for the constraints that it names); with
// exact numbers all is recovered.
void test_no_number_for_a_point()
{
  const double x = 0.1, y = 0.2, z = 0.30000000000000004, w = 0.4;
  Fuzz_case c; // in the default mode
  c.plc.points = { {{ 1, 0, 0 }}, {{ y, w, 0 }}, {{ x, y, y }}, {{ 0, w, y }}, {{ w, x, x }}, {{ y, x, z }} };
  c.plc.triangles = { { 4, 1, 3 }, { 1, 5, 3 } };
  c.plc.edges = { { 0, 2 } };
  assert(br3_test::recover_and_judge(c) == Recovery_status::incomplete);
  c.plc.points = { {{ w, .5, 0 }}, {{ 1, 0, 1 }}, {{ 0, .5, 0 }}, {{ 0, x, .5 }}, {{ w, .5, 1 }}, {{ z, w, 0 }},
                   {{ 1, 0, 0 }} };
  c.plc.triangles = { { 4, 6, 5 }, { 5, 3, 0 } };
  c.plc.edges = { { 2, 1 } };
  assert(br3_test::recover_and_judge(c) == Recovery_status::incomplete);
  c.plc.points = { {{ 1, 0, 0 }}, {{ y, .5, 0 }}, {{ 0, 0, 0.60000000000000009 }}, {{ x, 0, .5 }}, {{ y, .5, y }},
                   {{ y, .5, 1 }}, {{ 0, z, z }}, {{ x, w, z }} }; // in the mode conforming
  c.plc.triangles = { { 2, 4, 0 }, { 1, 3, 2 }, { 7, 4, 6 } };
  c.plc.edges = { { 3, 7 } };
  assert(br3_test::recover_and_judge(c) == Recovery_status::incomplete);
}

int main()
{
  test_no_vertices_for_a_late_refusal();
  test_flat_constraints_and_an_unused_point();
  test_flat_constraints_and_an_earlier_point();
  test_rounding_beside_a_nearly_flat_cell();
  test_more_than_three_attempts();
  test_kernels_thinner_than_numbers();
  test_rounding_beyond_the_next_numbers();
  test_no_number_for_a_point();
  std::cout << "done" << std::endl;
}

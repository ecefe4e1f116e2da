#ifndef BOUNDARY_RECOVERY_3_PROGRAM_AABB_TREES_H
#define BOUNDARY_RECOVERY_3_PROGRAM_AABB_TREES_H

#include <CGAL/AABB_tree.h>
#include <CGAL/version.h>

// CGAL 6.0 gave the classes for trees of triangles and segments in space other names.
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_segment_primitive_3.h>
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>

template <typename Kernel, typename Primitive>
using Aabb_traits = CGAL::AABB_traits_3<Kernel, Primitive>;

template <typename Kernel, typename Iterator>
using Aabb_triangle_primitive = CGAL::AABB_triangle_primitive_3<Kernel, Iterator>;

template <typename Kernel, typename Iterator>
using Aabb_segment_primitive = CGAL::AABB_segment_primitive_3<Kernel, Iterator>;
#else
#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>

template <typename Kernel, typename Primitive>
using Aabb_traits = CGAL::AABB_traits<Kernel, Primitive>;

template <typename Kernel, typename Iterator>
using Aabb_triangle_primitive = CGAL::AABB_triangle_primitive<Kernel, Iterator>;

template <typename Kernel, typename Iterator>
using Aabb_segment_primitive = CGAL::AABB_segment_primitive<Kernel, Iterator>;
#endif

#endif // BOUNDARY_RECOVERY_3_PROGRAM_AABB_TREES_H

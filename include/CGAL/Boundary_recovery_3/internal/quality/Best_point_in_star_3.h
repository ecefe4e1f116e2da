// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_BEST_POINT_IN_STAR_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_BEST_POINT_IN_STAR_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Cell_quality_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Visibility_kernel_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Badness_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Cell_shape_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/shape/distances_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Searches the point from which a polyhedron is starred best: the cells of its faces and the point are to be as little
 * bad as possible, see `Badness_3`.
 *
 * From the point at hand, it goes in the direction in which their badness falls most; by half of the step, and again,
 * where that is too far. Gradients are one-sided differences, so any quality will do.
 */
template <typename Quality>
class Best_point_in_star_3
{
public:
  typedef std::array<Coordinates_3, 3> Face; // seen from inside

  explicit Best_point_in_star_3(const Quality& quality) : m_quality(quality) { }

  // How bad cells are; they need not be any better than what is enough.
  void clear(const Badness_3& badness)
  {
    m_badness = badness;
    m_faces.clear();
  }

  void add(const Face& face) { m_faces.push_back(face); }

  std::size_t number_of_faces() const { return m_faces.size(); }

  // Of the cells of the faces and the point, where `improve` left it.
  const std::vector<double>& qualities() const { return m_qualities; }

  // By how much `improve` made them less bad.
  double gain() const { return m_gain; }

  // Moves the point to better places, until all cells are good enough, or nothing helps. The worst cell never gets
  // worse, or not more than the measure of badness tolerates. `is_allowed` tells where the point may be. Returns
  // which part of the badness of the cells is gone, 0 if the point was not moved.
  template <typename IsAllowed>
  double improve(Coordinates_3& p, const IsAllowed& is_allowed)
  {
    m_least = -std::numeric_limits<double>::infinity();
    const double badness_before = set_qualities(p);
    double badness = badness_before;
    double step = 0.25 * typical_length(p);
    for(int round = 0; round < max_number_of_rounds && badness > 0; ++round)
    {
      Coordinates_3 direction = descent(p, 1e-4 * typical_length(p));
      const double length = std::sqrt(dot_product(direction, direction));
      if(! (length > 0))
        break;
      for(double& x : direction)
        x /= length;
      if(! walk(p, direction, step, badness, is_allowed))
        break;
      const double better = set_qualities(p);
      const bool is_slow = better > (1 - least_progress) * badness;
      badness = better;
      if(is_slow)
        break;
    }
    m_gain = badness_before - badness;
    return badness < badness_before ? m_gain / badness_before : 0;
  }

private:
  // See "Tuning constants" in the manual.
  static constexpr int max_number_of_rounds = 8;
  static constexpr int max_number_of_halvings = 5;
  static constexpr double least_progress = 0.005;

  // Of the quality of the cell of a face, when the point moves along an axis.
  struct Difference
  {
    std::size_t face;
    int axis;
  };

  // Visits the qualities of the cells of the faces and p, see `visit_qualities()`.
  template <typename Visit>
  bool visit_cells(const Coordinates_3& p, const Visit& visit) const
  {
    const auto corners = [&](const Face& f) { return Cell_corners_3{{ f[0], f[1], f[2], p }}; };
    const auto visit_face = [&](const Face&, const double q) { return visit(q); };
    return internal::visit_qualities(m_quality, m_faces, corners, visit_face);
  }

  // Returns how bad the cells are.
  double set_qualities(const Coordinates_3& p)
  {
    m_qualities.clear();
    double badness = 0;
    double worst = 2;
    visit_cells(p, [&](const double q)
    {
      m_qualities.push_back(q);
      worst = (std::min)(worst, q);
      badness += m_badness.of_lack(lack(q));
      return true;
    });
    m_least = (std::max)(m_least, m_badness.least_quality(worst));
    return badness;
  }

  double lack(const double quality) const { return (std::max)(0., 1 - quality / m_badness.enough()); }

  bool is_better(const Coordinates_3& p, const double badness) const
  {
    double sum = 0;
    return visit_cells(p, [&](const double q)
    {
      sum += m_badness.of_lack(lack(q));
      return q >= m_least && sum < badness;
    });
  }

  double typical_length(const Coordinates_3& p) const
  {
    double sum = 0;
    for(const Face& f : m_faces)
      sum += internal::distance(f[0], p);
    return sum / static_cast<double>(m_faces.size());
  }

  // Goes as far as the step, or a half or a quarter of it ..., if that makes the cells less bad. The next step is about
  // as long.
  template <typename IsAllowed>
  bool walk(Coordinates_3& p, const Coordinates_3& direction, double& step, const double badness,
            const IsAllowed& is_allowed) const
  {
    for(int halving = 0; halving <= max_number_of_halvings; ++halving)
    {
      const Coordinates_3 q = {{ p[0] + step * direction[0], p[1] + step * direction[1], p[2] + step * direction[2] }};
      if(is_allowed(q) && is_better(q, badness))
      {
        p = q;
        step *= 1.5;
        return true;
      }
      step *= 0.5;
    }
    return false;
  }

  // The direction in which the cells get less bad.
  Coordinates_3 descent(const Coordinates_3& p, const double h)
  {
    set_differences();
    Coordinates_3 sum = {{ 0, 0, 0 }};
    const auto corners = [&](const Difference& d) { return moved_corners(d, p, h); };
    internal::visit_qualities(m_quality, m_differences, corners, [&](const Difference& d, const double q)
    {
      const double before = m_qualities[d.face];
      sum[d.axis] += m_badness.slope(lack(before)) * ((q - before) / h);
      return true;
    });
    return sum;
  }

  // Only bad cells are to get better.
  void set_differences()
  {
    m_differences.clear();
    for(std::size_t k = 0; k < m_faces.size(); ++k)
      if(m_qualities[k] < m_badness.enough())
        for(int i = 0; i < 3; ++i)
          m_differences.push_back(Difference{ k, i });
  }

  Cell_corners_3 moved_corners(const Difference& d, Coordinates_3 p, const double h) const
  {
    p[d.axis] += h;
    const Face& f = m_faces[d.face];
    return {{ f[0], f[1], f[2], p }};
  }

  const Quality& m_quality;
  std::vector<Face> m_faces;
  std::vector<double> m_qualities;
  std::vector<Difference> m_differences;
  Badness_3 m_badness = 1;
  double m_least = 0; // what qualities are to be
  double m_gain = 0;
};

// The deepest point of the visibility kernel of a polyhedron, maybe outside if there is no kernel. Each of the faces
// has the polyhedron on its positive side; the origin is a point near them.
template <typename Tr>
std::optional<Coordinates_3> deepest_point(const Tr& tr,
                                           const std::vector<std::array<typename Tr::Vertex_handle, 3>>& faces,
                                           const Coordinates_3& origin)
{
  typedef typename Vertex_predicates_3<Tr>::Approximate_point Point;
  const Vertex_predicates_3<Tr> predicates(tr);
  const Visibility_kernel_3<Tr> kernel(predicates, faces, Point(origin[0], origin[1], origin[2]));
  const std::optional<Point> deepest = kernel.deepest_point([](const Point&) { return true; });
  if(! deepest)
    return std::nullopt;
  return Coordinates_3{{ deepest->x(), deepest->y(), deepest->z() }};
}

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_BEST_POINT_IN_STAR_3_H

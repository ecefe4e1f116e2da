// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIZING_FORECAST_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIZING_FORECAST_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/shape/tetrahedron_edges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <queue>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

// What a forecast is told of a field that does not tell bounds.
struct Unknown_least_size
{
  double operator()(const std::array<Coordinates_3, 4>&, int /* region */) const { return 0; }
};

/*
 * Estimates how many cells a size field asks for: the integral of 6 sqrt(2) / h^3, which is one regular tetrahedron
 * with edges of length h in its own volume. The tetrahedra given are cut where the sizes inside can differ most for the
 * volume that they have, until there are enough pieces. Since most sizes in a piece are smaller, by volume of what they
 * ask for, than that at its centroid, a part of what may differ still is added.
 *
 * `Size` returns the size at a place, given by coordinates and the number of the region. `gradation` is by how much
 * sizes grow per length, as far as that is known. If they grow fast, `Least_size` is asked for a size that those in a
 * tetrahedron are not below, so that it is cut where small sizes are hidden.
 */
template <typename Size, typename Least_size = Unknown_least_size>
class Forecast_3
{
public:
  typedef std::array<Coordinates_3, 4> Tetrahedron;

  Forecast_3(Size& size, const double gradation, const Least_size& least_size = Least_size())
    : m_size(size), m_gradation((std::min)(gradation, assumed_gradation)),
      m_asks_for_least_sizes(gradation > assumed_gradation), m_least_size(least_size)
  { }

  // By how much sizes are assumed to grow per length.
  double gradation() const { return m_gradation; }

  // Its size at the centroid is about `h`.
  void add(const Tetrahedron& t, const int region, const double h) { push(t, region, h); }

  // Cuts the tetrahedra, which takes as many questions as are allowed, and returns the estimate.
  double operator()(const std::size_t max_number_of_questions)
  {
    for(std::size_t n = 0; n < max_number_of_questions && ! m_pieces.empty(); n += 2)
    {
      const Piece worst = m_pieces.top();
      if(! (worst.urgency > tolerance * m_sum))
        break;
      m_pieces.pop();
      m_sum -= worst.value;
      m_error -= worst.error;
      bisect(worst);
    }
    return m_sum + part_of_error * (std::max)(0., m_error);
  }

private:
  struct Piece
  {
    double urgency, error, value;
    std::size_t number; // so that the order of equal ones is known
    Tetrahedron corners;
    int region;

    bool operator<(const Piece& other) const
    {
      return urgency < other.urgency || (urgency == other.urgency && number > other.number);
    }
  };

  static constexpr double assumed_gradation = 0.5; // of fields that do not tell
  static constexpr double tolerance = 1e-6;        // of a piece, as a part of the whole
  static constexpr double most_refined = 0.2;      // no size is expected to fall below that part of one nearby
  static constexpr double part_of_error = 0.025;   // that is expected to be missing in the sum

  static double density(const double h) { return 6 * std::sqrt(2.) / (h * h * h); }

  void push(const Tetrahedron& t, const int region, const double h)
  {
    const double volume = std::abs(volume_times_6(t)) / 6;
    const double reach = m_gradation * internal::longest_edge(t).length / 2;
    const double lowest = (std::max)(h - reach, most_refined * h);
    const double error = volume * (density(lowest) - density(h + reach));
    const double least = m_asks_for_least_sizes ? m_least_size(t, region) : 0;
    const double urgency = least > 0 && least < lowest ? volume * density(least) : error;
    const Piece piece = { urgency, error, volume * density(h), m_number_of_pieces++, t, region };
    m_sum += piece.value;
    m_error += piece.error;
    if(piece.error > 0)
      m_pieces.push(piece);
  }

  void bisect(const Piece& piece)
  {
    const Tetrahedron_edge_3 edge = internal::longest_edge(piece.corners);
    const Coordinates_3 middle = internal::midpoint(piece.corners[edge.i], piece.corners[edge.j]);
    for(const int end : { edge.i, edge.j })
    {
      Tetrahedron half = piece.corners;
      half[end] = middle;
      const double h = m_size(centroid(half), piece.region);
      if(h > 0) // else the field has no size there, which is known by now
        push(half, piece.region, h);
    }
  }

  Size& m_size;
  double m_gradation;
  bool m_asks_for_least_sizes;
  Least_size m_least_size;
  double m_sum = 0;
  double m_error = 0; // of all pieces
  std::size_t m_number_of_pieces = 0;
  std::priority_queue<Piece> m_pieces;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIZING_FORECAST_3_H

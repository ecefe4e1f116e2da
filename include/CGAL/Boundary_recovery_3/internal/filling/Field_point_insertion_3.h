// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_FIELD_POINT_INSERTION_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_FIELD_POINT_INSERTION_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_constrained_mesh_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Fill_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Fill_parts_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Ordinary_scale_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Selected_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/vertex_owners.h>
#include <CGAL/Boundary_recovery_3/internal/owners/Concurrency.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Cell_shape_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Region_sizes_3.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Vertex_sizes_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>
#include <CGAL/Boundary_recovery_3/internal/util/available_memory.h>
#include <CGAL/Boundary_recovery_3/internal/util/standard_types.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

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
 * `Size` returns the size at a place, given by coordinates and the number of the region. `grading` is by how much
 * sizes grow per length, as far as that is known. If they grow fast, `Least_size` is asked for a size that those in a
 * tetrahedron are not below, so that it is cut where small sizes are hidden.
 */
template <typename Size, typename Least_size = Unknown_least_size>
class Forecast_3
{
public:
  typedef std::array<Coordinates_3, 4> Tetrahedron;

  Forecast_3(Size& size, const double grading, const std::size_t max_number_of_questions,
             const Least_size& least_size = Least_size())
    : m_size(size), m_grading((std::min)(grading, assumed_grading)),
      m_asks_for_least_sizes(grading > assumed_grading), m_max_number_of_cuts((max_number_of_questions + 1) / 2),
      m_least_size(least_size)
  { }

  // By how much sizes are assumed to grow per length.
  double grading() const { return m_grading; }

  // Its size at the centroid is about `h`. Of millions, those are forgotten that will not be cut in any case.
  void add(const Tetrahedron& t, const int region, const double h)
  {
    add_piece(t, region, h);
    if(m_pieces.size() <= 2 * m_max_number_of_cuts)
      return;
    const auto end = m_pieces.begin() + static_cast<std::ptrdiff_t>(m_max_number_of_cuts);
    std::nth_element(m_pieces.begin(), end, m_pieces.end(), [](const Piece& p, const Piece& q) { return q < p; });
    m_pieces.erase(end, m_pieces.end());
  }

  // Cuts the tetrahedra, which takes as many questions as are allowed, and returns the estimate.
  double operator()()
  {
    std::make_heap(m_pieces.begin(), m_pieces.end());
    for(std::size_t n = 0; n < m_max_number_of_cuts && ! m_pieces.empty(); ++n)
    {
      const Piece worst = m_pieces.front();
      if(! (worst.urgency > tolerance * m_sum))
        break;
      std::pop_heap(m_pieces.begin(), m_pieces.end());
      m_pieces.pop_back();
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

  static constexpr double assumed_grading = 0.5; // of fields that do not tell
  static constexpr double tolerance = 1e-6;        // of a piece, as a part of the whole
  static constexpr double most_refined = 0.2;      // no size is expected to fall below that part of one nearby
  static constexpr double part_of_error = 0.025;   // that is expected to be missing in the sum

  static double density(const double h) { return 6 * std::sqrt(2.) / (h * h * h); }

  void add_piece(const Tetrahedron& t, const int region, const double h)
  {
    const double volume = std::abs(volume_times_6(t)) / 6;
    const double reach = m_grading * internal::longest_edge(t).length / 2;
    const double lowest = (std::max)(h - reach, most_refined * h);
    const double error = volume * (density(lowest) - density(h + reach));
    const double least = m_asks_for_least_sizes ? m_least_size(t, region) : 0;
    const double urgency = least > 0 && least < lowest ? volume * density(least) : error;
    const Piece piece = { urgency, error, volume * density(h), m_number_of_pieces++, t, region };
    m_sum += piece.value;
    m_error += piece.error;
    if(piece.error > 0)
      m_pieces.push_back(piece);
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
      if(! (h > 0)) // the field has no size there, which is known by now
        continue;
      add_piece(half, piece.region, h);
      std::push_heap(m_pieces.begin(), m_pieces.end());
    }
  }

  Size& m_size;
  double m_grading;
  bool m_asks_for_least_sizes;
  std::size_t m_max_number_of_cuts;
  Least_size m_least_size;
  double m_sum = 0;
  double m_error = 0; // of all pieces
  std::size_t m_number_of_pieces = 0;
  std::vector<Piece> m_pieces; // a heap once they are cut
};

// How large the mesh will be, which is told before the filling: with a few thousand questions to the size field at
// least; with as many questions as there are cells; or not at all.
enum class Forecast_effort { usual, small, none };

/*
 * The work behind insert_field_points(): the forecast, then the filling, with an account of both.
 */
template <typename Tr>
class Field_point_insertion_3
{
public:
  typedef typename Tr::Cell_handle          Cell_handle;
  typedef Selected_domain_3<Tr>     Domain;
  typedef typename Tr::Geom_traits::Point_3 Point_3;
  typedef Field_points_result_3<Tr> Result;

  Field_point_insertion_3(Tr& tr, Domain& domain, const Size_field_3<Point_3>& size, Mesh_visitor_3<Tr>& visitor,
                          const Forecast_effort effort = Forecast_effort::usual)
    : m_tr(tr), m_domain(domain), m_sizes(tr, size), m_context(visitor), m_effort(effort)
  { }

  // Makes all cells as large as the field says, also at walls with shorter edges.
  void ignore_sizes_of_walls() { m_minds_walls = false; }

  // Leaves the sizes of the field in all vertices, also where walls made them smaller: those do not depend on the part
  // of a mesh that is filled.
  void leave_sizes_of_field() { m_leaves_sizes_of_field = true; }

  // To be called before the filling; else nothing is divided.
  void set_concurrency(const Concurrency& concurrency) { m_concurrency = concurrency; }

  Result operator()(const std::size_t max_number_of_vertices, const double maximum_running_time);

  // The forecast, and whether that many cells are possible, without the filling.
  Result forecast_only(const std::size_t max_number_of_vertices, const double maximum_running_time)
  {
    const Ordinary_scale_3<Tr> scale(m_tr);
    m_sizes.set_scale(scale.factor());
    m_context.set_maximum_running_time(maximum_running_time);
    if(m_tr.dimension() == 3)
      is_possible(max_number_of_vertices);
    return finish();
  }

  // The forecast of a mesh which has so many field points already, and is to get more of them.
  Result forecast_of_unfinished(const std::size_t number_of_field_points)
  {
    const Ordinary_scale_3<Tr> scale(m_tr);
    m_sizes.set_scale(scale.factor());
    m_result.number_of_field_points = number_of_field_points;
    correct_forecast();
    return m_result;
  }

private:
  typedef Region_sizes_3<Tr> Sizes;

  // See "Tuning constants" in the manual.
  static constexpr double cells_per_forecast_cell = 1.32;
  static constexpr double cells_per_wall = 1.2;
  static constexpr double cells_per_cell_of_part = 3; // of other parts: each border has to be filled first
  static constexpr double cells_per_inner_vertex = 6.6;
  static constexpr double cells_per_surface_vertex = 2;
  static constexpr std::size_t least_number_of_questions = 2000;
  static constexpr std::size_t largest_number_of_questions = 40000;

  bool is_possible(const std::size_t max_number_of_vertices)
  {
    run(Phase::forecast, [this] { forecast(); });
    if(! m_sizes.is_valid())
      refuse_size();
    else if(! m_context.go_further())
      m_result.status = Meshing_status::stopped;
    else if(m_result.forecast_of_vertices > static_cast<double>(max_number_of_vertices) || ! is_enough_memory())
      m_result.status = Meshing_status::too_large;
    else
      return true;
    return false;
  }

  Result finish()
  {
    m_result.seconds = m_context.seconds();
    return std::move(m_result);
  }

  template <typename Work>
  void run(const Phase phase, const Work& work)
  {
    m_context.run(phase, work, [&](Phase_report& report)
    {
      const bool is_forecast = phase == Phase::forecast;
      report.number_of_vertices = is_forecast ? rounded(m_result.forecast_of_vertices) : m_tr.number_of_vertices();
      report.number_of_cells = is_forecast ? rounded(m_result.forecast_of_cells)
                                           : internal::number_of_finite_cells(m_tr);
    });
  }

  // Forecasts may be larger than all integers.
  static std::size_t rounded(const double number)
  {
    const double largest = static_cast<double>((std::numeric_limits<std::size_t>::max)() / 2);
    return static_cast<std::size_t>(number < largest ? number : largest);
  }

  void forecast()
  {
    m_cells.clear();
    for(const Cell_handle c : m_tr.finite_cell_handles())
      if(m_domain.contains(c))
        m_cells.push_back(c);
    const double number_of_cells = static_cast<double>(m_cells.size());
    const double number_of_vertices = static_cast<double>(m_tr.number_of_vertices() - m_result.number_of_field_points);
    m_result.forecast_of_cells = number_of_cells; // what is there at least
    m_result.forecast_of_vertices = number_of_vertices;
    if(! m_sizes.ask_at_vertices(m_cells) || m_effort == Forecast_effort::none)
      return;
    m_result.forecast_of_cells = (std::max)(number_of_cells, cells_per_forecast_cell * number_of_regular_cells() +
                                                             cells_per_wall * static_cast<double>(number_of_walls()));
    const double inner_cells = m_result.forecast_of_cells - cells_per_surface_vertex * number_of_vertices;
    m_result.forecast_of_vertices = number_of_vertices + (std::max)(0., inner_cells / cells_per_inner_vertex);
  }

  // That of a mesh with field points which needs more of them.
  void correct_forecast()
  {
    forecast();
    m_result.forecast_of_vertices = (std::max)(m_result.forecast_of_vertices,
                                               static_cast<double>(m_tr.number_of_vertices() + 1));
  }

  // Seen from inside: cells at them have their size.
  std::size_t number_of_walls() const
  {
    std::size_t number = 0;
    for(const Cell_handle c : m_cells)
      for(int i = 0; i < 4; ++i)
        number += m_domain.is_wall(c, i);
    return number;
  }

  // Infinity if the sizes are so small that nobody can count.
  double number_of_regular_cells()
  {
    auto size = [this](const Coordinates_3& p, const int region) { return m_sizes.of_field(p, region); };
    const auto least_size = [this](const std::array<Coordinates_3, 4>& t, const int region)
    {
      const Coordinates_3 center = internal::centroid(t);
      return m_sizes.query().tells_least_sizes()
           ? m_sizes.least_size_around(center, internal::largest_distance(center, t), region) : 0;
    };
    const std::size_t least = m_effort == Forecast_effort::usual ? least_number_of_questions : 0;
    const std::size_t number_of_questions = (std::min)(least + m_cells.size(), largest_number_of_questions);
    Forecast_3<decltype(size), decltype(least_size)> integral(size, m_sizes.grading(), number_of_questions, least_size);
    for(const Cell_handle c : m_cells)
    {
      const auto corners = internal::corners(c);
      integral.add(corners, m_sizes.region(c), m_sizes.likely_size_at_centroid(c, corners, integral.grading()));
    }
    const double number = integral();
    return std::isnan(number) ? std::numeric_limits<double>::infinity() : number;
  }

  bool is_enough_memory() const
  {
    const double more_cells = m_result.forecast_of_cells - static_cast<double>(m_cells.size());
    const double more_vertices = m_result.forecast_of_vertices - static_cast<double>(m_tr.number_of_vertices());
    const double bytes = more_cells * sizeof(typename Tr::Cell) +
                         more_vertices * (sizeof(typename Tr::Vertex) + sizeof(typename Tr::Vertex_handle));
    return bytes <= 0 || bytes <= static_cast<double>(available_memory());
  }

  void fill(const std::size_t max_number_of_vertices)
  {
    if(m_minds_walls)
      m_sizes.set_walls(Wall_sizes_3<Tr>(m_cells, m_domain));
    Fill_domain_3<Tr> fill_domain(m_tr, m_domain, m_sizes, m_context);
    const double expected = m_result.forecast_of_vertices - static_cast<double>(m_tr.number_of_vertices());
    const std::size_t number_of_parts = this->number_of_parts(max_number_of_vertices);
    if(number_of_parts > 1)
      fill_parts(fill_domain, number_of_parts, static_cast<std::size_t>(expected));
    else
      fill_domain(m_cells, max_number_of_vertices, static_cast<std::size_t>(expected));
    if(m_leaves_sizes_of_field)
      m_sizes.restore_sizes_of_field();
    m_result.number_of_field_points = fill_domain.vertices().size();
    m_result.is_field_resolved = fill_domain.is_resolved();
    if(! m_sizes.is_valid())
      refuse_size();
    else if(m_context.is_stopped())
      m_result.status = Meshing_status::stopped;
    else if(fill_domain.is_full())
    {
      m_result.status = Meshing_status::too_large;
      correct_forecast();
    }
  }

  typedef std::conjunction<Has_part<typename Tr::Vertex>, Has_meshing_info<typename Tr::Vertex> > Can_have_parts;

  // A power of 2: parts are halves of halves with as much work each, which threads share evenly.
  std::size_t number_of_parts(const std::size_t max_number_of_vertices) const
  {
    if(! Can_have_parts::value || m_domain.has_selection())
      return 1;
    const double number_of_cells = m_result.forecast_of_cells / cells_per_cell_of_part;
    const std::size_t least = m_concurrency.number_of_parts(number_of_cells, max_number_of_vertices);
    std::size_t number = 1;
    while(number < least && 2 * number <= max_number_of_parts)
      number *= 2;
    return number;
  }

  void fill_parts([[maybe_unused]] Fill_domain_3<Tr>& fill_domain, [[maybe_unused]] const std::size_t number_of_parts,
                  [[maybe_unused]] const std::size_t expected_number)
  {
    if constexpr(Can_have_parts::value)
      internal::with_threads(*m_concurrency.number_of_threads, [&]
      {
        Fill_parts_3<Tr> fill(m_tr, m_domain, m_sizes, m_context, fill_domain);
        fill(m_cells, number_of_parts, expected_number);
      });
  }

  void refuse_size()
  {
    m_result.status = Meshing_status::invalid_input;
    m_result.invalid_sizes.push_back(m_sizes.query().invalid_size());
  }

  Tr& m_tr;
  Domain& m_domain;
  Sizes m_sizes;
  Recovery_context<Tr> m_context;
  const Forecast_effort m_effort;
  Concurrency m_concurrency;
  bool m_minds_walls = true;
  bool m_leaves_sizes_of_field = false;
  Result m_result;
  std::vector<Cell_handle> m_cells; // of the domain, before points are inserted
};

template <typename Tr>
Field_points_result_3<Tr>
Field_point_insertion_3<Tr>::operator()(const std::size_t max_number_of_vertices, const double maximum_running_time)
{
  const Ordinary_scale_3<Tr> scale(m_tr);
  m_sizes.set_scale(scale.factor());
  m_context.set_maximum_running_time(maximum_running_time);
  if(m_tr.dimension() == 3 && is_possible(max_number_of_vertices))
    run(Phase::field_point_insertion, [&] { fill(max_number_of_vertices); });
  return finish();
}

#ifdef CGAL_BOUNDARY_RECOVERY_3_COMPILED

extern template Field_points_result_3<Standard_mesh>
Field_point_insertion_3<Standard_mesh>::operator()(std::size_t, double);

#endif // CGAL_BOUNDARY_RECOVERY_3_COMPILED

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_FIELD_POINT_INSERTION_3_H

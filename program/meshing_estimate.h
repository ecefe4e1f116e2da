#ifndef BOUNDARY_RECOVERY_3_PROGRAM_MESHING_ESTIMATE_H
#define BOUNDARY_RECOVERY_3_PROGRAM_MESHING_ESTIMATE_H

#include "mesh_surface_options.h"
#include "progress_estimate.h"
#include "surface.h"

#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>
#include <CGAL/Boundary_recovery_3/enumerations.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <system_error>

// What a run of the mesher is expected to take. Needles of the surface take most: the cells at them stay bad, and are
// worked on again and again.
class Meshing_estimate
  : public Progress_estimate
{
  typedef CGAL::Boundary_recovery_3::Phase        Phase;
  typedef CGAL::Boundary_recovery_3::Phase_report Phase_report;

  // seconds for each triangle, cell, needle, or triangle that is nearly one; benchmark/Boundary_recovery_3/progress.py
  // shows how true the shares are with these figures
  static constexpr double to_read = 2.2e-6, to_insert = 2.1e-6, to_recover = 0.8e-6, to_recover_needle = 30e-6,
                          to_mark = 1e-6, to_forecast = 0.7e-6, to_fill = 1.3e-6, to_fill_needle = 15e-6,
                          to_improve = 1.5e-6, to_improve_needle = 300e-6, to_improve_slender = 60e-6,
                          to_measure = 0.6e-6, to_write = 0.35e-6;
  static constexpr double low_factor = 0.4, high_factor = 10; // of efforts, for needles
  static constexpr double cells_per_triangle = 6, cells_per_needle = 2; // if sizes are those of the surface
  static constexpr double cells_per_cubed_size = 8.5;
  static constexpr double bytes_per_triangle = 40, triangles_of_default_surface = 3000;
  static constexpr double cells_per_forecast_cell = 0.85;

  const Meshing_options& m_options;
  double m_triangles = 0;
  double m_needles = 0; // with less than half the angle that is asked for
  double m_slender = 0; // with less than that angle, beside needles
  double m_volume = 0;  // inside of the surface

public:
  explicit Meshing_estimate(const Meshing_options& options) : m_options(options) { }

  // The file is about to be read: its size is all that is known.
  void set_file(const std::string& file)
  {
    std::error_code error;
    const auto bytes = std::filesystem::file_size(file, error);
    m_triangles = error ? triangles_of_default_surface : double(bytes) / bytes_per_triangle;
    expect_by_triangles();
  }

  // What is no triangle soup is refused by the library at once.
  template <typename Point>
  void set_surface(const Surface<Point>& surface)
  {
    m_triangles = 0;
    if(is_triangle_soup(surface))
      for(const auto& face : surface.faces)
        add(surface.points[face[0]], surface.points[face[1]], surface.points[face[2]]);
    expect_by_triangles();
  }

  void begin_phase(const Phase phase)
  {
    const Step step = step_of(phase);
    if(step != this->step())
      begin(step);
  }

  void end_phase(const Phase_report& report)
  {
    if(report.phase == Phase::forecast)
      set_number_of_cells(cells_per_forecast_cell * double(report.number_of_cells));
  }

  void set_progress(const Phase phase, const std::size_t done, const std::size_t total)
  {
    const double part = double(done) / double(total);
    if(phase == Phase::field_point_insertion)
      set_part_of_step((std::min)(1., part / cells_per_forecast_cell));
    else if(phase == Phase::quality_improvement)
      set_part_of_step(part);
  }

private:
  void expect_by_triangles()
  {
    expect(reading, to_read * m_triangles);
    expect(insertion, to_insert * m_triangles);
    expect(recovery, to_recover * m_triangles + to_recover_needle * m_needles);
    expect(marking, to_mark * m_triangles);
    expect(forecast, to_forecast * m_triangles);
    const double cells = cells_per_triangle * (m_triangles - m_needles) + cells_per_needle * m_needles;
    set_number_of_cells(m_options.size > 0 ? (std::max)(cells, cells_of_uniform_size()) : cells);
  }

  static Step step_of(const Phase phase)
  {
    switch(phase)
    {
      case Phase::insertion:
      case Phase::search:                return insertion;
      case Phase::domain_marking:        return marking;
      case Phase::forecast:              return forecast;
      case Phase::decomposition:
      case Phase::field_point_insertion: return filling;
      case Phase::quality_improvement:   return improvement;
      default:                           return recovery;
    }
  }

  template <typename Point>
  void add(const Point& p, const Point& q, const Point& r)
  {
    ++m_triangles;
    m_volume += CGAL::determinant(p - CGAL::ORIGIN, q - CGAL::ORIGIN, r - CGAL::ORIGIN) / 6;
    const double angle = smallest_angle(p, q, r);
    if(angle < m_options.min_angle / 2)
      ++m_needles;
    else if(angle < m_options.min_angle)
      ++m_slender;
  }

  // in degrees, opposite of the shortest edge
  template <typename Point>
  static double smallest_angle(const Point& p, const Point& q, const Point& r)
  {
    std::array<double, 3> squares = {{ CGAL::squared_distance(p, q), CGAL::squared_distance(q, r),
                                       CGAL::squared_distance(r, p) }};
    std::sort(squares.begin(), squares.end());
    const double cosine = (squares[1] + squares[2] - squares[0]) / (2 * std::sqrt(squares[1] * squares[2]));
    return cosine < 1 ? std::acos(cosine) * 180 / std::acos(-1.) : 0; // also if all of them are 0
  }

  double cells_of_uniform_size() const
  {
    return cells_per_cubed_size * std::abs(m_volume) / std::pow(m_options.size, 3);
  }

  void set_number_of_cells(const double n)
  {
    expect(filling, m_options.insert_field_points ? to_fill * n + to_fill_needle * m_needles : 0);
    if(m_options.insert_field_points && m_options.improve_quality)
    {
      const double factor = m_options.effort == Improvement_effort::low    ? low_factor
                            : m_options.effort == Improvement_effort::high ? high_factor : 1;
      expect(improvement, to_improve * n + factor * (to_improve_needle * m_needles + to_improve_slender * m_slender));
    }
    expect(measuring, m_options.quiet && m_options.report.empty() ? 0 : to_measure * n);
    expect(writing, to_write * n * double(m_options.outputs.size()));
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_MESHING_ESTIMATE_H

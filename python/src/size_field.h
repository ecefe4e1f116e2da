#ifndef BOUNDARY_RECOVERY_3_PYTHON_SIZE_FIELD_H
#define BOUNDARY_RECOVERY_3_PYTHON_SIZE_FIELD_H

#include "module_types.h"

#include <CGAL/Boundary_recovery_3/Background_mesh_3.h>
#include <CGAL/Boundary_recovery_3/Background_mesh_sizing_field_3.h>
#include <CGAL/Boundary_recovery_3/Size_source_3.h>
#include <CGAL/Boundary_recovery_3/Source_sizing_field_3.h>
#include <CGAL/Boundary_recovery_3/Surface_sizing_field_3.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace boundary_recovery {

// The only size field: the smallest one of all kinds of sizes that the user asked for. It is cheap to be copied.
class Size_field
{
  typedef BR3::Surface_sizing_field_3<Triangulation>  Surface_field;
  typedef BR3::Source_sizing_field_3<Kernel>          Source_field;
  typedef BR3::Background_mesh_sizing_field_3<Kernel> Background_field;
  typedef BR3::Size_source_3<Kernel>                  Size_source;

  double m_uniform = infinity;
  Size_function* m_function = nullptr;
  std::shared_ptr<const Surface_field> m_surface;
  std::shared_ptr<const Source_field> m_points, m_sources; // the sizes at points are sources
  std::shared_ptr<const Background_field> m_background;

public:
  // so large that no edge is too long
  Size_field() : m_uniform((std::numeric_limits<double>::max)()) { }

  Size_field(const Sizes& sizes, const Point_rows& points, const Index_rows& triangles)
    : m_uniform(sizes.uniform), m_function(sizes.function)
  {
    if(sizes.is_from_surface && is_valid_surface(points, triangles))
      m_surface = std::make_shared<Surface_field>(as_points(points), as_rows<3>(triangles), sizes.grading);
    if(sizes.at_points != nullptr)
      set_sizes_at_points(sizes, points);
    set_sources(sizes);
    set_background(sizes);
  }

  double operator()(const Point_3& p, const int dimension, const int index) const
  {
    double size = m_uniform;
    const auto add = [&](const auto& field)
    {
      if(field)
        size = (std::min)(size, (*field)(p, dimension, index));
    };
    add(m_surface);
    add(m_points);
    add(m_sources);
    add(m_background);
    return m_function == nullptr ? size : smaller(size, (*m_function)(p.x(), p.y(), p.z()));
  }

  // Of a function, nothing is known beside the places where it was asked.
  double least_size_around(const Point_3& p, const double radius, const int index) const
  {
    double size = m_function == nullptr ? m_uniform : 0;
    const auto add = [&](const auto& field)
    {
      if(field && size > 0)
        size = (std::min)(size, field->least_size_around(p, radius, index));
    };
    add(m_surface);
    add(m_points);
    add(m_sources);
    add(m_background);
    return size;
  }

  double grading() const
  {
    double grading = 0;
    const auto add = [&](const auto& field)
    {
      if(field)
        grading = (std::max)(grading, field->grading());
    };
    add(m_surface);
    add(m_points);
    add(m_sources);
    return m_background || m_function != nullptr ? infinity : grading;
  }

private:
  // What is not a size has to be noticed.
  static double smaller(const double size, const double asked) { return asked > 0 ? (std::min)(size, asked) : asked; }

  // Else the recovery refuses the surface, and nobody asks for sizes.
  static bool is_valid_surface(const Point_rows& points, const Index_rows& triangles)
  {
    for(std::size_t i = 0; i < points.size; ++i)
      for(std::size_t j = 0; j < 3; ++j)
        if(! std::isfinite(points(i, j)))
          return false;
    for(std::size_t i = 0; i < triangles.size; ++i)
      for(std::size_t j = 0; j < 3; ++j)
        if(triangles(i, j) >= points.size)
          return false;
    return true;
  }

  void set_sizes_at_points(const Sizes& sizes, const Point_rows& points)
  {
    std::vector<Size_source> sources;
    sources.reserve(points.size);
    const auto growth = BR3::Size_growth::linear(sizes.grading);
    for(std::size_t i = 0; i < points.size; ++i)
      sources.push_back(Size_source::point(Point_row{ points }(i), sizes.at_points[i], 0, growth));
    m_points = make_source_field(sources, "size");
  }

  std::shared_ptr<const Source_field> make_source_field(const std::vector<Size_source>& sources,
                                                        const std::string& name) const
  {
    for(std::size_t i = 0; i < sources.size(); ++i)
      if(! sources[i].is_valid())
        throw std::invalid_argument(name + "[" + std::to_string(i) + "]: " + sources[i].what_is_wrong());
    return std::make_shared<Source_field>(sources, m_uniform);
  }

  static Size_source make_source(const Source& source)
  {
    const auto point = [&](const std::size_t i)
    {
      return Point_3(source.points[i][0], source.points[i][1], source.points[i][2]);
    };
    const auto growth = source.is_doubling ? BR3::Size_growth::doubling_at(source.growth)
                                           : BR3::Size_growth::linear(source.growth);
    switch(source.shape)
    {
      case 1:  return Size_source::point(point(0), source.size, source.radius, growth);
      case 2:  return Size_source::segment(point(0), point(1), source.size, source.radius, growth);
      case 3:  return Size_source::triangle(point(0), point(1), point(2), source.size, source.radius, growth);
      default: return Size_source::box(point(0), point(1), source.size, source.radius, growth);
    }
  }

  void set_sources(const Sizes& sizes)
  {
    std::vector<Size_source> sources;
    for(const Source& source : sizes.sources)
      sources.push_back(make_source(source));
    if(! sizes.source_file.empty())
    {
      std::ifstream is(sizes.source_file);
      std::string what;
      if(! is || ! BR3::read_size_sources(is, sources, what))
        throw std::invalid_argument("cannot read " + sizes.source_file + (what.empty() ? "" : ": ") + what);
    }
    if(! sources.empty())
      m_sources = make_source_field(sources, "sources");
  }

  void set_background(const Sizes& sizes)
  {
    BR3::Background_mesh_3<Kernel> mesh;
    std::string what;
    if(! sizes.background_file.empty())
    {
      if(! BR3::read_background_mesh(sizes.background_file, mesh, what))
        throw std::invalid_argument("cannot read " + sizes.background_file + ": " + what);
    }
    else if(sizes.background_sizes != nullptr)
    {
      const Points points = as_points(sizes.background_points);
      const Tetrahedra tetrahedra = as_rows<4>(sizes.background_tetrahedra);
      mesh.points.assign(points.begin(), points.end());
      mesh.tetrahedra.assign(tetrahedra.begin(), tetrahedra.end());
      mesh.sizes.assign(sizes.background_sizes, sizes.background_sizes + points.size());
    }
    else
      return;
    m_background = std::make_shared<Background_field>(mesh, sizes.grading);
    if(! m_background->is_valid())
      throw std::invalid_argument("background: sizes have to be positive numbers, and tetrahedra to name its points");
  }
};

} // namespace boundary_recovery

#endif // BOUNDARY_RECOVERY_3_PYTHON_SIZE_FIELD_H

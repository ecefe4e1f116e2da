#ifndef BOUNDARY_RECOVERY_3_PROGRAM_MESH_SIZE_H
#define BOUNDARY_RECOVERY_3_PROGRAM_MESH_SIZE_H

#include "mesh_surface_options.h"
#include "surface.h"

#include <CGAL/Boundary_recovery_3/Background_mesh_3.h>
#include <CGAL/Boundary_recovery_3/Background_mesh_sizing_field_3.h>
#include <CGAL/Boundary_recovery_3/Size_source_3.h>
#include <CGAL/Boundary_recovery_3/Source_sizing_field_3.h>
#include <CGAL/Boundary_recovery_3/Surface_sizing_field_3.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <string>
#include <vector>

// The sizes that the user asked for: the smallest of one to three kinds. It is cheap to be copied.
template <typename Triangulation>
class Mesh_size
{
  typedef typename Triangulation::Geom_traits                                       Traits;
  typedef typename Triangulation::Point                                             Point;
  typedef CGAL::Boundary_recovery_3::Surface_sizing_field_3<Triangulation>          Surface_field;
  typedef CGAL::Boundary_recovery_3::Source_sizing_field_3<Traits>                 Source_field;
  typedef CGAL::Boundary_recovery_3::Background_mesh_sizing_field_3<Traits>         Background_field;

  double m_uniform = infinity();
  std::shared_ptr<const Surface_field> m_surface;
  std::shared_ptr<const Source_field> m_sources;
  std::shared_ptr<const Background_field> m_background;

public:
  // such that there is no edge that is too long
  static Mesh_size unbounded()
  {
    Mesh_size size;
    size.m_uniform = (std::numeric_limits<double>::max)();
    return size;
  }

  // takes sizes that are not from the surface; returns `false` and says why if a file cannot be read
  bool read(const Meshing_options& options, std::string& message)
  {
    if(options.size > 0)
      m_uniform = options.size;
    const double grading_of_mesh = options.has_grading ? options.grading : infinity();
    return (options.sources.empty() || read_sources(options.sources, message)) &&
           (options.background.empty() || read_background(options.background, grading_of_mesh, message));
  }

  // takes sizes from the surface, if these are asked for and it is valid: else nothing will be meshed
  void set_surface(const Surface<Point>& surface, const Meshing_options& options)
  {
    if(options.size == 0 && is_triangle_soup(surface))
      m_surface = std::make_shared<Surface_field>(surface.points, surface.faces, options.grading);
  }

  // the size at a point of a region, or of what else the dimension and the index tell
  double operator()(const Point& p, const int dimension, const int index) const
  {
    double size = m_uniform;
    if(m_surface)
      size = (std::min)(size, (*m_surface)(p, dimension, index));
    if(m_sources)
      size = (std::min)(size, (*m_sources)(p, dimension, index));
    if(m_background)
      size = (std::min)(size, (*m_background)(p, dimension, index));
    return size;
  }

  // a number that no size within a distance of a point is below
  double least_size_around(const Point& p, const double radius, const int index) const
  {
    double size = m_uniform;
    if(m_surface)
      size = (std::min)(size, m_surface->least_size_around(p, radius, index));
    if(m_sources)
      size = (std::min)(size, m_sources->least_size_around(p, radius, index));
    if(m_background)
      size = (std::min)(size, m_background->least_size_around(p, radius, index));
    return size;
  }

  // by how much the size grows per length, at most; infinity if that is not known
  double grading() const
  {
    double grading = 0;
    if(m_surface)
      grading = (std::max)(grading, m_surface->grading());
    if(m_sources)
      grading = (std::max)(grading, m_sources->grading());
    return m_background ? infinity() : grading;
  }

private:
  static double infinity() { return (std::numeric_limits<double>::infinity)(); }

  bool read_sources(const std::string& file, std::string& message)
  {
    std::ifstream is(file);
    std::vector<CGAL::Boundary_recovery_3::Size_source_3<Traits> > sources;
    std::string what;
    if(! is || ! CGAL::Boundary_recovery_3::read_size_sources(is, sources, what))
    {
      message = "cannot read " + file + (what.empty() ? "" : ": ") + what;
      return false;
    }
    m_sources = std::make_shared<Source_field>(sources, m_uniform);
    return true;
  }

  bool read_background(const std::string& file, const double grading, std::string& message)
  {
    CGAL::Boundary_recovery_3::Background_mesh_3<Traits> mesh;
    std::string what;
    if(! CGAL::Boundary_recovery_3::read_background_mesh(file, mesh, what))
    {
      message = "cannot read " + file + ": " + what;
      return false;
    }
    m_background = std::make_shared<Background_field>(mesh, grading);
    return true;
  }
};

// All the files that are read, those that stand beside the background mesh included.
inline std::vector<std::string> input_files(const Meshing_options& options)
{
  std::vector<std::string> files = { options.input, options.sources };
  if(! options.background.empty())
    for(const char* extension : { ".mesh", ".sol", ".node", ".ele", ".mtr" })
      files.push_back(std::filesystem::path(options.background).replace_extension(extension).string());
  return files;
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_MESH_SIZE_H

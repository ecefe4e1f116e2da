#ifndef BOUNDARY_RECOVERY_3_PROGRAM_OPEN_SURFACE_H
#define BOUNDARY_RECOVERY_3_PROGRAM_OPEN_SURFACE_H

#include "boundary_loops.h"
#include "domain.h"
#include "domain_sides.h"
#include "print_summary.h"
#include "surface.h"
#include "triangle_soup.h"
#include "write_report.h"

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

// How many of many are shown on the console; the report has all of them.
constexpr std::size_t number_of_examples = 3;

// What of a surface bounds nothing, and where it ends.
struct Open_surface
{
  std::size_t number_of_faces = 0;        // of the whole surface
  std::vector<std::size_t> idle_faces;    // with no region on either side, by their numbers in the surface
  std::size_t number_of_inner_faces = 0;  // with the same region on both sides: sheets that are there on purpose
  CGAL::Bbox_3 box;                       // of the idle faces
  Boundary_loops boundary;                // where the idle faces end
};

// The loops are those of the faces that are listed as idle.
template <typename Point>
void find_borders(const Surface<Point>& surface, Open_surface& open)
{
  std::vector<bool> is_idle(surface.faces.size(), false);
  for(const std::size_t f : open.idle_faces)
  {
    is_idle[f] = true;
    for(const std::size_t v : surface.faces[f])
      open.box += surface.points[v].bbox();
  }
  std::vector<Open_edge> edges = open_edges(surface.faces);
  edges.erase(std::remove_if(edges.begin(), edges.end(), [&](const Open_edge& e) { return ! is_idle[e.triangle]; }),
              edges.end());
  open.boundary = find_boundary_loops(surface.points, edges);
}

// the same for a surface that was not meshed: all of it bounds nothing yet; empty if it is no triangle soup
template <typename Point>
Open_surface find_open_surface(const Surface<Point>& surface)
{
  Open_surface open;
  open.number_of_faces = surface.faces.size();
  if(! is_triangle_soup(surface))
    return open;
  for(std::size_t f = 0; f < surface.faces.size(); ++f)
    open.idle_faces.push_back(f);
  find_borders(surface, open);
  return open;
}

// for a surface that was meshed; the triangles of the domain still have the numbers of faces in the surface
template <typename Point>
Open_surface find_open_surface(const Surface<Point>& surface, const Domain<Point>& domain)
{
  if(domain.number_of_regions == 0)
    return find_open_surface(surface);
  Open_surface open;
  open.number_of_faces = surface.faces.size();
  const std::vector<Sides> sides = find_sides(domain);
  for(std::size_t t = 0; t < sides.size(); ++t)
  {
    if(t > 0 && domain.triangle_numbers[t - 1] == domain.triangle_numbers[t])
      continue; // parts of a face come one after the other, and have the same regions beside them
    if(sides[t][1] == 0)
      open.idle_faces.push_back(domain.triangle_numbers[t]);
    open.number_of_inner_faces += sides[t][0] != 0 && sides[t][0] == sides[t][1];
  }
  if(! open.idle_faces.empty())
    find_borders(surface, open);
  return open;
}

inline void print_box(std::ostream& os, const CGAL::Bbox_3& box)
{
  os << '(' << box.xmin() << ' ' << box.ymin() << ' ' << box.zmin() << ") and (" << box.xmax() << ' ' << box.ymax()
     << ' ' << box.zmax() << ')';
}

inline void print_loop(std::ostream& os, const Boundary_loop& loop)
{
  os << "  a " << (loop.is_closed ? "loop" : "chain that does not close") << " of "
     << count(loop.number_of_edges(), "edge") << ", " << loop.length << " long, between ";
  print_box(os, loop.box);
  os << '\n';
}

// prints how many loops there are, and the longest ones; nothing if there are none
inline void print_loops(std::ostream& os, const Boundary_loops& boundary)
{
  const std::size_t n = boundary.loops.size(), shown = (std::min)(n, number_of_examples);
  if(n == 0)
    return;
  os << "the surface is open along " << count(n, "loop") << " of edges that only one triangle has"
     << (shown < n ? "; the longest ones:\n" : ":\n");
  for(std::size_t i = 0; i < shown; ++i)
    print_loop(os, boundary.loops[i]);
  if(boundary.number_of_branching_vertices > 0)
    os << "  they touch: other loops could be made of the same edges\n";
  if(shown < n)
    os << "  and " << n - shown << " more: --report lists all of them\n";
}

// prints which faces bound nothing, though others do
template <typename Point>
void print_idle_faces(std::ostream& os, const Open_surface& open, const Surface<Point>& surface)
{
  const std::size_t n = open.idle_faces.size(), shown = (std::min)(n, number_of_examples);
  os << n << " of " << count(open.number_of_faces, "triangle") << (n == 1 ? " bounds" : " bound")
     << " nothing, there is no region beside: ";
  for(std::size_t i = 0; i < shown; ++i)
  {
    const std::size_t number = surface.face_number(open.idle_faces[i]);
    os << (i == 0 ? "facet " : ", ") << (number == surface.no_face ? "added" : std::to_string(number));
  }
  os << (shown < n ? ", ..." : "") << ", between ";
  print_box(os, open.box);
  os << '\n';
}

// the entries of a loop
template <typename Point>
void write_loop(Json_writer& json, const Boundary_loop& loop, const Surface<Point>& surface)
{
  const CGAL::Bbox_3& box = loop.box;
  json.entry("is_closed", loop.is_closed);
  json.entry("number_of_edges", loop.number_of_edges());
  json.entry("length", loop.length);
  json.key("box");
  json.list(std::vector<double>{ box.xmin(), box.ymin(), box.zmin(), box.xmax(), box.ymax(), box.zmax() },
            [&](const double x) { json.value(x); });
  json.key("vertices");
  json.list(loop.vertices, [&](const std::size_t v) { json.value(surface.vertex_number(v)); });
}

template <typename Point>
void write_open_surface(Json_writer& json, const Open_surface& open, const Surface<Point>& surface)
{
  json.entry("number_of_facets_inside_regions", open.number_of_inner_faces);
  json.entry("number_of_facets_that_bound_nothing", open.idle_faces.size());
  json.key("facets_that_bound_nothing");
  json.list(open.idle_faces, [&](const std::size_t f) { json.number_or_null(surface.face_number(f)); });
  json.entry("number_of_branching_boundary_vertices", open.boundary.number_of_branching_vertices);
  json.key("boundary_loops");
  json.objects(open.boundary.loops, [&](const Boundary_loop& loop) { write_loop(json, loop, surface); });
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_OPEN_SURFACE_H

#ifndef BOUNDARY_RECOVERY_3_PROGRAM_WRITE_MEDIT_H
#define BOUNDARY_RECOVERY_3_PROGRAM_WRITE_MEDIT_H

#include "domain.h"
#include "output_buffer.h"

#include <array>
#include <cstddef>
#include <vector>

// a section: for each simplex its vertices, from 1, and its reference
template <std::size_t N, typename Reference>
void write_medit_simplices(Output_buffer& os, const char* keyword,
                           const std::vector<std::array<Point_number, N> >& simplices,
                           const std::vector<Reference>& references)
{
  os << keyword << '\n' << simplices.size() << '\n';
  for(std::size_t i = 0; i < simplices.size(); ++i)
  {
    for(const Point_number v : simplices[i])
      os << std::size_t(v) + 1 << ' ';
    os << references[i] << '\n';
  }
}

// writes the triangles with their patches and the tetrahedra with their regions in MEDIT's text format
template <typename Point>
void write_medit(Output_buffer& os, const Domain<Point>& domain)
{
  os << "MeshVersionFormatted 2\nDimension 3\nVertices\n" << domain.points.size() << '\n';
  for(const Point& p : domain.points)
    os << p.x() << ' ' << p.y() << ' ' << p.z() << " 0\n";
  write_medit_simplices(os, "Triangles", domain.triangles, domain.patches);
  write_medit_simplices(os, "Tetrahedra", domain.tetrahedra, domain.regions);
  os << "End\n";
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_WRITE_MEDIT_H

#ifndef BOUNDARY_RECOVERY_3_PROGRAM_WRITE_MEDIT_H
#define BOUNDARY_RECOVERY_3_PROGRAM_WRITE_MEDIT_H

#include "domain.h"
#include "output_buffer.h"
#include "second_order.h"

#include <CGAL/Boundary_recovery_3/internal/util/Medit_writer.h>

#include <cstddef>

// writes the triangles with their patches and the tetrahedra with their regions in MEDIT's text format
template <typename Point>
void write_medit(Output_buffer& os, const Domain<Point>& domain)
{
  CGAL::Boundary_recovery_3::internal::Medit_writer<Output_buffer> writer(os);
  writer.write_vertices(domain.number_of_nodes(), [&](const std::size_t i) -> const Point& { return domain.node(i); });
  const bool is_second_order = domain.is_second_order();
  writer.write_simplices(is_second_order ? "TrianglesP2" : "Triangles", domain.triangles.size(),
                         [&](const std::size_t i, const auto& f)
                         { with_nodes(domain.triangles, domain.edges_of_triangles, i, f); }, domain.patches);
  writer.write_simplices(is_second_order ? "TetrahedraP2" : "Tetrahedra", domain.tetrahedra.size(),
                         [&](const std::size_t i, const auto& f)
                         { with_nodes(domain.tetrahedra, domain.edges_of_tetrahedra, i, f); }, domain.regions);
  writer.write_end();
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_WRITE_MEDIT_H

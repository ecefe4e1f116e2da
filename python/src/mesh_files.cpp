// Writes meshes as the programs do it.

#include "module_types.h"

#include "domain.h"
#include "second_order.h"
#include "write_domain.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <string>

namespace boundary_recovery {
namespace {

template <std::size_t N>
std::array<Point_number, N> numbers_of_points(const std::array<std::size_t, N>& row)
{
  std::array<Point_number, N> numbers;
  std::transform(row.begin(), row.end(), numbers.begin(), [](const std::size_t i) { return Point_number(i); });
  return numbers;
}

Domain<Point_3> make_domain(const Mesh_view& mesh)
{
  const Points points = as_points(mesh.points);
  Domain<Point_3> domain;
  domain.points.assign(points.begin(), points.end());
  for(const auto& t : as_rows<4>(mesh.tetrahedra))
    domain.tetrahedra.push_back(numbers_of_points(t));
  for(const auto& t : as_rows<3>(mesh.triangles))
    domain.triangles.push_back(numbers_of_points(t));
  domain.regions.assign(mesh.regions, mesh.regions + mesh.tetrahedra.size);
  domain.patches.assign(mesh.patches, mesh.patches + mesh.triangles.size);
  domain.triangle_numbers.assign(mesh.triangle_numbers, mesh.triangle_numbers + mesh.triangles.size);
  domain.patch_names = mesh.patch_names;
  domain.region_names = mesh.region_names;
  for(const int region : domain.regions)
    domain.number_of_regions = (std::max)(domain.number_of_regions, region);
  return domain;
}

} // namespace

bool writes_mesh_files(const std::string& extension) { return is_output_format(extension); }

int write_mesh_file(const std::string& file, const Mesh_view& mesh, const int order)
{
  Domain<Point_3> domain = make_domain(mesh);
  if(order == 2)
    add_edge_points(domain);
  if(write_whole_domain(file, domain))
    return 0;
  return errno != 0 ? errno : EIO;
}

} // namespace boundary_recovery

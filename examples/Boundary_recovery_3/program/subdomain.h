#ifndef BOUNDARY_RECOVERY_3_PROGRAM_SUBDOMAIN_H
#define BOUNDARY_RECOVERY_3_PROGRAM_SUBDOMAIN_H

#include "byte_string.h"
#include "domain.h"
#include "domain_sides.h"
#include "read_surface.h"

#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <stdexcept>
#include <vector>

// A region of the domain by itself: its boundary, turned such that the region is what it bounds, and the sheets inside.
// Each triangle is one of the whole surface, which stays as it is: so neighbours fit together, whoever meshes them.
struct Subdomain
{
  typedef std::array<Point_number, 3> Triangle;

  int region = 0;
  std::vector<Point_number> points;    // for each point, its number in the surface; in ascending order
  std::vector<Triangle> triangles;     // three positions in `points`
  std::vector<std::size_t> faces;      // for each triangle, its number in the surface
  double weight = 0;                   // about how many tetrahedra it will have
};

// Divides a domain whose boundary is recovered into its regions.
template <typename Point, typename Size>
class Domain_divider
{
  typedef Subdomain::Triangle Triangle;

  const Domain<Point>& m_domain;
  const Size& m_size;
  std::map<Triangle, std::size_t> m_triangles; // by their sorted vertices
  std::vector<Subdomain> m_subdomains;

public:
  Domain_divider(const Domain<Point>& domain, const Size& size) : m_domain(domain), m_size(size) { }

  std::vector<Subdomain> operator()()
  {
    for(std::size_t i = 0; i < m_domain.triangles.size(); ++i)
      m_triangles.emplace(sorted(m_domain.triangles[i]), i);
    m_subdomains.resize(static_cast<std::size_t>(m_domain.number_of_regions));
    add_triangles();
    for(std::size_t i = 0; i < m_domain.tetrahedra.size(); ++i)
      subdomain_of(i).weight += expected_tetrahedra(m_domain.tetrahedra[i], m_domain.regions[i]);
    int region = 0;
    for(Subdomain& subdomain : m_subdomains)
    {
      subdomain.region = ++region;
      number_points(subdomain);
    }
    return std::move(m_subdomains);
  }

private:
  static Triangle sorted(Triangle t)
  {
    std::sort(t.begin(), t.end());
    return t;
  }

  Subdomain& subdomain_of(const std::size_t tetrahedron)
  {
    return m_subdomains[static_cast<std::size_t>(m_domain.regions[tetrahedron]) - 1];
  }

  // From each tetrahedron, a triangle is seen with its outer side in front. Of a sheet, one side is enough.
  void add_triangles()
  {
    constexpr int outward[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };
    const std::vector<Sides> sides = find_sides(m_domain);
    std::vector<bool> is_taken(m_domain.triangles.size(), false); // as a sheet
    for(std::size_t t = 0; t < m_domain.tetrahedra.size(); ++t)
      for(const auto& corners : outward)
      {
        Triangle triangle;
        for(std::size_t i = 0; i < 3; ++i)
          triangle[i] = m_domain.tetrahedra[t][static_cast<std::size_t>(corners[i])];
        const auto found = m_triangles.find(sorted(triangle));
        if(found == m_triangles.end())
          continue;
        const bool is_sheet = sides[found->second][0] == sides[found->second][1];
        if(is_sheet && is_taken[found->second])
          continue;
        is_taken[found->second] = true;
        subdomain_of(t).triangles.push_back(triangle);
        subdomain_of(t).faces.push_back(m_domain.patches[found->second] - 1);
      }
  }

  // the integral of 6 sqrt(2) / h^3, by its values at the corners and in the middle
  double expected_tetrahedra(const std::array<Point_number, 4>& tetrahedron, const int region) const
  {
    double center[3] = { 0, 0, 0 }, mean = 0;
    for(const Point_number v : tetrahedron)
    {
      const Point& p = m_domain.points[v];
      mean += density(p, region) / 20;
      for(int i = 0; i < 3; ++i)
        center[i] += p[i] / 4;
    }
    mean += 0.8 * density(Point(center[0], center[1], center[2]), region);
    return mean * std::abs(CGAL::volume(m_domain.points[tetrahedron[0]], m_domain.points[tetrahedron[1]],
                                        m_domain.points[tetrahedron[2]], m_domain.points[tetrahedron[3]]));
  }

  double density(const Point& p, const int region) const
  {
    const double size = m_size(p, 3, region);
    return 6 * std::sqrt(2.) / (size * size * size);
  }

  static void number_points(Subdomain& subdomain)
  {
    for(const Triangle& triangle : subdomain.triangles)
      subdomain.points.insert(subdomain.points.end(), triangle.begin(), triangle.end());
    std::sort(subdomain.points.begin(), subdomain.points.end());
    subdomain.points.erase(std::unique(subdomain.points.begin(), subdomain.points.end()), subdomain.points.end());
    for(Triangle& triangle : subdomain.triangles)
      for(Point_number& v : triangle)
        v = static_cast<Point_number>(std::lower_bound(subdomain.points.begin(), subdomain.points.end(), v)
                                      - subdomain.points.begin());
  }
};

// The mesh of a sub-domain. Its first points are those of the sub-domain, which all has: the others are kept here.
template <typename Point>
struct Subdomain_mesh
{
  typedef std::array<Point_number, 4> Tetrahedron;

  std::vector<Point> points;
  std::vector<Tetrahedron> tetrahedra;
  std::uint64_t number_of_steiner_points = 0;

  Bytes bytes() const
  {
    std::vector<double> coordinates;
    for(const Point& p : points)
      for(int i = 0; i < 3; ++i)
        coordinates.push_back(p[i]);
    Bytes result;
    Byte_writer writer(result);
    writer.put(number_of_steiner_points);
    writer.put(coordinates);
    writer.put(tetrahedra);
    return result;
  }

  // throws if these are not the bytes of a mesh of that sub-domain
  static Subdomain_mesh from_bytes(const Bytes& bytes, const Subdomain& subdomain)
  {
    Subdomain_mesh mesh;
    std::vector<double> coordinates;
    Byte_reader reader(bytes);
    mesh.number_of_steiner_points = reader.get<std::uint64_t>();
    reader.get(coordinates);
    reader.get(mesh.tetrahedra);
    for(std::size_t i = 0; i + 2 < coordinates.size(); i += 3)
      mesh.points.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
    const std::size_t n = subdomain.points.size() + mesh.points.size();
    const bool is_valid = std::all_of(mesh.tetrahedra.begin(), mesh.tetrahedra.end(), [&](const Tetrahedron& t)
                                      { return *std::max_element(t.begin(), t.end()) < n; });
    if(! reader.is_at_end() || ! is_valid)
      throw std::runtime_error("it is no mesh of the sub-domain");
    return mesh;
  }
};

// What all the meshes of sub-domains together are. Their own points follow those of the surface, in the order of the
// sub-domains: whoever knows how many each has knows all the numbers.
template <typename Point>
class Divided_mesh
{
  const Surface<Point>& m_surface;
  const std::vector<Subdomain>& m_subdomains;
  std::vector<std::uint64_t> m_first_points; // of each sub-domain, the number of the first one of its own

public:
  // `numbers` are those of the own points of each sub-domain
  Divided_mesh(const Surface<Point>& surface, const std::vector<Subdomain>& subdomains,
               const std::vector<std::uint64_t>& numbers)
    : m_surface(surface), m_subdomains(subdomains), m_first_points(1, surface.points.size())
  {
    for(const std::uint64_t n : numbers)
      m_first_points.push_back(m_first_points.back() + n);
  }

  std::uint64_t number_of_points() const { return m_first_points.back(); }

  // the number in the whole mesh of a point of a sub-domain
  std::uint64_t global_number(const std::size_t subdomain, const Point_number v) const
  {
    const std::size_t shared = m_subdomains[subdomain].points.size();
    return v < shared ? m_subdomains[subdomain].points[v] : m_first_points[subdomain] + (v - shared);
  }

  // adds a mesh to the whole one, to which all the sub-domains before were added
  void add_to(Domain<Point>& whole, const std::size_t i, const Subdomain_mesh<Point>& mesh) const
  {
    if(number_of_points() > (std::numeric_limits<Point_number>::max)())
      throw std::length_error("the mesh has too many vertices to be merged");
    whole.points.insert(whole.points.end(), mesh.points.begin(), mesh.points.end());
    for(auto tetrahedron : mesh.tetrahedra)
    {
      for(Point_number& v : tetrahedron)
        v = static_cast<Point_number>(global_number(i, v));
      whole.tetrahedra.push_back(tetrahedron);
      whole.regions.push_back(m_subdomains[i].region);
    }
    whole.number_of_steiner_points += mesh.number_of_steiner_points;
    whole.number_of_field_points += mesh.points.size() - mesh.number_of_steiner_points;
  }

  // A sub-domain as a piece of the whole, and the number of each of its points there. A triangle between two of them is
  // in the first one only; triangles that bound nothing are in the first of all.
  Domain<Point> piece(const std::size_t i, const Subdomain_mesh<Point>& mesh, const Domain<Point>& surface_domain,
                      const std::vector<Sides>& sides, std::vector<std::uint64_t>& numbers) const
  {
    const Subdomain& subdomain = m_subdomains[i];
    Domain<Point> piece;
    for(const Point_number v : subdomain.points)
      piece.points.push_back(m_surface.points[v]);
    piece.points.insert(piece.points.end(), mesh.points.begin(), mesh.points.end());
    piece.tetrahedra = mesh.tetrahedra;
    piece.regions.assign(mesh.tetrahedra.size(), subdomain.region);
    piece.number_of_regions = subdomain.region;
    numbers.clear();
    for(std::size_t v = 0; v < piece.points.size(); ++v)
      numbers.push_back(global_number(i, static_cast<Point_number>(v)));
    std::map<Point_number, Point_number> local;
    for(std::size_t v = 0; v < subdomain.points.size(); ++v)
      local[subdomain.points[v]] = static_cast<Point_number>(v);
    for(std::size_t t = 0; t < sides.size(); ++t)
    {
      const int first = sides[t][0] != 0 ? sides[t][0] : (std::max)(sides[t][1], 1);
      if(first != subdomain.region)
        continue;
      auto triangle = surface_domain.triangles[t];
      for(Point_number& v : triangle)
      {
        const auto inserted = local.emplace(v, static_cast<Point_number>(piece.points.size()));
        if(inserted.second)
        {
          piece.points.push_back(m_surface.points[v]);
          numbers.push_back(v);
        }
        v = inserted.first->second;
      }
      piece.triangles.push_back(triangle);
      piece.patches.push_back(surface_domain.patches[t]);
    }
    return piece;
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_SUBDOMAIN_H

#ifndef BOUNDARY_RECOVERY_3_PROGRAM_WRITE_GMSH_H
#define BOUNDARY_RECOVERY_3_PROGRAM_WRITE_GMSH_H

#include "domain.h"
#include "domain_sides.h"
#include "output_buffer.h"

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

// Writes Gmsh's format 4.1, as text. Each region is a volume, and all the triangles with the same regions on both sides
// are a surface; each of them is a physical group with a name, so that a solver can put its conditions there. Were each
// triangle a surface of its own, there would be thousands of them: its number in the input is data, named `patch`.
template <typename Point>
class Gmsh_writer
{
  // of an entity, and of its physical group
  struct Name
  {
    int tag; // that of a volume is the number of the region
    std::string name;
  };

  // what Gmsh calls an entity
  struct Entity
    : public Name
  {
    int dimension;
    std::vector<std::size_t> simplices; // triangles or tetrahedra, in ascending order
    CGAL::Bbox_3 box;
  };

  Output_buffer& m_os;
  const Domain<Point>& m_domain;
  const std::vector<Sides> m_sides;
  std::vector<Entity> m_entities;         // surfaces, then volumes
  std::vector<std::size_t> m_owners;      // of each point, the first entity that has it

public:
  Gmsh_writer(Output_buffer& os, const Domain<Point>& domain)
    : m_os(os), m_domain(domain), m_sides(find_sides(domain)), m_owners(domain.points.size(), std::size_t(-1))
  { }

  void operator()()
  {
    int number_of_surfaces = 0;
    add_entities(2, m_sides, m_domain.triangles, [&](const Sides& sides)
                 { return Name{ ++number_of_surfaces, name_of_surface(sides) }; });
    add_entities(3, m_domain.regions, m_domain.tetrahedra, [&](const int region)
                 { return region == 0 ? Name{ m_domain.number_of_regions + 1, "outside" }
                                      : Name{ region, "region_" + std::to_string(region) }; });
    m_os << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    write_names();
    write_entities();
    write_nodes();
    write_elements();
    write_patches();
  }

private:
  static std::string name_of_surface(const Sides& sides)
  {
    const std::string first = std::to_string(sides[0]), second = std::to_string(sides[1]);
    if(sides[0] == sides[1])
      return sides[0] == 0 ? "sheet_outside" : "sheet_in_region_" + first;
    return sides[0] == 0 ? "boundary_of_region_" + second : "interface_of_regions_" + first + "_and_" + second;
  }

  // an entity for each value that simplices have, in ascending order
  template <typename Value, typename Simplices, typename Naming>
  void add_entities(const int dimension, const std::vector<Value>& values, const Simplices& simplices,
                    const Naming& name)
  {
    std::map<Value, std::vector<std::size_t> > simplices_of;
    for(std::size_t i = 0; i < values.size(); ++i)
      simplices_of[values[i]].push_back(i);
    for(auto& entry : simplices_of)
    {
      CGAL::Bbox_3 box;
      for(const std::size_t i : entry.second)
        for(const Point_number v : simplices[i])
        {
          box += m_domain.points[v].bbox();
          m_owners[v] = (std::min)(m_owners[v], m_entities.size());
        }
      m_entities.push_back({ name(entry.first), dimension, std::move(entry.second), box });
    }
  }

  std::size_t number_of_entities(const int dimension) const
  {
    return static_cast<std::size_t>(std::count_if(m_entities.begin(), m_entities.end(), [&](const Entity& entity)
                                                  { return entity.dimension == dimension; }));
  }

  void write_names()
  {
    m_os << "$PhysicalNames\n" << m_entities.size() << '\n';
    for(const Entity& entity : m_entities)
      m_os << entity.dimension << ' ' << entity.tag << " \"" << entity.name << "\"\n";
    m_os << "$EndPhysicalNames\n";
  }

  void write_entities()
  {
    m_os << "$Entities\n0 0 " << number_of_entities(2) << ' ' << number_of_entities(3) << '\n';
    for(const Entity& entity : m_entities)
    {
      m_os << entity.tag;
      for(int i = 0; i < 3; ++i)
        m_os << ' ' << entity.box.min(i);
      for(int i = 0; i < 3; ++i)
        m_os << ' ' << entity.box.max(i);
      m_os << " 1 " << entity.tag;
      write_boundary(entity);
    }
    m_os << "$EndEntities\n";
  }

  // of a volume, the surfaces that are not inside of it; of a surface nothing, since no curves are told apart
  void write_boundary(const Entity& volume)
  {
    std::vector<int> tags;
    for(const Entity& surface : m_entities)
      if(volume.dimension == 3 && surface.dimension == 2)
      {
        const int region = m_domain.regions[volume.simplices[0]];
        const Sides& sides = m_sides[surface.simplices[0]];
        if(sides[0] != sides[1] && (sides[0] == region || sides[1] == region))
          tags.push_back(surface.tag);
      }
    m_os << ' ' << tags.size();
    for(const int tag : tags)
      m_os << ' ' << tag;
    m_os << '\n';
  }

  // A block is a run of points of one entity, so that the points keep their order.
  void write_nodes()
  {
    const std::size_t n = m_domain.points.size();
    std::vector<std::size_t> begins;
    for(std::size_t v = 0; v < n; ++v)
      if(v == 0 || m_owners[v] != m_owners[v - 1])
        begins.push_back(v);
    begins.push_back(n);
    m_os << "$Nodes\n" << begins.size() - 1 << ' ' << n << " 1 " << n << '\n';
    for(std::size_t b = 0; b + 1 < begins.size(); ++b)
    {
      const Entity& owner = m_entities[m_owners[begins[b]]];
      m_os << owner.dimension << ' ' << owner.tag << " 0 " << begins[b + 1] - begins[b] << '\n';
      for(std::size_t v = begins[b]; v < begins[b + 1]; ++v)
        m_os << v + 1 << '\n';
      for(std::size_t v = begins[b]; v < begins[b + 1]; ++v)
        m_os << m_domain.points[v].x() << ' ' << m_domain.points[v].y() << ' ' << m_domain.points[v].z() << '\n';
    }
    m_os << "$EndNodes\n";
  }

  // Triangles have their numbers, from 1; those of the tetrahedra go on from there.
  void write_elements()
  {
    const std::size_t n = m_domain.triangles.size() + m_domain.tetrahedra.size();
    m_os << "$Elements\n" << m_entities.size() << ' ' << n << " 1 " << n << '\n';
    for(const Entity& entity : m_entities)
      if(entity.dimension == 2)
        write_elements(entity, 2, m_domain.triangles, 1);
      else
        write_elements(entity, 4, m_domain.tetrahedra, m_domain.triangles.size() + 1);
    m_os << "$EndElements\n";
  }

  template <typename Simplices>
  void write_elements(const Entity& entity, const int type, const Simplices& simplices, const std::size_t first_number)
  {
    m_os << entity.dimension << ' ' << entity.tag << ' ' << type << ' ' << entity.simplices.size() << '\n';
    for(const std::size_t i : entity.simplices)
    {
      m_os << first_number + i;
      for(const Point_number v : simplices[i])
        m_os << ' ' << std::size_t(v) + 1;
      m_os << '\n';
    }
  }

  void write_patches()
  {
    const std::size_t n = m_domain.triangles.size();
    m_os << "$ElementData\n1\n\"patch\"\n1\n0\n3\n0\n1\n" << n << '\n';
    for(std::size_t i = 0; i < n; ++i)
      m_os << i + 1 << ' ' << m_domain.patches[i] << '\n';
    m_os << "$EndElementData\n";
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_WRITE_GMSH_H

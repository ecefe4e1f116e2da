#ifndef BOUNDARY_RECOVERY_3_PROGRAM_WRITE_GMSH_H
#define BOUNDARY_RECOVERY_3_PROGRAM_WRITE_GMSH_H

#include "domain.h"
#include "domain_sides.h"
#include "output_buffer.h"
#include "second_order.h"

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

// Writes Gmsh's formats 4.1 and 2.2, as text. Each region is a volume, and all the triangles of a patch with the same
// regions on both sides are a surface. Regions and patches are physical groups with names, so that a solver can put its
// conditions there. The number of a triangle in the input is data. If the parts of a mesh are given, the entities are
// divided by them, as Gmsh does it: what has the tetrahedra or the triangles is an entity for each part, or for each
// two parts that meet; it has the whole one as its parent.
template <typename Point>
class Gmsh_writer
{
  typedef std::pair<int, Sides> Patch_sides; // the patch of triangles, and the regions on both sides

  // what Gmsh calls an entity
  struct Entity
  {
    int tag;                            // that of a volume is the number of its region
    int group;                          // the tag of its physical group
    int dimension;
    Sides parts;                        // on its sides, the smaller one first; of a volume, its part twice
    std::vector<std::size_t> simplices; // triangles or tetrahedra, in ascending order; of a parent, the first one
    CGAL::Bbox_3 box;
    std::size_t parent;                 // its position; that of itself if it is one
  };

  Output_buffer& m_os;
  const Domain<Point>& m_domain;
  const std::vector<int> m_parts;         // of each tetrahedron, from 1; empty: the mesh is not divided
  const std::vector<Sides> m_sides, m_part_sides;
  std::map<int, std::string> m_groups[2]; // the names of physical groups by their tags, of surfaces and of volumes
  std::vector<Entity> m_parents;          // surfaces, then volumes
  std::vector<Entity> m_entities;         // the same; or if the mesh is divided, what they are divided into
  std::vector<std::size_t> m_owners;      // of each point, the first entity that has it

public:
  explicit Gmsh_writer(Output_buffer& os, const Domain<Point>& domain, const std::vector<int>& parts = { })
    : m_os(os), m_domain(domain), m_parts(parts), m_sides(find_sides(domain)),
      m_part_sides(parts.empty() ? std::vector<Sides>(domain.triangles.size(), Sides{{ 0, 0 }})
                                 : find_sides(domain, parts)),
      m_owners(domain.number_of_nodes(), std::size_t(-1))
  { }

  void operator()()
  {
    add_surfaces();
    add_volumes();
    m_os << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    write_names();
    write_entities();
    if(is_divided())
      write_partitioned_entities();
    write_nodes();
    write_elements(false);
    write_data();
  }

  // The same in version 2.2, which MFEM and OpenFOAM read. Entities are not divided, and there are no data, which
  // meshio would take for those of other elements.
  void write_version_2()
  {
    add_surfaces();
    add_volumes();
    m_os << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    write_names();
    write_nodes_of_version_2();
    write_elements(true);
  }

private:
  // Groups have the numbers of patches. What is in no patch is grouped by its sides: Gmsh's numbers begin with 1.
  void add_surfaces()
  {
    std::vector<Patch_sides> values;
    int largest_patch = 0;
    for(std::size_t i = 0; i < m_sides.size(); ++i)
    {
      values.emplace_back(m_domain.patches[i], m_sides[i]);
      largest_patch = (std::max)(largest_patch, m_domain.patches[i]);
    }
    int number_of_surfaces = 0;
    add_entities(2, values, [&](const std::size_t i) { return m_part_sides[i]; }, [&](const Patch_sides& value)
    {
      const auto& [patch, sides] = value;
      const int tag = ++number_of_surfaces, group = patch == 0 ? largest_patch + tag : patch;
      m_groups[0].emplace(group, patch == 0 ? name_of_surface(sides) : name_of(m_domain.patch_names, patch, "patch_"));
      return std::make_pair(tag, group);
    });
  }

  void add_volumes()
  {
    std::map<std::string, int> groups;
    add_entities(3, m_domain.regions, [&](const std::size_t i) { return is_divided() ? Sides{{ m_parts[i], m_parts[i] }}
                                                                                     : Sides{{ 0, 0 }}; },
                 [&](const int region)
    {
      const int tag = region == 0 ? m_domain.number_of_regions + 1 : region;
      const std::string name = region == 0 ? "outside" : name_of(m_domain.region_names, region, "region_");
      const int group = groups.emplace(name, tag).first->second; // regions of one name are one group
      m_groups[1].emplace(group, name);
      return std::make_pair(tag, group);
    });
  }

  static std::string name_of(const std::map<int, std::string>& names, const int number, const std::string& noun)
  {
    const auto known = names.find(number);
    std::string name = known == names.end() ? noun + std::to_string(number) : known->second;
    std::replace(name.begin(), name.end(), '"', '\'');
    return name;
  }

  static std::string name_of_surface(const Sides& sides)
  {
    const std::string first = std::to_string(sides[0]), second = std::to_string(sides[1]);
    if(sides[0] == sides[1])
      return sides[0] == 0 ? "sheet_outside" : "sheet_in_region_" + first;
    return sides[0] == 0 ? "boundary_of_region_" + second : "interface_of_regions_" + first + "_and_" + second;
  }

  bool is_divided() const { return ! m_parts.empty(); }

  // a parent for each value that simplices have, and an entity for each of its parts, in ascending order
  template <typename Value, typename Parts, typename Tags>
  void add_entities(const int dimension, const std::vector<Value>& values, const Parts& parts, const Tags& tags)
  {
    std::map<std::pair<Value, Sides>, std::vector<std::size_t> > simplices_of;
    for(std::size_t i = 0; i < values.size(); ++i)
      simplices_of[std::make_pair(values[i], parts(i))].push_back(i);
    const std::size_t first = m_entities.size();
    int largest_tag = 0;
    const Value* previous = nullptr;
    for(auto& entry : simplices_of)
    {
      const Value& value = entry.first.first;
      if(previous == nullptr || *previous != value)
      {
        const auto [tag, group] = tags(value);
        m_parents.push_back({ tag, group, dimension, Sides{{ 0, 0 }}, { entry.second.front() }, CGAL::Bbox_3(),
                              m_parents.size() });
        largest_tag = (std::max)(largest_tag, m_parents.back().tag);
      }
      previous = &value;
      CGAL::Bbox_3 box;
      for(const std::size_t i : entry.second)
        for_each_node(dimension, i, [&](const Point_number v)
        {
          box += m_domain.node(v).bbox();
          m_owners[v] = (std::min)(m_owners[v], m_entities.size());
        });
      m_parents.back().box += box;
      m_entities.push_back({ m_parents.back().tag, m_parents.back().group, dimension, entry.first.second,
                             std::move(entry.second), box, m_parents.size() - 1 });
    }
    for(std::size_t e = first; is_divided() && e < m_entities.size(); ++e)
      m_entities[e].tag = ++largest_tag;
  }

  // calls the function with the nodes of a triangle or a tetrahedron in Gmsh's order: of a tetrahedron of second order,
  // the last two change places
  template <typename F>
  void for_each_node(const int dimension, const std::size_t i, const F& f) const
  {
    const auto for_each = [&](auto nodes)
    {
      if constexpr(std::tuple_size<decltype(nodes)>::value == 10)
        std::swap(nodes[8], nodes[9]);
      std::for_each(nodes.begin(), nodes.end(), f);
    };
    if(dimension == 2)
      with_nodes(m_domain.triangles, m_domain.edges_of_triangles, i, for_each);
    else
      with_nodes(m_domain.tetrahedra, m_domain.edges_of_tetrahedra, i, for_each);
  }

  static std::size_t number_of_entities(const std::vector<Entity>& entities, const int dimension)
  {
    return static_cast<std::size_t>(std::count_if(entities.begin(), entities.end(), [&](const Entity& entity)
                                                  { return entity.dimension == dimension; }));
  }

  void write_names()
  {
    m_os << "$PhysicalNames\n" << m_groups[0].size() + m_groups[1].size() << '\n';
    for(const int dimension : { 2, 3 })
      for(const auto& [tag, name] : m_groups[dimension - 2])
        m_os << dimension << ' ' << tag << " \"" << name << "\"\n";
    m_os << "$EndPhysicalNames\n";
  }

  void write_entities()
  {
    m_os << "$Entities\n0 0 " << number_of_entities(m_parents, 2) << ' ' << number_of_entities(m_parents, 3) << '\n';
    for(const Entity& entity : m_parents)
    {
      m_os << entity.tag;
      write_box_and_boundary(entity, m_parents);
    }
    m_os << "$EndEntities\n";
  }

  void write_partitioned_entities()
  {
    m_os << "$PartitionedEntities\n" << *std::max_element(m_parts.begin(), m_parts.end()) << "\n0\n0 0 "
         << number_of_entities(m_entities, 2) << ' ' << number_of_entities(m_entities, 3) << '\n';
    for(const Entity& entity : m_entities)
    {
      m_os << entity.tag << ' ' << entity.dimension << ' ' << m_parents[entity.parent].tag;
      write_parts(entity.parts);
      write_box_and_boundary(entity, m_entities);
    }
    m_os << "$EndPartitionedEntities\n";
  }

  // Outside there is no part. A triangle that bounds nothing is in the first one, as every entity has to be in one.
  void write_parts(const Sides& parts)
  {
    if(parts[0] == 0 || parts[0] == parts[1])
      m_os << " 1 " << (std::max)(parts[1], 1);
    else
      m_os << " 2 " << parts[0] << ' ' << parts[1];
  }

  void write_box_and_boundary(const Entity& entity, const std::vector<Entity>& entities)
  {
    for(int i = 0; i < 3; ++i)
      m_os << ' ' << entity.box.min(i);
    for(int i = 0; i < 3; ++i)
      m_os << ' ' << entity.box.max(i);
    m_os << " 1 " << entity.group;
    write_boundary(entity, entities);
  }

  // of a volume, the surfaces that are not inside of it; of a surface nothing, since no curves are told apart
  void write_boundary(const Entity& volume, const std::vector<Entity>& entities)
  {
    std::vector<int> tags;
    for(const Entity& surface : entities)
      if(volume.dimension == 3 && surface.dimension == 2)
      {
        const int region = m_domain.regions[volume.simplices[0]], part = volume.parts[0];
        const Sides& sides = m_sides[surface.simplices[0]];
        if(sides[0] != sides[1] && (sides[0] == region || sides[1] == region) &&
           (surface.parts[0] == part || surface.parts[1] == part))
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
    const std::size_t n = m_domain.number_of_nodes();
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
        write_coordinates(v);
    }
    m_os << "$EndNodes\n";
  }

  void write_nodes_of_version_2()
  {
    m_os << "$Nodes\n" << m_domain.number_of_nodes() << '\n';
    for(std::size_t v = 0; v < m_domain.number_of_nodes(); ++v)
    {
      m_os << v + 1 << ' ';
      write_coordinates(v);
    }
    m_os << "$EndNodes\n";
  }

  void write_coordinates(const std::size_t v)
  {
    const Point& p = m_domain.node(v);
    m_os << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  }

  // Triangles have their numbers, from 1; those of the tetrahedra go on from there. In version 2, there are no blocks.
  void write_elements(const bool is_version_2)
  {
    const std::size_t n = m_domain.triangles.size() + m_domain.tetrahedra.size();
    m_os << "$Elements\n";
    if(! is_version_2)
      m_os << m_entities.size() << ' ' << n << " 1 ";
    m_os << n << '\n';
    for(const Entity& entity : m_entities)
      write_elements(entity, entity.dimension == 2 ? 1 : m_domain.triangles.size() + 1, is_version_2);
    m_os << "$EndElements\n";
  }

  // In version 2, each element tells its type, its group and its entity.
  void write_elements(const Entity& entity, const std::size_t first_number, const bool is_version_2)
  {
    const int type = entity.dimension == 2 ? (m_domain.is_second_order() ? 9 : 2)
                                           : (m_domain.is_second_order() ? 11 : 4);
    if(! is_version_2)
      m_os << entity.dimension << ' ' << entity.tag << ' ' << type << ' ' << entity.simplices.size() << '\n';
    for(const std::size_t i : entity.simplices)
    {
      m_os << first_number + i;
      if(is_version_2)
        m_os << ' ' << type << " 2 " << entity.group << ' ' << entity.tag;
      for_each_node(entity.dimension, i, [&](const Point_number v) { m_os << ' ' << std::size_t(v) + 1; });
      m_os << '\n';
    }
  }

  // Data of all elements, in the order in which the elements come, as meshio wants it: first the regions, which Gmsh
  // shows; that of a triangle is the one beside it, the smaller one of two. Tetrahedra have no number in the input, -1.
  void write_data()
  {
    write_data("region", [&](const std::size_t i) { return std::int64_t(region_beside(m_sides[i])); },
               [&](const std::size_t i) { return std::int64_t(m_domain.regions[i]); });
    write_data("triangle", [&](const std::size_t i) { return static_cast<std::int64_t>(m_domain.triangle_numbers[i]); },
               [](const std::size_t) { return std::int64_t(-1); });
  }

  template <typename OfTriangle, typename OfTetrahedron>
  void write_data(const std::string& name, const OfTriangle& of_triangle, const OfTetrahedron& of_tetrahedron)
  {
    const std::size_t n = m_domain.triangles.size();
    m_os << "$ElementData\n1\n\"" << name << "\"\n1\n0\n3\n0\n1\n" << n + m_domain.tetrahedra.size() << '\n';
    for(const Entity& entity : m_entities)
      for(const std::size_t i : entity.simplices)
        if(entity.dimension == 2)
          m_os << i + 1 << ' ' << of_triangle(i) << '\n';
        else
          m_os << n + i + 1 << ' ' << of_tetrahedron(i) << '\n';
    m_os << "$EndElementData\n";
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_WRITE_GMSH_H

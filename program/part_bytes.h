#ifndef BOUNDARY_RECOVERY_3_PROGRAM_PART_BYTES_H
#define BOUNDARY_RECOVERY_3_PROGRAM_PART_BYTES_H

#include "byte_string.h"

#include <CGAL/Boundary_recovery_3/internal/parallel/Mesh_part_3.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <type_traits>
#include <vector>

// A part of a mesh as a string of bytes, and back.
template <typename Tr>
class Part_bytes
{
public:
  typedef CGAL::Boundary_recovery_3::internal::Mesh_part_3<Tr> Part;

  static Bytes from_part(const Part& part)
  {
    Arrays arrays;
    for(const auto& v : part.vertices)
    {
      arrays.numbers.push_back(v.number);
      for(int i = 0; i < 3; ++i)
        arrays.coordinates.push_back(v.point[i]);
      arrays.sizes.push_back(v.size);
      arrays.indices.push_back({{ v.indices.dimension, v.indices.index }});
      arrays.flags.push_back(v.may_be_shared);
    }
    for(std::size_t c = 0; c < part.number_of_cells(); ++c)
    {
      arrays.regions.push_back(part.cell_indices[c].subdomain);
      for(std::uint32_t i = 0; i < 4; ++i)
        if(part.cell_indices[c].patches[i] != 0)
          arrays.patches.push_back({ static_cast<std::uint32_t>(c), i, part.cell_indices[c].patches[i] });
    }
    Bytes bytes;
    Byte_writer writer(bytes);
    arrays.for_each([&](const auto& array) { writer.put(array); });
    writer.put(part.tetrahedra);
    writer.put(part.constrained_edges);
    return bytes;
  }

  // throws if these are not the bytes of a part
  static Part to_part(const Bytes& bytes)
  {
    Arrays arrays;
    Part part;
    Byte_reader reader(bytes);
    arrays.for_each([&](auto& array) { reader.get(array); });
    reader.get(part.tetrahedra);
    reader.get(part.constrained_edges);
    const std::size_t n = arrays.numbers.size();
    check(reader.is_at_end() && arrays.coordinates.size() == 3 * n && arrays.sizes.size() == n &&
          arrays.indices.size() == n && arrays.flags.size() == n && arrays.regions.size() == part.tetrahedra.size());
    check_positions(part.tetrahedra, n);
    check_positions(part.constrained_edges, n);
    add_vertices(arrays, part);
    add_indices(arrays, part);
    return part;
  }

private:
  typedef typename Tr::Geom_traits::FT FT;
  static_assert(std::is_same<FT, double>::value, "numbers are stored as doubles");

  // of a facet of a cell: most have none
  struct Patch
  {
    std::uint32_t cell, index;
    std::int32_t patch;
  };

  // what is stored of vertices and cells, in the order of the bytes
  struct Arrays
  {
    std::vector<std::uint64_t> numbers;
    std::vector<double> coordinates, sizes;
    std::vector<std::array<std::int32_t, 2> > indices;
    std::vector<char> flags;
    std::vector<std::int32_t> regions;
    std::vector<Patch> patches;

    template <typename F>
    void for_each(const F& f)
    {
      f(numbers);
      f(coordinates);
      f(sizes);
      f(indices);
      f(flags);
      f(regions);
      f(patches);
    }
  };

  static void check(const bool is_valid)
  {
    if(! is_valid)
      throw std::runtime_error("it is no part of a mesh");
  }

  template <typename Simplex>
  static void check_positions(const std::vector<Simplex>& simplices, const std::size_t number_of_vertices)
  {
    for(const Simplex& simplex : simplices)
      for(const std::uint32_t v : simplex)
        check(v < number_of_vertices);
  }

  static void add_vertices(const Arrays& arrays, Part& part)
  {
    typename Tr::Vertex vertex;
    part.vertices.reserve(arrays.numbers.size());
    for(std::size_t v = 0; v < arrays.numbers.size(); ++v)
    {
      const double* const p = arrays.coordinates.data() + 3 * v;
      vertex.set_point(typename Tr::Point(p[0], p[1], p[2]));
      vertex.set_dimension(arrays.indices[v][0]);
      vertex.set_index(arrays.indices[v][1]);
      vertex.set_meshing_info(arrays.sizes[v]);
      part.vertices.emplace_back(arrays.numbers[v], vertex);
      part.vertices.back().may_be_shared = arrays.flags[v] != 0;
    }
  }

  static void add_indices(const Arrays& arrays, Part& part)
  {
    const typename Tr::Cell cell;
    part.cell_indices.assign(arrays.regions.size(), typename Part::Cell_indices(cell));
    for(std::size_t c = 0; c < arrays.regions.size(); ++c)
      part.cell_indices[c].subdomain = arrays.regions[c];
    for(const Patch& patch : arrays.patches)
    {
      check(patch.cell < arrays.regions.size() && patch.index < 4);
      part.cell_indices[patch.cell].patches[patch.index] = patch.patch;
    }
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_PART_BYTES_H

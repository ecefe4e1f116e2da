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
    std::vector<std::uint64_t> numbers;
    std::vector<double> coordinates, sizes;
    std::vector<std::array<std::int32_t, 2> > indices;
    std::vector<char> flags;
    for(const auto& v : part.vertices)
    {
      numbers.push_back(v.number);
      for(int i = 0; i < 3; ++i)
        coordinates.push_back(v.point[i]);
      sizes.push_back(v.size);
      indices.push_back({{ v.indices.dimension, v.indices.index }});
      flags.push_back(v.may_be_shared);
    }
    std::vector<std::int32_t> regions;
    std::vector<Patch> patches;
    for(std::size_t c = 0; c < part.number_of_cells(); ++c)
    {
      regions.push_back(part.cell_indices[c].subdomain);
      for(std::uint32_t i = 0; i < 4; ++i)
        if(part.cell_indices[c].patches[i] != 0)
          patches.push_back({ static_cast<std::uint32_t>(c), i, part.cell_indices[c].patches[i] });
    }
    Bytes bytes;
    Byte_writer writer(bytes);
    writer.put(numbers);
    writer.put(coordinates);
    writer.put(sizes);
    writer.put(indices);
    writer.put(flags);
    writer.put(part.tetrahedra);
    writer.put(regions);
    writer.put(patches);
    writer.put(part.constrained_edges);
    return bytes;
  }

  // throws if these are not the bytes of a part
  static Part to_part(const Bytes& bytes)
  {
    std::vector<std::uint64_t> numbers;
    std::vector<double> coordinates, sizes;
    std::vector<std::array<std::int32_t, 2> > indices;
    std::vector<char> flags;
    std::vector<std::int32_t> regions;
    std::vector<Patch> patches;
    Part part;
    Byte_reader reader(bytes);
    reader.get(numbers);
    reader.get(coordinates);
    reader.get(sizes);
    reader.get(indices);
    reader.get(flags);
    reader.get(part.tetrahedra);
    reader.get(regions);
    reader.get(patches);
    reader.get(part.constrained_edges);
    const std::size_t n = numbers.size();
    check(reader.is_at_end() && coordinates.size() == 3 * n && sizes.size() == n && indices.size() == n &&
          flags.size() == n && regions.size() == part.tetrahedra.size());
    check_positions(part.tetrahedra, n);
    check_positions(part.constrained_edges, n);
    add_vertices(numbers, coordinates, sizes, indices, flags, part);
    add_indices(regions, patches, part);
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

  static void add_vertices(const std::vector<std::uint64_t>& numbers, const std::vector<double>& coordinates,
                           const std::vector<double>& sizes, const std::vector<std::array<std::int32_t, 2> >& indices,
                           const std::vector<char>& flags, Part& part)
  {
    typename Tr::Vertex vertex;
    part.vertices.reserve(numbers.size());
    for(std::size_t v = 0; v < numbers.size(); ++v)
    {
      vertex.set_point(typename Tr::Point(coordinates[3 * v], coordinates[3 * v + 1], coordinates[3 * v + 2]));
      vertex.set_dimension(indices[v][0]);
      vertex.set_index(indices[v][1]);
      vertex.set_meshing_info(sizes[v]);
      part.vertices.emplace_back(numbers[v], vertex);
      part.vertices.back().may_be_shared = flags[v] != 0;
    }
  }

  static void add_indices(const std::vector<std::int32_t>& regions, const std::vector<Patch>& patches, Part& part)
  {
    const typename Tr::Cell cell;
    part.cell_indices.assign(regions.size(), typename Part::Cell_indices(cell));
    for(std::size_t c = 0; c < regions.size(); ++c)
      part.cell_indices[c].subdomain = regions[c];
    for(const Patch& patch : patches)
    {
      check(patch.cell < regions.size() && patch.index < 4);
      part.cell_indices[patch.cell].patches[patch.index] = patch.patch;
    }
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_PART_BYTES_H

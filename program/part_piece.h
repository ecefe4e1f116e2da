#ifndef BOUNDARY_RECOVERY_3_PROGRAM_PART_PIECE_H
#define BOUNDARY_RECOVERY_3_PROGRAM_PART_PIECE_H

#include "domain.h"
#include "domain_sides.h"
#include "surface.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <stdexcept>
#include <vector>

// Makes of the parts of a mesh what is written to files. The numbers of the surface's points are those in the whole
// mesh, too; the others follow, with gaps.
template <typename Part, typename Point>
class Part_pieces
{
  const Surface<Point>& m_surface;
  const std::vector<Sides>& m_sides; // of its triangles

public:
  Part_pieces(const Surface<Point>& surface, const std::vector<Sides>& sides) : m_surface(surface), m_sides(sides) { }

  // A part as a piece of the whole, and the number of each of its points there. A triangle between two pieces is in one
  // of them; those that bound nothing are in the first piece.
  Domain<Point> piece(const Part& part, const bool is_first, std::vector<std::uint64_t>& numbers) const
  {
    Domain<Point> piece;
    piece.patch_names = m_surface.patch_names;
    numbers.clear();
    for(const auto& v : part.vertices)
    {
      piece.points.push_back(v.point);
      numbers.push_back(v.number);
    }
    for(std::size_t c = 0; c < part.number_of_cells(); ++c)
    {
      const auto& indices = part.cell_indices[c];
      piece.tetrahedra.push_back(part.tetrahedra[c]);
      piece.regions.push_back(indices.subdomain);
      piece.number_of_regions = (std::max)(piece.number_of_regions, indices.subdomain);
      for(std::size_t i = 0; i < 4; ++i)
        if(indices.patches[i] != 0)
          add_triangle(part, c, i, piece);
    }
    if(is_first)
      add_triangles_of_nothing(piece, numbers);
    return piece;
  }

  // the surface, to which parts can be added
  Domain<Point> surface() const
  {
    Domain<Point> whole;
    whole.points = m_surface.points;
    whole.patch_names = m_surface.patch_names;
    for(std::size_t f = 0; f < m_surface.faces.size(); ++f)
    {
      whole.triangles.push_back(triangle(f));
      add_numbers(f, whole);
      whole.number_of_regions = (std::max)(whole.number_of_regions, m_sides[f][1]);
    }
    return whole;
  }

  // `positions` has for each number in the whole mesh the position of its point in `whole`, or is too short
  void add_to(Domain<Point>& whole, std::vector<Point_number>& positions, const Part& part) const
  {
    constexpr Point_number none = (std::numeric_limits<Point_number>::max)();
    std::vector<std::size_t> order(part.vertices.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](const std::size_t u, const std::size_t v)
                     { return part.vertices[u].indices.index < part.vertices[v].indices.index; }); // by regions
    std::vector<Point_number> local(part.vertices.size());
    for(const std::size_t k : order)
    {
      const auto& v = part.vertices[k];
      while(positions.size() <= v.number)
        positions.push_back(positions.size() < m_surface.points.size() ? static_cast<Point_number>(positions.size())
                                                                       : none);
      Point_number& position = positions[v.number];
      if(position == none)
      {
        if(whole.points.size() >= none)
          throw std::length_error("the mesh has too many vertices to be merged");
        position = static_cast<Point_number>(whole.points.size());
        whole.points.push_back(v.point);
        ++whole.number_of_field_points;
      }
      local[k] = position;
    }
    for(std::size_t c = 0; c < part.number_of_cells(); ++c)
    {
      const auto& t = part.tetrahedra[c];
      whole.tetrahedra.push_back({{ local[t[0]], local[t[1]], local[t[2]], local[t[3]] }});
      whole.regions.push_back(part.cell_indices[c].subdomain);
    }
  }

private:
  std::array<Point_number, 3> triangle(const std::size_t face) const
  {
    const auto& f = m_surface.faces[face];
    return {{ static_cast<Point_number>(f[0]), static_cast<Point_number>(f[1]), static_cast<Point_number>(f[2]) }};
  }

  void add_numbers(const std::size_t face, Domain<Point>& domain) const
  {
    domain.triangle_numbers.push_back(m_surface.face_number(face));
    domain.patches.push_back(m_surface.patches[face]);
  }

  // It is that of the cell that has the region with the smaller number; if both have the same, of that in front.
  void add_triangle(const Part& part, const std::size_t cell, const std::size_t index, Domain<Point>& piece) const
  {
    const auto& t = part.tetrahedra[cell];
    const std::size_t face = static_cast<std::size_t>(part.cell_indices[cell].patches[index]) - 1;
    const Sides& sides = m_sides[face];
    const std::array<Point_number, 3> expected = triangle(face);
    std::array<Point_number, 3> corners = {{ 0, 0, 0 }};
    for(std::size_t k = 0; k < 3; ++k)
      for(std::size_t i = 0; i < 4; ++i)
        if(part.vertices[t[i]].number == expected[k])
          corners[k] = t[i];
    const int region = region_beside(sides);
    if(sides[0] == sides[1] ? ! is_in_front(t, index, corners) : part.cell_indices[cell].subdomain != region)
      return;
    piece.triangles.push_back(corners);
    add_numbers(face, piece);
  }

  static bool is_in_front(const std::array<std::uint32_t, 4>& t, const std::size_t index,
                          const std::array<Point_number, 3>& corners)
  {
    static constexpr std::size_t front[4][3] = { { 1, 3, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 0, 1, 2 } };
    const auto& facet = front[index];
    std::size_t first = 0;
    while(t[facet[first]] != corners[0])
      ++first;
    return t[facet[(first + 1) % 3]] == corners[1];
  }

  void add_triangles_of_nothing(Domain<Point>& piece, std::vector<std::uint64_t>& numbers) const
  {
    std::map<std::uint64_t, Point_number> positions; // filled when there is such a triangle
    for(std::size_t f = 0; f < m_sides.size(); ++f)
    {
      if(m_sides[f][1] != 0) // the larger one
        continue;
      if(positions.empty())
        for(std::size_t k = 0; k < numbers.size(); ++k)
          positions.emplace(numbers[k], static_cast<Point_number>(k));
      std::array<Point_number, 3> corners = triangle(f);
      for(Point_number& v : corners)
      {
        const auto [found, is_new] = positions.try_emplace(v, static_cast<Point_number>(numbers.size()));
        if(is_new)
        {
          numbers.push_back(v);
          piece.points.push_back(m_surface.points[v]);
        }
        v = found->second;
      }
      piece.triangles.push_back(corners);
      add_numbers(f, piece);
    }
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_PART_PIECE_H

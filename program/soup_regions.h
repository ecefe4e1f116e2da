#ifndef BOUNDARY_RECOVERY_3_PROGRAM_SOUP_REGIONS_H
#define BOUNDARY_RECOVERY_3_PROGRAM_SOUP_REGIONS_H

#include "surface.h"
#include "triangle_soup.h"

#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Unique_hash_map.h>
#include <CGAL/recover_boundary.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

// A triangle of a soup, and the regions beside it: first the one into which its normal points.
struct Region_wall
{
  std::size_t triangle;
  std::array<std::size_t, 2> regions;
  double area;

  bool separates() const { return regions[0] != regions[1]; }
};

// The regions into which a soup without intersections divides space, those that do not count as inside, too: the soup
// is recovered in a triangulation, and the cells between its triangles are a region. Region 0 is around all of it.
template <typename Point>
class Soup_regions
{
  typedef typename CGAL::Kernel_traits<Point>::Kernel                            Kernel;
  typedef typename CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type Triangulation;
  typedef typename Triangulation::Cell_handle                                    Cell_handle;
  typedef typename Triangulation::Facet                                          Facet;

  static constexpr std::size_t no_region = std::size_t(-1);

  Triangulation m_tr;
  CGAL::Unique_hash_map<Cell_handle, unsigned char> m_walls_of_cell; // bit i: facet i is a wall
  CGAL::Unique_hash_map<Cell_handle, std::size_t> m_region;
  std::vector<double> m_volumes;
  std::vector<Region_wall> m_walls;

public:
  explicit Soup_regions(const Triangle_soup<Point>& soup) : m_walls_of_cell(0), m_region(no_region)
  {
    const Surface<Point> surface = make_surface(soup.points, soup.triangles); // points that are not used may be on it
    const auto result = CGAL::recover_boundary(m_tr, surface.points, surface.faces);
    if(! result || m_tr.dimension() < 3)
      return;
    const auto triangles = result.surface_facets();
    for(const auto& t : triangles)
      mark_wall(facet_of(t));
    fill(m_tr.infinite_cell());
    for(const Cell_handle c : m_tr.all_cell_handles())
      if(m_region[c] == no_region)
        fill(c);
    for(const auto& t : triangles)
      add_wall(t, t.index);
  }

  // of each region but the first one, which has no end; empty if the soup could not be recovered
  const std::vector<double>& volumes() const { return m_volumes; }

  // one for each triangle, in their order
  const std::vector<Region_wall>& walls() const { return m_walls; }

private:
  // the facet of a triangle, seen from the cell into which its normal points
  template <typename Triple>
  Facet facet_of(const Triple& t) const
  {
    Cell_handle c;
    int i = 0, j = 0, k = 0; // it is a facet
    m_tr.is_facet(t[0], t[1], t[2], c, i, j, k);
    const Facet facet(c, 6 - i - j - k);
    const int first = c->index(t[0]);
    for(int n = 0; n < 3; ++n)
      if(Triangulation::vertex_triple_index(facet.second, n) == first)
        return c->vertex(Triangulation::vertex_triple_index(facet.second, (n + 1) % 3)) == t[1]
             ? facet : m_tr.mirror_facet(facet);
    return facet;
  }

  void mark_wall(const Facet& facet)
  {
    for(const Facet& f : { facet, m_tr.mirror_facet(facet) })
      m_walls_of_cell[f.first] = static_cast<unsigned char>(m_walls_of_cell[f.first] | 1 << f.second);
  }

  // a new region
  void fill(const Cell_handle seed)
  {
    std::vector<Cell_handle> stack(1, seed);
    m_region[seed] = m_volumes.size();
    m_volumes.push_back(0);
    while(! stack.empty())
    {
      const Cell_handle c = stack.back();
      stack.pop_back();
      if(! m_tr.is_infinite(c))
        m_volumes.back() += m_tr.tetrahedron(c).volume();
      for(int i = 0; i < 4; ++i)
        if((m_walls_of_cell[c] >> i & 1) == 0 && m_region[c->neighbor(i)] == no_region)
        {
          m_region[c->neighbor(i)] = m_region[c];
          stack.push_back(c->neighbor(i));
        }
    }
  }

  template <typename Triple>
  void add_wall(const Triple& t, const std::size_t index)
  {
    const Facet front = facet_of(t);
    m_walls.push_back(Region_wall{ index, {{ m_region[front.first], m_region[front.first->neighbor(front.second)] }},
                                   std::sqrt(m_tr.triangle(front).squared_area()) });
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_SOUP_REGIONS_H

#ifndef BOUNDARY_RECOVERY_3_PROGRAM_WRITE_DOMAIN_H
#define BOUNDARY_RECOVERY_3_PROGRAM_WRITE_DOMAIN_H

#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>
#include <CGAL/Boundary_recovery_3/label_regions.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/Unique_hash_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <ostream>
#include <string>
#include <vector>

// The tetrahedra of the domain as a soup: what is written to files.
template <typename Point>
struct Domain
{
  std::vector<Point> points;                            // input vertices in their order, then Steiner points
  std::vector<std::array<std::size_t, 4> > tetrahedra;
  std::vector<int> regions;                             // of each tetrahedron
  std::vector<std::array<std::size_t, 3> > triangles;   // the input faces that are in the triangulation, or their parts
  std::vector<std::size_t> patches;                     // of each triangle: the number of its face in the file, from 1
  int number_of_regions = 0;
  std::size_t number_of_steiner_points = 0; // those at tetrahedra of the domain
  bool is_convex_hull = false; // no region can be told from the outside: all tetrahedra are here, as region 1
};

// Collects the domain from a triangulation after its boundary was recovered.
template <typename Tr>
class Domain_builder
{
  typedef typename Tr::Vertex_handle      Vertex_handle;
  typedef typename Tr::Cell_handle        Cell_handle;
  typedef typename Tr::Point              Point;
  typedef CGAL::Unique_hash_map<Cell_handle, int> Region_map;

  const Tr& m_tr;
  Domain<Point> m_domain;
  std::vector<CGAL::Boundary_recovery_3::Surface_facet_3<Vertex_handle> > m_facets;

public:
  explicit Domain_builder(const Tr& tr) : m_tr(tr) { }

  template <typename Result>
  Domain<Point> operator()(const Result& result, const bool keep_exterior)
  {
    m_facets = result.surface_facets();
    Region_map region(0);
    m_domain.number_of_regions =
      CGAL::Boundary_recovery_3::label_regions(m_tr, m_facets, boost::associative_property_map<Region_map>(region));
    if(m_domain.number_of_regions == 0 || (! result.missing_facets.empty() && has_leak(region)))
    {
      m_domain.number_of_regions = 0;
      m_domain.is_convex_hull = true;
    }

    std::vector<Cell_handle> cells;
    for(const Cell_handle c : m_tr.finite_cell_handles())
    {
      const int r = m_domain.is_convex_hull ? 1 : region[c];
      if(r == 0 && ! keep_exterior)
        continue;
      cells.push_back(c);
      m_domain.regions.push_back(r);
    }
    add_simplices(cells, result);
    count_steiner_points(cells, result);
    return m_domain;
  }

private:
  // Where a facet is missing the outside may flow in, and what is left as regions are a few bubbles: then a facet
  // beside the gap has the outside on both sides.
  bool has_leak(const Region_map& region) const
  {
    const auto is_outside = [&](const Cell_handle c) { return m_tr.is_infinite(c) || region[c] == 0; };
    for(const auto& facet : m_facets)
    {
      Cell_handle c;
      int i, j, k;
      if(m_tr.is_facet(facet[0], facet[1], facet[2], c, i, j, k) &&
         is_outside(c) && is_outside(c->neighbor(6 - i - j - k)))
        return true;
    }
    return false;
  }

  // those that only tetrahedra outside the domain have do not count
  template <typename Result>
  void count_steiner_points(const std::vector<Cell_handle>& cells, const Result& result)
  {
    CGAL::Unique_hash_map<Vertex_handle, bool> is_in_domain(false);
    for(std::size_t i = 0; i < cells.size(); ++i)
      for(int j = 0; j < 4; ++j)
        if(m_domain.regions[i] != 0)
          is_in_domain[cells[i]->vertex(j)] = true;
    m_domain.number_of_steiner_points = static_cast<std::size_t>(
      std::count_if(result.steiner_vertices.begin(), result.steiner_vertices.end(),
                    [&](const Vertex_handle v) { return is_in_domain[v]; }));
  }

  // numbers the vertices and appends the tetrahedra of the cells and the triangles of the facets
  template <typename Result>
  void add_simplices(const std::vector<Cell_handle>& cells, const Result& result)
  {
    const std::size_t unused = std::size_t(-1), used = std::size_t(-2);
    CGAL::Unique_hash_map<Vertex_handle, std::size_t> number(unused);
    for(const Cell_handle c : cells)
      for(int i = 0; i < 4; ++i)
        number[c->vertex(i)] = used;
    for(const auto& facet : m_facets)
      for(const Vertex_handle v : facet)
        number[v] = used;

    const auto add_vertex = [&](const Vertex_handle v)
    {
      if(number[v] != used)
        return;
      number[v] = m_domain.points.size();
      m_domain.points.push_back(v->point());
    };
    for(const Vertex_handle v : result.vertices)
      add_vertex(v);
    for(const Vertex_handle v : result.steiner_vertices)
      add_vertex(v);

    for(const Cell_handle c : cells)
      m_domain.tetrahedra.push_back({{ number[c->vertex(0)], number[c->vertex(1)],
                                       number[c->vertex(2)], number[c->vertex(3)] }});
    for(const auto& facet : m_facets)
    {
      m_domain.triangles.push_back({{ number[facet[0]], number[facet[1]], number[facet[2]] }});
      m_domain.patches.push_back(facet.index + 1);
    }
  }
};

// the smallest and the largest dihedral angle of the tetrahedra, in degrees; 0 and 0 if there is none
template <typename Point>
std::array<double, 2> range_of_dihedral_angles(const Domain<Point>& domain)
{
  double low = 180, high = 0;
  for(const auto& t : domain.tetrahedra)
    for(int i = 0; i < 4; ++i)
      for(int j = i + 1; j < 4; ++j)
      {
        const int k = (i == 0) ? (j == 1 ? 2 : 1) : 0, l = 6 - i - j - k;
        const double angle = std::abs(CGAL::approximate_dihedral_angle(domain.points[t[i]], domain.points[t[j]],
                                                                       domain.points[t[k]], domain.points[t[l]]));
        low = (std::min)(low, angle);
        high = (std::max)(high, angle);
      }
  return {{ (std::min)(low, high), high }};
}

// writes the tetrahedra and the triangles in MEDIT's ASCII format
template <typename Point>
void write_mesh(std::ostream& os, const Domain<Point>& domain)
{
  os << "MeshVersionFormatted 2\nDimension 3\nVertices\n" << domain.points.size() << '\n';
  for(const Point& p : domain.points)
    os << p << " 0\n";
  os << "Triangles\n" << domain.triangles.size() << '\n';
  for(std::size_t i = 0; i < domain.triangles.size(); ++i)
  {
    for(const std::size_t v : domain.triangles[i])
      os << v + 1 << ' ';
    os << domain.patches[i] << '\n';
  }
  os << "Tetrahedra\n" << domain.tetrahedra.size() << '\n';
  for(std::size_t i = 0; i < domain.tetrahedra.size(); ++i)
  {
    for(const std::size_t v : domain.tetrahedra[i])
      os << v + 1 << ' ';
    os << domain.regions[i] << '\n';
  }
  os << "End\n";
}

// writes the tetrahedra with their regions in VTK's legacy ASCII format
template <typename Point>
void write_vtk(std::ostream& os, const Domain<Point>& domain)
{
  const std::size_t n = domain.tetrahedra.size();
  os << "# vtk DataFile Version 3.0\nboundary recovery\nASCII\nDATASET UNSTRUCTURED_GRID\n"
     << "POINTS " << domain.points.size() << " double\n";
  for(const Point& p : domain.points)
    os << p << '\n';
  os << "CELLS " << n << ' ' << 5 * n << '\n';
  for(const auto& t : domain.tetrahedra)
    os << "4 " << t[0] << ' ' << t[1] << ' ' << t[2] << ' ' << t[3] << '\n';
  os << "CELL_TYPES " << n << '\n';
  for(std::size_t i = 0; i < n; ++i)
    os << "10\n";
  os << "CELL_DATA " << n << "\nSCALARS region int 1\nLOOKUP_TABLE default\n";
  for(const int region : domain.regions)
    os << region << '\n';
}

// writes the tetrahedra with their regions in VTK's XML format, as text
template <typename Point>
void write_vtu(std::ostream& os, const Domain<Point>& domain)
{
  const std::size_t n = domain.tetrahedra.size();
  os << "<?xml version=\"1.0\"?>\n"
     << "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n"
     << "<Piece NumberOfPoints=\"" << domain.points.size() << "\" NumberOfCells=\"" << n << "\">\n"
     << "<CellData Scalars=\"region\">\n<DataArray type=\"Int32\" Name=\"region\" format=\"ascii\">\n";
  for(const int region : domain.regions)
    os << region << '\n';
  os << "</DataArray>\n</CellData>\n"
     << "<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n";
  for(const Point& p : domain.points)
    os << p << '\n';
  os << "</DataArray>\n</Points>\n<Cells>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n";
  for(const auto& t : domain.tetrahedra)
    os << t[0] << ' ' << t[1] << ' ' << t[2] << ' ' << t[3] << '\n';
  os << "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n";
  for(std::size_t i = 1; i <= n; ++i)
    os << 4 * i << '\n';
  os << "</DataArray>\n<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">\n";
  for(std::size_t i = 0; i < n; ++i)
    os << "10\n";
  os << "</DataArray>\n</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

// writes the domain in the format that the extension names; returns `false` if that fails
template <typename Point>
bool write_domain(const std::string& file, const std::string& extension, const Domain<Point>& domain)
{
  std::ofstream os(file);
  os.precision(17); // enough to read the same numbers back
  if(extension == ".mesh")
    write_mesh(os, domain);
  else if(extension == ".vtu")
    write_vtu(os, domain);
  else
    write_vtk(os, domain);
  os.close();
  return ! os.fail();
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_WRITE_DOMAIN_H

#ifndef BOUNDARY_RECOVERY_3_PROGRAM_WRITE_VTK_H
#define BOUNDARY_RECOVERY_3_PROGRAM_WRITE_VTK_H

#include "domain.h"
#include "domain_sides.h"
#include "output_buffer.h"
#include "second_order.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

// what a cell is: VTK's number of its type, and its data
struct Vtk_cell
{
  int type, region, patch;
  std::int64_t triangle; // its number in the input
};

// VTK's files have the tetrahedra, and after them the triangles of the surface as cells of their own. A triangle has
// the region of the tetrahedron beside it, the smaller one of two. Tetrahedra have patch 0, and as number of a triangle
// -1, as triangles have that are not from the file.
template <typename Point>
class Vtk_cells
{
  const Domain<Point>& m_domain;
  std::vector<Sides> m_sides;

public:
  explicit Vtk_cells(const Domain<Point>& domain) : m_domain(domain), m_sides(find_sides(domain)) { }

  std::size_t size() const { return m_domain.tetrahedra.size() + m_domain.triangles.size(); }

  std::size_t number_of_vertices() const
  {
    const bool is_second_order = m_domain.is_second_order();
    return (is_second_order ? 10 : 4) * m_domain.tetrahedra.size() +
           (is_second_order ? 6 : 3) * m_domain.triangles.size();
  }

  // calls the function for each cell: with its vertices, and what it is
  template <typename F>
  void for_each(const F& f) const
  {
    const bool is_second_order = m_domain.is_second_order();
    for(std::size_t i = 0; i < m_domain.tetrahedra.size(); ++i)
    {
      const Vtk_cell cell{ is_second_order ? 24 : 10, m_domain.regions[i], 0, -1 };
      with_nodes(m_domain.tetrahedra, m_domain.edges_of_tetrahedra, i, [&](const auto& nodes) { f(nodes, cell); });
    }
    for(std::size_t i = 0; i < m_domain.triangles.size(); ++i)
    {
      const Vtk_cell cell{ is_second_order ? 22 : 5, region_beside(m_sides[i]), m_domain.patches[i],
                           static_cast<std::int64_t>(m_domain.triangle_numbers[i]) }; // or -1
      with_nodes(m_domain.triangles, m_domain.edges_of_triangles, i, [&](const auto& nodes) { f(nodes, cell); });
    }
  }
};

// what VTK's text format has in the place of a name: no blank ends it
inline std::string encoded_vtk_name(const std::string& name)
{
  static const char* const digits = "0123456789ABCDEF";
  std::string result;
  for(const char c : name)
  {
    const unsigned char byte = static_cast<unsigned char>(c);
    if(byte > ' ' && byte < 127 && c != '%' && c != '"')
      result += c;
    else
      (result += '%') += { digits[byte / 16], digits[byte % 16] };
  }
  return result;
}

// The names of patches and regions as field data: an array for each name, with the number and the dimension of each
// patch and region that has it, as meshio tells physical groups. Arrays of strings, which VTK knows, it would refuse.
template <typename Point>
std::map<std::string, std::vector<std::array<int, 2> > > vtk_names(const Domain<Point>& domain)
{
  std::map<std::string, std::vector<std::array<int, 2> > > result;
  for(const auto& [number, name] : domain.patch_names)
    result[name].push_back({{ number, 2 }});
  for(const auto& [number, name] : domain.region_names)
    result[name].push_back({{ number, 3 }});
  return result;
}

template <typename Point>
void write_vtk_names(Output_buffer& os, const Domain<Point>& domain)
{
  const auto names = vtk_names(domain);
  if(names.empty())
    return;
  os << "FIELD FieldData " << names.size() << '\n';
  for(const auto& [name, values] : names)
  {
    os << encoded_vtk_name(name) << " 2 " << values.size() << " int\n";
    for(const auto& [number, dimension] : values)
      os << number << ' ' << dimension << '\n';
  }
}

// writes VTK's legacy text format
template <typename Point>
void write_vtk(Output_buffer& os, const Domain<Point>& domain)
{
  const Vtk_cells<Point> cells(domain);
  os << "# vtk DataFile Version 3.0\nBoundary_recovery_3\nASCII\nDATASET UNSTRUCTURED_GRID\n";
  write_vtk_names(os, domain);
  os << "POINTS " << domain.number_of_nodes() << " double\n";
  for(std::size_t v = 0; v < domain.number_of_nodes(); ++v)
    os << domain.node(v).x() << ' ' << domain.node(v).y() << ' ' << domain.node(v).z() << '\n';
  os << "CELLS " << cells.size() << ' ' << cells.size() + cells.number_of_vertices() << '\n';
  cells.for_each([&](const auto& vertices, const Vtk_cell&)
  {
    os << vertices.size();
    for(const Point_number v : vertices)
      os << ' ' << v;
    os << '\n';
  });
  os << "CELL_TYPES " << cells.size() << '\n';
  cells.for_each([&](const auto&, const Vtk_cell& cell) { os << cell.type << '\n'; });
  os << "CELL_DATA " << cells.size() << "\nSCALARS region int 1\nLOOKUP_TABLE default\n";
  cells.for_each([&](const auto&, const Vtk_cell& cell) { os << cell.region << '\n'; });
  os << "FIELD FieldData 2\npatch 1 " << cells.size() << " int\n"; // of several scalars, VTK reads the first one only
  cells.for_each([&](const auto&, const Vtk_cell& cell) { os << cell.patch << '\n'; });
  os << "triangle 1 " << cells.size() << " long\n";
  cells.for_each([&](const auto&, const Vtk_cell& cell) { os << cell.triangle << '\n'; });
}

// What a piece of a mesh tells besides: its number, from 1, and for each point the number in the whole mesh.
struct Vtu_piece
{
  int part = 0;
  std::vector<std::uint64_t> numbers;
};

inline const char* vtk_byte_order()
{
  const std::uint16_t one = 1;
  return *reinterpret_cast<const unsigned char*>(&one) == 1 ? "LittleEndian" : "BigEndian";
}

// a name as the value of an attribute
inline std::string xml_text(const std::string& text)
{
  std::string result;
  for(const char c : text)
    switch(c)
    {
      case '&':  result += "&amp;"; break;
      case '<':  result += "&lt;"; break;
      case '"':  result += "&quot;"; break;
      default:   result += c;
    }
  return result;
}

// Writes VTK's XML format: the numbers are raw bytes at the end of the file.
template <typename Point>
class Vtu_writer
{
  typedef std::uint64_t Length; // stands before the bytes of each array

  Output_buffer& m_os;
  const Domain<Point>& m_domain;
  Vtk_cells<Point> m_cells;
  const Vtu_piece* m_piece; // null: it is the whole mesh
  Length m_offset = 0;

public:
  Vtu_writer(Output_buffer& os, const Domain<Point>& domain, const Vtu_piece* piece = nullptr)
    : m_os(os), m_domain(domain), m_cells(domain), m_piece(piece)
  { }

  void operator()()
  {
    m_os << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\""
         << vtk_byte_order() << "\" header_type=\"UInt64\">\n<UnstructuredGrid>\n";
    write_names();
    m_os << "<Piece NumberOfPoints=\"" << m_domain.number_of_nodes() << "\" NumberOfCells=\"" << m_cells.size()
         << "\">\n";
    announce_numbers();
    m_os << "<CellData Scalars=\"region\">\n";
    announce("Int32", "region", 4 * m_cells.size());
    announce("Int32", "patch", 4 * m_cells.size());
    announce("Int64", "triangle", 8 * m_cells.size());
    if(m_piece != nullptr)
      announce("Int32", "part", 4 * m_cells.size());
    m_os << "</CellData>\n<Points>\n";
    announce("Float64", "Points", 24 * m_domain.number_of_nodes(), 3);
    m_os << "</Points>\n<Cells>\n";
    announce("Int64", "connectivity", 8 * m_cells.number_of_vertices());
    announce("Int64", "offsets", 8 * m_cells.size());
    announce("UInt8", "types", m_cells.size());
    m_os << "</Cells>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
    write_numbers();
    write_cell_data();
    write_points();
    write_cells();
    m_os << "\n</AppendedData>\n</VTKFile>\n";
  }

private:
  void announce(const std::string& type, const std::string& name, const Length length, const int components = 1)
  {
    m_os << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" NumberOfComponents=\"" << components
         << "\" format=\"appended\" offset=\"" << m_offset << "\"/>\n";
    m_offset += sizeof(Length) + length;
  }

  void announce_numbers()
  {
    if(m_piece == nullptr)
      return;
    m_os << "<PointData GlobalIds=\"global_id\">\n";
    announce("Int64", "global_id", 8 * m_domain.points.size());
    m_os << "</PointData>\n";
  }

  void write_numbers()
  {
    if(m_piece == nullptr)
      return;
    m_os.put_bytes(Length(8 * m_domain.points.size()));
    for(const std::uint64_t number : m_piece->numbers)
      m_os.put_bytes(std::int64_t(number));
  }

  void write_names()
  {
    const auto names = vtk_names(m_domain);
    if(names.empty())
      return;
    m_os << "<FieldData>\n";
    for(const auto& [name, values] : names)
    {
      m_os << "<DataArray type=\"Int32\" Name=\"" << xml_text(name) << "\" NumberOfComponents=\"2\" NumberOfTuples=\""
           << values.size() << "\" format=\"ascii\">\n";
      for(const auto& [number, dimension] : values)
        m_os << number << ' ' << dimension << '\n';
      m_os << "</DataArray>\n";
    }
    m_os << "</FieldData>\n";
  }

  void write_cell_data()
  {
    write_cell_array([](const Vtk_cell& cell) { return std::int32_t(cell.region); });
    write_cell_array([](const Vtk_cell& cell) { return std::int32_t(cell.patch); });
    write_cell_array([](const Vtk_cell& cell) { return cell.triangle; });
    if(m_piece != nullptr)
      write_cell_array([&](const Vtk_cell&) { return std::int32_t(m_piece->part); });
  }

  // a number for each cell
  template <typename Value>
  void write_cell_array(const Value& value)
  {
    m_os.put_bytes(Length(sizeof(value(Vtk_cell())) * m_cells.size()));
    m_cells.for_each([&](const auto&, const Vtk_cell& cell) { m_os.put_bytes(value(cell)); });
  }

  void write_points()
  {
    m_os.put_bytes(Length(24 * m_domain.number_of_nodes()));
    for(std::size_t v = 0; v < m_domain.number_of_nodes(); ++v)
      for(int i = 0; i < 3; ++i)
        m_os.put_bytes(double(m_domain.node(v)[i]));
  }

  void write_cells()
  {
    m_os.put_bytes(Length(8 * m_cells.number_of_vertices()));
    m_cells.for_each([&](const auto& vertices, const Vtk_cell&)
    {
      for(const Point_number v : vertices)
        m_os.put_bytes(std::int64_t(v));
    });
    std::int64_t end = 0;
    m_os.put_bytes(Length(8 * m_cells.size()));
    m_cells.for_each([&](const auto& vertices, const Vtk_cell&)
    {
      end += static_cast<std::int64_t>(vertices.size());
      m_os.put_bytes(end);
    });
    write_cell_array([](const Vtk_cell& cell) { return std::uint8_t(cell.type); });
  }
};

// writes what ParaView opens: the names of the pieces, which are beside the file, and what they have
inline void write_pvtu(Output_buffer& os, const std::vector<std::string>& pieces)
{
  os << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\" byte_order=\"" << vtk_byte_order()
     << "\" header_type=\"UInt64\">\n<PUnstructuredGrid GhostLevel=\"0\">\n"
     << "<PPointData GlobalIds=\"global_id\">\n<PDataArray type=\"Int64\" Name=\"global_id\"/>\n</PPointData>\n"
     << "<PCellData Scalars=\"region\">\n<PDataArray type=\"Int32\" Name=\"region\"/>\n"
     << "<PDataArray type=\"Int32\" Name=\"patch\"/>\n<PDataArray type=\"Int64\" Name=\"triangle\"/>\n"
     << "<PDataArray type=\"Int32\" Name=\"part\"/>\n</PCellData>\n"
     << "<PPoints>\n<PDataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"/>\n</PPoints>\n";
  for(const std::string& piece : pieces)
    os << "<Piece Source=\"" << xml_text(piece) << "\"/>\n";
  os << "</PUnstructuredGrid>\n</VTKFile>\n";
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_WRITE_VTK_H

// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_BACKGROUND_MESH_3_H
#define CGAL_BOUNDARY_RECOVERY_3_BACKGROUND_MESH_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <fstream>
#include <istream>
#include <limits>
#include <locale>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3 {

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief a tetrahedral mesh with sizes at its vertices, as arrays.
 *
 * \tparam GT the geometric traits
 *
 * \sa `read_background_mesh()`
 */
template <typename GT>
struct Background_mesh_3
{
  typedef typename GT::Point_3       Point_3;     ///< the point type
  typedef std::array<std::size_t, 4> Tetrahedron; ///< the positions of four points, from 0

  std::vector<Point_3> points;         ///< the vertices
  std::vector<Tetrahedron> tetrahedra; ///< the tetrahedra
  std::vector<double> sizes;           ///< the size at each vertex, in the unit of the coordinates

  /// returns whether each vertex has a positive and finite size, and each index of a tetrahedron names a vertex.
  bool is_valid() const
  {
    if(sizes.size() != points.size())
      return false;
    for(const double size : sizes)
      if(! (size > 0 && size < std::numeric_limits<double>::infinity()))
        return false;
    for(const Tetrahedron& t : tetrahedra)
      for(const std::size_t v : t)
        if(v >= points.size())
          return false;
    return true;
  }
};

namespace internal {

/*
 * Reads words and numbers from a text with comments, which begin with `#` and end with the line, and knows in which
 * line it is. Numbers are written as in C++, with a point, whatever the locale of the stream is.
 */
class Read_numbers
{
public:
  explicit Read_numbers(std::istream& in) : m_in(in), m_locale(in.imbue(std::locale::classic())) { }

  ~Read_numbers() { m_in.imbue(m_locale); }

  Read_numbers(const Read_numbers&) = delete;
  Read_numbers& operator=(const Read_numbers&) = delete;

  // Reads a number, or a word; returns whether there is one.
  template <typename Number_or_word>
  bool operator()(Number_or_word& x)
  {
    skip();
    return static_cast<bool>(m_in >> x);
  }

  // Reads a position that the file counts from `first`; `end` is behind the last one, counted from 0.
  bool read_position(std::size_t& position, const std::size_t first, const std::size_t end)
  {
    long long number;
    if(! (*this)(number) || number < static_cast<long long>(first))
      return false;
    position = static_cast<std::size_t>(number) - first;
    return position < end;
  }

  // Whether nothing but blanks and comments is left.
  bool is_at_end()
  {
    skip();
    return m_in.peek() == std::char_traits<char>::eof();
  }

  // Leaves out what is not a word that begins with a letter.
  void skip_numbers()
  {
    std::string word;
    for(skip(); ! is_letter(m_in.peek()) && (m_in >> word); skip())
      { }
  }

  // What is missing, or wrong, and where.
  std::string message(const std::string& text) const { return "line " + std::to_string(m_line) + ": " + text; }

private:
  static bool is_letter(const int c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

  // Leaves out blanks and comments.
  void skip()
  {
    for(int c = m_in.peek(); c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '#'; c = m_in.peek())
    {
      m_in.get();
      if(c == '#')
        while(m_in.peek() != '\n' && m_in.get() != std::char_traits<char>::eof())
          { }
      m_line += c == '\n';
    }
  }

  std::istream& m_in;
  std::locale m_locale;
  std::size_t m_line = 1;
};

// Reads the files of a background mesh one after the other: each function returns what is wrong, or nothing.
template <typename GT>
class Read_background_mesh_files
{
public:
  typedef Background_mesh_3<GT>      Mesh;
  typedef typename Mesh::Tetrahedron Tetrahedron;
  typedef std::string (Read_background_mesh_files::*Read_file)(Read_numbers&);

  // Returns whether the file is all right.
  bool read(std::istream& in, const std::string& extension, const Read_file read_file, std::string& message)
  {
    if(! in)
    {
      message = extension + " file: it cannot be opened";
      return false;
    }
    Read_numbers numbers(in);
    const std::string error = (this->*read_file)(numbers);
    if(! error.empty())
      message = extension + " file, " + numbers.message(error);
    return error.empty();
  }

  // Gives the mesh away, if each of its vertices has a size.
  bool finish(Mesh& mesh, std::string& message)
  {
    if(m_mesh.sizes.size() == m_mesh.points.size())
    {
      std::swap(mesh, m_mesh);
      return true;
    }
    message = "there are " + std::to_string(m_mesh.sizes.size()) + " sizes for "
              + std::to_string(m_mesh.points.size()) + " vertices";
    return false;
  }

  // The vertices of tetrahedra may come before the vertices, whose number is known in the end.
  std::string read_mesh(Read_numbers& read)
  {
    std::string word;
    if(! read(word) || word != "MeshVersionFormatted")
      return "it does not begin with MeshVersionFormatted";
    for(read.skip_numbers(); read(word) && word != "End"; read.skip_numbers())
    {
      std::string error;
      if(word == "Dimension")
        error = read_dimension(read);
      else if(word == "Vertices")
        error = read_vertices(read);
      else if(word == "Tetrahedra")
        error = read_tetrahedra(read);
      if(! error.empty())
        return error;
    }
    for(const Tetrahedron& t : m_mesh.tetrahedra)
      for(const std::size_t v : t)
        if(v >= m_mesh.points.size())
          return "a tetrahedron has a vertex " + std::to_string(v + 1) + ", which is not there";
    return m_mesh.tetrahedra.empty() ? "there are no tetrahedra" : "";
  }

  std::string read_sol(Read_numbers& read)
  {
    std::string word;
    if(! read(word) || word != "MeshVersionFormatted")
      return "it does not begin with MeshVersionFormatted";
    for(read.skip_numbers(); read(word) && word != "SolAtVertices"; read.skip_numbers())
      if(const std::string error = word == "Dimension" ? read_dimension(read) : ""; ! error.empty())
        return error;
    std::size_t n, number_of_solutions, type;
    if(word != "SolAtVertices" || ! read(n))
      return "there is no SolAtVertices with a number";
    if(! read(number_of_solutions) || ! read(type) || number_of_solutions != 1 || type != 1)
      return "the solution is not one scalar for each vertex, which '1 1' stands for";
    return read_sizes(read, n);
  }

  std::string read_node(Read_numbers& read)
  {
    std::size_t n, dimension, number_of_attributes, number_of_markers;
    if(! read(n) || ! read(dimension) || ! read(number_of_attributes) || ! read(number_of_markers) || dimension != 3)
      return "it does not begin with a number of points, 3, and numbers of attributes and of markers";
    for(std::size_t i = 0; i < n; ++i)
    {
      std::size_t number;
      std::array<double, 3> p;
      if(! read(number) || ! read(p[0]) || ! read(p[1]) || ! read(p[2])
         || ! skip_numbers(read, number_of_attributes + number_of_markers))
        return "a point is missing, or its numbers are not as many as announced";
      if(i == 0)
        m_first = number;
      if(number != m_first + i || m_first > 1)
        return "points are not numbered one after the other, from 0 or from 1";
      m_mesh.points.emplace_back(p[0], p[1], p[2]);
    }
    return "";
  }

  std::string read_ele(Read_numbers& read)
  {
    std::size_t n, number_of_vertices, number_of_attributes;
    if(! read(n) || ! read(number_of_vertices) || ! read(number_of_attributes)
       || (number_of_vertices != 4 && number_of_vertices != 10))
      return "it does not begin with a number of tetrahedra, 4 or 10, and a number of attributes";
    for(std::size_t i = 0; i < n; ++i)
    {
      long long number;
      Tetrahedron t;
      if(! read(number))
        return "a tetrahedron is missing";
      for(std::size_t& v : t)
        if(! read.read_position(v, m_first, m_mesh.points.size()))
          return "a vertex of a tetrahedron is missing, or is none of the points";
      if(! skip_numbers(read, number_of_vertices - 4 + number_of_attributes))
        return "the numbers of a tetrahedron are not as many as announced";
      m_mesh.tetrahedra.push_back(t);
    }
    return n == 0 ? "there are no tetrahedra" : "";
  }

  std::string read_mtr(Read_numbers& read)
  {
    std::size_t n, number_of_values;
    if(! read(n) || ! read(number_of_values) || number_of_values != 1)
      return "it does not begin with a number of points, and 1";
    return read_sizes(read, n);
  }

private:
  static bool skip_numbers(Read_numbers& read, const std::size_t n)
  {
    double number;
    for(std::size_t i = 0; i < n; ++i)
      if(! read(number))
        return false;
    return true;
  }

  static std::string read_dimension(Read_numbers& read)
  {
    int dimension;
    return read(dimension) && dimension == 3 ? "" : "the dimension is not 3";
  }

  std::string read_vertices(Read_numbers& read)
  {
    std::size_t n;
    if(! read(n))
      return "the number of vertices is missing";
    for(std::size_t i = 0; i < n; ++i)
    {
      double x, y, z;
      if(! read(x) || ! read(y) || ! read(z) || ! skip_numbers(read, 1))
        return "a vertex is missing, or is not three coordinates and a reference";
      m_mesh.points.emplace_back(x, y, z);
    }
    return "";
  }

  std::string read_tetrahedra(Read_numbers& read)
  {
    std::size_t n;
    if(! read(n))
      return "the number of tetrahedra is missing";
    for(std::size_t i = 0; i < n; ++i)
    {
      Tetrahedron t;
      for(std::size_t& v : t)
        if(! read.read_position(v, 1, std::size_t(-1)))
          return "a vertex of a tetrahedron is missing, or is not positive";
      if(! skip_numbers(read, 1))
        return "the reference of a tetrahedron is missing";
      m_mesh.tetrahedra.push_back(t);
    }
    return "";
  }

  std::string read_sizes(Read_numbers& read, const std::size_t n)
  {
    for(std::size_t i = 0; i < n; ++i)
    {
      double size;
      if(! read(size))
        return "a size is missing, or is not a number";
      if(! (size > 0))
        return "a size is not positive";
      m_mesh.sizes.push_back(size);
    }
    return "";
  }

  Mesh m_mesh;
  std::size_t m_first = 0; // the number of the first point of TetGen
};

} // namespace internal

/*!
 * \ingroup PkgBoundaryRecovery3Functions
 *
 * \brief reads a tetrahedral mesh in the text format MEDIT (`.mesh`), and the sizes at its vertices from a solution
 * (`.sol`), as MMG writes and reads them.
 *
 * Only vertices and tetrahedra of the mesh are used. The solution has one scalar at each vertex.
 *
 * \tparam GT the geometric traits
 *
 * \param mesh_stream the `.mesh` file
 * \param sol_stream the `.sol` file
 * \param mesh is set to the mesh
 * \param message is set to the error, with the kind of the file and the number of the line
 *
 * \return whether a valid mesh was read. Otherwise, `mesh` is unchanged.
 */
template <typename GT>
bool read_MEDIT_background_mesh(std::istream& mesh_stream, std::istream& sol_stream, Background_mesh_3<GT>& mesh,
                                std::string& message)
{
  internal::Read_background_mesh_files<GT> read;
  return read.read(mesh_stream, ".mesh", &internal::Read_background_mesh_files<GT>::read_mesh, message)
      && read.read(sol_stream, ".sol", &internal::Read_background_mesh_files<GT>::read_sol, message)
      && read.finish(mesh, message);
}

/*!
 * \ingroup PkgBoundaryRecovery3Functions
 *
 * \brief reads a tetrahedral mesh from files of TetGen: vertices (`.node`), tetrahedra (`.ele`), and the sizes at
 * vertices (`.mtr`).
 *
 * Vertices may be numbered from 0 or from 1. Of tetrahedra with ten vertices, the first four are used.
 *
 * \tparam GT the geometric traits
 *
 * \param node_stream the `.node` file
 * \param ele_stream the `.ele` file
 * \param mtr_stream the `.mtr` file
 * \param mesh is set to the mesh
 * \param message is set to the error, with the kind of the file and the number of the line
 *
 * \return whether a valid mesh was read. Otherwise, `mesh` is unchanged.
 */
template <typename GT>
bool read_TetGen_background_mesh(std::istream& node_stream, std::istream& ele_stream, std::istream& mtr_stream,
                                 Background_mesh_3<GT>& mesh, std::string& message)
{
  internal::Read_background_mesh_files<GT> read;
  return read.read(node_stream, ".node", &internal::Read_background_mesh_files<GT>::read_node, message)
      && read.read(ele_stream, ".ele", &internal::Read_background_mesh_files<GT>::read_ele, message)
      && read.read(mtr_stream, ".mtr", &internal::Read_background_mesh_files<GT>::read_mtr, message)
      && read.finish(mesh, message);
}

/*!
 * \ingroup PkgBoundaryRecovery3Functions
 *
 * \brief reads a background mesh from files with the same name but for their extensions: `x.mesh` and `x.sol`, or
 * `x.node`, `x.ele` and `x.mtr`.
 *
 * \tparam GT the geometric traits
 *
 * \param filename the name of one of the files; the extension tells the format
 * \param mesh is set to the mesh
 * \param message is set to the error, with the kind of the file and the number of the line
 *
 * \return whether a valid mesh was read. Otherwise, `mesh` is unchanged.
 */
template <typename GT>
bool read_background_mesh(const std::string& filename, Background_mesh_3<GT>& mesh, std::string& message)
{
  const std::string::size_type dot = (std::min)(filename.rfind('.'), filename.size());
  const std::string name = filename.substr(0, dot), extension = filename.substr(dot);
  if(extension == ".mesh" || extension == ".sol")
  {
    std::ifstream mesh_stream(name + ".mesh"), sol_stream(name + ".sol");
    return read_MEDIT_background_mesh(mesh_stream, sol_stream, mesh, message);
  }
  if(extension == ".node" || extension == ".ele" || extension == ".mtr")
  {
    std::ifstream node_stream(name + ".node"), ele_stream(name + ".ele"), mtr_stream(name + ".mtr");
    return read_TetGen_background_mesh(node_stream, ele_stream, mtr_stream, mesh, message);
  }
  message = "a background mesh is in a .mesh and a .sol file, or in .node, .ele and .mtr files";
  return false;
}

} // namespace CGAL::Boundary_recovery_3

#endif // CGAL_BOUNDARY_RECOVERY_3_BACKGROUND_MESH_3_H

// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_READ_BACKGROUND_MESH_H
#define CGAL_BOUNDARY_RECOVERY_3_READ_BACKGROUND_MESH_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Background_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Read_background_mesh_files.h>

#include <algorithm>
#include <fstream>
#include <istream>
#include <string>

namespace CGAL {
namespace Boundary_recovery_3 {

/*!
 * \ingroup PkgBoundaryRecovery3Functions
 *
 * \brief reads a tetrahedral mesh in the text format MEDIT (`.mesh`), and the sizes at its vertices from a solution
 * (`.sol`), as MMG writes and reads them.
 *
 * Of the mesh, the vertices and the tetrahedra are used. The solution has to have one scalar at each vertex.
 *
 * \tparam GT the geometric traits
 *
 * \param mesh_stream the `.mesh` file
 * \param sol_stream the `.sol` file
 * \param mesh is set to what is read
 * \param message is set to what is wrong, with the kind of the file and the number of the line
 *
 * \return whether a valid mesh was read. If not, `mesh` is as before.
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
 * \param mesh is set to what is read
 * \param message is set to what is wrong, with the kind of the file and the number of the line
 *
 * \return whether a valid mesh was read. If not, `mesh` is as before.
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
 * \param filename the name of one of the files; its extension tells which ones are read
 * \param mesh is set to what is read
 * \param message is set to what is wrong, with the kind of the file and the number of the line
 *
 * \return whether a valid mesh was read. If not, `mesh` is as before.
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

} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_READ_BACKGROUND_MESH_H

// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_CONSTRAINED_EDGE_MAP_3_H
#define CGAL_BOUNDARY_RECOVERY_3_CONSTRAINED_EDGE_MAP_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <boost/property_map/property_map.hpp>

#include <memory>
#include <utility>

namespace CGAL::Boundary_recovery_3 {

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief a property map of the constrained edges of a triangulation, for the named parameter `edge_is_constrained_map`
 * of this package and of CGAL's tetrahedral remeshing.
 *
 * The order of the ends makes no difference. Copies share their edges.
 *
 * \tparam Tr an instance of `CGAL::Triangulation_3`, or of a class derived from it
 *
 * \cgalModels{ReadWritePropertyMap}
 */
template <typename Tr>
class Constrained_edge_map_3
{
public:
  typedef Tr                                      Triangulation; ///< the triangulation type
  typedef typename Tr::Vertex_handle              Vertex_handle; ///< its vertex handle
  typedef std::pair<Vertex_handle, Vertex_handle> key_type;      ///< the ends of an edge
  typedef bool                                    value_type;    ///< whether it is constrained
  typedef bool                                    reference;     ///< the same
  typedef boost::read_write_property_map_tag      category;      ///< for reading and writing

  /// no edge is constrained.
  Constrained_edge_map_3() : m_edges(std::make_shared<Edges>()) { }

  /// the edges in `edges` are constrained, a range of arrays of two vertex handles, such as
  /// `Boundary_constrained_mesh_result_3::constrained_edges`.
  template <typename EdgeRange>
  explicit Constrained_edge_map_3(const EdgeRange& edges)
    : Constrained_edge_map_3()
  {
    for(const auto& e : edges)
      m_edges->insert({{ e[0], e[1] }});
  }

  /// returns whether an edge is constrained.
  friend bool get(const Constrained_edge_map_3& map, const key_type& edge)
  {
    return (*map.m_edges)[{{ edge.first, edge.second }}] != Edges::none;
  }

  /// makes an edge constrained or free.
  friend void put(const Constrained_edge_map_3& map, const key_type& edge, const bool is_constrained)
  {
    if(is_constrained)
      map.m_edges->insert({{ edge.first, edge.second }});
    else
      map.m_edges->erase({{ edge.first, edge.second }});
  }

private:
  typedef internal::Simplex_index_3<Vertex_handle, 2> Edges; // for looking up only

  std::shared_ptr<Edges> m_edges;
};

} // namespace CGAL::Boundary_recovery_3

#endif // CGAL_BOUNDARY_RECOVERY_3_CONSTRAINED_EDGE_MAP_3_H

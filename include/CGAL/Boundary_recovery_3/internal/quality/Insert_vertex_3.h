// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_INSERT_VERTEX_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_INSERT_VERTEX_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Quality_improvement_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/walk_to.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Best_point_in_star_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Cell_angles_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Free_star_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Places_near_cell_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Star_cavity_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Cell_shape_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/shape/distances_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <CGAL/Random.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Seeds of `Insert_vertex_3`: the centroid of a bad cell. The cavity grows through the face where the new cell is the
 * worst, until that face is a wall, all new cells are good enough, or the cavity is large. Then the point is moved to
 * where the new cells are least bad. Both steps alternate.
 *
 * A nearly flat cell is tried a second time, where the cavity also grows while the worst new cell is at a wall: if the
 * flat cell is at a wall, its centroid is nearly in the plane of the wall, so the new cell there is bad until the point
 * is moved.
 */
template <typename Mesh>
class Seeds_in_cell_3
{
public:
  typedef typename Mesh::Cell_handle Cell_handle;
  typedef Star_cavity_3<Mesh>        Cavity;

  static constexpr bool is_first_one_taken = true;

  explicit Seeds_in_cell_3(const Mesh& mesh) : m_mesh(mesh) { }

  bool is_for(Cell_handle) const { return true; }

  std::size_t start(const Cell_handle c, double /* tolerated_loss */)
  {
    m_cell = c;
    return m_mesh.is_nearly_flat(m_mesh.quality(c)) ? 2 : 1;
  }

  bool grow(const std::size_t k, Cavity& cavity) const
  {
    cavity.start(m_cell, internal::centroid(internal::corners(m_cell)));
    grow(cavity, k == 0);
    double quality;
    do
    {
      if(! cavity.has_only_free_vertices_inside())
        return false;
      quality = cavity.move_point();
    }
    while(quality < m_mesh.enough() && grow(cavity, k == 0));
    return quality > m_mesh.least_quality(cavity.worst_quality()) && cavity.gain() > 0 && cavity.is_in_size()
        && cavity.is_star();
  }

private:
  typedef typename Cavity::Face Face;

  // Takes in the cell behind the worst face, again and again, until that is a wall, or all are good enough. Returns
  // whether there was one.
  bool grow(Cavity& cavity, const bool minds_walls) const
  {
    const std::size_t number = cavity.cells().size();
    while(const Face* const face = worst_face(cavity, minds_walls))
      cavity.take_in(face->cell->neighbor(face->index));
    return cavity.cells().size() > number;
  }

  // The face with the worst new cell, if the cavity can grow through it; none if this face is a wall, if all new cells
  // are good enough, or if the cavity is large. If `minds_walls` is false, faces at walls are ignored.
  const Face* worst_face(const Cavity& cavity, const bool minds_walls) const
  {
    double worst = m_mesh.enough();
    const Face* face = nullptr;
    for(const Face& f : cavity.faces())
      if(f.quality < worst && (minds_walls || ! cavity.is_wall(f)))
      {
        worst = f.quality;
        face = &f;
      }
    return face == nullptr || cavity.is_large() || cavity.is_wall(*face) ? nullptr : face;
  }

  const Mesh& m_mesh;
  Cell_handle m_cell;
};

/*
 * Places near a bad cell, where the center does not help: beside a thin triangle of the surface, cells are good if they
 * have their other vertices near its short edge, or beside its long ones, and that is far from the center of any cell
 * there.
 *
 * The cavity is made of the cells on the way to the place, and grows where its star has the worst cell. Of all states
 * on the way, the one that helps most is taken; then the point is moved to where the cells are less bad.
 */
template <typename Mesh>
class Seeds_near_cell_3
{
public:
  typedef typename Mesh::Cell_handle Cell_handle;
  typedef Star_cavity_3<Mesh>        Cavity;

  static constexpr bool is_first_one_taken = false;

  explicit Seeds_near_cell_3(const Mesh& mesh) : m_mesh(mesh) { }

  bool is_for(Cell_handle) const { return true; }

  std::size_t start(const Cell_handle c, const double tolerated_loss)
  {
    m_cell = c;
    m_least_gain = - tolerated_loss;
    m_least_at_wall = m_mesh.least_quality(m_mesh.quality(c));
    return m_places_near(internal::corners(c)).size();
  }

  bool grow(const std::size_t k, Cavity& cavity)
  {
    const Coordinates_3& p = m_places_near.places()[k];
    return are_walls_good_with(p) && walk(p) && make_cavity(cavity, p);
  }

private:
  typedef typename Cavity::Face Face;

  static constexpr int max_number_of_steps = 20; // see "Tuning constants" in the manual

  // Whether the new cells between p and the walls of the bad cell are good enough. These cells stay however far the
  // cavity grows, since it does not grow through walls; if one is too bad, the point is useless.
  bool are_walls_good_with(const Coordinates_3& p) const
  {
    for(int i = 0; i < 4; ++i)
      if(m_mesh.domain().is_wall(m_cell, i)
         && m_mesh.quality(internal::facet_vertices(m_cell, i), p) < m_least_at_wall)
        return false;
    return true;
  }

  // Collects the cells on a walk from the bad cell to the cell that contains p, each once. Returns false if a wall is
  // in the way, or if the walk takes too many steps.
  bool walk(const Coordinates_3& p)
  {
    m_way.clear();
    const auto facet_towards = [&](const Cell_handle c)
    {
      m_way.push_back(c);
      return internal::facet_towards(c, p, [&](const int k) { return ! is_on_way(c->neighbor(k)); });
    };
    const auto cell_behind = [&](const Cell_handle c, const int i)
    {
      return m_mesh.domain().is_wall(c, i) ? std::nullopt : std::optional<Cell_handle>(c->neighbor(i));
    };
    return bool(internal::walk_to(m_cell, max_number_of_steps, facet_towards, cell_behind));
  }

  bool is_on_way(const Cell_handle c) const { return internal::contains(m_way, c); }

  // Begins with the cells of the way, and moves the point in the end. Returns false if the cells would be too bad.
  bool make_cavity(Cavity& cavity, const Coordinates_3& p)
  {
    cavity.start(m_way.front(), p);
    for(std::size_t k = 1; k < m_way.size(); ++k)
      cavity.take_in(m_way[k]);
    if(! grow(cavity))
      return false;
    const double quality = cavity.move_point();
    return cavity.gain() > m_least_gain && quality > 0 && quality >= m_mesh.least_quality(cavity.worst_quality())
        && cavity.has_only_free_vertices_inside() && cavity.is_in_size() && cavity.is_star();
  }

  // Grows the cavity, and goes back to where the cells are the least bad. Returns false if that is nowhere as
  // good as it has to be.
  bool grow(Cavity& cavity)
  {
    double best_gain = m_least_gain;
    std::size_t best = 0;
    while(true)
    {
      const double gain = cavity.badness() - set_worst_face(cavity);
      const double least = m_mesh.least_quality(cavity.worst_quality());
      if(gain > best_gain && m_worst > 0 && m_worst >= least && cavity.has_only_free_vertices_inside())
      {
        best_gain = gain;
        best = cavity.cells().size();
      }
      if(m_face == nullptr || m_worst_at_wall < least || cavity.is_large())
        break;
      cavity.take_in(m_face->cell->neighbor(m_face->index));
    }
    if(best > 0 && best < cavity.cells().size())
      cavity.go_back_to(best);
    return best > 0;
  }

  // Sets the worst quality of all new cells, and of those at walls, and the worst face that is not a wall, through
  // which the cavity can grow next. Returns the sum of the badness of the new cells.
  double set_worst_face(const Cavity& cavity)
  {
    double badness = 0, worst = m_mesh.enough();
    m_worst = m_worst_at_wall = worst;
    m_face = nullptr;
    for(const Face& f : cavity.faces())
    {
      badness += m_mesh.badness(f.quality);
      m_worst = (std::min)(m_worst, f.quality);
      if(! (f.quality < (std::max)(worst, m_worst_at_wall)))
        continue;
      if(cavity.is_wall(f))
        m_worst_at_wall = (std::min)(m_worst_at_wall, f.quality);
      else if(f.quality < worst)
      {
        worst = f.quality;
        m_face = &f;
      }
    }
    return badness;
  }

  const Mesh& m_mesh;
  Cell_handle m_cell;
  Places_near_cell_3 m_places_near;
  std::vector<Cell_handle> m_way; // from the bad cell to the place
  const Face* m_face = nullptr;   // of the cavity
  double m_worst = 0;             // of the qualities of the new cells
  double m_worst_at_wall = 0;
  double m_least_gain = 0;
  double m_least_at_wall = 0; // the least quality that new cells at the walls of the bad cell may have
};

/*
 * Seeds of `Insert_vertex_3` for a nearly flat cell: the shell of each edge at which the cell has an obtuse angle, with
 * the deepest point of the visibility kernel of the shell.
 *
 * They are for cells that fill the angle of nearly 180 degrees between two walls. Such a cell exists as long as the
 * edge does that is opposite to the common edge of the walls. All points of the cell are nearly in the plane of the
 * walls, so the other seeds find no good cavity. The insertion makes the worst cell far better, but the sum of badness
 * may increase.
 */
template <typename Mesh>
class Seeds_in_shells_3
{
public:
  typedef typename Mesh::Cell_handle Cell_handle;
  typedef Star_cavity_3<Mesh>        Cavity;

  static constexpr bool is_first_one_taken = true;

  explicit Seeds_in_shells_3(const Mesh& mesh) : m_mesh(mesh) { }

  bool is_for(const Cell_handle c) const { return ! m_mesh.is_strict() && m_mesh.is_nearly_flat(m_mesh.quality(c)); }

  std::size_t start(const Cell_handle c, double /* tolerated_loss */)
  {
    m_cell = c;
    const Cell_angles_3 angles(internal::corners(c));
    m_edges.clear();
    for(int k = 0; k < 6; ++k)
      if(angles[k] > 90)
        m_edges.push_back(k);
    return m_edges.size();
  }

  bool grow(const std::size_t i, Cavity& cavity) const
  {
    const int* const ends = edges_of_cell[m_edges[i]];
    const Coordinates_3 middle = internal::midpoint(Mesh::coordinates(m_cell->vertex(ends[0])),
                                                    Mesh::coordinates(m_cell->vertex(ends[1])));
    return take_shell(cavity, m_edges[i], middle) && find_point(cavity, middle);
  }

private:
  typedef typename Mesh::Triangulation                Tr;
  typedef std::array<typename Mesh::Vertex_handle, 3> Vertex_triple;

  // See "Tuning constants" in the manual.
  static constexpr double tolerated_loss = 2;
  static constexpr double numerically_flat = 1e-9;

  // Takes the shell of the edge k of the cell, with the new vertex at p. Returns false if a wall is at the edge, or the
  // shell is too large.
  bool take_shell(Cavity& cavity, const int k, const Coordinates_3& p) const
  {
    cavity.start(m_cell, p);
    Edge_walk_3<Tr> walk(m_cell, edges_of_cell[5 - k][0], edges_of_cell[5 - k][1]);
    while(! m_mesh.domain().is_wall(walk.cell(), walk.next_facet()))
    {
      ++walk;
      if(walk.cell() == m_cell)
        return true;
      if(cavity.cells().size() == usual_max_number_of_cells)
        return false;
      cavity.take_in(walk.cell());
    }
    return false;
  }

  // From a point of the shell on.
  bool find_point(Cavity& cavity, const Coordinates_3& p) const
  {
    if(! cavity.has_only_free_vertices_inside())
      return false;
    std::vector<Vertex_triple> faces;
    for(const auto& f : cavity.faces())
      faces.push_back(f.vertices);
    const auto deepest = internal::deepest_point(m_mesh.triangulation(), faces, p);
    return deepest && Mesh::is_far_better(cavity.move_point_from(*deepest), cavity.worst_quality())
        && is_bearable(cavity) && cavity.is_star();
  }

  // Where a cell has no volume but for rounding errors, neither lengths of edges count nor the other cells.
  static bool is_bearable(Cavity& cavity)
  {
    const bool is_in_size = cavity.is_in_size(); // which also finds the size of the vertex
    return cavity.worst_quality() < numerically_flat || (is_in_size && cavity.gain() > - tolerated_loss);
  }

  const Mesh& m_mesh;
  Cell_handle m_cell;
  std::vector<int> m_edges; // of the cell, with obtuse angles
};

/*
 * Inserts a vertex in a bad cell or near it: replaces a cavity by the star of the vertex. `Seeds` makes the cavities:
 *
 *   bool is_for(Cell_handle c)                                // whether the seeds are meant for a cell as bad as c
 *   std::size_t start(Cell_handle c, double tolerated_loss)   // finds the seeds at a cell, and returns their number
 *   bool grow(std::size_t k, Star_cavity_3<Mesh>& cavity)     // makes the cavity of a seed; returns whether it helps
 *
 * `Seeds::is_first_one_taken` tells whether the first cavity that helps is taken, or the one with the largest gain. The
 * mesh is not changed before the whole star is known.
 */
template <typename Mesh, typename Seeds>
class Insert_vertex_3
{
public:
  typedef typename Mesh::Cell_handle Cell_handle;
  typedef typename Mesh::Cells       Cells;

  explicit Insert_vertex_3(Mesh& mesh) : m_mesh(mesh), m_cavity(mesh), m_seeds(mesh) { }

  // Searches for a cavity and a point such that an insertion helps. Returns whether there is one. Then the sum of
  // badness decreases, and no new cell is worse than `least_quality()` of the worst old cell; `Seeds_in_shells_3` has
  // weaker conditions, for nearly flat cells.
  bool find(const Cell_handle c)
  {
    if(! m_seeds.is_for(c) || ! m_mesh.has_room())
      return false;
    const std::size_t number = m_seeds.start(c, 0);
    double best_gain = 0;
    std::size_t best = number;
    for(std::size_t k = 0; k < number; ++k)
      if(m_seeds.grow(k, m_cavity))
      {
        if(Seeds::is_first_one_taken)
          return true;
        if(gain() > best_gain)
        {
          best_gain = gain();
          best = k;
        }
      }
    return best < number && m_seeds.grow(best, m_cavity);
  }

  // The same for one seed at random, where the cells may be worse by less than `tolerated_loss`.
  bool find_any(const Cell_handle c, const double tolerated_loss, CGAL::Random& random)
  {
    const std::size_t number = m_mesh.has_room() ? m_seeds.start(c, tolerated_loss) : 0;
    return number > 0 && m_seeds.grow(random.uniform_int<std::size_t>(0, number - 1), m_cavity);
  }

  double gain() const { return m_cavity.gain(); }

  // Inserts the vertex. Returns true: all cells were found to be positively oriented.
  bool apply()
  {
    m_new_cells = &m_cavity.exchange();
    return true;
  }

  const Cells& new_cells() const { return *m_new_cells; }

  void count(Quality_improvement_counts& counts) const
  {
    ++counts.number_of_inserted_points;
    counts.number_of_removed_vertices += m_cavity.number_of_vertices_inside();
  }

private:
  Mesh& m_mesh;
  Star_cavity_3<Mesh> m_cavity;
  Seeds m_seeds;
  const Cells* m_new_cells = nullptr;
};

template <typename Mesh>
using Insert_into_bad_cell_3 = Insert_vertex_3<Mesh, Seeds_in_cell_3<Mesh>>;

template <typename Mesh>
using Insert_near_bad_cell_3 = Insert_vertex_3<Mesh, Seeds_near_cell_3<Mesh>>;

template <typename Mesh>
using Insert_into_shell_3 = Insert_vertex_3<Mesh, Seeds_in_shells_3<Mesh>>;

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_INSERT_VERTEX_3_H

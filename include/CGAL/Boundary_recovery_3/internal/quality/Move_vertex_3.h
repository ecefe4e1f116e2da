// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_MOVE_VERTEX_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_MOVE_VERTEX_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Cell_quality_3.h>
#include <CGAL/Boundary_recovery_3/Quality_improvement_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Allowed_lengths_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Badness_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Best_point_in_star_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Free_star_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Cell_shape_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/shape/distances_3.h>

#include <CGAL/Random.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Where the cells around a free vertex are less bad, and none is worse than the worst one was: optimising smoothing.
 * Places that hardly help do not count, so that it is the turn of other operations.
 */
template <typename Mesh>
class Least_bad_place_3
{
public:
  typedef typename Mesh::Vertex_handle Vertex_handle;
  typedef typename Mesh::Cell_handle   Cell_handle;

  static constexpr std::size_t max_number_of_cells = usual_max_number_of_cells;

  explicit Least_bad_place_3(const Mesh& mesh) : m_mesh(mesh), m_best_point(mesh.quality()) { }

  bool is_for(Cell_handle) const { return true; }

  bool find(const Vertex_handle v, const Free_star_3<Mesh>& star)
  {
    return improve(v, star, Mesh::coordinates(v), m_mesh.measure_of_badness()) >= least_progress;
  }

  // From a place on. Returns which part of the badness of the cells is gone.
  double improve(const Vertex_handle v, const Free_star_3<Mesh>& star, const Coordinates_3& from,
                 const Badness_3& badness)
  {
    m_best_point.clear(badness);
    for(const auto& f : star.faces())
      m_best_point.add(internal::corners(f));
    m_places.assign(m_mesh.allowed_lengths(), v, star.neighbors());
    m_point = from;
    return m_best_point.improve(m_point, m_places);
  }

  const Coordinates_3& point() const { return m_point; }
  double gain() const { return m_best_point.gain(); }

private:
  // See "Tuning constants" in the manual.
  static constexpr double least_progress = 0.02;

  const Mesh& m_mesh;
  Best_point_in_star_3<typename Mesh::Quality> m_best_point;
  Allowed_places_3<typename Mesh::Triangulation> m_places;
  Coordinates_3 m_point;
};

/*
 * The deepest point of the visibility kernel of a star with nearly flat cells, the one farthest from the planes of all
 * faces: the solution of a linear program.
 *
 * The recovery leaves such vertices: beside a strip of coplanar thin triangles that no other vertex sees, say, at a
 * distance of a millionth of its width. The kernel is so thin there that no step of smoothing stays in it, though other
 * vertices have come, and it is wide elsewhere. Those vertices have many cells, and edges that may be too long already.
 *
 * The worst cell is better by far then; others may be worse than before, and edges have any length.
 */
template <typename Mesh>
class Deepest_place_3
{
public:
  typedef typename Mesh::Vertex_handle Vertex_handle;
  typedef typename Mesh::Cell_handle   Cell_handle;

  // See "Tuning constants" in the manual.
  static constexpr std::size_t max_number_of_cells = 1000;

  explicit Deepest_place_3(const Mesh& mesh) : m_mesh(mesh), m_least_bad_place(mesh) { }

  bool is_for(const Cell_handle c) const { return ! m_mesh.is_strict() && m_mesh.is_nearly_flat(m_mesh.quality(c)); }

  bool find(const Vertex_handle v, const Free_star_3<Mesh>& star)
  {
    const Coordinates_3 before = Mesh::coordinates(v);
    const auto deepest = internal::deepest_point(m_mesh.triangulation(), star.faces(), before);
    if(! deepest)
      return false;
    const auto account = m_mesh.account_of_star(star.faces(), before);
    if(! Mesh::is_far_better(m_mesh.account_of_star(star.faces(), *deepest).worst, account.worst))
      return false;
    m_least_bad_place.improve(v, star, *deepest, Badness_3(m_mesh.enough()));
    m_gain = account.badness - m_mesh.account_of_star(star.faces(), point()).badness;
    return true;
  }

  const Coordinates_3& point() const { return m_least_bad_place.point(); }
  double gain() const { return m_gain; }

private:
  const Mesh& m_mesh;
  Least_bad_place_3<Mesh> m_least_bad_place;
  double m_gain = 0;
};

// The volume over the lengths of the edges that a cell with this dihedral angle, in radians, has at most, see
// Volume_length_quality_3::of_angle().
inline double largest_roundness(const double angle)
{
  return std::sqrt(8.) * std::sin(angle) / (3 - std::cos(angle));
}

// Cells of this volume over their edges, see Volume_length_quality_3, are sure to have the other quality, too: nothing
// is known of qualities in general.
template <typename Quality>
double sure_roundness(const Quality&, const double)
{
  return (std::numeric_limits<double>::infinity)();
}

// None of the angles can be so small, or so large, that the quality would be less.
inline double sure_roundness(const Dihedral_angle_quality_3& quality, const double least)
{
  const double sine = least * std::sin(largest_min_dihedral_angle); // the quality of this angle is 1
  const double sine_if_obtuse = sine / quality.obtuse_factor();
  if(! (sine < 1 && sine_if_obtuse < 1))
    return (std::numeric_limits<double>::infinity)();
  const double rounding = 1 + 1e-9;
  return rounding * (std::max)(largest_roundness(std::asin(sine)),
                               largest_roundness(CGAL_PI - std::asin(sine_if_obtuse)));
}

/*
 * The mean of the neighbors of a vertex, or a place on the way there, if the cells are rounder then: smart Laplacian
 * smoothing, as in L. A. Freitag, "On combining Laplacian and optimization-based mesh smoothing techniques", 1997.
 *
 * It is cheap, and good for the mass of the cells, where optimising smoothing is for single bad ones. The few of these
 * do not get worse for it: bad cells must stay as good as the worst of them was, and be no worse in sum.
 */
template <typename Mesh>
class Central_place_3
{
public:
  typedef typename Mesh::Vertex_handle Vertex_handle;
  typedef typename Mesh::Cell_handle   Cell_handle;

  static constexpr std::size_t max_number_of_cells = usual_max_number_of_cells;

  explicit Central_place_3(const Mesh& mesh) : m_mesh(mesh) { }

  bool find(const Vertex_handle v, const Free_star_3<Mesh>& star)
  {
    set_corners(v, star);
    const double before = sum_of_roundness();
    const Coordinates_3 from = Mesh::coordinates(v), to = mean_of_corners();
    for(double step = 1; step > 0.4; step *= 0.5)
    {
      m_point = internal::point_between(from, to, step);
      for(Cell_corners_3& c : m_corners)
        c[3] = m_point;
      if(sum_of_roundness() > before && are_as_good_as(star.cells()) && are_edges_in_size(v, star))
        return true;
    }
    return false;
  }

  const Coordinates_3& point() const { return m_point; }

private:
  // The vertex is the last corner of each cell.
  void set_corners(const Vertex_handle v, const Free_star_3<Mesh>& star)
  {
    m_corners.clear();
    for(const auto& f : star.faces())
      m_corners.push_back(Mesh::corners(f, Mesh::coordinates(v)));
  }

  double sum_of_roundness()
  {
    double sum = 0;
    m_least_roundness = std::numeric_limits<double>::infinity();
    for(const Cell_corners_3& c : m_corners)
    {
      const double q = m_roundness(c);
      sum += q;
      m_least_roundness = (std::min)(m_least_roundness, q);
    }
    return sum;
  }

  // A neighbor counts once for each cell, and so does the vertex itself, which does not go too far for that.
  Coordinates_3 mean_of_corners() const
  {
    Coordinates_3 sum = {{ 0, 0, 0 }};
    for(const Cell_corners_3& c : m_corners)
    {
      const Coordinates_3 p = internal::centroid(c);
      for(int i = 0; i < 3; ++i)
        sum[i] += p[i];
    }
    for(double& x : sum)
      x /= static_cast<double>(m_corners.size());
    return sum;
  }

  // Whether the cells of the corners are as good as these. Most stars have none that is bad, or nearly so.
  bool are_as_good_as(const std::vector<Cell_handle>& cells)
  {
    if(m_least_roundness >= enough_roundness())
      return true;
    const auto after = m_mesh.account_of(m_corners);
    if(after.worst >= m_mesh.enough())
      return true;
    const auto before = m_mesh.account_of(cells);
    return after.worst >= before.worst && after.badness <= before.badness;
  }

  // Rounder cells are sure to be good enough. It is computed once for all vertices.
  double enough_roundness()
  {
    if(m_enough != m_mesh.enough())
    {
      m_enough = m_mesh.enough();
      m_enough_roundness = internal::sure_roundness(m_mesh.uncounted_quality(), m_enough);
    }
    return m_enough_roundness;
  }

  bool are_edges_in_size(const Vertex_handle v, const Free_star_3<Mesh>& star)
  {
    m_places.assign(m_mesh.allowed_lengths(), v, star.neighbors());
    return m_places(m_point);
  }

  const Mesh& m_mesh;
  Volume_length_quality_3 m_roundness;
  std::vector<Cell_corners_3> m_corners;
  double m_least_roundness = 0; // of the corners
  double m_enough = -1;
  double m_enough_roundness = 0;
  Allowed_places_3<typename Mesh::Triangulation> m_places;
  Coordinates_3 m_point;
};

/*
 * Half of the way to a random place in a random cell of a star. Mostly, that makes cells worse; but none gets worse
 * than what the mesh tolerates.
 */
template <typename Mesh>
class Random_place_3
{
public:
  typedef typename Mesh::Vertex_handle Vertex_handle;
  typedef typename Mesh::Cell_handle   Cell_handle;

  static constexpr std::size_t max_number_of_cells = usual_max_number_of_cells;

  explicit Random_place_3(const Mesh& mesh) : m_mesh(mesh) { }

  bool find(const Vertex_handle v, const Free_star_3<Mesh>& star)
  {
    const Cell_handle c = star.cells()[m_random.uniform_int<std::size_t>(0, star.cells().size() - 1)];
    m_point = internal::midpoint(Mesh::coordinates(v), random_point(c));
    m_places.assign(m_mesh.allowed_lengths(), v, star.neighbors());
    return m_places(m_point) && are_tolerated(star);
  }

  const Coordinates_3& point() const { return m_point; }

private:
  Coordinates_3 random_point(const Cell_handle c)
  {
    std::array<double, 4> weights;
    double sum = 0;
    for(double& w : weights)
      sum += w = 1 - m_random.get_double(); // not 0
    Coordinates_3 p = {{ 0, 0, 0 }};
    for(int i = 0; i < 4; ++i)
      for(int j = 0; j < 3; ++j)
        p[j] += weights[i] / sum * Mesh::coordinates(c->vertex(i))[j];
    return p;
  }

  // Whether the mesh may have the cells that there would be.
  bool are_tolerated(const Free_star_3<Mesh>& star) const
  {
    return m_mesh.account_of_star(star.faces(), m_point).worst >=
           m_mesh.least_quality(m_mesh.account_of(star.cells()).worst);
  }

  const Mesh& m_mesh;
  Allowed_places_3<typename Mesh::Triangulation> m_places;
  Coordinates_3 m_point;
  CGAL::Random m_random = CGAL::Random(0); // always the same numbers
};

/*
 * Moves a free vertex to a place in its star. `Place` searches it:
 *
 *   bool find(Vertex_handle v, const Star& star) // whether there is a place that will do
 *   Coordinates_3 point()                        // the one that was found
 *
 * and tells how many cells the star may have. If it is for bad cells, it also has
 *
 *   bool is_for(Cell_handle c)                   // whether it helps cells that are as bad as c
 *   double gain()                                // by how much the cells are less bad if the vertex is there
 */
template <typename Mesh, typename Place>
class Move_vertex_3
{
public:
  typedef typename Mesh::Vertex_handle Vertex_handle;
  typedef typename Mesh::Cell_handle   Cell_handle;

  explicit Move_vertex_3(Mesh& mesh)
    : m_mesh(mesh), m_star(mesh, Place::max_number_of_cells), m_place(mesh), m_vain_attempts(mesh)
  { }

  // Searches a place for one of the vertices of a bad cell, of those around which something has changed.
  bool find(const Cell_handle c)
  {
    if(m_place.is_for(c))
      for(int i = 0; i < 4; ++i)
        if(! m_vain_attempts.contains(c->vertex(i)))
        {
          if(find(c->vertex(i)))
            return true;
          m_vain_attempts.add(c->vertex(i));
        }
    return false;
  }

  // The same for a vertex.
  bool find(const Vertex_handle v)
  {
    m_vertex = v;
    return m_star.collect(v) && m_place.find(v, m_star);
  }

  double gain() const { return m_place.gain(); }

  // Moves the vertex. Returns false, and does nothing, if a cell would not be positively oriented.
  bool apply()
  {
    const bool is_moved = move();
    m_vain_attempts.add(m_vertex);
    return is_moved;
  }

  // Searches and moves, whatever was in vain. Returns whether the vertex was moved.
  bool operator()(const Vertex_handle v) { return find(v) && move(); }

  // The cells around the vertex.
  const std::vector<Cell_handle>& new_cells() const { return m_star.cells(); }

  void count(Quality_improvement_counts& counts) const { ++counts.number_of_moved_vertices; }

private:
  bool move() { return m_mesh.move(m_vertex, m_place.point(), m_star.cells(), m_star.faces()); }

  Mesh& m_mesh;
  Free_star_3<Mesh> m_star;
  Place m_place;
  Vain_attempts_3<Mesh> m_vain_attempts;
  Vertex_handle m_vertex;
};

template <typename Mesh>
using Smooth_vertex_3 = Move_vertex_3<Mesh, Least_bad_place_3<Mesh>>;

template <typename Mesh>
using Deepen_vertex_3 = Move_vertex_3<Mesh, Deepest_place_3<Mesh>>;

template <typename Mesh>
using Center_vertex_3 = Move_vertex_3<Mesh, Central_place_3<Mesh>>;

template <typename Mesh>
using Move_at_random_3 = Move_vertex_3<Mesh, Random_place_3<Mesh>>;

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_MOVE_VERTEX_3_H

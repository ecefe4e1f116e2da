#ifndef BOUNDARY_RECOVERY_3_PROGRAM_REPAIR_SURFACE_H
#define BOUNDARY_RECOVERY_3_PROGRAM_REPAIR_SURFACE_H

#include "close_gaps.h"
#include "dissolve_degenerate_triangles.h"
#include "drop_dust_regions.h"
#include "find_intersections.h"
#include "fuse_bodies.h"
#include "merge_close_points.h"
#include "orient_triangles.h"
#include "resolve_intersections.h"
#include "surface.h"
#include "surface_changes.h"
#include "triangle_soup.h"
#include "unfold_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

// Repairs a triangle soup, step by step; what is good already stays as it is. Triangles without area or that are there
// twice go, and neighbors are turned alike. If the surface is open or intersects itself then, the same is tried with
// points merged that are closer than the tolerance, and then with triangles divided at points that are as close to
// their edges, and with triangles replaced that are folded flat; each is kept if fewer intersections or open edges are
// left. What still intersects is divided, and regions of dust that come of it are none. Nothing is promised: the
// recovery judges what comes out as it judges any surface.
template <typename Point>
class Surface_repairer
{
  typedef Triangle_soup<Point> Soup;

  // rounded points make new intersections, as a rule fewer each time
  static constexpr int max_number_of_refinements = 8;

  // a soup on its way, and what was done to it
  struct State
  {
    Soup soup;
    Repair_changes changes;
    std::size_t intersections = 0, open_edges = 0;

    bool is_good() const { return intersections == 0 && open_edges == 0; }

    // no surface at all is not better
    bool is_better_than(const State& other) const
    {
      return ! soup.triangles.empty() &&
             std::make_pair(intersections, open_edges) < std::make_pair(other.intersections, other.open_edges);
    }
  };

  Surface<Point>& m_surface;
  State m_state;

public:
  explicit Surface_repairer(Surface<Point>& surface) : m_surface(surface) { }

  // `tolerance` is that of the default if it is negative; `fuses` tells whether bodies that overlap become one
  Repair_changes operator()(const double tolerance, const bool fuses)
  {
    Repair_changes& changes = m_state.changes;
    changes.tolerance = tolerance < 0 ? default_tolerance(m_surface.points) : tolerance;
    changes.is_possible = is_triangle_soup(m_surface);
    if(! changes.is_possible)
      return changes;

    load();
    changes.open_edges[0] = open_edges(m_state.soup.triangles).size();
    clean(m_state);
    changes.intersections[0] = m_state.intersections;
    if(! m_state.is_good() && changes.tolerance > 0)
      try_change([this](State& state) { merge_points(state); });
    if(m_state.open_edges > 0 && changes.tolerance > 0)
      try_change([](State& state) { stitch(state); });
    if(m_state.intersections > 0 && changes.tolerance > 0)
      try_change([this](State& state) { unfold(state); });
    const bool is_refined = refine();
    changes.is_fusion_wanted = fuses;
    if(fuses && m_state.intersections == 0)
      fuse();
    if(is_refined && m_state.intersections == 0)
      drop_dust();
    store();
    return changes;
  }

private:
  void load()
  {
    m_state.soup.points = m_surface.points;
    for(std::size_t i = 0; i < m_surface.faces.size(); ++i)
    {
      const auto& face = m_surface.faces[i];
      m_state.soup.triangles.push_back(Sourced_triangle({{ face[0], face[1], face[2] }}, i));
    }
  }

  static void append(std::vector<std::size_t>& list, const std::vector<std::size_t>& more)
  {
    list.insert(list.end(), more.begin(), more.end());
  }

  // A triangle that is turned over twice is as it was. Both lists are in ascending order.
  static void toggle(std::vector<std::size_t>& list, const std::vector<std::size_t>& more)
  {
    std::vector<std::size_t> result;
    std::set_symmetric_difference(list.begin(), list.end(), more.begin(), more.end(), std::back_inserter(result));
    list.swap(result);
  }

  // takes out what the recovery would refuse at once, turns the rest, and looks at what comes out
  void clean(State& state) const
  {
    append(state.changes.degenerate_faces, Degenerate_triangle_dissolver<Point>(state.soup)());
    append(state.changes.duplicate_faces, drop_duplicate_triangles(state.soup));
    toggle(state.changes.reversed_faces, orient_triangles(state.soup));
    judge(state);
  }

  static void judge(State& state)
  {
    state.intersections = Intersection_finder<Point>(state.soup).number_of_pairs();
    state.open_edges = open_edges(state.soup.triangles).size();
  }

  // returns the sources of those that are gone
  static std::vector<std::size_t> drop_duplicate_triangles(Soup& soup)
  {
    const auto count_sources = [&]
    {
      std::map<std::size_t, std::size_t> count;
      for(const Sourced_triangle& t : soup.triangles)
        ++count[t.source];
      return count;
    };
    const auto before = count_sources();
    unite_equal_triangles(soup);
    for(Sourced_triangle& t : soup.triangles)
      t.is_odd = true; // a sheet with a front and a back is one
    auto after = count_sources();
    std::vector<std::size_t> dropped;
    for(const auto& source : before)
      if(after[source.first] == 0)
        dropped.push_back(source.first);
    return dropped;
  }

  template <typename Change>
  void try_change(const Change& change)
  {
    State changed = m_state;
    change(changed);
    changed.changes.is_tolerance_used = true;
    clean(changed);
    if(changed.is_better_than(m_state))
      m_state = std::move(changed);
  }

  static void stitch(State& state)
  {
    Gap_closer<Point> close(state.soup, state.changes.tolerance);
    state.changes.number_of_stitched_edges = close();
    append(state.changes.degenerate_faces, close.dropped());
  }

  // The order of the faces stays.
  void unfold(State& state) const
  {
    const std::set<std::size_t> before = used_vertices(state.soup);
    state.changes.unfolded_faces = Triangle_unfolder<Point>(state.soup, state.changes.tolerance)();
    std::stable_sort(state.soup.triangles.begin(), state.soup.triangles.end(),
                     [](const Sourced_triangle& s, const Sourced_triangle& t) { return s.source < t.source; });
    const std::set<std::size_t> after = used_vertices(state.soup);
    for(const std::size_t v : before)
      if(after.count(v) == 0)
        state.changes.unfolded_vertices.push_back(m_surface.file_vertex(v));
  }

  static std::set<std::size_t> used_vertices(const Soup& soup)
  {
    std::set<std::size_t> vertices;
    for(const Sourced_triangle& t : soup.triangles)
      vertices.insert(t.begin(), t.end());
    return vertices;
  }

  // The points stay in their places; merged ones are no longer used.
  void merge_points(State& state) const
  {
    const double tolerance = state.changes.tolerance;
    const auto flat = [&](const double x) { return std::abs(x) <= tolerance ? 0. : x; };
    std::vector<Point>& points = state.soup.points;
    for(std::size_t v = 0; v < points.size(); ++v)
    {
      const Point p(flat(points[v].x()), flat(points[v].y()), flat(points[v].z()));
      if(p != points[v])
        state.changes.flattened_vertices.push_back(m_surface.file_vertex(v));
      points[v] = p;
    }
    const std::vector<std::size_t> first = first_close_points(points, tolerance);
    for(std::size_t v = 0; v < points.size(); ++v)
      if(first[v] != v)
        state.changes.merged_vertices.push_back({{ m_surface.file_vertex(v), m_surface.file_vertex(first[v]) }});
    rename_vertices(state.soup, first);
  }

  static void rename_vertices(Soup& soup, const std::vector<std::size_t>& names)
  {
    for(Sourced_triangle& t : soup.triangles)
      for(std::size_t& v : t)
        v = names[v];
  }

  // returns whether there was anything to do, and a way to do it
  bool refine()
  {
    const bool is_needed = can_resolve_intersections && m_state.intersections > 0;
    for(int i = 0; can_resolve_intersections && i < max_number_of_refinements && m_state.intersections > 0; ++i)
    {
      State refined = m_state;
      resolve_intersections(refined.soup);
      rename_vertices(refined.soup, first_at_same_point(refined.soup.points));
      Degenerate_triangle_dissolver<Point> dissolve(refined.soup);
      dissolve();
      unite_equal_triangles(refined.soup);
      judge(refined);
      if(i > 0 && refined.intersections >= m_state.intersections)
        break; // they would become more and more
      m_state = std::move(refined);
    }
    return is_needed;
  }

  std::map<std::size_t, std::size_t> number_of_parts() const
  {
    std::map<std::size_t, std::size_t> number;
    for(const Sourced_triangle& t : m_state.soup.triangles)
      ++number[t.source];
    return number;
  }

  // the sources of which no part is left
  std::vector<std::size_t> sources_gone(const std::map<std::size_t, std::size_t>& before) const
  {
    const std::map<std::size_t, std::size_t> after = number_of_parts();
    std::vector<std::size_t> gone;
    for(const auto& source : before)
      if(after.count(source.first) == 0)
        gone.push_back(source.first);
    return gone;
  }

  void fuse()
  {
    const auto before = number_of_parts();
    m_state.changes.is_fused = Body_fuser<Point>(m_state.soup)();
    m_state.changes.inner_faces = sources_gone(before);
    m_state.open_edges = open_edges(m_state.soup.triangles).size();
  }

  void drop_dust()
  {
    const auto before = number_of_parts();
    std::vector<bool> is_part;
    for(const Sourced_triangle& t : m_state.soup.triangles)
      is_part.push_back(before.at(t.source) > 1);
    m_state.changes.number_of_dust_regions = Dust_dropper<Point>(m_state.soup)(is_part, m_state.changes.tolerance);
    m_state.changes.dust_faces = sources_gone(before);
    m_state.open_edges = open_edges(m_state.soup.triangles).size();
  }

  // makes the surface of the soup
  void store()
  {
    const std::size_t number_of_old_points = m_surface.points.size();
    Repair_changes& changes = m_state.changes;
    changes.open_edges[1] = m_state.open_edges;
    changes.intersections[1] = m_state.intersections;
    list_faces();

    Surface<Point> repaired = make_surface(m_state.soup.points, m_state.soup.triangles);
    for(std::size_t& v : repaired.file_vertices)
    {
      changes.number_of_new_points += v >= number_of_old_points;
      v = m_surface.file_vertex(v);
    }
    for(std::size_t f = 0; f < repaired.faces.size(); ++f)
    {
      const std::size_t source = m_state.soup.triangles[f].source;
      repaired.file_faces[f] = m_surface.file_face(source);
      repaired.patches[f] = m_surface.patches[source];
    }
    m_surface.points.swap(repaired.points);
    m_surface.faces.swap(repaired.faces);
    m_surface.file_faces.swap(repaired.file_faces);
    m_surface.file_vertices.swap(repaired.file_vertices);
    m_surface.patches.swap(repaired.patches);
  }

  // A face of which a part is left is not gone.
  void list_faces()
  {
    Repair_changes& changes = m_state.changes;
    const std::map<std::size_t, std::size_t> parts = number_of_parts();
    for(const auto& face : parts)
      if(face.second > 1)
      {
        changes.divided_faces.push_back(face.first);
        changes.number_of_parts += face.second;
      }
    for(auto* list : { &changes.degenerate_faces, &changes.duplicate_faces })
    {
      std::sort(list->begin(), list->end());
      const auto end = std::remove_if(list->begin(), std::unique(list->begin(), list->end()),
                                      [&](const std::size_t f) { return parts.count(f) > 0; });
      list->erase(end, list->end());
    }
    for(auto* list : { &changes.degenerate_faces, &changes.duplicate_faces, &changes.reversed_faces,
                       &changes.unfolded_faces, &changes.divided_faces, &changes.inner_faces, &changes.dust_faces })
      for(std::size_t& f : *list)
        f = m_surface.file_face(f);
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_REPAIR_SURFACE_H

#ifndef BOUNDARY_RECOVERY_3_PROGRAM_SURFACE_CHANGES_H
#define BOUNDARY_RECOVERY_3_PROGRAM_SURFACE_CHANGES_H

#include "boundary_loops.h"

#include <array>
#include <cstddef>
#include <vector>

// What was done to a surface before it is meshed: data only, for all who tell of it.

// What a repair changed; vertices and faces by their numbers in the file, in ascending order.
struct Repair_changes
{
  bool is_possible = false;                 // all faces are triangles with points
  double tolerance = 0;
  bool is_tolerance_used = false;           // only where that helps
  std::vector<std::array<std::size_t, 2> > merged_vertices; // a vertex, and the one in whose place it is now
  std::vector<std::size_t> flattened_vertices;              // those that got a coordinate 0
  std::vector<std::size_t> degenerate_faces;                // that are gone
  std::vector<std::size_t> duplicate_faces;                 // that are gone
  std::vector<std::size_t> reversed_faces;
  std::size_t number_of_stitched_edges = 0; // that were divided at points close to them
  std::vector<std::size_t> unfolded_faces;                  // that made way for others with the same border
  std::vector<std::size_t> unfolded_vertices;               // that are gone, inside of such a border
  std::vector<std::size_t> divided_faces;
  std::size_t number_of_parts = 0;          // of the divided faces
  std::size_t number_of_new_points = 0;     // where triangles intersected
  bool is_fusion_wanted = false, is_fused = false;
  std::vector<std::size_t> inner_faces;                     // that are gone, by the fusion
  std::size_t number_of_dust_regions = 0;   // that became a part of what is beside them
  std::vector<std::size_t> dust_faces;                      // that are gone with them
  std::array<std::size_t, 2> open_edges = {{ 0, 0 }};       // before and after
  std::array<std::size_t, 2> intersections = {{ 0, 0 }};    // before and after
};

// What a remeshing changed.
struct Remeshing_changes
{
  bool is_possible = false;       // the surface is valid
  bool is_too_fine = false;       // what is asked for
  bool is_remeshed = false;       // and so is the new one
  double tolerance = 0;           // how far from each other the surfaces may be
  double largest_edge = 0;        // how long edges may be
  std::array<std::size_t, 2> number_of_triangles = {{ 0, 0 }}; // before and after
  std::array<double, 2> smallest_angle = {{ 0, 0 }};           // of the triangles, in degrees, before and after
  std::array<double, 2> distances = {{ 0, 0 }};                // from the new surface to the old one, and back
  std::size_t number_of_attempts = 0;
  std::size_t number_of_kept_triangles = 0;                    // as anything else would intersect or be too far away
};

// What became of a loop.
enum class Hole_state { closed, too_long, chain, not_filled, crossing };

inline const char* to_string(const Hole_state state)
{
  switch(state)
  {
    case Hole_state::closed: return "closed";
    case Hole_state::too_long: return "it is longer than allowed";
    case Hole_state::chain: return "it does not close";
    case Hole_state::not_filled: return "there is no filling of triangles that have an area and are not there yet";
    case Hole_state::crossing: return "its filling would cross the surface";
  }
  return "";
}

// A loop, what became of it, and the triangles that close it.
struct Hole
{
  Boundary_loop loop;
  Hole_state state = Hole_state::closed;
  std::vector<std::size_t> neighbors;                   // the triangle at each edge of the loop
  std::vector<std::vector<std::size_t> > triangles;
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_SURFACE_CHANGES_H

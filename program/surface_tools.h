#ifndef BOUNDARY_RECOVERY_3_PROGRAM_SURFACE_TOOLS_H
#define BOUNDARY_RECOVERY_3_PROGRAM_SURFACE_TOOLS_H

#include "surface.h"
#include "surface_changes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <string>
#include <vector>

// What is done to surfaces before they are meshed, compiled once for all the programs.

typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Input_point;
typedef Surface<Input_point>                                         Input_surface;

// returns `false` and says why if the file cannot be read
bool read_input_surface(const std::string& file, Input_surface& surface, std::string& message);

// divides polygons into triangles, also those that are not flat if these are allowed
void divide_polygons(Input_surface& surface, bool are_bent_allowed);

// makes a valid surface, as far as that is possible; see `Surface_repairer`
Repair_changes repair(Input_surface& surface, double tolerance, bool fuses);

// closes loops of open edges that are not longer; returns all loops
std::vector<Hole> close_holes(Input_surface& surface, double max_length);

// replaces the triangles by others with better angles; edges above `angle` degrees stay. See `Surface_remesher`
Remeshing_changes remesh(Input_surface& surface, double angle, double largest_edge);

// divides a surface that has no patches at edges above `angle` degrees
void divide_into_patches(Input_surface& surface, double angle);

#endif // BOUNDARY_RECOVERY_3_PROGRAM_SURFACE_TOOLS_H

// The Delaunay triangulation of the points of an input, its constraints, and what recoveries with Steiner points share.

#ifndef BR3_TEST_STEINER_SCENE_H
#define BR3_TEST_STEINER_SCENE_H

#include "brute_force_input_br3.h"

#include <CGAL/Boundary_recovery_3/Meshing_visitor_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/lost/Recovery_state_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Constraint_parts_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Steiner_ledger_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Mesh_visitor_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <set>
#include <vector>

namespace br3_test {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Scene_kernel;
typedef CGAL::Delaunay_triangulation_3<Scene_kernel>        Scene_triangulation;

// The visitor of scenes that need none.
struct Silent_scene_visitor
  : public CGAL::Default_meshing_visitor_3
{
  explicit Silent_scene_visitor(const Scene_triangulation&) { }
};

// The visitor is constructed from the triangulation.
template <typename Visitor_>
struct Steiner_scene
{
  typedef Visitor_                                                            Visitor;
  typedef Scene_triangulation                                                 Tr;
  typedef Tr::Vertex_handle                                                   Vertex_handle;
  typedef Tr::Cell_handle                                                     Cell_handle;
  typedef CGAL::Boundary_recovery_3::internal::Constraints_3<Tr>              Constraints;
  typedef CGAL::Boundary_recovery_3::internal::Steiner_ledger_3<Tr>           Ledger;
  typedef CGAL::Boundary_recovery_3::internal::Vertex_predicates_3<Tr>        Predicates;
  typedef CGAL::Boundary_recovery_3::internal::Any_visitor_3<Tr, Visitor&>    Any_visitor;
  typedef CGAL::Boundary_recovery_3::internal::Recovery_context<Tr>           Context;
  typedef CGAL::Boundary_recovery_3::internal::Recovery_state_3<Tr>           State;
  typedef std::set<std::set<const void*> >                                    Cells; // by their vertices

  explicit Steiner_scene(const Plc& plc)
    : vertices(insert(plc)), ledger(constraints), predicates(tr, &ledger.positions()), visitor(tr),
      any_visitor(visitor), context(any_visitor), state(tr, predicates, constraints, context)
  {
    for(const Simplex& e : plc.edges)
      constraints.insert(vertices[e[0]], vertices[e[1]]);
    for(const Simplex& t : plc.triangles)
      constraints.insert(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
  }

  Cells cells() const
  {
    Cells result;
    for(const Cell_handle c : tr.all_cell_handles())
      result.insert({ &*c->vertex(0), &*c->vertex(1), &*c->vertex(2), &*c->vertex(3) });
    return result;
  }

  bool is_valid() const { return CGAL::Boundary_recovery_3::internal::is_mesh_valid(tr, predicates); }

  // Whether each constraint is a union of mesh simplices.
  bool is_conforming() const
  {
    const CGAL::Boundary_recovery_3::internal::Constraint_parts_3<Tr> parts(tr, ledger);
    for(std::size_t e = 0; e < constraints.edges().size(); ++e)
      if(parts.of_edge(e).empty())
        return false;
    for(std::size_t f = 0; f < constraints.facets().size(); ++f)
      if(parts.of_facet(f).empty())
        return false;
    return true;
  }

  Tr tr;
  const std::vector<Vertex_handle> vertices;
  Constraints constraints;
  Ledger ledger;
  const Predicates predicates;
  Visitor visitor;
  Any_visitor any_visitor; // hands on everything to `visitor`
  Context context;
  State state;

private:
  std::vector<Vertex_handle> insert(const Plc& plc)
  {
    std::vector<Vertex_handle> result;
    for(const Coordinates& c : plc.points)
      result.push_back(tr.insert(Scene_kernel::Point_3(c[0], c[1], c[2])));
    return result;
  }
};

} // namespace br3_test

#endif // BR3_TEST_STEINER_SCENE_H

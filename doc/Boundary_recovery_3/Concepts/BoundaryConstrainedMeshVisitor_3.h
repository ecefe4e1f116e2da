/*!
\ingroup PkgBoundaryRecovery3Concepts
\cgalConcept

The concept `BoundaryConstrainedMeshVisitor_3` describes what is told about the making of a mesh while it runs, and
asked: what is told about the recovery of the boundary, and the same for the steps after it. All calls come from the
thread that called the mesher.

The phases after the recovery are `domain_marking`, `forecast`, `field_point_insertion`, and `quality_improvement`, in
this order, each of them once at most. The triangulation is valid at each call.

A member may throw. The exception reaches the caller of the mesher, with a valid triangulation.

A model that cares for few of the members is derived from `CGAL::Default_boundary_constrained_mesh_visitor_3`, and hides
those. A member that is hidden hides the overloads of its name for the recovery, too; they come back by a
using-declaration.

\cgalRefines{BoundaryRecoveryVisitor_3}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Default_boundary_constrained_mesh_visitor_3}
\cgalHasModelsEnd

\sa `CGAL::make_boundary_constrained_mesh_3()`
\sa `CGAL::insert_field_points()`
\sa `CGAL::improve_mesh_quality()`
*/
class BoundaryConstrainedMeshVisitor_3
{
public:
  /// \name Phases
  /// @{

  /*!
  is called before a phase starts.
  */
  void on_phase_begin(CGAL::Boundary_recovery_3::Meshing_phase phase);

  /*!
  is called after a phase ended, also where it was stopped, with its duration and the sizes of the triangulation; after
  the forecast, with those that are to be expected.
  */
  void on_phase_end(const CGAL::Boundary_recovery_3::Meshing_phase_report& report);

  /*!
  is called inside a phase from time to time: about `done` of `total` is done. Inside a phase, the quotient never falls.
  The phase `domain_marking` does not call it.
  */
  void on_progress(CGAL::Boundary_recovery_3::Meshing_phase phase, std::size_t done, std::size_t total);

  /// @}

  /// \name Stopping
  /// @{

  /*!
  is asked again and again, between the phases and inside of them. Once it returned `false`, it is not asked again, and
  the work stops soon, with a valid triangulation.
  */
  bool go_further();

  /// @}
};

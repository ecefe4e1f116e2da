/*!
\ingroup PkgBoundaryRecovery3Concepts
\cgalConcept

The concept `HoleRemeshingVisitor_3` describes what is told about the remeshing of holes while it runs, and asked. All
calls come from the thread that called the function.

The phases are `selection`, `recovery`, `filling`, `improvement`, and `sewing`, in this order. Those from `recovery` to
`improvement` run again if holes grow since cells at their boundaries stayed bad.

A member may throw. The exception reaches the caller, whose mesh is unchanged then.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Default_hole_remeshing_visitor_3}
\cgalHasModelsEnd

\sa `CGAL::remesh_holes()`
\sa `CGAL::remesh_cells()`
*/
class HoleRemeshingVisitor_3
{
public:
  /// \name Phases
  /// @{

  /*!
  is called before a phase starts.
  */
  void on_phase_begin(CGAL::Boundary_recovery_3::Hole_remeshing_phase phase);

  /*!
  is called after a phase ended, also where it was stopped, with its duration and the number of holes.
  */
  void on_phase_end(const CGAL::Boundary_recovery_3::Hole_remeshing_phase_report& report);

  /*!
  is called inside the phases from `recovery` to `improvement`, after each hole: `done` of `total` are done. In the
  phase `recovery`, holes that have grown make another round, which is counted by itself.
  */
  void on_progress(CGAL::Boundary_recovery_3::Hole_remeshing_phase phase, std::size_t done, std::size_t total);

  /// @}

  /// \name Stopping
  /// @{

  /*!
  is asked again and again, before the phases and inside of them, but not while old and new are put together. Once it
  returned `false`, it is not asked again, and the work stops soon.
  */
  bool go_further();

  /// @}
};

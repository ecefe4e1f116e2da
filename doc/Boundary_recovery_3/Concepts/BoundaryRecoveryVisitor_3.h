/*!
\ingroup PkgBoundaryRecovery3Concepts
\cgalConcept

The concept `BoundaryRecoveryVisitor_3` describes what is told about a boundary recovery while it runs, and asked:
progress, the cells that go and come, and whether to go on. All calls come from the thread that called the recovery.

It is told about the cells that go and come, too. The coordinates of Steiner points that it sees may be rounded ones
until the end, and cells may be inverted by that. What the insertion of input points replaces is not announced.

A member may throw. The exception reaches the caller of the recovery, with a valid triangulation: as flips left it, and
without Steiner points if these were not finished. The visitor is not told about what is put back then.

A model that cares for few of the members is derived from `CGAL::Default_boundary_recovery_visitor_3`, and hides
those.

A visitor that is given as `std::ref(v)` is called itself, else a copy of it is.

\cgalRefines{CellReplacementVisitor_3,CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Default_boundary_recovery_visitor_3}
\cgalHasModels{CGAL::Boundary_recovery_3::Mesh_indices_keeper_3}
\cgalHasModelsEnd

\sa `CGAL::recover_boundary()`
\sa `CGAL::Constrained_boundary_recovery_3`
*/
class BoundaryRecoveryVisitor_3
{
public:
  /// \name Phases
  /// @{

  /*!
  is called before a phase starts. Phases that have nothing to do are left out.
  */
  void on_phase_begin(CGAL::Boundary_recovery_3::Recovery_phase phase);

  /*!
  is called after a phase ended, with its duration and with what was lost then.
  */
  void on_phase_end(const CGAL::Boundary_recovery_3::Phase_report& report);

  /*!
  is called inside a phase whenever one more item of a pass was treated: `done` of `total`. An item is a lost
  constraint, or a Steiner point in the phases `steiner_splitting` and `steiner_suppression`; in the latter, `done`
  counts the points that are gone, which may be none. Most phases have several passes. The phases `insertion`,
  `search` and `recount` do not call it.
  */
  void on_progress(CGAL::Boundary_recovery_3::Recovery_phase phase, std::size_t done, std::size_t total);

  /// @}

  /// \name Stopping
  /// @{

  /*!
  is asked again and again between attempts, and while the input is searched for defects. Once it returned `false`, it
  is not asked again, and the recovery stops soon, with a valid triangulation.
  */
  bool go_further();

  /// @}
};

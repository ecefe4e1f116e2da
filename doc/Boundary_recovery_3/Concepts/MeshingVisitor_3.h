/*!
\ingroup PkgBoundaryRecovery3Concepts
\cgalConcept

The concept `MeshingVisitor_3` describes an object that watches the work of a function of this package, and can stop it.
A visitor is told of phases, of progress, and of cells of the triangulation that are replaced, and it is asked whether
to go on. All calls come from the thread that called the function, with two exceptions, in which several threads call,
one at a time: while sub-domains are meshed, they call `on_progress()` and `go_further()`; while several threads change
one mesh, see `number_of_threads`, they call all members but those of phases, and meanwhile others change other cells.

A visitor must not change the triangulation, but may write to the data of new cells. It may read the triangulation,
whose data structure is valid; only in `before_cells_removal()`, vertices that are about to get their first cells have
none. Until the recovery ends, coordinates of Steiner points may be rounded, and the rounding may invert cells.

A member may throw. The exception reaches the caller, and the triangulation is valid. After a recovery, it is as the
flips left it, without Steiner points if their phases were not finished; the visitor is not told of the cells that are
put back then. A mesh whose holes are remeshed is unchanged.

A model that needs few of the members is derived from `CGAL::Default_meshing_visitor_3`, and hides these members.

If a visitor `v` is passed as `std::ref(v)`, the object itself is called; otherwise a copy is called.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Default_meshing_visitor_3}
\cgalHasModels{CGAL::Boundary_recovery_3::Mesh_indices_keeper_3}
\cgalHasModelsEnd

\sa `CGAL::recover_boundary()`
\sa `CGAL::Constrained_boundary_recovery_3`
\sa `CGAL::Shell_transformation_3`
\sa `CGAL::insert_field_points()`
\sa `CGAL::improve_mesh_quality()`
\sa `CGAL::make_boundary_constrained_mesh_3()`
\sa `CGAL::remesh_holes()`
\sa `CGAL::remesh_cells()`
*/
class MeshingVisitor_3
{
public:
  /// \name Phases
  /// @{

  /*!
  is called before a phase starts. Phases of a recovery that have nothing to do are left out. Phases of the meshing come
  once at most. In the remeshing of holes, the phases from `hole_recovery` to `hole_improvement` run again if holes grow
  because cells at their boundaries stayed bad.
  */
  void on_phase_begin(CGAL::Boundary_recovery_3::Phase phase);

  /*!
  is called after a phase ended, or was stopped. The report has the duration and, by the kind of the phase, the numbers
  of lost constraints, the size of the mesh, or the number of holes; after the phase `forecast`, it has the expected
  size of the mesh.
  */
  void on_phase_end(const CGAL::Boundary_recovery_3::Phase_report& report);

  /*!
  is called inside a phase: `done` of `total` items are done.

  In a recovery, the call comes after each item of a pass, and most phases have several passes. An item is a lost
  constraint, or a Steiner point in the phases `steiner_splitting` and `steiner_suppression`; in `steiner_suppression`,
  `done` counts the points that are gone, which may be none. In the remeshing of holes, the call comes after each hole;
  in the phase `hole_recovery`, holes that have grown make another round with a count of its own. In the meshing, calls
  come from time to time, and the quotient of `done` and `total` never falls.

  The phases `insertion`, `search`, `recount`, `domain_marking`, `forecast`, `decomposition`, `hole_selection` and
  `hole_sewing` do not call it.
  */
  void on_progress(CGAL::Boundary_recovery_3::Phase phase, std::size_t done, std::size_t total);

  /// @}

  /// \name Stopping
  /// @{

  /*!
  is asked again and again: between phases, inside phases, and while the input is searched for defects, but not while a
  remeshing of holes puts old and new cells together. After the first `false`, it is not asked again, and the work stops
  soon, with a valid triangulation. A mesh whose holes are remeshed is returned unchanged.
  */
  bool go_further();

  /// @}

  /// \name Replacement of Cells
  /// A visitor is not told of cells that the insertion of input points replaces, of cells of sub-domains, and of cells
  /// of holes that are remeshed.
  /// @{

  /*!
  is called before a replacement removes cells from the triangulation.

  \tparam CellRange a model of `ConstRange` whose value type is the cell handle of the triangulation. Infinite cells
  may be in it.
  */
  template <typename CellRange>
  void before_cells_removal(const CellRange& cells);

  /*!
  is called after a replacement has put cells into the triangulation. They cover the same space as the cells of the last
  `before_cells_removal()` that came from the same thread.

  \tparam CellRange a model of `ConstRange` whose value type is the cell handle of the triangulation. Infinite cells
  may be in it.
  */
  template <typename CellRange>
  void after_cells_creation(const CellRange& cells);

  /// @}
};

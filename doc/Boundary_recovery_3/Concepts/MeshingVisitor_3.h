/*!
\ingroup PkgBoundaryRecovery3Concepts
\cgalConcept

The concept `MeshingVisitor_3` describes what is told about the work while it runs, and asked: phases, progress, whether
to go on, and the cells of the triangulation that go and come. All calls come from the thread that called the function;
only while sub-domains are meshed, `on_progress()` and `go_further()` are called by several threads, one at a time.

A visitor must not change the triangulation. It may look at it, and it sees a valid data structure; only in
`before_cells_removal()`, vertices that are about to get their first cells have none. It may write to the cells that
came. The coordinates of Steiner points that it sees may be rounded ones until the recovery ends, and cells may be
inverted by that.

A member may throw. The exception reaches the caller, with a valid triangulation: of a recovery, as flips left it, and
without Steiner points if these were not finished. The visitor is not told about what is put back then. A mesh of which
holes are remeshed is unchanged.

A model that cares for few of the members is derived from `CGAL::Default_meshing_visitor_3`, and hides those.

A visitor that is given as `std::ref(v)` is called itself, else a copy of it is.

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
  is called before a phase starts. Phases of a recovery that have nothing to do are left out; those of the meshing come
  once at most. Of the remeshing of holes, the phases from `hole_recovery` to `hole_improvement` run again if holes grow
  since cells at their boundaries stayed bad.
  */
  void on_phase_begin(CGAL::Boundary_recovery_3::Phase phase);

  /*!
  is called after a phase ended, also where it was stopped, with its duration, and what was lost then, how large the
  mesh was, or how many holes there were; after the forecast, how large the mesh is expected to be.
  */
  void on_phase_end(const CGAL::Boundary_recovery_3::Phase_report& report);

  /*!
  is called inside a phase: `done` of `total` is done.

  In a recovery, that is whenever one more item of a pass was treated: a lost constraint, or a Steiner point in the
  phases `steiner_splitting` and `steiner_suppression`; in the latter, `done` counts the points that are gone, which may
  be none. Most phases have several passes. In the remeshing of holes, it is after each hole; in the phase
  `hole_recovery`, holes that have grown make another round, which is counted by itself. In the meshing, it is from time
  to time, and the quotient never falls.

  The phases `insertion`, `search`, `recount`, `domain_marking`, `forecast`, `decomposition`, `hole_selection` and
  `hole_sewing` do not call it.
  */
  void on_progress(CGAL::Boundary_recovery_3::Phase phase, std::size_t done, std::size_t total);

  /// @}

  /// \name Stopping
  /// @{

  /*!
  is asked again and again, between the phases and inside of them, and while the input is searched for defects, but not
  while old and new are put together in a remeshing. Once it returned `false`, it is not asked again, and the work stops
  soon, with a valid triangulation; a mesh of which holes are remeshed is returned as it was.
  */
  bool go_further();

  /// @}

  /// \name Replacement of Cells
  /// What the insertion of input points replaces is not announced, nor are cells of sub-domains, or of holes that are
  /// remeshed.
  /// @{

  /*!
  is called before cells are removed from the triangulation by a replacement.

  \tparam CellRange a model of `ConstRange` whose value type is the cell handle of the triangulation. Infinite cells
  may be in it.
  */
  template <typename CellRange>
  void before_cells_removal(const CellRange& cells);

  /*!
  is called after cells came into the triangulation. They cover what the cells of the last `before_cells_removal()`
  covered.

  \tparam CellRange a model of `ConstRange` whose value type is the cell handle of the triangulation. Infinite cells
  may be in it.
  */
  template <typename CellRange>
  void after_cells_creation(const CellRange& cells);

  /// @}
};

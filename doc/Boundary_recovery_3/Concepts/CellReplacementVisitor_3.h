/*!
\ingroup PkgBoundaryRecovery3Concepts
\cgalConcept

The concept `CellReplacementVisitor_3` describes what is told when cells of a triangulation are replaced: for data that
is attached to cells.

A visitor must not change the triangulation. It may look at it, and it sees a valid data structure; only in
`before_cells_removal()`, vertices that are about to get their first cells have none. It may write to the cells that
came.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Default_cell_replacement_visitor_3}
\cgalHasModels{CGAL::Default_boundary_recovery_visitor_3}
\cgalHasModelsEnd

\sa `CGAL::Shell_transformation_3`
\sa `BoundaryRecoveryVisitor_3`
*/
class CellReplacementVisitor_3
{
public:
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
};

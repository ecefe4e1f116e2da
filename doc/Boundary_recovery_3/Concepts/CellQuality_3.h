/*!
\ingroup PkgBoundaryRecovery3Concepts
\cgalConcept

The concept `CellQuality_3` describes a measure of the shape of tetrahedra. `CGAL::improve_mesh_quality()` makes a
change only if the worst of the new cells is better than the worst of the old cells.

A quality is a number, and larger is better. It is computed from the coordinates of the corners in floating point
numbers. Qualities do not decide which meshes are valid: exact predicates do.

The members are called millions of times for large meshes. A model may have a further member `of_two_cells()`, as
`Dihedral_angle_quality_3` has, which computes the qualities of two cells in less time than two calls take. The
improvement calls this member if it exists. Both qualities must be equal, bit for bit, to the qualities of single calls.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Boundary_recovery_3::Dihedral_angle_quality_3}
\cgalHasModels{CGAL::Boundary_recovery_3::Volume_length_quality_3}
\cgalHasModelsEnd

\sa `CGAL::improve_mesh_quality()`
*/
class CellQuality_3
{
public:
  /// \name Operations
  /// @{

  /*!
  returns the quality of the cell with these corners. The best cell has the quality 1, up to rounding. A cell that is
  flat or not positively oriented has a quality that is not positive. Up to rounding, the quality must not depend on the
  order of the corners, as long as the orientation is the same, nor on the position, rotation and scale of the cell.
  */
  double operator()(const std::array<std::array<double, 3>, 4>& corners) const;

  /*!
  returns the largest quality of all cells whose smallest dihedral angle is `degrees`. The angle `degrees` is from 0 to
  70.53, the angle of the regular tetrahedron. The quality grows with the angle: with this angle as target, a cell of
  this quality is good enough.
  */
  double of_angle(double degrees) const;

  /// @}
};

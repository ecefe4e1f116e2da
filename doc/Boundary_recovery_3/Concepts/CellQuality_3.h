/*!
\ingroup PkgBoundaryRecovery3Concepts
\cgalConcept

The concept `CellQuality_3` describes what makes a cell of a tetrahedral mesh better than another one, for
`CGAL::improve_mesh_quality()`: there, the worst cell of those that an operation changes has to become better.

A quality is a number, and larger is better. It is computed from the coordinates of the corners in floating point
numbers, since it does not decide which meshes are valid: orientations are decided by exact predicates, whatever the
quality of a cell is.

The members are called millions of times for large meshes. If a model can compute the qualities of two cells in less
time together than one by one, it may have a member `of_two_cells()` for that, as `Dihedral_angle_quality_3` has; it is
used where it exists. The qualities must be the very same.

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
  returns the quality of the cell with these corners: at most 1, up to rounding, for a cell that is as good as can be;
  not positive if the cell is flat or not positively oriented. It must not depend on the order of the corners, as long
  as the orientation is the same, up to rounding, nor on where the cell is, how it is turned, or how large it is.
  */
  double operator()(const std::array<std::array<double, 3>, 4>& corners) const;

  /*!
  returns the quality that a cell has at most if its smallest dihedral angle is `degrees`, where `degrees` is not
  negative, and not larger than the angle of the regular tetrahedron, 70.53. It grows with the angle: a cell of this
  quality is good enough if that angle is the target.
  */
  double of_angle(double degrees) const;

  /// @}
};

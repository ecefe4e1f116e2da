/*!
\ingroup PkgBoundaryRecovery3Concepts
\cgalConcept

The concept `ShellValidity_3` describes which covering meshes of a shell are allowed, and which edges and
facets of the triangulation have to stay: the additional conditions of \cgalCite{CZZ+17}, Section 3.2.

Two conditions are no part of it because they always hold: all tetrahedra of a covering mesh are positively
oriented, decided exactly, and the convex hull does not change. The pieces of a covering mesh are as in
`ShellQuality_3`. Only pieces that the shell does not have yet are judged, its *new entities*: triangles \f$
p_i p_k p_j \f$ of the skirt polygon, and chords \f$ p_i p_j \f$ with their faces \f$ a p_i p_j \f$ and \f$ b
p_i p_j \f$. A condition that also refused what is there already would allow no partial reduction.

A model that has a condition on few of the members is derived from
`CGAL::Boundary_recovery_3::No_shell_validity_3`, and hides those. Several conditions are joined by
`CGAL::Boundary_recovery_3::Shell_validity_conjunction_3`.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Boundary_recovery_3::BRC1}
\cgalHasModels{CGAL::Boundary_recovery_3::BRC2}
\cgalHasModels{CGAL::Boundary_recovery_3::BRC3}
\cgalHasModels{CGAL::Boundary_recovery_3::BRC4}
\cgalHasModels{CGAL::Boundary_recovery_3::Kept_constraints_3}
\cgalHasModels{CGAL::Boundary_recovery_3::No_shell_validity_3}
\cgalHasModels{CGAL::Boundary_recovery_3::Shell_validity_conjunction_3}
\cgalHasModelsEnd

\sa `ShellQuality_3`
\sa `CGAL::Shell_transformation_3`
*/
class ShellValidity_3
{
public:
  /// \name Types
  /// @{

  /*!
  `Shell_3<Tr>` of the namespace `CGAL::Boundary_recovery_3`, where `Tr` is the triangulation type. A model
  may leave this type and the next one out, and be a model for any triangulation, if its members are
  templates.
  */
  typedef unspecified_type Shell;

  /*!
  `Tr::Vertex_handle`.
  */
  typedef unspecified_type Vertex_handle;

  /// @}

  /// \name Conditions on Pieces
  /// They are asked for pieces with positively oriented tetrahedra. The answer must not depend on the rest of
  /// the covering mesh.
  /// @{

  /*!
  returns whether the new face \f$ p_i p_k p_j \f$ is allowed. The positions in the skirt polygon are in
  cyclic order; one of them may be that of the infinite vertex.
  */
  bool is_valid_triangle(const Shell& s, int i, int k, int j) const;

  /*!
  returns whether the new edge \f$ p_i p_j \f$ and the new faces \f$ a p_i p_j \f$ and \f$ b p_i p_j \f$ are
  allowed. All vertices are finite.
  */
  bool is_valid_chord(const Shell& s, int i, int j) const;

  /// @}

  /// \name Condition on the Whole
  /// @{

  /*!
  returns whether the present covering mesh of `s` may be replaced by the one that `k` stands for.

  It is asked once, for the best covering mesh whose pieces are valid. If it is refused, the shell stays as it
  is; no second best one is tried.
  */
  bool is_valid_covering_mesh(const Shell& s, const CGAL::Boundary_recovery_3::Partial_triangulation& k) const;

  /// @}

  /// \name Constraints
  /// What is constrained and in the triangulation is never destroyed. The edges of a constrained facet
  /// have to be constrained, too. The answers must not change while a member of `CGAL::Shell_transformation_3` runs.
  /// @{

  /*!
  returns whether the edge from `u` to `v` has to stay.
  */
  bool is_constrained(Vertex_handle u, Vertex_handle v) const;

  /*!
  returns whether the facet `uvw` has to stay.
  */
  bool is_constrained(Vertex_handle u, Vertex_handle v, Vertex_handle w) const;

  /// @}
};

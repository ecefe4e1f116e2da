/*!
\ingroup PkgBoundaryRecovery3Concepts
\cgalConcept

The concept `ShellValidity_3` describes conditions on covering meshes of a shell, and the edges and facets of the
triangulation that must stay: the additional conditions of \cgalCite{CZZ+17}, Section 3.2.

Two conditions always hold, and are not part of the concept: all tetrahedra of a covering mesh are positively oriented,
by an exact predicate, and the convex hull does not change. The pieces of a covering mesh are those of `ShellQuality_3`.
A model judges *new entities* only, pieces that the shell does not have yet: triangles \f$ p_i p_k p_j \f$ of the skirt
polygon, and chords \f$ p_i p_j \f$ with their faces \f$ a p_i p_j \f$ and \f$ b p_i p_j \f$. A condition on old
entities, too, would allow no partial reduction.

A model with a condition on few kinds of pieces is derived from `CGAL::Boundary_recovery_3::No_shell_validity_3`, and
hides these members. `CGAL::Boundary_recovery_3::Shell_validity_conjunction_3` joins several conditions.

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
  `Shell_3<Tr>` of the namespace `CGAL::Boundary_recovery_3`, where `Tr` is the triangulation type. A model whose
  members are templates may leave out this type and the next one; it is then a model for all triangulations.
  */
  typedef unspecified_type Shell;

  /*!
  `Tr::Vertex_handle`.
  */
  typedef unspecified_type Vertex_handle;

  /// @}

  /// \name Conditions on Pieces
  /// The pieces have positively oriented tetrahedra. The answer must not depend on the rest of the covering mesh.
  /// @{

  /*!
  returns whether the new face \f$ p_i p_k p_j \f$ is allowed. The positions in the skirt polygon are in cyclic order;
  one may be that of the infinite vertex.
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
  returns whether the covering mesh of `k` may replace the present one of `s`.

  The question comes once, for the best covering mesh with valid pieces. If the answer is `false`, the shell stays as it
  is; no second best covering mesh is tried.
  */
  bool is_valid_covering_mesh(const Shell& s, const CGAL::Boundary_recovery_3::Partial_triangulation& k) const;

  /// @}

  /// \name Constraints
  /// Constrained edges and facets of the triangulation are never destroyed. The edges of a constrained facet must be
  /// constrained, too. The answers must not change while a member of `CGAL::Shell_transformation_3` runs.
  /// @{

  /*!
  returns whether the edge from `u` to `v` must stay.
  */
  bool is_constrained(Vertex_handle u, Vertex_handle v) const;

  /*!
  returns whether the facet `uvw` must stay.
  */
  bool is_constrained(Vertex_handle u, Vertex_handle v, Vertex_handle w) const;

  /// @}
};

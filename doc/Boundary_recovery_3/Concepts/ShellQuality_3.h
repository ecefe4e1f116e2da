/*!
\ingroup PkgBoundaryRecovery3Concepts
\cgalConcept

The concept `ShellQuality_3` describes a measure of covering meshes of a shell: the main quality index \f$ Q \f$ of
\cgalCite{CZZ+17}, Section 3.1.

A covering mesh of the shell of an edge \f$ ab \f$ belongs to a partial triangulation of the skirt polygon
\f$ p_0 \ldots p_{m-1} \f$, and consists of these pieces:

- each triangle \f$ p_i p_k p_j \f$ of the partial triangulation: the two tetrahedra between it and \f$ a \f$
and \f$ b \f$;
- each chord \f$ p_i p_j \f$, a side of such a triangle that is not an edge of the skirt polygon: this edge,
and its two faces with \f$ a \f$ and with \f$ b \f$;
- each edge \f$ p_i p_j \f$ of the core: the tetrahedron \f$ a b p_i p_j \f$;
- each vertex \f$ p_i \f$ of the core: the supporting face \f$ a b p_i \f$;
- the supporting edge \f$ ab \f$, unless the core is empty.

A model gives each piece a value. The value of a covering mesh is the combination of the values of its pieces, by the
function \f$ f_Q \f$ of the paper (Eq.\ 2 and 3); larger is better. Dynamic programming finds the best covering mesh,
since `combine()` is monotone.

\f$ Q \f$ is one of three indices that are compared lexicographically (Eq.\ 4). The other two are the same for all
models: \f$ Q' \f$ is 1 if the covering mesh avoids a given face, and 0 otherwise; \f$ Q'' \f$ is larger for a smaller
core. `ShellValidity_3` decides which covering meshes are allowed.

The arguments are a shell of type `CGAL::Boundary_recovery_3::Shell_3`, and positions in its skirt polygon. The members
are called often, also for pieces that become part of no covering mesh, but only for triangles whose tetrahedra are
positively oriented. In a triangle, and in the edges and vertices of a core, one position may be that of the infinite
vertex, `Shell_3::infinite_index()`; in a chord, none.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Boundary_recovery_3::Fewest_intersections_quality_3}
\cgalHasModels{CGAL::Boundary_recovery_3::No_shell_quality_3}
\cgalHasModels{CGAL::Boundary_recovery_3::Worst_element_quality_3}
\cgalHasModelsEnd

\sa `ShellValidity_3`
\sa `CGAL::Shell_transformation_3`
*/
class ShellQuality_3
{
public:
  /// \name Types
  /// @{

  /*!
  The value of a piece or of a covering mesh. The type is default constructible, copyable, and has a strict weak order
  by `operator<`.
  */
  typedef unspecified_type Value;

  /*!
  `Shell_3<Tr>` of the namespace `CGAL::Boundary_recovery_3`, where `Tr` is the triangulation type. A model whose
  members are templates may leave this type out; it is then a model for all triangulations.
  */
  typedef unspecified_type Shell;

  /// @}

  /// \name Constants
  /// @{

  /*!
  The place of the value in the quality vector of [CZZ+17, Eq.\ 4]. `true` stands for \f$ [Q, Q', Q''] \f$: a better
  value wins in spite of a larger degree. `false` stands for \f$ [Q', Q'', Q] \f$: the value decides between covering
  meshes of the same degree only.
  */
  static constexpr bool is_first_in_vector = unspecified_value;

  /// @}

  /// \name Combination
  /// @{

  /*!
  returns the value of no pieces: the neutral element of `combine()`.
  */
  Value best() const;

  /*!
  returns the value of the union of two sets of pieces with the values `x` and `y`: the function \f$ f_Q \f$
  of [CZZ+17, Eq.\ 2].

  The function must be commutative and associative, up to rounding, and monotone: if `x < y`, then
  `combine(y, z) < combine(x, z)` is false for all `z`. Minimum and sum are examples.
  */
  Value combine(Value x, Value y) const;

  /// @}

  /// \name Values of Pieces
  /// @{

  /*!
  returns the value of the triangle \f$ p_i p_k p_j \f$, and of the tetrahedra \f$ p_i p_k p_j b \f$ and
  \f$ p_i p_j p_k a \f$. The positions are in cyclic order.
  */
  Value of_triangle(const Shell& s, int i, int k, int j) const;

  /*!
  returns the value of the edge \f$ p_i p_j \f$ inside the shell, and of the faces \f$ a p_i p_j \f$ and
  \f$ b p_i p_j \f$. The ring from \f$ p_i \f$ to \f$ p_j \f$, in cyclic order, is the triangulated side of the chord.
  */
  Value of_chord(const Shell& s, int i, int j) const;

  /*!
  returns the value of the tetrahedron \f$ a b p_i p_j \f$.
  */
  Value of_core_edge(const Shell& s, int i, int j) const;

  /*!
  returns the value of the supporting face \f$ a b p_i \f$.
  */
  Value of_core_vertex(const Shell& s, int i) const;

  /*!
  returns the value of the supporting edge \f$ ab \f$.
  */
  Value of_supporting_edge(const Shell& s) const;

  /// @}
};

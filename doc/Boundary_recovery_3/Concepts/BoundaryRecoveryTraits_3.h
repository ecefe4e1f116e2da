/*!
\ingroup PkgBoundaryRecovery3Concepts
\cgalConcept

The concept `BoundaryRecoveryTraits_3` describes what the recovery of boundaries asks of the geometric traits class
of the triangulation, and of the one that is given as `geom_traits`.

All predicates have to be exact: every decision rests on them, and there are no tolerances. Constructions need not
be. If `FT` is an exact number type, in the sense of `CGAL::Algebraic_structure_traits<FT>::Is_exact`, Steiner
points are constructed with it. Else positions on constraints are computed with `CGAL::Exact_rational` and converted,
for which the points have to be those of a kernel of \cgal: the type `CGAL::Kernel_traits<Point_3>::Kernel` is a model
of `Kernel` with a Cartesian representation.

Besides what is listed below, the triangulation asks for what the traits concept of its own class asks for. The
concept `SpatialSortingTraits_3` matters only if points are inserted.

\cgalRefines{DelaunayTriangulationTraits_3}
\cgalRefines{SpatialSortingTraits_3}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Exact_predicates_inexact_constructions_kernel}
\cgalHasModels{CGAL::Exact_predicates_exact_constructions_kernel}
\cgalHasModelsEnd

\sa `CGAL::recover_boundary()`
\sa `CGAL::Constrained_boundary_recovery_3`
*/
class BoundaryRecoveryTraits_3
{
public:
  /// \name Types
  /// @{

  /*!
  The point type. A point is constructed from three values of type `double`; it has `x()`, `y()`, `z()`, `bbox()`
  and `operator[]`, which returns the exact coordinates. It has to be the type of the points of the vertices, so there
  are no weights.
  */
  typedef unspecified_type Point_3;

  /*!
  The segment type.
  */
  typedef unspecified_type Segment_3;

  /*!
  The triangle type.
  */
  typedef unspecified_type Triangle_3;

  /// @}

  /// \name Predicates of the Recovery
  /// @{

  /*!
  A predicate with `CGAL::Orientation operator()(Point_3 p, Point_3 q, Point_3 r, Point_3 s)`: the sign of the
  volume of the tetrahedron `pqrs`.
  */
  typedef unspecified_type Orientation_3;

  /*!
  A predicate with `CGAL::Orientation operator()(Point_3 p, Point_3 q, Point_3 r)`, which returns `CGAL::COLLINEAR`
  iff the points are collinear, and `CGAL::Orientation operator()(Point_3 p, Point_3 q, Point_3 r, Point_3 s)`,
  which returns for coplanar points, the first three of them not collinear, whether `r` and `s` are on the same side
  of the line through `p` and `q`.
  */
  typedef unspecified_type Coplanar_orientation_3;

  /*!
  A predicate with `CGAL::Comparison_result operator()(Point_3 p, Point_3 q)`, the lexicographical order.
  */
  typedef unspecified_type Compare_xyz_3;

  /// @}

  /// \name Predicates of the Diagnosis
  /// They look for what is wrong with the input.
  /// @{

  /*!
  A predicate with `bool operator()(Point_3 p, Point_3 q)`.
  */
  typedef unspecified_type Equal_3;

  /*!
  A predicate with `bool operator()(Point_3 p, Point_3 q, Point_3 r)`.
  */
  typedef unspecified_type Collinear_3;

  /*!
  A predicate with `bool operator()(Point_3 p, Point_3 q, Point_3 r)`: whether `q` is between `p` and `r`, known to be
  collinear, or equal to one of them.
  */
  typedef unspecified_type Collinear_are_ordered_along_line_3;

  /*!
  A predicate with `bool operator()(Segment_3 s, Point_3 p)` and `bool operator()(Triangle_3 t, Point_3 p)`.
  */
  typedef unspecified_type Has_on_3;

  /*!
  A predicate with `bool operator()(Segment_3, Segment_3)`, `bool operator()(Triangle_3, Segment_3)` and
  `bool operator()(Triangle_3, Triangle_3)`.
  */
  typedef unspecified_type Do_intersect_3;

  /// @}

  /// \name Constructions of the Diagnosis
  /// @{

  /*!
  A constructor with `Segment_3 operator()(Point_3 p, Point_3 q)`.
  */
  typedef unspecified_type Construct_segment_3;

  /*!
  A constructor with `Triangle_3 operator()(Point_3 p, Point_3 q, Point_3 r)`.
  */
  typedef unspecified_type Construct_triangle_3;

  /*!
  A constructor with `CGAL::Bbox_3 operator()(Point_3 p)`, a box that encloses the exact coordinates.
  */
  typedef unspecified_type Construct_bbox_3;

  /// @}

  /// \name Access to Function Objects
  /// @{

  /// returns a function object of the type `Orientation_3`.
  Orientation_3 orientation_3_object() const;
  /// returns a function object of the type `Coplanar_orientation_3`.
  Coplanar_orientation_3 coplanar_orientation_3_object() const;
  /// returns a function object of the type `Compare_xyz_3`.
  Compare_xyz_3 compare_xyz_3_object() const;
  /// returns a function object of the type `Equal_3`.
  Equal_3 equal_3_object() const;
  /// returns a function object of the type `Collinear_3`.
  Collinear_3 collinear_3_object() const;
  /// returns a function object of the type `Collinear_are_ordered_along_line_3`.
  Collinear_are_ordered_along_line_3 collinear_are_ordered_along_line_3_object() const;
  /// returns a function object of the type `Has_on_3`.
  Has_on_3 has_on_3_object() const;
  /// returns a function object of the type `Do_intersect_3`.
  Do_intersect_3 do_intersect_3_object() const;
  /// returns a function object of the type `Construct_segment_3`.
  Construct_segment_3 construct_segment_3_object() const;
  /// returns a function object of the type `Construct_triangle_3`.
  Construct_triangle_3 construct_triangle_3_object() const;
  /// returns a function object of the type `Construct_bbox_3`.
  Construct_bbox_3 construct_bbox_3_object() const;

  /// @}
};

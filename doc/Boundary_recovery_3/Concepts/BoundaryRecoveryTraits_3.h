/*!
\ingroup PkgBoundaryRecovery3Concepts
\cgalConcept

The concept `BoundaryRecoveryTraits_3` lists the requirements of the boundary recovery on two classes: the geometric
traits class of the triangulation, and the class of the named parameter `geom_traits`.

All predicates must be exact: every decision rests on a predicate, and there are no tolerances. Constructions may be
inexact. If `FT` is an exact number type, in the sense of `CGAL::Algebraic_structure_traits<FT>::Is_exact`, Steiner
points are constructed with `FT`. Otherwise, positions on constraints are computed with `CGAL::Exact_rational` and
converted. In this case, the points must be points of a kernel of \cgal: the type `CGAL::Kernel_traits<Point_3>::Kernel`
is a model of `Kernel` with a Cartesian representation.

The class of the triangulation has requirements of its own, in addition to the list below. The concept
`SpatialSortingTraits_3` matters only if points are inserted.

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
  The point type. A point is constructed from three values of type `double`, and has the members `x()`, `y()`, `z()`,
  `bbox()` and `operator[]`, which returns the exact coordinates. The points of the vertices must have this type, so
  points with weights are excluded.
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
  A predicate with two operators. `CGAL::Orientation operator()(Point_3 p, Point_3 q, Point_3 r)` returns
  `CGAL::COLLINEAR` iff the points are collinear. `CGAL::Orientation operator()(Point_3 p, Point_3 q, Point_3 r, Point_3
  s)` returns whether `r` and `s` are on the same side of the line through `p` and `q`; the points are coplanar, and
  `p`, `q`, `r` are not collinear.
  */
  typedef unspecified_type Coplanar_orientation_3;

  /*!
  A predicate with `CGAL::Comparison_result operator()(Point_3 p, Point_3 q)`, the lexicographical order.
  */
  typedef unspecified_type Compare_xyz_3;

  /// @}

  /// \name Predicates of the Diagnosis
  /// These predicates find defects of the input.
  /// @{

  /*!
  A predicate with `bool operator()(Point_3 p, Point_3 q)`: whether the points are equal.
  */
  typedef unspecified_type Equal_3;

  /*!
  A predicate with `bool operator()(Point_3 p, Point_3 q, Point_3 r)`: whether the points are collinear.
  */
  typedef unspecified_type Collinear_3;

  /*!
  A predicate with `bool operator()(Point_3 p, Point_3 q, Point_3 r)`: whether `q` is between `p` and `r`, or equal to
  one of the two. The points are collinear.
  */
  typedef unspecified_type Collinear_are_ordered_along_line_3;

  /*!
  A predicate with `bool operator()(Segment_3 s, Point_3 p)` and `bool operator()(Triangle_3 t, Point_3 p)`: whether the
  point is on the segment, or on the triangle.
  */
  typedef unspecified_type Has_on_3;

  /*!
  A predicate with `bool operator()(Segment_3, Segment_3)`, `bool operator()(Triangle_3, Segment_3)` and
  `bool operator()(Triangle_3, Triangle_3)`: whether the two have a common point.
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
  A constructor with `CGAL::Bbox_3 operator()(Point_3 p)`: a box that contains the point with its exact coordinates.
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

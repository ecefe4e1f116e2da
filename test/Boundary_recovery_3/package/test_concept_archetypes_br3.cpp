// The concepts of the manual: models that have what is documented, and nothing else, compile and work.

#undef NDEBUG // the checks are assertions, also in a Release build

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Shell_transformation_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/recover_boundary.h>

#include <cassert>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Delaunay_triangulation_3<Kernel>              Triangulation;
typedef CGAL::Surface_mesh<Kernel::Point_3>                 Surface;
typedef Triangulation::Vertex_handle                        Vertex_handle;
typedef Triangulation::Cell_handle                          Cell_handle;

namespace BR3 = CGAL::Boundary_recovery_3;

// BoundaryRecoveryTraits_3 as the argument `geom_traits`, without what the triangulation's own concept asks for
struct Traits
{
  typedef Kernel::Point_3    Point_3;
  typedef Kernel::Segment_3  Segment_3;
  typedef Kernel::Triangle_3 Triangle_3;

  typedef Kernel::Orientation_3          Orientation_3;
  typedef Kernel::Coplanar_orientation_3 Coplanar_orientation_3;
  typedef Kernel::Compare_xyz_3          Compare_xyz_3;
  typedef Kernel::Equal_3                Equal_3;
  typedef Kernel::Collinear_3            Collinear_3;
  typedef Kernel::Collinear_are_ordered_along_line_3 Collinear_are_ordered_along_line_3;
  typedef Kernel::Has_on_3               Has_on_3;
  typedef Kernel::Do_intersect_3         Do_intersect_3;
  typedef Kernel::Construct_segment_3    Construct_segment_3;
  typedef Kernel::Construct_triangle_3   Construct_triangle_3;
  typedef Kernel::Construct_bbox_3       Construct_bbox_3;

  Orientation_3 orientation_3_object() const { return Orientation_3(); }
  Coplanar_orientation_3 coplanar_orientation_3_object() const { return Coplanar_orientation_3(); }
  Compare_xyz_3 compare_xyz_3_object() const { return Compare_xyz_3(); }
  Equal_3 equal_3_object() const { return Equal_3(); }
  Collinear_3 collinear_3_object() const { return Collinear_3(); }
  Collinear_are_ordered_along_line_3 collinear_are_ordered_along_line_3_object() const
  { return Collinear_are_ordered_along_line_3(); }
  Has_on_3 has_on_3_object() const { return Has_on_3(); }
  Do_intersect_3 do_intersect_3_object() const { return Do_intersect_3(); }
  Construct_segment_3 construct_segment_3_object() const { return Construct_segment_3(); }
  Construct_triangle_3 construct_triangle_3_object() const { return Construct_triangle_3(); }
  Construct_bbox_3 construct_bbox_3_object() const { return Construct_bbox_3(); }
};

// MeshingVisitor_3; it holds the recovery to what the concept says about the order of calls
struct Visitor
{
  explicit Visitor(std::size_t number_of_cells) : number_of_cells(number_of_cells) { }

  void on_phase_begin(const BR3::Phase p)
  {
    assert(! in_phase);
    in_phase = true;
    phase = p;
  }

  void on_phase_end(const BR3::Phase_report& report)
  {
    assert(in_phase && report.phase == phase && report.seconds >= 0);
    in_phase = false;
  }

  void on_progress(const BR3::Phase p, const std::size_t done, const std::size_t total)
  {
    assert(in_phase && p == phase && done <= total && total > 0);
    assert(p != BR3::Phase::insertion && p != BR3::Phase::search);
    assert(p != BR3::Phase::recount);
  }

  bool go_further()
  {
    assert(! was_stopped);
    was_stopped = questions_left == 0;
    questions_left -= ! was_stopped;
    return ! was_stopped;
  }

  template <typename CellRange>
  void before_cells_removal(const CellRange& cells)
  {
    for(const Cell_handle c : cells)
      for(int i = 0; i < 4; ++i)
        assert(c->neighbor(i)->has_neighbor(c));
    number_of_cells -= cells.size();
  }

  template <typename CellRange>
  void after_cells_creation(const CellRange& cells)
  {
    for(const Cell_handle c : cells)
      for(int i = 0; i < 4; ++i)
        assert(c->neighbor(i)->has_neighbor(c));
    number_of_cells += cells.size();
  }

  std::size_t number_of_cells;
  std::size_t questions_left = std::size_t(-1);
  bool in_phase = false, was_stopped = false;
  BR3::Phase phase = BR3::Phase::insertion;
};

void recover(const Surface& surface, const BR3::Recovery_mode mode, const std::size_t number_of_questions)
{
  std::vector<Kernel::Point_3> points;
  for(const auto v : vertices(surface))
    points.push_back(surface.point(v));
  Triangulation tr(points.begin(), points.end());

  Visitor visitor(tr.number_of_cells());
  visitor.questions_left = number_of_questions;
  const auto result = CGAL::recover_boundary(tr, surface, CGAL::parameters::recovery_mode(mode),
                                             CGAL::parameters::geom_traits(Traits()).visitor(std::ref(visitor)));
  assert(! visitor.in_phase);
  assert(visitor.number_of_cells == tr.number_of_cells());
  assert(visitor.was_stopped || result || mode == BR3::Recovery_mode::flips_only);
  assert(! visitor.was_stopped || result || result.status == BR3::Recovery_status::stopped);
}

// ShellQuality_3: the number of cells around the edge; fewer are better
struct Quality
{
  typedef BR3::Shell_3<Triangulation> Shell;

  struct Value // no operators but the required one
  {
    int n;
    bool operator<(const Value& other) const { return n < other.n; }
  };
  static constexpr bool is_first_in_vector = true;

  Value best() const { return { 0 }; }
  Value combine(const Value x, const Value y) const { return { x.n + y.n }; }
  Value of_triangle(const Shell&, int, int, int) const { return { 0 }; }
  Value of_chord(const Shell&, int, int) const { return { 0 }; }
  Value of_core_edge(const Shell&, int, int) const { return { -1 }; }
  Value of_core_vertex(const Shell&, int) const { return { 0 }; }
  Value of_supporting_edge(const Shell&) const { return { 0 }; }
};

// ShellValidity_3: one edge has to stay
struct Validity
{
  typedef BR3::Shell_3<Triangulation>  Shell;
  typedef Triangulation::Vertex_handle Vertex_handle;

  bool is_valid_triangle(const Shell&, int, int, int) const { return true; }
  bool is_valid_chord(const Shell&, int, int) const { return true; }
  bool is_valid_covering_mesh(const Shell&, const BR3::Partial_triangulation&) const { return true; }
  bool is_constrained(const Vertex_handle v, const Vertex_handle w) const
  {
    return (v == kept[0] && w == kept[1]) || (v == kept[1] && w == kept[0]);
  }
  bool is_constrained(Vertex_handle, Vertex_handle, Vertex_handle) const { return false; }

  Vertex_handle kept[2];
};

// Three tetrahedra around an edge, which is removed unless it is to stay.
void transform(const bool is_kept)
{
  Triangulation tr;
  const Vertex_handle a = tr.insert(Kernel::Point_3(0, 0, 1)), b = tr.insert(Kernel::Point_3(0, 0, -1));
  tr.insert(Kernel::Point_3(4, 0, 0));
  tr.insert(Kernel::Point_3(-2, 3, 0));
  tr.insert(Kernel::Point_3(-2, -3, 0));
  assert(tr.number_of_finite_cells() == 3);

  Validity validity;
  if(is_kept)
  {
    validity.kept[0] = b;
    validity.kept[1] = a;
  }
  typedef CGAL::Shell_transformation_3<Triangulation, Quality, Validity> Transformation;
  Transformation transformation(tr, Quality(), validity);
  Triangulation::Edge ab;
  const bool is_there = tr.is_edge(a, b, ab.first, ab.second, ab.third);
  assert(is_there);
  const Transformation::Outcome outcome = transformation(ab);
  assert(outcome == (is_kept ? Transformation::UNCHANGED : Transformation::REMOVED));
  assert(tr.number_of_finite_cells() == (is_kept ? 3u : 2u));
}

int main()
{
  for(const std::string name : { "gear", "schoenhardt" })
  {
    Surface surface;
    const bool is_read = CGAL::IO::read_polygon_mesh(CGAL::data_file_path("meshes/" + name + "_br3.off"), surface);
    assert(is_read);
    for(const BR3::Recovery_mode mode : { BR3::Recovery_mode::constrained, BR3::Recovery_mode::conforming,
                                          BR3::Recovery_mode::flips_only })
      for(const std::size_t number_of_questions : { std::size_t(0), std::size_t(3), std::size_t(20), std::size_t(-1) })
        recover(surface, mode, number_of_questions);
  }
  transform(true);
  transform(false);
}

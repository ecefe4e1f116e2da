// Exact_mesh_checker agrees with good results in all modes with both kernels, and notices faults of many kinds.

#include "recovered_mesh_br3.h"
#include "recovery_of_oracles_br3.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/recover_boundary.h>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>
#include <type_traits>
#include <vector>

using namespace br3_test;

typedef CGAL::Exact_predicates_inexact_constructions_kernel Epick;
typedef CGAL::Exact_predicates_exact_constructions_kernel   Epeck;
typedef CGAL::Boundary_recovery_3::Recovery_mode            Mode;
typedef Exact_mesh_checker::Kind                            Kind;

struct Case
{
  Indexed_mesh mesh;
  Kind kind;
};

std::string complaint_about(const Case& c)
{
  try {
    Exact_mesh_checker(c.mesh, c.kind)();
  } catch(const Complaint& complaint) {
    return complaint.what();
  }
  return "";
}

template <typename Kernel>
Case recover(const std::string& file, const Mode mode)
{
  std::vector<typename Kernel::Point_3> points;
  std::vector<std::array<std::size_t, 3> > faces;
  require(CGAL::IO::read_polygon_soup(file, points, faces), "the data set cannot be read");
  std::vector<Coordinates> coordinates;
  for(const auto& p : points)
    coordinates.push_back({ { CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()) } });

  typedef CGAL::Delaunay_triangulation_3<Kernel> Triangulation;
  Triangulation tr;
  const auto result = CGAL::recover_boundary(tr, points, faces, CGAL::parameters::recovery_mode(mode));
  typedef Recovered_mesh<Triangulation, std::decay_t<decltype(result)> > Mesh;
  return { Mesh(tr, result, coordinates, faces).mesh(), Mesh::kind(mode, result) };
}

void expect_fault(const Case& good, const char* complaint, const std::function<void(Indexed_mesh&)>& break_it)
{
  Case bad = good;
  break_it(bad.mesh);
  const std::string found = complaint_about(bad);
  require(found == complaint, (std::string("expected '") + complaint + "', got '" + found + "'").c_str());
}

void check_faults_of_cells(const Case& good)
{
  expect_fault(good, "a cell is flat or inverted", [](Indexed_mesh& m) { std::swap(m.cells[0][0], m.cells[0][1]); });
  expect_fault(good, "two cells are on the same side of a facet",
               [](Indexed_mesh& m) { m.cells.push_back(m.cells.front()); });
  expect_fault(good, "a point is not in the mesh", [](Indexed_mesh& m) { m.points.push_back({ { 0, 0, 9 } }); });
  expect_fault(good, "a triangle is there, but is listed as missing", [](Indexed_mesh& m) { m.missing.insert(0); });
  Case hole = good; // a cell less: a hull that is not convex, or a cavity in it
  hole.mesh.cells.pop_back();
  require(! complaint_about(hole).empty(), "a hole was not noticed");
}

// Three input points that are no vertices of one cell.
Indexed_mesh::Facet first_absent_triangle(const Indexed_mesh& m)
{
  for(std::size_t i = 0; i < m.number_of_inputs; ++i)
    for(std::size_t j = 0; j < i; ++j)
      for(std::size_t k = 0; k < j; ++k)
        if(std::none_of(m.cells.begin(), m.cells.end(), [&](const Indexed_mesh::Cell& c)
                        { return std::count(c.begin(), c.end(), i) + std::count(c.begin(), c.end(), j)
                               + std::count(c.begin(), c.end(), k) == 3; }))
          return {{ i, j, k }};
  throw Complaint("every triangle is there");
}

void check_faults_of_constraints()
{
  const Case good = recover<Epick>(CGAL::data_file_path("meshes/schoenhardt_br3.off"), Mode::constrained);
  require(complaint_about(good).empty(), complaint_about(good).c_str());
  require(good.mesh.points.size() > good.mesh.number_of_inputs, "there is no Steiner point");
  expect_fault(good, "a Steiner point is on a constraint", [](Indexed_mesh& m)
               { m.surface[2] = {{ m.number_of_inputs, m.surface[2][0], m.surface[2][1] }}; });
  Case flips = recover<Epick>(CGAL::data_file_path("meshes/schoenhardt_br3.off"), Mode::flips_only);
  require(! flips.mesh.missing.empty() && complaint_about(flips).empty(), "an incomplete result is judged wrongly");
  expect_fault(flips, "a triangle is not there, and is not listed as missing",
               [](Indexed_mesh& m) { m.missing.erase(m.missing.begin()); });

  // points on constraints are none of the business of the mode `constrained`
  const Case split = recover<Epeck>(CGAL::data_file_path("meshes/schoenhardt_br3.off"), Mode::conforming);
  require(split.kind == Exact_mesh_checker::conforming && complaint_about(split).empty(),
          "a split triangle is refused");
  expect_fault(split, "a triangle is not there, and is not listed as missing",
               [](Indexed_mesh& m) { m.surface[0] = first_absent_triangle(m); });
  Case wrong_mode = split;
  wrong_mode.kind = Exact_mesh_checker::constrained;
  require(complaint_about(wrong_mode) == "a Steiner point is on a constraint", "a point on a constraint is accepted");

  const Case rounded = recover<Epick>(CGAL::data_file_path("meshes/schoenhardt_br3.off"), Mode::conforming);
  require(rounded.kind == Exact_mesh_checker::conforming_rounded && complaint_about(rounded).empty(),
          "a split triangle is refused");
  require(! rounded.mesh.parts.empty(), "no triangle is split");
  expect_fault(rounded, "the parts of a triangle are no disk",
               [](Indexed_mesh& m) { auto& parts = m.parts.begin()->second; parts.push_back(parts.front()); });
  expect_fault(rounded, "a triangle is not there, and is not listed as missing",
               [](Indexed_mesh& m) { m.parts.erase(m.parts.begin()); });
}

int main()
{
  try {
    for(const char* name : { "cube", "gear", "nested_cubes", "schoenhardt", "two_cubes", "washer" })
      for(const Mode mode : { Mode::constrained, Mode::conforming, Mode::flips_only })
      {
        const std::string file = CGAL::data_file_path(std::string("meshes/") + name + "_br3.off");
        const Case picked = recover<Epick>(file, mode), exact = recover<Epeck>(file, mode);
        for(const Case* c : { &picked, &exact })
        {
          require(complaint_about(*c).empty(), (std::string(name) + ": " + complaint_about(*c)).c_str());
          check_faults_of_cells(*c);
        }
      }
    check_faults_of_constraints();
  } catch(const std::exception& e) {
    std::cerr << e.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// Sizes of a background mesh are interpolated inside of it, carried outside from its boundary, and graded along edges;
// files of MEDIT and TetGen are read, and what is wrong in them is told.

#undef NDEBUG

#include <CGAL/Boundary_recovery_3/Background_mesh_3.h>
#include <CGAL/Boundary_recovery_3/Background_mesh_sizing_field_3.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Mesh_interpolation_3.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace Boundary_recovery_3 = CGAL::Boundary_recovery_3;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Exact_predicates_exact_constructions_kernel Exact_kernel;
typedef Kernel::Point_3 Point_3;
typedef Boundary_recovery_3::Background_mesh_3<Kernel> Mesh;
typedef Boundary_recovery_3::Background_mesh_sizing_field_3<Kernel> Field;

const double infinity = std::numeric_limits<double>::infinity();

// within 0 and 1
double random_number(std::mt19937& rng) { return rng() / 4294967296.; }

Point_3 random_place(std::mt19937& rng, const double size)
{
  return Point_3(size * random_number(rng), size * random_number(rng), size * random_number(rng));
}

// The Delaunay triangulation of random points, with sizes that are a linear function of the place, or random.
Mesh random_mesh(std::mt19937& rng, const int n, const double size, const bool is_linear)
{
  typedef CGAL::Triangulation_vertex_base_with_info_3<std::size_t, Kernel> Vb;
  typedef CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Vb> > Tr;
  Mesh mesh;
  Tr tr;
  for(int i = 0; i < n; ++i)
  {
    const Point_3 p = random_place(rng, size);
    tr.insert(p)->info() = static_cast<std::size_t>(i);
    mesh.points.push_back(p);
    mesh.sizes.push_back(is_linear ? size + .5 * p.x() + .25 * p.y() : size * (.1 + random_number(rng)));
  }
  for(const auto c : tr.finite_cell_handles())
    mesh.tetrahedra.push_back({{ c->vertex(0)->info(), c->vertex(1)->info(), c->vertex(2)->info(),
                                 c->vertex(3)->info() }});
  return mesh;
}

// With exact numbers: the smallest of the interpolated sizes of all tetrahedra that have p inside or on the boundary.
double brute_force(const Mesh& mesh, const Point_3& p)
{
  typedef Exact_kernel::FT FT;
  const auto exact = [](const Point_3& q) { return Exact_kernel::Point_3(q.x(), q.y(), q.z()); };
  double smallest = infinity;
  for(const auto& t : mesh.tetrahedra)
  {
    std::array<Exact_kernel::Point_3, 4> q;
    for(int i = 0; i < 4; ++i)
      q[i] = exact(mesh.points[t[i]]);
    const FT volume = CGAL::volume(q[0], q[1], q[2], q[3]);
    FT size = 0;
    bool is_inside = volume != 0;
    for(int i = 0; i < 4 && is_inside; ++i)
    {
      std::array<Exact_kernel::Point_3, 4> r = q;
      r[i] = exact(p);
      const FT share = CGAL::volume(r[0], r[1], r[2], r[3]) / volume;
      is_inside = share >= 0;
      size += share * mesh.sizes[t[i]];
    }
    if(is_inside)
      smallest = (std::min)(smallest, CGAL::to_double(size));
  }
  return smallest;
}

void test_interpolation(const double size)
{
  std::mt19937 rng(5);
  for(const bool is_linear : { true, false })
  {
    const Mesh mesh = random_mesh(rng, 40, size, is_linear);
    const Field field(mesh);
    int number_of_inside = 0;
    for(int k = 0; k < 100; ++k)
    {
      const Point_3 p = random_place(rng, size);
      const double expected = brute_force(mesh, p), value = field(p);
      assert(value == field(p) && value == field(p, 3, 1));
      if(expected == infinity)
        continue;
      ++number_of_inside;
      assert(std::abs(value - expected) <= 1e-9 * expected);
      assert(! is_linear || std::abs(value - (size + .5 * p.x() + .25 * p.y())) <= 1e-9 * value);
    }
    assert(number_of_inside > 20);
    for(std::size_t v = 0; v < mesh.points.size(); ++v)
      assert(std::abs(field(mesh.points[v]) - mesh.sizes[v]) <= 1e-9 * mesh.sizes[v]);
  }
}

// On the common facets of two tetrahedra, where rounding errors may leave a point in none of them.
void test_facets()
{
  std::mt19937 rng(8);
  const Mesh mesh = random_mesh(rng, 200, 1, true);
  const Field field(mesh);
  for(const auto& t : mesh.tetrahedra)
  {
    const Point_3 p = CGAL::centroid(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
    assert(std::abs(field(p) - (1 + .5 * p.x() + .25 * p.y())) <= 1e-9);
  }
}

// The cube [0, 1]^3 around its diagonal, with sizes x + 2 y + 4 z + 1.
Mesh cube()
{
  Mesh mesh;
  for(int i = 0; i < 8; ++i)
  {
    mesh.points.emplace_back(i & 1, (i >> 1) & 1, i >> 2);
    mesh.sizes.push_back(i + 1);
  }
  typedef std::array<std::size_t, 2> Edge;
  for(const Edge& e : { Edge{{ 1, 3 }}, {{ 1, 5 }}, {{ 2, 3 }}, {{ 2, 6 }}, {{ 4, 5 }}, {{ 4, 6 }} })
    mesh.tetrahedra.push_back({{ 0, e[0], e[1], 7 }});
  return mesh;
}

void test_outside()
{
  const Field field(cube());
  for(double x = -2; x <= 3; x += .25)
    for(double y = -2; y <= 3; y += .25)
      for(double z = -2; z <= 3; z += .25)
      {
        const auto clamp = [](const double c) { return (std::max)(0., (std::min)(1., c)); };
        const double expected = 1 + clamp(x) + 2 * clamp(y) + 4 * clamp(z);
        assert(std::abs(field(Point_3(x, y, z)) - expected) <= 1e-12);
      }
  assert(std::abs(field(Point_3(1e5, 1e5, 1e5)) - 8) < 1e-6 && std::abs(field(Point_3(-1e5, -1e5, -1e5)) - 1) < 1e-6);
  assert(field(Point_3(1e30, 0, 0)) >= 1 && field(Point_3(1e30, 0, 0)) <= 8);
}

// Overlapping tetrahedra, flat ones, and none.
void test_soups()
{
  Mesh mesh = cube();
  const std::size_t n = mesh.points.size();
  for(int i = 0; i < 4; ++i)
  {
    mesh.points.emplace_back(i == 1 ? .5 : 0, i == 2 ? .5 : 0, i == 3 ? .5 : 0);
    mesh.sizes.push_back(.25);
  }
  mesh.tetrahedra.push_back({{ n + 1, n, n + 2, n + 3 }});
  mesh.tetrahedra.push_back({{ 0, 1, 2, 3 }}); // flat
  mesh.tetrahedra.push_back({{ 0, 0, 1, 2 }}); // flatter
  const Field field(mesh);
  assert(field.is_valid() && field(Point_3(.1, .1, .1)) == .25 && std::abs(field(Point_3(.9, .9, .9)) - 7.3) < 1e-12);
  mesh.sizes.resize(n);
  assert(! mesh.is_valid() && ! Field(mesh).is_valid() && std::isnan(Field(mesh)(Point_3(.1, .1, .1))));
  mesh.points.resize(n);
  mesh.tetrahedra = { {{ 0, 1, 2, 3 }} };
  assert(Field(mesh).is_valid() && Field(mesh)(Point_3(.1, .1, .1)) == infinity);
  assert(Field(Mesh())(Point_3(.1, .1, .1)) == infinity);
  for(const double invalid : { 0., -1., infinity, std::numeric_limits<double>::quiet_NaN() })
  {
    mesh.sizes.back() = invalid;
    assert(! Field(mesh).is_valid());
  }
  mesh.sizes.back() = 1;
  mesh.tetrahedra.push_back({{ 0, 1, 2, 8 }});
  assert(! Field(mesh).is_valid() && ! Field(cube(), -1).is_valid());
}

// Several tetrahedra at one place: the smallest size wins, inside and outside.
void test_overlaps()
{
  Mesh mesh;
  for(const double size : { 3., 7., 1., 9., 2. })
  {
    const std::size_t n = mesh.points.size();
    for(int i = 0; i < 4; ++i)
    {
      mesh.points.emplace_back(i == 1, i == 2, i == 3);
      mesh.sizes.push_back(size);
    }
    mesh.tetrahedra.push_back({{ n, n + 1, n + 2, n + 3 }});
    assert(Field(mesh)(Point_3(.1, .1, .1)) == *std::min_element(mesh.sizes.begin(), mesh.sizes.end()));
    assert(Field(mesh)(Point_3(-1, .1, .1)) == *std::min_element(mesh.sizes.begin(), mesh.sizes.end()));
  }
}

// No size in a ball is below the number that is told, which is near the size at its center if the ball is small.
void check_least_sizes(const Mesh& mesh, const double size, const bool is_any_precise)
{
  std::mt19937 rng(11);
  const Field field(mesh);
  int number_of_precise = 0;
  for(int k = 0; k < 1000; ++k)
  {
    const Point_3 center = random_place(rng, 2 * size) - typename Kernel::Vector_3(size, size, size) / 2;
    const double radius = size * std::pow(2., -30 * random_number(rng)), at_center = field(center);
    const double least = field.least_size_around(center, radius, 1);
    assert(least > 0 && least <= at_center);
    number_of_precise += radius < 1e-5 * size && least > .9 * at_center;
    for(int n = 0; n < 20; ++n)
    {
      const Point_3 p = random_place(rng, 2) - typename Kernel::Vector_3(1, 1, 1);
      if(CGAL::squared_distance(p, Point_3(0, 0, 0)) <= 1)
        assert(field(center + radius * (p - Point_3(0, 0, 0))) >= least * (1 - 1e-12));
    }
  }
  assert(! is_any_precise || number_of_precise > 350);
}

void test_least_sizes()
{
  std::mt19937 rng(10);
  for(const double size : { 1., 1e-20, 1e30 })
    for(const bool is_linear : { true, false })
      check_least_sizes(random_mesh(rng, 60, size, is_linear), size, true);
  check_least_sizes(cube(), 1, true);
  Mesh soup = random_mesh(rng, 60, 1, false); // some are missing, others are there twice, or overlap
  soup.tetrahedra.erase(soup.tetrahedra.begin() + 10, soup.tetrahedra.begin() + 40);
  soup.tetrahedra.insert(soup.tetrahedra.end(), soup.tetrahedra.begin() + 10, soup.tetrahedra.begin() + 50);
  for(std::size_t v = 0; v + 3 < 60; v += 5)
    soup.tetrahedra.push_back({{ v, v + 1, v + 2, v + 3 }});
  check_least_sizes(soup, 1, false);
  Mesh invalid = soup;
  invalid.sizes.pop_back();
  assert(std::isnan(Field(invalid).least_size_around(Point_3(0, 0, 0), 1, 1)));
}

// Twins hide the boundary: both of the facets of the pair are of two tetrahedra. Outside, the size is that of the other
// end of the mesh.
void test_hidden_boundary()
{
  Mesh mesh;
  for(int i = 0; i < 8; ++i)
  {
    mesh.points.emplace_back((i % 4 == 1) + (i < 4 ? 0 : 100), i % 4 == 2, i % 4 == 3);
    mesh.sizes.push_back(i < 4 ? 5 : 1);
  }
  mesh.tetrahedra = { {{ 0, 1, 2, 3 }}, {{ 0, 1, 2, 3 }}, {{ 4, 5, 6, 7 }} };
  const Field field(mesh);
  assert(field(Point_3(.2, .2, .2)) == 5 && field(Point_3(-.1, .2, .2)) == 1);
  assert(field.least_size_around(Point_3(.2, .2, .2), .3, 1) == 1);
}

// Sizes that are carried along edges until nothing changes.
void test_grading()
{
  std::mt19937 rng(9);
  for(const double grading : { 0., .1, .3, 1e6 })
  {
    const Mesh mesh = random_mesh(rng, 60, 1, false);
    const Field field(mesh, grading);
    std::vector<double> sizes = mesh.sizes;
    for(bool changed = true; changed; )
    {
      changed = false;
      for(const auto& t : mesh.tetrahedra)
        for(const std::size_t v : t)
          for(const std::size_t w : t)
          {
            const double length = std::sqrt(CGAL::squared_distance(mesh.points[v], mesh.points[w]));
            const double carried = sizes[v] + grading * length;
            changed = changed || carried < sizes[w] - 1e-14;
            sizes[w] = (std::min)(sizes[w], carried);
          }
    }
    bool changed = false;
    for(std::size_t v = 0; v < sizes.size(); ++v)
    {
      assert(std::abs(field(mesh.points[v]) - sizes[v]) <= 1e-9);
      changed = changed || sizes[v] < mesh.sizes[v];
    }
    assert(changed == (grading < 1));
  }
}

const std::string mesh_text = "MeshVersionFormatted 2\n# a comment\nDimension\n3\n"
                              "Vertices\n4\n0 0 0 1\n1 0 0 1\n0 1 0 1\n0 0 1 1\nTriangles\n1\n1 2 3 1\n"
                              "Tetrahedra 1\n1 2 3 4 7\nEnd\n";
const std::string sol_text = "MeshVersionFormatted 2\nDimension 3\nSolAtVertices\n4\n1 1\n.5\n1\n2\n4\nEnd\n";
const std::string node_text = "4 3 1 1 # points\n1 0 0 0 5 1\n2 1 0 0 5 1\n3 0 1 0 5 1\n4 0 0 1 5 1\n";
const std::string ele_text = "1 4 1\n1 1 2 3 4 -1\n";
const std::string mtr_text = "4 1\n.5\n1\n2\n4\n";

// a text in which the first occurrence of `what` is replaced
std::string changed(std::string text, const std::string& what, const std::string& by)
{
  const std::size_t place = text.find(what);
  assert(place != std::string::npos);
  return text.replace(place, what.size(), by);
}

std::string read_MEDIT(const std::string& mesh_file, const std::string& sol_file, Mesh& mesh)
{
  std::istringstream mesh_stream(mesh_file), sol_stream(sol_file);
  std::string message;
  const bool ok = Boundary_recovery_3::read_MEDIT_background_mesh(mesh_stream, sol_stream, mesh, message);
  assert(ok == message.empty());
  return message;
}

std::string read_TetGen(const std::string& node, const std::string& ele, const std::string& mtr, Mesh& mesh)
{
  std::istringstream node_stream(node), ele_stream(ele), mtr_stream(mtr);
  std::string message;
  const bool ok = Boundary_recovery_3::read_TetGen_background_mesh(node_stream, ele_stream, mtr_stream, mesh, message);
  assert(ok == message.empty());
  return message;
}

void check_read(const Mesh& mesh)
{
  assert(mesh.is_valid() && mesh.points.size() == 4 && mesh.tetrahedra.size() == 1);
  assert(mesh.points[3] == Point_3(0, 0, 1));
  assert((mesh.tetrahedra[0] == Mesh::Tetrahedron{{ 0, 1, 2, 3 }}));
  assert((mesh.sizes == std::vector<double>{ .5, 1, 2, 4 }));
}

void test_reading()
{
  Mesh mesh, of_TetGen, from_zero, quadratic;
  assert(read_MEDIT(mesh_text, sol_text, mesh).empty());
  check_read(mesh);
  assert(read_MEDIT(changed(mesh_text, "\nEnd\n", ""), changed(sol_text, "\nEnd\n", ""), mesh).empty());
  check_read(mesh);
  assert(read_TetGen(node_text, ele_text, mtr_text, of_TetGen).empty());
  check_read(of_TetGen);
  assert(read_TetGen("4 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n", "1 4 0\r\n0 0 1 2 3", mtr_text,
                     from_zero).empty());
  check_read(from_zero);
  assert(read_TetGen(node_text, "1 10 0\n1 1 2 3 4 1 1 1 1 1 1\n", mtr_text, quadratic).empty());
  check_read(quadratic);
}

void test_messages()
{
  const auto mesh_message = [](const std::string& what, const std::string& by)
  {
    Mesh mesh;
    const std::string message = read_MEDIT(changed(mesh_text, what, by), sol_text, mesh);
    assert(mesh.points.empty());
    return message;
  };
  assert(mesh_message("MeshVersion", "Mesh") == ".mesh file, line 1: it does not begin with MeshVersionFormatted");
  assert(mesh_message("3\nVertices", "2\nVertices") == ".mesh file, line 4: the dimension is not 3");
  assert(mesh_message("\n4\n", "\nfour\n") == ".mesh file, line 6: the number of vertices is missing");
  assert(mesh_message("0 1 0 1", "0 y 0 1")
         == ".mesh file, line 9: a vertex is missing, or is not three coordinates and a reference");
  assert(mesh_message("a 1\n1", "a x\n1") == ".mesh file, line 14: the number of tetrahedra is missing");
  assert(mesh_message("1 2 3 4 7", "0 2 3 4 7")
         == ".mesh file, line 15: a vertex of a tetrahedron is missing, or is not positive");
  assert(mesh_message("1 2 3 4 7", "1 2 3 4") == ".mesh file, line 16: the reference of a tetrahedron is missing");
  assert(mesh_message("1 2 3 4 7", "1 2 3 5 7")
         == ".mesh file, line 16: a tetrahedron has a vertex 5, which is not there");
  assert(mesh_message("Tetrahedra 1\n1 2 3 4 7", "Tetrahedra 0") == ".mesh file, line 15: there are no tetrahedra");

  const auto sol_message = [](const std::string& what, const std::string& by)
  {
    Mesh mesh;
    return read_MEDIT(mesh_text, changed(sol_text, what, by), mesh);
  };
  assert(sol_message("MeshVersion", "") == ".sol file, line 1: it does not begin with MeshVersionFormatted");
  assert(sol_message("Dimension 3", "Dimension 2") == ".sol file, line 2: the dimension is not 3");
  assert(sol_message("AtVertices", "AtTriangles") == ".sol file, line 11: there is no SolAtVertices with a number");
  assert(sol_message("1 1", "1 3")
         == ".sol file, line 5: the solution is not one scalar for each vertex, which '1 1' stands for");
  assert(sol_message("\n2\n", "\n0\n") == ".sol file, line 8: a size is not positive");
  assert(sol_message("\n2\n", "\n") == ".sol file, line 9: a size is missing, or is not a number");
  assert(sol_message("\n4\n1 1\n.5", "\n3\n1 1") == "there are 3 sizes for 4 vertices");

  const auto TetGen_message = [](const std::string& node, const std::string& ele, const std::string& mtr)
  {
    Mesh mesh;
    return read_TetGen(node, ele, mtr, mesh);
  };
  assert(TetGen_message(changed(node_text, "4 3", "4 2"), ele_text, mtr_text)
         == ".node file, line 1: it does not begin with a number of points, 3, and numbers of attributes and of "
            "markers");
  assert(TetGen_message(changed(node_text, "4 0 0 1 5 1\n", ""), ele_text, mtr_text)
         == ".node file, line 5: a point is missing, or its numbers are not as many as announced");
  assert(TetGen_message(changed(node_text, "\n3", "\n5"), ele_text, mtr_text)
         == ".node file, line 4: points are not numbered one after the other, from 0 or from 1");
  assert(TetGen_message(node_text, changed(ele_text, "1 4", "1 5"), mtr_text)
         == ".ele file, line 1: it does not begin with a number of tetrahedra, 4 or 10, and a number of attributes");
  assert(TetGen_message(node_text, changed(ele_text, "1 4", "2 4"), mtr_text)
         == ".ele file, line 3: a tetrahedron is missing");
  for(const std::string vertex : { "0", "5", "x", "99999999999999999999999" })
    assert(TetGen_message(node_text, changed(ele_text, "3 4 -1", "3 " + vertex + " -1"), mtr_text)
           == ".ele file, line 2: a vertex of a tetrahedron is missing, or is none of the points");
  assert(TetGen_message(node_text, changed(ele_text, " -1", ""), mtr_text)
         == ".ele file, line 3: the numbers of a tetrahedron are not as many as announced");
  assert(TetGen_message(node_text, "0 4 0", mtr_text) == ".ele file, line 1: there are no tetrahedra");
  assert(TetGen_message(node_text, ele_text, changed(mtr_text, "4 1", "4 2"))
         == ".mtr file, line 1: it does not begin with a number of points, and 1");
  assert(TetGen_message(node_text, ele_text, changed(mtr_text, "2", "-2"))
         == ".mtr file, line 4: a size is not positive");
}

void test_files()
{
  const std::string name = "test_background_mesh_br3_scratch";
  std::ofstream(name + ".mesh") << mesh_text;
  std::ofstream(name + ".node") << node_text;
  std::ofstream(name + ".ele") << ele_text;
  std::ofstream(name + ".mtr") << mtr_text;
  Mesh mesh;
  std::string message;
  assert(Boundary_recovery_3::read_background_mesh(name + ".ele", mesh, message));
  check_read(mesh);
  std::remove((name + ".sol").c_str());
  assert(! Boundary_recovery_3::read_background_mesh(name + ".mesh", mesh, message));
  assert(message == ".sol file: it cannot be opened");
  std::ofstream(name + ".sol") << sol_text;
  assert(Boundary_recovery_3::read_background_mesh(name + ".mesh", mesh, message));
  for(const std::string other : { "x.off", "x", "" })
  {
    assert(! Boundary_recovery_3::read_background_mesh(other, mesh, message));
    assert(message == "a background mesh is in a .mesh and a .sol file, or in .node, .ele and .mtr files");
  }
  for(const char* extension : { ".mesh", ".sol", ".node", ".ele", ".mtr" })
    std::remove((name + extension).c_str());
}

int main()
{
  for(const double size : { 1., 1e-9, 1e9 })
    test_interpolation(size);
  test_facets();
  test_outside();
  test_soups();
  test_overlaps();
  test_least_sizes();
  test_hidden_boundary();
  test_grading();
  test_reading();
  test_messages();
  test_files();
  std::cout << "done" << std::endl;
  return 0;
}

// Recovers one surface and prints what that took as one line of JSON; README.md tells what the entries mean. Nothing
// that the library reports is taken on trust: the final triangulation is looked through.

#include "mesh_quality_br3.h"
#include "peak_memory_br3.h"
#include "recovered_mesh_br3.h" // of the tests

#include <CGAL/recover_boundary.h>

#include <CGAL/Boundary_recovery_3/label_regions.h>
#include <CGAL/Cartesian_converter.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Unique_hash_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <limits>
#include <string>
#include <unordered_map>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel   Epick;
typedef CGAL::Exact_predicates_exact_constructions_kernel     Epeck;
typedef CGAL::Boundary_recovery_3::Phase                      Phase;
typedef CGAL::Boundary_recovery_3::Recovery_status            Status;
typedef CGAL::Boundary_recovery_3::Recovery_mode              Mode;
typedef std::array<std::size_t, 2>                            Edge;
typedef std::array<std::size_t, 3>                            Facet;
typedef std::array<std::size_t, 4>                            Cell;

enum Exit_status { measured = 0, usage_or_file_error = 1, exception_caught = 2 };

constexpr const char* usage =
  "usage: benchmark_recovery [options] SURFACE\n"
  "Recovers a surface (.off .ply .stl .obj) and prints one line of JSON.\n"
  "  --mode MODE            constrained (default), conforming or flips_only\n"
  "  --kernel epick|epeck   the kernel; default: epick\n"
  "  --time-limit SECONDS   stop the recovery after that time; default: never\n"
  "  --check                have the result judged by the exact checker of the tests; may take long\n"
  "  --table                add the numbers n1 to n4 of each recursion level\n"
  "  --write-surface FILE   write the surface as it is recovered, in OFF, for other programs\n"
  "  --write-mesh FILE      write the tetrahedra of the domain, in MEDIT's format\n"
  "benchmark_recovery --phases prints the names of the phases, in the order in which they run.\n"
  "exit status: 0 measured, 1 usage or file error, 2 an exception left the library\n";

struct Options
{
  std::string input;
  std::string surface;
  std::string mesh;
  Mode mode = Mode::constrained;
  bool is_exact = false;
  bool table = false;
  bool check = false;
  double time_limit = (std::numeric_limits<double>::infinity)();
};

struct Surface
{
  std::vector<Epick::Point_3> points;
  std::vector<std::vector<std::size_t> > faces;
};

constexpr const char* names_of_modes[] = { "constrained", "conforming", "flips_only" }; // in the order of `Mode`

bool parse_mode(const std::string& name, Mode& mode)
{
  for(int i = 0; i < 3; ++i)
    if(name == names_of_modes[i])
    {
      mode = static_cast<Mode>(i);
      return true;
    }
  return false;
}

bool parse(const int argc, const char* const argv[], Options& options)
{
  for(int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    const std::string value = i + 1 < argc ? argv[i + 1] : "";
    if(argument == "--table")
      options.table = true;
    else if(argument == "--check")
      options.check = true;
    else if(argument == "--kernel" && (value == "epick" || value == "epeck"))
      options.is_exact = argv[++i] == std::string("epeck");
    else if(argument == "--mode" && parse_mode(value, options.mode))
      ++i;
    else if(argument == "--write-surface" && ! value.empty())
      options.surface = argv[++i];
    else if(argument == "--write-mesh" && ! value.empty())
      options.mesh = argv[++i];
    else if(argument == "--time-limit" && ! value.empty())
    {
      char* end = nullptr;
      options.time_limit = std::strtod(argv[++i], &end);
      if(*end != '\0' || ! (options.time_limit >= 0))
        return false;
    }
    else if(! options.input.empty() || argument.empty() || argument[0] == '-')
      return false;
    else
      options.input = argument;
  }
  return ! options.input.empty();
}

// Equal points become one, vertices that no face uses go; the order of the file remains.
void use_each_point_once(Surface& surface)
{
  const std::vector<Epick::Point_3>& p = surface.points;
  std::vector<std::size_t> order, number(p.size());
  for(std::size_t i = 0; i < p.size(); ++i)
  {
    number[i] = i;
    if(std::isfinite(p[i].x()) && std::isfinite(p[i].y()) && std::isfinite(p[i].z()))
      order.push_back(i); // NaN has no place in an order; the library will refuse it
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return p[i] < p[j]; });
  for(std::size_t k = 1; k < order.size(); ++k)
    if(p[order[k - 1]] == p[order[k]])
      number[order[k]] = number[order[k - 1]];

  std::vector<bool> is_used(p.size(), false);
  for(auto& face : surface.faces)
    for(std::size_t& v : face)
      is_used[v = number[v]] = true;
  std::vector<Epick::Point_3> used;
  for(std::size_t i = 0; i < p.size(); ++i)
    if(is_used[i])
    {
      number[i] = used.size();
      used.push_back(p[i]);
    }
  for(auto& face : surface.faces)
    for(std::size_t& v : face)
      v = number[v];
  surface.points.swap(used);
}

bool read_surface(const std::string& file, Surface& surface)
{
  if(! CGAL::IO::read_polygon_soup(file, surface.points, surface.faces, CGAL::parameters::verbose(false)))
    return false;
  for(const auto& face : surface.faces)
    for(const std::size_t v : face)
      if(v >= surface.points.size())
        return false;
  use_each_point_once(surface);
  return true;
}

bool write_surface(const std::string& file, const Surface& surface)
{
  std::ofstream os(file);
  os.precision(17);
  os << "OFF\n" << surface.points.size() << ' ' << surface.faces.size() << " 0\n";
  for(const Epick::Point_3& p : surface.points)
    os << p << '\n';
  for(const auto& face : surface.faces)
  {
    os << face.size();
    for(const std::size_t v : face)
      os << ' ' << v;
    os << '\n';
  }
  os.close();
  return ! os.fail();
}

// Each simplex once and with its vertices in order.
template <typename Simplex>
void make_unique(std::vector<Simplex>& simplices)
{
  for(Simplex& s : simplices)
    std::sort(s.begin(), s.end());
  std::sort(simplices.begin(), simplices.end());
  simplices.erase(std::unique(simplices.begin(), simplices.end()), simplices.end());
}

std::vector<Edge> edges_of(const std::vector<std::vector<std::size_t> >& faces)
{
  std::vector<Edge> edges;
  for(const auto& face : faces)
    for(std::size_t i = 0; i < face.size(); ++i)
      edges.push_back({{ face[i], face[(i + 1) % face.size()] }});
  make_unique(edges);
  return edges;
}

// The vertices by number: those of the input, Steiner points, and the infinite vertex.
template <typename Triangulation>
class Vertex_numbers
{
  std::unordered_map<const void*, std::size_t> m_numbers; // look-up only

public:
  Vertex_numbers(const Triangulation& tr, const CGAL::Boundary_recovery_result_3<Triangulation>& result)
  {
    for(const auto v : result.vertices)
      m_numbers.emplace(&*v, m_numbers.size());
    for(const auto v : result.steiner_vertices)
      m_numbers.emplace(&*v, m_numbers.size());
    m_numbers.emplace(&*tr.infinite_vertex(), m_numbers.size());
  }

  std::size_t operator()(const typename Triangulation::Vertex_handle v) const { return m_numbers.at(&*v); }
};

// The cells by the numbers of their vertices, in an order of their own.
template <typename Triangulation>
std::vector<Cell> indexed_cells(const Triangulation& tr, const Vertex_numbers<Triangulation>& number)
{
  std::vector<Cell> cells;
  for(const auto c : tr.all_cell_handles())
    cells.push_back({{ number(c->vertex(0)), number(c->vertex(1)), number(c->vertex(2)), number(c->vertex(3)) }});
  for(Cell& c : cells)
    std::sort(c.begin(), c.end());
  std::sort(cells.begin(), cells.end());
  return cells;
}

// FNV-1a on the indices, byte by byte
std::uint64_t checksum(const std::vector<Cell>& cells)
{
  std::uint64_t hash = 14695981039346656037u;
  for(const Cell& c : cells)
    for(const std::size_t v : c)
      for(int shift = 0; shift < 64; shift += 8)
        hash = (hash ^ ((static_cast<std::uint64_t>(v) >> shift) & 0xff)) * 1099511628211u;
  return hash;
}

// The cells of the domain: those whose region is not 0; all of them if the surface bounds nothing.
template <typename Triangulation>
std::vector<typename Triangulation::Cell_handle>
cells_of_domain(const Triangulation& tr, const CGAL::Boundary_recovery_result_3<Triangulation>& result)
{
  typedef typename Triangulation::Cell_handle Cell_handle;

  CGAL::Unique_hash_map<Cell_handle, int> region(0);
  const int number_of_regions = CGAL::Boundary_recovery_3::label_regions(
    tr, result.surface_facets(), boost::associative_property_map<CGAL::Unique_hash_map<Cell_handle, int> >(region));
  std::vector<Cell_handle> cells;
  for(const Cell_handle c : tr.finite_cell_handles())
    if(number_of_regions == 0 || region[c] != 0)
      cells.push_back(c);
  return cells;
}

// How many Steiner points are vertices of the cells.
template <typename Result, typename Cells>
std::size_t number_of_steiner_points(const Result& result, const Cells& cells)
{
  CGAL::Unique_hash_map<typename Result::Vertex_handle, bool> is_there(false);
  for(const auto c : cells)
    for(int i = 0; i < 4; ++i)
      is_there[c->vertex(i)] = true;
  return static_cast<std::size_t>(std::count_if(result.steiner_vertices.begin(), result.steiner_vertices.end(),
                                                [&](const auto v) { return is_there[v]; }));
}

// Steiner points by where they are: on a split edge, else on a split facet, else in the domain or outside of it.
template <typename Result, typename Cells>
void print_kinds_of_steiner_points(std::ostream& os, const Result& result, const Cells& cells)
{
  enum Place { outside, inside, on_facet, on_edge };
  CGAL::Unique_hash_map<typename Result::Vertex_handle, Place> place(outside);
  for(const auto c : cells)
    for(int i = 0; i < 4; ++i)
      place[c->vertex(i)] = inside;
  for(const auto& part : result.parts_of_facets)
    for(const auto v : part.vertices)
      place[v] = on_facet;
  for(const auto& part : result.parts_of_edges)
    for(const auto v : part.vertices)
      place[v] = on_edge;
  std::array<std::size_t, 4> number = {{ 0, 0, 0, 0 }};
  for(const auto v : result.steiner_vertices)
    ++number[place[v]];
  os << ", \"steiner_points_on_edges\": " << number[on_edge] << ", \"steiner_points_on_facets\": " << number[on_facet]
     << ", \"steiner_points_inside\": " << number[inside] << ", \"steiner_points_outside\": " << number[outside];
}

template <typename Cells>
void print_quality(std::ostream& os, const Cells& cells)
{
  br3_benchmark::Dihedral_angles angles;
  for(const auto c : cells)
  {
    std::array<br3_benchmark::Point, 4> p;
    for(int i = 0; i < 4; ++i)
      for(int k = 0; k < 3; ++k)
        p[i][k] = CGAL::to_double(c->vertex(i)->point()[k]);
    angles.add(p);
  }
  os << ", \"tetrahedra\": " << cells.size() << ", ";
  write_json(os, angles);
}

// What the exact checker says: `exact`; `rounded`, if points on constraints are beside them but all is connected as it
// has to be; else its complaint. `deviation` is how far they are beside them.
template <typename Triangulation, typename Result>
std::string verdict(const Triangulation& tr, const Result& result, const Surface& surface, const Mode mode,
                    double& deviation)
{
  typedef br3_test::Recovered_mesh<Triangulation, Result> Mesh;
  std::vector<br3_test::Coordinates> points;
  std::vector<Facet> faces;
  for(const Epick::Point_3& p : surface.points)
    points.push_back({{ p.x(), p.y(), p.z() }});
  for(const auto& face : surface.faces)
    faces.push_back({{ face[0], face[1], face[2] }});
  try {
    const Mesh mesh(tr, result, points, faces);
    const auto kind = Mesh::kind(mode, result);
    br3_test::require(mode != Mode::flips_only || result.steiner_vertices.empty(),
                      "a Steiner point without permission");
    br3_test::require((result.status == Status::recovered) == (result.missing_edges.empty()
                                                                && result.missing_facets.empty()),
                      "the status contradicts the lists");
    br3_test::Exact_mesh_checker checker(mesh.mesh(), kind);
    checker();
    deviation = checker.deviation();
    return kind == br3_test::Exact_mesh_checker::conforming_rounded ? "rounded" : "exact";
  } catch(const br3_test::Complaint& complaint) {
    return complaint.what();
  }
}

template <typename Result, typename Cells>
bool write_mesh(const std::string& file, const Result& result, const Cells& cells)
{
  typedef typename Result::Vertex_handle Vertex_handle;
  std::vector<Vertex_handle> vertices = result.vertices;
  vertices.insert(vertices.end(), result.steiner_vertices.begin(), result.steiner_vertices.end());
  CGAL::Unique_hash_map<Vertex_handle, std::size_t> number(0); // 0: not used
  for(const auto c : cells)
    for(int i = 0; i < 4; ++i)
      number[c->vertex(i)] = std::size_t(-1);

  std::ofstream os(file);
  os.precision(17);
  vertices.erase(std::remove_if(vertices.begin(), vertices.end(), [&](const auto v) { return number[v] == 0; }),
                 vertices.end());
  os << "MeshVersionFormatted 2\nDimension 3\nVertices\n" << vertices.size() << '\n';
  for(std::size_t i = 0; i < vertices.size(); ++i)
  {
    const auto& p = vertices[i]->point();
    number[vertices[i]] = i + 1;
    os << CGAL::to_double(p.x()) << ' ' << CGAL::to_double(p.y()) << ' ' << CGAL::to_double(p.z()) << " 0\n";
  }
  os << "Tetrahedra\n" << cells.size() << '\n';
  for(const auto c : cells)
    os << number[c->vertex(0)] << ' ' << number[c->vertex(1)] << ' ' << number[c->vertex(2)] << ' '
       << number[c->vertex(3)] << " 1\n";
  os << "End\n";
  os.close();
  return ! os.fail();
}

template <typename Simplex>
std::size_t number_of_missing(const std::vector<Simplex>& wanted, const std::vector<Simplex>& present)
{
  return static_cast<std::size_t>(std::count_if(wanted.begin(), wanted.end(), [&](const Simplex& s)
                                  { return ! std::binary_search(present.begin(), present.end(), s); }));
}

// Puts the parts of simplices (mode `conforming`) in their place.
template <typename Simplex, typename Parts, typename Numbers>
void replace_by_parts(std::vector<Simplex>& simplices, const Parts& parts, const Numbers& number)
{
  std::vector<Simplex> split, pieces;
  for(const auto& part : parts)
  {
    Simplex whole, piece;
    std::copy_n(part.constraint.vertices.begin(), whole.size(), whole.begin());
    std::transform(part.vertices.begin(), part.vertices.end(), piece.begin(), number);
    split.push_back(whole);
    pieces.push_back(piece);
  }
  make_unique(split);
  simplices.erase(std::remove_if(simplices.begin(), simplices.end(), [&](const Simplex& s)
                                 { return std::binary_search(split.begin(), split.end(), s); }), simplices.end());
  simplices.insert(simplices.end(), pieces.begin(), pieces.end());
  make_unique(simplices);
}

// Whether the numbers of missing edges and facets are those that a look at all the cells gives.
template <typename Result, typename Numbers>
bool recount_agrees(const Result& result, const Surface& surface, const std::vector<Cell>& cells, const Numbers& number)
{
  std::vector<Facet> present, wanted;
  for(const Cell& c : cells)
    for(std::size_t i = 0; i < 4; ++i)
      present.push_back({{ c[(i + 1) % 4], c[(i + 2) % 4], c[(i + 3) % 4] }});
  make_unique(present);
  std::vector<Edge> present_edges, wanted_edges = edges_of(surface.faces);
  for(const Facet& f : present)
    for(std::size_t i = 0; i < 3; ++i)
      present_edges.push_back({{ f[i], f[(i + 1) % 3] }});
  make_unique(present_edges);
  for(const auto& face : surface.faces)
    wanted.push_back({{ face[0], face[1], face[2] }});
  make_unique(wanted);
  replace_by_parts(wanted_edges, result.parts_of_edges, number);
  replace_by_parts(wanted, result.parts_of_facets, number);
  return number_of_missing(wanted_edges, present_edges) == result.missing_edges.size()
      && number_of_missing(wanted, present) == result.missing_facets.size();
}

// What Delaunay_triangulation_3 adds to the test of its base class does not hold after flips.
template <typename GT, typename TDS, typename Lock>
bool is_valid_as_base(const CGAL::Triangulation_3<GT, TDS, Lock>& tr) { return tr.is_valid(); }

// The points of the vertices of a cell, the infinite one replaced by the vertex `v`.
template <typename Triangulation>
CGAL::Orientation orientation_of(const Triangulation& tr, const typename Triangulation::Cell_handle c,
                                 const typename Triangulation::Vertex_handle v)
{
  std::array<const typename Triangulation::Point*, 4> p;
  for(int i = 0; i < 4; ++i)
    p[i] = &(tr.is_infinite(c->vertex(i)) ? v : c->vertex(i))->point();
  return tr.geom_traits().orientation_3_object()(*p[0], *p[1], *p[2], *p[3]);
}

// Whether every finite cell is positive, and not flat. CGAL's is_valid() asserts that, too, but without assertions
// (NDEBUG) it ignores what it finds.
template <typename Triangulation>
bool cells_are_positive(const Triangulation& tr)
{
  for(const auto c : tr.finite_cell_handles())
    if(orientation_of(tr, c, c->vertex(0)) != CGAL::POSITIVE)
      return false;
  return true;
}

// Whether no edge of the hull is reflex. Beside positive cells, that proves that the cells tile the hull.
template <typename Triangulation>
bool hull_is_convex(const Triangulation& tr)
{
  if(tr.dimension() < 3)
    return true;
  for(const auto c : tr.all_cell_handles())
    for(int i = 0; i < 4; ++i)
      if(tr.is_infinite(c) && ! tr.is_infinite(c->vertex(i)) &&
         orientation_of(tr, c, tr.mirror_vertex(c, i)) == CGAL::POSITIVE) // the next hull facet is in front of this one
        return false;
  return true;
}

std::string quoted(const std::string& text)
{
  std::string s = "\"";
  for(const char c : text)
  {
    char code[8];
    std::snprintf(code, sizeof(code), "\\u%04x", static_cast<unsigned int>(static_cast<unsigned char>(c)));
    s += c == '"' || c == '\\' || static_cast<unsigned char>(c) < 0x20 ? std::string(code) : std::string(1, c);
  }
  return s + '"';
}

std::string model_name(const std::string& file)
{
  const std::size_t slash = file.find_last_of("/\\");
  const std::string name = slash == std::string::npos ? file : file.substr(slash + 1);
  return name.substr(0, name.rfind('.'));
}

template <typename Result>
void print_phases(std::ostream& os, const Result& result)
{
  os << ", \"phases\": [";
  for(std::size_t i = 0; i < result.phases.size(); ++i)
    os << (i == 0 ? "" : ", ") << "{\"phase\": \"" << to_string(result.phases[i].phase)
       << "\", \"lost_edges\": " << result.phases[i].lost_edges
       << ", \"lost_facets\": " << result.phases[i].lost_facets
       << ", \"seconds\": " << result.phases[i].seconds << '}';
  os << ']';
}

template <typename Result>
void print_levels(std::ostream& os, const Result& result)
{
  os << ", \"levels\": [";
  for(std::size_t i = 0; i < result.levels.size(); ++i)
  {
    const auto& level = result.levels[i];
    os << (i == 0 ? "" : ", ") << "{\"phase\": \"" << to_string(level.phase) << "\", \"level\": "
       << level.max_recursion_level << ", \"n1\": " << level.n1 << ", \"n2\": " << level.n2
       << ", \"n3\": " << level.n3 << ", \"n4\": " << level.n4 << '}';
  }
  os << ']';
}

// what was lost after the insertion, and how long what took; `seconds` is the duration of the whole call
template <typename Result>
void print_account(std::ostream& os, const Result& result, const double seconds)
{
  double insertion = 0, phases = 0;
  std::size_t lost_edges = result.missing_edges.size(), lost_facets = result.missing_facets.size();
  for(const auto& phase : result.phases)
  {
    (phase.phase == Phase::insertion ? insertion : phases) += phase.seconds;
    if(phase.phase == Phase::search)
    {
      lost_edges = phase.lost_edges;
      lost_facets = phase.lost_facets;
    }
  }
  os << ", \"status\": \"" << to_string(result.status) << "\", \"defects\": " << result.defects.size()
     << ", \"lost_edges_at_start\": " << lost_edges << ", \"lost_facets_at_start\": " << lost_facets
     << ", \"lost_edges\": " << result.missing_edges.size()
     << ", \"lost_facets\": " << result.missing_facets.size()
     << ", \"constraint_points\": " << result.number_of_constraint_points
     << ", \"steiner_points_after_splitting\": " << result.number_of_steiner_points
     << ", \"steiner_points\": " << result.steiner_vertices.size()
     << ", \"shell_transformations\": " << result.number_of_shell_transformations;
  print_phases(os, result);
  os << ", \"insertion_seconds\": " << insertion << ", \"recovery_seconds\": " << seconds - insertion
     << ", \"phases_seconds\": " << phases;
}

// what a look at the triangulation gives
template <typename Triangulation, typename Result>
void print_checks(std::ostream& os, const Triangulation& tr, const Result& result, const Surface& surface)
{
  os << std::boolalpha << ", \"is_valid\": " << is_valid_as_base(tr) << ", \"tds_is_valid\": "
     << tr.tds().is_valid() << ", \"cells_are_positive\": " << cells_are_positive(tr)
     << ", \"hull_is_convex\": " << hull_is_convex(tr);
  if(result.status == Status::invalid_input || result.vertices.size() != surface.points.size())
    return; // nobody knows which vertex is which
  const Vertex_numbers<Triangulation> number(tr, result);
  const std::vector<Cell> cells = indexed_cells(tr, number);
  char text[24];
  std::snprintf(text, sizeof(text), "%016llx", static_cast<unsigned long long>(checksum(cells)));
  const auto domain = cells_of_domain(tr, result);
  os << ", \"steiner_points_in_domain\": " << number_of_steiner_points(result, domain);
  os << ", \"domain_is_hull\": " << (domain.size() == tr.number_of_finite_cells());
  print_kinds_of_steiner_points(os, result, domain);
  print_quality(os, domain);
  os << ", \"recount_agrees\": " << recount_agrees(result, surface, cells, number)
     << ", \"checksum\": \"" << text << '"';
}

// Returns false if a file cannot be written.
template <typename Kernel>
bool measure(const Options& options, const Surface& surface)
{
  typedef CGAL::Delaunay_triangulation_3<Kernel> Triangulation;

  std::vector<typename Kernel::Point_3> points;
  const CGAL::Cartesian_converter<Epick, Kernel> convert;
  for(const Epick::Point_3& p : surface.points)
    points.push_back(convert(p));

  Triangulation tr;
  CGAL::Real_timer timer;
  timer.start();
  const auto result = CGAL::recover_boundary(tr, points, surface.faces,
    CGAL::parameters::maximum_running_time(options.time_limit),
    CGAL::parameters::recovery_mode(options.mode));
  timer.stop();
  const double memory = br3_benchmark::peak_memory(); // before the checks take some

  std::ostream& os = std::cout;
  os.precision(9);
  os << "{\"model\": " << quoted(model_name(options.input))
     << ", \"mode\": \"" << names_of_modes[static_cast<int>(options.mode)]
     << "\", \"kernel\": \"" << (options.is_exact ? "epeck" : "epick")
     << "\", \"vertices\": " << surface.points.size() << ", \"facets\": " << surface.faces.size()
     << ", \"edges\": " << edges_of(surface.faces).size();
  print_account(os, result, timer.time());
  os << ", \"peak_memory_mb\": " << memory;
  print_checks(os, tr, result, surface);
  if(options.check && result.status != Status::invalid_input)
  {
    double deviation = 0;
    os << ", \"verdict\": " << quoted(verdict(tr, result, surface, options.mode, deviation));
    os << ", \"deviation\": " << deviation;
  }
  if(options.table)
    print_levels(os, result);
  os << '}' << std::endl;
  return options.mesh.empty() || result.vertices.size() != surface.points.size()
      || write_mesh(options.mesh, result, cells_of_domain(tr, result));
}

// The phases of a recovery, a name per line.
void print_names_of_phases(std::ostream& os)
{
  for(int i = 0; i <= static_cast<int>(Phase::recount); ++i)
    os << static_cast<Phase>(i) << '\n';
}

int main(int argc, char* argv[])
{
  if(argc == 2 && argv[1] == std::string("--phases"))
  {
    print_names_of_phases(std::cout);
    return measured;
  }
  Options options;
  if(! parse(argc, argv, options))
  {
    std::cerr << usage;
    return usage_or_file_error;
  }
  Surface surface;
  bool is_read = false;
  try
  {
    is_read = read_surface(options.input, surface);
  }
  catch(const std::exception&) { } // an index or a size that the file cannot have
  if(! is_read || (! options.surface.empty() && ! write_surface(options.surface, surface)))
  {
    std::cerr << "benchmark_recovery: cannot " << (is_read ? "write " + options.surface : "read " + options.input)
              << std::endl;
    return usage_or_file_error;
  }
  try
  {
    if(! (options.is_exact ? measure<Epeck>(options, surface) : measure<Epick>(options, surface)))
    {
      std::cerr << "benchmark_recovery: cannot write " << options.mesh << std::endl;
      return usage_or_file_error;
    }
  }
  catch(const std::exception& e)
  {
    std::cerr << "benchmark_recovery: " << e.what() << std::endl;
    return exception_caught;
  }
  return measured;
}

#ifndef BOUNDARY_RECOVERY_3_PYTHON_PLAIN_INTERFACE_H
#define BOUNDARY_RECOVERY_3_PYTHON_PLAIN_INTERFACE_H

// What passes between the half of the module that knows Python and the half that knows CGAL. Neither includes the
// headers of the other one, since both take long to be compiled.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace boundary_recovery {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t no_limit = (std::numeric_limits<std::size_t>::max)();

// The caller's rows of coordinates, where they are.
struct Point_rows
{
  const char* data = nullptr;
  std::size_t size = 0;
  std::ptrdiff_t row_stride = 0, column_stride = 0; // in bytes

  double operator()(const std::size_t i, const std::size_t j) const
  {
    return *reinterpret_cast<const double*>(data + std::ptrdiff_t(i) * row_stride + std::ptrdiff_t(j) * column_stride);
  }
};

// The caller's rows of numbers of points, where they are, in the type that they have.
struct Index_rows
{
  enum class Type { int32, uint32, int64, uint64 };

  const char* data = nullptr;
  std::size_t size = 0;
  std::ptrdiff_t row_stride = 0, column_stride = 0; // in bytes
  Type type = Type::int64;

  // A negative number becomes one that is too large, which is refused as such.
  std::size_t operator()(const std::size_t i, const std::size_t j) const
  {
    const char* const p = data + std::ptrdiff_t(i) * row_stride + std::ptrdiff_t(j) * column_stride;
    switch(type)
    {
      case Type::int32:  return static_cast<std::size_t>(*reinterpret_cast<const std::int32_t*>(p));
      case Type::uint32: return *reinterpret_cast<const std::uint32_t*>(p);
      default:           return static_cast<std::size_t>(*reinterpret_cast<const std::uint64_t*>(p));
    }
  }
};

// Rows of numbers that the module makes. They are not set to zero first, and become an array of Python without a copy.
template <typename T>
struct Rows
{
  std::unique_ptr<T[]> data;
  std::size_t size = 0, width = 1;

  Rows() = default;
  Rows(const std::size_t size, const std::size_t width) : data(new T[size * width]), size(size), width(width) { }

  T* operator[](const std::size_t i) { return data.get() + i * width; }
  const T* operator[](const std::size_t i) const { return data.get() + i * width; }
};

// The account of the work, which becomes a dictionary.
struct Record;
typedef std::variant<bool, std::int64_t, double, std::string, std::vector<double>, std::vector<Record> > Value;

struct Record
{
  std::vector<std::pair<std::string, Value> > entries;

  void add(const char* key, const bool value) { entries.emplace_back(key, value); }
  void add(const char* key, const int value) { entries.emplace_back(key, std::int64_t(value)); }
  void add(const char* key, const std::size_t value) { entries.emplace_back(key, std::int64_t(value)); }
  void add(const char* key, const double value) { entries.emplace_back(key, value); }
  void add(const char* key, const char* value) { entries.emplace_back(key, std::string(value)); }
  void add(const char* key, std::string value) { entries.emplace_back(key, std::move(value)); }
  void add(const char* key, std::vector<double> value) { entries.emplace_back(key, std::move(value)); }
  void add(const char* key, std::vector<Record> value) { entries.emplace_back(key, std::move(value)); }
};

// What the user wants to hear, and whether he wants the work to go on.
class Watch
{
public:
  virtual ~Watch() = default;
  virtual bool go_further() = 0;
  virtual void tell(const char* phase, double share, bool is_urgent) = 0;
};

// The user's function of sizes.
class Size_function
{
public:
  virtual ~Size_function() = default;
  virtual double operator()(double x, double y, double z) = 0; // NaN after an exception
};

struct Source
{
  int shape = 0; // the number of its points, from 1 to 3; 4: a box
  std::array<std::array<double, 3>, 3> points = {{ {{ 0, 0, 0 }}, {{ 0, 0, 0 }}, {{ 0, 0, 0 }} }};
  double size = 0, radius = 0, growth = 0;
  bool is_doubling = false; // `growth` is the distance where the size has doubled, not the grading
};

// The sizes that the user asks for: the smallest one of all that are there.
struct Sizes
{
  double uniform = infinity;
  bool is_from_surface = false;
  const double* at_points = nullptr;
  Size_function* function = nullptr;
  std::vector<Source> sources;
  std::string source_file;
  Point_rows background_points;
  Index_rows background_tetrahedra;
  const double* background_sizes = nullptr;
  std::string background_file;
  double grading = 0.3;
};

struct Options
{
  std::string mode = "constrained", recovery_effort = "more_time", effort = "normal";
  bool insert_field_points = true, improve = true, list_defects = false, is_outside_wanted = false;
  double min_angle = 25, time_limit = infinity;
  std::size_t max_vertices = no_limit, max_defects = 10000, layers = 2, threads = 0;
};

// A defect of the input: what kind of simplices, and which; `no_index` for those that have no number.
struct Simplex
{
  int dimension = -1;
  std::int64_t index = -1;
  std::vector<std::int64_t> vertices;
  std::vector<double> coordinates; // of all its vertices, if they have any
};

struct Defect
{
  std::string kind;
  std::vector<Simplex> simplices;
};

// What is known of a tetrahedron that stayed bad.
struct Bad_cell
{
  std::int64_t tetrahedron = -1;
  double angle = 0, surface_angle = 0, distance = 0;
  std::array<std::int64_t, 2> edge = {{ -1, -1 }};
  std::string reason;
  std::vector<std::array<std::int64_t, 3> > facets; // the numbers of their points
  std::vector<std::int64_t> triangles;              // those of the input that they are, -1: none
};

struct Mesh
{
  std::string status, recovery_status, message;
  Rows<double> points;
  Rows<std::int64_t> tetrahedra;
  Rows<std::int32_t> regions;
  Rows<std::int64_t> triangles, triangle_numbers;
  Rows<std::int64_t> edges, point_numbers; // of the caller, where that is not clear
  std::vector<Bad_cell> bad_cells;
  std::vector<Defect> defects;
  std::size_t number_of_defects = 0;
  std::vector<Simplex> missing;
  Record report;
};

// What comes of the remeshing of holes.
struct Remeshed
{
  Mesh mesh; // `triangles` are the constrained facets
  Rows<std::int64_t> tetrahedron_numbers; // of the old mesh
  Rows<std::int64_t> location_cells;      // for each new vertex, the old tetrahedron where it is
  Rows<double> location_weights;
};

struct Surface_arrays
{
  Rows<double> points;
  Rows<std::int64_t> triangles, triangle_numbers, point_numbers;
  Rows<std::int32_t> patches;
  std::map<int, std::string> patch_names;
  std::vector<std::string> notes;
  Record changes;
  std::string message; // not empty: it could not be read
};

// The caller's mesh, where it is. Numbers of points are below their number.
struct Mesh_view
{
  Point_rows points;
  Index_rows tetrahedra, triangles;
  const std::int32_t* regions = nullptr; // of each tetrahedron
  const std::int32_t* patches = nullptr; // of each triangle
  const std::int64_t* triangle_numbers = nullptr;
  std::map<int, std::string> patch_names, region_names;
};

Mesh tetrahedralize(const Point_rows& points, const Index_rows& triangles, const Index_rows& edges, const Sizes& sizes,
                    const Options& options, Watch& watch);
Mesh improve(const Point_rows& points, const Index_rows& tetrahedra, const std::int64_t* regions,
             const Index_rows& facets, const Index_rows& edges, const Options& options, Watch& watch);
Remeshed remesh_holes(const Point_rows& points, const Index_rows& tetrahedra, const std::int64_t* regions,
                      const unsigned char* is_selected, const Index_rows& facets, const Index_rows& edges,
                      const Sizes* sizes, const Options& options, Watch& watch);
Surface_arrays read_surface_file(const std::string& file);
Surface_arrays repair_surface(const Point_rows& points, const Index_rows& triangles, double tolerance);
bool writes_mesh_files(const std::string& extension);
// returns 0, or what `errno` tells of the file
int write_mesh_file(const std::string& file, const Mesh_view& mesh, int order);

} // namespace boundary_recovery

#endif // BOUNDARY_RECOVERY_3_PYTHON_PLAIN_INTERFACE_H

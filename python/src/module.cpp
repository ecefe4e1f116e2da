// The half of the module that knows Python: arrays, callbacks, exceptions, signals.

#include "plain_interface.h"
#include "sampled_sizes.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <exception>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace py = pybind11;

namespace boundary_recovery {
namespace {

// The first exception that came out of Python while the library worked, through which no exception may pass.
class Held_exception
{
  std::exception_ptr m_exception;

public:
  bool is_there() const { return m_exception != nullptr; }

  void hold_current()
  {
    if(! m_exception)
      m_exception = std::current_exception();
  }

  // when the library has returned
  void rethrow()
  {
    if(m_exception)
      std::rethrow_exception(std::exchange(m_exception, nullptr));
  }
};

// Asks Python from time to time whether there was a signal, as by Ctrl-C, and calls the user's function of progress.
class Python_watch
  : public Watch
{
  typedef std::chrono::steady_clock Clock;

  static constexpr std::chrono::milliseconds pause{50};

  const py::object m_progress;
  Held_exception& m_exception;
  bool m_is_stopped = false;
  Clock::time_point m_last_check = Clock::now(), m_last_call = Clock::now();

public:
  Python_watch(const py::object& progress, Held_exception& exception) : m_progress(progress), m_exception(exception) { }

  bool go_further() override
  {
    if(m_is_stopped || m_exception.is_there())
      return false;
    if(! is_due(m_last_check))
      return true;
    const py::gil_scoped_acquire acquire;
    return guarded([] { if(PyErr_CheckSignals() != 0) throw py::error_already_set(); });
  }

  void tell(const char* const phase, const double share, const bool is_urgent) override
  {
    if(m_is_stopped || m_exception.is_there() || m_progress.is_none() || ! (is_due(m_last_call) || is_urgent))
      return;
    const py::gil_scoped_acquire acquire;
    guarded([&] { m_is_stopped = is_false(m_progress(phase, share)); });
  }

private:
  // Functions that return nothing, or a number, do not mean to stop the work.
  static bool is_false(const py::object& value)
  {
    PyObject* const p = value.ptr();
    return (PyBool_Check(p) || std::strncmp(Py_TYPE(p)->tp_name, "numpy.bool", 10) == 0) && PyObject_IsTrue(p) == 0;
  }

  static bool is_due(Clock::time_point& last)
  {
    const Clock::time_point now = Clock::now();
    if(now - last < pause)
      return false;
    last = now;
    return true;
  }

  // whether that went well
  template <typename F>
  bool guarded(const F& f)
  {
    try
    {
      f();
      return true;
    }
    catch(...)
    {
      m_exception.hold_current();
      return false;
    }
  }
};

// Calls the user's function of sizes: once for all points of the input, then for places in boxes, see `Sampled_sizes`.
class Python_sizes
  : public Size_function
{
  typedef Sampled_sizes::Place Place;

  struct Hash
  {
    std::size_t operator()(const Place& p) const
    {
      std::array<std::uint64_t, 3> bits;
      std::memcpy(bits.data(), p.data(), sizeof(bits));
      return ((bits[0] * 0x9E3779B97F4A7C15u ^ bits[1]) * 0xC2B2AE3D27D4EB4Fu ^ bits[2]) * 0x165667B19E3779F9u >> 8;
    }
  };

  const py::object m_function;
  Held_exception& m_exception;
  std::unordered_map<Place, double, Hash> m_known; // at the points of the input
  Sampled_sizes m_sampled;

public:
  Python_sizes(const py::object& function, Held_exception& exception) : m_function(function), m_exception(exception) { }

  void ask_at_points(const py::array& points)
  {
    const py::array_t<double, py::array::c_style | py::array::forcecast> rows(points);
    std::vector<Place> places(std::size_t(rows.shape(0)));
    Place low = {{ infinity, infinity, infinity }}, high = {{ -infinity, -infinity, -infinity }};
    for(std::size_t i = 0; i < places.size(); ++i)
      for(std::size_t j = 0; j < 3; ++j)
      {
        places[i][j] = rows.at(py::ssize_t(i), py::ssize_t(j));
        low[j] = (std::min)(low[j], places[i][j]);
        high[j] = (std::max)(high[j], places[i][j]);
      }
    if(places.empty())
      return;
    m_sampled.set_bounds(low, high);
    const std::vector<double> sizes = ask(places);
    m_known.reserve(places.size());
    for(std::size_t i = 0; i < places.size(); ++i)
      m_known.emplace(places[i], sizes[i]);
  }

  double operator()(const double x, const double y, const double z) override
  {
    const Place place = {{ x, y, z }};
    const auto known = m_known.find(place);
    if(known != m_known.end())
      return known->second;
    if(m_exception.is_there())
      return std::numeric_limits<double>::quiet_NaN();
    try
    {
      return m_sampled(place, [this](const std::vector<Place>& places)
      {
        const py::gil_scoped_acquire acquire;
        return ask(places);
      });
    }
    catch(...)
    {
      m_exception.hold_current();
      return std::numeric_limits<double>::quiet_NaN();
    }
  }

private:
  std::vector<double> ask(const std::vector<Place>& places) const
  {
    const py::ssize_t number = py::ssize_t(places.size());
    py::array_t<double> rows({ number, py::ssize_t(3) });
    std::memcpy(rows.mutable_data(), places.data(), places.size() * sizeof(Place));
    const auto sizes = py::array_t<double, py::array::c_style | py::array::forcecast>(m_function(rows));
    if(sizes.ndim() > 1 || (sizes.ndim() == 1 && sizes.size() != number))
      throw py::value_error("size: the function returned an array of " + std::to_string(sizes.size()) + " sizes, of " +
                            std::to_string(sizes.ndim()) + " dimensions, for " + std::to_string(number) + " places");
    if(sizes.ndim() == 0)
      return std::vector<double>(places.size(), sizes.data()[0]);
    return std::vector<double>(sizes.data(), sizes.data() + number);
  }
};

// views of arrays, and arrays of what was made

template <typename View>
void set_view(const py::array& array, const py::ssize_t width, View& view)
{
  if(array.ndim() != 2 || array.shape(1) != width)
    throw py::value_error("an array of " + std::to_string(width) + " columns is needed");
  view.data = static_cast<const char*>(array.data());
  view.size = std::size_t(array.shape(0));
  view.row_stride = array.strides(0);
  view.column_stride = array.strides(1);
}

Point_rows point_rows(const py::array& array)
{
  Point_rows view;
  if(! py::isinstance<py::array_t<double> >(array))
    throw py::type_error("points: an array of float64 is needed");
  set_view(array, 3, view);
  return view;
}

Index_rows index_rows(const py::array& array, const py::ssize_t width)
{
  Index_rows view;
  set_view(array, width, view);
  const char kind = array.dtype().kind();
  const auto item = array.itemsize();
  if((kind != 'i' && kind != 'u') || (item != 4 && item != 8))
    throw py::type_error("an array of integers of 4 or 8 bytes is needed");
  view.type = item == 4 ? (kind == 'i' ? Index_rows::Type::int32 : Index_rows::Type::uint32)
                        : (kind == 'i' ? Index_rows::Type::int64 : Index_rows::Type::uint64);
  return view;
}

// the numbers of an optional array that is contiguous and of this type
template <typename T>
const T* numbers_of(const py::object& object)
{
  if(object.is_none())
    return nullptr;
  const auto array = py::reinterpret_borrow<py::array>(object);
  if(array.ndim() != 1 || ! py::isinstance<py::array_t<T> >(object) || ! (array.flags() & py::array::c_style))
    throw py::type_error("a contiguous array of one dimension is needed");
  return static_cast<const T*>(array.data());
}

// The array of Python owns the memory then.
template <typename T>
py::array_t<T> as_array(Rows<T>& rows, const bool is_column = false)
{
  const py::ssize_t size = py::ssize_t(rows.size), width = py::ssize_t(rows.width);
  std::vector<py::ssize_t> shape = { size };
  if(! is_column)
    shape.push_back(width);
  if(! rows.data)
    return py::array_t<T>(shape);
  T* const data = rows.data.release();
  const py::capsule owner(data, [](void* const p) { delete[] static_cast<T*>(p); });
  return py::array_t<T>(shape, data, owner);
}

py::object as_python(const Record& record);

py::object as_python(const std::vector<Record>& records)
{
  py::list list;
  for(const Record& record : records)
    list.append(as_python(record));
  return std::move(list);
}

py::object as_python(const Record& record)
{
  py::dict dict;
  for(const auto& entry : record.entries)
    dict[py::str(entry.first)] = std::visit([](const auto& value) -> py::object
    {
      typedef std::decay_t<decltype(value)> T;
      if constexpr(std::is_same<T, std::vector<Record> >::value)
        return as_python(value);
      else
        return py::cast(value);
    }, entry.second);
  return std::move(dict);
}

py::dict as_python(const Simplex& simplex)
{
  py::dict dict;
  dict["dimension"] = simplex.dimension;
  dict["index"] = simplex.index;
  dict["vertices"] = py::tuple(py::cast(simplex.vertices));
  dict["coordinates"] = simplex.coordinates;
  return dict;
}

py::dict as_python(const Bad_cell& bad)
{
  py::dict dict;
  dict["tetrahedron"] = bad.tetrahedron;
  dict["angle"] = bad.angle;
  dict["edge"] = py::make_tuple(bad.edge[0], bad.edge[1]);
  dict["reason"] = bad.reason;
  dict["facets"] = py::cast(bad.facets);
  dict["triangles"] = py::cast(bad.triangles);
  dict["surface_angle"] = bad.surface_angle;
  dict["distance"] = bad.distance;
  return dict;
}

py::dict as_python(Mesh& mesh)
{
  py::dict dict;
  dict["status"] = mesh.status;
  dict["recovery_status"] = mesh.recovery_status;
  dict["message"] = mesh.message;
  dict["points"] = as_array(mesh.points);
  dict["tetrahedra"] = as_array(mesh.tetrahedra);
  dict["regions"] = as_array(mesh.regions, true);
  dict["triangles"] = as_array(mesh.triangles);
  dict["triangle_numbers"] = as_array(mesh.triangle_numbers, true);
  dict["edges"] = as_array(mesh.edges);
  dict["point_numbers"] = as_array(mesh.point_numbers, true);
  py::list bad_cells, defects, missing;
  for(const Bad_cell& bad : mesh.bad_cells)
    bad_cells.append(as_python(bad));
  for(const Defect& defect : mesh.defects)
  {
    py::list simplices;
    for(const Simplex& simplex : defect.simplices)
      simplices.append(as_python(simplex));
    defects.append(py::make_tuple(defect.kind, simplices));
  }
  for(const Simplex& simplex : mesh.missing)
    missing.append(as_python(simplex));
  dict["bad_cells"] = bad_cells;
  dict["defects"] = defects;
  dict["number_of_defects"] = mesh.number_of_defects;
  dict["missing"] = missing;
  dict["report"] = as_python(mesh.report);
  return dict;
}

// Empty arrays have their width all the same.
void set_widths(Mesh& mesh)
{
  mesh.points.width = 3;
  mesh.tetrahedra.width = 4;
  mesh.triangles.width = 3;
  mesh.edges.width = 2;
}

template <typename T>
void set(const py::dict& dict, const char* const key, T& value)
{
  if(dict.contains(key))
    value = dict[key].cast<T>();
}

Options options_of(const py::dict& dict)
{
  Options options;
  set(dict, "mode", options.mode);
  set(dict, "recovery_effort", options.recovery_effort);
  set(dict, "effort", options.effort);
  set(dict, "insert_field_points", options.insert_field_points);
  set(dict, "improve", options.improve);
  set(dict, "list_defects", options.list_defects);
  set(dict, "outside", options.is_outside_wanted);
  set(dict, "min_angle", options.min_angle);
  set(dict, "time_limit", options.time_limit);
  set(dict, "max_vertices", options.max_vertices);
  set(dict, "threads", options.threads);
  set(dict, "max_defects", options.max_defects);
  set(dict, "layers", options.layers);
  return options;
}

Source source_of(const py::handle object)
{
  Source source;
  source.shape = object.attr("_shape").cast<int>();
  const auto points = object.attr("points").cast<std::vector<std::array<double, 3> > >();
  for(std::size_t i = 0; i < 3; ++i)
    source.points[i] = points[i < points.size() ? i : points.size() - 1];
  source.size = object.attr("size").cast<double>();
  source.radius = object.attr("radius").cast<double>();
  source.is_doubling = ! object.attr("doubling").is_none();
  source.growth = object.attr(source.is_doubling ? "doubling" : "grading").cast<double>();
  return source;
}

// The dictionary keeps the arrays alive of which only the place is remembered here.
Sizes sizes_of(const py::dict& dict)
{
  Sizes sizes;
  set(dict, "uniform", sizes.uniform);
  set(dict, "is_from_surface", sizes.is_from_surface);
  set(dict, "grading", sizes.grading);
  set(dict, "source_file", sizes.source_file);
  set(dict, "background_file", sizes.background_file);
  if(dict.contains("at_points"))
    sizes.at_points = numbers_of<double>(dict["at_points"]);
  if(dict.contains("sources"))
    for(const py::handle source : dict["sources"])
      sizes.sources.push_back(source_of(source));
  if(dict.contains("background_points"))
  {
    sizes.background_points = point_rows(dict["background_points"].cast<py::array>());
    sizes.background_tetrahedra = index_rows(dict["background_tetrahedra"].cast<py::array>(), 4);
    sizes.background_sizes = numbers_of<double>(dict["background_sizes"]);
  }
  return sizes;
}

// Everything of Python that is called while the library works, and what came of it.
class Session
{
  Held_exception m_exception;
  Python_watch m_watch;
  std::unique_ptr<Python_sizes> m_function;

public:
  explicit Session(const py::object& progress) : m_watch(progress, m_exception) { }

  // the function of sizes, if there is one
  void add_function(const py::dict& dict, const py::array& points, Sizes& sizes)
  {
    if(! dict.contains("function"))
      return;
    m_function = std::make_unique<Python_sizes>(dict["function"], m_exception);
    m_function->ask_at_points(points);
    sizes.function = m_function.get();
  }

  // Lets other threads of Python run meanwhile.
  template <typename Work>
  auto operator()(const Work& work)
  {
    auto result = [&]
    {
      const py::gil_scoped_release release;
      auto made = work(static_cast<Watch&>(m_watch));
      give_memory_back();
      return made;
    }();
    m_exception.rethrow();
    return result;
  }

private:
  // Else the memory of the triangulation, several times that of the arrays, would stay with this process.
  static void give_memory_back()
  {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
  }
};

py::dict call_tetrahedralize(const py::array& points, const py::array& triangles, const py::array& edges,
                             const py::dict& size, const py::dict& options, const py::object& progress)
{
  Session session(progress);
  Sizes sizes = sizes_of(size);
  session.add_function(size, points, sizes);
  const Options plain = options_of(options);
  const Point_rows p = point_rows(points);
  const Index_rows t = index_rows(triangles, 3), e = index_rows(edges, 2);
  Mesh mesh = session([&](Watch& watch) { return tetrahedralize(p, t, e, sizes, plain, watch); });
  set_widths(mesh);
  return as_python(mesh);
}

py::dict call_improve(const py::array& points, const py::array& tetrahedra, const py::object& regions,
                      const py::array& facets, const py::array& edges, const py::dict& options,
                      const py::object& progress)
{
  Session session(progress);
  const Options plain = options_of(options);
  const Point_rows p = point_rows(points);
  const Index_rows t = index_rows(tetrahedra, 4), f = index_rows(facets, 3), e = index_rows(edges, 2);
  const std::int64_t* const r = numbers_of<std::int64_t>(regions);
  Mesh mesh = session([&](Watch& watch) { return improve(p, t, r, f, e, plain, watch); });
  set_widths(mesh);
  return as_python(mesh);
}

py::dict call_remesh_holes(const py::array& points, const py::array& tetrahedra, const py::object& regions,
                           const py::object& selected, const py::array& facets, const py::array& edges,
                           const py::object& size, const py::dict& options, const py::object& progress)
{
  Session session(progress);
  Sizes sizes;
  if(! size.is_none())
  {
    const auto dict = size.cast<py::dict>();
    sizes = sizes_of(dict);
    session.add_function(dict, points, sizes);
  }
  const Options plain = options_of(options);
  const Point_rows p = point_rows(points);
  const Index_rows t = index_rows(tetrahedra, 4), f = index_rows(facets, 3), e = index_rows(edges, 2);
  const std::int64_t* const r = numbers_of<std::int64_t>(regions);
  const auto s = reinterpret_cast<const unsigned char*>(numbers_of<bool>(selected));
  Remeshed remeshed = session([&](Watch& watch)
  {
    return remesh_holes(p, t, r, s, f, e, size.is_none() ? nullptr : &sizes, plain, watch);
  });
  set_widths(remeshed.mesh);
  py::dict dict = as_python(remeshed.mesh);
  remeshed.location_weights.width = 4;
  dict["tetrahedron_numbers"] = as_array(remeshed.tetrahedron_numbers, true);
  dict["location_cells"] = as_array(remeshed.location_cells, true);
  dict["location_weights"] = as_array(remeshed.location_weights);
  return dict;
}

py::dict as_python(Surface_arrays& surface)
{
  surface.points.width = surface.triangles.width = 3;
  py::dict dict;
  dict["message"] = surface.message;
  dict["points"] = as_array(surface.points);
  dict["triangles"] = as_array(surface.triangles);
  dict["triangle_numbers"] = as_array(surface.triangle_numbers, true);
  dict["point_numbers"] = as_array(surface.point_numbers, true);
  dict["patches"] = as_array(surface.patches, true);
  dict["patch_names"] = surface.patch_names;
  dict["notes"] = surface.notes;
  dict["changes"] = as_python(surface.changes);
  return dict;
}

py::dict call_read_surface(const std::string& file)
{
  Surface_arrays surface = [&]
  {
    const py::gil_scoped_release release;
    return read_surface_file(file);
  }();
  return as_python(surface);
}

py::dict call_repair_surface(const py::array& points, const py::array& triangles, const double tolerance)
{
  const Point_rows p = point_rows(points);
  const Index_rows t = index_rows(triangles, 3);
  Surface_arrays surface = [&]
  {
    const py::gil_scoped_release release;
    return repair_surface(p, t, tolerance);
  }();
  return as_python(surface);
}

// The dictionary keeps the arrays alive.
Mesh_view view_of_mesh(const py::dict& mesh)
{
  Mesh_view view;
  view.points = point_rows(mesh["points"].cast<py::array>());
  view.tetrahedra = index_rows(mesh["tetrahedra"].cast<py::array>(), 4);
  view.triangles = index_rows(mesh["triangles"].cast<py::array>(), 3);
  view.regions = numbers_of<std::int32_t>(mesh["regions"]);
  view.patches = numbers_of<std::int32_t>(mesh["patches"]);
  view.triangle_numbers = numbers_of<std::int64_t>(mesh["triangle_numbers"]);
  set(mesh, "patch_names", view.patch_names);
  set(mesh, "region_names", view.region_names);
  return view;
}

void call_write_mesh(const py::bytes& file, const py::dict& mesh, const int order)
{
  const std::string name = file;
  const Mesh_view view = view_of_mesh(mesh);
  const int error = [&]
  {
    const py::gil_scoped_release release;
    return write_mesh_file(name, view, order);
  }();
  if(error == 0)
    return;
  errno = error;
  PyErr_SetFromErrnoWithFilename(PyExc_OSError, name.c_str());
  throw py::error_already_set();
}

} // namespace
} // namespace boundary_recovery

PYBIND11_MODULE(_core, module)
{
  using namespace boundary_recovery;
  module.doc() = "The compiled half of boundary_recovery, which is the module to be used.";
  module.attr("version") = BOUNDARY_RECOVERY_3_VERSION;
  module.def("tetrahedralize", &call_tetrahedralize);
  module.def("improve", &call_improve);
  module.def("remesh_holes", &call_remesh_holes);
  module.def("read_surface", &call_read_surface);
  module.def("repair_surface", &call_repair_surface);
  module.def("writes_mesh_files", &writes_mesh_files);
  module.def("write_mesh", &call_write_mesh);
}

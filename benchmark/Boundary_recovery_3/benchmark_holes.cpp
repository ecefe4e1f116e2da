// What a remeshing costs: more and more holes in the same mesh, then more and more mesh around the same holes.
// Argument: N (default: 40); the meshes are grids of N * N * N small cubes, of six tetrahedra each, and longer ones.
// Prints a row for each remeshing. The exit status is 1 if anything failed, or if holes are not the same in all meshes.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Boundary_recovery_3/Hole_remeshing_result_3.h>
#include <CGAL/Random.h>
#include <CGAL/property_map.h>
#include <CGAL/remesh_holes.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Hole_remeshing_result_3<Kernel::Point_3>      Result;
typedef CGAL::Boundary_recovery_3::Phase                    Phase;
typedef std::array<std::size_t, 4>                          Tetrahedron;

// A grid of n * n * length cubes, whose inner vertices are not quite in their places. A longer one begins with the same
// points and tetrahedra as a shorter one, but for its end.
struct Grid
{
  std::vector<Kernel::Point_3> points;
  std::vector<Tetrahedron> tetrahedra;
  std::array<std::size_t, 3> strides;
  std::size_t n;

  Grid(const std::size_t n, const std::size_t length) : strides{{ 1, n + 1, (n + 1) * (n + 1) }}, n(n)
  {
    CGAL::Random random(7);
    const auto shifted = [&](const std::size_t i, const std::size_t last)
    {
      const double shift = random.uniform_real(-0.2, 0.2);
      return double(i) + (i == 0 || i == last ? 0 : shift);
    };
    for(std::size_t k = 0; k <= length; ++k)
      for(std::size_t j = 0; j <= n; ++j)
        for(std::size_t i = 0; i <= n; ++i)
        {
          const double x = shifted(i, n), y = shifted(j, n), z = shifted(k, length);
          points.emplace_back(x, y, z);
        }
    for(std::size_t k = 0; k < length; ++k)
      for(std::size_t j = 0; j < n; ++j)
        for(std::size_t i = 0; i < n; ++i)
          add_cube(i * strides[0] + j * strides[1] + k * strides[2]);
  }

  // Around the diagonal.
  void add_cube(const std::size_t v)
  {
    for(std::size_t a = 0; a < 3; ++a)
      for(std::size_t b = 0; b < 3; ++b)
        if(a != b)
        {
          const std::size_t w = v + strides[a];
          Tetrahedron t = {{ v, w, w + strides[b], v + strides[0] + strides[1] + strides[2] }};
          if(b != (a + 1) % 3)
            std::swap(t[1], t[2]);
          tetrahedra.push_back(t);
        }
  }

  std::size_t cell(const std::size_t i, const std::size_t j, const std::size_t k) const
  {
    return 6 * (i + n * (j + n * k));
  }
};

// A tetrahedron in the middle of each hole. With two layers around them, holes are some five cubes wide.
std::vector<bool> marks(const Grid& grid, const std::size_t number_of_holes)
{
  const std::size_t spacing = 7;
  std::vector<bool> result(grid.tetrahedra.size(), false);
  std::size_t number = 0;
  for(std::size_t k = spacing / 2; k + spacing / 2 < grid.n; k += spacing)
    for(std::size_t j = spacing / 2; j + spacing / 2 < grid.n; j += spacing)
      for(std::size_t i = spacing / 2; i + spacing / 2 < grid.n && number < number_of_holes; i += spacing, ++number)
        result[grid.cell(i, j, k)] = true;
  return result;
}

struct Is_marked
{
  typedef std::size_t                        key_type;
  typedef bool                               value_type;
  typedef bool                               reference;
  typedef boost::readable_property_map_tag   category;

  const std::vector<bool>* marks;

  friend bool get(const Is_marked& map, const std::size_t c) { return (*map.marks)[c]; }
};

void print_head()
{
  std::cout << "   cells holes new_cells selection recovery filling improvement sewing    all"
               "  passes/1e6_old work/1e6_new" << std::endl;
}

// The shortest of three times counts.
Result remesh(const Grid& grid, const std::size_t number_of_holes)
{
  const std::vector<bool> is_marked = marks(grid, number_of_holes);
  Result best;
  for(int run = 0; run < 3; ++run)
  {
    Result result = CGAL::remesh_holes(grid.points, grid.tetrahedra,
                                       CGAL::parameters::cell_is_selected_map(Is_marked{ &is_marked }));
    if(run == 0 || result.seconds < best.seconds)
      best = std::move(result);
  }
  const double new_cells = double(best.tetrahedra.size() - best.number_of_kept_cells);
  const double passes = best.seconds_of(Phase::hole_selection) + best.seconds_of(Phase::hole_sewing);
  const double work = best.seconds_of(Phase::hole_recovery) + best.seconds_of(Phase::hole_filling);
  std::cout << std::fixed << std::setprecision(3) << std::setw(8) << grid.tetrahedra.size() << std::setw(6)
            << best.number_of_holes << std::setw(10) << std::size_t(new_cells);
  const std::pair<Phase, int> columns[] = { { Phase::hole_selection, 10 }, { Phase::hole_recovery, 9 },
                                            { Phase::hole_filling, 8 }, { Phase::hole_improvement, 12 },
                                            { Phase::hole_sewing, 7 } };
  for(const auto& column : columns)
    std::cout << std::setw(column.second) << best.seconds_of(column.first);
  std::cout << std::setw(7) << best.seconds << std::setw(16) << 1e6 * passes / double(grid.tetrahedra.size())
            << std::setw(13) << 1e6 * work / new_cells << std::endl;
  return best;
}

// Whether there are so many holes, with cells that are not inverted.
bool is_good(const Result& result, const std::size_t number_of_holes)
{
  return result && result.number_of_holes == number_of_holes &&
         std::all_of(result.tetrahedra.begin() + std::ptrdiff_t(result.number_of_kept_cells), result.tetrahedra.end(),
                     [&](const Tetrahedron& t)
                     {
                       return CGAL::orientation(result.points[t[0]], result.points[t[1]], result.points[t[2]],
                                                result.points[t[3]]) == CGAL::POSITIVE;
                     });
}

int main(int argc, char** argv)
{
  const std::size_t n = argc > 1 ? std::stoul(argv[1]) : 40;
  const std::size_t in_row = n / 7, most = in_row * in_row * in_row;
  if(most == 0)
    return EXIT_FAILURE;

  std::cout << "more and more holes in the same mesh\n";
  print_head();
  const Grid grid(n, n);
  for(std::size_t number_of_holes = most; number_of_holes > 0; number_of_holes /= 2)
    if(! is_good(remesh(grid, number_of_holes), number_of_holes))
      return EXIT_FAILURE;

  std::cout << "more and more mesh around the same holes\n";
  print_head();
  std::size_t number_of_new_cells = 0;
  for(const std::size_t factor : { 1, 2, 4 })
  {
    const Result result = remesh(Grid(n, factor * n), most);
    const std::size_t number = result.tetrahedra.size() - result.number_of_kept_cells;
    if(! is_good(result, most) || (factor > 1 && number != number_of_new_cells))
      return EXIT_FAILURE;
    number_of_new_cells = number;
  }
  return EXIT_SUCCESS;
}

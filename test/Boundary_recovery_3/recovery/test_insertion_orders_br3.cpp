// The order in which points come: in every order all triangles are recovered, and each again to the same cells. Other
// orders may lead to other cells, also from the same Delaunay triangulation: nothing promises that they do not.
#undef NDEBUG

#include "exact_mesh_checker_br3.h"
#include "recover_and_judge_br3.h"
#include "recovered_mesh_br3.h"
#include "steiner_inputs_br3.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/recover_boundary.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <memory>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Delaunay_triangulation_3<Kernel>              Triangulation;
typedef CGAL::Boundary_recovery_result_3<Triangulation>     Result;
typedef br3_test::Portrait<Triangulation>                   Portrait;
typedef CGAL::Boundary_recovery_3::Recovery_mode            Mode;
typedef std::vector<Kernel::Point_3>                        Points;

// Points in general position: those of a surface are moved a little, all in their own ways.
br3_test::Plc moved(br3_test::Plc plc, const unsigned seed, const double distance)
{
  std::mt19937 random(seed);
  for(auto& p : plc.points)
    for(double& x : p)
      x += distance * (static_cast<double>(random() % 65536) / 65536 - 0.5);
  return plc;
}

// FNV-1a of all the points and cells, in an order that depends on them only.
std::uint64_t hash(const Portrait& portrait)
{
  std::uint64_t result = 14695981039346656037u;
  const auto add = [&](const std::uint64_t word)
  {
    for(int k = 0; k < 64; k += 8)
      result = (result ^ ((word >> k) & 255)) * 1099511628211u;
  };
  for(const auto& p : portrait.points)
    for(int k = 0; k < 3; ++k)
    {
      std::uint64_t word;
      const double x = p[k];
      std::memcpy(&word, &x, sizeof(word));
      add(word);
    }
  for(const auto& c : portrait.cells)
    for(const std::size_t v : c)
      add(v);
  return result;
}

// The order of the caller, its reverse, a spatial sort, and pseudo-random ones.
std::vector<std::vector<std::size_t> > orders(const Points& points)
{
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::vector<std::vector<std::size_t> > result = { order };
  result.emplace_back(order.rbegin(), order.rend());

  const std::set<Kernel::Point_3> known(points.begin(), points.end());
  assert(known.size() == points.size());
  Points sorted = points;
  CGAL::spatial_sort(sorted.begin(), sorted.end());
  result.emplace_back();
  for(const Kernel::Point_3& p : sorted)
    result.back().push_back(static_cast<std::size_t>(std::find(points.begin(), points.end(), p) - points.begin()));

  std::mt19937 random(3);
  for(int k = 0; k < 5; ++k)
  {
    for(std::size_t i = order.size(); i > 1; --i) // std::shuffle() differs between libraries
      std::swap(order[i - 1], order[random() % i]);
    result.push_back(order);
  }
  return result;
}

class Ordered_recoveries
{
public:
  Ordered_recoveries(const br3_test::Plc& plc, const Mode mode) : m_plc(plc), m_mode(mode)
  {
    for(const auto& c : plc.points)
      m_points.emplace_back(c[0], c[1], c[2]);
    for(const auto& t : plc.triangles)
      m_triangles.push_back({{ t[0], t[1], t[2] }});
  }

  // Returns the number of different outcomes.
  std::size_t operator()()
  {
    std::set<std::uint64_t> before, after;
    for(const auto& order : orders(m_points))
    {
      before.insert(hash(Portrait(*inserted(order))));
      const std::uint64_t h = recovered(order);
      std::vector<std::unique_ptr<char[]> > junk; // other addresses in the second run
      for(std::size_t i = 1; i < 300; ++i)
        junk.emplace_back(new char[(i * 7919) % 4000 + 1]);
      assert(recovered(order) == h);
      after.insert(h);
    }
    assert(before.size() == 1); // one Delaunay triangulation
    return after.size();
  }

private:
  std::unique_ptr<Triangulation> inserted(const std::vector<std::size_t>& order) const
  {
    auto tr = std::make_unique<Triangulation>();
    for(const std::size_t i : order)
      tr->insert(m_points[i]);
    return tr;
  }

  std::uint64_t recovered(const std::vector<std::size_t>& order) const
  {
    const auto tr = inserted(order);
    const Result result = CGAL::recover_boundary(*tr, m_points, m_plc.triangles,
                                                 CGAL::parameters::recovery_mode(m_mode));
    assert(result && result.number_of_inserted_vertices == 0);
    typedef br3_test::Recovered_mesh<Triangulation, Result> Mesh;
    br3_test::Exact_mesh_checker(Mesh(*tr, result, m_plc.points, m_triangles).mesh(), Mesh::kind(m_mode, result))();
    return hash(Portrait(*tr));
  }

  const br3_test::Plc m_plc;
  const Mode m_mode;
  Points m_points;
  std::vector<br3_test::Indexed_mesh::Facet> m_triangles;
};

int main()
{
  const struct { const char* name; br3_test::Plc plc; } inputs[] = {
    { "prism of 3", moved(br3_test::twisted_prism(3, .3, 1000, 1000), 1, 5) },
    { "prism of 12", moved(br3_test::twisted_prism(12, .3, 1000, 1000), 2, 0.01) },
    { "random", moved(br3_test::Random_constraints(5)(24, 40, 60, 0), 3, 0.001) } };
  for(const auto& input : inputs)
    for(const Mode mode : { Mode::constrained, Mode::conforming })
      std::cout << input.name << ": " << Ordered_recoveries(input.plc, mode)() << " outcomes" << std::endl;
  return EXIT_SUCCESS;
}

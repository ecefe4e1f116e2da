// Many operations in a row on random constrained meshes: their gain is what the cells tell before and afterwards, and
// when they are taken back, all is as it was, bit for bit, but for handles.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "improvement_judge_br3.h"

#include <CGAL/Boundary_recovery_3/Cell_quality_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Selected_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Badness_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Contract_bad_edge_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Flip_bad_cell_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Insert_vertex_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Move_vertex_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Random.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <set>
#include <tuple>
#include <vector>

namespace BR3 = CGAL::Boundary_recovery_3;
namespace internal = BR3::internal;
using br3_test::Improvement_options;
using br3_test::Lengths_slack;
typedef BR3::Dihedral_angle_quality_3 Quality;

template <typename Kernel>
struct Attempt
  : public br3_test::Improvement_trial<br3_test::Improvement_scene<Kernel>, Quality>
{
  typedef br3_test::Improvement_trial<br3_test::Improvement_scene<Kernel>, Quality>  Base;
  typedef typename Base::Mesh                                                        Mesh;
  typedef typename Base::Scene::Vertex_handle                                        Vertex_handle;
  typedef typename Base::Scene::Cell_handle                                          Cell_handle;
  using Base::scene;
  using Base::mesh;

  Attempt(const unsigned seed, const Improvement_options& options)
    : Base(seed, options, Quality(), Quality().of_angle(25))
  {
    double worst = std::numeric_limits<double>::infinity();
    for(const Cell_handle c : scene.cells())
      if(scene.contains(c))
        worst = (std::min)(worst, mesh.quality(c));
    mesh.set_measure_of_badness(internal::Badness_3(mesh.enough(), worst));
  }

  // Returns how often something was changed.
  int change_randomly(const int number_of_cells, CGAL::Random& random)
  {
    internal::Flip_bad_cell_3<Mesh> flip(mesh);
    internal::Contract_bad_edge_3<Mesh> contract(mesh);
    internal::Smooth_vertex_3<Mesh> smooth(mesh);
    internal::Insert_near_bad_cell_3<Mesh> insert(mesh);
    internal::Move_at_random_3<Mesh> move(mesh);
    int number = 0;
    for(int k = 0; k < number_of_cells; ++k)
    {
      const std::vector<Cell_handle> cells = scene.cells();
      const Cell_handle c = cells[random.uniform_int<std::size_t>(0, cells.size() - 1)];
      if(! scene.contains(c))
        continue;
      switch(random.get_int(0, 5))
      {
        case 0: number += flip.find(c) && flip.apply(); break;
        case 1: number += contract.find(c->vertex(0), 0) && contract.apply(); break;
        case 2: number += smooth(c->vertex(1)); break;
        case 3: number += insert.find_any(c, 3, random) && insert.apply(); break;
        default: number += move(c->vertex(random.get_int(0, 4)));
      }
    }
    return number;
  }

  // All that there is, by points instead of handles.
  typedef std::array<double, 3>                                       Place;
  typedef std::tuple<Place, int, double, double, double>              Corner; // dimension, size, lengths nearby
  typedef std::tuple<std::array<Corner, 4>, int, std::array<int, 4>, bool, std::array<Place, 4>>  Row;

  std::vector<Row> portrait() const
  {
    std::vector<Row> rows;
    for(const Cell_handle c : scene.tr.finite_cell_handles())
    {
      std::array<Corner, 4> corners;
      std::array<int, 4> patches;
      std::array<Place, 4> behind = {}; // the vertices that the neighbors have there
      for(int i = 0; i < 4; ++i)
      {
        const Vertex_handle v = c->vertex(i), opposite = scene.tr.mirror_vertex(c, i);
        const auto& lengths = mesh.allowed_lengths().of_constraints(v);
        corners[i] = Corner(Mesh::coordinates(v), v->in_dimension(), CGAL::to_double(v->meshing_info()),
                            lengths.least, lengths.largest);
        patches[i] = static_cast<int>(c->surface_patch_index(i));
        if(! scene.tr.is_infinite(opposite))
          behind[i] = Mesh::coordinates(opposite);
      }
      rows.emplace_back(corners, static_cast<int>(c->subdomain_index()), patches, scene.is_selected(c), behind);
    }
    std::sort(rows.begin(), rows.end());
    return rows;
  }

  double weight() const
  {
    double sum = 0;
    for(const Cell_handle c : scene.cells())
      if(scene.contains(c))
        sum += mesh.measure_of_badness().weight(mesh.quality(c));
    return sum;
  }
};

struct Numbers
{
  int changes = 0, kept = 0, undone = 0, renamed = 0;
};

// What is taken back, every other time, is as if it had not been; else, it stays.
template <typename Kernel>
void test_attempts(const unsigned seed, Numbers& numbers)
{
  typedef typename Attempt<Kernel>::Cell_handle Cell_handle;
  Improvement_options options;
  options.is_grid = seed % 4 == 0;
  options.size = seed % 3 == 0 ? 0.15 : 0;
  options.number_of_points = 100;
  Attempt<Kernel> t(seed, options);
  CGAL::Random random(seed);
  for(int k = 0; k < 8; ++k)
  {
    const auto before = t.portrait();
    const double weight = t.weight();
    const std::vector<Cell_handle> cells = t.scene.cells();
    const std::set<Cell_handle> old_cells(cells.begin(), cells.end());
    br3_test::Improvement_judge<typename Attempt<Kernel>::Scene, typename Attempt<Kernel>::Mesh> judge(t.scene, t.mesh);
    judge.remember_all();
    t.mesh.begin_attempt();
    const int number = t.change_randomly(k == 0 ? 0 : 60, random);
    assert((number == 0) == (t.portrait() == before));
    assert(std::abs(t.mesh.gain_of_attempt() - (weight - t.weight())) < 1e-9);
    judge.check_all();
    numbers.changes += number;
    if(k % 3 == 2)
    {
      const auto after = t.portrait();
      t.mesh.keep_attempt();
      assert(t.portrait() == after);
      ++numbers.kept;
      continue;
    }
    const std::vector<Cell_handle> came_back = t.mesh.undo_attempt();
    assert(t.portrait() == before);
    judge.check_all();
    const std::set<Cell_handle> all_that_came_back(came_back.begin(), came_back.end());
    for(const Cell_handle c : all_that_came_back)
      assert(t.scene.contains(c));
    for(const Cell_handle c : t.scene.cells())
      if(old_cells.count(c) == 0)
      {
        assert(all_that_came_back.count(c) > 0);
        ++numbers.renamed;
      }
    ++numbers.undone;
  }
}

// Vertices that are free go to places at random, none of them where cells would be too bad.
void test_random_moves(const unsigned seed, int& number)
{
  typedef Attempt<CGAL::Exact_predicates_inexact_constructions_kernel> Moves;
  Improvement_options options;
  options.size = seed % 2 == 0 ? 0.15 : 0;
  options.number_of_points = 100;
  Moves t(seed, options);
  internal::Move_at_random_3<Moves::Mesh> move(t.mesh);
  CGAL::Random random(seed);
  number += br3_test::try_on_all_cells(t.scene, t.mesh, Lengths_slack::none, [&](const Moves::Cell_handle c)
                                       { return move(c->vertex(random.get_int(0, 4))); },
                                       std::numeric_limits<double>::infinity());
}

int main()
{
  Numbers numbers;
  for(unsigned seed = 0; seed < 12; ++seed)
    test_attempts<CGAL::Exact_predicates_inexact_constructions_kernel>(seed, numbers);
  for(unsigned seed = 0; seed < 2; ++seed)
    test_attempts<CGAL::Exact_predicates_exact_constructions_kernel>(seed, numbers);
  int number_of_moves = 0;
  for(unsigned seed = 0; seed < 6; ++seed)
    test_random_moves(seed, number_of_moves);
  std::cout << numbers.changes << " changes; " << numbers.kept << " attempts kept, " << numbers.undone
            << " undone, with " << numbers.renamed << " cells that have other handles; " << number_of_moves << " moves"
            << std::endl;
  assert(numbers.changes > 500 && numbers.kept > 20 && numbers.undone > 50 && numbers.renamed > 500);
  assert(number_of_moves > 100);
  return 0;
}

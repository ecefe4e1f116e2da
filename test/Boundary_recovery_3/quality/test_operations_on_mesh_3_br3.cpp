// The operations led by quality on triangulations over CGAL's own bases, judged after each step: those of Mesh_3, with
// points that have weights, patches that are pairs and indices that are variants, and those of Tetrahedral_remeshing.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "improvement_judge_br3.h"

#include <CGAL/Boundary_recovery_3/Cell_quality_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Contract_bad_edge_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Flip_bad_cell_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Insert_vertex_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Move_vertex_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>
#include <CGAL/Triangulation_3.h>

#include <array>
#include <cassert>
#include <functional>
#include <iostream>
#include <set>
#include <type_traits>

namespace BR3 = CGAL::Boundary_recovery_3;
namespace internal = BR3::internal;
using br3_test::Improvement_options;
using br3_test::Lengths_slack;
typedef CGAL::Exact_predicates_inexact_constructions_kernel                 Kernel;
typedef BR3::Dihedral_angle_quality_3                                       Quality;
typedef CGAL::Mesh_triangulation_3<CGAL::Labeled_mesh_domain_3<Kernel> >::type  Mesh_tr;

// What convert_to_triangulation_3() makes of it.
typedef CGAL::Triangulation_3<Mesh_tr::Geom_traits, Mesh_tr::Triangulation_data_structure>  Mesh_3_triangulation;
typedef CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<Kernel>      Remeshing_triangulation;

template <typename Tr>
struct Operations
{
  typedef br3_test::Improvement_scene<Kernel, Tr>       Scene;
  typedef br3_test::Improvement_trial<Scene, Quality>   Trial;
  typedef typename Trial::Mesh                          Mesh;
  typedef typename Scene::Vertex_handle                 Vertex_handle;
  typedef typename Scene::Cell_handle                   Cell_handle;

  explicit Operations(const unsigned seed)
    : size(options(seed).size), trial(seed, options(seed), Quality(), Quality().of_angle(10 + seed % 4 * 10))
  { }

  static Improvement_options options(const unsigned seed)
  {
    Improvement_options result;
    result.size = seed % 3 == 0 ? 0.06 : seed % 3 == 1 ? 0.4 : 0;
    result.number_of_points = 80;
    return result;
  }

  template <typename Attempt>
  int operator()(const Lengths_slack slack, const Attempt& attempt)
  {
    return br3_test::try_on_all_cells(trial.scene, trial.mesh, slack, attempt);
  }

  int flip()
  {
    internal::Flip_bad_cell_3<Mesh> flip(trial.mesh);
    return (*this)(Lengths_slack::edges_that_go, [&](const Cell_handle c) { return flip.find(c) && flip.apply(); });
  }

  int smooth()
  {
    internal::Smooth_vertex_3<Mesh> smooth(trial.mesh);
    return (*this)(Lengths_slack::none, [&](const Cell_handle c) { return smooth(c->vertex(0)); });
  }

  int center()
  {
    internal::Center_vertex_3<Mesh> center(trial.mesh);
    return (*this)(Lengths_slack::none, [&](const Cell_handle c) { return center(c->vertex(0)); });
  }

  int contract()
  {
    internal::Contract_bad_edge_3<Mesh> contract(trial.mesh);
    return (*this)(Lengths_slack::none, [&](const Cell_handle c)
                   { return contract.find(c->vertex(0), 0) && contract.apply(); });
  }

  // New vertices have the indices of the region that they are in, and a size.
  int insert()
  {
    const std::set<Vertex_handle> before(trial.scene.tr.finite_vertex_handles().begin(),
                                         trial.scene.tr.finite_vertex_handles().end());
    internal::Insert_into_bad_cell_3<Mesh> insert(trial.mesh);
    const int number = (*this)(Lengths_slack::longest_edge,
                               [&](const Cell_handle c) { return insert.find(c) && insert.apply(); });
    for(const Cell_handle c : trial.scene.cells())
      for(int i = 0; i < 4; ++i)
        if(before.count(c->vertex(i)) == 0)
          check_new_vertex(c->vertex(i), static_cast<int>(c->subdomain_index()));
    return number;
  }

  void check_new_vertex(const Vertex_handle v, const int region) const
  {
    typedef std::decay_t<decltype(v->index())> Index;
    assert(v->in_dimension() == 3 && v->index() == Index(region));
    assert(v->meshing_info() >= size && v->meshing_info() <= 2 * size);
  }

  const double size; // no vertex has a smaller one
  Trial trial;
};

// Returns how many steps there were of each kind.
template <typename Tr>
std::array<int, 5> test(const char* const name)
{
  std::array<int, 5> number = {{ 0, 0, 0, 0, 0 }};
  for(unsigned seed = 0; seed < 12; ++seed)
  {
    number[0] += Operations<Tr>(seed).flip();
    number[1] += Operations<Tr>(seed).smooth();
    number[2] += Operations<Tr>(seed).contract();
    number[3] += Operations<Tr>(seed).insert();
    number[4] += Operations<Tr>(seed).center();
  }
  std::cout << name << ": " << number[0] << " flips, " << number[1] << " moves, " << number[2]
            << " contractions, " << number[3] << " insertions, " << number[4] << " centered" << std::endl;
  for(const int n : number)
    assert(n > 3);
  return number;
}

int main()
{
  const auto number = test<Mesh_3_triangulation>("Mesh_3");
  assert(test<Remeshing_triangulation>("Tetrahedral_remeshing") == number);
}

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/recover_boundary.h>

#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iostream>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Delaunay_triangulation_3<Kernel>              Triangulation;
typedef CGAL::Surface_mesh<Kernel::Point_3>                 Surface;

namespace BR3 = CGAL::Boundary_recovery_3;

//! [visitor]
// Prints what is going on, and gives up after so many cells were replaced.
struct Impatient_visitor
  : public CGAL::Default_meshing_visitor_3
{
  std::size_t patience;
  std::size_t number_of_replaced_cells = 0;

  explicit Impatient_visitor(const std::size_t patience) : patience(patience) { }

  void on_phase_begin(const BR3::Phase phase)
  {
    std::cout << to_string(phase) << std::endl;
  }

  void on_progress(BR3::Phase, const std::size_t done, const std::size_t total)
  {
    if(total < 10 || done % (total / 10) == 0) // ten lines or so for each pass
      std::cout << "  " << done << " of " << total << std::endl;
  }

  void on_phase_end(const BR3::Phase_report& report)
  {
    std::cout << "  lost: " << report.lost_edges << " edges, " << report.lost_facets << " facets" << std::endl;
  }

  template <typename CellRange>
  void before_cells_removal(const CellRange& cells)
  {
    number_of_replaced_cells += cells.size();
  }

  bool go_further() { return number_of_replaced_cells < patience; }
};
//! [visitor]

int main()
{
  Surface surface;
  if(! CGAL::IO::read_polygon_mesh(CGAL::data_file_path("meshes/gear_br3.off"), surface))
    return EXIT_FAILURE;

  // std::ref: not a copy, but this visitor is to be called.
  Triangulation tr;
  Impatient_visitor impatient(20);
  const auto stopped = CGAL::recover_boundary(tr, surface, CGAL::parameters::visitor(std::ref(impatient)));
  std::cout << to_string(stopped.status) << " with " << stopped.missing_facets.size() << " triangles missing after "
            << impatient.number_of_replaced_cells << " cells were replaced" << std::endl;

  // The triangulation is valid, so the work can go on where it was stopped.
  Impatient_visitor patient(std::size_t(-1));
  const auto result = CGAL::recover_boundary(tr, surface, CGAL::parameters::visitor(std::ref(patient)));
  std::cout << to_string(result.status) << std::endl;

  const bool was_stopped = stopped.status == BR3::Recovery_status::stopped && ! stopped.missing_facets.empty();
  return was_stopped && result && result.number_of_inserted_vertices == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

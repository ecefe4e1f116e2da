// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_REMESH_HOLES_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_REMESH_HOLES_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Hole_remeshing_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Hole_cells_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Hole_surface_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Hole_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Moved_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Sew_holes_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Tetrahedra_incidences_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/standard_types.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

// What the caller of remesh_holes() can choose.
template <typename Point_3>
struct Hole_remeshing_options_3
{
  double min_dihedral_angle = 0;                  // cells below it are bad
  double target_angle = 0;                        // of the improvement
  std::size_t number_of_layers = 0;
  bool improve_quality = true;
  bool has_unfilled_region = false;
  int unfilled_region = 0;                        // its cells are replaced, but get no field points
  std::function<bool(std::size_t)> is_selected;   // whether a tetrahedron is bad, whatever its shape
  std::function<double(const Point_3&, int)> size; // at a place in a region; none: the old sizes
  double grading = std::numeric_limits<double>::infinity(); // of these sizes
  std::function<bool()> can_go_further;
};

/*
 * The work behind remesh_holes(), one phase after the other.
 */
template <typename Kernel>
class Remesh_holes_3
{
public:
  typedef typename Kernel::Point_3          Point_3;
  typedef Moved_mesh_3<Point_3>             Mesh;
  typedef Hole_remeshing_result_3<Point_3>  Result;
  typedef Hole_remeshing_options_3<Point_3> Options;
  typedef Recovery_context<typename Hole_triangulation_3<Kernel>::Tr> Context;

  Remesh_holes_3(const Mesh& mesh, const Options& options, Context& context, Result& result)
    : m_mesh(mesh), m_options(options), m_context(context), m_result(result)
  { }

  // Writes the status, the account, and, if all is done, the mesh.
  void operator()();

private:
  typedef Hole_surface_3<Point_3>      Surface;
  typedef Hole_triangulation_3<Kernel> Triangulation;
  typedef Hole_defects_3<Point_3>      Defects;
  typedef Constrained_sides_3<Point_3> Constraints;

  struct Hole
  {
    std::size_t number; // in m_hole_cells
    Surface surface;
    std::unique_ptr<Triangulation> triangulation;
    bool is_filled = false;
    bool is_improved = false;
    std::vector<std::size_t> bad_vertices; // those of the surface at cells that stayed bad, as positions in the mesh
    std::array<std::size_t, 3> numbers_of_bad_cells = {{ 0, 0, 0 }}; // by their reasons
  };

  // See "Tuning constants" in the manual.
  static constexpr int max_number_of_rounds = 2;

  template <typename Work>
  void run(const Phase phase, const Work& work)
  {
    if(m_result.status != Meshing_status::meshed)
      return;
    m_context.run(phase, [&]
    {
      if(goes_on())
        work();
    },
    [this](Phase_report& report)
    {
      report.number_of_holes = m_holes.size();
      m_result.phases.push_back(report);
    });
  }

  // Whether nothing has ended the work.
  bool goes_on()
  {
    if(m_result.status == Meshing_status::meshed && ! m_context.go_further())
      m_result.status = Meshing_status::stopped;
    return m_result.status == Meshing_status::meshed;
  }

  // What ended it first is the reason.
  void end(const Meshing_status status)
  {
    if(m_result.status == Meshing_status::meshed)
      m_result.status = status;
  }

  void refuse(std::vector<typename Result::Input_defect>&& defects)
  {
    m_result.status = Meshing_status::invalid_input;
    for(auto& defect : defects)
      m_result.defects.push_back(std::move(defect));
  }

  bool is_unfilled(const int region) const
  {
    return m_options.has_unfilled_region && region == m_options.unfilled_region;
  }

  void select()
  {
    Check_moved_mesh_3<Point_3> check(m_mesh);
    if(! check.check_vertices())
      return refuse(std::move(check.defects()));
    m_incidences = std::make_unique<Tetrahedra_incidences_3>(m_mesh.points.size(), m_mesh.tetrahedra);
    m_constraints = std::make_unique<Constraints>(m_mesh, *m_incidences);
    if(! check.check_incidences(*m_incidences) || ! check.find_constraints(*m_constraints))
      return refuse(std::move(check.defects()));

    Find_bad_cells_3<Kernel> bad(m_mesh, m_options.min_dihedral_angle, m_options.is_selected,
                                 [this](const int region) { return is_unfilled(region); });
    m_result.number_of_bad_cells = bad.number_of_bad_cells;
    m_result.number_of_inverted_cells = bad.number_of_inverted_cells;
    m_is_bad = std::move(bad.is_bad);
    m_hole_cells = std::make_unique<Hole_cells_3>(m_mesh.tetrahedra, *m_incidences);
    for(std::size_t c = 0; c < m_is_bad.size(); ++c)
      if(m_is_bad[c])
        m_hole_cells->add(c);
    m_hole_cells->add_layers(m_options.number_of_layers);
  }

  // Until no hole grows.
  void recover_holes()
  {
    for(bool is_first_round = true; goes_on(); is_first_round = false)
    {
      const std::size_t first = m_hole_cells->form_holes(), last = m_hole_cells->number_of_holes();
      forget_lost_holes();
      std::vector<std::pair<std::size_t, std::vector<std::size_t> > > growing; // holes, and the vertices where
      for(std::size_t hole = first; hole < last && can_recover_more(); ++hole)
      {
        recover(hole, is_first_round, growing);
        m_context.visitor().on_progress(Phase::hole_recovery, hole - first + 1, last - first);
      }
      if(growing.empty() || ! goes_on())
        break;
      grow(growing);
    }
    std::sort(m_holes.begin(), m_holes.end(), [this](const Hole& a, const Hole& b)
    {
      return m_hole_cells->cells(a.number).front() < m_hole_cells->cells(b.number).front();
    });
    m_result.number_of_holes = m_holes.size();
  }

  // Where input is invalid, other holes tell what else is.
  bool can_recover_more() { return goes_on() || m_result.status == Meshing_status::invalid_input; }

  // Those that others have reached.
  void forget_lost_holes()
  {
    const auto is_lost = [this](const Hole& hole) { return m_hole_cells->cells(hole.number).empty(); };
    m_holes.erase(std::remove_if(m_holes.begin(), m_holes.end(), is_lost), m_holes.end());
  }

  void recover(const std::size_t number, const bool is_first_round,
               std::vector<std::pair<std::size_t, std::vector<std::size_t> > >& growing)
  {
    Hole hole{ number,
               Surface(m_mesh, *m_incidences, *m_constraints, *m_hole_cells, m_hole_cells->cells(number)),
               std::make_unique<Triangulation>(m_options.can_go_further), false, false, { }, {{ 0, 0, 0 }} };
    const auto recovery = hole.triangulation->recover(hole.surface, ! is_first_round);
    Defects defects(m_mesh, *m_constraints, hole.surface);
    switch(recovery.status)
    {
      case Recovery_status::recovered:
        if(hole.triangulation->mark(hole.surface, unfilled_number(hole.surface)))
          m_holes.push_back(std::move(hole));
        else
          grow_everywhere(hole, Input_defect_kind::inverted_region, growing);
        break;
      case Recovery_status::invalid_input:
        defects.add(recovery.defects);
        if(! defects.defects().empty())
          refuse(std::vector<typename Result::Input_defect>(defects.defects()));
        else if(defects.is_flat())
          grow_everywhere(hole, Input_defect_kind::dimension_less_than_3, growing);
        else
          growing.emplace_back(number, defects.growing_vertices());
        break;
      case Recovery_status::incomplete:
        ++m_result.number_of_failures;
        grow_everywhere(hole, Input_defect_kind::empty_input, growing);
        break;
      case Recovery_status::stopped:
        end(Meshing_status::stopped);
        break;
    }
  }

  int unfilled_number(const Surface& surface) const
  {
    const auto it = std::find(surface.regions.begin() + 1, surface.regions.end(), m_options.unfilled_region);
    return ! m_options.has_unfilled_region || it == surface.regions.end() ? -1
         : static_cast<int>(it - surface.regions.begin());
  }

  // By a layer. If there is none, that is the end: then `kind` is what was wrong, `empty_input` meaning nothing.
  void grow_everywhere(const Hole& hole, const Input_defect_kind kind,
                       std::vector<std::pair<std::size_t, std::vector<std::size_t> > >& growing)
  {
    if(can_grow_at(hole.surface.vertices))
      growing.emplace_back(hole.number, hole.surface.vertices);
    else if(kind == Input_defect_kind::empty_input)
      end(Meshing_status::incomplete);
    else
      refuse({ { kind, { describe_tetrahedron(m_mesh, m_hole_cells->cells(hole.number).front()) } } });
  }

  // Whether there is a cell that is in no hole.
  bool can_grow_at(const std::vector<std::size_t>& vertices) const
  {
    const auto has_kept_cell = [this](const std::size_t v)
    {
      const auto star = m_incidences->cells(v);
      return std::any_of(star.begin(), star.end(), [this](const std::size_t c) { return ! m_hole_cells->contains(c); });
    };
    return std::any_of(vertices.begin(), vertices.end(), has_kept_cell);
  }

  // Cells may have to be bad because the boundary of a hole is: it grows there. Returns false if there is nothing to be
  // done.
  bool grow_at_bad_cells()
  {
    std::vector<std::pair<std::size_t, std::vector<std::size_t> > > growing;
    for(const Hole& hole : m_holes)
      if(can_grow_at(hole.bad_vertices))
        growing.emplace_back(hole.number, hole.bad_vertices);
    grow(growing);
    m_result.number_of_enlargements -= growing.size();
    m_result.number_of_enlargements_for_quality += growing.size();
    return ! growing.empty();
  }

  void grow(const std::vector<std::pair<std::size_t, std::vector<std::size_t> > >& growing)
  {
    for(const auto& hole_and_vertices : growing)
    {
      m_hole_cells->dissolve(hole_and_vertices.first);
      for(const std::size_t v : hole_and_vertices.second)
        m_hole_cells->add_star(v);
      ++m_result.number_of_enlargements;
    }
  }

  void fill_holes()
  {
    for(std::size_t k = 0; k < m_holes.size() && goes_on(); ++k)
    {
      Hole& hole = m_holes[k];
      if(std::exchange(hole.is_filled, true))
        continue;
      const auto filling = hole.triangulation->fill(sizes(hole));
      m_result.status = filling.status;
      m_result.invalid_sizes = filling.invalid_sizes;
      m_context.visitor().on_progress(Phase::hole_filling, k + 1, m_holes.size());
    }
  }

  Hole_sizes_3<Point_3> sizes(const Hole& hole) const
  {
    if(m_options.size)
      return { [this, &hole](const Point_3& p, const int region)
               { return m_options.size(p, hole.surface.regions[static_cast<std::size_t>(region)]); },
               m_options.grading, false };
    const auto old_sizes = std::make_shared<Old_sizes_3>(m_mesh, *m_incidences, m_is_bad,
                                                         m_hole_cells->cells(hole.number));
    return { [old_sizes](const Point_3& p, const int) { return (*old_sizes)(internal::coordinates_of(p)); },
             double(Old_sizes_3::grading), true };
  }

  void improve_holes()
  {
    for(std::size_t k = 0; k < m_holes.size() && goes_on(); ++k)
    {
      Hole& hole = m_holes[k];
      if(std::exchange(hole.is_improved, true))
        continue;
      const auto improvement = hole.triangulation->improve(m_options.target_angle);
      m_result.status = improvement.status;
      hole.numbers_of_bad_cells = {{ improvement.certificate.number_of_cells(Bad_cell_reason::forced)
                                       + improvement.certificate.number_of_cells(Bad_cell_reason::gap),
                                     improvement.certificate.number_of_cells(Bad_cell_reason::needle),
                                     improvement.certificate.number_of_cells(Bad_cell_reason::not_improved) }};
      for(const std::size_t v : hole.triangulation->vertices_of_bad_cells(improvement, m_options.min_dihedral_angle))
        hole.bad_vertices.push_back(hole.surface.vertices[v]);
      m_context.visitor().on_progress(Phase::hole_improvement, k + 1, m_holes.size());
    }
  }

  void sew()
  {
    Sew_holes_3<Kernel> sew_holes(m_mesh, *m_incidences, *m_hole_cells, m_result);
    for(const Hole& hole : m_holes)
      sew_holes.expect(hole.surface, *hole.triangulation);
    sew_holes.copy();
    for(Hole& hole : m_holes)
    {
      sew_holes.add(hole.surface, *hole.triangulation, m_hole_cells->cells(hole.number));
      const std::size_t n = hole.triangulation->number_of_steiner_points();
      m_result.number_of_steiner_points += n;
      m_result.number_of_holes_with_steiner_points += n > 0 ? 1 : 0;
      m_result.number_of_forced_cells += hole.numbers_of_bad_cells[0];
      m_result.number_of_needles += hole.numbers_of_bad_cells[1];
      m_result.number_of_unimproved_cells += hole.numbers_of_bad_cells[2];
      hole.triangulation.reset();
    }
  }

  const Mesh& m_mesh;
  const Options& m_options;
  Context& m_context;
  Result& m_result;
  std::unique_ptr<Tetrahedra_incidences_3> m_incidences;
  std::unique_ptr<Constraints> m_constraints;
  std::vector<char> m_is_bad; // of the tetrahedra
  std::unique_ptr<Hole_cells_3> m_hole_cells;
  std::vector<Hole> m_holes;
};

template <typename Kernel>
void Remesh_holes_3<Kernel>::operator()()
{
  m_result.status = Meshing_status::meshed;
  run(Phase::hole_selection, [this] { select(); });
  for(int round = 0; round < max_number_of_rounds; ++round)
  {
    run(Phase::hole_recovery, [this] { recover_holes(); });
    run(Phase::hole_filling, [this] { fill_holes(); });
    if(m_options.improve_quality)
      run(Phase::hole_improvement, [this] { improve_holes(); });
    if(round + 1 == max_number_of_rounds || m_result.status != Meshing_status::meshed || ! grow_at_bad_cells())
      break;
  }
  run(Phase::hole_sewing, [this] { sew(); });
}

#ifdef CGAL_BOUNDARY_RECOVERY_3_COMPILED

extern template void Remesh_holes_3<Standard_kernel>::operator()();

#endif // CGAL_BOUNDARY_RECOVERY_3_COMPILED

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_REMESH_HOLES_3_H

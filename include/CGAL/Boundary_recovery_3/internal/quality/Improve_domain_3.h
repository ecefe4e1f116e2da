// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_IMPROVE_DOMAIN_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_IMPROVE_DOMAIN_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/quality/Contract_bad_edge_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Flip_bad_cell_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Improved_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Insert_into_bad_cell_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Reconnect_bad_cell_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Smooth_vertex_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <utility>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Improves the cells of a domain, step 7 of [CZZ+17, Section 4.1]: works through a list of the bad cells, the worst one
 * first, again and again. The first rounds flip and smooth only; the dear operations follow for what these leave.
 *
 * No operation makes the worst of the cells that it changes worse, and each makes the sum of their badness smaller, so
 * the work ends.
 */
template <typename Tr, typename Domain, typename Quality, typename Visitor>
class Improve_domain_3
{
public:
  typedef typename Tr::Vertex_handle Vertex_handle;
  typedef typename Tr::Cell_handle   Cell_handle;

  Improve_domain_3(Tr& tr, Domain& domain, const Quality& quality, Recovery_context<Visitor>& context)
    : m_tr(tr), m_domain(domain), m_quality(quality), m_context(context),
      m_mesh(tr, domain, quality, context.visitor()),
      m_flip(m_mesh), m_smooth(m_mesh, quality), m_contract(m_mesh), m_insert(m_mesh, quality), m_reconnect(m_mesh)
  { }

  void operator()(const double min_dihedral_angle)
  {
    stage(min_dihedral_angle, 6);
    if(min_dihedral_angle > 12)
      stage(12, 6);
  }

private:
  typedef Improved_mesh_3<Tr, Domain, Quality, Visitor> Mesh;

  void stage(const double angle, const int max_rounds)
  {
    m_mesh.set_enough(m_quality.of_angle(angle));
    collect_bad_cells();
    m_last_change.clear(-1);
    double before = sort_bad_cells();
    for(int round = 0; round < max_rounds && ! m_bad.empty(); ++round)
    {
      const double t = m_context.seconds();
      const std::size_t n = m_bad.size();
      std::size_t counts[5] = { 0, 0, 0, 0, 0 };
      std::vector<std::pair<double, Cell_handle> > bad;
      bad.swap(m_bad);
      for(const auto& b : bad)
      {
        const Cell_handle c = b.second;
        if(! is_bad(c))
          continue;
        if(round > 2 && ! has_changed(c, round - 1))
        {
          push(c);
          continue;
        }
        m_round = round;
        if(flip(c))
          ++counts[0];
        else if(contract(c))
          ++counts[2];
        else if(round > 0 && smooth(c))
          ++counts[1];
        else if(round > 1 && insert(c))
          ++counts[3];
        else if(round > 1 && reconnect(c))
          ++counts[4];
        else
          push(c);
      }
      const double after = sort_bad_cells();
      std::fprintf(stderr, "angle %g round %d: bad %zu %g, flipped %zu smoothed %zu contracted %zu inserted %zu reconnected %zu; bad %zu %g worst %g; %.3f s\n", angle, round, n, before, counts[0], counts[1], counts[2], counts[3], counts[4], m_bad.size(), after, m_bad.empty() ? 0 : m_bad.front().first, m_context.seconds() - t);
      if(round > 1 && after > 0.98 * before)
        break;
      before = after;
    }
  }

  void collect_bad_cells()
  {
    m_bad.clear();
    for(const Cell_handle c : m_tr.finite_cell_handles())
      if(m_domain.contains(c))
        push(c);
  }

  void push(const Cell_handle c)
  {
    const double q = m_mesh.quality(c);
    if(q < m_mesh.enough())
      m_bad.emplace_back(q, c);
  }

  template <typename Cells>
  void push_all(const Cells& cells)
  {
    for(const Cell_handle c : cells)
    {
      push(c);
      for(int i = 0; i < 4; ++i)
        m_last_change[c->vertex(i)] = m_round;
    }
  }

  bool has_changed(const Cell_handle c, const int round) const
  {
    for(int i = 0; i < 4; ++i)
      if(m_last_change.is_defined(c->vertex(i)) && m_last_change[c->vertex(i)] >= round)
        return true;
    return false;
  }

  // The worst one first. Those that are gone, or are there twice, are taken out. Returns how bad they are together.
  double sort_bad_cells()
  {
    for(auto& b : m_bad)
      b.first = is_bad(b.second) ? m_mesh.quality(b.second) : 2;
    std::stable_sort(m_bad.begin(), m_bad.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
    m_bad.erase(std::unique(m_bad.begin(), m_bad.end()), m_bad.end());
    double sum = 0;
    for(const auto& b : m_bad)
      sum += m_mesh.badness(b.first);
    while(! m_bad.empty() && m_bad.back().first > 1.5)
      m_bad.pop_back();
    return sum;
  }

  bool is_bad(const Cell_handle c) const
  {
    return m_tr.tds().cells().is_used(c) && m_domain.contains(c) && m_mesh.quality(c) < m_mesh.enough();
  }

  // Flips what comes from a cell, until that does not help any more.
  bool flip(const Cell_handle c)
  {
    m_stack.assign(1, c);
    bool is_flipped = false;
    for(int k = 0; ! m_stack.empty() && k < 50; ++k)
    {
      const Cell_handle d = m_stack.back();
      m_stack.pop_back();
      if(! is_bad(d))
        continue;
      if(m_flip(d))
      {
        is_flipped = true;
        for(const Cell_handle n : m_flip.new_cells())
          for(int i = 0; i < 4; ++i)
            m_last_change[n->vertex(i)] = m_round;
        for(const Cell_handle n : m_flip.new_cells())
          if(m_mesh.quality(n) < m_mesh.enough())
            m_stack.push_back(n);
      }
      else if(is_flipped)
        push(d);
    }
    for(const Cell_handle d : m_stack)
      if(is_bad(d))
        push(d);
    return is_flipped;
  }

  bool smooth(const Cell_handle c)
  {
    bool is_smoothed = false;
    for(int i = 0; i < 4 && m_mesh.quality(c) < m_mesh.enough(); ++i)
      if(m_smooth(c->vertex(i)))
      {
        is_smoothed = true;
        push_all(m_smooth.cells());
      }
    return is_smoothed;
  }

  bool contract(const Cell_handle c)
  {
    double gain = 0;
    int at = -1;
    for(int i = 0; i < 4; ++i)
      if(m_contract.find(c->vertex(i), gain))
      {
        gain = m_contract.gain();
        at = i;
      }
    if(at < 0 || ! m_contract.find(c->vertex(at), 0) || ! m_contract.apply())
      return false;
    push_all(m_contract.new_cells());
    return true;
  }

  bool insert(const Cell_handle c)
  {
    if(! m_insert.find(c) || ! m_insert.apply())
      return false;
    push_all(m_insert.new_cells());
    return true;
  }

  bool reconnect(const Cell_handle c)
  {
    if(! m_reconnect.find(c) || ! m_reconnect.apply())
      return false;
    push_all(m_reconnect.new_cells());
    return true;
  }

  Tr& m_tr;
  Domain& m_domain;
  const Quality& m_quality;
  Recovery_context<Visitor>& m_context;
  Mesh m_mesh;
  Flip_bad_cell_3<Mesh> m_flip;
  Smooth_vertex_3<Mesh> m_smooth;
  Contract_bad_edge_3<Mesh> m_contract;
  Insert_into_bad_cell_3<Mesh> m_insert;
  Reconnect_bad_cell_3<Mesh> m_reconnect;
  std::vector<std::pair<double, Cell_handle> > m_bad;
  std::vector<Cell_handle> m_stack;
  Unique_hash_map<Vertex_handle, int> m_last_change;
  int m_round = 0;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_IMPROVE_DOMAIN_3_H

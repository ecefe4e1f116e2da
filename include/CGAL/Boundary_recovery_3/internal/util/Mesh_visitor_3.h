// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_MESH_VISITOR_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_MESH_VISITOR_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>
#include <CGAL/Boundary_recovery_3/parameters.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

// Cell handles that lie one after the other in the memory of somebody else.
template <typename Cell_handle>
class Cell_span
{
public:
  typedef Cell_handle        value_type;
  typedef const Cell_handle* iterator;
  typedef const Cell_handle* const_iterator;
  typedef std::size_t        size_type;

  template <typename CellRange>
  Cell_span(const CellRange& cells) : m_data(cells.data()), m_size(cells.size()) { }

  const_iterator begin() const { return m_data; }
  const_iterator end() const { return m_data + m_size; }
  std::size_t size() const { return m_size; }
  bool empty() const { return m_size == 0; }
  const Cell_handle* data() const { return m_data; }

private:
  const Cell_handle* m_data;
  std::size_t m_size;
};

/*
 * A visitor as everything below the entry functions knows it, see `MeshingVisitor_3`: the type of the caller's visitor
 * is no parameter of templates there, so that they are compiled once for all visitors. By itself it does nothing.
 */
template <typename Tr>
class Mesh_visitor_3
{
public:
  typedef Cell_span<typename Tr::Cell_handle> Cells;

  virtual ~Mesh_visitor_3() = default;

  virtual void on_phase_begin(Phase) { }
  virtual void on_phase_end(const Phase_report&) { }
  virtual void on_progress(Phase, std::size_t /* done */, std::size_t /* total */) { }
  virtual bool go_further() { return true; }
  virtual void before_cells_removal(const Cells&) { }
  virtual void after_cells_creation(const Cells&) { }

  // Whether anything is done when it is told of cells: threads need not wait for each other to tell nobody.
  virtual bool watches_cells() const { return false; }
};

// Hands on everything to a visitor of another type, `Visitor`, or to the one that `Visitor` is a reference to. Cells
// are told only if they are those of the caller's triangulation: else a visitor need not know what they are.
template <typename Tr, typename Visitor, bool tells_cells = true>
class Any_visitor_3 final
  : public Mesh_visitor_3<Tr>
{
public:
  typedef typename Mesh_visitor_3<Tr>::Cells Cells;

  explicit Any_visitor_3(Visitor&& visitor) : m_visitor(std::forward<Visitor>(visitor)) { }

  void on_phase_begin(const Phase phase) override { m_visitor.on_phase_begin(phase); }
  void on_phase_end(const Phase_report& report) override { m_visitor.on_phase_end(report); }

  void on_progress(const Phase phase, const std::size_t done, const std::size_t total) override
  {
    m_visitor.on_progress(phase, done, total);
  }

  bool go_further() override { return m_visitor.go_further(); }

  void before_cells_removal([[maybe_unused]] const Cells& cells) override
  {
    if constexpr(tells_cells)
      m_visitor.before_cells_removal(cells);
  }

  void after_cells_creation([[maybe_unused]] const Cells& cells) override
  {
    if constexpr(tells_cells)
      m_visitor.after_cells_creation(cells);
  }

  bool watches_cells() const override
  {
    return tells_cells && ! std::is_same<std::decay_t<Visitor>, Default_meshing_visitor_3>::value;
  }

private:
  Visitor m_visitor;
};

// Hands on everything to another visitor; what is to be otherwise, derived classes override.
template <typename Tr>
class Forwarding_visitor_3
  : public Mesh_visitor_3<Tr>
{
public:
  typedef Mesh_visitor_3<Tr>      Visitor;
  typedef typename Visitor::Cells Cells;

  explicit Forwarding_visitor_3(Visitor& visitor) : m_visitor(visitor) { }

  Forwarding_visitor_3(const Forwarding_visitor_3&) = delete;
  Forwarding_visitor_3& operator=(const Forwarding_visitor_3&) = delete;

  void on_phase_begin(const Phase phase) override { m_visitor.on_phase_begin(phase); }
  void on_phase_end(const Phase_report& report) override { m_visitor.on_phase_end(report); }

  void on_progress(const Phase phase, const std::size_t done, const std::size_t total) override
  {
    m_visitor.on_progress(phase, done, total);
  }

  bool go_further() override { return m_visitor.go_further(); }
  void before_cells_removal(const Cells& cells) override { m_visitor.before_cells_removal(cells); }
  void after_cells_creation(const Cells& cells) override { m_visitor.after_cells_creation(cells); }
  bool watches_cells() const override { return m_visitor.watches_cells(); }

protected:
  Visitor& m_visitor;
};

/*
 * Stands between the steps of a longer run and its visitor: it collects what phases report, those of recoveries not
 * included, since the result of a recovery has these, and asks whether to go on only until the answer is no.
 */
template <typename Tr>
class Recording_visitor_3 final
  : public Forwarding_visitor_3<Tr>
{
  typedef Forwarding_visitor_3<Tr> Base;

public:
  Recording_visitor_3(Mesh_visitor_3<Tr>& visitor, std::vector<Phase_report>& reports)
    : Base(visitor), m_reports(reports)
  { }

  void on_phase_end(const Phase_report& report) override
  {
    if(! internal::is_of_recovery(report.phase))
      m_reports.push_back(report);
    Base::on_phase_end(report);
  }

  bool go_further() override
  {
    m_is_stopped = m_is_stopped || ! Base::go_further();
    return ! m_is_stopped;
  }

private:
  std::vector<Phase_report>& m_reports;
  bool m_is_stopped = false;
};

// The visitor that was passed as a named parameter: itself if it was passed by reference, else a copy.
template <typename Tr, bool tells_cells = true, typename NamedParameters>
auto mesh_visitor(const NamedParameters& np)
{
  return Any_visitor_3<Tr, decltype(internal::visitor_of(np)), tells_cells>(internal::visitor_of(np));
}

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_MESH_VISITOR_3_H

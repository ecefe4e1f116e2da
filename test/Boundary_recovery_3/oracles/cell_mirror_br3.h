// A visitor that knows the cells of a mesh from what it is told.

#ifndef BR3_TEST_CELL_MIRROR_H
#define BR3_TEST_CELL_MIRROR_H

#include "brute_force_checker_br3.h"

#include <CGAL/Boundary_recovery_3/Meshing_visitor_3.h>

#include <map>
#include <set>

namespace br3_test {

// The cells that are in the triangulation, if the visitor is told the truth: by addresses, with their vertices. And the
// visitor sees a valid data structure.
template <typename Tr>
class Cell_mirror
  : public CGAL::Default_meshing_visitor_3
{
public:
  typedef std::map<const void*, std::set<const void*> > Cells;

  explicit Cell_mirror(const Tr& tr) : m_tr(tr), m_cells(cells(tr)) { }

  template <typename CellRange>
  void before_cells_removal(const CellRange& cells)
  {
    for(const auto c : cells)
    {
      const auto it = m_cells.find(&*c);
      require(it != m_cells.end() && it->second == vertices(c), "a cell is removed that was not there");
      m_cells.erase(it);
    }
  }

  template <typename CellRange>
  void after_cells_creation(const CellRange& cells)
  {
    for(const auto c : cells)
      require(m_cells.emplace(&*c, vertices(c)).second, "a cell is created that was there");
    require(m_tr.tds().is_valid(), "the visitor sees a data structure that is not valid");
  }

  void check(const Tr& tr) const { require(m_cells == cells(tr), "the visitor missed some cells"); }

private:
  template <typename Cell_handle>
  static std::set<const void*> vertices(const Cell_handle c)
  {
    return { &*c->vertex(0), &*c->vertex(1), &*c->vertex(2), &*c->vertex(3) };
  }

  static Cells cells(const Tr& tr)
  {
    Cells result;
    for(const auto c : tr.all_cell_handles())
      result.emplace(&*c, vertices(c));
    return result;
  }

  const Tr& m_tr;
  Cells m_cells;
};

} // namespace br3_test

#endif // BR3_TEST_CELL_MIRROR_H

// Exact checks of what a local operation did to a mesh: some cells are replaced by others, and everything else stays.

#ifndef BR3_TEST_EXPECTED_CHANGE_H
#define BR3_TEST_EXPECTED_CHANGE_H

#include "changing_mesh_br3.h"

#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>

#include <array>
#include <cassert>
#include <cstddef>
#include <map>
#include <set>

namespace br3_test {

// The cells with their vertices and neighbors, and the vertices with their points.
template <typename Mesh>
struct Mesh_record
{
  typedef const void* Address;
  struct Cell
  {
    bool operator==(const Cell& other) const { return vertices == other.vertices && neighbors == other.neighbors; }

    std::array<Address, 4> vertices, neighbors;
  };

  explicit Mesh_record(const Mesh& mesh)
  {
    for(const auto c : mesh.tr.all_cell_handles())
      for(int i = 0; i < 4; ++i)
      {
        cells[&*c].vertices[static_cast<std::size_t>(i)] = &*c->vertex(i);
        cells[&*c].neighbors[static_cast<std::size_t>(i)] = &*c->neighbor(i);
      }
    for(auto v = mesh.tr.tds().vertices().begin(); v != mesh.tr.tds().vertices().end(); ++v)
      if(v != mesh.tr.infinite_vertex())
        points.emplace(&*v, v->point());
  }

  bool operator==(const Mesh_record& other) const { return cells == other.cells && points == other.points; }

  std::map<Address, Cell> cells;
  std::map<Address, typename Mesh::Point> points; // with those that are in no cell
};

// The cells that are going to be replaced, and the tetrahedra that are to come in their place.
template <typename Mesh>
class Expected_change
{
public:
  typedef typename Mesh::Cell_handle    Cell_handle;
  typedef typename Mesh::Vertex_handle  Vertex_handle;
  typedef typename Mesh::Cells          Cells;
  typedef typename Mesh::Tetrahedron    Tetrahedron;
  typedef typename Mesh::Tetrahedra     Tetrahedra;
  typedef typename Mesh::Vertices       Vertices;

  Expected_change(Mesh& mesh, const Cells& old_cells, const Tetrahedra& tetrahedra,
                  const Vertices& dropped = Vertices())
    : m_mesh(mesh), m_before(mesh)
  {
    Tetrahedra old_tetrahedra;
    for(const Cell_handle c : old_cells)
    {
      m_old_cells.insert(&*c);
      old_tetrahedra.push_back(Mesh::tetrahedron(c));
    }
    assert(m_old_cells.size() == old_cells.size());
    for(const Tetrahedron& t : tetrahedra)
      m_new_simplices.insert(addresses(t));
    assert(mesh.total_volume(old_tetrahedra) == mesh.total_volume(tetrahedra));
    for(const Vertex_handle v : dropped)
    {
      m_dropped.insert(&*v);
      mesh.positions.erase(v);
    }
  }

  // If the visitor throws, either nothing or all has happened; it is thrown again.
  template <typename Change>
  void make(const Change& change)
  {
    m_mesh.recorder.removed.clear();
    m_mesh.recorder.created.clear();
    try {
      change();
    } catch(const Interruption&) {
      if(m_mesh.recorder.removed.empty())
        assert(m_before == Record(m_mesh));
      else
        check();
      throw;
    }
    check();
    assert(m_mesh.are_all_constraints_there());
  }

private:
  typedef Mesh_record<Mesh>           Record;
  typedef typename Record::Address    Address;
  typedef std::set<Address>           Addresses;

  static std::multiset<Address> addresses(const Tetrahedron& t)
  {
    std::multiset<Address> result;
    for(const Vertex_handle v : t)
      result.insert(&*v);
    return result;
  }

  void check() const
  {
    const Record now(m_mesh);
    check_old_cells(now);
    check_new_cells();
    std::map<Address, typename Mesh::Point> points = m_before.points;
    for(const Address v : m_dropped)
      assert(points.erase(v) == 1);
    assert(now.points == points);
    assert(m_mesh.tr.tds().is_valid());
    assert(CGAL::Boundary_recovery_3::internal::is_mesh_valid(m_mesh.tr, m_mesh.predicates));
  }

  void check_old_cells(const Record& now) const
  {
    for(const auto& c : m_before.cells)
    {
      if(m_old_cells.count(c.first) == 1)
        continue;
      const auto it = now.cells.find(c.first);
      assert(it != now.cells.end() && it->second.vertices == c.second.vertices);
      for(std::size_t i = 0; i < 4; ++i)
        if(m_old_cells.count(c.second.neighbors[i]) == 0)
          assert(it->second.neighbors[i] == c.second.neighbors[i]);
    }
    assert(now.cells.size() == m_before.cells.size() - m_old_cells.size() + m_new_simplices.size());
  }

  void check_new_cells() const
  {
    Addresses new_cells;
    std::multiset<std::multiset<Address> > simplices;
    Tetrahedra tetrahedra;
    for(const Cell_handle c : m_mesh.tr.all_cell_handles())
      if(m_before.cells.count(&*c) == 0 || m_old_cells.count(&*c) == 1)
      {
        new_cells.insert(&*c);
        tetrahedra.push_back(Mesh::tetrahedron(c));
        simplices.insert(addresses(tetrahedra.back()));
      }
    assert(simplices == m_new_simplices);
    assert(m_mesh.are_positive(tetrahedra));
    check_told_cells(m_mesh.recorder.removed, m_old_cells);
    check_told_cells(m_mesh.recorder.created, new_cells);
    check_told_cells(Change_recorder::addresses(m_mesh.editor.new_cells()), new_cells);
  }

  // Each of them once.
  static void check_told_cells(const Change_recorder::Addresses& told, const Addresses& expected)
  {
    assert(told.size() == expected.size() && Addresses(told.begin(), told.end()) == expected);
  }

  Mesh& m_mesh;
  const Record m_before;
  Addresses m_old_cells, m_dropped;
  std::multiset<std::multiset<Address> > m_new_simplices;
};

} // namespace br3_test

#endif // BR3_TEST_EXPECTED_CHANGE_H

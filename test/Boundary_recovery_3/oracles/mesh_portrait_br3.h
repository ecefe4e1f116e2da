// What there is to compare of a mesh that was changed and put back: all the cells with what they carry, and the points.

#ifndef BR3_TEST_MESH_PORTRAIT_H
#define BR3_TEST_MESH_PORTRAIT_H

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace br3_test {

// Names of vertices that outlive their handles.
template <typename Tr>
class Vertex_names
{
public:
  typedef typename Tr::Vertex_handle Vertex_handle;

  explicit Vertex_names(const Tr& tr)
  {
    for(auto v = tr.tds().vertices().begin(); v != tr.tds().vertices().end(); ++v)
      m_names.emplace(&*v, m_names.size());
  }

  std::size_t operator()(const Vertex_handle v) const
  {
    const auto it = m_names.find(&*v);
    return it == m_names.end() ? std::size_t(-1) : it->second;
  }

  // Pairs of a handle that is gone, and the one that has its name from now on.
  template <typename Vertex_pairs>
  void rename(const Vertex_pairs& pairs)
  {
    std::vector<std::size_t> names;
    for(const auto& p : pairs)
    {
      names.push_back(m_names.at(&*p[0]));
      m_names.erase(&*p[0]);
    }
    for(std::size_t i = 0; i < names.size(); ++i)
      assert(m_names.emplace(&*pairs[i][1], names[i]).second);
  }

private:
  std::map<const void*, std::size_t> m_names;
};

// The neighbors of all the cells are as their vertices say, judged by a map of facets.
template <typename Tr>
bool are_neighbors_right(const Tr& tr)
{
  typedef std::array<const void*, 2> Cell_and_neighbor;
  std::map<std::array<const void*, 3>, std::vector<Cell_and_neighbor> > facets;
  for(auto c = tr.tds().cells().begin(); c != tr.tds().cells().end(); ++c)
    for(int i = 0; i < 4; ++i)
    {
      std::array<const void*, 3> f;
      for(int j = 0; j < 3; ++j)
        f[j] = &*c->vertex((i + 1 + j) & 3);
      std::sort(f.begin(), f.end(), std::less<const void*>());
      facets[f].push_back({{ &*c, &*c->neighbor(i) }});
    }
  for(const auto& f : facets)
    if(f.second.size() != 2 || f.second[0][0] != f.second[1][1] || f.second[0][1] != f.second[1][0])
      return false;
  return true;
}

// Three marks for the region and the facets of a cell, if it carries them.
template <typename Cell, typename = void>
struct Marks_of_cell
{
  static std::array<int, 5> get(const Cell&) { return {{ 0, 0, 0, 0, 0 }}; }
};

template <typename Cell>
struct Marks_of_cell<Cell, std::void_t<typename Cell::Subdomain_index> >
{
  static std::array<int, 5> get(const Cell& c)
  {
    return {{ c.subdomain_index(), c.surface_patch_index(0), c.surface_patch_index(1), c.surface_patch_index(2),
              c.surface_patch_index(3) }};
  }
};

template <typename Tr>
struct Mesh_portrait
{
  Mesh_portrait(const Tr& tr, const Vertex_names<Tr>& names)
  {
    for(auto c = tr.tds().cells().begin(); c != tr.tds().cells().end(); ++c)
      cells.insert({ {{ names(c->vertex(0)), names(c->vertex(1)), names(c->vertex(2)), names(c->vertex(3)) }},
                     Marks_of_cell<typename Tr::Cell>::get(*c) });
    for(auto v = tr.tds().vertices().begin(); v != tr.tds().vertices().end(); ++v)
      if(v != tr.infinite_vertex())
        points.insert({ names(v), {{ v->point().x(), v->point().y(), v->point().z() }} });
    assert(are_neighbors_right(tr));
  }

  bool operator==(const Mesh_portrait& other) const { return cells == other.cells && points == other.points; }

  std::multiset<std::pair<std::array<std::size_t, 4>, std::array<int, 5> > > cells;
  std::multimap<std::size_t, std::array<double, 3> > points;
};

// The triangulation of n points in a cube, always the same ones.
template <typename Tr>
void insert_random_points(Tr& tr, const int n, std::mt19937& rng)
{
  for(int i = 0; i < n; ++i)
  {
    std::array<double, 3> x;
    for(double& coordinate : x)
      coordinate = static_cast<double>(rng() % 1000) / 8;
    tr.insert(typename Tr::Point(x[0], x[1], x[2]));
  }
}

template <typename Items>
auto random_item(const Items& items, std::mt19937& rng) { return items[rng() % items.size()]; }

} // namespace br3_test

#endif // BR3_TEST_MESH_PORTRAIT_H

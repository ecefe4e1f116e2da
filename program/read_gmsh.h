#ifndef BOUNDARY_RECOVERY_3_PROGRAM_READ_GMSH_H
#define BOUNDARY_RECOVERY_3_PROGRAM_READ_GMSH_H

#include "polygon_soup.h"
#include "utf8.h"
#include "word_reader.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

// Reads the triangles and quadrangles of a file in Gmsh's formats 2.2 and 4.1, as text, with their physical groups, or
// where there are none, with the surfaces that they are on. Of those of second order, the corners are taken. Points
// keep their order, not their tags; faces count from 1.
template <typename Point>
class Gmsh_reader
{
  // what Gmsh calls an element: the number of its nodes, of its corners if it is a face, and of its dimension
  struct Kind
  {
    std::size_t nodes, corners;
  };

  Word_reader m_words;
  Polygon_soup<Point> m_soup;
  std::map<long long, std::size_t> m_positions; // of the points, by their tags
  std::map<long long, int> m_group_of_surface;
  std::map<int, std::string> m_group_names;
  std::vector<int> m_groups, m_surfaces;        // of each polygon
  std::size_t m_number_of_cells = 0, m_number_of_curved = 0;

public:
  explicit Gmsh_reader(const std::string& text) : m_words(text, false) { m_soup.first_number = 1; }

  Polygon_soup<Point> operator()()
  {
    m_words.expect("$MeshFormat");
    const std::string version = m_words.word();
    if(m_words.word() != "0")
      m_words.fail("it is binary: `gmsh FILE -save -o TEXT.msh` makes text of it");
    m_words.skip_words(1);
    m_words.expect("$EndMeshFormat");
    if(version[0] != '2' && version != "4.1")
      m_words.fail("it has version " + version + "; 2.2 and 4.1 are known");
    while(m_words.has_word())
      read_section(m_words.word(), version[0] == '2');
    set_patches();
    m_soup.leave_out(m_number_of_cells, "tetrahedra and other cells");
    m_soup.leave_out(m_number_of_curved, "nodes in the middle of edges");
    return std::move(m_soup);
  }

private:
  void read_section(const std::string& keyword, const bool is_old)
  {
    if(keyword == "$PhysicalNames")
      read_names();
    else if(keyword == "$Entities")
      read_surfaces();
    else if(keyword == "$Nodes")
      is_old ? read_old_nodes() : read_nodes();
    else if(keyword == "$Elements")
      is_old ? read_old_elements() : read_elements();
    const std::string end = "$End" + keyword.substr((std::min)(keyword.size(), std::size_t(1)));
    while(m_words.word() != end)
      ;
  }

  void read_names()
  {
    const std::size_t n = m_words.count(3);
    for(std::size_t i = 0; i < n; ++i)
    {
      const long long dimension = m_words.integer(), group = m_words.integer();
      const std::string line = m_words.line();
      const std::size_t begin = line.find('"'), end = line.rfind('"');
      if(dimension == 2 && begin != end)
        m_group_names[static_cast<int>(group)] = as_utf8(line.substr(begin + 1, end - begin - 1));
    }
  }

  void read_surfaces()
  {
    std::size_t numbers[4];
    for(std::size_t& n : numbers)
      n = m_words.count();
    for(std::size_t dimension = 0; dimension < 3; ++dimension) // volumes come last
      for(std::size_t i = 0; i < numbers[dimension]; ++i)
      {
        const long long tag = m_words.integer();
        m_words.skip_words(dimension == 0 ? 3 : 6); // a box
        const std::size_t number_of_groups = m_words.count();
        for(std::size_t g = 0; g < number_of_groups; ++g)
        {
          const int group = static_cast<int>(m_words.integer());
          if(dimension == 2)
            m_group_of_surface.emplace(tag, group); // of several, the first one counts
        }
        if(dimension > 0)
          m_words.skip_words(m_words.count()); // what bounds it
      }
  }

  void add_point(const long long tag)
  {
    m_positions[tag] = m_soup.points.size();
    m_soup.points.push_back(m_words.point<Point>());
  }

  void read_old_nodes()
  {
    const std::size_t n = m_words.count(4);
    for(std::size_t i = 0; i < n; ++i)
      add_point(m_words.integer());
  }

  void read_nodes()
  {
    const std::size_t number_of_blocks = m_words.count();
    m_words.skip_words(3);
    for(std::size_t b = 0; b < number_of_blocks; ++b)
    {
      const long long dimension = m_words.integer();
      m_words.skip_words(1);
      const bool is_parametric = m_words.integer() != 0;
      std::vector<long long> tags(m_words.count());
      for(long long& tag : tags)
        tag = m_words.integer();
      for(const long long tag : tags)
      {
        add_point(tag);
        if(is_parametric)
          m_words.skip_words(static_cast<std::size_t>(dimension));
      }
    }
  }

  Kind kind_of(const long long type) const
  {
    static const std::map<long long, Kind> kinds = { { 1, { 2, 0 } }, { 2, { 3, 3 } }, { 3, { 4, 4 } }, { 4, { 4, 0 } },
      { 5, { 8, 0 } }, { 6, { 6, 0 } }, { 7, { 5, 0 } }, { 8, { 3, 0 } }, { 9, { 6, 3 } }, { 10, { 9, 4 } },
      { 11, { 10, 0 } }, { 12, { 27, 0 } }, { 13, { 18, 0 } }, { 14, { 14, 0 } }, { 15, { 1, 0 } }, { 16, { 8, 4 } },
      { 17, { 20, 0 } }, { 18, { 15, 0 } }, { 19, { 13, 0 } } };
    const auto kind = kinds.find(type);
    if(kind == kinds.end())
      m_words.fail("elements of type " + std::to_string(type) + " are not known");
    return kind->second;
  }

  static bool is_cell(const long long type)
  {
    return (type >= 4 && type <= 7) || (type >= 11 && type != 15 && type != 16);
  }

  void read_old_elements()
  {
    const std::size_t n = m_words.count(4);
    for(std::size_t i = 0; i < n; ++i)
    {
      m_words.skip_words(1);
      const long long type = m_words.integer();
      std::vector<int> tags(m_words.count());
      for(int& tag : tags)
        tag = static_cast<int>(m_words.integer());
      tags.resize((std::max)(tags.size(), std::size_t(2)), 0);
      read_element(type, tags[0], tags[1]);
    }
  }

  void read_elements()
  {
    const std::size_t number_of_blocks = m_words.count();
    m_words.skip_words(3);
    for(std::size_t b = 0; b < number_of_blocks; ++b)
    {
      m_words.skip_words(1);
      const long long surface = m_words.integer(), type = m_words.integer();
      const auto group = m_group_of_surface.find(surface);
      const std::size_t n = m_words.count();
      for(std::size_t i = 0; i < n; ++i)
      {
        m_words.skip_words(1);
        read_element(type, group == m_group_of_surface.end() ? 0 : group->second, static_cast<int>(surface));
      }
    }
  }

  void read_element(const long long type, const int group, const int surface)
  {
    const Kind kind = kind_of(type);
    typename Polygon_soup<Point>::Polygon polygon;
    for(std::size_t i = 0; i < kind.corners; ++i)
    {
      const auto position = m_positions.find(m_words.integer());
      if(position == m_positions.end())
        m_words.fail("it has no such node");
      polygon.push_back(position->second);
    }
    m_words.skip_words(kind.nodes - kind.corners);
    m_number_of_cells += is_cell(type);
    if(kind.corners == 0)
      return;
    m_number_of_curved += kind.nodes - kind.corners;
    m_soup.polygons.push_back(polygon);
    m_groups.push_back(group);
    m_surfaces.push_back(surface);
  }

  void set_patches()
  {
    const bool has_groups = std::any_of(m_groups.begin(), m_groups.end(), [](const int group) { return group != 0; });
    m_soup.set_patches_by_numbers(has_groups ? m_groups : m_surfaces, true);
    if(has_groups && m_soup.patch_names.empty())
      m_soup.patch_names = m_group_names;
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_READ_GMSH_H

#ifndef BOUNDARY_RECOVERY_3_PROGRAM_READ_NAMES_H
#define BOUNDARY_RECOVERY_3_PROGRAM_READ_NAMES_H

#include "normalize_text.h"
#include "polygon_soup.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

// CGAL's readers leave out the names that polygons have in STL and OBJ files. Here these are read, in the same order,
// after the polygons.

namespace read_surface_internal {

// what follows the first word of a line
inline std::string rest_of_line(const std::string& line)
{
  const std::string word = first_word(line);
  const std::size_t begin = line.find(word) + word.size(), end = line.find_last_not_of(" \t\r");
  const std::size_t name = line.find_first_not_of(" \t\r", begin);
  return name == std::string::npos ? std::string() : line.substr(name, end + 1 - name);
}

// One solid alone has the name of the file, or of the program that wrote it: it tells nothing apart.
template <typename Point>
void read_names_of_solids(const std::string& text, Polygon_soup<Point>& soup)
{
  std::vector<std::string> names;
  std::string name;
  std::size_t number_of_solids = 0;
  for_each_line(text, [&](const std::string& line)
  {
    const std::string word = first_word(line);
    if(word == "solid")
    {
      ++number_of_solids;
      name = rest_of_line(line);
      if(name.empty())
        name = "solid_" + std::to_string(number_of_solids);
    }
    else if(word == "facet")
      names.push_back(name);
  });
  if(number_of_solids > 1 && names.size() == soup.polygons.size())
    soup.set_patches_by_names(names);
}

// Faces of OBJ files have names of three kinds. Those that differ are put together.
template <typename Point>
class Obj_name_reader
{
  static constexpr std::size_t number_of_kinds = 3;
  static constexpr const char* keywords[number_of_kinds] = { "o", "g", "usemtl" };
  static constexpr const char* kinds[number_of_kinds] = { "object", "group", "material" };

  typedef std::array<std::string, number_of_kinds> Names;

  Polygon_soup<Point>& m_soup;
  std::vector<Names> m_names; // of each face

public:
  explicit Obj_name_reader(Polygon_soup<Point>& soup) : m_soup(soup) { }

  void operator()(const std::string& text)
  {
    Names current;
    for_each_line(text, [&](const std::string& line)
    {
      const std::string word = first_word(line);
      if(word == "f")
        m_names.push_back(current);
      for(std::size_t k = 0; k < number_of_kinds; ++k)
        if(word == keywords[k])
          current[k] = rest_of_line(line);
    });
    if(m_names.size() != m_soup.polygons.size())
      return;
    drop_common_names();
    std::vector<std::string> names;
    for(const Names& of_face : m_names)
      names.push_back(joined(of_face));
    m_soup.set_patches_by_names(names);
  }

private:
  // A name that all faces have tells nothing apart where others do.
  void drop_common_names()
  {
    std::array<std::set<std::string>, number_of_kinds> values;
    for(const Names& names : m_names)
      for(std::size_t k = 0; k < number_of_kinds; ++k)
        values[k].insert(names[k]);
    bool is_divided = false;
    for(const auto& names : values)
      is_divided = is_divided || names.size() > 1;
    for(std::size_t k = 0; k < number_of_kinds; ++k)
    {
      const std::string name = values[k].size() == 1 ? *values[k].begin() : std::string();
      if(name.empty())
        continue;
      if(is_divided)
        m_soup.notes.push_back(std::string("the ") + kinds[k] + " of all faces, not part of the names of patches: "
                               + name);
      for(Names& names : m_names)
        names[k].clear();
    }
  }

  static std::string joined(const Names& names)
  {
    std::string result;
    for(std::size_t k = 0; k < number_of_kinds; ++k)
      if(! names[k].empty() && std::find(names.begin(), names.begin() + k, names[k]) == names.begin() + k)
        result += (result.empty() ? "" : ":") + names[k];
    return result;
  }
};

} // namespace read_surface_internal

#endif // BOUNDARY_RECOVERY_3_PROGRAM_READ_NAMES_H

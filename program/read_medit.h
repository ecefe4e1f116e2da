#ifndef BOUNDARY_RECOVERY_3_PROGRAM_READ_MEDIT_H
#define BOUNDARY_RECOVERY_3_PROGRAM_READ_MEDIT_H

#include "polygon_soup.h"
#include "word_reader.h"

#include <cctype>
#include <cstddef>
#include <string>
#include <vector>

// Reads the triangles and quadrilaterals of a file in MEDIT's text format; their references are patches.
template <typename Point>
class Medit_reader
{
  Word_reader m_words;
  Polygon_soup<Point> m_soup;
  std::vector<int> m_references;
  std::size_t m_number_of_cells = 0;

public:
  explicit Medit_reader(const std::string& text) : m_words(text) { m_soup.first_number = 1; }

  Polygon_soup<Point> operator()()
  {
    m_words.expect("MeshVersionFormatted");
    m_words.skip_words(1);
    while(m_words.has_word() && m_words.peek() != "End")
      read_section(m_words.word());
    m_soup.set_patches_by_numbers(m_references, true);
    m_soup.leave_out(m_number_of_cells, "tetrahedra and other cells");
    return std::move(m_soup);
  }

private:
  void read_section(const std::string& keyword)
  {
    if(keyword == "Dimension" && m_words.integer() != 3)
      m_words.fail("it has not dimension 3");
    else if(keyword == "Vertices")
      read_points();
    else if(keyword == "Triangles")
      read_polygons(3);
    else if(keyword == "Quadrilaterals")
      read_polygons(4);
    else
      skip_section(keyword);
  }

  void read_points()
  {
    const std::size_t n = m_words.count(4);
    for(std::size_t i = 0; i < n; ++i)
    {
      m_soup.points.push_back(m_words.point<Point>());
      m_words.skip_words(1);
    }
  }

  // An index of 0 is as much out of range as the largest number.
  void read_polygons(const std::size_t number_of_corners)
  {
    const std::size_t n = m_words.count(number_of_corners + 1);
    for(std::size_t i = 0; i < n; ++i)
    {
      typename Polygon_soup<Point>::Polygon polygon;
      for(std::size_t k = 0; k < number_of_corners; ++k)
        polygon.push_back(static_cast<std::size_t>(m_words.integer() - 1));
      m_soup.polygons.push_back(polygon);
      m_references.push_back(static_cast<int>(m_words.integer()));
    }
  }

  // What no surface has, such as edges and corners: numbers, up to the next keyword.
  void skip_section(const std::string& keyword)
  {
    if(keyword == "Tetrahedra" || keyword == "Hexahedra" || keyword == "Prisms" || keyword == "Pyramids")
      m_number_of_cells += m_words.count();
    while(m_words.has_word() && ! std::isalpha(static_cast<unsigned char>(m_words.peek()[0])))
      m_words.word();
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_READ_MEDIT_H

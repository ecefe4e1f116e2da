#ifndef BOUNDARY_RECOVERY_3_PROGRAM_READ_BINARY_OFF_H
#define BOUNDARY_RECOVERY_3_PROGRAM_READ_BINARY_OFF_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>

// Reads binary OFF files. In Geomview's format, the number of its colors comes after each face, and is 0 where there
// are none; CGAL's reader does not skip it. Some programs leave that number out. A file is read in the way in which
// it is used up to its last byte.
class Binary_off_reader
{
  // what is stored for each item
  struct Layout
  {
    std::size_t floats_per_vertex;
    bool has_colors_of_faces; // their number after each face, at least
  };

  const std::string& m_text;
  std::size_t m_begin = 0, m_position = 0; // where the numbers begin, and where the next one is
  std::string m_prefix;                    // of the keyword OFF, as C for colors of vertices

public:
  explicit Binary_off_reader(const std::string& text) : m_text(text) { }

  // returns whether it is such a file; only then the arguments are those of the file
  template <typename PointRange, typename PolygonRange>
  bool operator()(PointRange& points, PolygonRange& polygons)
  {
    if(! read_header())
      return false;
    const auto has = [&](const char c) { return m_prefix.find(c) != std::string::npos; };
    const std::size_t n = 3 + (has('N') ? 3 : 0) + (has('S') ? 2 : 0);
    for(const std::size_t number_of_colors : { 4, 3 }) // the last one may be left out
      for(const bool has_colors_of_faces : { true, false })
        if(read(Layout{ n + (has('C') ? number_of_colors : 0), has_colors_of_faces }, points, polygons))
          return true;
    points.clear();
    polygons.clear();
    return false;
  }

private:
  // the first line; homogeneous coordinates and other dimensions are left to CGAL's reader
  bool read_header()
  {
    const std::size_t end = m_text.find('\n');
    std::istringstream line(m_text.substr(0, end));
    std::string keyword, binary;
    if(end == std::string::npos || ! (line >> keyword >> binary) || binary != "BINARY" || keyword.size() < 3)
      return false;
    m_begin = end + 1;
    m_prefix = keyword.substr(0, keyword.size() - 3);
    return keyword.compare(m_prefix.size(), 3, "OFF") == 0 && m_prefix.find_first_not_of("STCN") == std::string::npos;
  }

  std::size_t number_of_words_left() const { return (m_text.size() - m_position) / 4; }

  // the next word of four bytes, of which the first one is the highest; the caller knows that it is there
  std::uint32_t next_word()
  {
    std::uint32_t word = 0;
    for(int i = 0; i < 4; ++i)
      word = 256 * word + static_cast<unsigned char>(m_text[m_position++]);
    return word;
  }

  double next_float()
  {
    const std::uint32_t word = next_word();
    float x;
    static_assert(sizeof(x) == sizeof(word), "a float of another size");
    std::memcpy(&x, &word, sizeof(x));
    return x;
  }

  template <typename PointRange, typename PolygonRange>
  bool read(const Layout& layout, PointRange& points, PolygonRange& polygons)
  {
    m_position = m_begin;
    if(number_of_words_left() < 3)
      return false;
    const std::size_t number_of_vertices = next_word(), number_of_faces = next_word();
    next_word(); // the number of edges means nothing
    if(number_of_vertices > number_of_words_left() / layout.floats_per_vertex)
      return false;
    points.resize(number_of_vertices);
    for(auto& p : points)
      p = next_point<typename PointRange::value_type>(layout);
    if(number_of_faces > number_of_words_left())
      return false;
    polygons.resize(number_of_faces);
    for(auto& polygon : polygons)
      if(! read_face(layout, polygon))
        return false;
    return m_position == m_text.size();
  }

  template <typename Point>
  Point next_point(const Layout& layout)
  {
    std::array<double, 3> x;
    for(double& coordinate : x)
      coordinate = next_float();
    m_position += 4 * (layout.floats_per_vertex - 3);
    return Point(x[0], x[1], x[2]);
  }

  template <typename Polygon>
  bool read_face(const Layout& layout, Polygon& polygon)
  {
    if(number_of_words_left() < 1)
      return false;
    const std::size_t degree = next_word();
    if(degree > number_of_words_left())
      return false;
    polygon.resize(degree);
    for(auto& index : polygon)
      index = next_word();
    if(! layout.has_colors_of_faces)
      return true;
    if(number_of_words_left() < 1)
      return false;
    const std::size_t number_of_colors = next_word();
    if(number_of_colors > 4 || number_of_colors > number_of_words_left())
      return false;
    m_position += 4 * number_of_colors;
    return true;
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_READ_BINARY_OFF_H

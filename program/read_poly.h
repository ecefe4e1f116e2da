#ifndef BOUNDARY_RECOVERY_3_PROGRAM_READ_POLY_H
#define BOUNDARY_RECOVERY_3_PROGRAM_READ_POLY_H

#include "polygon_soup.h"
#include "triangulate_facet.h"
#include "word_reader.h"

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

// Reads TetGen's .poly and .smesh files: facets of one or several polygons, with holes; their markers are patches.
// Places of holes are to be empty, and those of regions have their attributes as names.
template <typename Point>
class Poly_reader
{
  typedef std::vector<std::size_t> Polygon;

  Polygon_soup<Point> m_soup;
  std::vector<int> m_markers;
  std::size_t m_number_of_volumes = 0;

public:
  // `nodes` has the points if there are none in `text`; `is_smesh` tells the format
  Polygon_soup<Point> operator()(const std::string& text, const std::string& nodes, const bool is_smesh)
  {
    Word_reader words(text);
    if(! read_points(words))
    {
      Word_reader node_words(nodes);
      if(! read_points(node_words))
        words.fail("it has no points, nor is there a .node file beside it");
    }
    read_facets(words, is_smesh);
    read_places(words);
    m_soup.set_patches_by_numbers(m_markers, true);
    m_soup.leave_out(m_number_of_volumes, "largest volumes of regions");
    return std::move(m_soup);
  }

private:
  bool read_points(Word_reader& words)
  {
    const std::size_t n = words.has_word() ? words.count() : 0;
    words.line();
    for(std::size_t i = 0; i < n; ++i)
    {
      const long long number = words.integer();
      if(i == 0)
        m_soup.first_number = number == 0 ? 0 : 1;
      m_soup.points.push_back(words.point<Point>());
      words.line();
    }
    return n > 0;
  }

  void read_facets(Word_reader& words, const bool is_smesh)
  {
    const std::size_t n = words.count();
    words.line();
    for(std::size_t f = 0; f < n; ++f)
      if(is_smesh)
      {
        const Polygon polygon = read_polygon(words);
        add_facet(f, { polygon }, { }, words.has_word_in_line() ? static_cast<int>(words.integer()) : 0, words);
      }
      else
      {
        const std::size_t number_of_polygons = words.count();
        const std::size_t number_of_holes = words.has_word_in_line() ? words.count() : 0;
        const int marker = words.has_word_in_line() ? static_cast<int>(words.integer()) : 0;
        words.line();
        std::vector<Polygon> polygons;
        for(std::size_t p = 0; p < number_of_polygons; ++p)
          polygons.push_back(read_polygon(words));
        add_facet(f, polygons, read_places_of_holes(words, number_of_holes), marker, words);
      }
  }

  Polygon read_polygon(Word_reader& words) const
  {
    Polygon polygon(words.count());
    for(std::size_t& v : polygon)
      v = static_cast<std::size_t>(words.integer() - static_cast<long long>(m_soup.first_number));
    return polygon;
  }

  static std::vector<Point> read_places_of_holes(Word_reader& words, const std::size_t n)
  {
    std::vector<Point> places;
    for(std::size_t i = 0; i < n; ++i)
    {
      words.skip_words(1);
      places.push_back(words.point<Point>());
    }
    return places;
  }

  void add_facet(const std::size_t number, const std::vector<Polygon>& polygons, const std::vector<Point>& holes,
                 const int marker, const Word_reader& words)
  {
    if(polygons.size() == 1 && holes.empty())
      return add_polygon(number, polygons[0], marker);
    for(const Polygon& polygon : polygons)
      for(const std::size_t v : polygon)
        if(v >= m_soup.points.size())
          words.fail("it has no such point");
    const auto triangles = polygons.empty() ? std::vector<std::array<std::size_t, 3> >()
                                            : Facet_triangulation<Point>(m_soup.points, polygons)(holes);
    if(triangles.empty())
      words.fail("facet " + std::to_string(number + m_soup.first_number) + " has no area, or edges of it cross");
    for(const auto& t : triangles)
      add_polygon(number, Polygon(t.begin(), t.end()), marker);
  }

  void add_polygon(const std::size_t number, const Polygon& polygon, const int marker)
  {
    typename Polygon_soup<Point>::Polygon bounded;
    bounded.assign(polygon.begin(), polygon.end());
    m_soup.polygons.push_back(bounded);
    m_soup.positions.push_back(number);
    m_markers.push_back(marker);
  }

  void read_places(Word_reader& words)
  {
    const std::size_t number_of_holes = words.has_word() ? words.count() : 0;
    m_soup.voids = read_places_of_holes(words, number_of_holes);
    const std::size_t number_of_regions = words.has_word() ? words.count() : 0;
    for(std::size_t i = 0; i < number_of_regions; ++i)
    {
      words.skip_words(1);
      const Point place = words.point<Point>();
      if(words.has_word_in_line())
        m_soup.regions.push_back({ words.word(), place });
      if(words.has_word_in_line())
        m_number_of_volumes += words.number() > 0;
    }
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_READ_POLY_H

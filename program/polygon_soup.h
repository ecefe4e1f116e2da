#ifndef BOUNDARY_RECOVERY_3_PROGRAM_POLYGON_SOUP_H
#define BOUNDARY_RECOVERY_3_PROGRAM_POLYGON_SOUP_H

#include "surface.h"
#include "utf8.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

// A vector that refuses a size that no file of the given size can fill: what a damaged file asks for would
// exhaust the memory.
template <typename T>
struct Bounded_vector
  : public std::vector<T>
{
  std::size_t bound = 1u << 20;

  void resize(const std::size_t n)
  {
    if(n > bound)
      throw std::length_error("it announces more than it has");
    std::vector<T>::resize(n);
  }
};

// What readers of files make: points and polygons, and what the file tells about them.
template <typename Point>
struct Polygon_soup
  : public Surface_notes<Point>
{
  typedef Bounded_vector<std::size_t> Polygon;

  Bounded_vector<Point> points;
  Bounded_vector<Polygon> polygons;
  std::vector<std::size_t> positions;       // of polygons, in the file; empty: they are in the order of the file
  std::vector<int> patches;                 // of the polygons, 0 for those in none; empty: there are none

  // takes names, in the order of the polygons, as patches; those without a name are in none
  void set_patches_by_names(const std::vector<std::string>& names)
  {
    std::map<std::string, int> numbers;
    patches.clear();
    for(const std::string& name : names)
    {
      const int number = name.empty() ? 0 : numbers.emplace(name, static_cast<int>(numbers.size()) + 1).first->second;
      if(number != 0)
        this->patch_names.emplace(number, as_utf8(name));
      patches.push_back(number);
    }
  }

  // Takes numbers as patches; 0 may stand for none. Patches are positive: numbers that are not become names.
  void set_patches_by_numbers(const std::vector<int>& numbers, const bool is_zero_none)
  {
    const bool are_good = std::all_of(numbers.begin(), numbers.end(),
                                      [&](const int n) { return n > 0 || (n == 0 && is_zero_none); });
    if(are_good)
    {
      patches = numbers;
      return;
    }
    std::vector<std::string> names;
    for(const int n : numbers)
      names.push_back(n == 0 && is_zero_none ? std::string() : std::to_string(n));
    set_patches_by_names(names);
  }

  void leave_out(const std::size_t number, const std::string& what)
  {
    if(number > 0)
      this->notes.push_back(what + " of the file that are left out: " + std::to_string(number));
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_POLYGON_SOUP_H

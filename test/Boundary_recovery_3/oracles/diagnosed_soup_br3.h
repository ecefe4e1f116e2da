// Input that is to be diagnosed, free of kernels, and what the diagnosis says of it, as short strings.

#ifndef BR3_TEST_DIAGNOSED_SOUP_H
#define BR3_TEST_DIAGNOSED_SOUP_H

#include "stopping_visitor_br3.h"

#include <CGAL/Boundary_recovery_3/internal/input/Constraint_intersections_3.h>
#include <CGAL/Boundary_recovery_3/internal/input/Indexed_input_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <iostream>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace br3_test {

namespace internal = CGAL::Boundary_recovery_3::internal;

typedef std::array<double, 3>      Coordinates;
typedef std::array<std::size_t, 3> Facet;
typedef std::array<std::size_t, 2> Edge;
typedef std::vector<std::string>   Strings;

struct Soup
{
  std::vector<Coordinates> points;
  std::vector<Facet> facets;
  std::vector<Edge> edges;
};

template <typename K>
internal::Indexed_input_3<typename K::Point_3> to_input(const Soup& soup)
{
  internal::Indexed_input_3<typename K::Point_3> input;
  for(const Coordinates& c : soup.points)
    input.points.emplace_back(c[0], c[1], c[2]);
  input.facets = soup.facets;
  input.edges = soup.edges;
  return input;
}

// "kind v0 e1 f2": the kind and the dimension and index of each simplex.
template <typename Defects>
Strings names(const Defects& defects)
{
  Strings result;
  for(const auto& defect : defects)
  {
    std::ostringstream os;
    os << to_string(defect.kind);
    for(const auto& simplex : defect.simplices)
      os << ' ' << "vef"[simplex.dimension] << simplex.index;
    result.push_back(os.str());
  }
  return result;
}

template <typename Defects>
std::string full_text(const Defects& defects)
{
  std::ostringstream os;
  for(const auto& defect : defects)
    os << defect << '\n';
  return os.str();
}

// Checks that the simplices carry the vertices and, unless one is missing or not finite, the points of the input.
template <typename Input, typename Defects>
void check_contents(const Input& input, const Defects& defects)
{
  const auto is_equal = [](const auto& a, const auto& b) { return std::equal(a.begin(), a.end(), b.begin(), b.end()); };
  for(const auto& defect : defects)
    for(const auto& s : defect.simplices)
    {
      if(s.dimension == 0)
        assert(s.vertices == std::vector<std::size_t>(1, s.index));
      else if(s.dimension == 1)
        assert(is_equal(s.vertices, input.edges[s.index]));
      else
        assert(is_equal(s.vertices, input.facets[s.index]));

      const bool complete = std::all_of(s.vertices.begin(), s.vertices.end(), [&](std::size_t v)
        { return v < input.points.size() && internal::has_finite_coordinates(input.points[v]); });
      assert(s.points.size() == (complete ? s.vertices.size() : 0));
      for(std::size_t i = 0; i < s.points.size(); ++i)
        assert(s.points[i] == input.points[s.vertices[i]]);
    }
}

// No triangulation is asked for anything; contexts and visitors are those of one.
typedef CGAL::Delaunay_triangulation_3<CGAL::Exact_predicates_inexact_constructions_kernel> Unused_triangulation;
typedef internal::Recovery_context<Unused_triangulation> Context;
typedef Stopping_visitor<Unused_triangulation>           Soup_visitor;

constexpr std::size_t unlimited = std::size_t(-1);

template <typename Intersections>
auto all_defects(const Intersections& intersections, Context& context)
{
  std::size_t number = unlimited;
  const auto result = intersections.defects(context, unlimited, number);
  assert(number == result.size());
  return result;
}

template <typename K, typename Input>
auto intersecting_constraints(const Input& input)
{
  Soup_visitor visitor;
  Context context(visitor);
  const K gt;
  return all_defects(internal::Constraint_intersections_3<K>(input, gt), context);
}

// Asked for one constraint, the search has to say whether a defect names it.
template <typename K, typename Input, typename Defects>
void check_single_constraints(const Input& input, const Defects& defects)
{
  typedef internal::Constraint_intersections_3<K> Intersections;
  std::set<std::pair<int, std::size_t> > named;
  for(const auto& d : defects)
    for(const auto& s : d.simplices)
      named.emplace(s.dimension, s.index);

  const K kernel;
  const Intersections intersections(input, kernel);
  Soup_visitor visitor;
  Context context(visitor);
  const auto check = [&](const typename Intersections::Simplex& s)
  {
    assert(intersections.have_defects({ s }, context, unlimited) == (named.count({ s.dimension, s.index }) > 0));
  };
  std::vector<typename Intersections::Simplex> all;
  for(std::size_t f = 0; f < input.facets.size(); ++f)
    all.push_back(internal::describe_facet(input, f));
  for(std::size_t e = 0; e < input.edges.size(); ++e)
    all.push_back(internal::describe_edge(input, e));
  std::for_each(all.begin(), all.end(), check);
  assert(intersections.have_defects(all, context, unlimited) == ! defects.empty());
  assert(! intersections.have_defects({}, context, unlimited));
}

template <typename K>
Strings intersections(const Soup& soup)
{
  const auto input = to_input<K>(soup);
  const auto defects = intersecting_constraints<K>(input);
  check_contents(input, defects);
  check_single_constraints<K>(input, defects);
  assert(full_text(defects) == full_text(intersecting_constraints<K>(to_input<K>(soup))));

  Strings result;
  const std::string kind = "intersecting_constraints ";
  for(const std::string& name : names(defects))
  {
    assert(name.compare(0, kind.size(), kind) == 0);
    result.push_back(name.substr(kind.size()));
  }
  return result;
}

inline void expect(const std::string& what, const Strings& found, const Strings& expected)
{
  if(found == expected)
    return;
  std::cerr << what << ":\n";
  for(const std::string& s : found)
    std::cerr << "  found    " << s << '\n';
  for(const std::string& s : expected)
    std::cerr << "  expected " << s << '\n';
  assert(found == expected);
}

} // namespace br3_test

#endif // BR3_TEST_DIAGNOSED_SOUP_H

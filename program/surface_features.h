#ifndef BOUNDARY_RECOVERY_3_PROGRAM_SURFACE_FEATURES_H
#define BOUNDARY_RECOVERY_3_PROGRAM_SURFACE_FEATURES_H

#include "triangle_complex.h"
#include "triangle_soup.h"

#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

// the angle in degrees between two directions; 0 if one of them is none
template <typename Vector>
double angle_between(const Vector& v, const Vector& w)
{
  static const double degree = std::acos(-1.) / 180;
  const Vector n = CGAL::cross_product(v, w);
  return std::atan2(std::sqrt(n.squared_length()), v * w) / degree;
}

// Finds the edges of a complex that have to stay: sharp ones, borders, those of more than two triangles or of triangles
// that are not turned alike, and those between triangles with different labels. They are parts of curves, which end at
// corners, and bound patches.
template <typename Complex>
class Feature_marker
{
  typedef typename Complex::Index   Index;
  typedef typename Complex::Indices Indices;
  typedef typename Complex::Kind    Kind;

  Complex& m_complex;
  const std::vector<int>& m_labels; // of the faces
  const double m_angle;             // in degrees
  std::vector<Indices> m_curve_neighbors; // of the vertices, along curves

public:
  Feature_marker(Complex& complex, const std::vector<int>& labels, const double angle)
    : m_complex(complex), m_labels(labels), m_angle(angle), m_curve_neighbors(complex.points.size())
  { }

  // returns the number of patches, and of curves
  std::array<std::size_t, 2> operator()()
  {
    find_curve_edges();
    const std::size_t number_of_patches = number_patches();
    for(Index v = 0; v < m_complex.points.size(); ++v)
      m_complex.kinds[v] = kind(v);
    return {{ number_of_patches, number_curves() }};
  }

private:
  void find_curve_edges()
  {
    std::vector<std::array<Index, 3> > triangles;
    for(const auto& face : m_complex.faces)
      triangles.push_back(face.vertices);
    visit_edges(triangles, [&](const auto edge, const std::size_t number)
    {
      if(number == 2 && ! is_feature(*edge, (edge + 1)->triangle))
        return;
      const Index v = edge->vertices.first, w = edge->vertices.second;
      set_curve(v, w, 0);
      m_curve_neighbors[v].push_back(w);
      m_curve_neighbors[w].push_back(v);
    });
  }

  bool is_feature(const Triangle_edge& edge, const Index g) const
  {
    const auto& face = m_complex.faces[edge.triangle];
    const auto& other = m_complex.faces[g];
    const auto& [v, w] = edge.vertices;
    return m_labels[edge.triangle] != m_labels[g] || face.runs(v, w) == other.runs(v, w) ||
           angle_between(normal(edge.triangle), normal(g)) > m_angle;
  }

  auto normal(const Index f) const
  {
    const auto& v = m_complex.faces[f].vertices;
    return CGAL::normal(m_complex.points[v[0]], m_complex.points[v[1]], m_complex.points[v[2]]);
  }

  // makes an edge a part of a curve
  void set_curve(const Index v, const Index w, const Index curve)
  {
    for(const Index f : m_complex.faces_of_edge(v, w))
      m_complex.faces[f].curves[3 - m_complex.faces[f].position(v) - m_complex.faces[f].position(w)] = curve;
  }

  // patches are what is connected over edges that are no parts of curves
  std::size_t number_patches()
  {
    std::size_t n = 0;
    for(auto& face : m_complex.faces)
      face.patch = Complex::none;
    for(Index f = 0; f < m_complex.faces.size(); ++f)
      if(m_complex.faces[f].patch == Complex::none)
        fill_patch(f, n++);
    return n;
  }

  void fill_patch(const Index first, const Index patch)
  {
    Indices open(1, first);
    m_complex.faces[first].patch = patch;
    while(! open.empty())
    {
      const auto face = m_complex.faces[open.back()];
      open.pop_back();
      for(int i = 0; i < 3; ++i)
        if(face.curves[i] == Complex::none)
          for(const Index g : m_complex.faces_of_edge(face.vertices[(i + 1) % 3], face.vertices[(i + 2) % 3]))
            if(m_complex.faces[g].patch == Complex::none)
            {
              m_complex.faces[g].patch = patch;
              open.push_back(g);
            }
    }
  }

  // Where a curve runs through a vertex without a sharp turn, as many fans of triangles meet there as along the curve.
  Kind kind(const Index v) const
  {
    const Indices& ends = m_curve_neighbors[v];
    const std::size_t number_of_fans = fans(v);
    if(ends.empty())
      return number_of_fans == 1 ? Kind::free : Kind::fixed;
    if(ends.size() != 2 || m_complex.faces_of_edge(v, ends[0]).size() != number_of_fans ||
       m_complex.faces_of_edge(v, ends[1]).size() != number_of_fans)
      return Kind::fixed;
    const auto& p = m_complex.points;
    return angle_between(p[v] - p[ends[0]], p[ends[1]] - p[v]) > m_angle ? Kind::fixed : Kind::on_curve;
  }

  // how often the star of a vertex falls apart if it is cut along curves
  std::size_t fans(const Index v) const
  {
    Indices rest = m_complex.stars[v];
    std::size_t n = 0;
    for(; ! rest.empty(); ++n)
    {
      Indices open(1, rest.back());
      rest.pop_back();
      while(! open.empty())
      {
        const auto& face = m_complex.faces[open.back()];
        open.pop_back();
        for(const Index w : face.vertices)
          if(w != v && face.curve(v, w) == Complex::none)
            move_faces(w, rest, open);
      }
    }
    return n;
  }

  void move_faces(const Index w, Indices& from, Indices& to) const
  {
    const auto has_vertex = [&](const Index f) { return m_complex.faces[f].has(w); };
    std::copy_if(from.begin(), from.end(), std::back_inserter(to), has_vertex);
    from.erase(std::remove_if(from.begin(), from.end(), has_vertex), from.end());
  }

  std::size_t number_curves()
  {
    std::vector<Indices> next = m_curve_neighbors;
    std::size_t n = 0;
    const auto follow = [&](const Index v)
    {
      while(! next[v].empty())
        follow_curve(v, n++, next);
    };
    for(Index v = 0; v < next.size(); ++v)
      if(m_complex.kinds[v] == Kind::fixed)
        follow(v);
    for(Index v = 0; v < next.size(); ++v) // curves that are closed
      follow(v);
    return n;
  }

  // gives its number to the curve that begins with one of the edges of a vertex
  void follow_curve(Index v, const Index curve, std::vector<Indices>& next)
  {
    do
    {
      const Index w = next[v].front();
      next[v].erase(next[v].begin());
      next[w].erase(std::find(next[w].begin(), next[w].end(), v));
      set_curve(v, w, curve);
      v = w;
    }
    while(m_complex.kinds[v] != Kind::fixed && ! next[v].empty());
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_SURFACE_FEATURES_H

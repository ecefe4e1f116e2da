// What is wrong with an input, by the definition and with integers only: nothing here is shared with the library. To be
// linked to brute_force_br3.

#ifndef BR3_TEST_BRUTE_FORCE_INPUT_H
#define BR3_TEST_BRUTE_FORCE_INPUT_H

#include <boost/multiprecision/cpp_int.hpp>

#include <array>
#include <cstddef>
#include <set>
#include <vector>

namespace br3_test {

typedef std::array<double, 3>    Coordinates;
typedef std::vector<std::size_t> Simplex; // vertex indices

// An input of recover_boundary(), and the points that are in the triangulation before.
struct Plc
{
  std::vector<Coordinates> points;
  std::vector<Simplex> triangles, edges;
  std::vector<Coordinates> earlier_points;
};

/*
 * Doubles are integers times a power of two, hence the answers are exact. Small numbers take a fast way.
 *
 * The indices of vertices count the points, then the earlier points.
 */
class Brute_force_input
{
public:
  explicit Brute_force_input(const Plc& plc);

  // Whether the intersection of two closed simplices is more than the hull of their common vertices. That is so iff it
  // has a corner that is no common vertex; and a corner is the only common point of the insides of two faces.
  bool do_intersect(const Simplex& s, const Simplex& t) const;

  bool is_degenerate(Simplex s) const;

  bool are_all_coplanar() const;

  bool has_simple_defect() const;

  // Every edge of the constraints once, as a sorted pair.
  std::set<Simplex> all_edges() const;

  // All pairs of triangles and isolated edges that intersect. A pair is given by its sorted simplices.
  std::set<std::set<Simplex> > intersecting_pairs() const;

  // All the vertices with the constraints they are on, but not corners of; a place is named by its first vertex.
  std::set<std::set<Simplex> > vertices_on_constraints() const;

private:
  typedef boost::multiprecision::cpp_int  Big;
  typedef boost::multiprecision::int128_t Small;

  void set_coordinate(const double x, const int least, const int i);

  Big determinant(const std::size_t o, const std::size_t p, const std::size_t q, const std::size_t r) const;

  bool is_collinear(const std::size_t o, const std::size_t p, const std::size_t q) const;

  std::set<Simplex> edges_of_triangles() const;

  const Plc& m_plc;
  bool m_is_small;
  std::vector<std::vector<Big> > m_big;
  std::vector<std::vector<Small> > m_small;
};

} // namespace br3_test

#endif // BR3_TEST_BRUTE_FORCE_INPUT_H

#ifndef BOUNDARY_RECOVERY_3_PYTHON_SAMPLED_SIZES_H
#define BOUNDARY_RECOVERY_3_PYTHON_SAMPLED_SIZES_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace boundary_recovery {

// Asks a function, a call of which is expensive, for many sizes at a time: for those at the corners of the cells of a
// box that is divided into 4 x 4 x 4 of them. In a cell that is not longer than the sizes at its corners, these are
// interpolated; a longer one is a box itself. So a size is interpolated over one size at most, it depends on the place
// alone, and only boxes are asked for in which somebody wants to know a size.
class Sampled_sizes
{
public:
  typedef std::array<double, 3> Place;

  // All places that are asked for should be in the smallest box around these.
  void set_bounds(const Place& low, const Place& high)
  {
    m_root.low = low;
    m_root.edge = (std::max)({ high[0] - low[0], high[1] - low[1], high[2] - low[2] });
    for(std::size_t i = 0; i < 3; ++i)
      m_root.low[i] -= (m_root.edge - (high[i] - low[i])) / 2;
  }

  // `ask` returns the sizes at some places. Where it has none at a corner, NaN for instance, it is asked for the place
  // itself: it may be defined in the domain only.
  template <typename Ask>
  double operator()(const Place& p, const Ask& ask)
  {
    Box* box = &m_root;
    for(int depth = 0; depth < max_depth && box->contains(p); ++depth)
    {
      if(! box->is_known())
        box->values = ask(box->corners());
      const std::array<std::size_t, 3> cell = box->cell_of(p);
      const double smallest = box->smallest_at(cell);
      if(box->edge / n <= smallest && box->has_all(cell))
        return box->interpolated(cell, p);
      if(box->edge / n <= smallest)
        break;
      box = box->child(cell);
    }
    return ask(std::vector<Place>(1, p))[0];
  }

private:
  static constexpr std::size_t n = 4;      // cells along an edge of a box
  static constexpr int max_depth = 20;

  struct Box
  {
    Place low = {{ 0, 0, 0 }};
    double edge = 0;
    std::vector<double> values;                          // at the corners of the cells; empty if not known
    std::array<std::unique_ptr<Box>, n * n * n> children; // those that were needed

    bool is_known() const { return ! values.empty(); }

    bool contains(const Place& p) const
    {
      for(std::size_t i = 0; i < 3; ++i)
        if(! (p[i] >= low[i] && p[i] <= low[i] + edge))
          return false;
      return edge > 0;
    }

    std::vector<Place> corners() const
    {
      std::vector<Place> result;
      for(std::size_t i = 0; i <= n; ++i)
        for(std::size_t j = 0; j <= n; ++j)
          for(std::size_t k = 0; k <= n; ++k)
            result.push_back({{ corner(0, i), corner(1, j), corner(2, k) }});
      return result;
    }

    double corner(const std::size_t axis, const std::size_t i) const
    {
      return low[axis] + edge * (double(i) / double(n));
    }

    std::array<std::size_t, 3> cell_of(const Place& p) const
    {
      std::array<std::size_t, 3> cell;
      for(std::size_t i = 0; i < 3; ++i)
        cell[i] = (std::min)(n - 1, static_cast<std::size_t>((p[i] - low[i]) / edge * double(n)));
      return cell;
    }

    double value(const std::array<std::size_t, 3>& cell, const std::size_t corner) const
    {
      const std::size_t i = cell[0] + (corner & 1), j = cell[1] + (corner >> 1 & 1), k = cell[2] + (corner >> 2);
      return values[(i * (n + 1) + j) * (n + 1) + k];
    }

    static bool is_size(const double x) { return x > 0 && x < std::numeric_limits<double>::infinity(); }

    bool has_all(const std::array<std::size_t, 3>& cell) const
    {
      for(std::size_t corner = 0; corner < 8; ++corner)
        if(! is_size(value(cell, corner)))
          return false;
      return true;
    }

    // of those that are there, infinity if none is
    double smallest_at(const std::array<std::size_t, 3>& cell) const
    {
      double smallest = std::numeric_limits<double>::infinity();
      for(std::size_t corner = 0; corner < 8; ++corner)
        if(is_size(value(cell, corner)))
          smallest = (std::min)(smallest, value(cell, corner));
      return smallest;
    }

    double interpolated(const std::array<std::size_t, 3>& cell, const Place& p) const
    {
      std::array<double, 3> t;
      for(std::size_t i = 0; i < 3; ++i)
        t[i] = (std::min)(1., (std::max)(0., (p[i] - corner(i, cell[i])) / (edge / double(n))));
      double sum = 0;
      for(std::size_t corner = 0; corner < 8; ++corner)
        sum += value(cell, corner) * (corner & 1 ? t[0] : 1 - t[0]) * (corner & 2 ? t[1] : 1 - t[1]) *
               (corner & 4 ? t[2] : 1 - t[2]);
      return sum;
    }

    Box* child(const std::array<std::size_t, 3>& cell)
    {
      std::unique_ptr<Box>& box = children[(cell[0] * n + cell[1]) * n + cell[2]];
      if(! box)
      {
        box = std::make_unique<Box>();
        for(std::size_t i = 0; i < 3; ++i)
          box->low[i] = corner(i, cell[i]);
        box->edge = edge / double(n);
      }
      return box.get();
    }
  };

  Box m_root;
};

} // namespace boundary_recovery

#endif // BOUNDARY_RECOVERY_3_PYTHON_SAMPLED_SIZES_H

// Minimum and maximum over any range of a growing array, at a cost that hardly depends on the length of the
// range. With it, a curve of a million points is drawn from as many values as there are pixels.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace gaspard {

/// The extrema of an array; NaN and infinity are ignored.
struct Extent {
    double min = std::numeric_limits<double>::infinity();
    double max = -std::numeric_limits<double>::infinity();
    double min_positive = std::numeric_limits<double>::infinity(); ///< for logarithmic axes

    bool empty() const { return min > max; }
    void add(double value);
    void add(const Extent& other);
};

/// append() must be called for every value that is appended to the array.
class Extremes {
  public:
    void append(double value);
    void clear();
    std::size_t size() const { return size_; }
    const Extent& all() const { return all_; }
    /// The extrema of values[begin, end), where `values` is the array. Requires begin <= end <= size().
    Extent of(std::span<const double> values, std::size_t begin, std::size_t end) const;

  private:
    static constexpr std::size_t block = 16;
    std::vector<Extent> blocks_; ///< one per `block` values; the last may have fewer
    Extent all_;
    std::size_t size_ = 0;
};

} // namespace gaspard

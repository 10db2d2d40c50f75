// The smallest and the largest number of any stretch of a growing column, at a cost that hardly depends on
// the stretch's length. With it a curve of a million points is drawn from as many values as there are pixels.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace gaspard {

/// What numbers lie between. NaN and infinity do not count.
struct Extent {
    double min = std::numeric_limits<double>::infinity();
    double max = -std::numeric_limits<double>::infinity();
    double min_positive = std::numeric_limits<double>::infinity(); ///< for logarithmic axes

    bool empty() const { return min > max; }
    void add(double value);
    void add(const Extent& other);
};

/// Beside a column that only grows, append() is called for each of its values.
class Extremes {
  public:
    void append(double value);
    void clear();
    std::size_t size() const { return size_; }
    const Extent& all() const { return all_; }
    /// Of values[begin, end), where `values` is the column. Needs begin <= end <= size().
    Extent of(std::span<const double> values, std::size_t begin, std::size_t end) const;

  private:
    static constexpr std::size_t block = 16;
    std::vector<Extent> blocks_; ///< of `block` values each, the last one perhaps of fewer
    Extent all_;
    std::size_t size_ = 0;
};

} // namespace gaspard

#include "core/tessellate/extremes.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <cmath>

namespace gaspard {

void Extent::add(double value) {
    if (!std::isfinite(value)) return;
    min = std::min(min, value);
    max = std::max(max, value);
    if (value > 0) min_positive = std::min(min_positive, value);
}

void Extent::add(const Extent& other) {
    min = std::min(min, other.min);
    max = std::max(max, other.max);
    min_positive = std::min(min_positive, other.min_positive);
}

void Extremes::append(double value) {
    if (size_ % block == 0) blocks_.emplace_back();
    blocks_.back().add(value);
    all_.add(value);
    ++size_;
}

void Extremes::clear() { *this = {}; }

Extent Extremes::of(std::span<const double> values, std::size_t begin, std::size_t end) const {
    GASPARD_CHECK(begin <= end && end <= size_ && values.size() == size_);
    Extent extent;
    std::size_t i = begin;
    for (; i < end && i % block != 0; ++i) extent.add(values[i]);
    for (; i + block <= end; i += block) extent.add(blocks_[i / block]);
    for (; i < end; ++i) extent.add(values[i]);
    return extent;
}

} // namespace gaspard

#include "core/transport/arc_length.hpp"

#include "core/base/check.hpp"
#include "core/fem/gauss.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gaspard {

ArcLength::ArcLength(std::function<double(double)> speed, const std::vector<double>& breaks)
    : speed_(std::move(speed)), lengths_{0} {
    GASPARD_CHECK(breaks.size() >= 2);
    knots_.push_back(breaks.front());
    double estimate = 0;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) estimate += integral(breaks[i], breaks[i + 1]);
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
        add(breaks[i], breaks[i + 1], integral(breaks[i], breaks[i + 1]), 1e-15 * estimate, 0);
}

double ArcLength::integral(double low, double high) const {
    static const LineQuadrature rule = gauss_legendre(12);
    double sum = 0;
    for (std::size_t i = 0; i < rule.points.size(); ++i)
        sum += rule.weights[i] * speed_(low + (high - low) * rule.points[i]);
    return (high - low) * sum;
}

void ArcLength::add(double low, double high, double whole, double accepted, int depth) {
    constexpr int deepest = 48; // at a break the speed may be a power of the distance
    const double middle = low + (high - low) / 2;
    const double left = integral(low, middle), right = integral(middle, high), error = left + right - whole;
    if (std::abs(error) > std::max(accepted, 1e-14 * whole) && depth < deepest) {
        add(low, middle, left, accepted, depth + 1);
        add(middle, high, right, accepted, depth + 1);
        return;
    }
    knots_.push_back(high);
    lengths_.push_back(lengths_.back() + whole);
}

double ArcLength::parameter(double length) const {
    const auto above = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, length);
    const auto i = static_cast<std::size_t>(above - lengths_.begin()) - 1;
    double low = knots_[i], high = knots_[i + 1];
    const double wanted = length - lengths_[i], whole = lengths_[i + 1] - lengths_[i], start = low;
    if (!(wanted > 0)) return low;
    if (wanted >= whole) return high;
    double u = low + (high - low) * (wanted / whole);
    for (int iteration = 0; iteration < 60; ++iteration) {
        const double excess = integral(start, u) - wanted;
        (excess > 0 ? high : low) = u;
        if (std::abs(excess) <= 1e-15 * total()) break;
        double next = u - excess / speed_(u);
        if (!(next > low && next < high)) next = low + (high - low) / 2; // Newton's step leaves the bracket
        if (next == u) break;
        u = next;
    }
    return u;
}

} // namespace gaspard

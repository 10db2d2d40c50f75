#include "core/function/line_resampling.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace gaspard {

namespace {

/// Images beside each end; their influence falls by 0.27 from point to point.
constexpr std::size_t most_images = 24;

/// The slope at `at` of the polynomial through the points (Lagrange).
double end_slope(std::span<const double> x, std::span<const double> y, std::size_t at) {
    double slope = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (i == at) {
            for (std::size_t k = 0; k < x.size(); ++k)
                if (k != at) slope += y[at] / (x[at] - x[k]);
            continue;
        }
        double factor = 1 / (x[i] - x[at]);
        for (std::size_t k = 0; k < x.size(); ++k)
            if (k != i && k != at) factor *= (x[at] - x[k]) / (x[i] - x[k]);
        slope += factor * y[i];
    }
    return slope;
}

struct Limits {
    double low, high;
};

/// Second divided differences at inner points; 0 at the ends.
std::vector<double> second_differences(std::span<const double> x, std::span<const double> y) {
    std::vector<double> all(x.size(), 0);
    for (std::size_t i = 1; i + 1 < x.size(); ++i)
        all[i] = ((y[i + 1] - y[i]) / (x[i + 1] - x[i]) - (y[i] - y[i - 1]) / (x[i] - x[i - 1])) /
                 (x[i + 1] - x[i - 1]);
    return all;
}

/// Whether the curve between points i and i + 1 is like a parabola.
bool is_smooth(std::span<const double> second, std::size_t i) {
    const std::size_t begin = std::max<std::size_t>(i, 2) - 1, end = std::min(i + 3, second.size() - 1);
    if (end < begin + 2) return false;
    const auto [low, high] = std::minmax_element(second.begin() + static_cast<std::ptrdiff_t>(begin),
                                                 second.begin() + static_cast<std::ptrdiff_t>(end));
    constexpr double factor = 3;
    return (*low > 0 && *high <= factor * *low) || (*high < 0 && *low >= factor * *high);
}

/// What the curve may reach between points i and i + 1.
Limits limits_between(std::span<const double> y, std::span<const double> second, std::size_t i) {
    const auto [low, high] = std::minmax(y[i], y[i + 1]);
    if (!is_smooth(second, i)) return {low, high};
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return {low > 0 ? low / 2 : -infinity, high < 0 ? high / 2 : infinity};
}

double median_spacing(const std::vector<double>& axis) {
    std::vector<double> steps(axis.size() - 1);
    for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = axis[i + 1] - axis[i];
    std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2),
                     steps.end());
    return steps[steps.size() / 2];
}

} // namespace

LineResampling::LineResampling(std::vector<double> axis, double first, double step, std::size_t count,
                               std::optional<double> period)
    : axis_(std::move(axis)), sources_(axis_.size()) {
    GASPARD_CHECK(axis_.size() >= 2 && count > 0);
    std::iota(sources_.begin(), sources_.end(), std::size_t{0});
    const double spacing = median_spacing(axis_);
    if (period) go_around(*period);
    const double ratio = std::abs(step) / spacing;
    average_ = static_cast<std::size_t>(std::clamp(std::round(ratio), 1.0, 64.0));
    const auto n = static_cast<double>(average_);
    for (std::size_t i = 0; i < count; ++i) {
        const double middle = first + static_cast<double>(i) * step;
        bool covered = false;
        for (std::size_t k = 0; k < average_; ++k) {
            const double at = middle + ((static_cast<double>(k) + 0.5) / n - 0.5) * (average_ > 1 ? step : 0);
            samples_.push_back(sample(at, period));
            const double turns =
                period ? std::floor((at - axis_.front() + spacing / 2) / *period) * *period : 0;
            covered = covered || (at - turns >= axis_.front() - spacing / 2 - 1e-9 * spacing &&
                                  at - turns <= axis_.back() + spacing / 2 + 1e-9 * spacing);
        }
        covered_.push_back(covered ? 1 : 0);
    }
    prepare_slopes();
}

/// Begins the axis after its largest gap, and adds images if that gap is a step like the others.
void LineResampling::go_around(double period) {
    std::vector<std::pair<double, std::size_t>> points;
    for (std::size_t i = 0; i < axis_.size(); ++i)
        points.emplace_back(axis_[i] - period * std::floor((axis_[i] - axis_[0]) / period), i);
    std::sort(points.begin(), points.end());
    const double same = 1e-6 * period / static_cast<double>(axis_.size());
    const auto last = std::unique(points.begin(), points.end(),
                                  [&](const auto& a, const auto& b) { return b.first - a.first < same; });
    points.erase(last, points.end());
    if (points.size() > 2 && points.front().first + period - points.back().first < same) points.pop_back();
    if (points.size() < 2) return;
    std::size_t gap = 0; // before this point
    double largest = points.front().first + period - points.back().first;
    for (std::size_t i = 1; i < points.size(); ++i)
        if (points[i].first - points[i - 1].first > largest * (1 + 1e-9))
            gap = i, largest = points[i].first - points[i - 1].first;
    std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(gap), points.end());
    for (std::size_t i = 0; i < points.size(); ++i)
        if (i >= points.size() - gap) points[i].first += period;
    const std::size_t n = points.size();
    const bool around = largest < 1.75 * (period - largest) / static_cast<double>(n - 1);
    const std::size_t images = around ? most_images : 0;
    axis_.clear(), sources_.clear();
    for (std::size_t k = 0; k < n + 2 * images; ++k) {
        const auto shifted = static_cast<std::ptrdiff_t>(k) - static_cast<std::ptrdiff_t>(images);
        const auto size = static_cast<std::ptrdiff_t>(n);
        const std::ptrdiff_t turn = shifted >= 0 ? shifted / size : -((-shifted + size - 1) / size);
        const auto& point = points[static_cast<std::size_t>(shifted - turn * size)];
        axis_.push_back(point.first + static_cast<double>(turn) * period);
        sources_.push_back(point.second);
    }
}

LineResampling::Sample LineResampling::sample(double at, std::optional<double> period) {
    if (period) { // the image in the middle of the axis
        const double middle = 0.5 * (axis_.front() + axis_.back());
        at -= *period * std::round((at - middle) / *period);
    }
    at = std::clamp(at, axis_.front(), axis_.back());
    const auto above = std::upper_bound(axis_.begin() + 1, axis_.end() - 1, at) - axis_.begin();
    const auto i = static_cast<std::size_t>(above - 1);
    return {i, (at - axis_[i]) / (axis_[i + 1] - axis_[i])};
}

/// The slopes m of the spline at inner points, with the steps h:
/// m_(i-1) / h_(i-1) + 2 (1 / h_(i-1) + 1 / h_i) m_i + m_(i+1) / h_i = 3 ((y_i - y_(i-1)) / h_(i-1)^2 + ...).
void LineResampling::prepare_slopes() {
    const std::size_t n = axis_.size();
    upper_.assign(n, 0), inverse_.assign(n, 1);
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const double before = 1 / (axis_[i] - axis_[i - 1]), after = 1 / (axis_[i + 1] - axis_[i]);
        inverse_[i] = 1 / (2 * (before + after) - before * upper_[i - 1]);
        upper_[i] = after * inverse_[i];
    }
}

void LineResampling::apply(std::span<const double> given, std::span<double> wanted) const {
    const std::size_t n = axis_.size(), around = std::min<std::size_t>(n, 4);
    std::vector<double> y(n), slopes(n);
    for (std::size_t i = 0; i < n; ++i) y[i] = given[sources_[i]];
    const std::span<const double> x(axis_), values(y);
    slopes[0] = end_slope(x.first(around), values.first(around), 0);
    slopes[n - 1] = end_slope(x.last(around), values.last(around), around - 1);
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const double before = 1 / (x[i] - x[i - 1]), after = 1 / (x[i + 1] - x[i]);
        const double right = 3 * ((y[i] - y[i - 1]) * before * before + (y[i + 1] - y[i]) * after * after);
        slopes[i] = (right - before * slopes[i - 1]) * inverse_[i];
    }
    for (std::size_t i = n - 1; i-- > 1;) slopes[i] -= upper_[i] * slopes[i + 1];
    const std::vector<double> second = second_differences(x, values);
    std::vector<Limits> limits(n - 1);
    for (std::size_t i = 0; i + 1 < n; ++i) limits[i] = limits_between(values, second, i);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        double sum = 0;
        for (std::size_t k = 0; k < average_; ++k) {
            const auto [at, t] = samples_[i * average_ + k];
            const double h = x[at + 1] - x[at], rest = 1 - t;
            const double spline = rest * rest * (1 + 2 * t) * y[at] + t * t * (3 - 2 * t) * y[at + 1] +
                                  h * t * rest * (rest * slopes[at] - t * slopes[at + 1]);
            sum += std::clamp(spline, limits[at].low, limits[at].high);
        }
        wanted[i] = sum / static_cast<double>(average_);
    }
}

} // namespace gaspard

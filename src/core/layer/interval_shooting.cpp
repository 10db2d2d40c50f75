#include "core/layer/interval_shooting.hpp"

#include "core/base/error.hpp"
#include "core/base/parameter.hpp"
#include "core/base/short_number.hpp"
#include "core/layer/interval_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace gaspard {

namespace {

using Index = std::size_t;

std::vector<double> shares_of(std::span<const double> densities, std::span<const double> x) {
    std::vector<double> shares(densities.size());
    for (Index i = 0; i < shares.size(); ++i) shares[i] = densities[i] * (x[i + 1] - x[i]);
    return shares;
}

/// Evaluates shares of single cells.
class Share {
  public:
    explicit Share(const Monitor& rho) : rho_(rho), one_(1), two_(2) {}

    double density(double x) {
        one_.x[0] = x;
        double value = 0;
        rho_.values(one_, {&value, 1});
        check(value, x);
        return value;
    }
    /// r d of the cell from left, where the density is given, to right; keeps the density there.
    double operator()(double left, double at_left, double right) {
        two_.x = {left + 0.5 * (right - left), right};
        std::array<double, 2> value{};
        rho_.values(two_, value);
        for (Index i = 0; i < 2; ++i) check(value[i], two_.x[i]);
        at_right_ = value[1];
        return (at_left / 6 + value[0] * (2.0 / 3) + value[1] / 6) * (right - left);
    }
    double at_right() const { return at_right_; }

  private:
    static void check(double value, double x) {
        if (!(value > 0) || !std::isfinite(value))
            throw InputError("the density of the mesh must be positive and finite, but is " +
                             exact_number(value) + " at " + exact_number(x));
    }
    const Monitor& rho_;
    Points one_, two_;
    double at_right_ = 0;
};

/// The mesh that guides a shot: positions by the sum of shares, and densities at its nodes.
class Guide {
  public:
    Guide(std::span<const double> x, const std::vector<double>& shares, const Monitor& rho)
        : x_(x), sums_(x.size(), 0.0), rho_(x.size()) {
        for (Index i = 0; i < shares.size(); ++i) sums_[i + 1] = sums_[i] + shares[i];
        Points at(x.size());
        at.x.assign(x.begin(), x.end());
        rho.values(at, rho_);
    }
    /// Goes on to the cell of the guide in which a cell starts; from left to right.
    void start(double left) {
        while (at_ + 2 < x_.size() && x_[at_ + 1] <= left) ++at_;
    }
    /// Where the cell from `left` with the given share ends by the guide.
    double end(double left, double share) const {
        const double part = std::clamp((left - x_[at_]) / (x_[at_ + 1] - x_[at_]), 0.0, 1.0);
        const double wanted = sums_[at_] + part * (sums_[at_ + 1] - sums_[at_]) + share;
        Index i = at_;
        while (i + 2 < x_.size() && sums_[i + 1] < wanted) ++i;
        const double rest = (wanted - sums_[i]) / (sums_[i + 1] - sums_[i]);
        return x_[i] + rest * (x_[i + 1] - x_[i]);
    }
    /// A node where the share is larger for certain, as rho (x - left) / 6 alone is: the cell ends before it,
    /// though behind a spike its share may be small again. b if there is none nearby.
    double limit(double left, double share) const {
        constexpr Index nearby = 64;
        for (Index i = at_ + 1; i < std::min(x_.size(), at_ + nearby); ++i)
            if (rho_[i] * (x_[i] - left) > 6 * share) return x_[i];
        return x_.back();
    }

  private:
    std::span<const double> x_;
    std::vector<double> sums_, rho_;
    Index at_ = 0;
};

/// The right end of a cell with share C, near `guess`; nothing if the cells up to b have less. The root is
/// bracketed, then approached by secants of the logarithms, which are nearly straight.
std::optional<double> cell_end(Share& share, double left, double at_left, const Guide& guide, double c,
                               double b) {
    constexpr double tolerance = 4e-16, growth = 4;
    double low = left, high = b, log_low = 0, log_high = 0; // logarithms of share / C
    bool has_low = false, has_high = false, was_short = false;
    const double limit = std::max(guide.limit(left, c), std::nextafter(left, b));
    double y = std::clamp(guide.end(left, c), std::nextafter(left, b), limit);
    for (int k = 0; k < 200; ++k) {
        const double ratio = share(left, at_left, y) / c;
        if (std::abs(ratio - 1) <= tolerance) return y;
        const bool short_of = ratio < 1;
        if (short_of && y >= b) return {};
        if (k > 0 && short_of == was_short) (short_of ? log_high : log_low) *= 0.5; // Illinois
        was_short = short_of;
        if (short_of)
            low = y, log_low = std::log(ratio), has_low = true;
        else
            high = y, log_high = std::log(ratio), has_high = true;
        const double d = y - left;
        if (!has_high)
            y = std::min(y < limit ? limit : b, left + d * std::clamp(1.05 / ratio, 1.0 + 1e-6, growth));
        else if (!has_low)
            y = left + d * std::clamp(0.95 / ratio, 1 / growth, 1.0 - 1e-6);
        else
            y = left + (low - left) * std::pow((high - left) / (low - left), log_low / (log_low - log_high));
        if (!(y > low && y < high)) y = low + 0.5 * (high - low);
        if (has_high && !(y > low && y < high)) return -log_low < log_high && low > left ? low : high;
        if (!has_high && y <= low) y = b;
    }
    return y;
}

/// The nodes of a shot, densities there, and the share of the last cell, which b cuts off.
struct Shot {
    std::vector<double> x, rho;
    double share = 0, last = 0;

    /// T(C) - cells, without rounding the sum.
    double excess(Index cells) const {
        return static_cast<double>(x.size()) - 2 - static_cast<double>(cells) + last / share;
    }
};

/// What rounding of a node takes from a share is given to the next, so that no sum of shares is wrong by
/// more.
Shot shoot(const Monitor& rho, Guide guide, double a, double b, double c, Index most) {
    Share share(rho);
    Shot shot{{a}, {share.density(a)}, c, 0};
    double carry = 0;
    for (;;) {
        const double left = shot.x.back(), at_left = shot.rho.back(), wanted = c + carry;
        guide.start(left);
        std::optional<double> right;
        if (shot.x.size() <= most) right = cell_end(share, left, at_left, guide, wanted, b);
        // A root next to b: the cell ends there, with a little more than its share.
        const bool close = right && b - *right < 1e-3 * (b - left) && share(left, at_left, b) < 1.001 * c;
        const double end = right && !close ? *right : b;
        shot.x.push_back(end);
        const double made = share(left, at_left, end);
        shot.rho.push_back(share.at_right());
        if (end == b) {
            shot.last = made - carry;
            return shot;
        }
        carry = wanted - made;
    }
}

/// Position in a cell of a shot, 0 <= t <= 1, by a monotone rational function with dx/dt = C / rho at both
/// ends.
double within(const Shot& shot, Index cell, double t) {
    const double left = shot.x[cell], d = shot.x[cell + 1] - left;
    const bool cut = cell + 2 == shot.x.size(); // b is not a node of its own
    const double share = cut ? shot.last : shot.share;
    const double first = share / shot.rho[cell], second = share / shot.rho[cell + 1];
    const double both = t * (1 - t);
    return left + d * (d * t * t + first * both) / (d + (first + second - 2 * d) * both);
}

/// Divides the cells of a shot evenly; one that takes nearly as many cells keeps its nodes.
std::vector<double> divided(const Shot& shot, Index cells) {
    constexpr double negligible = 1e-3;
    std::vector<double> x(cells + 1, shot.x.front());
    x.back() = shot.x.back();
    const Index whole = shot.x.size() - 2;
    const double last = shot.last / shot.share, excess = shot.excess(cells);
    for (Index i = 1; i < cells; ++i) {
        const double shift = excess * (static_cast<double>(i) / static_cast<double>(cells));
        const Index cell = std::min(static_cast<Index>(static_cast<double>(i) + std::floor(shift)), whole);
        const double t = static_cast<double>(i) - static_cast<double>(cell) + shift;
        x[i] = std::abs(excess) < negligible
                   ? shot.x[i]
                   : within(shot, cell, cell == whole ? std::min(t / last, 1.0) : t);
    }
    return x;
}

double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

} // namespace

double share_deviation(std::span<const double> densities, std::span<const double> x) {
    const auto shares = shares_of(densities, x);
    const double c = mean(shares);
    double most = 0;
    for (const double share : shares) most = std::max(most, std::abs(share / c - 1));
    return most;
}

double share_rounding(const Monitor& rho, std::span<const double> densities, std::span<const double> x) {
    const double c = mean(shares_of(densities, x));
    Points at(2 * x.size());
    for (Index i = 0; i < x.size(); ++i) {
        at.x[2 * i] = x[i];
        at.x[2 * i + 1] = std::nextafter(x[i], i + 1 < x.size() ? x.back() : x.front());
    }
    std::vector<double> values(at.size());
    rho.values(at, values);
    double most = 0x1p-53 * static_cast<double>(densities.size()); // C is rounded as well
    for (Index i = 0; i + 1 < x.size(); ++i)
        for (const Index k : {i, i + 1}) {
            const double unit = std::abs(at.x[2 * k + 1] - x[k]);
            const double change = std::abs(values[2 * k + 1] - values[2 * k]) * (x[i + 1] - x[i]) / 6;
            most = std::max(most, (0.5 * densities[i] * unit + 0.5 * change) / c);
        }
    return most;
}

IntervalShooting::IntervalShooting(std::vector<double> x)
    : x_(std::move(x)), excess_(std::numeric_limits<double>::infinity()), deviation_(excess_) {
    if (x_.size() < 2) throw InputError("a mesh of an interval must have at least two nodes");
    for (Index i = 1; i < x_.size(); ++i)
        if (!(x_[i] > x_[i - 1]))
            throw InputError("the nodes of a mesh must grow, but " + exact_number(x_[i]) + " comes after " +
                             exact_number(x_[i - 1]));
}

/// First the median share of the mesh, which a single cell of the layer does not spoil; then 1/C as T asks
/// for; then by secants of the logarithms, or by halving where these do not close the bounds.
double IntervalShooting::next_share() const {
    if (share_ <= 0) {
        std::vector<double> shares = shares_;
        const auto middle = shares.begin() + static_cast<std::ptrdiff_t>(shares.size() / 2);
        std::nth_element(shares.begin(), middle, shares.end());
        return *middle;
    }
    const auto cells = static_cast<double>(x_.size() - 1);
    if (!many_ || !few_) return share_ * std::max(1 + excess_ / cells, 1e-6);
    // The secant of the last two shots, where it is between the bounds; they must close as well.
    const double low = many_->share, high = few_->share;
    const double log_ratio = std::log1p((last_.share - before_.share) / before_.share);
    double next = last_.share;
    next += next * std::expm1(-last_.log_cells * log_ratio / (last_.log_cells - before_.log_cells));
    if (slow_ < 4 && next > low && next < high) return next;
    return high < 2 * low ? low + 0.5 * (high - low) : std::sqrt(low) * std::sqrt(high);
}

void IntervalShooting::step(const Monitor& rho) {
    if (shares_.empty()) guide_ = x_, shares_ = shares_of(cell_densities(rho, x_), x_);
    share_ = next_share();
    const Index cells = x_.size() - 1;
    const Shot shot = shoot(rho, Guide(guide_, shares_, rho), x_.front(), x_.back(), share_, 4 * x_.size());
    excess_ = shot.excess(cells);
    const End end{share_, std::log1p(excess_ / static_cast<double>(cells))};
    before_ = last_, last_ = end;
    const double width = bounds();
    (excess_ > 0 ? many_ : few_) = end;
    if (many_ && few_ && !(many_->share < few_->share)) // the density shows more, or less, than before
        (excess_ > 0 ? few_ : many_).reset();
    slow_ = bounds() > 0.5 * width ? slow_ + 1 : 0;
    x_ = divided(shot, cells);
    const auto densities = cell_densities(rho, x_);
    const double total = share_ * (excess_ + static_cast<double>(cells));
    if (total > 0.9 * most_) most_ = total, guide_ = x_, shares_ = shares_of(densities, x_);
    deviation_ = share_deviation(densities, x_);
    rounding_ = share_rounding(rho, densities, x_);
}

/// ln(C too large / C too small).
double IntervalShooting::bounds() const {
    return many_ && few_ ? std::log1p((few_->share - many_->share) / many_->share)
                         : std::numeric_limits<double>::infinity();
}

bool IntervalShooting::stuck() const {
    return many_ && few_ && std::nextafter(many_->share, few_->share) >= few_->share;
}

ShootingResult shoot_interval(const Monitor& rho, std::span<const double> x, double tolerance,
                              int max_shots) {
    IntervalShooting shooting({x.begin(), x.end()});
    ShootingResult result;
    while (result.shots < max_shots && !shooting.stuck()) {
        shooting.step(rho);
        ++result.shots;
        result.converged = shooting.converged(tolerance);
        if (result.converged) break;
    }
    result.x = shooting.mesh();
    result.deviation = shooting.deviation();
    result.rounding = shooting.rounding();
    return result;
}

} // namespace gaspard

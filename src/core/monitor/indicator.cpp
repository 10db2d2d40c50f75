#include "core/monitor/indicator.hpp"

#include "core/base/error.hpp"
#include "core/base/parameter.hpp"
#include "core/base/short_number.hpp"
#include "core/function/derivative_norms.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gaspard {

namespace {

constexpr std::size_t block = 8192; // points: small enough for the cache, and to stop soon

void look(const DataContext& context) {
    if (context.stop.stop_requested()) throw Interrupted();
}

std::string place(Vec3 x) {
    return "(" + exact_number(x.x) + ", " + exact_number(x.y) + ", " + exact_number(x.z) + ")";
}

Points part_of(const Points& x, std::size_t from, std::size_t to) {
    Points part(to - from);
    for (std::size_t i = from; i < to; ++i) part.set(i - from, x[i]);
    return part;
}

struct Range {
    double low = 0, high = 0, largest = 0; ///< of u, and max |u|
    double span() const { return high - low; }
};

/// Over the points of the domain.
Range range_of(const DomainGrid& domain, const ScalarFunction& u, const DataContext& context) {
    Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    std::vector<double> values;
    for (std::size_t from = 0; from < domain.x.size(); from += block) {
        look(context);
        const Points x = part_of(domain.x, from, std::min(from + block, domain.x.size()));
        values.resize(x.size());
        u.values(x, values);
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (!(domain.measures[from + i] > 0)) continue;
            if (!std::isfinite(values[i]))
                throw InputError("u is " + exact_number(values[i]) + " at " + place(x[i]) +
                                 "; it must be finite everywhere on the domain");
            range.low = std::min(range.low, values[i]), range.high = std::max(range.high, values[i]);
        }
    }
    range.largest = std::max(std::abs(range.low), std::abs(range.high));
    return range;
}

/// (1 + a d^2)^p - 1, without cancellation for small d and overflow for large ones.
double excess(double a, double d, double p) {
    constexpr double large = 1e100;
    return std::expm1(p * (d < large ? std::log1p(a * d * d) : std::log(a) + 2 * std::log(d)));
}

/// u times a power of two, so that neither squares nor differences overflow.
class Scaled final : public ScalarFunction {
  public:
    Scaled(const ScalarFunction& u, int power) : u_(u), power_(power) {}
    void values(const Points& x, std::span<double> values) const override {
        u_.values(x, values);
        for (double& value : values) value = std::scalbn(value, power_);
    }
    void gradients(const Points& x, Points& gradients) const override {
        u_.gradients(x, gradients);
        for (std::size_t i = 0; i < gradients.size(); ++i) {
            const Vec3 g = gradients[i];
            gradients.set(i, {std::scalbn(g.x, power_), std::scalbn(g.y, power_), std::scalbn(g.z, power_)});
        }
    }

  private:
    const ScalarFunction& u_;
    int power_;
};

/// The power with which the largest |u| is about 1.
int power_of(const Range& range) { return range.largest > 0 ? -std::ilogb(range.largest) : 0; }

Range scaled(const Range& range, int power) {
    return {std::scalbn(range.low, power), std::scalbn(range.high, power), std::scalbn(range.largest, power)};
}

/// q at points of the domain. u is evaluated times 2^power, of which `range` is.
class Formula {
  public:
    Formula(const DomainGrid& domain, const ScalarFunction& u, const DerivedOptions& options,
            const Range& range, int power)
        : u_(u, power), options_(options), norms_(u_, domain.grid.chart, domain.size, !domain.patch) {
        scale_ = std::scalbn(1.0, -power);
        if (!options.normalise) return;
        const bool by_size = options.indicator == Indicator::magnitude;
        scale_ = 1 / (by_size ? range.largest : range.span());
        if (options.indicator == Indicator::band) shift_ = range.low;
        length_ = domain.size;
    }

    void values(const Points& s, const Points& x, std::span<double> q) const {
        const double a = options_.alpha;
        switch (options_.indicator) {
        case Indicator::arc_length:
            norms_.gradients(s, x, q);
            for (double& one : q) one = excess(a, scale_ * length_ * one, 0.5);
            return;
        case Indicator::curvature:
            norms_.hessians(s, x, q);
            for (double& one : q) one = excess(a, scale_ * length_ * length_ * one, 0.5 / options_.order);
            return;
        case Indicator::gradient:
            norms_.gradients(s, x, q);
            for (double& one : q) one *= scale_ * length_;
            return;
        case Indicator::magnitude:
            u_.values(x, q);
            for (double& one : q) one = std::abs(scale_ * one);
            return;
        case Indicator::band:
            u_.values(x, q);
            for (double& one : q) {
                const double z = (scale_ * (one - shift_) - options_.level) / options_.width;
                one = a * (options_.gaussian ? std::exp(-z * z) : 1 / std::cosh(z));
            }
        }
    }

  private:
    Scaled u_;
    const DerivedOptions& options_;
    DerivativeNorms norms_;
    double scale_ = 1, shift_ = 0, length_ = 1;
};

/// Whether all of the part of the domain that a point of a grid in two directions stands for is inside.
bool is_inner(const DomainGrid& domain, std::size_t point) {
    const std::size_t first = domain.grid.directions[0].count, i = point % first, j = point / first;
    if (i == 0 || i + 1 == first || j == 0 || j + 1 == domain.grid.directions[1].count) return false;
    for (const std::size_t row : {point - first, point, point + first})
        for (const std::size_t one : {row - 1, row, row + 1})
            if (!(domain.measures[one] > 0)) return false;
    return true;
}

/// Four places around every point of a grid, a quarter of the spacing away; where these may leave the domain,
/// the point itself.
Points moved(const DomainGrid& domain, std::size_t from, std::size_t to, int corner) {
    const double ds = (corner % 2 == 0 ? -0.25 : 0.25) * domain.grid.spacing(0);
    const double dt = (corner / 2 == 0 ? -0.25 : 0.25) * domain.grid.spacing(1);
    Points s = part_of(domain.s, from, to);
    for (std::size_t i = 0; i < s.size(); ++i)
        if (is_inner(domain, from + i)) s.set(i, s[i] + Vec3{ds, dt, 0});
    return s;
}

} // namespace

IndicatorValues indicator_on(const DomainGrid& domain, const ScalarFunction& u, const DerivedOptions& options,
                             bool fine, const DataContext& context) {
    const Range own = range_of(domain, u, context);
    const int power = power_of(own);
    const Range range = scaled(own, power);
    constexpr double huge = 1e250; // differences of u may overflow
    const bool has_one =
        options.indicator != Indicator::gradient && options.indicator != Indicator::magnitude;
    IndicatorValues result{.q = std::vector<double>(domain.x.size()), .background = has_one ? 1.0 : 0.0};
    result.constant = range.span() <= 1e-14 * range.largest;
    const bool flat = options.indicator == Indicator::magnitude ? range.largest == 0 : result.constant;
    if (flat && options.normalise) return result;
    const Formula formula(domain, u, options, range, power);
    const int places = fine && domain.dimension() == 2 ? 4 : 1;
    std::vector<double> values;
    for (std::size_t from = 0; from < domain.x.size(); from += block) {
        look(context);
        if (context.progress)
            context.progress(static_cast<double>(from) / static_cast<double>(domain.x.size()),
                             "computing the indicator");
        const std::size_t to = std::min(from + block, domain.x.size());
        const std::span<double> q(result.q.data() + from, to - from);
        std::vector<int> counts(q.size());
        values.resize(q.size());
        Points x = part_of(domain.x, from, to), s = part_of(domain.s, from, to);
        for (int corner = 0; corner < places; ++corner) {
            if (places > 1) {
                s = moved(domain, from, to, corner);
                domain.grid.chart->points(s, x);
            }
            formula.values(s, x, values);
            for (std::size_t i = 0; i < q.size(); ++i)
                if (std::isfinite(values[i]))
                    q[i] += values[i], ++counts[i];
                else if (own.largest > huge && domain.measures[from + i] > 0)
                    throw InputError("the derivatives of u, which is as large as " +
                                     exact_number(own.largest) + ", overflow at " + place(x[i]) +
                                     "; divide u by a number");
        }
        for (std::size_t i = 0; i < q.size(); ++i) {
            if (counts[i] == 0 && domain.measures[from + i] > 0)
                throw InputError("the derivatives of u are not finite at " + place(x[i]) +
                                 "; monitor.kind = band or magnitude needs none");
            q[i] /= std::max(counts[i], 1);
        }
    }
    return result;
}

} // namespace gaspard

#include "core/function/formula.hpp"

#include "core/base/box.hpp"
#include "core/base/check.hpp"
#include "core/base/parameter.hpp"
#include "core/function/expression.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <numbers>
#include <utility>

namespace gaspard {

namespace {

constexpr std::size_t block = 64;          // points whose differences are evaluated together
constexpr std::size_t most_samples = 4096; // from which steps are chosen
constexpr double part = 5e-4;              // of the length over which f changes: the step
constexpr double least_length = 1e-4;      // of that length, relative to the domain

enum class Axis { x, y, z, first_tangent, second_tangent, u, v };

/// A point with its parameters, if the formula uses them.
struct Place {
    Vec3 x, uv;
};

bool is_parameter(Axis axis) { return axis == Axis::u || axis == Axis::v; }
bool is_tangent(Axis axis) { return axis == Axis::first_tangent || axis == Axis::second_tangent; }

/// A unit tangent of the sphere at x.
Vec3 tangent(Axis axis, Vec3 x) {
    const Vec3 unit = (1 / norm(x)) * x, first = any_across(unit);
    return axis == Axis::first_tangent ? first : cross(unit, first);
}

double& coordinate(Axis axis, Place& place) {
    switch (axis) {
    case Axis::x:
        return place.x.x;
    case Axis::y:
        return place.x.y;
    case Axis::z:
        return place.x.z;
    case Axis::u:
        return place.uv.x;
    default:
        return place.uv.y;
    }
}

/// Moves a place along an axis, on a sphere by an angle. Returns its new coordinate, rounded as it is.
double move(Axis axis, Place& place, double length) {
    if (is_tangent(axis)) {
        place.x = std::cos(length) * place.x + (std::sin(length) * norm(place.x)) * tangent(axis, place.x);
        return length;
    }
    return coordinate(axis, place) += length;
}

/// Points spread over a space whose domain is not known.
Points default_sample(const Space& space) {
    Points sample(most_samples);
    for (std::size_t i = 0; i < most_samples; ++i) {
        const double u = (static_cast<double>(i) + 0.5) / most_samples;
        const double turn = static_cast<double>(i) * std::numbers::phi, v = turn - std::floor(turn);
        sample.set(i, space.kind == SpaceKind::sphere
                          ? at_latitude_longitude(std::asin(2 * u - 1) * 180 / std::numbers::pi, 360 * v)
                          : Vec3{u, v, 0});
    }
    return sample;
}

/// At most most_samples of the points.
Points thinned(const Points& points) {
    const std::size_t stride = (points.size() + most_samples - 1) / most_samples;
    Points some((points.size() + stride - 1) / stride);
    for (std::size_t i = 0; i < some.size(); ++i) some.set(i, points[i * stride]);
    return some;
}

/// The vector w in the plane of a and b with w.a = first and w.b = second; 0 where a and b are parallel.
Vec3 from_slopes(Vec3 a, Vec3 b, double first, double second) {
    const double aa = dot(a, a), ab = dot(a, b), bb = dot(b, b), area = aa * bb - ab * ab;
    if (!(area > 1e-24 * aa * bb)) return {};
    return ((bb * first - ab * second) / area) * a + ((aa * second - ab * first) / area) * b;
}

class TypedFunction final : public FormulaFunction {
  public:
    TypedFunction(ExpressionFunction function, FormulaOptions options)
        : function_(std::move(function)), options_(std::move(options)),
          sample_(options_.sample.size() > 0 ? thinned(options_.sample) : default_sample(options_.space)) {
        const Expression& expression = function_.expression();
        if (options_.space.kind == SpaceKind::sphere) {
            axes_ = {Axis::first_tangent, Axis::second_tangent};
            return;
        }
        if (expression.uses_plane()) axes_ = {Axis::x, Axis::y};
        if (expression.uses_z() && options_.space.dimension == 3) axes_.push_back(Axis::z);
        if (expression.uses_parameters()) axes_.insert(axes_.end(), {Axis::u, Axis::v});
    }

    void values(const Points& x, std::span<double> values) const override {
        const Points uv = parameters_of(x);
        if (options_.space.kind != SpaceKind::periodic_square) return function_.values(x, uv, values);
        Points images(x.size());
        for (std::size_t i = 0; i < x.size(); ++i) images.set(i, image(x[i]));
        function_.values(images, uv, values);
    }

    void gradients(const Points& x, Points& gradients) const override {
        gradients = Points(x.size());
        std::call_once(steps_chosen_, [this] { choose_steps(); });
        const Points uv = parameters_of(x);
        std::vector<double> slopes(x.size());
        Points first, second;
        if (uv.size() > 0) options_.patch->tangents(uv, first, second);
        std::vector<double> slope_u;
        for (const Axis axis : axes_) {
            differentiate(axis, is_parameter(axis) ? parameter_step_ : step_, x, uv, slopes);
            for (std::size_t i = 0; i < x.size(); ++i) {
                const double s = slopes[i];
                if (is_tangent(axis)) gradients.set(i, gradients[i] + (s / norm(x[i])) * tangent(axis, x[i]));
                if (axis == Axis::x) gradients.x[i] += s;
                if (axis == Axis::y) gradients.y[i] += s;
                if (axis == Axis::z) gradients.z[i] += s;
                if (axis == Axis::v)
                    gradients.set(i, gradients[i] + from_slopes(first[i], second[i], slope_u[i], s));
            }
            if (axis == Axis::u) slope_u = slopes;
        }
    }

    FormulaJump jump() const override {
        FormulaJump jump;
        if (options_.space.kind != SpaceKind::periodic_square) return jump;
        constexpr std::size_t count = 256;
        Points low(2 * count), high(2 * count);
        const Vec3 corner = options_.centre - Vec3{0.5, 0.5, 0};
        for (std::size_t i = 0; i < count; ++i) {
            const double s = (static_cast<double>(i) + 0.5) / count;
            low.set(i, corner + Vec3{0, s, 0}), high.set(i, corner + Vec3{1, s, 0});
            low.set(count + i, corner + Vec3{s, 0, 0}), high.set(count + i, corner + Vec3{s, 1, 0});
        }
        std::vector<double> below(low.size()), above(low.size());
        function_.values(low, {}, below);
        function_.values(high, {}, above);
        double largest = 0, difference = 0;
        for (std::size_t i = 0; i < low.size(); ++i) {
            const double size = std::max(std::abs(below[i]), std::abs(above[i]));
            if (!std::isfinite(size)) continue;
            largest = std::max(largest, size);
            if (std::abs(above[i] - below[i]) > difference)
                difference = std::abs(above[i] - below[i]), jump.at = low[i];
        }
        if (difference > 0) jump.relative = difference / largest;
        return jump;
    }

  private:
    Vec3 image(Vec3 x) const {
        const Vec3 centre = options_.centre;
        return {x.x - std::floor(x.x - centre.x + 0.5), x.y - std::floor(x.y - centre.y + 0.5), x.z};
    }

    Points parameters_of(const Points& x) const {
        Points uv;
        if (function_.expression().uses_parameters()) options_.patch->find(x, uv);
        return uv;
    }

    Place place_of(const Points& x, const Points& uv, std::size_t i) const {
        return {options_.space.kind == SpaceKind::periodic_square ? image(x[i]) : x[i],
                uv.size() > 0 ? uv[i] : Vec3{}};
    }

    /// df/ds at every point, of order 4. Differences never cross a jump at the sides of the periodic square:
    /// the formula is continued beyond them.
    void differentiate(Axis axis, double step, const Points& x, const Points& uv,
                       std::span<double> slopes) const {
        constexpr std::array<double, 4> lengths = {1, -1, 2, -2};
        std::array<std::array<double, lengths.size()>, block> places;
        Points moved, moved_uv;
        std::vector<double> f;
        for (std::size_t begin = 0; begin < x.size(); begin += block) {
            const std::size_t count = std::min(block, x.size() - begin);
            moved.resize(lengths.size() * count);
            moved_uv.resize(uv.size() > 0 ? moved.size() : 0);
            f.resize(moved.size());
            for (std::size_t i = 0; i < count; ++i)
                for (std::size_t k = 0; k < lengths.size(); ++k) {
                    Place place = place_of(x, uv, begin + i);
                    places[i][k] = move(axis, place, lengths[k] * step);
                    moved.set(lengths.size() * i + k, place.x);
                    if (uv.size() > 0) moved_uv.set(lengths.size() * i + k, place.uv);
                }
            function_.values(moved, moved_uv, f);
            for (std::size_t i = 0; i < count; ++i) {
                const double* v = &f[lengths.size() * i];
                const auto& at = places[i];
                slopes[begin + i] =
                    (4 * (v[0] - v[1]) / (at[0] - at[1]) - (v[2] - v[3]) / (at[2] - at[3])) / 3;
            }
        }
    }

    /// The step along some axes in a domain of size `extent`: a part of the length over which f changes by
    /// its range. Differences of order 4 then have an error of about 1e-12, and one below 1e-8 even if f
    /// changes ten times faster between the sample points. Shorter steps would show the rounding errors of f:
    /// muParser computes (x - a)/b as x/b - a/b.
    double choose_step(const std::vector<Axis>& axes, double extent, const Points& uv) const {
        std::vector<double> slopes(sample_.size()), values(sample_.size());
        double steepest = 0, least = std::numeric_limits<double>::infinity(), largest = -least;
        for (const Axis axis : axes) {
            differentiate(axis, 1e-6 * extent, sample_, uv, slopes);
            for (const double slope : slopes)
                if (std::isfinite(slope)) steepest = std::max(steepest, std::abs(slope));
        }
        this->values(sample_, values);
        for (const double value : values)
            if (std::isfinite(value)) least = std::min(least, value), largest = std::max(largest, value);
        const double range = std::max(0.0, largest - least);
        const double length = steepest > 0 ? range / steepest : extent;
        return part * std::clamp(length, least_length * extent, extent);
    }

    void choose_steps() const {
        std::vector<Axis> positions, parameters;
        for (const Axis axis : axes_) (is_parameter(axis) ? parameters : positions).push_back(axis);
        const bool round = options_.space.kind == SpaceKind::sphere;
        const double size = round ? 1 : longest_side(bounding_box(sample_));
        const Points uv = parameters_of(sample_);
        step_ = choose_step(positions, size > 0 ? size : 1, uv);
        if (!parameters.empty()) parameter_step_ = choose_step(parameters, 1, uv);
    }

    ExpressionFunction function_;
    FormulaOptions options_;
    Points sample_;
    std::vector<Axis> axes_; ///< along which the formula is differentiated
    mutable std::once_flag steps_chosen_;
    mutable double step_ = 0, parameter_step_ = 0;
};

std::vector<double> in_order(const Expression& expression, const std::map<std::string, double>& parameters) {
    const auto& names = expression.parameters();
    std::vector<double> values;
    for (const auto& name : names) {
        const auto found = parameters.find(name);
        if (found == parameters.end())
            throw InputError("the formula's parameter '" + name + "' has no value");
        values.push_back(found->second);
    }
    for (const auto& [name, value] : parameters)
        if (std::find(names.begin(), names.end(), name) == names.end())
            throw InputError("the formula has no parameter '" + name + "'" + did_you_mean(name, names));
    return values;
}

} // namespace

std::shared_ptr<const FormulaFunction> formula_function(const std::string& text, FormulaOptions options) {
    Expression expression(text, options.space);
    if (expression.uses_parameters() && !options.patch)
        throw InputError("a formula in u and v needs the parameters of a patch");
    const auto values = in_order(expression, options.parameters);
    return std::make_shared<TypedFunction>(ExpressionFunction(std::move(expression), values),
                                           std::move(options));
}

} // namespace gaspard

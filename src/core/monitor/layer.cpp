// Densities for boundary layers of width eps / beta at sides of the domain, Hill, Madden (2021):
//
//   layer          (18), (34)   rho = max{ 1, sum_s K beta/eps exp(-beta d_s / (sigma eps)) }
//   two-layers     (27)         rho = 1 + sum_s sum_j K beta/eps_j exp(-beta d_s / (sigma eps_j)),  j = 1, 2
//   layer-tensor   (37)         M = diag(rho_1, rho_2), of the form of "layer": rho_1 for the left and the
// right
//                               side with eps_1(x, y), rho_2 for the lower and the upper one with eps_2(x, y)
//
// d_s is the distance from side s, on an interval x - a and b - x. K = q / (sigma (1 - q)) puts a share of
// about q of the cells into a layer (21).
#include "core/base/error.hpp"
#include "core/base/exponential.hpp"
#include "core/base/short_number.hpp"
#include "core/function/coefficient.hpp"
#include "core/monitor/layer_rows.hpp"
#include "core/monitor/tensor.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace gaspard {

namespace {

/// Where a side is: d = normal . (x - point) is the distance from it.
struct Side {
    Vec3 normal, point;
    double distance(double x, double y) const {
        return std::max(0.0, normal.x * (x - point.x) + normal.y * (y - point.y));
    }
};

struct SideName {
    const char* key;
    const char* label;
    bool horizontal; ///< about so
};
constexpr std::array<SideName, 4> side_names = {{{"bottom", "Lower side", true},
                                                 {"right", "Right side", false},
                                                 {"top", "Upper side", true},
                                                 {"left", "Left side", false}}};

/// Of an interval, or of a quadrilateral: from corner k to the next one. `along_axis`: the distance is
/// measured along the axis that crosses the side.
Side side_of(const Space& space, std::size_t k, bool along_axis) {
    if (space.dimension == 1) {
        const Box ends = space.reach.empty() ? Box{{0, 0, 0}, {1, 0, 0}} : space.reach.front();
        return side_names[k].key == std::string_view("left") ? Side{{1, 0, 0}, ends.low}
                                                             : Side{{-1, 0, 0}, ends.high};
    }
    static const std::vector<Vec3> unit_square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const std::vector<Vec3>& corners = space.corners.empty() ? unit_square : space.corners;
    const Vec3 from = corners[k], along = corners[(k + 1) % 4] - from;
    const double across = std::abs(side_names[k].horizontal ? along.x : along.y), length = norm(along);
    const double scale = along_axis && across > 1e-6 * length ? across : length;
    return {{-along.y / scale, along.x / scale, 0}, from};
}

/// The sides that are switched on.
std::vector<Side> sides_of(const Values& values, const Space& space, bool horizontal, bool upright) {
    const bool along_axis = values.has("distance") && values.text("distance") == "axis";
    std::vector<Side> sides;
    for (std::size_t k = 0; k < side_names.size(); ++k)
        if (side_names[k].horizontal ? horizontal : upright)
            if (values.has(side_names[k].key) && values.boolean(side_names[k].key))
                sides.push_back(side_of(space, k, along_axis));
    return sides;
}

struct Shape {
    double k, beta, sigma;
    double term(double eps, double distance) const {
        return k * beta / eps * exponential(-beta * distance / (sigma * eps));
    }
    /// Adds the terms of a side, for eps at every point.
    void add(const Side& side, const Points& x, std::span<const double> eps, std::span<double> rho) const {
        for (std::size_t i = 0; i < rho.size(); ++i) rho[i] += term(eps[i], side.distance(x.x[i], x.y[i]));
    }
};

Shape shape_of(const Values& values) {
    return {layer_weight_of(values), values.real("beta"), values.real("sigma")};
}

/// The larger of 1 and the sum of the terms of sides and eps, or 1 and their sum.
class LayerDensity final : public Monitor {
  public:
    LayerDensity(const Values& values, const Space& space, std::vector<double> eps, bool sum)
        : shape_(shape_of(values)), sides_(sides_of(values, space, true, true)), eps_(std::move(eps)),
          base_(sum ? 1 : 0) {}

    void values(const Points& x, std::span<double> values) const override {
        std::fill(values.begin(), values.end(), base_);
        for (const Side& side : sides_)
            for (const double eps : eps_)
                for (std::size_t i = 0; i < values.size(); ++i)
                    values[i] += shape_.term(eps, side.distance(x.x[i], x.y[i]));
        for (double& rho : values) rho = std::max(1.0, rho);
    }
    void gradients(const Points& x, Points& gradients) const override {
        gradients = Points(x.size());
        for (std::size_t i = 0; i < x.size(); ++i) {
            double rho = base_;
            Vec3 slope;
            for (const Side& side : sides_)
                for (const double eps : eps_) {
                    const double term = shape_.term(eps, side.distance(x.x[i], x.y[i]));
                    rho += term;
                    slope = slope - (shape_.beta / (shape_.sigma * eps) * term) * side.normal;
                }
            if (rho > 1) gradients.set(i, slope);
        }
    }

  private:
    Shape shape_;
    std::vector<Side> sides_;
    std::vector<double> eps_;
    double base_;
};

/// diag(rho_1, rho_2).
class LayerTensor final : public TensorMonitor {
  public:
    LayerTensor(const Values& values, const Space& space, double eps)
        : shape_(shape_of(values)), upright_(sides_of(values, space, false, true)),
          horizontal_(sides_of(values, space, true, false)), widths_{coefficient(values, "width_x", 2,
                                                                                 {{"eps", eps}}),
                                                                     coefficient(values, "width_y", 2,
                                                                                 {{"eps", eps}})},
          key_(values.section()) {}

    void values(const Points& x, std::span<SymmetricTensor> values) const override {
        std::vector<double> first(x.size()), second(x.size());
        widths_[0](x, first);
        widths_[1](x, second);
        for (std::size_t i = 0; i < values.size(); ++i)
            if (!(first[i] > 0) || !(second[i] > 0))
                throw InputError(key_ + (first[i] > 0 ? ".width_y" : ".width_x") +
                                 " must be positive, but is " + exact_number(std::min(first[i], second[i])) +
                                 " at (" + exact_number(x.x[i]) + ", " + exact_number(x.y[i]) + ")");
        std::vector<double> rho1(x.size()), rho2(x.size());
        for (const Side& side : upright_) shape_.add(side, x, first, rho1);
        for (const Side& side : horizontal_) shape_.add(side, x, second, rho2);
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = {.xx = std::max(1.0, rho1[i]), .yy = std::max(1.0, rho2[i])};
    }
    void check() const override {} // where it is evaluated

  private:
    Shape shape_;
    std::vector<Side> upright_, horizontal_;
    std::array<Coefficient, 2> widths_;
    std::string key_;
};

/// eps and its relatives: of the monitor, or of the problem where they are automatic.
std::vector<double> eps_of(const Values& values, const std::vector<std::string>& keys,
                           const MonitorContext& context) {
    std::vector<double> found;
    for (const std::string& key : keys) {
        auto width = values.real_or_auto(key);
        if (!width) width = layer_width_of(context.pde, key);
        if (!width)
            throw InputError(values.section() + "." + key + " = auto: the problem has no " + key +
                             "; set it to a number");
        found.push_back(*width);
    }
    return found;
}

/// `on`: the sides with a layer by default.
std::vector<ParameterRow> side_rows(const Space& space, const std::vector<std::string>& on) {
    std::vector<ParameterRow> rows;
    for (const char* key : {"left", "right", "bottom", "top"}) {
        const auto name = std::find_if(side_names.begin(), side_names.end(),
                                       [&](const SideName& one) { return one.key == std::string_view(key); });
        if (name->horizontal && space.dimension == 1) continue;
        rows.push_back({.key = key,
                        .label = space.dimension > 1               ? name->label
                                 : key == std::string_view("left") ? "Left end"
                                                                   : "Right end",
                        .kind = ParameterKind::boolean,
                        .default_value = std::find(on.begin(), on.end(), key) != on.end(),
                        .help = "a layer there"});
    }
    if (space.dimension > 1)
        rows.push_back({.key = "distance",
                        .label = "Distance",
                        .kind = ParameterKind::choice,
                        .default_value = std::string("normal"),
                        .choices = {"normal", "axis"},
                        .help = "from a side: across it, or along the axis that crosses it"});
    return rows;
}

std::vector<ParameterRow> rows(std::vector<ParameterRow> all, Value k,
                               const std::vector<ParameterRow>& sides) {
    for (ParameterRow& row : layer_shape_rows()) all.push_back(std::move(row));
    all.push_back({.key = "K",
                   .label = "Weight",
                   .symbol = "K",
                   .kind = ParameterKind::real_or_auto,
                   .minimum = 1e-3,
                   .maximum = 100,
                   .scale = ParameterScale::logarithmic,
                   .default_value = std::move(k),
                   .help = "weight of a layer against the rest; auto: q/(σ(1 - q))"});
    all.insert(all.end(), sides.begin(), sides.end());
    return all;
}

} // namespace

MonitorType layer_monitor_type() {
    return {
        .name = "layer",
        .label = "Layer",
        .help = "cells as in Bakhvalov's meshes, for boundary layers",
        .equation = "ρ = max{1, Σ K β/ε exp(-β d/(σ ε))}, d the distance from a side",
        .spaces = {SpaceKind::euclidean},
        .solids = false,
        .rows =
            [](const Space& space) {
                return rows({layer_width_row("eps", "ε")}, std::string("auto"), side_rows(space, {"left"}));
            },
        .make = [](const Values& values, const MonitorContext& context) -> std::shared_ptr<const Monitor> {
            return std::make_shared<LayerDensity>(values, context.space, eps_of(values, {"eps"}, context),
                                                  false);
        }};
}

MonitorType two_layers_monitor_type() {
    return {
        .name = "two-layers",
        .label = "Two layers",
        .help = "for boundary layers of two widths at the same place",
        .equation = "ρ = 1 + Σ K β/ε₁ exp(-β d/(σ ε₁)) + K β/ε₂ exp(-β d/(σ ε₂))",
        .spaces = {SpaceKind::euclidean},
        .solids = false,
        .rows =
            [](const Space& space) {
                return rows({layer_width_row("eps1", "ε₁"), layer_width_row("eps2", "ε₂")}, 0.1,
                            side_rows(space, {"left", "right"}));
            },
        .make = [](const Values& values, const MonitorContext& context) -> std::shared_ptr<const Monitor> {
            return std::make_shared<LayerDensity>(values, context.space,
                                                  eps_of(values, {"eps1", "eps2"}, context), true);
        }};
}

MonitorType layer_tensor_monitor_type() {
    return {.name = "layer-tensor",
            .label = "Layers, by direction",
            .help = "for boundary layers whose width varies, by directions",
            .equation = "M = diag(ρ₁, ρ₂), ρₖ = max{1, Σ K β/εₖ exp(-β d/(σ εₖ))}",
            .rows =
                [](const Space& space) {
                    const char* help = "width of the layers, a formula in x, y and eps";
                    return rows({layer_width_row("eps", "ε"),
                                 coefficient_row("width_x", "Width in x", "ε₁", "eps", help),
                                 coefficient_row("width_y", "Width in y", "ε₂", "eps", help)},
                                std::string("auto"), side_rows(space, {"right", "top"}));
                },
            .make_tensor = [](const Values& values,
                              const MonitorContext& context) -> std::shared_ptr<const TensorMonitor> {
                return std::make_shared<LayerTensor>(values, context.space,
                                                     eps_of(values, {"eps"}, context).front());
            }};
}

} // namespace gaspard

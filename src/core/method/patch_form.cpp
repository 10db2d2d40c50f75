#include "core/method/patch_form.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace gaspard {

namespace {

constexpr std::size_t shown = 100; // points per direction for the extremes of the Jacobian, as in the paper

/// Standard deviation / mean.
double variation(const std::vector<double>& values) {
    const double count = static_cast<double>(values.size());
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
    double squares = 0;
    for (const double value : values) squares += (value - mean) * (value - mean);
    return std::sqrt(squares / count) / mean;
}

/// The spline phi, transferred from the space `from` to the space `to` in both directions.
std::vector<double> transferred(const KnotVector& from, const KnotVector& to, std::span<const double> phi) {
    const LineMatrix along = transfer(from, to);
    std::vector<double> half(from.size() * to.size(), 0.0), all(to.size() * to.size(), 0.0);
    for (std::size_t j = 0; j < from.size(); ++j)
        for (std::size_t i = 0; i < to.size(); ++i)
            for (std::size_t k = 0; k < from.size(); ++k)
                half[j * to.size() + i] += along(i, k) * phi[j * from.size() + k];
    for (std::size_t j = 0; j < to.size(); ++j)
        for (std::size_t k = 0; k < from.size(); ++k)
            for (std::size_t i = 0; along(j, k) != 0 && i < to.size(); ++i)
                all[j * to.size() + i] += along(j, k) * half[k * to.size() + i];
    return all;
}

} // namespace

std::string spline_layout(const SplineLayout& layout) {
    return std::string("spline ") + (layout.formulation == Formulation::standard ? "standard" : "mixed") +
           " p=" + std::to_string(layout.degree) + " n=" + std::to_string(layout.cells);
}

std::optional<SplineLayout> parse_spline_layout(const std::string& text) {
    constexpr int most_cells = 100000;
    char kind[9] = {};
    int degree = 0, cells = 0;
    if (std::sscanf(text.c_str(), "spline %8s p=%d n=%d", kind, &degree, &cells) != 3) return std::nullopt;
    if (degree < 2 || degree > highest_degree || cells < 1 || cells > most_cells) return std::nullopt;
    const SplineLayout layout{std::string(kind) == "mixed" ? Formulation::mixed : Formulation::standard,
                              degree, static_cast<std::size_t>(cells)};
    if (spline_layout(layout) != text) return std::nullopt; // unknown formulation or trailing text
    return layout;
}

std::unique_ptr<SplineForm> make_form(const SplineLayout& layout) {
    const SplineLine line(uniform_knots(layout.degree, layout.cells));
    const NormalTrace trace = identity_trace(line);
    return layout.formulation == Formulation::standard ? make_standard_form(line, trace)
                                                       : make_mixed_form(line, trace);
}

ParameterRow measure_row() {
    return {.key = "measure",
            .label = "Measure",
            .kind = ParameterKind::choice,
            .default_value = std::string("parameter"),
            .choices = {"parameter", "physical"},
            .help = "what the areas of cells refer to. parameter: the parameter square, as in the paper; "
                    "physical: the patch itself, so that finer meshes are equidistributed on every patch"};
}

Measure measure_of(const Values& method) {
    return method.text("measure") == "physical" ? Measure::physical : Measure::parameter;
}

namespace {

struct PatchMeasure {
    std::string name, label, symbol;
    ParameterScale scale;
    std::string help;
    double PatchMeasures::*value;
};

const std::vector<PatchMeasure>& patch_measures() {
    using enum ParameterScale;
    static const std::vector<PatchMeasure> table = {
        {"err", "Density error", "‖det/f − 1‖", logarithmic,
         "L² norm of det/f − 1, the error in the tables of Bahari et al.", &PatchMeasures::err_printed},
        {"err_absolute", "Density error, absolute", "‖det − f‖", logarithmic, "L² norm of det − f",
         &PatchMeasures::err_defined},
        {"qual", "Displacement cost", "", linear, "root of the integral of |Ψ − ξ|² / |det|",
         &PatchMeasures::qual_det},
        {"qual_f", "Displacement cost over f", "", linear, "root of the integral of |Ψ − ξ|² / f",
         &PatchMeasures::qual_f},
        {"min_jacobian_psi", "Min. Jacobian of Ψ", "min det", linear,
         "smallest Jacobian of Ψ on a grid of 100 × 100 points", &PatchMeasures::min_jacobian},
        {"max_jacobian_psi", "Max. Jacobian of Ψ", "max det", linear,
         "largest Jacobian of Ψ on a grid of 100 × 100 points", &PatchMeasures::max_jacobian},
        {"bound_jacobian_psi", "Bound of the Jacobian of Ψ", "min det", linear,
         "lower bound of the Jacobian of Ψ on the whole square, within 1e-6 of its largest value",
         &PatchMeasures::bound_jacobian},
        {"border_error", "Border error", "|(Ψ − ξ) · n|", logarithmic,
         "largest distance of Ψ from the border on a grid of 100 × 100 points", &PatchMeasures::border_error},
        {"equidistribution_square", "Equidistribution in the parameter square", "", logarithmic,
         "like the equidistribution, but with the areas of the parameter square instead of those in space",
         &PatchMeasures::variation_in_square}};
    return table;
}

} // namespace

std::vector<SeriesInfo> patch_series() {
    std::vector<SeriesInfo> all;
    for (const PatchMeasure& one : patch_measures())
        all.push_back({.name = one.name,
                       .label = one.label,
                       .symbol = one.symbol,
                       .scale = one.scale,
                       .help = one.help,
                       .measured = true,
                       .column = false});
    return all;
}

std::vector<double> values_of(const PatchMeasures& measures) {
    std::vector<double> values;
    for (const PatchMeasure& one : patch_measures()) values.push_back(measures.*one.value);
    return values;
}

PatchForm::PatchForm(std::shared_ptr<const SplineDomain> domain, Formulation formulation, std::size_t cells)
    : domain_(std::move(domain)), formulation_(formulation), cells_(cells),
      form_(make_form({formulation, domain_->degree(), cells})), identity_(form_->identity()),
      nodes_(form_->line(), domain_->node_lines()), workspace_(form_->make_workspace()) {}

void PatchForm::set_measure(Measure measure) {
    if (measure == Measure::parameter || domain_->patch_map()->is_identity())
        areas_.clear(); // of the identity all area elements are 1
    else if (areas_.empty())
        areas_ = area_elements(*domain_->patch_map(), form_->line());
}

void PatchForm::add_identity(std::span<const double> phi, std::span<double> whole) const {
    for (std::size_t i = 0; i < identity_.size(); ++i) whole[i] = phi[i] + identity_[i];
}

std::vector<double> PatchForm::without_identity(std::span<const double> whole) const {
    std::vector<double> phi(whole.begin(), whole.end());
    for (std::size_t i = 0; i < identity_.size(); ++i) phi[i] -= identity_[i];
    return phi;
}

std::vector<double> PatchForm::adopt(const std::string& layout, std::span<const double> phi) const {
    const auto other = parse_spline_layout(layout);
    if (!other) return {};
    KnotVector from = uniform_knots(other->degree, other->cells);
    if (other->formulation == Formulation::mixed) from = derivative_space(from);
    if (phi.size() != from.size() * from.size()) return {};
    if (from == form_->space()) return {phi.begin(), phi.end()};
    return transferred(from, form_->space(), phi);
}

void PatchForm::positions(std::span<const double> whole, Points& x) {
    const std::size_t side = nodes_.points.size();
    psi_.resize(side * side);
    form_->expand(whole, SplineForm::Border::given, nodes_, 2, workspace_);
    for (std::size_t j = 0; j < side; ++j)
        form_->row(nodes_, j, 2, {&psi_.x[j * side], &psi_.y[j * side], nullptr, nullptr, nullptr},
                   workspace_);
    if (formulation_ == Formulation::mixed) // removes rounding errors
        for (std::size_t k = 0; k < side; ++k) {
            psi_.x[k * side] = psi_.y[k] = 0;
            psi_.x[k * side + side - 1] = psi_.y[(side - 1) * side + k] = 1;
        }
    // Beyond an edge that is one point, F has the opposite orientation. The penalty of the standard form lets
    // the map pass such an edge, or end before it, by its error at the boundary: the edge is put on its
    // point.
    const PointEdges& tips = domain_->point_edges();
    for (std::size_t k = 0; k < side; ++k) {
        if (tips.left) psi_.x[k * side] = 0;
        if (tips.right) psi_.x[k * side + side - 1] = 1;
        if (tips.bottom) psi_.y[k] = 0;
        if (tips.top) psi_.y[(side - 1) * side + k] = 1;
    }
    for (std::size_t i = 0; i < psi_.size(); ++i) {
        psi_.x[i] = std::clamp(psi_.x[i], tips.left ? 0 : psi_.x[i], tips.right ? 1 : psi_.x[i]);
        psi_.y[i] = std::clamp(psi_.y[i], tips.bottom ? 0 : psi_.y[i], tips.top ? 1 : psi_.y[i]);
    }
    domain_->patch_map()->points(psi_, x);
}

const JacobianBounds& PatchForm::jacobian(std::span<const double> whole) {
    if (!std::equal(whole.begin(), whole.end(), whole_of_jacobian_.begin(), whole_of_jacobian_.end())) {
        jacobian_ = bound_jacobian(form_->map(whole), domain_->cells());
        whole_of_jacobian_.assign(whole.begin(), whole.end());
    }
    return jacobian_;
}

PatchMeasures PatchForm::measure(const Monitor& monitor, std::span<const double> whole) {
    PatchMeasures result;
    result.bound_jacobian = jacobian(whole).bound;
    integrate(monitor, whole, result);
    find_extremes(whole, result);
    return result;
}

void PatchForm::integrate(const Monitor& monitor, std::span<const double> whole, PatchMeasures& result) {
    const PatchSource of_patch = source(monitor);
    const SplineLine& line = form_->line();
    const std::size_t n = line.points.size();
    const std::size_t per_cell = n / cells_; // points
    std::vector<double> xx(n), xy(n), yy(n), f(n), rho(n), mass(cells_ * cells_, 0.0);
    psi_.resize(n);
    form_->expand(whole, SplineForm::Border::given, form_->quadrature(), map_fields, workspace_);
    for (std::size_t j = 0; j < n; ++j) {
        form_->row(form_->quadrature(), j, map_fields,
                   {psi_.x.data(), psi_.y.data(), xx.data(), xy.data(), yy.data()}, workspace_);
        of_patch.values(j, psi_, f);
        of_patch.monitor_values(f, rho);
        for (std::size_t i = 0; i < n; ++i) {
            const double weight = line.weights[i] * line.weights[j];
            const double det = xx[i] * yy[i] - xy[i] * xy[i];
            const double dx = psi_.x[i] - line.points[i], dy = psi_.y[i] - line.points[j];
            const double far = dx * dx + dy * dy;
            result.err_printed += weight * (det / f[i] - 1) * (det / f[i] - 1);
            result.err_defined += weight * (det - f[i]) * (det - f[i]);
            result.qual_det += weight * far / std::abs(det);
            result.qual_f += weight * far / f[i];
            mass[j / per_cell * cells_ + i / per_cell] += weight * rho[i] * det;
        }
    }
    for (double* square : {&result.err_printed, &result.err_defined, &result.qual_det, &result.qual_f})
        *square = std::sqrt(*square);
    result.variation_in_square = variation(mass);
}

void PatchForm::find_extremes(std::span<const double> whole, PatchMeasures& result) {
    const SplineLine& line = form_->line();
    std::vector<double> at(shown);
    for (std::size_t i = 0; i < shown; ++i) at[i] = static_cast<double>(i) / (shown - 1);
    const SplineGrid grid(line, at);
    result.min_jacobian = 1e300, result.max_jacobian = -1e300;
    std::vector<double> xx(shown), xy(shown), yy(shown);
    psi_.resize(shown);
    form_->expand(whole, SplineForm::Border::given, grid, map_fields, workspace_);
    for (std::size_t j = 0; j < shown; ++j) {
        form_->row(grid, j, map_fields, {psi_.x.data(), psi_.y.data(), xx.data(), xy.data(), yy.data()},
                   workspace_);
        const auto note = [&](double error) {
            result.border_error = std::max(result.border_error, std::abs(error));
        };
        note(psi_.x[0]);
        note(psi_.x[shown - 1] - 1);
        for (std::size_t i = 0; i < shown; ++i) {
            if (j == 0) note(psi_.y[i]);
            if (j == shown - 1) note(psi_.y[i] - 1);
            if (i == 0 || j == 0 || i == shown - 1 || j == shown - 1) continue;
            const double det = xx[i] * yy[i] - xy[i] * xy[i];
            result.min_jacobian = std::min(result.min_jacobian, det);
            result.max_jacobian = std::max(result.max_jacobian, det);
        }
    }
}

} // namespace gaspard

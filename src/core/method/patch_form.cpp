#include "core/method/patch_form.hpp"

#include "core/base/check.hpp"
#include "core/base/symmetric.hpp"
#include "core/spline/solid_folds.hpp"

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

/// The spline phi, transferred from the space `from` to the space `to` in all directions.
template <std::size_t D>
std::vector<double> transferred(const KnotVector& from, const KnotVector& to, std::span<const double> phi) {
    const LineMatrix along = transfer(from, to);
    std::vector<double> now(phi.begin(), phi.end()), next;
    std::size_t before = 1, after = tensor_size<D - 1>(from.size()); // sizes of the directions around
    for (std::size_t d = 0; d < D; ++d) {
        next.assign(before * to.size() * after, 0.0);
        for (std::size_t slow = 0; slow < after; ++slow)
            for (std::size_t i = 0; i < to.size(); ++i)
                for (std::size_t k = 0; k < from.size(); ++k) {
                    if (along(i, k) == 0) continue;
                    for (std::size_t fast = 0; fast < before; ++fast)
                        next[(slow * to.size() + i) * before + fast] +=
                            along(i, k) * now[(slow * from.size() + k) * before + fast];
                }
        now.swap(next);
        before *= to.size();
        after /= from.size();
    }
    return now;
}

} // namespace

std::string spline_layout(const SplineLayout& layout) {
    return std::string(layout.dimension == 3 ? "solid " : "spline ") +
           (layout.formulation == Formulation::standard ? "standard" : "mixed") +
           " p=" + std::to_string(layout.degree) + " n=" + std::to_string(layout.cells);
}

std::optional<SplineLayout> parse_spline_layout(const std::string& text) {
    constexpr int most_cells = 100000;
    char what[7] = {}, kind[9] = {};
    int degree = 0, cells = 0;
    if (std::sscanf(text.c_str(), "%6s %8s p=%d n=%d", what, kind, &degree, &cells) != 4) return std::nullopt;
    if (degree < 2 || degree > highest_degree || cells < 1 || cells > most_cells) return std::nullopt;
    const SplineLayout layout{std::string(kind) == "mixed" ? Formulation::mixed : Formulation::standard,
                              degree, static_cast<std::size_t>(cells),
                              std::string(what) == "solid" ? std::size_t{3} : std::size_t{2}};
    if (spline_layout(layout) != text) return std::nullopt; // unknown words or trailing text
    return layout;
}

template <std::size_t D>
std::unique_ptr<TensorForm<D>> make_form(const SplineLayout& layout) {
    const SplineLine line(uniform_knots(layout.degree, layout.cells));
    const FaceTrace<D> trace = identity_trace<D>(line);
    return layout.formulation == Formulation::standard ? make_standard_form<D>(line, trace)
                                                       : make_mixed_form<D>(line, trace);
}

ParameterRow measure_row() {
    return {.key = "measure",
            .label = "Measure",
            .kind = ParameterKind::choice,
            .default_value = std::string("parameter"),
            .choices = {"parameter", "physical"},
            .help = "what the sizes of cells refer to. parameter: the parameter square or cube, as in the "
                    "paper; physical: the patch itself, so that finer meshes are equidistributed on every "
                    "patch"};
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
    bool patch = true, solid = true; ///< where it is measured
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
         "smallest Jacobian of Ψ on a grid of 100 points per direction", &PatchMeasures::min_jacobian},
        {"max_jacobian_psi", "Max. Jacobian of Ψ", "max det", linear,
         "largest Jacobian of Ψ on a grid of 100 points per direction", &PatchMeasures::max_jacobian},
        {"bound_jacobian_psi", "Bound of the Jacobian of Ψ", "min det", linear,
         "lower bound of the Jacobian of Ψ on the whole square, within 1e-6 of its largest value",
         &PatchMeasures::bound_jacobian, true, false},
        {"border_error", "Border error", "|(Ψ − ξ) · n|", logarithmic,
         "largest distance of Ψ from the border on a grid of 100 points per direction",
         &PatchMeasures::border_error},
        {"equidistribution_square", "Equidistribution in the parameter square", "", logarithmic,
         "like the equidistribution, but with the areas of the parameter square instead of those in space",
         &PatchMeasures::variation_in_square, true, false},
        {"equidistribution_cube", "Equidistribution in the parameter cube", "", logarithmic,
         "like the equidistribution, but with the volumes of the parameter cube instead of those in space",
         &PatchMeasures::variation_in_square, false, true},
        {"err_last_layer", "Density error, last layer", "", logarithmic,
         "the density error over the last layer of cells alone, as in tables 16 to 19 of Bahari et al.",
         &PatchMeasures::err_last_layer, false, true},
        {"qual_last_layer", "Displacement cost, last layer", "", linear,
         "the displacement cost over the last layer of cells alone, likewise",
         &PatchMeasures::qual_last_layer, false, true}};
    return table;
}

} // namespace

std::vector<SeriesInfo> patch_series(std::size_t dimension) {
    std::vector<SeriesInfo> all;
    for (const PatchMeasure& one : patch_measures())
        if (dimension == 2 ? one.patch : one.solid)
            all.push_back({.name = one.name,
                           .label = one.label,
                           .symbol = one.symbol,
                           .scale = one.scale,
                           .help = one.help,
                           .measured = true,
                           .column = false});
    return all;
}

std::vector<double> values_of(const PatchMeasures& measures, std::size_t dimension) {
    std::vector<double> values;
    for (const PatchMeasure& one : patch_measures())
        if (dimension == 2 ? one.patch : one.solid) values.push_back(measures.*one.value);
    return values;
}

template <std::size_t D>
MappedForm<D>::MappedForm(std::shared_ptr<const TensorDomain<D>> domain, Formulation formulation,
                          std::size_t cells)
    : domain_(std::move(domain)), formulation_(formulation), cells_(cells),
      form_(make_form<D>({formulation, domain_->degree(), cells, D})), identity_(form_->identity()),
      nodes_(form_->line(), domain_->node_lines()), workspace_(form_->make_workspace()) {}

template <std::size_t D>
void MappedForm<D>::set_measure(Measure measure) {
    if (measure == Measure::parameter || domain_->map()->is_identity())
        elements_.clear(); // of the identity all are 1
    else if (elements_.empty())
        elements_ = elements_of(*domain_->map(), form_->line());
}

template <std::size_t D>
void MappedForm<D>::add_identity(std::span<const double> phi, std::span<double> whole) const {
    for (std::size_t i = 0; i < identity_.size(); ++i) whole[i] = phi[i] + identity_[i];
}

template <std::size_t D>
std::vector<double> MappedForm<D>::without_identity(std::span<const double> whole) const {
    std::vector<double> phi(whole.begin(), whole.end());
    for (std::size_t i = 0; i < identity_.size(); ++i) phi[i] -= identity_[i];
    return phi;
}

template <std::size_t D>
std::vector<double> MappedForm<D>::adopt(const std::string& layout, std::span<const double> phi) const {
    const auto other = parse_spline_layout(layout);
    if (!other || other->dimension != D) return {};
    KnotVector from = uniform_knots(other->degree, other->cells);
    if (other->formulation == Formulation::mixed) from = derivative_space(from);
    if (phi.size() != tensor_size<D>(from.size())) return {};
    if (from == form_->space()) return {phi.begin(), phi.end()};
    return transferred<D>(from, form_->space(), phi);
}

namespace {

/// One coordinate of points.
std::vector<double>& coordinate(Points& points, std::size_t d) {
    return d == 0 ? points.x : d == 1 ? points.y : points.z;
}

/// Where TensorForm::row() writes Psi, from point `first` on; the other fields are not wanted.
template <std::size_t D>
typename TensorForm<D>::Fields map_at(Points& psi, std::size_t first) {
    typename TensorForm<D>::Fields fields{};
    for (std::size_t d = 0; d < D; ++d) fields[d] = &coordinate(psi, d)[first];
    return fields;
}

/// The upper triangle of grad Psi at the points of a slab.
template <std::size_t D>
struct Gradients {
    std::array<std::vector<double>, D*(D + 1) / 2> entries;

    explicit Gradients(std::size_t points) { entries.fill(std::vector<double>(points)); }
    /// Psi and its gradient.
    typename TensorForm<D>::Fields with(Points& psi) {
        auto fields = map_at<D>(psi, 0);
        for (std::size_t e = 0; e < entries.size(); ++e) fields[D + e] = entries[e].data();
        return fields;
    }
    double determinant(std::size_t i) const {
        Symmetric<D> h;
        for (std::size_t e = 0; e < entries.size(); ++e) h[e] = entries[e][i];
        return gaspard::determinant(h);
    }
};

} // namespace

template <std::size_t D>
void MappedForm<D>::positions(std::span<const double> whole, Points& x) {
    const std::size_t side = nodes_.points.size(), slab = tensor_size<D - 1>(side);
    psi_.resize(side * slab); // in the plane z stays zero
    form_->expand(whole, Form::Border::given, nodes_, D, workspace_);
    for (std::size_t s = 0; s < side; ++s) form_->row(nodes_, s, D, map_at<D>(psi_, s * slab), workspace_);
    keep_sides();
    domain_->map()->points(psi_, x);
}

// Beyond a collapsed side, F has the opposite orientation. The penalty of the standard form lets the map pass
// such a side, or end before it, by its error at the boundary: the side is put on its place. In the mixed
// form this only removes rounding errors.
template <std::size_t D>
void MappedForm<D>::keep_sides() {
    const std::size_t side = nodes_.points.size();
    const auto& [low, high] = domain_->collapsed();
    const bool exact = formulation_ == Formulation::mixed;
    for (std::size_t d = 0, step = 1; d < D; ++d, step *= side) {
        std::vector<double>& psi = coordinate(psi_, d);
        for (std::size_t i = 0; i < psi.size(); ++i) {
            const std::size_t at = i / step % side;
            if (at == 0 && (exact || low[d])) psi[i] = 0;
            if (at == side - 1 && (exact || high[d])) psi[i] = 1;
            if (low[d] && psi[i] < 0) psi[i] = 0;
            if (high[d] && psi[i] > 1) psi[i] = 1;
        }
    }
}

template <std::size_t D>
const JacobianBounds& MappedForm<D>::jacobian(std::span<const double> whole) requires(D == 2) {
    if (!std::equal(whole.begin(), whole.end(), whole_of_jacobian_.begin(), whole_of_jacobian_.end())) {
        jacobian_ = bound_jacobian(form_->map(whole), domain_->cells());
        whole_of_jacobian_.assign(whole.begin(), whole.end());
    }
    return jacobian_;
}

template <std::size_t D>
std::vector<std::uint32_t> MappedForm<D>::folded_cells(std::span<const double> whole) {
    if constexpr (D == 2) return jacobian(whole).folded;
    return folded_solid_cells(form_->map(whole), domain_->cells());
}

template <std::size_t D>
PatchMeasures MappedForm<D>::measure(const Monitor& monitor, std::span<const double> whole) {
    PatchMeasures result;
    if constexpr (D == 2) result.bound_jacobian = jacobian(whole).bound;
    integrate(monitor, whole, result);
    find_extremes(whole, result);
    return result;
}

template <std::size_t D>
void MappedForm<D>::integrate(const Monitor& monitor, std::span<const double> whole, PatchMeasures& result) {
    const TensorSource<D> of_patch = source(monitor);
    const SplineLine& line = form_->line();
    const std::size_t n = line.points.size(), slab = form_->slab();
    const std::size_t per_cell = n / cells_; // points
    std::vector<double> f(slab), rho(slab), mass(tensor_size<D>(cells_), 0.0);
    Gradients<D> gradients(slab);
    psi_.resize(slab);
    form_->expand(whole, Form::Border::given, form_->quadrature(), Form::fields, workspace_);
    for_each_slab<D>(line, [&](std::size_t s, const Points& xi, std::span<const double> weights) {
        form_->row(form_->quadrature(), s, Form::fields, gradients.with(psi_), workspace_);
        of_patch.values(s, psi_, f, rho);
        const bool last_layer = s >= n - per_cell;
        for (std::size_t i = 0; i < slab; ++i) {
            const double weight = weights[i] * line.weights[s], det = gradients.determinant(i);
            const Vec3 way = psi_[i] - xi[i];
            const double far = dot(way, way), relative = weight * (det / f[i] - 1) * (det / f[i] - 1);
            result.err_printed += relative;
            result.err_defined += weight * (det - f[i]) * (det - f[i]);
            result.qual_det += weight * far / std::abs(det);
            result.qual_f += weight * far / f[i];
            if (last_layer) {
                result.err_last_layer += relative;
                result.qual_last_layer += weight * far / std::abs(det);
            }
            std::size_t cell = s / per_cell * cells_ + i / tensor_size<D - 2>(n) / per_cell;
            if constexpr (D == 3) cell = cell * cells_ + i % n / per_cell;
            mass[cell] += weight * rho[i] * det;
        }
    });
    for (double* square : {&result.err_printed, &result.err_defined, &result.qual_det, &result.qual_f,
                           &result.err_last_layer, &result.qual_last_layer})
        *square = std::sqrt(*square);
    result.variation_in_square = variation(mass);
}

template <std::size_t D>
void MappedForm<D>::find_extremes(std::span<const double> whole, PatchMeasures& result) {
    const SplineLine& line = form_->line();
    std::vector<double> at(shown);
    for (std::size_t i = 0; i < shown; ++i) at[i] = static_cast<double>(i) / (shown - 1);
    const SplineGrid grid(line, at);
    constexpr std::size_t slab = tensor_size<D - 1>(shown);
    result.min_jacobian = 1e300, result.max_jacobian = -1e300;
    Gradients<D> gradients(slab);
    psi_.resize(slab);
    form_->expand(whole, Form::Border::given, grid, Form::fields, workspace_);
    for (std::size_t s = 0; s < shown; ++s) {
        form_->row(grid, s, Form::fields, gradients.with(psi_), workspace_);
        for (std::size_t i = 0; i < slab; ++i) {
            bool inside = true;
            for (std::size_t d = 0, rest = i; d < D; ++d, rest /= shown) {
                const std::size_t index = d == D - 1 ? s : rest % shown;
                if (index != 0 && index != shown - 1) continue;
                inside = false;
                const double side = index == 0 ? 0 : 1;
                result.border_error = std::max(result.border_error, std::abs(coordinate(psi_, d)[i] - side));
            }
            if (!inside) continue;
            const double det = gradients.determinant(i);
            result.min_jacobian = std::min(result.min_jacobian, det);
            result.max_jacobian = std::max(result.max_jacobian, det);
        }
    }
}

template class MappedForm<2>;
template class MappedForm<3>;
template std::unique_ptr<TensorForm<2>> make_form<2>(const SplineLayout& layout);
template std::unique_ptr<TensorForm<3>> make_form<3>(const SplineLayout& layout);

} // namespace gaspard

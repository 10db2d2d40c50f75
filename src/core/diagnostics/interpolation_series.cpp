// What is reported of interpolation errors: names, comparisons, series.
#include "core/base/check.hpp"
#include "core/diagnostics/interpolation_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace gaspard {

namespace {

struct NormText {
    std::string_view name, label;
};
constexpr std::array<NormText, 3> norm_texts{{{"l2", "L2"}, {"maximum", "maximum"}, {"h1", "H1"}}};

double quotient(double uniform, double adapted) {
    if (uniform == adapted) return 1; // also 0 / 0
    return adapted == 0 ? std::numeric_limits<double>::quiet_NaN() : uniform / adapted;
}

} // namespace

std::string_view norm_name(ErrorNorm norm) { return norm_texts[static_cast<std::size_t>(norm)].name; }
std::string_view norm_label(ErrorNorm norm) { return norm_texts[static_cast<std::size_t>(norm)].label; }

double InterpolationComparison::ratio(ErrorNorm which) const {
    GASPARD_CHECK(uniform && adapted);
    return quotient(uniform->of(which), adapted->of(which));
}

std::vector<double> InterpolationComparison::cell_ratios(ErrorNorm which) const {
    const auto &before = uniform->of_cells(which), &after = adapted->of_cells(which);
    const double least = 1e-12 * range(which).second;
    std::vector<double> ratios(before.size());
    std::transform(before.begin(), before.end(), after.begin(), ratios.begin(),
                   [&](double one, double other) {
                       return least > 0 ? std::max(one, least) / std::max(other, least) : 1.0;
                   });
    return ratios;
}

std::pair<double, double> InterpolationComparison::range(ErrorNorm which) const {
    double low = std::numeric_limits<double>::infinity(), high = 0;
    for (const auto* of : {uniform.get(), adapted.get()})
        for (const double value : of->of_cells(which))
            if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
    return {std::min(low, high), high};
}

std::vector<SeriesInfo> interpolation_series() {
    std::vector<SeriesInfo> all;
    for (const bool uniform : {false, true})
        for (const NormText& norm : norm_texts) {
            const std::string mesh = uniform ? "uniform" : "adapted";
            std::string label = std::string(norm.label) + " error";
            label.front() = norm.name == "maximum" ? 'M' : label.front();
            all.push_back({.name = std::string(norm.name) + "_error" + (uniform ? "_uniform" : ""),
                           .label = label + ", " + mesh + " mesh",
                           .scale = ParameterScale::logarithmic,
                           .help = "of interpolating u (or the monitor) on the " + mesh + " mesh",
                           .plot = SharedPlot{std::string(norm.name) + "_error", label, mesh},
                           .measured = true,
                           .column = false});
        }
    return all;
}

SeriesValues values_of(const InterpolationComparison& comparison) {
    SeriesValues values;
    for (const auto* of : {comparison.adapted.get(), comparison.uniform.get()})
        for (const double norm : of->norm) values.push_back(norm);
    return values;
}

} // namespace gaspard

#include "core/monitor/stages.hpp"

#include "core/base/check.hpp"
#include "core/function/chart_extent.hpp"
#include "core/function/grid_function.hpp"
#include "core/function/smoothing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace gaspard {

namespace {

constexpr std::array lengths{0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0}; ///< in cells

double fourth_power(double x) { return x * x * x * x; }

/// The part of the domain within the smoothing's reach of a grid point; 1 inside of it.
std::vector<double> covered(const DomainGrid& domain, double length, const DataContext& context) {
    std::vector<double> cover(domain.measures.size());
    for (std::size_t i = 0; i < cover.size(); ++i) cover[i] = domain.measures[i] > 0 ? 1 : 0;
    for (int pass = 0; pass < 2; ++pass)
        helmholtz_filter(domain.grid, cover, length, context.progress, context.stop);
    return cover;
}

} // namespace

void average_stage(const DomainGrid& domain, std::span<double> values, double fraction) {
    GASPARD_CHECK(fraction >= 0 && fraction < 1);
    const double average = domain.mean(values);
    const double factor = average > 0 ? fraction / (1 - fraction) / average : 0;
    for (double& value : values) value = 1 + factor * value;
}

void limit_stage(const DomainGrid& domain, std::span<double> values, double floor, double contrast) {
    const double low = floor * domain.mean(values);
    for (double& value : values) {
        const double larger = std::max(value, low), ratio = std::min(value, low) / larger;
        value = larger > 0 ? larger * std::pow(1 + fourth_power(ratio), 0.25) : 0;
    }
    const double high = contrast * domain.least(values);
    if (!(high > 0)) return;
    for (double& value : values) {
        const double smaller = std::min(value, high), ratio = smaller / std::max(value, high);
        value = smaller * std::pow(1 + fourth_power(ratio), -0.25);
    }
    // The least value has become smaller, too.
    const double least = domain.least(values);
    for (double& value : values) value = std::min(value, contrast * least);
}

void smoothing_stage(const DomainGrid& domain, std::span<double> values, double length,
                     const DataContext& context) {
    if (length == 0) return;
    const double each = length / std::sqrt(2.0), before = domain.mean(values);
    const double least = domain.least(values);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = !domain.patch || domain.measures[i] > 0 ? values[i] - least : 0;
    for (int pass = 0; pass < 2; ++pass)
        helmholtz_filter(domain.grid, values, each, context.progress, context.stop);
    if (domain.patch) { // what lies beside the patch does not count
        constexpr double far = 1e-6;
        const auto cover = covered(domain, each, context);
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = values[i] / std::max(cover[i], far);
    }
    const double after = domain.mean(values), factor = after > 0 ? (before - least) / after : 1;
    for (double& value : values) value = least + factor * std::max(value, 0.0);
}

double steepness(const DomainGrid& domain, std::span<const double> values) {
    std::vector<double> logs(values.size());
    for (std::size_t i = 0; i < logs.size(); ++i) logs[i] = std::log(values[i]);
    Points slopes;
    GridFunction(domain.grid, logs).gradients(domain.x, slopes);
    const double average = domain.mean(values), power = 1 / static_cast<double>(domain.dimension());
    double steepest_one = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (domain.measures[i] > 0)
            steepest_one = std::max(steepest_one, std::pow(average / values[i], power) * norm(slopes[i]));
    return domain.cell * steepest_one;
}

double steepest(const DomainGrid& domain, double on_square) {
    const bool square = domain.grid.chart->kind() == ChartKind::box && domain.dimension() == 2;
    return square && !domain.patch ? on_square : 0.5;
}

Followed follow(const DomainGrid& domain, std::vector<double> values, std::optional<double> length,
                const DataContext& context) {
    const auto is_even = [&](const std::vector<double>& m) {
        return steepness(domain, m) <= steepest(domain, steepest_stages);
    };
    Followed made{std::move(values), length.value_or(0), {}};
    if (length && *length > 0) smoothing_stage(domain, made.values, *length * domain.cell, context);
    if (is_even(made.values)) return made;
    double needed = 0;
    bool enough = false;
    std::vector<double> smoother;
    for (const double longer : lengths) {
        if (enough || longer <= made.length) continue;
        smoother = made.values;
        const double further = std::sqrt(longer * longer - made.length * made.length); // variances add up
        smoothing_stage(domain, smoother, further * domain.cell, context);
        needed = longer, enough = is_even(smoother);
    }
    const std::string more_cells = "more cells, or a smaller contrast, would help.";
    if (length) {
        std::string note = "The mesh may not follow the monitor";
        if (*length > 0) note += ", which is smoothed over " + in_cells(*length);
        note += enough ? ": it needs a smoothing over " + in_cells(needed) + " (smoothing = \"auto\")."
                       : ": " + more_cells;
        made.notes.push_back(std::move(note));
        return made;
    }
    made.values = std::move(smoother), made.length = needed;
    std::string note = "The monitor is smoothed over " + in_cells(needed) + " of the uniform mesh";
    note += enough ? ", so that the mesh can follow it."
                   : ", and the mesh may not follow it even so: " + more_cells;
    made.notes.push_back(std::move(note));
    return made;
}

} // namespace gaspard

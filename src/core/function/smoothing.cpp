#include "core/function/smoothing.hpp"

#include "core/base/check.hpp"
#include "core/function/spectral_box.hpp"
#include "core/function/surface_filter.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace gaspard {

namespace {

/// `steps` Helmholtz filters of this length on the sphere or a surface.
void filter_surface(const Grid& grid, std::span<double> values, double length, int steps,
                    const Progress& progress, const std::stop_token& stop) {
    const bool sphere = grid.chart->kind() == ChartKind::sphere;
    GASPARD_CHECK(grid.directions.size() == 2);
    for (const GridDirection& direction : grid.directions) GASPARD_CHECK(direction.count >= 2);
    const auto filter = sphere ? sphere_filter(grid, length) : patch_filter(grid, length, progress, stop);
    for (int step = 0; step < steps; ++step) {
        if (progress) progress(static_cast<double>(step) / steps, "Smoothing");
        filter->apply(values, stop);
    }
}

/// Both filters are averages with positive weights; rounding must not take values out of their range.
void filter_box(const Grid& grid, std::span<double> values, const std::function<double(double)>& factor,
                const Progress& progress, const std::stop_token& stop) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    const double low = *least, high = *most;
    multiply_spectrum(grid, values, factor, progress, stop);
    for (double& value : values) value = std::clamp(value, low, high);
}

} // namespace

void blur(const Grid& grid, std::span<double> values, double sigma, const Progress& progress,
          std::stop_token stop) {
    GASPARD_CHECK(values.size() == grid.size() && sigma >= 0);
    if (sigma == 0) return;
    if (grid.chart->kind() != ChartKind::box)
        return filter_surface(grid, values, sigma / std::sqrt(2.0 * blur_steps), blur_steps, progress, stop);
    const auto factor = [&](double lambda) { return std::exp(-0.5 * sigma * sigma * lambda); };
    filter_box(grid, values, factor, progress, stop);
}

void helmholtz_filter(const Grid& grid, std::span<double> values, double length, const Progress& progress,
                      std::stop_token stop) {
    GASPARD_CHECK(values.size() == grid.size() && length >= 0);
    if (length == 0) return;
    if (grid.chart->kind() != ChartKind::box) return filter_surface(grid, values, length, 1, progress, stop);
    const auto factor = [&](double lambda) { return 1 / (1 + length * length * lambda); };
    filter_box(grid, values, factor, progress, stop);
}

} // namespace gaspard

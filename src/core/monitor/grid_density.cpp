#include "core/monitor/grid_density.hpp"

#include "core/function/grid_function.hpp"
#include "core/function/smoothing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace gaspard {

namespace {

class GridDensity final : public Monitor {
  public:
    GridDensity(GridFunction logarithm, MonitorReport report, SpaceKind kind)
        : logarithm_(std::move(logarithm)), report_(std::move(report)), kind_(kind) {}

    void values(const Points& x, std::span<double> values) const override {
        logarithm_.values(x, values);
        for (double& value : values) value = std::exp(value);
    }
    void gradients(const Points& x, Points& gradients) const override {
        logarithm_.gradients(x, gradients);
        std::vector<double> m(x.size());
        values(x, m);
        for (std::size_t i = 0; i < m.size(); ++i) gradients.set(i, m[i] * gradients[i]);
    }
    std::optional<SpaceKind> made_for() const override { return kind_; }
    MonitorReport report() const override { return report_; }

  private:
    GridFunction logarithm_;
    MonitorReport report_;
    SpaceKind kind_;
};

/// The largest relative change of m over a cell of the adapted mesh, whose size is h sqrt(mean m / m):
///
///   max h sqrt(mean m / m) |grad m| / m
double steepness(const Grid& grid, std::span<const double> m, double cell) {
    const std::vector<double> weights = measures(grid);
    double mean = 0, area = 0;
    for (std::size_t i = 0; i < m.size(); ++i) mean += weights[i] * m[i], area += weights[i];
    mean /= area;
    Points x, g;
    grid.chart->points(grid.coordinates(), x);
    GridFunction(grid, m).gradients(x, g);
    double most = 0;
    for (std::size_t i = 0; i < m.size(); ++i)
        most = std::max(most, cell * std::sqrt(mean / m[i]) * norm(g[i]) / m[i]);
    return most;
}

} // namespace

void to_density(std::span<double> d, double contrast) {
    for (double& value : d) value = 1 + (contrast - 1) * value;
}

double steepest(const Space& space) {
    const bool square =
        space.kind == SpaceKind::periodic_square || (space.kind == SpaceKind::euclidean && !space.patch);
    return square ? 1.2 : 0.5;
}

double blur_density(const Grid& grid, std::span<double> m, double sigma, double cell,
                    const DataContext& context) {
    blur(grid, m, sigma, context.progress, context.stop);
    const double limit = steepest(context.space);
    for (double steep = steepness(grid, m, cell); steep > limit; steep = steepness(grid, m, cell)) {
        const double wider = sigma * std::clamp(steep / limit, 1.1, 1.5); // variances of Gaussians add up
        blur(grid, m, std::sqrt(wider * wider - sigma * sigma), context.progress, context.stop);
        sigma = wider;
    }
    return sigma;
}

std::shared_ptr<const Monitor> grid_density(Grid grid, std::vector<double> density, MonitorReport report,
                                            SpaceKind kind) {
    for (double& value : density) value = std::log(std::max(value, std::numeric_limits<double>::min()));
    return std::make_shared<GridDensity>(GridFunction(std::move(grid), density), std::move(report), kind);
}

} // namespace gaspard

#include "core/monitor/grid_density.hpp"

#include "core/base/check.hpp"
#include "core/function/grid_function.hpp"
#include "core/function/smoothing.hpp"
#include "core/monitor/stages.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace gaspard {

namespace {

/// Points that are not finite, of an iteration that diverges, have no value.
bool has_finite_sum(Vec3 p) { return std::isfinite(p.x + p.y + p.z); }

class GridDensity final : public Monitor {
  public:
    /// `range`: of the logarithms on the grid.
    GridDensity(GridFunction logarithm, std::pair<double, double> range, MonitorReport report, SpaceKind kind)
        : logarithm_(std::move(logarithm)), lowest_(range.first - margin), highest_(range.second + margin),
          report_(std::move(report)), kind_(kind) {}

    void values(const Points& x, std::span<double> values) const override {
        GASPARD_CHECK(values.size() == x.size());
        logarithm_.values(x, values);
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = has_finite_sum(x[i]) ? std::exp(std::clamp(values[i], lowest_, highest_))
                                             : std::numeric_limits<double>::quiet_NaN();
    }
    void gradients(const Points& x, Points& gradients) const override {
        std::vector<double> log_m(x.size());
        logarithm_.values(x, log_m);
        logarithm_.gradients(x, gradients);
        for (std::size_t i = 0; i < log_m.size(); ++i) {
            const bool within = log_m[i] > lowest_ && log_m[i] < highest_;
            gradients.set(i, (within ? std::exp(log_m[i]) : 0) * gradients[i]);
        }
    }
    std::optional<SpaceKind> made_for() const override { return kind_; }
    MonitorReport report() const override { return report_; }

  private:
    static constexpr double margin = 1; // far beside the domain the spline goes on without bounds

    GridFunction logarithm_;
    double lowest_, highest_;
    MonitorReport report_;
    SpaceKind kind_;
};

} // namespace

void to_density(std::span<double> d, double contrast) {
    for (double& value : d) value = 1 + (contrast - 1) * value;
}

double blur_density(const DomainGrid& domain, std::span<double> m, double sigma, const DataContext& context) {
    blur(domain.grid, m, sigma, context.progress, context.stop);
    const double limit = steepest(domain, steepest_data);
    for (double steep = steepness(domain, m); steep > limit; steep = steepness(domain, m)) {
        const double wider = sigma * std::clamp(steep / limit, 1.1, 1.5); // variances of Gaussians add up
        blur(domain.grid, m, std::sqrt(wider * wider - sigma * sigma), context.progress, context.stop);
        sigma = wider;
    }
    return sigma;
}

std::shared_ptr<const Monitor> grid_density(Grid grid, std::vector<double> density, MonitorReport report,
                                            SpaceKind kind) {
    for (double& value : density) value = std::log(std::max(value, std::numeric_limits<double>::min()));
    const auto [least, most] = std::minmax_element(density.begin(), density.end());
    const std::pair range(*least, *most);
    return std::make_shared<GridDensity>(GridFunction(std::move(grid), density), range, std::move(report),
                                         kind);
}

} // namespace gaspard

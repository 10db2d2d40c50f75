// How methods converge for monitors of the vorticity q that the scenario flow-vortices ships, as they are:
// q is linear on each triangle of its grid, m follows pointwise, and nothing is blurred (docs/flow.md).
#include "core/base/read_data_file.hpp"
#include "core/data/field_file.hpp"
#include "core/gaspard.hpp"

#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <vector>

namespace {

using namespace gaspard;

/// q at a point of [0, 1)^2.
class Vorticity {
  public:
    Vorticity() {
        const FieldData field = parse_field(read_data_file("gaspard:flow-vortices.nc", {}),
                                            "flow-vortices.nc", {.variable = "q"});
        const auto& grid = std::get<GridData>(field.data);
        n_ = grid.axes[0].size();
        values_ = grid.values;
    }
    double operator()(Vec3 x) const {
        const auto n = static_cast<double>(n_);
        const double column = std::floor(x.x * n), row = std::floor(x.y * n), s = x.x * n - column,
                     t = x.y * n - row;
        const auto i = static_cast<std::size_t>(column), j = static_cast<std::size_t>(row);
        const double start = at(i, j), end = at(i + 1, j + 1), corner = s >= t ? at(i + 1, j) : at(i, j + 1);
        return start * (1 - std::max(s, t)) + corner * std::abs(s - t) + end * std::min(s, t);
    }

  private:
    double at(std::size_t i, std::size_t j) const { return values_[j % n_ * n_ + i % n_]; }

    std::size_t n_ = 0;
    std::vector<double> values_;
};

struct Density {
    const char* name;
    double (*of)(double q);
};

} // namespace

int main() {
    constexpr Density densities[] = {
        {"max(q^2, 0.005)", [](double q) { return std::max(q * q, 0.005); }},
        {"sqrt(q^4 + 0.005^2)", [](double q) { return std::sqrt(q * q * q * q + 0.005 * 0.005); }},
        {"sqrt(q^2 + 0.005)", [](double q) { return std::sqrt(q * q + 0.005); }}};
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    const auto q = std::make_shared<const Vorticity>();
    std::printf("| m | n | method | status | iterations | tangled cells | equidistribution | CPU s |\n");
    for (const char* cells : {"60", "120"})
        for (const Density& density : densities)
            for (const char* method : {"quasi-newton", "newton", "auto"}) {
                Scenario scenario = find_scenario(*catalogue, "plane-ring");
                apply_settings(*catalogue, scenario,
                               {std::string("domain.cells=") + cells, std::string("method.type=") + method,
                                "method.max_iterations=100"});
                RunOptions options;
                options.monitor = function_monitor([q, &density](Vec3 x) { return density.of((*q)(x)); });
                Run run(catalogue, scenario, options);
                run.solve();
                const StepReport& last = run.history().back();
                std::printf("| %s | %s | %s | %s | %d | %zu | %.4f | %.1f |\n", density.name, cells, method,
                            std::string(status_name(last.status)).c_str(), last.iteration,
                            last.tangled_cells.value_or(0), last.value("equidistribution").value_or(0),
                            last.cpu_seconds);
            }
}

// What a simulation does with the installed library; library_test.py compiles and runs it.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <gaspard/gaspard.hpp>

using namespace gaspard;

namespace {

void require(bool truth, const char* what) {
    if (truth) return;
    std::printf("failed: %s\n", what);
    std::exit(1);
}

/// Only values; many points per call.
class Density final : public Monitor {
  public:
    explicit Density(double unit, double bad = 1) : unit_(unit), bad_(bad) {}
    void values(const Points& x, std::span<double> values) const override {
        for (std::size_t i = 0; i < x.size(); ++i)
            values[i] = unit_ * (x.x[i] > 0.3 ? bad_ : 1) * (2 + std::sin(3 * x.x[i]) * std::cos(2 * x.y[i]));
    }

  private:
    double unit_, bad_;
};

} // namespace

int main(int, char** arguments) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    Scenario scenario = find_scenario(*catalogue, "spline-patch");
    apply_settings(*catalogue, scenario,
                   {"domain.cells=16", "method.type=newton", "method.diagnostics=geometry"});
    SplinePatch patch = nurbs_disk();
    for (double& x : patch.control.x) x *= 0.5;
    const RunOptions options{.monitor = std::make_shared<Density>(1),
                             .patch = std::make_shared<SplinePatch>(patch)};
    Run run(catalogue, scenario, options);
    require(run.solve().status == RunStatus::converged, "a run with a monitor and a patch of the caller's");
    require(!run.history().back().value("equidistribution"), "diagnostics = geometry");
    const int iterations = run.history().back().iteration;

    Run other(catalogue, scenario, {.monitor = std::make_shared<Density>(1e-300), .patch = options.patch});
    require(other.solve().iteration == iterations, "the unit of the monitor is arbitrary");

    const auto before = run.snapshot();
    try {
        run.follow(std::make_shared<Density>(1, -1));
        require(false, "a negative monitor is refused");
    } catch (const InputError&) {
    }
    require(run.snapshot()->x == before->x, "the map stays");

    std::stop_source stop;
    stop.request_stop();
    try {
        run.follow(std::make_shared<Density>(2), stop.get_token());
        require(false, "following can be stopped");
    } catch (const Interrupted&) {
    }
    run.follow(std::make_shared<Density>(2));
    require(run.status() == RunStatus::converged, "the same mesh for twice the monitor");
    write_run_files(arguments[1], run, parse_formats("vtu"));
    std::puts("as documented");
}

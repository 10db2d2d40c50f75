#include "core/published/mcrae_runs.hpp"

#include "core/base/check.hpp"
#include "core/scenario/toml.hpp"

namespace gaspard {

Run begin_run(const Workshop& workshop, const std::string& scenario, const std::vector<std::string>& settings,
              const std::string& title) {
    if (workshop.stop.stop_requested()) throw Interrupted();
    Scenario chosen = find_scenario(*workshop.catalogue, scenario);
    apply_settings(*workshop.catalogue, chosen, settings);
    workshop.announce(chosen.method.type + ", " + title);
    return Run(workshop.catalogue, std::move(chosen), {}, {}, workshop.stop);
}

void finish(Run& run, const Workshop& workshop) {
    while (run.status() == RunStatus::running) {
        if (workshop.stop.stop_requested()) throw Interrupted();
        run.step(workshop.stop);
    }
}

Run solve(const Workshop& workshop, const std::string& scenario, const std::vector<std::string>& settings,
          const std::string& title) {
    Run run = begin_run(workshop, scenario, settings, title);
    finish(run, workshop);
    GASPARD_CHECK(run.status() == RunStatus::converged);
    return run;
}

Curve history_curve(const Run& run, const std::string& label, std::string_view series) {
    Curve curve{label, {}, {}};
    for (const auto& report : run.history())
        if (const auto value = report.value(series)) {
            curve.x.push_back(report.iteration);
            curve.y.push_back(*value);
        }
    return curve;
}

Recipe make_recipe(const std::string& id, const std::string& title, MakeInWorkshop make,
                   MakeInWorkshop full) {
    const auto with_workshop = [](MakeInWorkshop work) -> Recipe::Make {
        if (!work) return {};
        return [work = std::move(work)](const std::shared_ptr<const Catalogue>& catalogue,
                                        const Announce& announce, std::stop_token stop) {
            return work(Workshop{catalogue, announce, stop});
        };
    };
    return {id, title, with_workshop(std::move(make)), with_workshop(std::move(full))};
}

} // namespace gaspard

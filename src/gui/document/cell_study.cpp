#include "gui/document/cell_study.hpp"

#include <stop_token>
#include <utility>

namespace gaspard {

CellStudy::CellStudy(std::shared_ptr<const Catalogue> catalogue, std::function<void()> wake)
    : catalogue_(std::move(catalogue)), study_(std::move(wake)) {}

void CellStudy::begin(const Scenario& scenario) {
    scenario_ = scenario, known_ = true;
    study_.begin([catalogue = catalogue_, scenario](const auto& change, const std::stop_token& stop) {
        check_comparable(scenario);
        const auto resolutions = usual_resolutions(scenario);
        change([&](Result& result) { result.total = resolutions.size(); });
        std::vector<InterpolationRow> rows;
        for (const std::int64_t resolution : resolutions) {
            Run run(catalogue, with_resolution(*catalogue, scenario, resolution),
                    {.threads = study_threads()}, {}, stop);
            run.solve(stop);
            if (run.status() == RunStatus::interrupted) return;
            rows.push_back(interpolation_row(run, rows.empty() ? nullptr : &rows.back(), stop));
            change([&](Result& result) { result.rows = rows; });
        }
    });
}

bool CellStudy::describes(const Scenario& scenario) const {
    return known_ && scenario.domain == scenario_.domain && scenario.monitor == scenario_.monitor &&
           scenario.source == scenario_.source && scenario.pde == scenario_.pde &&
           scenario.method == scenario_.method;
}

} // namespace gaspard

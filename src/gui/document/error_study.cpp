#include "gui/document/error_study.hpp"

#include "core/base/error.hpp"

#include <utility>

namespace gaspard {

ErrorStudy::ErrorStudy(std::shared_ptr<const Catalogue> catalogue, std::function<void()> wake)
    : catalogue_(std::move(catalogue)), study_(std::move(wake)) {}

void ErrorStudy::follow(const Scenario& scenario, const StudyVariable& variable, bool rests) {
    if (!seen_ || variable != variable_ || scenario != *seen_) {
        seen_ = scenario, variable_ = variable;
        wanted_.reset();
        try {
            wanted_ = usual_study(*catalogue_, scenario, variable);
        } catch (const InputError&) { // such as of a formula that is being typed: the run says so
        }
    }
    if (current()) return;
    cut_short();
    if (!rests || !wanted_) return;
    begun_ = wanted_, incomplete_ = false;
    study_.begin([catalogue = catalogue_, plan = *wanted_](const auto& change, const std::stop_token& stop) {
        run_study(
            catalogue, plan, study_threads(),
            [&](StudyPoint point) {
                change([&](Result& result) { result.points.push_back(std::move(point)); });
            },
            stop);
    });
}

void ErrorStudy::cut_short() {
    if (begun_ && !study_.result().done) incomplete_ = true; // to begin anew, whatever its thread says later
    study_.cancel();
}

void ErrorStudy::leave() {
    cut_short();
    seen_.reset(), wanted_.reset();
}

} // namespace gaspard

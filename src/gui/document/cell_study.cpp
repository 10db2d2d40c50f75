#include "gui/document/cell_study.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <exception>
#include <mutex>
#include <stop_token>
#include <utility>

namespace gaspard {

/// What the thread of a study shares with the window.
struct CellStudy::Work {
    mutable std::mutex mutex;
    Result result;

    void change(const std::function<void()>& wake, const std::function<void(Result&)>& edit) {
        {
            const std::lock_guard lock(mutex);
            edit(result);
        }
        if (wake) wake();
    }
    Result copy() const {
        const std::lock_guard lock(mutex);
        return result;
    }
};

namespace {

int usual_threads() { return static_cast<int>(std::max(1U, std::thread::hardware_concurrency())); }

} // namespace

CellStudy::CellStudy(std::shared_ptr<const Catalogue> catalogue, std::function<void()> wake)
    : catalogue_(std::move(catalogue)), wake_(std::move(wake)) {}

CellStudy::~CellStudy() {
    thread_.request_stop();
    for (Leaving& one : leaving_) one.thread.request_stop(); // all of them, before the first is waited for
}

void CellStudy::begin(const Scenario& scenario) {
    cancel();
    scenario_ = scenario, known_ = true;
    work_ = std::make_shared<Work>();
    thread_ = std::jthread([work = work_, wake = wake_, catalogue = catalogue_,
                            scenario](const std::stop_token& stop) {
        std::string complaint;
        try {
            const auto resolutions = usual_resolutions(scenario);
            work->change(wake, [&](Result& result) { result.total = resolutions.size(); });
            std::vector<InterpolationRow> rows;
            for (const std::int64_t resolution : resolutions) {
                Run run(catalogue, with_resolution(*catalogue, scenario, resolution),
                        {.threads = usual_threads()}, {}, stop);
                run.solve(stop);
                if (run.status() == RunStatus::interrupted) break;
                rows.push_back(interpolation_row(run, rows.empty() ? nullptr : &rows.back(), stop));
                work->change(wake, [&](Result& result) { result.rows = rows; });
            }
        } catch (const Interrupted&) { // the rows so far stay
        } catch (const std::exception& error) {
            complaint = error.what();
        }
        work->change(wake, [&](Result& result) { result.done = true, result.complaint = complaint; });
    });
}

void CellStudy::cancel() {
    std::erase_if(leaving_, [](const Leaving& one) { return one.work->copy().done; });
    if (!thread_.joinable()) return;
    thread_.request_stop();
    leaving_.push_back({work_, std::move(thread_)});
}

bool CellStudy::describes(const Scenario& scenario) const {
    return known_ && scenario.domain == scenario_.domain && scenario.monitor == scenario_.monitor &&
           scenario.target == scenario_.target && scenario.pde == scenario_.pde &&
           scenario.method == scenario_.method;
}

CellStudy::Result CellStudy::result() const { return work_ ? work_->copy() : Result{}; }

} // namespace gaspard

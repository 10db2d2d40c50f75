#include "gui/document/playback.hpp"

#include "core/session/time_series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gaspard {

namespace {

constexpr double rest_at_end = 0.8;    // seconds
constexpr double blend_period = 4;     // seconds there and back
constexpr double longest_frame = 0.25; // seconds; a frame that took longer does not make the replay jump

/// Null if nothing was recorded.
std::shared_ptr<const RecordedIterate> first_iterate(const DocumentRun& run) {
    return run.recording ? run.recording->at(std::numeric_limits<int>::min()) : nullptr;
}

/// Whether a run ends after another.
bool longer(const DocumentRun& run, const DocumentRun& other) {
    const auto end = [](const DocumentRun& one) {
        return one.history.empty() ? std::nullopt : time_of(one.history.back());
    };
    const auto mine = end(run), its = end(other);
    if (mine && its && *mine != *its) return *mine > *its;
    return last_iteration(run) > last_iteration(other);
}

/// Nothing if the run has no time. While it is being solved for the first time, others are shown at the same
/// iteration of theirs; its last mesh is compared with their last one.
std::optional<Moment> moment_of(const DocumentRun& run, int iteration) {
    const auto t = time_at(run, iteration);
    if (!t) return std::nullopt;
    const auto row = std::ranges::lower_bound(run.history, iteration, {}, &StepReport::iteration);
    const auto next = std::next(row);
    const bool before_time = next != run.history.end() && !is_time_step(*row) && !is_time_step(*next);
    return Moment{*t, before_time ? iteration : std::numeric_limits<int>::max()};
}

} // namespace

int last_iteration(const DocumentRun& run) { return run.history.empty() ? 0 : run.history.back().iteration; }

const DocumentRun& longest_run(const DocumentRun& run, const std::vector<const DocumentRun*>& others) {
    const DocumentRun* longest = &run;
    for (const DocumentRun* other : others)
        if (other->recording && longer(*other, *longest)) longest = other;
    return *longest;
}

std::optional<double> time_at(const DocumentRun& run, int iteration) {
    const auto after = std::ranges::lower_bound(run.history, iteration, {}, &StepReport::iteration);
    if (after == run.history.end()) return std::nullopt;
    const auto t = time_of(*after);
    if (!t || after->iteration == iteration || after == run.history.begin()) return t;
    const auto recorded = run.recording ? run.recording->at(iteration) : nullptr;
    if (recorded && recorded->iteration() == iteration) return time_of(recorded->report());
    const auto before = std::prev(after);
    const double share =
        static_cast<double>(iteration - before->iteration) / (after->iteration - before->iteration);
    return std::lerp(time_of(*before).value_or(*t), *t, share);
}

int iteration_beside(const DocumentRun& run, const DocumentRun& other, int iteration) {
    if (run.id == other.id || !other.recording) return iteration;
    const auto moment = moment_of(run, iteration);
    const auto there = moment ? other.recording->at_time(moment->t, moment->iteration) : nullptr;
    return there ? there->iteration() : iteration;
}

void Playback::update(const DocumentRun& run, const DocumentRun& longest, double seconds) {
    if (run.id != run_ || run.histories != histories_) {
        run_ = run.id, histories_ = run.histories;
        go_to_end();
        restored_.clear();
    }
    if (live() && run.solving()) compares_ = false;
    if (live()) {
        of_ = run.id;
        const bool under_way = run.live() && !run.ended() && !compares_;
        moment_ = under_way ? moment_of(run, last_iteration(run)) : std::nullopt;
    }
    if (blends_) blended_ += std::min(seconds, longest_frame);
    if (playing_) advance(longest, run.solving(), std::min(seconds, longest_frame));
}

void Playback::advance(const DocumentRun& run, bool solving, double seconds) {
    const int last = last_iteration(run);
    if (at_ && of_ != run.id) stand_at(run, iteration(run));
    if (at_ && *at_ < last) {
        if (rate_ > 0)
            stand_at(run, std::min(*at_ + seconds * rate_, static_cast<double>(last)));
        else
            go_forward(run), playing_ = true;
        rested_ = 0;
        if (at_ && *at_ < last) return;
        stand_at(run, last); // shown at least once
    } else {
        rested_ += seconds;
    }
    if (solving || !loops_) {
        show_newest();
    } else if (rested_ >= rest_at_end) {
        go_to_start(run);
        playing_ = true;
    }
}

/// Null: the newest.
std::shared_ptr<const RecordedIterate> Playback::iterate(const DocumentRun& run) const {
    if (!run.recording) return nullptr;
    auto there = moment_ && run.id != of_ ? run.recording->at_time(moment_->t, moment_->iteration) : nullptr;
    return there || !at_ ? there : run.recording->at(static_cast<int>(*at_));
}

int Playback::iteration(const DocumentRun& run) const {
    const auto shown = iterate(run);
    return shown ? shown->iteration() : last_iteration(run);
}

std::shared_ptr<const Snapshot> Playback::snapshot(const DocumentRun& run) {
    const auto iterate = this->iterate(run);
    if (!iterate || (run.snapshot && run.snapshot->version == iterate->version())) return run.snapshot;
    Restored& known = restored_[run.id];
    if (known.of != iterate) known = {iterate, iterate->restore()};
    return known.snapshot;
}

void Playback::go_to(const DocumentRun& run, double iteration, const DocumentRun* longest) {
    playing_ = false;
    compares_ = true;
    const bool ends_last = longest == nullptr || longest->id == run.id;
    const auto first = first_iterate(run);
    const int wanted = static_cast<int>(std::lround(std::clamp(iteration, -1e9, 1e9)));
    if (!first || (wanted >= last_iteration(run) && ends_last)) return show_newest();
    const auto before = run.recording->at(wanted);
    if (!before) return show_newest(); // the solver has just begun another recording
    const std::vector<int> kept = run.recording->iterations();
    const auto after = std::upper_bound(kept.begin(), kept.end(), wanted);
    const bool nearer = after != kept.end() && *after - wanted < wanted - before->iteration();
    stand_at(run, nearer ? *after : std::max(before->iteration(), first->iteration()));
}

void Playback::stand_at(const DocumentRun& run, double iteration) {
    at_ = iteration, of_ = run.id;
    moment_ = moment_of(run, static_cast<int>(iteration));
}

void Playback::go_back(const DocumentRun& run) {
    if (!run.recording) return;
    const std::vector<int> kept = run.recording->iterations();
    const auto here = std::lower_bound(kept.begin(), kept.end(), iteration(run));
    if (here != kept.begin()) go_to(run, *std::prev(here));
}

void Playback::go_forward(const DocumentRun& run) {
    if (!run.recording) return;
    const std::vector<int> kept = run.recording->iterations();
    const auto next = std::upper_bound(kept.begin(), kept.end(), iteration(run));
    next == kept.end() ? show_newest() : go_to(run, *next);
}

void Playback::go_to_start(const DocumentRun& run) {
    if (const auto first = first_iterate(run)) go_to(run, first->iteration());
}

void Playback::show_newest() {
    playing_ = false;
    at_.reset(), moment_.reset();
}

void Playback::go_to_end() {
    show_newest();
    compares_ = false;
}

void Playback::play(const DocumentRun& run) {
    if (live()) go_to_start(run);
    playing_ = !live();
    compares_ = playing_;
    rested_ = 0;
}

void Playback::set_blends(bool blends) {
    blends_ = blends;
    blended_ = 0;
}

double Playback::blend() const {
    // Begins with the physical mesh, and rests a little at both ends.
    const double wave = 1.3 * std::cos(2 * std::numbers::pi * blended_ / blend_period);
    return std::clamp(0.5 + 0.5 * wave, 0.0, 1.0);
}

std::vector<std::pair<int, int>> tangled_ranges(const std::vector<StepReport>& history) {
    std::vector<std::pair<int, int>> ranges;
    bool tangled = false;
    for (const StepReport& report : history) {
        const bool before = tangled;
        if (report.measured()) tangled = *report.tangled_cells > 0;
        if (tangled && !before)
            ranges.emplace_back(report.iteration, report.iteration);
        else if (tangled)
            ranges.back().second = report.iteration;
    }
    return ranges;
}

} // namespace gaspard

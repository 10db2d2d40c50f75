#include "core/session/recording.hpp"

#include "core/session/time_series.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

namespace gaspard {

namespace {

void append_rounded(std::vector<float>& to, const std::vector<double>& from) {
    std::transform(from.begin(), from.end(), std::back_inserter(to),
                   [](double value) { return static_cast<float>(value); });
}

bool up_to(int iteration, const std::shared_ptr<const RecordedIterate>& one) {
    return iteration < one->iteration();
}

} // namespace

RecordedIterate::RecordedIterate(const Snapshot& snapshot, std::shared_ptr<const State> state)
    : state_(std::move(state)) {
    rest_ = {.mesh = snapshot.mesh,
             .x = {},
             .exact = snapshot.exact,
             .tangled = snapshot.tangled,
             .control = snapshot.control,
             .control_columns = snapshot.control_columns,
             .target = snapshot.target,
             .patches = snapshot.patches,
             .monitor_report = snapshot.monitor_report,
             .interpolation = snapshot.interpolation,
             .fields = {},
             .report = snapshot.report,
             .version = snapshot.version};
    const int dimension = snapshot.mesh->space_dimension;
    coordinates_.reserve(snapshot.x.size() * static_cast<std::size_t>(dimension));
    append_rounded(coordinates_, snapshot.x.x);
    if (dimension > 1) append_rounded(coordinates_, snapshot.x.y);
    if (dimension > 2) append_rounded(coordinates_, snapshot.x.z);
    bytes_ = sizeof *this + sizeof(float) * coordinates_.size();
    for (const Field& field : snapshot.fields) {
        rest_.fields.push_back({static_cast<const FieldInfo&>(field), {}, field.range});
        append_rounded(values_.emplace_back(), field.values);
        bytes_ += sizeof(Field) + sizeof(float) * field.values.size();
    }
    if (state_)
        for (const auto& array : state_->arrays) bytes_ += sizeof(double) * array.values.size();
    if (rest_.exact && is_time_step(rest_.report)) // others share it
        bytes_ += sizeof(Vec3) * rest_.exact->size();
    if (rest_.tangled) bytes_ += sizeof(std::uint32_t) * rest_.tangled->size();
}

std::shared_ptr<const Snapshot> RecordedIterate::restore() const {
    auto snapshot = std::make_shared<Snapshot>(rest_);
    const std::size_t nodes = snapshot->mesh->node_count();
    snapshot->x.resize(nodes);
    auto from = coordinates_.begin();
    for (std::vector<double>* to : {&snapshot->x.x, &snapshot->x.y, &snapshot->x.z}) {
        if (from == coordinates_.end()) break;
        const auto end = from + static_cast<std::ptrdiff_t>(nodes);
        std::copy(from, end, to->begin());
        from = end;
    }
    for (std::size_t i = 0; i < values_.size(); ++i)
        snapshot->fields[i].values.assign(values_[i].begin(), values_[i].end());
    return snapshot;
}

Recording::Recording(const Recording& other) {
    std::lock_guard lock(other.mutex_);
    budget_ = other.budget_, bytes_ = other.bytes_;
    stride_ = other.stride_;
    kept_ = other.kept_;
}

void Recording::begin() {
    std::lock_guard lock(mutex_);
    kept_.clear();
    bytes_ = 0;
    stride_ = 1;
}

void Recording::add(const Snapshot& snapshot, std::shared_ptr<const State> state) {
    auto iterate = std::make_shared<const RecordedIterate>(snapshot, std::move(state));
    std::lock_guard lock(mutex_);
    const auto drop_last = [this] {
        bytes_ -= kept_.back()->bytes();
        kept_.pop_back();
    };
    while (!kept_.empty() && kept_.back()->iteration() >= iterate->iteration()) drop_last();
    // The newest before it was kept although the stride leaves it out.
    if (kept_.size() > 1 && kept_.back()->iteration() % stride_ != 0) drop_last();
    bytes_ += iterate->bytes();
    kept_.push_back(std::move(iterate));
    thin_out();
}

/// Until the iterates fit into the budget.
void Recording::thin_out() {
    while (bytes_ > budget_ && kept_.size() > 2) {
        stride_ *= 2;
        const auto between = [&](const std::shared_ptr<const RecordedIterate>& one) {
            return one->iteration() % stride_ != 0;
        };
        kept_.erase(std::remove_if(kept_.begin() + 1, kept_.end() - 1, between), kept_.end() - 1);
        bytes_ = std::accumulate(kept_.begin(), kept_.end(), std::size_t{0},
                                 [](std::size_t sum, const auto& one) { return sum + one->bytes(); });
    }
}

void Recording::set_budget(std::size_t budget) {
    std::lock_guard lock(mutex_);
    budget_ = budget;
    thin_out();
}

std::size_t Recording::budget() const {
    std::lock_guard lock(mutex_);
    return budget_;
}

std::vector<int> Recording::iterations() const {
    std::lock_guard lock(mutex_);
    std::vector<int> all;
    for (const auto& one : kept_) all.push_back(one->iteration());
    return all;
}

std::shared_ptr<const RecordedIterate> Recording::at(int iteration) const {
    std::lock_guard lock(mutex_);
    if (kept_.empty()) return nullptr;
    const auto after = std::upper_bound(kept_.begin(), kept_.end(), iteration, up_to);
    return after == kept_.begin() ? kept_.front() : *std::prev(after);
}

std::shared_ptr<const RecordedIterate> Recording::at_time(double t, int iteration) const {
    std::lock_guard lock(mutex_);
    if (kept_.empty() || !time_of(kept_.front()->report())) return nullptr;
    const auto time = [](const std::shared_ptr<const RecordedIterate>& one) {
        return time_of(one->report()).value_or(0);
    };
    auto nearest = std::ranges::lower_bound(kept_, t, {}, time);
    const bool before = nearest == kept_.end() ||
                        (nearest != kept_.begin() && t - time(*std::prev(nearest)) < time(*nearest) - t);
    if (before) --nearest;
    const auto [first, last] = std::ranges::equal_range(kept_, time(*nearest), {}, time);
    const auto after = std::upper_bound(first, last, iteration, up_to);
    return after == first ? *first : *std::prev(after);
}

bool Recording::wants_state(int iteration) const {
    std::lock_guard lock(mutex_);
    return kept_.empty() || iteration % (between_states * stride_) == 0;
}

std::shared_ptr<const RecordedIterate> Recording::with_state(int iteration) const {
    std::lock_guard lock(mutex_);
    std::shared_ptr<const RecordedIterate> found;
    for (const auto& one : kept_) {
        if (found && one->iteration() > iteration) break;
        if (one->state()) found = one;
    }
    return found;
}

std::optional<int> Recording::first_tangled() const {
    std::lock_guard lock(mutex_);
    for (const auto& one : kept_)
        if (one->report().tangled_cells.value_or(0) > 0) return one->iteration();
    return std::nullopt;
}

std::size_t Recording::bytes() const {
    std::lock_guard lock(mutex_);
    return bytes_;
}

int Recording::stride() const {
    std::lock_guard lock(mutex_);
    return stride_;
}

} // namespace gaspard

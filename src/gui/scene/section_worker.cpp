#include "gui/scene/section_worker.hpp"

#include "core/base/stopwatch.hpp"

#include <exception>
#include <utility>

namespace gaspard {

MadeSection SectionMaking::make(const SectionJob& job) {
    if (mesh_ != job.mesh || !maker_) maker_.emplace(job.mesh, job.faces);
    mesh_ = job.mesh;
    const Stopwatch watch;
    MadeSection made{.mesh = job.mesh, .tessellation = nullptr, .number = job.number};
    made.tessellation =
        std::make_shared<const Tessellation>(maker_->make(job.x, job.visible, job.choice, job.pieces));
    made.seconds = watch.seconds();
    return made;
}

SectionWorker::SectionWorker() : thread_([this](const std::stop_token& stop) { run(stop); }) {}

void SectionWorker::post(SectionJob job) {
    const std::lock_guard lock(mutex_);
    waiting_ = std::move(job);
    posted_.notify_one();
}

void SectionWorker::withdraw() {
    const std::lock_guard lock(mutex_);
    waiting_.reset();
}

std::optional<MadeSection> SectionWorker::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(made_, std::nullopt);
}

bool SectionWorker::busy() const {
    const std::lock_guard lock(mutex_);
    return working_ || waiting_.has_value() || made_.has_value();
}

void SectionWorker::run(const std::stop_token& stop) {
    SectionMaking making;
    std::unique_lock lock(mutex_);
    while (posted_.wait(lock, stop, [this] { return waiting_.has_value(); })) {
        const SectionJob job = *std::exchange(waiting_, std::nullopt);
        working_ = true;
        lock.unlock();
        MadeSection made{.mesh = job.mesh, .tessellation = nullptr, .number = job.number};
        try {
            made = making.make(job);
        } catch (const std::exception&) { // not enough memory: the section before stays
        }
        lock.lock();
        working_ = false;
        made_ = std::move(made);
    }
}

} // namespace gaspard

#include "gui/app/mesh_painter.hpp"

#include "core/base/this_thread.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace gaspard {

namespace {

constexpr double slow_drawing = 0.02, rest_before_full = 0.3; // seconds
constexpr int nicer = 5;                                      // than the window, which answers first
constexpr double soon = 0.06, longest_wait = 0.08;            // seconds that a frame may wait for its meshes

std::chrono::duration<double> seconds(double count) { return std::chrono::duration<double>(count); }

} // namespace

MeshPainter::MeshPainter(std::function<void()> wake, OffscreenBackend backend)
    : wake_(std::move(wake)), thread_([this, backend] { work(backend); }) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return ready_ || failure_; });
    if (!failure_) return;
    lock.unlock();
    thread_.join();
    std::rethrow_exception(failure_);
}

MeshPainter::~MeshPainter() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

std::uint64_t MeshPainter::want(const MeshesToDraw& what, Hurry hurry) {
    const std::lock_guard lock(mutex_);
    if (failure_) std::rethrow_exception(failure_);
    const bool waits = wanted_.number != shown_;
    if (what == wanted_.what) {
        wanted_.hurry = std::max(wanted_.hurry, hurry);
    } else {
        wanted_ = {what, waits ? std::max(wanted_.hurry, hurry) : hurry, wanted_.number + 1};
        wanted_at_ = clock_.seconds();
    }
    changed_.notify_all();
    return wanted_.number;
}

double MeshPainter::patience() const {
    const std::lock_guard lock(mutex_);
    const bool quickly = full_seconds_ > slow_drawing && wanted_.hurry != Hurry::in_full;
    return (quickly ? quick_seconds_ : full_seconds_) <= soon ? longest_wait : 0;
}

bool MeshPainter::wait(double most) {
    std::unique_lock lock(mutex_);
    const bool in_full = wanted_.hurry == Hurry::in_full;
    return changed_.wait_for(lock, seconds(most), [&] {
        return failure_ || (shown_ == wanted_.number && (shown_in_full_ || !in_full));
    });
}

std::shared_ptr<const PaintedMeshes> MeshPainter::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(image_, nullptr);
}

/// Waits for the next image to draw; none: the painter ends.
std::optional<MeshPainter::Job> MeshPainter::next_job() {
    std::unique_lock lock(mutex_);
    while (!stop_) {
        const double now = clock_.seconds();
        const bool slow = full_seconds_ > slow_drawing, hurried = wanted_.hurry != Hurry::none;
        double due = 0;
        if (wanted_.number != shown_) {
            due = hurried ? now : 2 * ended_ - begun_;
            if (now >= due) return Job{wanted_, slow && wanted_.hurry != Hurry::in_full};
        } else if (!shown_in_full_) {
            due = wanted_.hurry == Hurry::in_full ? now : wanted_at_ + rest_before_full;
            if (now >= due) return Job{wanted_, false};
        }
        if (due > 0)
            changed_.wait_for(lock, seconds(due - now));
        else
            changed_.wait(lock);
    }
    return std::nullopt;
}

void MeshPainter::publish(std::shared_ptr<const PaintedMeshes> image, const Job& job) {
    {
        const std::lock_guard lock(mutex_);
        image_ = std::move(image);
        shown_ = job.wanted.number;
        shown_in_full_ = !job.quickly;
        if (job.wanted.number == wanted_.number && !job.quickly) wanted_.hurry = Hurry::none;
    }
    changed_.notify_all();
    wake_();
}

void MeshPainter::draw_what_is_wanted(const Gl& gl) {
    MeshImage image(gl);
    while (const auto job = next_job()) {
        const double begun = clock_.seconds();
        const auto give_up = [&] {
            const std::lock_guard lock(mutex_);
            const bool outdated = wanted_.number != job->wanted.number && job->wanted.hurry != Hurry::in_full;
            const bool slow = std::max(full_seconds_, clock_.seconds() - begun) > slow_drawing;
            // What was begun quickly is of use unless the window looks different now.
            return stop_ ||
                   (outdated && slow && (!job->quickly || !in_same_place(job->wanted.what, wanted_.what)));
        };
        const bool done =
            image.draw(job->wanted.what, job->quickly, job->quickly ? std::function<bool()>() : give_up);
        auto drawn = done ? std::make_shared<const PaintedMeshes>(PaintedMeshes{
                                image.image().read(), job->wanted.what, job->wanted.number, !job->quickly})
                          : nullptr;
        {
            const std::lock_guard lock(mutex_);
            begun_ = begun, ended_ = clock_.seconds();
            const double took = ended_ - begun_;
            if (job->quickly)
                quick_seconds_ = done ? took : quick_seconds_;
            else
                full_seconds_ = done ? took : std::max(took, full_seconds_);
        }
        if (done) publish(std::move(drawn), *job);
    }
}

void MeshPainter::work(OffscreenBackend backend) {
    name_thread("mesh painter");
    lower_priority(nicer); // and the threads that OpenGL starts for it
    try {
        const auto context = make_offscreen_context(backend);
        {
            const std::lock_guard lock(mutex_);
            ready_ = true;
        }
        changed_.notify_all();
        draw_what_is_wanted(context->gl());
        return;
    } catch (...) {
        const std::lock_guard lock(mutex_);
        failure_ = std::current_exception();
    }
    changed_.notify_all();
    wake_();
}

} // namespace gaspard

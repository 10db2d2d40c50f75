#include "gui/app/frame_pacing.hpp"

#include <algorithm>

namespace gaspard {

namespace {

constexpr double frame_seconds = 1.0 / 60;
constexpr double gesture_seconds = 0.5; // after an input, in which what it changes is drawn at once

} // namespace

bool FramePacing::may_sleep(const FrameCauses& causes) const {
    return frames_due_ == 0 && !causes.news && !causes.image && !causes.animating;
}

bool FramePacing::in_gesture(double now) const { return now - input_at_ < gesture_seconds; }

bool FramePacing::answers(const FrameCauses& causes, double now) const {
    if (!in_gesture(now)) return false;
    if (frames_due_ > 0 && !changed_) return true; // the last frame took an input that shows only in the next
    return !causes.input && (causes.image || (causes.news ? !answered_ : frames_due_ > 0));
}

double FramePacing::rest(const FrameCauses& causes, double now) const {
    const bool at_once = causes.input || in_gesture(now) || causes.image || (frames_due_ > 0 && !causes.news);
    const double pause = answers(causes, now) ? 0.0
                         : at_once            ? frame_seconds
                                              : std::max(frame_seconds, 2 * drawing_seconds_);
    return begun_ + pause - now;
}

void FramePacing::begin(const FrameCauses& causes, double now) {
    if (causes.input || causes.news) need_more_frames();
    frames_due_ = std::max(0, frames_due_ - 1);
    begun_ = now;
    if (causes.news) answered_ = true;
    if (causes.input) input_at_ = now, answered_ = false;
}

void FramePacing::end(double seconds, bool changed) { drawing_seconds_ = seconds, changed_ = changed; }

void FramePacing::need_more_frames() { frames_due_ = settling_frames; }

} // namespace gaspard

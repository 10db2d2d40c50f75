// When the window draws. It sleeps until something happens, and draws at most 60 times a second, with two
// exceptions:
//
// - What answers an input is drawn at once: the frames in which ImGui reacts to it, the first news of the
//   solver after it, and meshes that were being painted. Further inputs wait unless nothing has changed yet:
//   a mouse may send a thousand positions a second.
// - Slow drawing, without a graphics card, takes at most half of the time while the solver, which needs the
//   cores too, is running and nobody touches the window.
#pragma once

namespace gaspard {

/// What the window may have to draw for. All that happened since the last frame.
struct FrameCauses {
    bool input = false;
    bool news = false;      ///< of the solver, or of files
    bool image = false;     ///< painted meshes
    bool animating = false; ///< whether or not anything happens
};

class FramePacing {
  public:
    /// There is nothing to draw until something happens.
    bool may_sleep(const FrameCauses& causes) const;
    /// Seconds from `now` until the next frame should begin; at most 0: at once.
    double rest(const FrameCauses& causes, double now) const;
    /// The next frame begins. Times are in seconds, from any origin.
    void begin(const FrameCauses& causes, double now);
    /// The frame took so many seconds, without those spent waiting; `changed`: it differed from the last one.
    void end(double seconds, bool changed);
    /// There is more to draw than in the frame that is being drawn.
    void need_more_frames();
    /// What changes now was probably caused by the hand, which goes on.
    bool in_gesture(double now) const;

    double begun() const { return begun_; } ///< of the last frame

  private:
    static constexpr int settling_frames = 3; ///< ImGui reacts to an input one or two frames later

    bool answers(const FrameCauses& causes, double now) const;

    int frames_due_ = settling_frames;
    double begun_ = 0, drawing_seconds_ = 0; ///< of the last frame
    double input_at_ = -1e9;                 ///< when the last input came
    bool answered_ = true;                   ///< the solver has sent news since
    bool changed_ = false;                   ///< the last frame differed from the one before
};

} // namespace gaspard

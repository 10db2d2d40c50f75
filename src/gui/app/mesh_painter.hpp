// Draws the meshes of a window that has no graphics card, on a thread with a context of its own, so that a
// button or a menu never waits for a mesh.
//
// A mesh that takes longer than 20 ms is drawn with one sample a pixel while it
// changes, and in full when it has rested for 0.3 s; the latter is given up as soon as something else is
// wanted. While nobody touches the window, drawing takes at most half of the time, as the solver needs the
// cores too.
#pragma once

#include "core/base/stopwatch.hpp"
#include "gui/app/mesh_image.hpp"

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace gaspard {

/// An image of what was wanted.
struct PaintedMeshes {
    Image image;
    MeshesToDraw what;
    std::uint64_t number = 0; ///< as want() has returned it
    bool in_full = true;
};

enum class Hurry {
    none,    ///< drawing may wait, as the solver needs the cores
    at_once, ///< it answers an input
    in_full  ///< at once, and in full
};

class MeshPainter {
  public:
    /// `wake` is called on the painter's thread when there is a new image. Throws MachineError if there is no
    /// OpenGL without a window.
    explicit MeshPainter(std::function<void()> wake, OffscreenBackend backend = OffscreenBackend::any);
    ~MeshPainter();
    MeshPainter(const MeshPainter&) = delete;
    MeshPainter& operator=(const MeshPainter&) = delete;

    /// From now on this is to be shown; what is wanted later has a larger number. Throws what the drawing of
    /// an earlier one has thrown.
    std::uint64_t want(const MeshesToDraw& what, Hurry hurry);
    /// Waits at most so many seconds until it is there, with Hurry::in_full in full. False if it is not.
    bool wait(double seconds);
    /// How long a frame should wait: not at all if that is not expected to be enough.
    double patience() const;
    /// The newest image, if it is not the one that was taken last; else null.
    std::shared_ptr<const PaintedMeshes> take();

  private:
    struct Wanted {
        MeshesToDraw what;
        Hurry hurry = Hurry::none;
        std::uint64_t number = 0;
    };
    struct Job {
        Wanted wanted;
        bool quickly = false;
    };
    void work(OffscreenBackend backend);
    void draw_what_is_wanted(const Gl& gl);
    std::optional<Job> next_job();
    void publish(std::shared_ptr<const PaintedMeshes> image, const Job& job);

    std::function<void()> wake_;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    Wanted wanted_;
    std::uint64_t shown_ = 0; ///< number of what was drawn last
    bool ready_ = false, shown_in_full_ = true, stop_ = false;
    double quick_seconds_ = 0, full_seconds_ = 0; ///< that the last ones took; 0: unknown
    Stopwatch clock_;
    double begun_ = 0, ended_ = 0, wanted_at_ = 0; ///< of the last drawing, and of the last wish
    std::exception_ptr failure_;
    std::shared_ptr<const PaintedMeshes> image_; ///< null once it is taken
    std::thread thread_;
};

} // namespace gaspard

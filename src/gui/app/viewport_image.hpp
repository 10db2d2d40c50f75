// Images without a window: a viewport, a plot, or several of them side by side, drawn offscreen.
//
// Drawing creates and releases an OpenGL context, unless it is given one. Throws MachineError
// if there is no OpenGL.
#pragma once

#include "core/base/parameter.hpp"
#include "core/io/image.hpp"
#include "core/session/snapshot.hpp"
#include "core/tessellate/background.hpp"
#include "core/tessellate/plot.hpp"
#include "core/tessellate/tessellation_cache.hpp"
#include "gui/gl/offscreen.hpp"
#include "gui/viewport/viewport.hpp"

#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <variant>
#include <vector>

namespace gaspard {

/// Larger images are drawn in strips of at most so many pixels (strips.hpp).
inline constexpr int strip_pixels = 1 << 22;

struct ImageOptions {
    bool light = false; ///< dark on white, for paper; so does view.theme
    OffscreenBackend backend = OffscreenBackend::any;
    Background background{}; ///< so is view.background
    int most_pixels = strip_pixels;
    const Gl* gl = nullptr; ///< of a context that is current, to draw with; null: one is made and released
    std::stop_token stop{}; ///< asked to stop between meshes, drawing throws Interrupted
    std::shared_ptr<TessellationCache> cache{}; ///< of tessellations that may have been made; may be null
    int last_iteration = 0;                     ///< of the run, for the caption; 0: unknown
    std::vector<NamedSnapshot> beside{};        ///< other runs, shown if view.layout is "runs"
    /// That has prepared this snapshot and view, and is used for nothing else; null: one is made.
    std::shared_ptr<ViewportPlanner> planner{};
};

/// What a viewport of the window would show of `snapshot`. `view` is the section of view_rows(); `subject`
/// names the problem in the caption ("plane, ring").
Image render_view(const Snapshot& snapshot, const Values& view, int width, int height,
                  const std::string& subject = {}, const ImageOptions& options = {});

/// The same in two parts, of which the long one may be on another thread.
class PreparedImage {
  public:
    /// Lays it out, on the thread of the ImGui context that is current, if any, which has to destroy it, too.
    PreparedImage(const Snapshot& snapshot, const Values& view, int width, int height,
                  const std::string& subject, const ImageOptions& options = {});
    ~PreparedImage();
    PreparedImage(const PreparedImage&) = delete;
    PreparedImage& operator=(const PreparedImage&) = delete;

    /// Draws it, once, on any thread. `drawn` is called with the fraction that is done.
    Image draw(const std::function<void(double)>& drawn = {}) const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

Image render_plot(const Plot& plot, int width, int height, const ImageOptions& options = {});

/// One mesh of a figure.
struct MeshPanel {
    std::string title;
    std::shared_ptr<const Snapshot> snapshot;
    std::string colour = "none"; ///< as view.color
    double blend = 1;
    std::string camera{}; ///< as view.camera
    std::string cut{};    ///< as view.cut
    bool lines = true;    ///< as view.lines
};
using Panel = std::variant<MeshPanel, Plot>;

/// Panels in rows of `columns`, each of the same size.
Image render_panels(const std::vector<Panel>& panels, int columns, int width, int height,
                    const ImageOptions& options = {.light = true});

} // namespace gaspard

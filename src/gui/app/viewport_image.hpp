// Images without a window: a viewport, a plot, or several of them side by side, drawn offscreen.
//
// Each call creates and releases an OpenGL context, unless it is given one. Throws MachineError
// if there is no OpenGL.
#pragma once

#include "core/base/parameter.hpp"
#include "core/io/image.hpp"
#include "core/session/snapshot.hpp"
#include "core/tessellate/background.hpp"
#include "core/tessellate/plot.hpp"
#include "gui/gl/offscreen.hpp"

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
};

/// What a viewport of the window would show of `snapshot`. `view` is the section of view_rows(); `subject`
/// names the problem in the caption ("plane, ring").
Image render_view(const Snapshot& snapshot, const Values& view, int width, int height,
                  const std::string& subject = {}, const ImageOptions& options = {});

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

#include "gui/app/whole_window.hpp"

#include "gui/app/strips.hpp"
#include "gui/gl/imgui_context.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gaspard {

namespace {

/// 1 up to the default size of the window; a larger image has the same layout at a higher density.
float window_zoom(int width, int height) {
    return std::clamp(std::min(static_cast<float>(width) / 1400, static_cast<float>(height) / 900), 1.0F,
                      6.0F);
}

} // namespace

PixelRect pixels_of(const ItemRectangle& part, float density) {
    const auto pixels = [density](float units) { return static_cast<int>(std::lround(units * density)); };
    const int x = pixels(part.left), y = pixels(part.top);
    return {x, y, pixels(part.right) - x, pixels(part.bottom) - y};
}

void WindowImage::draw_meshes(const Application& application, const WindowPixels& pixels, float zoom,
                              RenderTarget& target) {
    const Theme& theme = application.window_state().theme;
    target.bind();
    gl_.Disable(GL_SCISSOR_TEST);
    gl_.ClearColor(theme.background.r, theme.background.g, theme.background.b, 1);
    gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const auto& views = application.views();
    for (const ShownView& shown : views) {
        // A mesh that several views show, as from front and rear, is uploaded once.
        const auto first = std::find_if(views.begin(), views.end(), [&](const ShownView& one) {
            return one.scene.physical == shown.scene.physical;
        });
        Camera camera = shown.camera;
        camera.scale /= static_cast<double>(pixels.density);
        std::optional<StripView> part{{camera, pixels_of(shown.rectangle, pixels.density)}};
        if (pixels.top) part = in_strip(part->camera, part->area, {*pixels.top, pixels.height});
        if (part)
            meshes_.at(static_cast<std::size_t>(first - views.begin()))
                .draw(shown.scene, part->camera, part->area, pixels.height, theme, zoom * pixels.density);
    }
}

/// Whether both have the same views, which show other iterates.
bool WindowImage::only_moved(const Below& drawn, const Below& wanted) {
    return drawn.theme == wanted.theme && drawn.density == wanted.density && drawn.zoom == wanted.zoom &&
           drawn.top == wanted.top &&
           std::equal(drawn.views.begin(), drawn.views.end(), wanted.views.begin(), wanted.views.end(),
                      [](const ShownView& a, const ShownView& b) {
                          return a.camera == b.camera && a.rectangle == b.rectangle &&
                                 a.scene.mesh == b.scene.mesh && a.scene.blend == b.scene.blend;
                      });
}

WindowImage::Outcome WindowImage::draw(const Application& application, const WindowPixels& pixels, float zoom,
                                       const Drawing& drawing) {
    if (!whole_ || whole_->width() != pixels.width || whole_->height() != pixels.height) {
        below_.reset(), draft_.reset(), whole_.reset(), drawn_.reset();
        below_.emplace(gl_, pixels.width, pixels.height);
        whole_.emplace(gl_, pixels.width, pixels.height, 0); // text and panels need no multisampling
    }
    Below wanted{application.views(), application.window_state().theme_name, pixels.density, zoom,
                 pixels.top};
    const bool changed = drawn_ != wanted;
    const bool kept = changed && drawing.keep && drawn_ && only_moved(*drawn_, wanted);
    const bool anew = (changed && !kept) || (!changed && !full_ && drawing.finish);
    if (anew) {
        full_ = !drawing.quickly || !changed;
        if (!full_ && !draft_) draft_.emplace(gl_, pixels.width, pixels.height, 0);
        draw_meshes(application, pixels, zoom, full_ ? *below_ : *draft_);
        drawn_ = std::move(wanted);
    }
    whole_->copy(full_ ? *below_ : *draft_);
    whole_->bind();
    const ImDrawData& data = *ImGui::GetDrawData();
    interface_.draw(pixels.top ? in_strip(data, {*pixels.top, pixels.height}) : data);
    return {anew, full_ && !kept};
}

Image render_whole_window(std::shared_ptr<const Catalogue> catalogue, const FinishedRun& run, int width,
                          int height, const Settings& settings, OffscreenBackend backend) {
    const auto context = make_offscreen_context(backend);
    const Gl& gl = context->gl();
    const ImGuiSession session;
    Application application(std::move(catalogue), run, {.settings = settings});
    const float zoom = window_zoom(width, height) * application.window_state().text_size;
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
    io.MousePos = {-FLT_MAX, -FLT_MAX};
    load_font(*io.Fonts, application.window_state().theme, zoom, application.title());
    apply_theme(application.window_state().theme, zoom);
    application.set_scale(zoom);
    WindowImage image(gl);
    for (int frame = 0; frame < 3; ++frame) { // some sizes are known only in the frame after
        ImGui::NewFrame();
        application.frame();
        ImGui::Render();
    }
    const int rows = strip_height(width, height);
    return draw_in_strips(width, height, rows, [&](Strip strip) {
        image.draw(application, {width, rows, 1, strip.top}, zoom);
        return image.read();
    });
}

} // namespace gaspard

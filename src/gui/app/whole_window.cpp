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

MeshesToDraw meshes_to_draw(const Application& application, const WindowPixels& pixels, float zoom) {
    const auto& views = application.views();
    return {views, application.window_state().theme, pixels, zoom, area_of_views(views, pixels)};
}

void WindowImage::resize(int width, int height, Colour ground) {
    if (below_ && below_->width() == width && below_->height() == height && ground == ground_) return;
    std::optional<Image> before;
    if (below_ && ground == ground_) before = below_->read(); // until there are meshes of the new size
    ground_ = ground;
    below_.emplace(gl_, width, height, 0); // text and panels need no multisampling
    whole_.emplace(gl_, width, height, 0);
    meshes_ = {};
    clear_below();
    if (before) below_->put(*before, 0, 0);
}

void WindowImage::clear_below() {
    below_->bind();
    gl_.Disable(GL_SCISSOR_TEST);
    gl_.ClearColor(ground_.r, ground_.g, ground_.b, 1);
    gl_.Clear(GL_COLOR_BUFFER_BIT);
    draw_all_anew();
}

void WindowImage::draw_all_anew() {
    if (whole_) changed_ = {0, 0, whole_->width(), whole_->height()};
}

void WindowImage::make_place_for(PixelRect meshes) {
    if (meshes != meshes_) clear_below();
    meshes_ = meshes;
    changed_ = around(changed_, meshes);
}

void WindowImage::take(const MeshImage& meshes, PixelRect area) {
    make_place_for(area);
    below_->put(meshes.image(), area.x, area.y);
}

void WindowImage::take(const PaintedMeshes& meshes) {
    make_place_for(meshes.what.area);
    below_->put(meshes.image, meshes.what.area.x, meshes.what.area.y);
}

void WindowImage::forget_meshes() {
    meshes_ = {};
    clear_below();
}

bool WindowImage::draw(const WindowPixels& pixels) {
    const ImDrawData& data = *ImGui::GetDrawData();
    const PixelRect part = around(changes_.follow(data), std::exchange(changed_, {}));
    if (part.empty()) return false;
    whole_->copy(*below_, part);
    whole_->bind();
    if (pixels.top)
        interface_.draw(in_strip(data, {*pixels.top, pixels.height}));
    else
        interface_.draw(data, part);
    return true;
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
    MeshImage meshes(gl);
    WindowImage image(gl);
    for (int frame = 0; frame < 3; ++frame) { // some sizes are known only in the frame after
        ImGui::NewFrame();
        application.frame();
        ImGui::Render();
    }
    const int rows = strip_height(width, height);
    return draw_in_strips(width, height, rows, [&](Strip strip) {
        WindowPixels pixels{width, rows, 1};
        if (rows < height) pixels.top = strip.top;
        MeshesToDraw what = meshes_to_draw(application, pixels, zoom);
        if (pixels.top) what.area = {0, 0, width, rows};
        meshes.draw(what);
        image.resize(width, rows, what.theme.background);
        image.take(meshes, what.area);
        image.draw(pixels);
        return image.read();
    });
}

} // namespace gaspard

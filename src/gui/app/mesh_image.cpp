#include "gui/app/mesh_image.hpp"

#include "gui/app/strips.hpp"

#include <algorithm>
#include <cmath>

namespace gaspard {

PixelRect pixels_of(const ItemRectangle& part, float density) {
    const auto pixels = [density](float units) { return static_cast<int>(std::lround(units * density)); };
    const int x = pixels(part.left), y = pixels(part.top);
    return {x, y, pixels(part.right) - x, pixels(part.bottom) - y};
}

bool in_same_place(const MeshesToDraw& one, const MeshesToDraw& other) {
    const auto alike = [](const ShownView& a, const ShownView& b) {
        const Mesh &first = *a.scene.mesh, &second = *b.scene.mesh;
        return a.rectangle == b.rectangle && first.cell_count() == second.cell_count() &&
               first.space_dimension == second.space_dimension &&
               a.scene.projection.has_value() == b.scene.projection.has_value();
    };
    return one.theme == other.theme && one.pixels == other.pixels && one.zoom == other.zoom &&
           one.area == other.area &&
           std::equal(one.views.begin(), one.views.end(), other.views.begin(), other.views.end(), alike);
}

PixelRect area_of_views(const std::vector<ShownView>& views, const WindowPixels& pixels) {
    PixelRect area;
    for (const ShownView& shown : views) area = around(area, pixels_of(shown.rectangle, pixels.density));
    area = intersection(area, {0, 0, pixels.width, pixels.height});
    return area.empty() ? PixelRect{0, 0, 1, 1} : area;
}

bool MeshImage::draw(const MeshesToDraw& what, bool quickly, const std::function<bool()>& give_up) {
    const auto [x, y, width, height] = what.area;
    const float density = what.pixels.density;
    const auto need = [&](std::optional<RenderTarget>& target, int samples) -> RenderTarget& {
        if (!target || target->width() != width || target->height() != height)
            target.emplace(gl_, width, height, samples);
        return *target;
    };
    full_ = !quickly;
    const RenderTarget& target = quickly ? need(draft_, 0) : need(sampled_, image_samples);
    target.bind();
    gl_.Disable(GL_SCISSOR_TEST);
    gl_.ClearColor(what.theme.background.r, what.theme.background.g, what.theme.background.b, 1);
    gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (const ShownView& shown : what.views) {
        // A mesh that several views show, as from front and rear, is uploaded once.
        const auto first = std::find_if(what.views.begin(), what.views.end(), [&](const ShownView& one) {
            return one.scene.physical == shown.scene.physical;
        });
        Camera camera = shown.camera;
        camera.scale /= static_cast<double>(density);
        PixelRect place = pixels_of(shown.rectangle, density);
        place.x -= x;
        std::optional<StripView> part{{camera, place}};
        if (what.pixels.top)
            part = in_strip(camera, place, {*what.pixels.top, height});
        else
            part->area.y -= y;
        if (part && !meshes_.at(static_cast<std::size_t>(first - what.views.begin()))
                         .draw(shown.scene, part->camera, part->area, height, what.theme, what.zoom * density,
                               quickly, give_up))
            return false;
    }
    if (!quickly) need(resolved_, 0).copy(target);
    return true;
}

} // namespace gaspard

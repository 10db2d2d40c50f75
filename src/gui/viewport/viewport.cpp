#include "gui/viewport/viewport.hpp"

#include "core/session/report_columns.hpp"
#include "core/tessellate/ticks.hpp"
#include "gui/plot/plot_widget.hpp"
#include "gui/viewport/axes.hpp"
#include "gui/viewport/legend.hpp"
#include "gui/viewport/section_control.hpp"
#include "gui/viewport/viewport_text.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gaspard {

namespace {

constexpr float margin = viewport_margin, gap = viewport_gap;

float line_height() { return viewport_line_height(); }

Colour status_colour(RunStatus status, const Theme& theme) {
    switch (status) {
    case RunStatus::converged:
        return theme.good;
    case RunStatus::iteration_limit:
    case RunStatus::stalled:
    case RunStatus::interrupted:
        return theme.warning;
    case RunStatus::diverged:
    case RunStatus::tangled:
    case RunStatus::invalid_input:
    case RunStatus::failed:
        return theme.bad;
    case RunStatus::preparing:
    case RunStatus::running:
        break;
    }
    return theme.accent;
}

void draw_caption(ImDrawList& list, const ViewportPlan& plan, const Theme& theme, float scale) {
    const ScreenRect& rect = plan.rect;
    const auto lines = caption_lines(plan.text, rect.width() - 2 * margin * scale, scale);
    float y = rect.max.y - caption_height(plan.text, rect.width(), scale);
    list.AddRectFilled({rect.min.x, y}, rect.max, packed(theme.panel, 0.9F));
    y += gap * scale / 2;
    const Colour status = status_colour(plan.text.report.status, theme);
    for (const auto& line : lines) {
        float x = rect.min.x + margin * scale;
        for (const std::string& part : line) {
            const bool is_status = &line == &lines.back() && &part == &line.back() &&
                                   part == status_name(plan.text.report.status);
            const float top = y + (line_height() - ImGui::GetFontSize()) / 2;
            list.AddText({x, top}, packed(is_status ? status : theme.text), part.c_str());
            x += ImGui::CalcTextSize(part.c_str()).x + 4 * gap * scale;
        }
        y += line_height();
    }
}

void draw_title(ImDrawList& list, const std::string& title, ScreenRect rect, const Theme& theme,
                float scale) {
    if (title.empty()) return;
    const ImVec2 size = ImGui::CalcTextSize(title.c_str());
    const ImVec2 at{std::round((rect.min.x + rect.max.x - size.x) / 2), rect.min.y + margin * scale / 2};
    list.AddRectFilled({at.x - gap * scale, at.y - gap * scale / 3},
                       {at.x + size.x + gap * scale, at.y + size.y + gap * scale / 3},
                       packed(theme.background, 0.82F), 4 * scale);
    list.AddText(at, packed(theme.text), title.c_str());
}

/// Round a globe, whose limb may be as dark as what is behind it.
void draw_rim(ImDrawList& list, const PlannedView& shown, const Theme& theme, float scale) {
    const Pixel middle = to_pixel(shown.camera, shown.size(), pivot_of(shown.scene));
    list.PushClipRect(shown.rect.min, shown.rect.max, true);
    list.AddCircle(
        {shown.rect.min.x + static_cast<float>(middle.x), shown.rect.min.y + static_cast<float>(middle.y)},
        static_cast<float>(shown.scene.ball / shown.camera.scale), packed(theme.faint_text, 0.8F), 180,
        1.3F * scale);
    list.PopClipRect();
}

/// What is picked: a cell has an outline, a node a ring; dark on light on dark, to be seen on any colour.
void draw_mark(ImDrawList& list, const PlannedView& shown, const Pick& pick, const Theme& theme,
               float scale) {
    if (!faces_viewer(pick, shown.scene, shown.camera)) return;
    const auto on_screen = [&](Pixel p) {
        return ImVec2{shown.rect.min.x + static_cast<float>(p.x), shown.rect.min.y + static_cast<float>(p.y)};
    };
    const std::pair<float, Colour> strokes[] = {{5.0F, theme.background}, {2.2F, theme.accent}};
    list.PushClipRect(shown.rect.min, shown.rect.max, true);
    if (pick.kind == Pick::Kind::node) {
        if (const auto at = middle_of(pick, shown.scene, shown.camera, shown.size()))
            for (const auto& [width, colour] : strokes)
                list.AddCircle(on_screen(*at), 7 * scale, packed(colour), 32, width * scale);
        list.PopClipRect();
        return;
    }
    const auto sides = outline_of(shown.scene, shown.camera, shown.size(), pick.index);
    ImVec2 low{1e30F, 1e30F}, high{-1e30F, -1e30F};
    for (const auto& [width, colour] : strokes)
        for (const auto& [from, to] : sides) {
            const ImVec2 a = on_screen(from), b = on_screen(to);
            list.AddLine(a, b, packed(colour), width * scale);
            for (const ImVec2 p : {a, b}) {
                list.AddCircleFilled(p, width * scale / 2, packed(colour), 12);
                low = {std::min(low.x, p.x), std::min(low.y, p.y)};
                high = {std::max(high.x, p.x), std::max(high.y, p.y)};
            }
        }
    if (std::max(high.x - low.x, high.y - low.y) < 8 * scale && high.x >= low.x) // too small to be found
        for (const auto& [width, colour] : strokes)
            list.AddCircle({(low.x + high.x) / 2, (low.y + high.y) / 2}, 10 * scale, packed(colour), 32,
                           width * scale);
    list.PopClipRect();
}

/// The corner of the viewport in which the card hides least of the picked cell or node.
ImVec2 card_corner(const ViewportPlan& plan, ImVec2 size, ScreenRect available, float scale) {
    const float away = margin * scale;
    const ImVec2 first{available.min.x + away, available.min.y + away};
    for (const ImVec2 corner : {first, ImVec2{first.x, available.max.y - away - size.y}}) {
        const bool hides = std::any_of(plan.views.begin(), plan.views.end(), [&](const auto& shown) {
            const auto at = middle_of(*plan.pick, shown.scene, shown.camera, shown.size());
            if (!at) return false;
            const float x = shown.rect.min.x + static_cast<float>(at->x) - corner.x,
                        y = shown.rect.min.y + static_cast<float>(at->y) - corner.y;
            return x > -away && y > -away && x < size.x + away && y < size.y + away;
        });
        if (!hides) return corner;
    }
    return first;
}

void draw_card(ImDrawList& list, const ViewportPlan& plan, ScreenRect available, const Theme& theme,
               float scale) {
    float names = 0, values = 0;
    for (const auto& [name, value] : plan.facts) {
        const float width = ImGui::CalcTextSize(value.c_str()).x;
        if (!name.empty()) names = std::max(names, ImGui::CalcTextSize(name.c_str()).x);
        values = std::max(values, width);
    }
    const float pad = 10 * scale, line = line_height(), between = 10 * scale;
    const ImVec2 size{names + between + values + 2 * pad,
                      line * static_cast<float>(plan.facts.size()) + 2 * pad - line / 4};
    const ImVec2 low = card_corner(plan, size, available, scale), high{low.x + size.x, low.y + size.y};
    list.AddRectFilled(low, high, packed(theme.panel, 0.94F), 6 * scale);
    list.AddRect(low, high, packed(theme.border), 6 * scale, 0, scale);
    float y = low.y + pad;
    for (const auto& [name, value] : plan.facts) {
        const bool title = name.empty();
        if (!title) list.AddText({low.x + pad, y}, packed(theme.faint_text), name.c_str());
        list.AddText({low.x + pad + (title ? 0 : names + between), y},
                     packed(title ? theme.accent : theme.text), value.c_str());
        y += line;
    }
}

void draw_complaint(ImDrawList& list, const std::string& text, ScreenRect available, const Theme& theme,
                    float scale) {
    const float width = std::max(1.0F, available.width() - 4 * margin * scale);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, width);
    const ImVec2 low{available.min.x + margin * scale, available.max.y - size.y - 3 * margin * scale};
    list.AddRectFilled(low, {low.x + size.x + 2 * margin * scale, low.y + size.y + margin * scale},
                       packed(theme.panel, 0.94F), 6 * scale);
    list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {low.x + margin * scale, low.y + margin * scale / 2},
                 packed(theme.bad), text.c_str(), nullptr, width);
}

} // namespace

/// How many of the tangled cells of a ball all turn away from the viewer.
static std::size_t hidden_tangled(const PlannedView& shown) {
    const MeshScene& scene = shown.scene;
    if (scene.ball == 0) return 0;
    const Tessellation& t = *scene.tessellation;
    const Vec3 viewer = towards_viewer(shown.camera);
    std::vector<char> seen(scene.tangled->back() + std::size_t{1}, 0);
    for (std::size_t i = 0; i < t.triangle_cells.size(); ++i) {
        const std::uint32_t cell = t.triangle_cells[i];
        if (cell >= seen.size() || seen[cell] != 0) continue;
        for (std::size_t k = 0; k < 3; ++k)
            if (dot(shown_point(scene, t.triangles[3 * i + k]), viewer) > 0) seen[cell] = 1;
    }
    std::size_t hidden = 0;
    for (const std::uint32_t cell : *scene.tangled) hidden += seen[cell] == 0 ? 1 : 0;
    return hidden;
}

/// One line in the lower right corner, above those that are there: a colour and what it means.
static void draw_note(ImDrawList& list, ScreenRect& available, Colour colour, bool line,
                      const std::string& text, const Theme& theme, float scale) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const float pad = 7 * scale, swatch = size.y * 0.8F, thick = line ? 2 * scale : swatch;
    const ImVec2 high{available.max.x - pad, available.max.y - pad};
    const ImVec2 low{high.x - size.x - swatch - 3 * pad, high.y - size.y - 2 * pad};
    list.AddRectFilled(low, high, packed(theme.panel, 0.92F), 4 * scale);
    const float top = (low.y + high.y - thick) / 2;
    list.AddRectFilled({low.x + pad, top}, {low.x + pad + swatch, top + thick}, packed(colour));
    list.AddText({low.x + 2 * pad + swatch, low.y + pad}, packed(theme.text), text.c_str());
    available.max.y = low.y;
}

/// What colours mean that are in no legend.
static void draw_notes(ImDrawList& list, const ViewportPlan& plan, ScreenRect available, const Theme& theme,
                       float scale) {
    const MeshScene& scene = plan.views.back().scene;
    if (scene.tangled != nullptr) {
        const std::size_t count = scene.tangled->size();
        std::string text = std::to_string(count) + (count == 1 ? " tangled cell" : " tangled cells");
        const std::size_t hidden = plan.views.size() == 1 ? hidden_tangled(plan.views.front()) : 0;
        if (hidden == count)
            text += count == 1 ? ", on the far side" : ", all on the far side";
        else if (hidden > 0)
            text += ", " + std::to_string(hidden) + " of them on the far side";
        draw_note(list, available, theme.tangled, false, text, theme, scale);
    }
    if (scene.overlay != nullptr) draw_note(list, available, theme.overlay, true, "exact mesh", theme, scale);
}

/// A projected line through places at longitudes (from the centre) and latitudes in degrees.
static std::vector<Vec3> projected_line(const MapProjection& projection, auto&& longitude_and_latitude) {
    constexpr int pieces = 72;
    constexpr double degree = std::numbers::pi / 180, inside = 1 - 1e-9; // of the cut, which is two lines
    std::vector<Vec3> line;
    for (int i = 0; i <= pieces; ++i) {
        const auto [east, north] = longitude_and_latitude(static_cast<double>(i) / pieces);
        const double l = projection.longitude + inside * east * degree, p = north * degree;
        line.push_back(
            to_map(projection, {std::cos(p) * std::cos(l), std::cos(p) * std::sin(l), std::sin(p)}));
    }
    return line;
}

/// Every thirty degrees, whole ones of longitude, wherever the centre is.
static std::vector<std::vector<Vec3>> graticule_lines(const MapProjection& projection) {
    std::vector<std::vector<Vec3>> lines;
    const double middle = projection.longitude * 180 / std::numbers::pi;
    for (double north = -60; north <= 60; north += 30)
        lines.push_back(
            projected_line(projection, [&](double t) { return std::pair(360 * t - 180, north); }));
    for (double longitude = -180; longitude < 180; longitude += 30) {
        const double east = std::remainder(longitude - middle, 360);
        lines.push_back(projected_line(projection, [&](double t) { return std::pair(east, 180 * t - 90); }));
    }
    return lines;
}

/// The projection's outline, longitudes and latitudes, and degrees beside them.
static void draw_graticule(ImDrawList& list, const PlannedView& shown, const Theme& theme, float scale) {
    const MapProjection& projection = *shown.scene.projection;
    const auto on_screen = [&](Vec3 place) {
        const Pixel p = to_pixel(shown.camera, shown.size(), place);
        return ImVec2{shown.rect.min.x + static_cast<float>(p.x), shown.rect.min.y + static_cast<float>(p.y)};
    };
    std::vector<ImVec2> outline;
    for (const Vec3 place : map_outline(projection)) outline.push_back(on_screen(place));
    const auto draw = [&](Colour ink, float opacity, float width) {
        list.AddPolyline(outline.data(), static_cast<int>(outline.size()), packed(ink, opacity),
                         ImDrawFlags_Closed, width * scale);
    };
    list.PushClipRect(shown.rect.min, shown.rect.max, true);
    for (const auto& line : graticule_lines(projection)) {
        std::vector<ImVec2> points;
        for (const Vec3 place : line) points.push_back(on_screen(place));
        list.AddPolyline(points.data(), static_cast<int>(points.size()), packed(theme.accent, 0.4F), 0,
                         scale);
    }
    draw(theme.background, 1, 4);
    draw(theme.text, 0.85F, 1.6F);
    for (const double latitude : {-60.0, -30.0, 0.0, 30.0, 60.0}) {
        const double radians = latitude * std::numbers::pi / 180,
                     cut = projection.longitude + std::numbers::pi;
        Vec3 place = to_map(projection, {std::cos(radians) * std::cos(cut), std::cos(radians) * std::sin(cut),
                                         std::sin(radians)});
        place.x = -std::abs(place.x);
        std::string text = short_number(std::abs(latitude), 3) + "°";
        if (latitude != 0) text += latitude > 0 ? " N" : " S";
        const ImVec2 at = on_screen(place), size = ImGui::CalcTextSize(text.c_str());
        list.AddText(
            {at.x - size.x - 8 * scale, at.y - size.y / 2 - static_cast<float>(latitude / 60) * size.y / 2},
            packed(theme.faint_text), text.c_str());
    }
    list.PopClipRect();
}

void draw_viewport_plots(ImDrawList& list, const ViewportPlan& plan, const Theme& theme, float scale) {
    for (const PlannedPlot& plot : plan.plots) draw_plot(list, plot.view, plot.rect, plot.zoom, theme, scale);
}

/// What the legend may take a part of.
static ScreenRect beside_legend(const ViewportPlan& plan, float scale) {
    ScreenRect available = above_caption(plan, scale);
    available.min.y += title_height(plan.text.title, scale);
    return available;
}

std::optional<LegendPlaces> legend_of(const ViewportPlan& plan, float scale) {
    if (!plan.colouring || plan.views.empty()) return std::nullopt;
    return legend_places(*plan.colouring, plan.histogram, beside_legend(plan, scale), scale);
}

void draw_viewport_overlay(ImDrawList& list, const ViewportPlan& plan, const Theme& theme, float scale) {
    list.PushClipRect(plan.rect.min, plan.rect.max, true);
    ScreenRect available = above_caption(plan, scale);
    const auto legend = legend_of(plan, scale);
    for (const PlannedView& shown : plan.views) {
        ScreenRect pane = shown.rect;
        pane.max.y = std::min(pane.max.y, available.max.y);
        draw_axes(list, shown, pane, legend ? std::optional(legend->all) : std::nullopt, theme, scale);
        if (shown.scene.projection) draw_graticule(list, shown, theme, scale);
        if (shown.scene.ball > 0 && shown.scene.mesh->kind.order > 1) // straight cells have none
            draw_rim(list, shown, theme, scale);
        if (plan.section) draw_section_line(list, shown, *plan.section, theme, scale);
        if (plan.pick && has(*shown.scene.mesh, *plan.pick)) draw_mark(list, shown, *plan.pick, theme, scale);
        draw_title(list, shown.title, shown.rect, theme, scale);
    }
    for (const PlannedView& shown : plan.views) { // lines between them
        const ScreenRect& r = shown.rect;
        if (r.min.x > plan.views[0].rect.min.x)
            list.AddRectFilled(r.min, {r.min.x + 1, r.max.y}, packed(theme.border));
        if (r.min.y > plan.views[0].rect.min.y)
            list.AddRectFilled(r.min, {r.max.x, r.min.y + 1}, packed(theme.border));
    }
    if (!plan.views.empty()) {
        if (plan.colouring)
            draw_legend(list, *plan.colouring, plan.histogram, plan.counts, beside_legend(plan, scale), theme,
                        scale);
        if (plan.text.notes) draw_notes(list, plan, available, theme, scale);
    }
    if (plan.text.caption) draw_caption(list, plan, theme, scale);
    if (!plan.facts.empty()) {
        ScreenRect below_title = available;
        below_title.min.y += title_height(plan.views.front().title, scale) / 2;
        draw_card(list, plan, below_title, theme, scale);
    }
    if (!plan.complaint.empty()) draw_complaint(list, plan.complaint, available, theme, scale);
    list.PopClipRect();
}

} // namespace gaspard

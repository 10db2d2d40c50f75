#include "gui/viewport.hpp"

#include "core/base/error.hpp"
#include "core/tessellate/ticks.hpp"
#include "gui/arrows.hpp"
#include "gui/legend.hpp"

#include <algorithm>
#include <cmath>

namespace gaspard {

namespace {

// At scale 1.
constexpr float margin = 14, gap = 6;
constexpr double arrow_spacing = 26;

float line_height() { return ImGui::GetFontSize() * 1.35F; }

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
    case RunStatus::failed:
        return theme.bad;
    case RunStatus::preparing:
    case RunStatus::running:
        break;
    }
    return theme.accent;
}

/// Parts of the caption, so many to a line as fit.
std::vector<std::vector<std::string>> caption_lines(const ViewportText& text, float width, float scale) {
    std::vector<std::vector<std::string>> lines;
    float used = width + 1;
    for (auto& part : caption_parts(text)) {
        const float need = ImGui::CalcTextSize(part.c_str()).x + 4 * gap * scale;
        if (used + need > width) {
            lines.emplace_back();
            used = 0;
        }
        used += need;
        lines.back().push_back(std::move(part));
    }
    return lines;
}

float caption_height(const ViewportText& text, float width, float scale) {
    if (!text.caption) return 0;
    const auto lines = caption_lines(text, width - 2 * margin * scale, scale);
    return std::round(line_height() * static_cast<float>(lines.size()) + gap * scale);
}

float title_height(const std::string& title, float scale) {
    return title.empty() ? 0 : line_height() + margin * scale;
}

/// What the caption leaves.
ScreenRect above_caption(const ViewportPlan& plan, float scale) {
    ScreenRect room = plan.rect;
    room.max.y -= caption_height(plan.text, room.width(), scale);
    return room;
}

/// What to keep the mesh clear of in a picture that fills the viewport.
Insets insets_of(const ViewportPlan& plan, const MeshPicture& picture, float scale) {
    Insets insets;
    const ScreenRect rect = plan.rect;
    insets.top = static_cast<double>(title_height(plan.text.title, scale));
    insets.bottom = static_cast<double>(caption_height(plan.text, rect.width(), scale));
    if (picture.colouring != nullptr)
        insets.right = static_cast<double>(legend_width(*picture.colouring, plan.histogram, scale));
    // Where the legend's strip is free anyway beside a centred mesh, the mesh stays centred.
    const double free_side =
        (static_cast<double>(rect.width() - rect.height()) + insets.top + insets.bottom) / 2;
    if (free_side > insets.right) insets.left = insets.right;
    return insets;
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
            const bool is_status = &line == &lines.back() && &part == &line.back();
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

/// What is picked: a cell has an outline, a node a ring; dark on light on dark, to be seen on any colour.
void draw_mark(ImDrawList& list, const PlannedPicture& shown, const Pick& pick, const Theme& theme,
               float scale) {
    const auto on_screen = [&](Pixel p) {
        return ImVec2{shown.rect.min.x + static_cast<float>(p.x), shown.rect.min.y + static_cast<float>(p.y)};
    };
    const std::pair<float, Colour> strokes[] = {{5.0F, theme.background}, {2.2F, theme.accent}};
    list.PushClipRect(shown.rect.min, shown.rect.max, true);
    if (pick.kind == Pick::Kind::node) {
        if (const auto at = middle_of(pick, shown.picture, shown.camera, shown.size()))
            for (const auto& [width, colour] : strokes)
                list.AddCircle(on_screen(*at), 7 * scale, packed(colour), 32, width * scale);
        list.PopClipRect();
        return;
    }
    const auto sides = outline_of(shown.picture, shown.camera, shown.size(), pick.index);
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

/// The corner of the room where the card hides least of what it speaks of.
ImVec2 card_corner(const ViewportPlan& plan, ImVec2 size, ScreenRect room, float scale) {
    const float away = margin * scale;
    const ImVec2 first{room.min.x + away, room.min.y + away};
    for (const ImVec2 corner : {first, ImVec2{first.x, room.max.y - away - size.y}}) {
        const bool hides = std::any_of(plan.pictures.begin(), plan.pictures.end(), [&](const auto& shown) {
            const auto at = middle_of(*plan.pick, shown.picture, shown.camera, shown.size());
            if (!at) return false;
            const float x = shown.rect.min.x + static_cast<float>(at->x) - corner.x,
                        y = shown.rect.min.y + static_cast<float>(at->y) - corner.y;
            return x > -away && y > -away && x < size.x + away && y < size.y + away;
        });
        if (!hides) return corner;
    }
    return first;
}

void draw_card(ImDrawList& list, const ViewportPlan& plan, ScreenRect room, const Theme& theme, float scale) {
    float names = 0, values = 0;
    for (const auto& [name, value] : plan.facts) {
        const float width = ImGui::CalcTextSize(value.c_str()).x;
        if (!name.empty()) names = std::max(names, ImGui::CalcTextSize(name.c_str()).x);
        values = std::max(values, width);
    }
    const float pad = 10 * scale, line = line_height(), between = 10 * scale;
    const ImVec2 size{names + between + values + 2 * pad,
                      line * static_cast<float>(plan.facts.size()) + 2 * pad - line / 4};
    const ImVec2 low = card_corner(plan, size, room, scale), high{low.x + size.x, low.y + size.y};
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

void draw_complaint(ImDrawList& list, const std::string& text, ScreenRect room, const Theme& theme,
                    float scale) {
    const float width = std::max(1.0F, room.width() - 4 * margin * scale);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, width);
    const ImVec2 low{room.min.x + margin * scale, room.max.y - size.y - 3 * margin * scale};
    list.AddRectFilled(low, {low.x + size.x + 2 * margin * scale, low.y + size.y + margin * scale},
                       packed(theme.panel, 0.94F), 6 * scale);
    list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {low.x + margin * scale, low.y + margin * scale / 2},
                 packed(theme.bad), text.c_str(), nullptr, width);
}

std::string blend_title(double blend) {
    if (blend == 1) return "physical";
    return "t = " + short_number(blend, 3);
}

} // namespace

std::vector<std::string> caption_parts(const ViewportText& text) {
    std::vector<std::string> parts;
    const StepReport& report = text.report;
    if (!text.subject.empty()) parts.push_back(text.subject);
    parts.push_back("iteration " + std::to_string(report.iteration));
    parts.push_back("residual " + short_number(report.residual, 3));
    if (report.equidistribution)
        parts.push_back("equidistribution " + short_number(*report.equidistribution, 4));
    if (report.tangled_cells.value_or(0) > 0)
        parts.push_back(std::to_string(*report.tangled_cells) +
                        (*report.tangled_cells == 1 ? " tangled cell" : " tangled cells"));
    parts.emplace_back(status_name(report.status));
    return parts;
}

/// What the colour of tangled cells means, in the lower right corner.
static void draw_tangled_note(ImDrawList& list, const ViewportPlan& plan, ScreenRect room, const Theme& theme,
                              float scale) {
    const auto& tangled = plan.pictures.front().picture.tangled;
    if (tangled == nullptr) return;
    const std::string text =
        std::to_string(tangled->size()) + (tangled->size() == 1 ? " tangled cell" : " tangled cells");
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const float pad = 7 * scale, swatch = size.y * 0.8F;
    const ImVec2 high{room.max.x - pad, room.max.y - pad};
    const ImVec2 low{high.x - size.x - swatch - 3 * pad, high.y - size.y - 2 * pad};
    list.AddRectFilled(low, high, packed(theme.panel, 0.92F), 4 * scale);
    const float top = (low.y + high.y - swatch) / 2;
    list.AddRectFilled({low.x + pad, top}, {low.x + pad + swatch, top + swatch}, packed(theme.tangled));
    list.AddText({low.x + 2 * pad + swatch, low.y + pad}, packed(theme.text), text.c_str());
}

Camera ViewportPlanner::camera_of(const MeshPicture& picture, const Values& view, Size size, Insets insets,
                                  std::string& complaint) {
    try {
        if (const std::string& text = view.text("camera"); !text.empty()) return parse_camera(text, size);
    } catch (const InputError& error) {
        complaint = error.what();
    }
    const std::string& direction = view.text("direction");
    if (home_.of == picture.tessellation && home_.size == size && home_.insets == insets &&
        home_.direction == direction)
        return home_.camera;
    home_ = {picture.tessellation, size, insets, direction, home(picture.home_box, size, insets, direction)};
    if (!picture.planar()) {
        home_.camera.centre = picture.home_box.centre();
        std::vector<const Points*> points{picture.computational.get()};
        if (!picture.burst) points.push_back(picture.physical.get());
        fit_points(home_.camera, points, size, insets);
    }
    return home_.camera;
}

void ViewportPlanner::place_pictures(const MeshPicture& picture, const Values& view, ViewportPlan& plan,
                                     float scale) {
    const auto size_of = [](ScreenRect rect) {
        return Size{std::max(1.0, static_cast<double>(rect.width())),
                    std::max(1.0, static_cast<double>(rect.height()))};
    };
    if (view.text("layout") == "single") {
        const Camera camera =
            camera_of(picture, view, size_of(plan.rect), insets_of(plan, picture, scale), plan.complaint);
        plan.pictures = {{picture, camera, plan.rect, plan.text.title}};
        return;
    }
    // Two of the same size; the legend has a strip of its own.
    ScreenRect room = above_caption(plan, scale);
    if (picture.colouring != nullptr)
        room.max.x -= std::round(legend_width(*picture.colouring, plan.histogram, scale));
    const bool beside = room.width() >= room.height();
    const float half = std::floor((beside ? room.width() : room.height()) / 2);
    ScreenRect first = room, second = room;
    (beside ? first.max.x : first.max.y) = (beside ? room.min.x : room.min.y) + half;
    (beside ? second.min.x : second.min.y) = (beside ? first.max.x : first.max.y);
    (beside ? second.max.x : second.max.y) = (beside ? second.min.x : second.min.y) + half;
    PlannedPicture left{picture, {}, first, "computational"};
    left.picture.blend = 0;
    const Insets insets{.top = static_cast<double>(title_height(left.title, scale))};
    left.camera = camera_of(picture, view, size_of(first), insets, plan.complaint);
    plan.pictures = {left, {picture, left.camera, second, blend_title(picture.blend)}};
}

void ViewportPlanner::add_arrows(ViewportPlan& plan, float scale) {
    for (PlannedPicture& shown : plan.pictures) {
        const Size size = shown.size();
        const double spacing = arrow_spacing * static_cast<double>(scale);
        if (arrows_.of != shown.picture.tessellation || !(arrows_.camera == shown.camera) ||
            arrows_.width != size.width || arrows_.height != size.height || arrows_.spacing != spacing)
            arrows_ = {shown.picture.tessellation,
                       shown.camera,
                       size.width,
                       size.height,
                       spacing,
                       std::make_shared<const std::vector<std::uint32_t>>(
                           points_with_arrows(shown.picture, shown.camera, size, spacing))};
        shown.picture.arrows = arrows_.points;
    }
}

void ViewportPlanner::add_pick(const Snapshot& snapshot, const Values& view, ViewportPlan& plan) {
    try {
        plan.pick = parse_pick(view.text("pick"));
    } catch (const InputError& error) {
        plan.complaint = error.what();
    }
    if (!plan.pick) return;
    if (!has(*snapshot.mesh, *plan.pick)) {
        plan.pick.reset();
        return;
    }
    if (facts_.mesh != snapshot.mesh || facts_.version != snapshot.version || facts_.pick != plan.pick)
        facts_ = {snapshot.mesh, snapshot.version, plan.pick, facts_of(*plan.pick, snapshot, maker_.cells())};
    plan.facts = facts_.facts;
}

ViewportPlan ViewportPlanner::plan(const Snapshot& snapshot, const Values& view, const ViewportText& text,
                                   ScreenRect rect, float scale) {
    const MeshPicture picture = maker_.make(snapshot, view);
    ViewportPlan plan;
    plan.rect = rect;
    plan.text = text;
    plan.histogram = view.boolean("histogram");
    place_pictures(picture, view, plan, scale);
    if (view.boolean("arrows")) add_arrows(plan, scale);
    add_pick(snapshot, view, plan);
    return plan;
}

void draw_viewport_overlay(ImDrawList& list, const ViewportPlan& plan, const Theme& theme, float scale) {
    list.PushClipRect(plan.rect.min, plan.rect.max, true);
    ScreenRect room = above_caption(plan, scale);
    for (const PlannedPicture& shown : plan.pictures) {
        if (plan.pick) draw_mark(list, shown, *plan.pick, theme, scale);
        draw_title(list, shown.title, shown.rect, theme, scale);
    }
    if (plan.pictures.size() > 1) {
        const ScreenRect& second = plan.pictures[1].rect;
        const bool beside = second.min.x > plan.pictures[0].rect.min.x;
        list.AddRectFilled(second.min,
                           beside ? ImVec2{second.min.x + 1, second.max.y}
                                  : ImVec2{second.max.x, second.min.y + 1},
                           packed(theme.border));
    }
    if (const auto& colouring = plan.pictures.front().picture.colouring) {
        ScreenRect legend = room;
        legend.min.y += title_height(plan.text.title, scale);
        draw_legend(list, *colouring, plan.histogram, legend, theme, scale);
    }
    draw_tangled_note(list, plan, room, theme, scale);
    if (plan.text.caption) draw_caption(list, plan, theme, scale);
    if (!plan.facts.empty()) {
        ScreenRect below_title = room;
        below_title.min.y += title_height(plan.pictures.front().title, scale) / 2;
        draw_card(list, plan, below_title, theme, scale);
    }
    if (!plan.complaint.empty()) draw_complaint(list, plan.complaint, room, theme, scale);
    list.PopClipRect();
}

void check_view(const Values& view, const Mesh* mesh) {
    if (!view.text("camera").empty()) parse_camera(view.text("camera"), {1, 1});
    const auto pick = parse_pick(view.text("pick"));
    if (pick && mesh != nullptr && !has(*mesh, *pick))
        throw InputError("view.pick = '" + view.text("pick") + "': the mesh has " +
                         (pick->kind == Pick::Kind::cell ? std::to_string(mesh->cell_count()) + " cells"
                                                         : std::to_string(mesh->node_count()) + " nodes") +
                         ", counted from 0");
    if (view.text("range") == "fixed" && !(view.real("low") < view.real("high")))
        throw InputError("view.low = " + format_number(view.real("low")) +
                         " must be below view.high = " + format_number(view.real("high")));
}

} // namespace gaspard

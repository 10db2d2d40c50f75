// How the application is drawn; what it does is in application.cpp.
#include "core/io/formats.hpp"
#include "core/scenario/toml.hpp"
#include "gui/app/application.hpp"
#include "gui/base/icons.hpp"
#include "gui/base/part_window.hpp"
#include "gui/panels/status_bar.hpp"

#include <algorithm>
#include <cmath>
#include <imgui.h>

namespace gaspard {

namespace {

constexpr const char* hint =
    "Drag to pan, turn the wheel to zoom, click a cell to know it, press H to see all. F1 shows all keys.";
constexpr const char* hint_in_space =
    "Drag to turn, turn the wheel to zoom, click a cell to know it, press F for the "
    "rear, H to see all. F1 shows all keys.";

/// Whether one camera does for both meshes.
bool look_alike(const DocumentRun& one, const DocumentRun& other) {
    return one.snapshot && other.snapshot &&
           one.snapshot->mesh->space_dimension == other.snapshot->mesh->space_dimension &&
           one.scenario.domain.type == other.scenario.domain.type;
}

Icon icon_of(ActionId id) {
    switch (id) {
    case ActionId::run_pause:
        return Icon::run;
    case ActionId::step:
        return Icon::step;
    case ActionId::reset:
        return Icon::reset;
    case ActionId::home:
        return Icon::home;
    case ActionId::screenshot:
        return Icon::image;
    case ActionId::export_files:
        return Icon::save;
    default:
        return Icon::none;
    }
}

} // namespace

void Application::frame() {
    items_.clear();
    // A button's own tooltip does not belong in the picture, so this frame does without the mouse; a slider
    // that is held would follow it.
    taking_screenshot_ = std::exchange(screenshot_, false);
    if (taking_screenshot_ && !ImGui::IsAnyItemActive()) ImGui::GetIO().MousePos = {-FLT_MAX, -FLT_MAX};
    if (viewed_theme() != theme_name()) follow_theme();
    draw_menus();
    arrange();
    const FrameContext context{theme_, scale_, items_};
    draw_toolbar();
    viewport_pane_.say_in_corner(note_has_room() ? method_note(run(), *catalogue_) : std::string());
    const bool with_handles = run().live() && !taking_screenshot_;
    std::vector<Handle> handles;
    if (with_handles) {
        handles = monitor_handles(run().scenario);
        if (run().snapshot)
            for (auto& one : control_handles(run().scenario, *run().snapshot))
                handles.push_back(std::move(one));
    }
    viewport_pane_.offer_handles(std::move(handles));
    std::vector<const DocumentRun*> others;
    for (const DocumentRun& other : document_.runs())
        if (&other != &run() && !other.hidden && look_alike(other, run())) others.push_back(&other);
    viewport_pane_.frame(run(), viewport(), layout_.viewport, context, others);
    if (const auto move = viewport_pane_.take_handle_move()) {
        if (!run().status.refused) message_ = {};
        document_.change_by_hand(0, with_handle_at(run().scenario, move->handle, move->place));
    }
    if (checked(ActionId::sidebar)) draw_sidebar();
    if (checked(ActionId::plots)) draw_plots(context);
    draw_edges();
    if (checked(ActionId::log)) draw_log();
    draw_remedy();
    draw_comparison();
    draw_status();
    draw_dialogs();
}

void Application::arrange() {
    const Values& window = settings_.window;
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const LayoutChoice choice{.sidebar = window.boolean("sidebar"),
                              .plots = window.boolean("plots"),
                              .log = window.boolean("log"),
                              .sidebar_width = static_cast<float>(window.real("sidebar_width")),
                              .plots_share = static_cast<float>(window.real("plots_share"))};
    layout_ = compute_layout(size.x, size.y, ImGui::GetFontSize(), ImGui::GetFrameHeight(), choice);
}

void Application::draw_menus() {
    if (!ImGui::BeginMainMenuBar()) return;
    for (const char* menu : {"File", "Solve", "View", "Help"}) {
        const bool open = ImGui::BeginMenu(menu);
        remember_item(items_, "menu." + std::string(menu));
        if (!open) continue;
        for (const Action& row : actions()) {
            if (row.menu != menu) continue;
            if (ImGui::MenuItem(label_of(row).c_str(), describe_keys(row).c_str(), checked(row.id),
                                possible(row.id)))
                perform(row.id);
            remember_item(items_, "menu." + std::string(row.name));
            if (row.id == ActionId::open) draw_recent();
            if (row.id == ActionId::export_files) draw_formats();
        }
        ImGui::EndMenu();
    }
    ImGui::EndMainMenuBar();
}

void Application::draw_recent() {
    if (!ImGui::BeginMenu("Open recent", !settings_.recent.empty())) return;
    for (std::size_t i = 0; i < settings_.recent.size(); ++i) {
        const std::string file = settings_.recent[i];
        if (ImGui::MenuItem(file.c_str())) open_file(file);
        remember_item(items_, "recent." + std::to_string(i));
    }
    ImGui::EndMenu();
}

void Application::draw_formats() {
    if (!ImGui::BeginMenu("Export as", run().live())) return;
    for (const Format& format : formats()) {
        if (ImGui::MenuItem(format.name.c_str(), nullptr, exports(run().scenario, format.name)))
            toggle_format(format.name);
        remember_item(items_, "format." + format.name);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", format.help.c_str());
    }
    ImGui::EndMenu();
}

void Application::draw_toolbar() {
    begin_part("##toolbar", layout_.toolbar);
    const float em = ImGui::GetFontSize();
    for (const Action& row : actions()) {
        if (!row.toolbar) continue;
        draw_button(row);
        const bool last_of_group = row.id == ActionId::reset || row.id == ActionId::home;
        ImGui::SameLine(0, last_of_group ? 1.6F * em : 0.5F * em);
    }
    draw_scenarios();
    ImGui::End();
}

void Application::draw_button(const Action& row) {
    const bool main = row.id == ActionId::run_pause;
    if (main) { // what one looks for first
        const ImVec4 accent = to_imgui(theme_.accent);
        ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(theme_.background));
        ImGui::PushStyleColor(ImGuiCol_Button, accent);
        ImGui::PushStyleColor(ImGuiCol_ButtonHovered, ImGui::GetStyleColorVec4(ImGuiCol_SliderGrabActive));
        ImGui::PushStyleColor(ImGuiCol_ButtonActive, accent);
    }
    ImGui::BeginDisabled(!possible(row.id));
    const std::string id = "##" + std::string(row.name);
    const Icon icon = main && run().solving() ? Icon::pause : icon_of(row.id);
    if (icon_button(id.c_str(), icon, label_of(row).c_str(), main ? 7.5F * ImGui::GetFontSize() : 0))
        perform(row.id);
    ImGui::EndDisabled();
    if (main) ImGui::PopStyleColor(4);
    remember_item(items_, "action." + std::string(row.name));
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("%.*s\nKey: %s", static_cast<int>(row.help.size()), row.help.data(),
                          describe_keys(row).c_str());
}

void Application::draw_scenarios() {
    const float em = ImGui::GetFontSize();
    const float right = ImGui::GetWindowContentRegionMax().x;
    ImGui::SameLine(std::max(ImGui::GetCursorPosX(), right - 19 * em));
    ImGui::SetNextItemWidth(std::max(4 * em, right - ImGui::GetCursorPosX()));
    const bool open = ImGui::BeginCombo("##scenario", run().title.c_str());
    remember_item(items_, "scenario");
    if (!open) return;
    if (shipped_.empty())
        for (const BuiltinScenario& one : builtin_scenarios())
            shipped_.push_back(find_scenario(*catalogue_, std::string(one.name)));
    float widest = 0;
    for (const Scenario& one : shipped_) widest = std::max(widest, ImGui::CalcTextSize(one.title.c_str()).x);
    for (const Scenario& one : shipped_) {
        const bool chosen = ImGui::Selectable(("##" + one.name).c_str(), run().scenario.name == one.name);
        remember_item(items_, "scenario=" + one.name);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", one.description.c_str());
        ImGui::SameLine(0, 0);
        ImGui::TextUnformatted(one.title.c_str());
        ImGui::SameLine(widest + 2 * em);
        ImGui::TextDisabled("%s", one.name.c_str());
        if (chosen) open_builtin(one.name);
    }
    if (!settings_.recent.empty()) ImGui::Separator();
    for (const std::string& file : std::vector(settings_.recent))
        if (ImGui::Selectable(file.c_str())) open_file(file);
    ImGui::EndCombo();
}

void Application::draw_sidebar() {
    begin_part("##sidebar", layout_.sidebar, ImGuiWindowFlags_None); // it may have to scroll
    Scenario scenario = run().scenario;
    const PanelContext context{*catalogue_, run().opened, theme_, items_, viewport_pane_.unavailable()};
    bool changed = false;
    for (const auto kind : {SectionKind::domain, SectionKind::monitor, SectionKind::method}) {
        if (ImGui::CollapsingHeader(section_title(kind), ImGuiTreeNodeFlags_DefaultOpen))
            changed |= panel_.draw_section(kind, context, scenario);
        ImGui::Spacing();
    }
    if (ImGui::CollapsingHeader("Runs", ImGuiTreeNodeFlags_DefaultOpen)) {
        if (run_list_.draw(document_, {theme_, scale_, items_})) perform(ActionId::keep);
        const Action& row = action(ActionId::compare);
        ImGui::SameLine();
        ImGui::BeginDisabled(!possible(row.id));
        if (ImGui::Button(std::string(row.label).c_str())) perform(row.id);
        ImGui::EndDisabled();
        remember_item(items_, "runs.compare");
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(row.help).c_str());
    }
    ImGui::Spacing();
    if (ImGui::CollapsingHeader("View", ImGuiTreeNodeFlags_DefaultOpen)) draw_view(context);
    if (scenario.domain != run().scenario.domain) viewport().view.set("pick", std::string());
    scenario.view = viewport().view;
    if (changed) {
        document_.change(0, scenario); // once per frame; of those that wait, the solver takes the newest
        message_ = {};
    }
    ImGui::End();
}

void Application::draw_view(const PanelContext& context) {
    Values& view = viewport().view;
    update_view_rows(*catalogue_, run().scenario.method.type, view);
    const bool was_fixed = view.text("range") == "fixed";
    std::vector<std::string> keys = {"blend", "color", "map", "log", "range"};
    if (was_fixed) keys.insert(keys.end(), {"low", "high"});
    for (const char* key : {"histogram", "lines", "arrows", "layout"}) keys.emplace_back(key);
    const bool map = view.text("layout") == "map" && available("layout=map");
    if (map) keys.insert(keys.end(), {"map_longitude", "map_camera"});
    if (!map) keys.emplace_back("camera");
    if (run().snapshot && run().snapshot->mesh->space_dimension == 3 && !map)
        keys.insert(keys.end(), {"direction", "spin"});
    if (run().snapshot && run().snapshot->mesh->space_dimension == 3) keys.emplace_back("overlay");
    panel_.draw_rows(context, run().opened.view, view, keys);
    if (!was_fixed && view.text("range") == "fixed") viewport_pane_.fix_range(viewport());
}

void Application::draw_plots(const FrameContext& context) {
    const auto wish = plot_pane_.frame(document_, layout_.first_plot, layout_.second_plot, context);
    if (wish) fulfil(*wish);
    const auto choices = plot_pane_.choices();
    settings_.window.set("first_plot", format_choice(choices[0]));
    settings_.window.set("second_plot", format_choice(choices[1]));
}

void Application::draw_edges() {
    const ItemRectangle& plots = layout_.plots_edge;
    const float right = ImGui::GetIO().DisplaySize.x, bottom = layout_.second_plot.bottom;
    if (checked(ActionId::sidebar))
        draw_edge("edge.sidebar", layout_.sidebar_edge, "sidebar_width", {true, 0, ImGui::GetFontSize()});
    if (checked(ActionId::plots) && layout_.plots_beside)
        draw_edge("edge.plots", plots, "plots_share", {true, right, layout_.sidebar.width() - right});
    else if (checked(ActionId::plots))
        draw_edge("edge.plots", plots, "plots_share", {false, bottom, layout_.viewport.top - bottom});
}

/// A strip that changes a setting as it is dragged.
void Application::draw_edge(const char* name, const ItemRectangle& edge, const char* setting,
                            const EdgeTravel& travel) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    begin_part(name, edge, ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar, true);
    ImGui::PopStyleVar(2);
    ImGui::InvisibleButton(name, {std::max(1.0F, edge.width()), std::max(1.0F, edge.height())});
    remember_item(items_, name);
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
        ImGui::SetMouseCursor(travel.across ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
        ImGui::GetWindowDrawList()->AddRectFilled({edge.left, edge.top}, {edge.right, edge.bottom},
                                                  packed(theme_.accent, 0.5F));
    }
    if (ImGui::IsItemActive() && travel.span != 0) {
        const ImVec2 pointer = ImGui::GetIO().MousePos;
        const double value =
            static_cast<double>(((travel.across ? pointer.x : pointer.y) - travel.zero) / travel.span);
        if (std::isfinite(value)) settings_.window.set(setting, within(settings_.window, setting, value));
    }
    ImGui::End();
}

/// Below the mesh; else what the method says stands in the bar along the window's edge.
bool Application::note_has_room() const { return layout_.viewport.height() > 26 * ImGui::GetFontSize(); }

void Application::draw_status() {
    begin_part("##status", layout_.status);
    const bool in_space = !views().empty() && !views().front().scene.planar();
    const std::string note = note_has_room() ? std::string() : method_note(run(), *catalogue_);
    const char* help = in_space ? hint_in_space : hint;
    draw_status_bar(run(), message_, note.empty() ? help : note, theme_, items_);
    ImGui::End();
}

/// Linear cells that have failed, and what would help, at the foot of the picture.
void Application::draw_remedy() {
    const std::string text = remedy_note(run());
    if (text.empty()) return;
    const float em = ImGui::GetFontSize();
    const ItemRectangle& available = layout_.viewport;
    const Action& row = action(ActionId::quadratic);
    const std::string label = std::string(row.label) + " (" + describe_keys(row) + ")";
    const float button = ImGui::CalcTextSize(label.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
    const float widest = std::max(12 * em, available.width() - 4 * em);
    const float wanted = ImGui::CalcTextSize(text.c_str()).x + button + 4 * em;
    const float width = std::min(wanted, widest);
    const float wrap = width - button - 3.4F * em;
    const float height = ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap).y + 1.6F * em;
    const float left = (available.left + available.right - width) / 2, bottom = available.bottom - 3.2F * em;
    begin_part("##remedy", {left, bottom - height, left + width, bottom}, ImGuiWindowFlags_NoScrollbar, true);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRectFullScreen();
    list.AddRect({left, bottom - height}, {left + width, bottom}, packed(theme_.warning), 0, 0,
                 1.5F * scale_);
    list.PopClipRect();
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + wrap);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::SetCursorPos({width - button - em, (height - ImGui::GetFrameHeight()) / 2});
    if (ImGui::Button(label.c_str())) perform(ActionId::quadratic);
    remember_item(items_, "remedy");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%.*s", static_cast<int>(row.help.size()), row.help.data());
    ImGui::End();
}

void Application::draw_log() {
    begin_part("##log", layout_.log);
    log_.draw(theme_, items_);
    ImGui::End();
}

void Application::draw_dialogs() {
    const SolverStatus& status = run().status;
    if (working()) {
        if (draw_progress(status.activity.empty() ? "preparing" : status.activity, status.progress,
                          layout_.viewport, items_))
            run().solver->cancel();
    } else if (document_.comparing() && !comparison_panel_.open()) {
        if (draw_progress("comparing methods", document_.comparison_progress(), layout_.viewport, items_))
            document_.cancel_comparison();
    }
    draw_help(help_, theme_);
    if (error_.open()) // two at once would close each other
        error_.draw(items_);
    else if (const auto path = open_dialog_.draw(settings_.recent, items_))
        open_file(*path);
}

} // namespace gaspard

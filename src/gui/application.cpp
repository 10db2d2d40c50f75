#include "gui/application.hpp"

#include "core/base/error.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/run_files.hpp"
#include "core/scenario/toml.hpp"
#include "gui/icons.hpp"
#include "gui/part_window.hpp"
#include "gui/runs_csv.hpp"
#include "gui/status_bar.hpp"

#include <algorithm>
#include <cmath>
#include <imgui.h>
#include <utility>

namespace gaspard {

namespace {

constexpr const char* hint =
    "Drag to pan, turn the wheel to zoom, double-click to see the whole mesh. F1 shows all keys.";

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
        return Icon::picture;
    case ActionId::export_files:
        return Icon::save;
    case ActionId::keep:
    case ActionId::help:
    case ActionId::quit:
        break;
    }
    return Icon::none;
}

} // namespace

Application::Application(std::shared_ptr<const Catalogue> catalogue, const Scenario& scenario,
                         const Theme& theme, std::function<void()> wake, std::filesystem::path output)
    : catalogue_(catalogue), output_(std::move(output)), board_(std::make_shared<NoticeBoard>(wake)),
      theme_(theme), pictures_(board_), document_(std::move(catalogue), std::move(wake)) {
    document_.open(scenario);
}

bool Application::collect() {
    bool news = document_.collect();
    for (Notice& notice : board_->take()) message_ = std::move(notice), news = true;
    const SolverStatus& status = run().status;
    if (status.messages != messages_seen_) message_ = {status.message, true};
    messages_seen_ = status.messages;
    return news;
}

void Application::frame() {
    items_.clear();
    // A button's own tooltip does not belong in the picture, so this frame does without the mouse; a slider
    // that is held would follow it.
    taking_screenshot_ = std::exchange(screenshot_, false);
    if (taking_screenshot_ && !ImGui::IsAnyItemActive()) ImGui::GetIO().MousePos = {-FLT_MAX, -FLT_MAX};
    draw_menus();
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    layout_ = compute_layout(size.x, size.y, ImGui::GetFontSize(), ImGui::GetFrameHeight());
    const FrameContext context{theme_, scale_, items_};
    draw_toolbar();
    viewport_pane_.frame(run(), viewport(), layout_.viewport, context);
    draw_sidebar();
    if (const auto wish = plot_pane_.frame(document_, layout_.residual, layout_.equidistribution, context))
        fulfil(*wish);
    draw_status();
    if (help_) draw_help();
}

bool Application::press_key(std::string_view key) {
    if (ImGui::GetIO().WantTextInput) return false;
    const Action* row = action_for_key(key);
    if (!row || !possible(row->id)) return false;
    perform(row->id);
    return true;
}

bool Application::possible(ActionId id) {
    if (id == ActionId::step) return !run().ended();
    return id != ActionId::keep || !run().history.empty();
}

void Application::perform(ActionId id) {
    message_ = {};
    switch (id) {
    case ActionId::run_pause:
        return toggle_running();
    case ActionId::step:
        return document_.step(0);
    case ActionId::reset:
        return document_.reset(0);
    case ActionId::keep:
        if (const auto kept = document_.keep(0))
            message_ = {"Kept as \"" + document_.runs()[*kept].name + "\"", false};
        return;
    case ActionId::home:
        viewport_pane_.go_home(viewport());
        return;
    case ActionId::screenshot:
        screenshot_ = true;
        return;
    case ActionId::export_files:
        return export_files();
    case ActionId::help:
        help_ = !help_;
        return;
    case ActionId::quit:
        quit_ = true;
        return;
    }
}

void Application::toggle_running() {
    if (run().solving())
        document_.pause(0);
    else
        document_.start(0);
}

std::filesystem::path Application::output_folder() { return output_ / run().scenario.name; }

void Application::export_files() {
    // The board is shared, for the task may come to its turn when the window is already closing.
    run().solver->post(
        InspectCommand{[board = board_, folder = output_folder(),
                        names = run().scenario.output.text("formats")](Run& solved, const Activity&) {
            report_outcome(*board, [&] {
                const auto formats = parse_formats(names);
                check_writable(folder);
                write_run_files(folder, solved, formats);
                return "Exported to " + folder.string();
            });
        }});
    message_ = {"Exporting ...", false};
}

void Application::save_picture(Image image) { pictures_.write(output_folder(), "view", std::move(image)); }

void Application::fulfil(const PlotWish& wish) {
    switch (wish.kind) {
    case PlotWish::Kind::copy_csv:
        ImGui::SetClipboardText(runs_csv(document_.runs()).c_str());
        message_ = {"Copied the numbers of all runs that are shown", false};
        return;
    case PlotWish::Kind::save_png:
        plot_picture_ = plot_of_runs(document_.runs(), wish.choice, wish.zoom);
        plot_name_ = name_of(wish.choice.quantity);
        return;
    }
}

void Application::save_plot(const std::function<Image(const Plot&)>& draw) {
    const auto plot = std::exchange(plot_picture_, std::nullopt);
    if (!plot) return;
    try {
        pictures_.write(output_folder(), plot_name_, draw(*plot));
    } catch (const MachineError& error) {
        message_ = {error.what(), true};
    }
}

void Application::open_scenario(const std::string& name) {
    try {
        document_.replace(0, find_scenario(*catalogue_, name));
        message_ = {};
        viewport_pane_.go_home(viewport());
    } catch (const InputError& error) {
        message_ = {error.what(), true};
    }
}

std::string Application::label_of(const Action& row) {
    if (row.id != ActionId::run_pause) return std::string(row.label);
    return run().solving() ? "Pause" : run().ended() ? "Run again" : std::string(row.label);
}

void Application::draw_menus() {
    if (!ImGui::BeginMainMenuBar()) return;
    for (const char* menu : {"File", "Solve", "View", "Help"}) {
        if (!ImGui::BeginMenu(menu)) continue;
        for (const Action& row : actions()) {
            if (row.menu != menu) continue;
            if (ImGui::MenuItem(label_of(row).c_str(), describe_keys(row).c_str(), false, possible(row.id)))
                perform(row.id);
            remember_item(items_, "menu." + std::string(row.name));
        }
        ImGui::EndMenu();
    }
    ImGui::EndMainMenuBar();
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
    for (const BuiltinScenario& one : builtin_scenarios()) {
        const std::string name(one.name);
        if (ImGui::Selectable(name.c_str(), run().scenario.name == name)) open_scenario(name);
        remember_item(items_, "scenario=" + name);
    }
    ImGui::EndCombo();
}

void Application::draw_sidebar() {
    begin_part("##sidebar", layout_.sidebar, ImGuiWindowFlags_None); // it may have to scroll
    Scenario scenario = run().scenario;
    const PanelContext context{*catalogue_, run().opened, theme_, items_};
    bool changed = false;
    for (const auto kind : {SectionKind::domain, SectionKind::monitor, SectionKind::method}) {
        if (ImGui::CollapsingHeader(section_title(kind), ImGuiTreeNodeFlags_DefaultOpen))
            changed |= panel_.draw_section(kind, context, scenario);
        ImGui::Spacing();
    }
    if (ImGui::CollapsingHeader("View", ImGuiTreeNodeFlags_DefaultOpen))
        panel_.draw_rows(context, run().opened.view, viewport().view, {"color", "blend"});
    ImGui::Spacing();
    if (ImGui::CollapsingHeader("Runs", ImGuiTreeNodeFlags_DefaultOpen))
        if (run_list_.draw(document_, {theme_, scale_, items_})) perform(ActionId::keep);
    scenario.view = viewport().view;
    if (changed) {
        document_.change(0, scenario); // once per frame; of those that wait, the solver takes the newest
        message_ = {};
    }
    ImGui::End();
}

void Application::draw_status() {
    begin_part("##status", layout_.status);
    draw_status_bar(run(), message_, hint, theme_, items_);
    ImGui::End();
}

void Application::draw_help() {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({size.x / 2, size.y / 2}, ImGuiCond_Appearing, {0.5F, 0.5F});
    if (ImGui::Begin("Keys and mouse", &help_,
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_AlwaysAutoResize)) {
        ImGui::PushStyleVar(ImGuiStyleVar_CellPadding,
                            {0.6F * ImGui::GetFontSize(), 0.25F * ImGui::GetFontSize()});
        if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
            const ImVec4 accent = to_imgui(theme_.accent);
            const auto line = [&](const std::string& what, std::string_view help) {
                ImGui::TableNextColumn();
                ImGui::TextColored(accent, "%s", what.c_str());
                ImGui::TableNextColumn();
                ImGui::TextUnformatted(help.data(), help.data() + help.size());
            };
            for (const Action& row : actions()) line(describe_keys(row), row.help);
            line("Drag the picture", "Pan, with the left or the middle button.");
            line("Wheel", "Zoom at the pointer.");
            line("Double-click", "Show the whole mesh again.");
            line("Ctrl+click a slider", "Type its value.");
            ImGui::EndTable();
        }
        ImGui::PopStyleVar();
    }
    ImGui::End();
}

} // namespace gaspard

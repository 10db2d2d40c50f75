#include "gui/app/file_dialogs.hpp"

#include "core/base/user_path.hpp"
#include "core/scenario/data_files.hpp"
#include "core/spline/solid_domain.hpp"
#include "core/spline/spline_domain.hpp"
#include "gui/app/file_kinds.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>
#include <utility>

namespace gaspard {

namespace {

/// The files that a value of the scenario can name.
std::vector<std::string_view> endings_for(const std::string& key, const Scenario& scenario) {
    if (key.starts_with("domain.")) {
        const std::string& type = scenario.domain.type;
        const bool splines = type == own_patch_domain || type == own_solid_domain;
        return endings_of(splines ? FileUse::patch : FileUse::mesh);
    }
    std::vector<std::string_view> endings = endings_of(FileUse::image);
    for (const std::string_view ending : endings_of(FileUse::field)) endings.push_back(ending);
    return endings;
}

} // namespace

void FileDialogs::ask_what_to_open(const Settings& settings) {
    purpose_ = Purpose::open;
    const std::filesystem::path last = settings.folders.empty() ? "." : settings.folders.front();
    browser_.show({.title = "Open",
                   .line = "Open " + what_opens() + "; you can also drop a file on the window.",
                   .endings = endings_of(),
                   .start = (std::filesystem::absolute(last).lexically_normal() / "").string()});
}

void FileDialogs::ask_for_value(const FileWish& wish, const Scenario& scenario) {
    purpose_ = Purpose::value;
    key_ = wish.key;
    std::string start;
    if (is_path(wish.present)) {
        std::filesystem::path file = wish.present; // with ~, as it is typed
        if (file.is_relative() && !wish.present.starts_with("~")) file = scenario.folder / file;
        start = (file.parent_path() / "").string();
    }
    browser_.show({.title = "Choose a file",
                   .line = "You can also drop the file on the window.",
                   .endings = endings_for(wish.key, scenario),
                   .start = start});
}

void FileDialogs::ask_where_to_save(const Scenario& scenario, const std::filesystem::path& file) {
    purpose_ = Purpose::save;
    to_save_ = {.file = {}, .title = scenario_title(scenario)};
    with_data_ = has_data_files(scenario);
    browser_.show({.mode = BrowseMode::save,
                   .keys = "save",
                   .title = "Save the scenario as",
                   .endings = endings_of(FileUse::scenario),
                   .start = file.string(),
                   .ending = ".toml"});
}

void FileDialogs::ask_what_to_export(const Scenario& scenario, bool splines,
                                     const std::filesystem::path& folder) {
    export_.show(scenario.output.text("formats"), splines, folder.string());
}

void FileDialogs::ask_how_to_draw(const Values& view, const std::filesystem::path& folder) {
    figure_.show(view, (folder / "figure").string());
}

void FileDialogs::ask_how_to_film(FilmSubject subject, const Values& view,
                                  const std::filesystem::path& folder) {
    film_.show(std::move(subject), view, (folder / "film").string());
}

void FileDialogs::close() {
    if (browser_.open())
        browser_.close();
    else if (figure_.open())
        figure_.close();
    else if (film_.open())
        film_.close();
    else
        export_.close();
}

/// True when Enter was pressed.
bool FileDialogs::draw_save_fields(ItemRectangles& items) {
    ImGui::TextUnformatted("Title:");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    const bool entered = ImGui::InputText("##title", &to_save_.title, ImGuiInputTextFlags_EnterReturnsTrue);
    remember_item(items, "save.title");
    if (with_data_) {
        ImGui::Checkbox("Pack the data into the file", &to_save_.packed);
        remember_item(items, "save.pack");
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip("The scenario then needs no other file; for data of at most %d MB.",
                              static_cast<int>(most_packed_data >> 20));
    }
    return entered;
}

FileAnswer FileDialogs::answer(const std::string& path) {
    if (purpose_ == Purpose::value) return FileOfValue{key_, path};
    if (purpose_ == Purpose::save) {
        to_save_.file = path;
        return to_save_;
    }
    return FileToOpen{path};
}

std::optional<FileAnswer> FileDialogs::draw(const Settings& settings, ItemRectangles& items) {
    if (browser_.open()) return draw_browser(settings, items);
    if (film_.open()) return draw_film(items);
    return figure_.open() ? draw_figure(items) : draw_export(items);
}

std::optional<FileAnswer> FileDialogs::draw_browser(const Settings& settings, ItemRectangles& items) {
    const FileBrowser::Recent recent{settings.recent, settings.folders};
    std::function<bool()> further;
    if (purpose_ == Purpose::save) further = [&] { return draw_save_fields(items); };
    const auto path = browser_.draw(recent, items, further);
    if (!path) return std::nullopt;
    if (purpose_ == Purpose::export_folder) {
        export_.set_folder(*path);
        return std::nullopt;
    }
    if (purpose_ == Purpose::figure_file) {
        figure_.set_file(*path);
        return std::nullopt;
    }
    if (purpose_ == Purpose::film_file) {
        film_.set_file(*path);
        return std::nullopt;
    }
    return answer(*path);
}

std::optional<FileAnswer> FileDialogs::draw_export(ItemRectangles& items) {
    const auto choice = export_.draw(items);
    if (export_.take_browse_wish()) {
        purpose_ = Purpose::export_folder;
        browser_.show({.mode = BrowseMode::folder,
                       .keys = "folder",
                       .title = "Choose a folder",
                       .start = (std::filesystem::path(export_.folder()) / "").string()});
    }
    if (choice) return *choice;
    return std::nullopt;
}

std::optional<FileAnswer> FileDialogs::draw_figure(ItemRectangles& items) {
    const auto choice = figure_.draw(items);
    if (figure_.take_browse_wish()) {
        purpose_ = Purpose::figure_file;
        const std::string_view ending = figure_ending(figure_.kind());
        browser_.show({.mode = BrowseMode::save,
                       .keys = "image",
                       .title = "Save the figure as",
                       .endings = {ending},
                       .start = figure_.file(),
                       .ending = std::string(ending)});
    }
    if (choice) return *choice;
    return std::nullopt;
}

std::optional<FileAnswer> FileDialogs::draw_film(ItemRectangles& items) {
    const auto choice = film_.draw(items);
    if (film_.take_browse_wish()) {
        purpose_ = Purpose::film_file;
        film_ending_ = film_.ending();
        BrowsePurpose purpose{.mode = film_ending_.empty() ? BrowseMode::folder : BrowseMode::save,
                              .keys = film_ending_.empty() ? "folder" : "image",
                              .title = film_ending_.empty() ? "Choose a folder" : "Save the film as",
                              .start = film_.file(),
                              .ending = film_ending_};
        if (!film_ending_.empty()) purpose.endings = {film_ending_};
        browser_.show(std::move(purpose));
    }
    if (choice) return *choice;
    return std::nullopt;
}

} // namespace gaspard

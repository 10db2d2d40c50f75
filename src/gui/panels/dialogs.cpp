#include "gui/panels/dialogs.hpp"

#include "core/base/error.hpp"
#include "core/base/user_path.hpp"
#include "core/scenario/data_files.hpp"
#include "core/scenario/toml.hpp"

#include <algorithm>
#include <filesystem>
#include <imgui.h>
#include <imgui_stdlib.h>
#include <utility>

namespace gaspard {

namespace {

constexpr ImGuiWindowFlags dialog_flags =
    ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove;

/// Border and rounding of a dialog, while it begins.
struct Frame {
    Frame() {
        ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 2);
        ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.5F * ImGui::GetFontSize());
        ImGui::PushStyleColor(ImGuiCol_Border, ImGui::GetStyleColorVec4(ImGuiCol_CheckMark));
    }
    ~Frame() {
        ImGui::PopStyleColor();
        ImGui::PopStyleVar(2);
    }
    Frame(const Frame&) = delete;
    Frame& operator=(const Frame&) = delete;
};

/// Begins a modal popup in the middle of the window, and opens it first if it is closed.
bool begin_modal(const char* title) {
    if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({size.x / 2, size.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
    const Frame frame;
    return ImGui::BeginPopupModal(title, nullptr, dialog_flags);
}

/// The largest width of a line of text.
float text_width() { return std::min(34 * ImGui::GetFontSize(), 0.85F * ImGui::GetIO().DisplaySize.x); }

} // namespace

void ErrorDialog::draw(ItemRectangles& items) {
    if (!open()) return;
    if (!begin_modal("Error")) return;
    ImGui::PushTextWrapPos(text_width());
    ImGui::TextUnformatted(sentence_.c_str());
    ImGui::PopTextWrapPos();
    remember_item(items, "error");
    ImGui::Spacing();
    const float em = ImGui::GetFontSize();
    if (ImGui::Button("OK", {6 * em, 0}) || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter))) close();
    remember_item(items, "error.ok");
    ImGui::SameLine();
    if (ImGui::Button("Copy", {6 * em, 0})) ImGui::SetClipboardText(sentence_.c_str());
    if (!open()) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

void OpenDialog::show(Purpose purpose) {
    purpose_ = std::move(purpose);
    text_ = purpose_.start;
    open_ = true, ready_ = refocus_ = false, at_end_ = true;
    listing_ = {}, wanted_.clear();
}

std::optional<std::filesystem::path> OpenDialog::take_folder_wish() {
    if (!open_) return std::nullopt;
    const auto folder = folder_of(text_);
    if (folder == wanted_) return std::nullopt;
    return wanted_ = folder;
}

/// The names in the folder of the path; those that begin like the name that is typed.
std::optional<std::string> OpenDialog::draw_listing(ItemRectangles& items) {
    const float em = ImGui::GetFontSize();
    const std::string typed = std::filesystem::path(text_).filename().string();
    std::optional<std::string> chosen;
    ImGui::BeginChild("##folder", {text_width(), 13 * em}, true);
    const auto go_to = [this](const std::filesystem::path& folder) {
        text_ = (folder / "").string(), refocus_ = at_end_ = true;
    };
    if (listing_.folder.has_parent_path() && listing_.folder != listing_.folder.root_path()) {
        auto folder = listing_.folder;
        if (!folder.has_filename()) folder = folder.parent_path();
        if (ImGui::Selectable("..", false, ImGuiSelectableFlags_DontClosePopups)) go_to(folder.parent_path());
        remember_item(items, "open.up");
    }
    for (const FolderListing::Entry& entry : listing_.entries) {
        if (!entry.name.starts_with(typed) && entry.name != typed) continue;
        const std::string label = entry.name + (entry.folder ? "/" : "");
        if (ImGui::Selectable(label.c_str(), false, ImGuiSelectableFlags_DontClosePopups)) {
            if (entry.folder)
                go_to(listing_.folder / entry.name);
            else
                chosen = (listing_.folder / entry.name).string();
        }
        remember_item(items, "open.entry." + entry.name);
    }
    if (!listing_.complete) ImGui::TextDisabled("and others; type the beginning of a name");
    ImGui::EndChild();
    return chosen;
}

std::optional<std::string> OpenDialog::draw(const std::vector<std::string>& recent, ItemRectangles& items) {
    if (!open_ || !begin_modal(purpose_.title.c_str())) return std::nullopt;
    std::optional<std::string> chosen;
    const float em = ImGui::GetFontSize();
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + text_width());
    ImGui::TextUnformatted(purpose_.line.c_str());
    ImGui::PopTextWrapPos();
    ImGui::SetNextItemWidth(text_width());
    if (ImGui::IsWindowAppearing() || std::exchange(refocus_, false)) ImGui::SetKeyboardFocusHere();
    const auto to_end = [](ImGuiInputTextCallbackData* data) {
        if (std::exchange(*static_cast<bool*>(data->UserData), false))
            data->CursorPos = data->SelectionStart = data->SelectionEnd = data->BufTextLen;
        return 0;
    };
    if (ImGui::InputText("##path", &text_,
                         ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackAlways, to_end,
                         &at_end_))
        chosen = text_;
    // A text field takes no input in the frame in which it gets the focus.
    ready_ = ready_ || text_ != purpose_.start || (ImGui::IsItemActive() && !ImGui::IsItemActivated());
    remember_item(items, "open.path");
    if (const auto one = draw_listing(items)) chosen = one;
    if (purpose_.recent && !recent.empty()) ImGui::TextDisabled("Recent files");
    for (std::size_t i = 0; purpose_.recent && i < recent.size(); ++i) {
        if (ImGui::Selectable(recent[i].c_str(), false, ImGuiSelectableFlags_DontClosePopups,
                              {text_width(), 0}))
            chosen = recent[i];
        remember_item(items, "open.recent." + std::to_string(i));
    }
    ImGui::Spacing();
    if (ImGui::Button("Open", {6 * em, 0})) chosen = text_;
    remember_item(items, "open.ok");
    ImGui::SameLine();
    if (ImGui::Button("Cancel", {6 * em, 0})) close();
    remember_item(items, "open.cancel");
    if (chosen && chosen->empty()) chosen.reset();
    if (chosen) close();
    if (!open_) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return chosen;
}

void SaveDialog::show(std::string file, std::string title, bool with_data) {
    open_ = true, ready_ = false, with_data_ = with_data;
    choice_ = {std::move(file), std::move(title)};
    present_.clear();
}

/// A typed path as a scenario file: "~/" is the home folder, and the name ends in ".toml".
static std::string scenario_path(std::string text) {
    if (!text.empty() && !is_scenario_file(text)) text += ".toml";
    try {
        return user_path(text).string();
    } catch (const InputError&) { // no home folder, as saving will say
        return text;
    }
}

std::optional<SaveDialog::Choice> SaveDialog::draw(ItemRectangles& items) {
    if (!open_ || !begin_modal("Save the scenario as")) return std::nullopt;
    const float em = ImGui::GetFontSize();
    bool accepted = false;
    const auto field = [&](const char* label, const char* id, std::string& text) {
        ImGui::TextUnformatted(label);
        ImGui::SetNextItemWidth(text_width());
        accepted |= ImGui::InputText(id, &text, ImGuiInputTextFlags_EnterReturnsTrue);
    };
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    field("File:", "##path", choice_.file);
    ready_ = ready_ || (ImGui::IsItemActive() && !ImGui::IsItemActivated());
    remember_item(items, "save.path");
    field("Title:", "##title", choice_.title);
    remember_item(items, "save.title");
    if (with_data_) {
        ImGui::Checkbox("Pack the data into the file", &choice_.packed);
        remember_item(items, "save.pack");
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip("The scenario then needs no other file; for data of at most %d MB.",
                              static_cast<int>(most_packed_data >> 20));
    }
    const std::string file = scenario_path(choice_.file);
    const bool asked = !present_.empty() && present_ == file;
    if (asked) ImGui::TextUnformatted("This file exists already. Replace it?");
    ImGui::Spacing();
    accepted |= ImGui::Button(asked ? "Replace" : "Save", {6 * em, 0});
    remember_item(items, "save.ok");
    ImGui::SameLine();
    if (ImGui::Button("Cancel", {6 * em, 0})) close();
    remember_item(items, "save.cancel");
    std::optional<Choice> chosen;
    std::error_code ignored;
    if (accepted && open_ && !file.empty()) {
        if (asked || !std::filesystem::exists(file, ignored)) {
            chosen = Choice{file, choice_.title, choice_.packed};
            close();
        } else {
            present_ = file;
        }
    }
    if (!open_) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return chosen;
}

bool draw_progress(const std::string& what, double fraction, const ItemRectangle& over,
                   ItemRectangles& items) {
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos({over.left + em, over.bottom - em}, ImGuiCond_Always, {0, 1});
    ImGui::Begin("##progress", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoMove);
    ImGui::ProgressBar(static_cast<float>(std::clamp(fraction, 0.0, 1.0)), {20 * em, 1.6F * em},
                       what.c_str());
    remember_item(items, "progress");
    ImGui::SameLine();
    const bool cancel = ImGui::Button("Cancel");
    remember_item(items, "progress.cancel");
    ImGui::End();
    return cancel;
}

} // namespace gaspard

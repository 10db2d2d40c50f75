#include "gui/panels/file_browser.hpp"

#include "core/base/error.hpp"
#include "core/base/user_path.hpp"
#include "gui/panels/modal.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <imgui.h>
#include <imgui_stdlib.h>
#include <utility>

namespace gaspard {

namespace {

constexpr float browser_width = 46, browser_height = 34; // in widths of the font

/// Whether a text begins like another one, or contains it; upper and lower case are equal.
bool equal_letters(char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

bool begins_like(std::string_view text, std::string_view beginning) {
    return text.size() >= beginning.size() &&
           std::equal(beginning.begin(), beginning.end(), text.begin(), equal_letters);
}

bool contains_letters(std::string_view text, std::string_view part) {
    return std::search(text.begin(), text.end(), part.begin(), part.end(), equal_letters) != text.end();
}

std::string name_in(const std::string& path) { return std::filesystem::path(path).filename().string(); }

std::string with_slash(const std::filesystem::path& folder) { return (folder / "").string(); }

const char* accept_label(BrowseMode mode, bool asked) {
    if (asked) return "Replace";
    return mode == BrowseMode::open ? "Open" : mode == BrowseMode::save ? "Save" : "Choose";
}

} // namespace

void FileBrowser::show(BrowsePurpose purpose) {
    purpose_ = std::move(purpose);
    open_ = true, ready_ = refocus_ = naming_ = all_ = false, at_end_ = true;
    text_ = purpose_.start;
    find_.clear(), selected_.clear(), present_.clear();
    listing_ = {}, wanted_ = {}, shown_.clear(), to_make_.reset();
}

std::optional<FolderWish> FileBrowser::take_wish() {
    if (!open_) return std::nullopt;
    FolderWish wish{.folder = folder_of(text_), .hidden = hidden_};
    if (!all_) wish.endings = purpose_.endings;
    wish.files = purpose_.mode != BrowseMode::folder;
    if (to_make_) {
        wish.folder = *std::exchange(to_make_, std::nullopt);
        wanted_ = wish;
        wish.create = true;
        return wish;
    }
    if (wish == wanted_) return std::nullopt;
    return wanted_ = wish;
}

void FileBrowser::set_listing(FolderListing listing) {
    if (listing.folder != listing_.folder) selected_.clear();
    listing_ = std::move(listing);
    update_shown();
}

/// Those of the listing that are as typed, in the order of the selected column.
void FileBrowser::update_shown() {
    shown_.clear();
    const bool narrowed = purpose_.mode != BrowseMode::save && !find_.empty();
    const auto add = [&](auto fits) {
        for (const Entry& entry : listing_.entries)
            if (!narrowed || fits(entry.name, find_)) shown_.push_back(&entry);
    };
    add(begins_like);
    if (shown_.empty()) add(contains_letters);
    if (sort_column_ == 0 && !descending_) return; // as the listing is
    std::stable_sort(shown_.begin(), shown_.end(), [&](const Entry* a, const Entry* b) {
        if (a->folder != b->folder) return a->folder;
        if (descending_) std::swap(a, b);
        if (sort_column_ == 1) return a->size < b->size;
        if (sort_column_ == 2) return a->time < b->time;
        return a->name < b->name;
    });
}

void FileBrowser::set_text(std::string text) {
    text_ = std::move(text);
    refocus_ = at_end_ = true;
    present_.clear();
}

void FileBrowser::go_to(const std::filesystem::path& folder) {
    std::string text = with_slash(folder);
    if (purpose_.mode == BrowseMode::save) text += name_in(text_); // the name stays
    set_text(std::move(text));
    find_.clear(), selected_.clear();
}

void FileBrowser::go_up() {
    const auto folder = folder_of(text_); // ends in a slash, or is the root
    go_to((folder.has_filename() ? folder : folder.parent_path()).parent_path());
}

const FileBrowser::Entry* FileBrowser::selected_entry() const {
    const auto at = std::find_if(listing_.entries.begin(), listing_.entries.end(),
                                 [&](const Entry& entry) { return entry.name == selected_; });
    return selected_.empty() || at == listing_.entries.end() ? nullptr : &*at;
}

void FileBrowser::move_selection(int by) {
    if (shown_.empty()) return;
    const auto at = std::find_if(shown_.begin(), shown_.end(),
                                 [&](const Entry* entry) { return entry->name == selected_; });
    const int last = static_cast<int>(shown_.size()) - 1;
    const int now = at == shown_.end() ? (by > 0 ? -1 : last + 1) : static_cast<int>(at - shown_.begin());
    selected_ = shown_[static_cast<std::size_t>(std::clamp(now + by, 0, last))]->name;
    scroll_ = true;
}

/// What all names that begin as typed have in common; a folder that is the only one is entered.
std::string FileBrowser::completion() const {
    const std::string typed = name_in(text_);
    const Entry* first = nullptr;
    std::size_t common = 0, count = 0;
    for (const Entry& entry : listing_.entries) {
        if (!begins_like(entry.name, typed)) continue;
        if (++count == 1) {
            first = &entry, common = entry.name.size();
            continue;
        }
        const auto [end, other] =
            std::mismatch(first->name.begin(), first->name.end(), entry.name.begin(), entry.name.end());
        common = std::min(common, static_cast<std::size_t>(end - first->name.begin()));
    }
    if (first == nullptr || common < typed.size()) return text_;
    std::string name = first->name.substr(0, common);
    if (count == 1 && first->folder) name += '/';
    return text_.substr(0, text_.size() - typed.size()) + name;
}

/// What keys do while the field has the keyboard.
int FileBrowser::edit(ImGuiInputTextCallbackData* data) {
    auto& self = *static_cast<FileBrowser*>(data->UserData);
    const auto replace = [&](const std::string& text) {
        data->DeleteChars(0, data->BufTextLen);
        data->InsertChars(0, text.c_str());
    };
    if (data->EventFlag == ImGuiInputTextFlags_CallbackHistory)
        self.move_selection(data->EventKey == ImGuiKey_UpArrow ? -1 : 1);
    if (data->EventFlag == ImGuiInputTextFlags_CallbackCompletion) replace(self.completion());
    if (data->EventFlag != ImGuiInputTextFlags_CallbackAlways) return 0;
    if (std::exchange(self.at_end_, false))
        data->CursorPos = data->SelectionStart = data->SelectionEnd = data->BufTextLen;
    const std::string_view now(data->Buf, static_cast<std::size_t>(data->BufTextLen));
    const std::string& before = self.text_;
    const bool slash_deleted = before.size() > 1 && before.back() == '/' && now.size() + 1 == before.size() &&
                               std::string_view(before).starts_with(now);
    if (slash_deleted && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Backspace))) {
        const std::filesystem::path above = std::filesystem::path(std::string(now)).parent_path();
        replace(above.empty() ? std::string() : with_slash(above));
    }
    return 0;
}

/// True when Enter was pressed.
bool FileBrowser::draw_field(ItemRectangles& items) {
    ImGui::SetNextItemWidth(-1);
    if (ImGui::IsWindowAppearing() || std::exchange(refocus_, false)) ImGui::SetKeyboardFocusHere();
    const bool entered =
        ImGui::InputText("##path", &text_,
                         ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackAlways |
                             ImGuiInputTextFlags_CallbackHistory | ImGuiInputTextFlags_CallbackCompletion,
                         &FileBrowser::edit, this);
    if (ImGui::IsItemEdited()) {
        find_ = name_in(text_);
        selected_.clear(), present_.clear();
        update_shown();
    }
    // A text field takes no input in the frame in which it gets the focus.
    ready_ = ready_ || (ImGui::IsItemActive() && !ImGui::IsItemActivated());
    remember_item(items, key("path"));
    return entered;
}

/// The same keys where no field has the keyboard, as after a click in the list. True when Enter was pressed.
bool FileBrowser::take_keys() {
    if (ImGui::IsAnyItemActive() || refocus_) return false;
    const auto pressed = [](auto one) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(one)); };
    if (pressed(ImGuiKey_UpArrow)) move_selection(-1);
    if (pressed(ImGuiKey_DownArrow)) move_selection(1);
    if (pressed(ImGuiKey_Backspace)) go_up();
    std::string typed;
    for (const ImWchar letter : ImGui::GetIO().InputQueueCharacters)
        if (letter >= ' ' && letter < 127) typed += static_cast<char>(letter);
    if (!typed.empty()) {
        set_text(with_slash(folder_of(text_)) + typed);
        find_ = typed;
        selected_.clear();
        update_shown();
    }
    return pressed(ImGuiKey_Enter);
}

void FileBrowser::draw_buttons_above(const Recent& recent, ItemRectangles& items) {
    const auto button = [&](const char* label, const char* name, const char* help) {
        const bool pressed = ImGui::Button(label);
        remember_item(items, key(name));
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", help);
        ImGui::SameLine();
        return pressed;
    };
    if (button("Up", "up", "The folder above (Backspace)")) go_up();
    const char* home = std::getenv("HOME");
    if (home != nullptr && button("Home", "home", home)) go_to(home);
    if (button("Recent", "recent", "Recent files and folders")) ImGui::OpenPopup("recent");
    if (ImGui::BeginPopup("recent")) {
        if (purpose_.mode == BrowseMode::open)
            for (const std::string& file : recent.files)
                if (ImGui::MenuItem(file.c_str())) set_text(file), find_.clear();
        if (!recent.folders.empty()) ImGui::Separator();
        for (const std::string& folder : recent.folders)
            if (ImGui::MenuItem(with_slash(folder).c_str())) go_to(folder);
        if (recent.files.empty() && recent.folders.empty()) ImGui::TextDisabled("None yet");
        ImGui::EndPopup();
    }
    if (purpose_.mode != BrowseMode::open && button("New folder", "new-folder", "Make a folder here"))
        naming_ = !naming_, new_name_.clear();
    ImGui::NewLine();
}

void FileBrowser::draw_new_folder(ItemRectangles& items) {
    if (!naming_) return;
    ImGui::SetNextItemWidth(-8 * ImGui::GetFontSize());
    bool made = ImGui::InputTextWithHint("##new", "name of the new folder", &new_name_,
                                         ImGuiInputTextFlags_EnterReturnsTrue);
    remember_item(items, key("new-name"));
    ImGui::SameLine();
    made |= ImGui::Button("Make");
    remember_item(items, key("new-ok"));
    if (!made || new_name_.empty() || new_name_.find('/') != std::string::npos) return;
    to_make_ = folder_of(text_) / new_name_ / "";
    go_to(folder_of(text_) / new_name_);
    naming_ = false;
}

/// True when it was double-clicked.
bool FileBrowser::draw_entry(const Entry& entry, ItemRectangles& items) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const std::string label = entry.name + (entry.folder ? "/" : "");
    bool twice = false;
    if (ImGui::Selectable(label.c_str(), entry.name == selected_,
                          ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowDoubleClick |
                              ImGuiSelectableFlags_DontClosePopups)) {
        twice = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
        selected_ = entry.name;
        // Not into the field, which would take the second click of a double click.
        if (!entry.folder) text_ = (listing_.folder / entry.name).string(), present_.clear();
    }
    remember_item(items, key("entry." + entry.name));
    ImGui::TableNextColumn();
    if (!entry.folder) ImGui::TextDisabled("%s", size_text(entry.size).c_str());
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", time_text(entry.time).c_str());
    return twice;
}

/// True when an entry was double-clicked.
bool FileBrowser::draw_list(float height, ItemRectangles& items) {
    const float em = ImGui::GetFontSize();
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_Sortable |
                                      ImGuiTableFlags_BordersOuter | ImGuiTableFlags_SizingFixedFit |
                                      ImGuiTableFlags_NoSavedSettings;
    if (!ImGui::BeginTable("##folder", 3, flags, {0, height})) return false;
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn("Name", ImGuiTableColumnFlags_WidthStretch | ImGuiTableColumnFlags_DefaultSort);
    ImGui::TableSetupColumn("Size", ImGuiTableColumnFlags_WidthFixed, 5 * em);
    ImGui::TableSetupColumn("Changed", ImGuiTableColumnFlags_WidthFixed, 10 * em);
    ImGui::TableHeadersRow();
    if (ImGuiTableSortSpecs* sort = ImGui::TableGetSortSpecs(); sort != nullptr && sort->SpecsDirty) {
        sort_column_ = sort->SpecsCount > 0 ? sort->Specs[0].ColumnIndex : 0;
        descending_ = sort->SpecsCount > 0 && sort->Specs[0].SortDirection == ImGuiSortDirection_Descending;
        sort->SpecsDirty = false;
        update_shown();
    }
    bool twice = false;
    if (std::exchange(scroll_, false)) {
        const float row = ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y;
        const auto at = std::find_if(shown_.begin(), shown_.end(),
                                     [&](const Entry* entry) { return entry->name == selected_; });
        ImGui::SetScrollY(row * static_cast<float>(at - shown_.begin()) - height / 2);
    }
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(shown_.size()));
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            twice |= draw_entry(*shown_[static_cast<std::size_t>(i)], items);
    if (!listing_.problem.empty() || !listing_.complete) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", listing_.complete ? listing_.problem.c_str()
                                                    : "and others; type the beginning of a name");
    }
    ImGui::EndTable();
    return twice;
}

void FileBrowser::draw_filters(ItemRectangles& items) {
    if (purpose_.mode != BrowseMode::folder && !purpose_.endings.empty()) {
        ImGui::Checkbox("All files", &all_);
        remember_item(items, key("all"));
        if (ImGui::IsItemHovered()) {
            std::string endings;
            for (const std::string_view ending : purpose_.endings) endings += " " + std::string(ending);
            ImGui::SetTooltip("Otherwise only files that fit:%s", endings.c_str());
        }
        ImGui::SameLine();
    }
    ImGui::Checkbox("Hidden files", &hidden_);
    remember_item(items, key("hidden"));
}

/// The text of the field as a path.
std::string FileBrowser::typed_path() const {
    std::string text = text_;
    const bool named = !name_in(text).empty();
    if (purpose_.mode == BrowseMode::save && named && !has_extension(text, purpose_.ending))
        text += purpose_.ending;
    try {
        return user_path(text).string();
    } catch (const InputError&) { // no home folder, as the task will say
        return text;
    }
}

/// Enters a folder, asks whether to replace a file, or is done.
std::optional<std::string> FileBrowser::accept() {
    const Entry* entry = selected_entry();
    if (entry == nullptr && purpose_.mode == BrowseMode::open) { // a folder may be typed without a slash
        const std::string name = name_in(text_);
        for (const Entry& one : listing_.entries)
            if (one.folder && one.name == name && listing_.folder == folder_of(text_)) entry = &one;
    }
    if (entry != nullptr && entry->folder) {
        go_to(listing_.folder / entry->name);
        return std::nullopt;
    }
    if (entry != nullptr) // as if it had been typed
        if (std::string file = (listing_.folder / entry->name).string(); file != text_)
            set_text(std::move(file));
    const std::string path = typed_path();
    const bool of_folder = purpose_.mode == BrowseMode::folder;
    if (path.empty() || (!of_folder && name_in(path).empty())) {
        refocus_ = at_end_ = true;
        return std::nullopt;
    }
    std::error_code unknown;
    if (purpose_.mode == BrowseMode::save && present_ != path && std::filesystem::exists(path, unknown)) {
        present_ = path;
        return std::nullopt;
    }
    close();
    return path;
}

std::optional<std::string> FileBrowser::draw(const Recent& recent, ItemRectangles& items,
                                             const std::function<bool()>& further) {
    const float em = ImGui::GetFontSize(), row = ImGui::GetFrameHeightWithSpacing();
    if (!open_ || !begin_modal(purpose_.title.c_str(), browser_width * em, browser_height * em))
        return std::nullopt;
    if (!purpose_.line.empty()) ImGui::TextWrapped("%s", purpose_.line.c_str());
    draw_buttons_above(recent, items);
    bool accepted = draw_field(items) || take_keys();
    draw_new_folder(items);
    const float below = row * (3.6F + (further ? 2.6F : 0)); // filters, question, buttons
    const float left = ImGui::GetContentRegionAvail().y - below;
    accepted |= draw_list(std::max(4 * row, left), items);
    draw_filters(items);
    if (further) accepted |= further();
    const bool asked = !present_.empty() && present_ == typed_path();
    if (purpose_.mode == BrowseMode::save) // its line is always there, so that the buttons stay
        ImGui::TextUnformatted(asked ? "This file exists already. Replace it?" : "");
    ImGui::Spacing();
    const auto answer = draw_modal_buttons(purpose_.keys, accept_label(purpose_.mode, asked), true, items);
    if (answer == ModalAnswer::cancel) close();
    std::optional<std::string> chosen;
    if (open_ && (accepted || answer == ModalAnswer::accept)) {
        const Entry* entry = selected_entry();
        if (purpose_.mode == BrowseMode::folder && answer == ModalAnswer::accept && entry != nullptr)
            go_to(listing_.folder / entry->name); // the button chooses what is selected
        chosen = accept();
    }
    if (!open_) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return chosen;
}

} // namespace gaspard

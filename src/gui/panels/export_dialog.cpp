#include "gui/panels/export_dialog.hpp"

#include "core/base/join.hpp"
#include "core/io/formats.hpp"
#include "gui/panels/modal.hpp"

#include <algorithm>
#include <imgui.h>
#include <imgui_stdlib.h>
#include <utility>

namespace gaspard {

void ExportDialog::show(const std::string& formats, bool splines, std::string folder) {
    open_ = true, splines_ = splines, browse_ = replace_ = false;
    folder_ = std::move(folder);
    const auto names = split(formats, ",");
    chosen_.clear();
    for (const Format& format : gaspard::formats())
        chosen_.push_back(std::find(names.begin(), names.end(), format.name) != names.end());
}

bool ExportDialog::take_browse_wish() { return std::exchange(browse_, false); }

void ExportDialog::draw_formats(ItemRectangles& items) {
    const float em = ImGui::GetFontSize();
    const auto& all = formats();
    const float height = std::min(static_cast<float>(all.size()) * ImGui::GetFrameHeightWithSpacing() * 1.5F,
                                  0.5F * ImGui::GetIO().DisplaySize.y);
    if (!ImGui::BeginTable("##formats", 2, ImGuiTableFlags_ScrollY | ImGuiTableFlags_SizingFixedFit,
                           {modal_text_width() + 10 * em, height}))
        return;
    ImGui::TableSetupColumn("format", ImGuiTableColumnFlags_WidthFixed, 8.5F * em);
    ImGui::TableSetupColumn("help", ImGuiTableColumnFlags_WidthStretch);
    for (std::size_t i = 0; i < all.size(); ++i) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        const bool possible = splines_ || !all[i].splines_only;
        bool chosen = chosen_[i] && possible;
        ImGui::BeginDisabled(!possible);
        if (ImGui::Checkbox(all[i].name.c_str(), &chosen)) chosen_[i] = chosen;
        remember_item(items, "export." + all[i].name);
        ImGui::EndDisabled();
        ImGui::TableNextColumn();
        ImGui::AlignTextToFramePadding();
        ImGui::TextWrapped("%s", all[i].help.c_str());
    }
    ImGui::EndTable();
}

void ExportDialog::draw_folder(ItemRectangles& items) {
    const float em = ImGui::GetFontSize();
    ImGui::TextUnformatted("Folder:");
    ImGui::SetNextItemWidth(modal_text_width() + 2 * em);
    ImGui::InputText("##folder", &folder_);
    remember_item(items, "export.folder");
    ImGui::SameLine();
    browse_ |= ImGui::Button("Browse ...");
    remember_item(items, "export.browse");
    ImGui::Checkbox("Replace the files of an earlier export", &replace_);
    remember_item(items, "export.replace");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Otherwise a folder with the next free number is used.");
}

std::optional<ExportDialog::Choice> ExportDialog::draw(ItemRectangles& items) {
    if (!open_ || !begin_modal("Export")) return std::nullopt;
    ImGui::TextUnformatted("With summary.json, history.csv and state.bin:");
    draw_formats(items);
    ImGui::Spacing();
    draw_folder(items);
    ImGui::Spacing();
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < chosen_.size(); ++i)
        if (chosen_[i] && (splines_ || !formats()[i].splines_only)) names.push_back(formats()[i].name);
    const auto answer = draw_modal_buttons("export", "Export", !names.empty() && !folder_.empty(), items);
    std::optional<Choice> choice;
    if (answer == ModalAnswer::accept) choice = Choice{join(names, ","), folder_, replace_};
    if (answer != ModalAnswer::none) close();
    if (!open_ || browse_) ImGui::CloseCurrentPopup(); // the browser takes its place meanwhile
    ImGui::EndPopup();
    return choice;
}

} // namespace gaspard

#include "gui/panels/log_panel.hpp"

#include <ctime>
#include <imgui.h>
#include <utility>

namespace gaspard {

namespace {

constexpr std::size_t most_lines = 1000;

std::string time_of_day() {
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    localtime_r(&now, &local);
    char text[16];
    std::strftime(text, sizeof text, "%H:%M:%S", &local);
    return text;
}

} // namespace

void Log::add(Notice notice) {
    lines_.push_back({time_of_day(), std::move(notice)});
    if (lines_.size() > most_lines) lines_.pop_front();
    grown_ = true;
}

std::string Log::text() const {
    std::string text;
    for (const LogLine& line : lines_) text += line.time + "  " + line.notice.text + "\n";
    return text;
}

void Log::draw(const Theme& theme, ItemRectangles& items) {
    ImGui::TextDisabled("Message log");
    ImGui::SameLine();
    if (ImGui::SmallButton("Copy")) ImGui::SetClipboardText(text().c_str());
    remember_item(items, "log.copy");
    ImGui::SameLine();
    if (ImGui::SmallButton("Clear")) lines_.clear();
    remember_item(items, "log.clear");
    ImGui::BeginChild("##lines");
    if (lines_.empty()) ImGui::TextDisabled("No messages yet.");
    for (const LogLine& line : lines_) {
        ImGui::TextDisabled("%s", line.time.c_str());
        ImGui::SameLine();
        ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(line.notice.error ? theme.bad : theme.text));
        ImGui::TextWrapped("%s", line.notice.text.c_str());
        ImGui::PopStyleColor();
    }
    if (std::exchange(grown_, false)) ImGui::SetScrollHereY(1);
    ImGui::EndChild();
    remember_item(items, "log");
}

} // namespace gaspard

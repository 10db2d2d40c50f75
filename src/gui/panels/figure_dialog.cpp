#include "gui/panels/figure_dialog.hpp"

#include "core/base/error.hpp"
#include "core/base/user_path.hpp"
#include "core/tessellate/background.hpp"
#include "gui/panels/image_fields.hpp"
#include "gui/panels/modal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <imgui.h>
#include <imgui_stdlib.h>
#include <utility>

namespace gaspard {

namespace {

constexpr std::array figure_kinds = {FigureKind::png, FigureKind::svg, FigureKind::pdf};
constexpr std::array<const char*, 3> grounds = {"theme", "transparent", "colour"};
constexpr double mm_per_inch = 25.4;

} // namespace

const char* figure_ending(FigureKind kind) {
    return kind == FigureKind::png ? ".png" : kind == FigureKind::svg ? ".svg" : ".pdf";
}

void FigureDialog::show(const Values& view, std::string stem) {
    open_ = true, browse_ = false;
    view_ = view;
    stem_ = std::move(stem);
    agreed_.clear(), asked_.clear();
    const double factor = millimetres_ ? mm_per_inch / view.real("dpi") : 1;
    width_ = factor * static_cast<double>(view.integer("width"));
    height_ = factor * static_cast<double>(view.integer("height"));
    const std::string& ground = view.text("background");
    ground_ = ground == "theme" ? 0 : ground == "transparent" ? 1 : 2;
    if (ground_ == 2) colour_ = ground;
}

bool FigureDialog::take_browse_wish() { return std::exchange(browse_, false); }

std::string FigureDialog::file() const { return stem_ + figure_ending(kind_); }

void FigureDialog::set_file(const std::string& file) {
    const std::string ending = figure_ending(kind_);
    stem_ = has_extension(file, ending) ? file.substr(0, file.size() - ending.size()) : file;
    agreed_ = this->file();
}

/// The size in pixels that the fields say.
void FigureDialog::set_pixels() {
    const double factor = millimetres_ ? view_->real("dpi") / mm_per_inch : 1;
    for (const auto& [key, size] : {std::pair("width", width_), std::pair("height", height_)}) {
        const double pixels = std::round(size * factor);
        if (pixels >= least_image_pixels && pixels <= most_image_pixels)
            view_->set(key, static_cast<std::int64_t>(pixels));
    }
}

/// What is wrong with the fields; empty if nothing is.
std::string FigureDialog::problem() const {
    const double factor = millimetres_ ? view_->real("dpi") / mm_per_inch : 1;
    const auto possible = [](double pixels) {
        return pixels >= least_image_pixels && pixels <= most_image_pixels;
    };
    for (const double size : {width_, height_})
        if (!possible(std::round(size * factor))) return "Width and height must be 64 to 8192 pixels.";
    if (std::filesystem::path(stem_).filename().empty()) return "The file needs a name.";
    try {
        if (ground_ == 2) parse_background(colour_);
    } catch (const InputError&) {
        return "The colour must be #rrggbb, such as #fff1d6.";
    }
    return {};
}

std::string FigureDialog::size_note() const {
    const auto width = static_cast<double>(view_->integer("width")),
               height = static_cast<double>(view_->integer("height"));
    const double mm = mm_per_inch / view_->real("dpi");
    std::array<char, 128> text{};
    if (kind_ == FigureKind::png)
        std::snprintf(text.data(), text.size(), "%.0f × %.0f pixels, printed as %.1f × %.1f mm", width,
                      height, mm * width, mm * height);
    else
        std::snprintf(text.data(), text.size(), "%.1f × %.1f mm, texts of %.1f points", mm * width,
                      mm * height, 8 * view_->real("text_size"));
    return text.data();
}

void FigureDialog::draw_kind(ItemRectangles& items) {
    label_before("Format");
    constexpr std::array help = {"pixels, as the view looks", "vectors, for drawing programs and the web",
                                 "vectors, for papers"};
    for (std::size_t i = 0; i < figure_kinds.size(); ++i) {
        const std::string name = figure_ending(figure_kinds[i]) + 1;
        std::string label = name;
        for (char& letter : label) letter = static_cast<char>(letter - 'a' + 'A');
        if (ImGui::RadioButton(label.c_str(), kind_ == figure_kinds[i])) kind_ = figure_kinds[i];
        remember_item(items, "figure." + name);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", help[i]);
        ImGui::SameLine();
    }
    ImGui::NewLine();
}

void FigureDialog::draw_size(ItemRectangles& items) {
    const char* format = millimetres_ ? "%.1f" : "%.0f";
    label_before("Size");
    number_field("##width", width_, format);
    remember_item(items, "figure.width");
    ImGui::SameLine();
    ImGui::TextUnformatted("×");
    ImGui::SameLine();
    number_field("##height", height_, format);
    remember_item(items, "figure.height");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(6 * ImGui::GetFontSize());
    int unit = millimetres_ ? 1 : 0;
    if (ImGui::Combo("##unit", &unit, "pixels\0mm\0")) {
        const double mm = mm_per_inch / view_->real("dpi"), factor = unit == 1 ? mm : 1 / mm;
        millimetres_ = unit == 1;
        width_ *= factor, height_ *= factor;
    }
    remember_item(items, "figure.unit");
    label_before("Resolution");
    double dpi = view_->real("dpi");
    if (number_field("##dpi", dpi, "%.0f") && dpi >= 36 && dpi <= 2400) view_->set("dpi", dpi);
    remember_item(items, "figure.dpi");
    ImGui::SameLine();
    ImGui::TextUnformatted("dpi");
    set_pixels();
    label_before("");
    ImGui::TextDisabled("%s", size_note().c_str());
}

void FigureDialog::draw_ground(ItemRectangles& items) {
    const float em = ImGui::GetFontSize();
    label_before("Theme");
    const bool vectors = kind_ != FigureKind::png; // are drawn for paper
    int theme = vectors || view_->text("theme") == "light" ? 1 : 0;
    ImGui::SetNextItemWidth(9 * em);
    ImGui::BeginDisabled(vectors);
    if (ImGui::Combo("##theme", &theme, "dark\0light\0"))
        view_->set("theme", std::string(theme == 1 ? "light" : "dark"));
    ImGui::EndDisabled();
    remember_item(items, "figure.theme");
    label_before("Background");
    ImGui::SetNextItemWidth(9 * em);
    ImGui::Combo("##ground", &ground_,
                 kind_ == FigureKind::png ? "of the theme\0transparent\0colour\0"
                                          : "white\0transparent\0colour\0");
    remember_item(items, "figure.ground");
    if (ground_ == 2) {
        ImGui::SameLine();
        ImGui::SetNextItemWidth(7 * em);
        ImGui::InputText("##colour", &colour_);
        remember_item(items, "figure.colour");
    }
    try {
        const std::string text = ground_ == 2 ? colour_ : grounds[static_cast<std::size_t>(ground_)];
        parse_background(text);
        view_->set("background", text);
    } catch (const InputError&) { // being typed; problem() says so
    }
}

void FigureDialog::draw_parts(ItemRectangles& items) {
    label_before("Text size");
    constexpr float smallest = 0.25F, largest = 4;
    auto size = static_cast<float>(view_->real("text_size"));
    double typed = view_->real("text_size");
    // The number has a field of its own, as the knob of a slider would cover it.
    ImGui::SetNextItemWidth(10 * ImGui::GetFontSize());
    if (ImGui::SliderFloat("##text", &size, smallest, largest, "",
                           ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_NoInput))
        view_->set("text_size", static_cast<double>(size));
    remember_item(items, "figure.text_size");
    ImGui::SameLine();
    if (number_field("##text number", typed, "%.2f"))
        view_->set("text_size",
                   std::clamp(typed, static_cast<double>(smallest), static_cast<double>(largest)));
    remember_item(items, "figure.text_size.number");
    draw_shown_parts(*view_, "figure", items);
}

void FigureDialog::draw_file(ItemRectangles& items) {
    const float em = ImGui::GetFontSize();
    label_before("File");
    ImGui::SetNextItemWidth(22 * em);
    ImGui::InputText("##file", &stem_);
    remember_item(items, "figure.file");
    ImGui::SameLine();
    ImGui::TextUnformatted(figure_ending(kind_));
    ImGui::SameLine();
    browse_ |= ImGui::Button("Browse ...");
    remember_item(items, "figure.browse");
}

std::optional<FigureDialog::Choice> FigureDialog::draw(ItemRectangles& items) {
    if (!open_ || !begin_modal("Figure")) return std::nullopt;
    draw_kind(items);
    draw_size(items);
    draw_ground(items);
    draw_parts(items);
    draw_file(items);
    const std::string wrong = problem(), chosen = file();
    const bool asked = !asked_.empty() && asked_ == chosen;
    label_before("");
    ImGui::TextUnformatted(!wrong.empty() ? wrong.c_str()
                           : asked        ? "This file exists already. Replace it?"
                                          : "");
    const auto answer = draw_modal_buttons("figure", asked ? "Replace" : "Save", wrong.empty(), items);
    std::optional<Choice> choice;
    if (answer == ModalAnswer::accept) {
        std::error_code unknown;
        const bool exists = std::filesystem::exists(chosen, unknown);
        if (exists && !asked && agreed_ != chosen)
            asked_ = chosen;
        else
            choice = Choice{kind_, chosen, *view_, exists};
    }
    if (choice || answer == ModalAnswer::cancel) close();
    if (!open_ || browse_) ImGui::CloseCurrentPopup(); // the browser takes its place meanwhile
    ImGui::EndPopup();
    return choice;
}

} // namespace gaspard

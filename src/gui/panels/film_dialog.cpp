#include "gui/panels/film_dialog.hpp"

#include "core/base/error.hpp"
#include "core/base/join.hpp"
#include "core/base/user_path.hpp"
#include "core/io/run_folder.hpp"
#include "core/io/video.hpp"
#include "core/tessellate/ticks.hpp"
#include "gui/panels/image_fields.hpp"
#include "gui/panels/modal.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <functional>
#include <imgui.h>
#include <imgui_stdlib.h>
#include <utility>

namespace gaspard {

namespace {

constexpr float wide_field = 24; // in widths of the font

/// The text of the InputError that `check` throws, as a sentence; else empty.
std::string complaint_of(const std::function<void()>& check) {
    try {
        check();
        return {};
    } catch (const InputError& error) {
        std::string text = error.what();
        if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
        return text + ".";
    }
}

std::string capitals(std::string_view name) {
    std::string text(name);
    for (char& letter : text) letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
    return text;
}

std::string label_of_motion(const FilmMotionRow& row) {
    return capitals(row.name.substr(0, 1)) + std::string(row.name.substr(1));
}

void integer_field(const char* id, int& value) {
    ImGui::SetNextItemWidth(6 * ImGui::GetFontSize());
    ImGui::InputInt(id, &value, 0, 0);
}

} // namespace

void FilmDialog::show(FilmSubject subject, const Values& view, std::string stem) {
    open_ = true, browse_ = false;
    subject_ = std::move(subject);
    view_ = view;
    stem_ = std::move(stem);
    agreed_.clear(), asked_.clear();
    width_ = static_cast<double>(view.integer("width")),
    height_ = static_cast<double>(view.integer("height"));
    first_ = subject_.iterates.recorded.front(), last_ = subject_.iterates.recorded.back(),
    still_ = subject_.shown;
    if (!subject_.iterates.times.empty())
        from_time_ = subject_.iterates.times.front(), to_time_ = subject_.iterates.times.back();
    seconds_.reset();
    to_ = subject_.camera;
    if (from_.empty() || !subject_.earlier.empty()) from_ = subject_.earlier;
    unsuitable_.clear(), missing_.clear();
    motions_.resize(film_motions().size(), false);
    for (std::size_t i = 0; i < motions_.size(); ++i) {
        FilmPlan alone{.motions = {}, .from = {}, .to = {}};
        alone.motions.*film_motions()[i].member = true;
        if (alone.motions.camera) alone.from = alone.to = subject_.camera;
        unsuitable_.push_back(complaint_of([&] {
            check_film(alone, *subject_.mesh, *view_);
            film_iterations(alone, subject_.iterates);
        }));
        motions_[i] = motions_[i] && unsuitable_[i].empty();
    }
    if (std::count(motions_.begin(), motions_.end(), true) == 0) {
        const std::string_view usual = subject_.iterates.first_in_time ? "time" : "iterations";
        motions_[static_cast<std::size_t>(std::ranges::find(film_motions(), usual, &FilmMotionRow::name) -
                                          film_motions().begin())] = true;
    }
    for (const FilmFormat& format : film_formats())
        missing_.push_back(complaint_of([&] {
            if (format.ffmpeg) check_ffmpeg(format.name);
        }));
}

bool FilmDialog::take_browse_wish() { return std::exchange(browse_, false); }

const FilmFormat& FilmDialog::format() const { return film_formats()[format_]; }

std::string FilmDialog::ending() const {
    return format().several ? std::string() : std::filesystem::path(format().file).extension().string();
}

std::string FilmDialog::file() const { return stem_ + ending(); }

void FilmDialog::set_file(const std::string& file) {
    const std::string end = ending();
    stem_ = !end.empty() && has_extension(file, end) ? file.substr(0, file.size() - end.size()) : file;
    if (!format().several) agreed_ = this->file(); // the browser has asked
}

/// Leaves out what is as usual, so that it is the plan of a command without options.
FilmPlan FilmDialog::plan() const {
    FilmPlan plan{.motions = {}, .rate = format().timed ? rate_ : 0};
    for (std::size_t i = 0; i < motions_.size(); ++i) plan.motions.*film_motions()[i].member = motions_[i];
    const std::vector<double>& times = subject_.iterates.times;
    if (plan.motions.time && !times.empty()) {
        if (from_time_ != times.front()) plan.from_time = from_time_;
        if (to_time_ != times.back()) plan.to_time = to_time_;
    } else {
        const int last = plan.motions.shows_iterates() ? last_ : still_;
        if (plan.motions.shows_iterates() && first_ != subject_.iterates.recorded.front())
            plan.first = first_;
        if (last != subject_.iterates.recorded.back()) plan.last = last;
    }
    if (plan.motions.camera) plan.from = from_, plan.to = to_;
    if (seconds_ && format().timed) {
        const double frames = std::round(*seconds_ * rate());
        plan.frames = static_cast<int>(std::clamp(frames, 1.0, 2.0 * most_film_frames));
    }
    return plan;
}

/// Frames a second: what the user has typed, else what is usual for the motions.
double FilmDialog::rate() const {
    if (rate_ > 0 && format().timed) return rate_;
    FilmPlan any{.motions = {}, .frames = 1};
    for (std::size_t i = 0; i < motions_.size(); ++i) any.motions.*film_motions()[i].member = motions_[i];
    return film_length(any, 1).rate;
}

/// Throws InputError for times that were not recorded.
void FilmDialog::check_times(const FilmPlan& film) const {
    if (!film.from_time && !film.to_time) return;
    const std::vector<double>& times = subject_.iterates.times;
    for (const double t : {from_time_, to_time_})
        if (!(t >= times.front() && t <= times.back()))
            throw InputError("the times of the film must be from " + short_number(times.front(), 6) + " to " +
                             short_number(times.back(), 6) + ", not " + short_number(t, 6));
}

std::string FilmDialog::problem() const {
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < motions_.size(); ++i)
        if (motions_[i]) names.push_back(film_motions()[i].name);
    for (const double size : {width_, height_})
        if (!(std::round(size) >= least_image_pixels && std::round(size) <= most_image_pixels))
            return "Width and height must be 64 to 8192 pixels.";
    if (!(rate() >= least_film_rate && rate() <= most_film_rate))
        return "A film has 1 to 1000 frames a second.";
    if (!missing_[format_].empty()) return missing_[format_];
    const FilmPlan film = plan();
    if (film.motions.camera && (from_.empty() || to_.empty()))
        return "The motion camera needs two views: Ctrl+C copies that of the window as text.";
    const std::string wrong = complaint_of([&] {
        parse_film_motions(join(names, ","));
        check_times(film);
        check_film(film, *subject_.mesh, *view_);
        check_film_formats(film, {&format()});
        film_length(film, film_iterations(film, subject_.iterates).size());
    });
    if (!wrong.empty()) return wrong;
    if (std::filesystem::path(stem_).filename().empty())
        return format().several ? "The folder needs a name." : "The file needs a name.";
    return {};
}

std::string FilmDialog::estimate() const {
    std::string text;
    complaint_of([&] { // that is said elsewhere
        const FilmPlan film = plan();
        const std::size_t iterates = film_iterations(film, subject_.iterates).size();
        const FilmLength length = film_length(film, iterates);
        if (!format().timed) {
            const auto meshes = std::min<std::size_t>(iterates, static_cast<std::size_t>(length.frames));
            text = std::to_string(meshes) + (meshes == 1 ? " mesh" : " meshes");
            return;
        }
        text = std::to_string(length.frames) + (length.frames == 1 ? " frame" : " frames") + ", " +
               short_number(length.frames / length.rate, 3) + " s";
        if (length.hold > 0) text += ", and " + short_number(length.hold, 3) + " s more at the end";
    });
    return text;
}

void FilmDialog::draw_motions(ItemRectangles& items) {
    const float em = ImGui::GetFontSize();
    for (std::size_t i = 0; i < film_motions().size(); ++i) {
        const FilmMotionRow& row = film_motions()[i];
        label_before(i == 0 ? "Motion" : "");
        ImGui::BeginDisabled(!unsuitable_[i].empty());
        bool chosen = motions_[i];
        if (ImGui::Checkbox(label_of_motion(row).c_str(), &chosen)) motions_[i] = chosen;
        remember_item(items, "film.motion=" + std::string(row.name));
        const bool hovered = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled);
        ImGui::SameLine(16 * em);
        ImGui::TextDisabled("%s", std::string(row.help).c_str());
        ImGui::EndDisabled();
        if (hovered && !unsuitable_[i].empty()) ImGui::SetTooltip("%s", unsuitable_[i].c_str());
    }
}

/// Shown only for the motion that needs them.
void FilmDialog::draw_cameras(ItemRectangles& items) {
    if (!plan().motions.camera) return;
    for (const auto& [label, key, text] :
         {std::tuple("First view", "film.from", &from_), std::tuple("Last view", "film.to", &to_)}) {
        label_before(label);
        ImGui::PushID(key);
        ImGui::SetNextItemWidth(wide_field * ImGui::GetFontSize());
        ImGui::InputText("##camera", text);
        remember_item(items, key);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("A view as Copy camera (Ctrl+C) copies it");
        ImGui::SameLine();
        if (ImGui::Button("Present view")) *text = subject_.camera;
        remember_item(items, std::string(key) + "-present");
        ImGui::PopID();
    }
}

/// Those of the motion time.
void FilmDialog::draw_times(ItemRectangles& items) {
    label_before("Times");
    number_field("##from-time", from_time_, "%.6g");
    remember_item(items, "film.from-time");
    ImGui::SameLine();
    ImGui::TextUnformatted("to");
    ImGui::SameLine();
    number_field("##to-time", to_time_, "%.6g");
    remember_item(items, "film.to-time");
    ImGui::SameLine();
    const std::vector<double>& times = subject_.iterates.times;
    ImGui::TextDisabled("recorded: t = %s to %s", short_number(times.front(), 6).c_str(),
                        short_number(times.back(), 6).c_str());
}

void FilmDialog::draw_iterates(ItemRectangles& items) {
    if (plan().motions.time && !subject_.iterates.times.empty()) return draw_times(items);
    const bool several = plan().motions.shows_iterates();
    label_before(several ? "Iterations" : "Iteration");
    if (several) {
        integer_field("##first", first_);
        remember_item(items, "film.first");
        ImGui::SameLine();
        ImGui::TextUnformatted("to");
        ImGui::SameLine();
    }
    integer_field("##last", several ? last_ : still_);
    remember_item(items, "film.last");
    ImGui::SameLine();
    ImGui::TextDisabled("recorded: %d to %d", subject_.iterates.recorded.front(),
                        subject_.iterates.recorded.back());
}

void FilmDialog::draw_format(ItemRectangles& items) {
    const float em = ImGui::GetFontSize();
    label_before("Format");
    ImGui::SetNextItemWidth(6 * em);
    const bool listed =
        ImGui::BeginCombo("##format", capitals(format().name).c_str(), ImGuiComboFlags_HeightLargest);
    remember_item(items, "film.format");
    if (listed) {
        for (std::size_t i = 0; i < film_formats().size(); ++i) {
            const FilmFormat& one = film_formats()[i];
            if (ImGui::Selectable(capitals(one.name).c_str(), i == format_, 0, {5 * em, 0})) format_ = i;
            remember_item(items, "film.format=" + std::string(one.name));
            ImGui::SameLine(6 * em);
            ImGui::TextDisabled("%s", std::string(one.help).c_str());
        }
        ImGui::EndCombo();
    }
    ImGui::SameLine();
    ImGui::TextDisabled("%s", std::string(format().help).c_str());
}

void FilmDialog::draw_size(ItemRectangles& items) {
    label_before("Size");
    number_field("##width", width_, "%.0f");
    remember_item(items, "film.width");
    ImGui::SameLine();
    ImGui::TextUnformatted("×");
    ImGui::SameLine();
    number_field("##height", height_, "%.0f");
    remember_item(items, "film.height");
    ImGui::SameLine();
    ImGui::TextUnformatted("pixels");
    for (const auto& [key, size] : {std::pair("width", width_), std::pair("height", height_)})
        if (const double pixels = std::round(size);
            pixels >= least_image_pixels && pixels <= most_image_pixels)
            view_->set(key, static_cast<std::int64_t>(pixels));
}

void FilmDialog::draw_length(ItemRectangles& items) {
    const bool timed = format().timed;
    const auto explain = [&] { // why the fields are grey
        if (!timed && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
            ImGui::SetTooltip(
                "%s has each mesh once, with its time or iteration: it has no rate and no length",
                capitals(format().name).c_str());
    };
    ImGui::BeginDisabled(!timed);
    label_before("Rate");
    double shown = rate();
    if (number_field("##rate", shown, "%g")) rate_ = shown;
    remember_item(items, "film.rate");
    explain();
    ImGui::SameLine();
    ImGui::TextUnformatted("frames a second");
    label_before("Length");
    double seconds = 0;
    complaint_of([&] {
        const FilmPlan film = plan();
        const FilmLength length = film_length(film, film_iterations(film, subject_.iterates).size());
        seconds = length.frames / length.rate;
    });
    if (seconds_ && timed) seconds = *seconds_;
    if (number_field("##seconds", seconds, "%.4g")) seconds_ = seconds;
    remember_item(items, "film.seconds");
    explain();
    ImGui::SameLine();
    ImGui::TextUnformatted("s");
    ImGui::SameLine();
    ImGui::BeginDisabled(!seconds_ && rate_ == 0);
    if (ImGui::Button("Default")) seconds_.reset(), rate_ = 0;
    remember_item(items, "film.default");
    ImGui::EndDisabled();
    ImGui::EndDisabled();
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("One frame for each iterate, 10 a second; six seconds of another motion");
    label_before("");
    ImGui::TextDisabled("%s", estimate().c_str());
    remember_item(items, "film.estimate");
}

void FilmDialog::draw_file(ItemRectangles& items) {
    label_before(format().several ? "Folder" : "File");
    ImGui::SetNextItemWidth(wide_field * ImGui::GetFontSize());
    ImGui::InputText("##file", &stem_);
    remember_item(items, "film.file");
    ImGui::SameLine();
    ImGui::TextUnformatted(ending().c_str());
    ImGui::SameLine((8 + wide_field + 3.5F) * ImGui::GetFontSize()); // whatever the ending
    browse_ |= ImGui::Button("Browse ...");
    remember_item(items, "film.browse");
}

/// Whether something would be replaced.
bool FilmDialog::present(const std::string& file) const {
    bool found = false;
    complaint_of([&] {
        std::error_code unknown;
        const auto path = std::filesystem::absolute(user_path(file));
        found = format().several ? !first_present(path, film_file_names()).empty()
                                 : std::filesystem::exists(path, unknown);
    });
    return found;
}

/// What is wrong or asked, and the buttons.
std::optional<FilmDialog::Choice> FilmDialog::draw_end(ItemRectangles& items) {
    const std::string wrong = problem(), chosen = file();
    const bool asked = !asked_.empty() && asked_ == chosen;
    const char* question = format().several ? "This folder has a film already. Replace it?"
                                            : "This file exists already. Replace it?";
    const float em = ImGui::GetFontSize(), top = ImGui::GetCursorPosY();
    label_before("");
    ImGui::PushTextWrapPos((8 + wide_field + 8) * em);
    ImGui::TextUnformatted(!wrong.empty() ? wrong.c_str() : asked ? question : "");
    remember_item(items, "film.problem");
    ImGui::PopTextWrapPos();
    ImGui::SetCursorPosY(top + 2.6F * ImGui::GetTextLineHeight()); // the buttons stay where they are
    const auto answer = draw_modal_buttons("film", asked ? "Replace" : "Record", wrong.empty(), items);
    std::optional<Choice> choice;
    if (answer == ModalAnswer::accept) {
        const bool exists = present(chosen);
        if (exists && !asked && agreed_ != chosen)
            asked_ = chosen;
        else
            choice = Choice{plan(), &format(), chosen, *view_, exists};
    }
    if (choice || answer == ModalAnswer::cancel) close();
    return choice;
}

std::optional<FilmDialog::Choice> FilmDialog::draw(ItemRectangles& items) {
    if (!open_ || !begin_modal("Record a film")) return std::nullopt;
    draw_motions(items);
    draw_cameras(items);
    draw_iterates(items);
    draw_format(items);
    ImGui::BeginDisabled(!format().drawn); // files of meshes have neither
    draw_size(items);
    ImGui::EndDisabled();
    draw_length(items);
    ImGui::BeginDisabled(!format().drawn);
    draw_shown_parts(*view_, "film", items);
    ImGui::EndDisabled();
    draw_file(items);
    auto choice = draw_end(items);
    if (!open_ || browse_) ImGui::CloseCurrentPopup(); // the browser takes its place meanwhile
    ImGui::EndPopup();
    return choice;
}

} // namespace gaspard

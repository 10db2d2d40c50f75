#include "core/tessellate/film.hpp"

#include "core/base/box.hpp"
#include "core/base/check.hpp"
#include "core/base/error.hpp"
#include "core/base/join.hpp"
#include "core/base/short_number.hpp"
#include "core/scenario/time_rows.hpp"
#include "core/session/time_series.hpp"
#include "core/tessellate/camera.hpp"
#include "core/tessellate/cell_geometry.hpp"
#include "core/tessellate/colouring.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <utility>

namespace gaspard {

namespace {

constexpr double seconds_of_motion = 6;                 // of a turn, or of another motion without iterates
constexpr double room = 1.05;                           // around a mesh that turns, relative to its size
constexpr double legend_part = 0.2, caption_part = 0.1; // at most, of the sizes of the image

/// From 0 to 1, at rest at both ends.
double smooth(double t) { return t * t * (3 - 2 * t); }

Camera camera_of(const std::string& text, Size size) {
    if (text.empty())
        throw InputError("the motion camera needs two views, --from and --to, as view.camera has them");
    if (shows_all(text))
        throw InputError("the camera '" + text +
                         "' shows all of a mesh; the motion camera needs two with "
                         "'centre ... height ...', as copied from the window");
    return parse_camera(text, size);
}

/// On the way from one camera to another: magnified evenly, turned by the shorter way.
Camera between(const Camera& from, const Camera& to, double t) {
    Camera camera;
    camera.centre = from.centre + t * (to.centre - from.centre);
    camera.scale = from.scale * std::pow(to.scale / from.scale, t);
    camera.right = from.right + t * (to.right - from.right);
    camera.up = from.up + t * (to.up - from.up);
    return camera;
}

/// It ends where it begins.
bool closes(const FilmMotions& motions) { return motions.turn || motions.blend; }

Size size_of(const Values& view) {
    return {static_cast<double>(view.integer("width")), static_cast<double>(view.integer("height"))};
}

/// What the camera sees at first: the whole mesh, with room to turn, if the view names no other.
Camera before_turn(const Mesh& mesh, const Values& view) {
    const std::string& text = view.text("camera");
    const Size size = size_of(view);
    if (!text.empty() && !shows_all(text)) return parse_camera(text, size);
    const Box box = bounding_box(mesh.nodes);
    Camera camera = spatial_home(box, size, {}, view.text("direction"));
    if (!text.empty()) {
        const Camera axes = parse_camera(text, size);
        camera.right = axes.right, camera.up = axes.up;
    }
    camera.centre = box.centre();
    double radius = 0;
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
        radius = std::max(radius, norm(mesh.nodes[i] - camera.centre));
    const double right = view.boolean("legend") ? legend_part * size.width : 0,
                 bottom = view.boolean("caption") ? caption_part * size.height : 0;
    camera.scale = 2 * room * radius / std::min(size.width - right, size.height - bottom);
    pan(camera, {-right / 2, -bottom / 2});
    return camera;
}

/// All of a box in the plane, with space for legend and caption; `beside`: in half of the width.
Camera whole_plane(const Box& box, const Values& view, bool beside) {
    constexpr double axes_room = 1.2;
    const Size size = size_of(view);
    const double right = view.boolean("legend") ? legend_part * size.width : 0,
                 bottom = view.boolean("caption") ? caption_part * size.height : 0;
    const double width = beside ? (size.width - right) / 2 : size.width - right;
    const Vec3 side = box.high - box.low;
    Camera camera;
    camera.centre = box.centre();
    camera.scale =
        (view.boolean("axes") ? axes_room : room) * std::max(side.x / width, side.y / (size.height - bottom));
    pan(camera, {beside ? 0 : -right / 2, -bottom / 2});
    return camera;
}

} // namespace

const std::vector<FilmMotionRow>& film_motions() {
    static const std::vector<FilmMotionRow> rows{
        {"iterations", "the iterates of the solve", &FilmMotions::iterations},
        {"time", "the time steps of a mesh that moves", &FilmMotions::time},
        {"turn", "the camera turns once round the mesh", &FilmMotions::turn},
        {"blend", "from the computational to the adapted mesh and back", &FilmMotions::blend},
        {"camera", "the camera goes from one view to another", &FilmMotions::camera},
    };
    return rows;
}

FilmMotions parse_film_motions(std::string_view list) {
    FilmMotions motions;
    std::vector<std::string> names;
    for (const FilmMotionRow& row : film_motions()) names.emplace_back(row.name);
    for (const std::string_view name : split(list, ",")) {
        if (list.empty()) break;
        const auto row = std::find_if(film_motions().begin(), film_motions().end(),
                                      [&](const FilmMotionRow& one) { return one.name == name; });
        if (row == film_motions().end())
            throw InputError("unknown motion '" + std::string(name) + "'" + did_you_mean(name, names));
        motions.*row->member = true;
    }
    if (motions == FilmMotions{}) throw InputError("no motion is given, such as iterations");
    if (motions.turn && motions.camera)
        throw InputError("the motions turn and camera both move the camera; choose one of them");
    if (motions.iterations && motions.time)
        throw InputError("the motions iterations and time both show iterates; choose one of them");
    return motions;
}

std::string_view usual_motion(const Scenario& scenario) {
    return has_time(scenario.time) ? "time" : "iterations";
}

static void check_order(const FilmPlan& plan) {
    if (plan.from_time && plan.to_time && *plan.from_time > *plan.to_time)
        throw InputError("the first time of the film, " + short_number(*plan.from_time, 6) +
                         ", is later than the last one, " + short_number(*plan.to_time, 6));
}

static void check_times(const FilmPlan& plan) {
    if (!plan.from_time && !plan.to_time) return;
    if (!plan.motions.time)
        throw InputError("--from-time and --to-time are times of the motion time, which is not asked for");
    if (plan.first && plan.from_time)
        throw InputError("--first and --from-time both say where the film begins; choose one of them");
    if (plan.last && plan.to_time)
        throw InputError("--last and --to-time both say where the film ends; choose one of them");
    check_order(plan);
}

void check_film(const FilmPlan& plan, const Mesh& mesh, const Values& view) {
    if (plan.first && plan.last && *plan.first > *plan.last)
        throw InputError("the first iteration of the film, " + std::to_string(*plan.first) +
                         ", comes after the last one, " + std::to_string(*plan.last));
    check_times(plan);
    const bool moves_camera = plan.motions.turn || plan.motions.camera;
    if (moves_camera && view.text("layout") == "projection")
        throw InputError("a map projection has no camera that could move; choose another view.layout");
    if (moves_camera && mesh.space_dimension == 1)
        throw InputError("the meshes of an interval are shown as plots, which no camera looks at");
    if (plan.motions.turn && mesh.space_dimension < 3)
        throw InputError("the motion turn needs a surface or a solid; this mesh lies in the plane");
    if (!plan.motions.camera) {
        if (!plan.from.empty() || !plan.to.empty())
            throw InputError("--from and --to are cameras of the motion camera, which is not asked for");
        return;
    }
    for (const std::string& text : {plan.from, plan.to}) {
        const Camera camera = camera_of(text, size_of(view));
        const bool planar = camera.right == Vec3{1, 0, 0} && camera.up == Vec3{0, 1, 0};
        if (mesh.space_dimension < 3 && !planar)
            throw InputError("the camera '" + text + "' looks from the side at a mesh in the plane");
    }
    const Size size = size_of(view);
    const Camera half_way = between(camera_of(plan.from, size), camera_of(plan.to, size), 0.5);
    if (norm(half_way.right) < 0.1 || norm(half_way.up) < 0.1)
        throw InputError("the two cameras look at the mesh from opposite sides, between which there is no "
                         "shortest way; choose one that is turned less");
}

FilmIterates film_iterates(const Recording& recording) {
    FilmIterates iterates{recording.iterations(), {}};
    for (std::size_t i = 1; i < iterates.recorded.size() && !iterates.first_in_time; ++i)
        if (is_time_step(recording.at(iterates.recorded[i])->report()))
            iterates.first_in_time = iterates.recorded[i - 1] == iterates.recorded[i] - 1
                                         ? iterates.recorded[i - 1]
                                         : iterates.recorded[i];
    auto& recorded = iterates.recorded;
    if (recorded.size() > 1 && is_given_up(recording.at(recorded.back())->report())) recorded.pop_back();
    for (const int iteration : recorded)
        if (iterates.first_in_time && iteration >= *iterates.first_in_time)
            iterates.times.push_back(time_of(recording.at(iteration)->report()).value());
    return iterates;
}

namespace {

/// The place of the time that is nearest; of two equally near ones the earlier.
std::size_t nearest(const std::vector<double>& times, double t) {
    const auto after = std::ranges::lower_bound(times, t);
    if (after == times.begin()) return 0;
    const bool before = after == times.end() || t - *std::prev(after) <= *after - t;
    return static_cast<std::size_t>(after - times.begin()) - (before ? 1 : 0);
}

/// The iterations between the two times of the plan, of those in time.
std::vector<int> between_times(const FilmPlan& plan, const std::vector<int>& iterations,
                               const std::vector<double>& times) {
    if (!plan.from_time && !plan.to_time) return iterations;
    GASPARD_CHECK(iterations.size() == times.size());
    check_order(plan);
    const std::string range = "; the meshes are those of t = " + short_number(times.front(), 6) + " to " +
                              short_number(times.back(), 6);
    const double rounding = 1e-9 * std::max(std::abs(times.front()), std::abs(times.back()));
    if (plan.from_time && *plan.from_time > times.back() + rounding)
        throw InputError("the film begins at t = " + short_number(*plan.from_time, 6) + range);
    if (plan.to_time && *plan.to_time < times.front() - rounding)
        throw InputError("the film ends at t = " + short_number(*plan.to_time, 6) + range);
    const std::size_t from = plan.from_time ? nearest(times, *plan.from_time) : 0,
                      to = plan.to_time ? nearest(times, *plan.to_time) : times.size() - 1;
    return {iterations.begin() + static_cast<std::ptrdiff_t>(from),
            iterations.begin() + static_cast<std::ptrdiff_t>(to) + 1};
}

} // namespace

std::vector<int> film_iterations(const FilmPlan& plan, const FilmIterates& iterates) {
    std::vector<int> recorded = iterates.recorded;
    GASPARD_CHECK(!recorded.empty());
    if (plan.motions.time) {
        if (!iterates.first_in_time)
            throw InputError(
                "the motion time needs time steps: time.end after time.start, and a mesh that is solved at "
                "the start");
        std::erase_if(recorded, [&](int iteration) { return iteration < *iterates.first_in_time; });
        recorded = between_times(plan, recorded, iterates.times);
    }
    if (plan.first && *plan.first > recorded.back())
        throw InputError("the film begins with iteration " + std::to_string(*plan.first) +
                         ", but the last one is " + std::to_string(recorded.back()));
    std::vector<int> shown;
    for (const int iteration : recorded)
        if (iteration >= plan.first.value_or(iteration) && iteration <= plan.last.value_or(iteration))
            shown.push_back(iteration);
    if (!shown.empty()) return shown;
    // Between two that were recorded: the one before, as of a recording.
    const auto after =
        std::upper_bound(recorded.begin(), recorded.end(), plan.last.value_or(recorded.back()));
    return {after == recorded.begin() ? recorded.front() : *std::prev(after)};
}

FilmLength film_length(const FilmPlan& plan, std::size_t iterates) {
    FilmLength length{plan.frames, plan.rate,
                      plan.motions.shows_iterates() || plan.motions.camera ? 1.0 : 0.0};
    if (length.rate == 0) length.rate = plan.motions == FilmMotions{.iterations = true} ? 10 : 25;
    if (length.frames == 0)
        length.frames = plan.motions.shows_iterates() && !closes(plan.motions)
                            ? static_cast<int>(iterates)
                            : static_cast<int>(std::lround(seconds_of_motion * length.rate));
    length.frames = std::max(length.frames, 1);
    if (length.frames > most_film_frames)
        throw InputError("the film would have " + std::to_string(length.frames) +
                         " frames; choose fewer, at most " + std::to_string(most_film_frames));
    return length;
}

Film::Film(FilmPlan plan, const Recording& recording, std::shared_ptr<const Snapshot> last, Values view,
           const Progress& progress, const std::stop_token& stop)
    : plan_(std::move(plan)), recording_(recording),
      iterations_(film_iterations(plan_, film_iterates(recording_))), last_(std::move(last)),
      view_(std::move(view)), length_(film_length(plan_, iterations_.size())) {
    GASPARD_CHECK(last_ != nullptr);
    if (plan_.motions.time)
        fit_to_time(progress, stop);
    else if (plan_.motions.iterations && view_.text("range") != "fixed")
        view_ = with_range(view_, range_of_recording(recording_, last_.get(), colour_choice(view_)));
    last_ = iterate(iterations_.back());
    if (is_interval(*last_->mesh)) fit_axes(stop);
}

/// To all meshes of the film, but to tangled ones only if there are no others.
void Film::fit_axes(const std::stop_token& stop) {
    const std::vector<bool> shown = this->shown();
    std::vector<Values> views{view_};
    if (plan_.motions.blend) { // in between, all is between
        views.push_back(view_);
        views[0].set("blend", 0.0), views[1].set("blend", 1.0);
    }
    std::vector<ColumnRanges> sound, tangled;
    for (std::size_t i = 0; i < iterations_.size(); ++i) {
        if (!shown[i]) continue;
        if (stop.stop_requested()) throw Interrupted();
        const auto mesh = iterate(iterations_[i]);
        auto& all = mesh->report.tangled_cells.value_or(0) > 0 ? tangled : sound;
        for (const Values& view : views) all = merged(all, shown_ranges(interval_plots(*mesh, view)));
    }
    axes_ = sound.empty() ? tangled : sound;
}

/// Whether all meshes are seen by one camera, so that its frame does not move with them: those in the plane.
bool Film::holds_camera() const {
    const bool whole = view_.text("camera").empty() || shows_all(view_.text("camera"));
    return whole && last_->mesh->space_dimension == 2 && view_.real("elevation") == 0 &&
           view_.text("layout") != "computational";
}

/// Which of the iterations the frames show.
std::vector<bool> Film::shown() const {
    std::vector<bool> shown(iterations_.size(), false);
    if (!plan_.motions.shows_iterates()) shown.back() = true;
    for (int k = 0; plan_.motions.shows_iterates() && k < length_.frames; ++k) shown[place_in_list(k)] = true;
    return shown;
}

/// One range of colours of all frames, in which tangled meshes count only where no other is shown, and one
/// camera. Each mesh is restored once.
void Film::fit_to_time(const Progress& progress, const std::stop_token& stop) {
    const bool with_camera = holds_camera(), automatic = view_.text("range") != "fixed";
    const std::vector<bool> coloured = automatic ? shown() : std::vector<bool>(iterations_.size(), false);
    const ColourChoice choice = colour_choice(view_);
    Box box = bounding_box(last_->x);
    std::optional<ColourRange> sound, tangled;
    for (std::size_t i = 0; i < iterations_.size(); ++i) {
        if (!with_camera && !coloured[i]) continue;
        if (stop.stop_requested()) throw Interrupted();
        if (progress)
            progress(static_cast<double>(i) / static_cast<double>(iterations_.size()),
                     "fitting colours and camera");
        const auto mesh = iterate(iterations_[i]);
        if (with_camera) box = merge(box, bounding_box(mesh->x));
        if (!coloured[i]) continue;
        const bool is_tangled = mesh->report.tangled_cells.value_or(0) > 0;
        if (!is_tangled || !sound) cover(is_tangled ? tangled : sound, *mesh, choice);
    }
    view_ = with_range(view_, sound ? sound : tangled);
    if (!with_camera) return;
    const std::string& layout = view_.text("layout");
    const bool beside = layout == "side-by-side" || layout == "field-and-mesh";
    view_.set("camera", format_camera(whole_plane(box, view_, beside), size_of(view_)));
}

double Film::place(int frame) const {
    const int frames = length_.frames;
    const bool round = closes(plan_.motions) && !plan_.motions.shows_iterates() && !plan_.motions.camera;
    const int steps = round ? frames : frames - 1;
    return steps > 0 ? static_cast<double>(frame) / steps : 1;
}

std::size_t Film::place_in_list(int frame) const {
    return static_cast<std::size_t>(std::lround(place(frame) * static_cast<double>(iterations_.size() - 1)));
}

int Film::iteration(int frame) const {
    GASPARD_CHECK(frame >= 0 && frame < length_.frames);
    if (!plan_.motions.shows_iterates()) return last_->report.iteration;
    return iterations_[place_in_list(frame)];
}

double Film::moment(int frame) const {
    const int shown = iteration(frame);
    const StepReport& report =
        shown == last_->report.iteration ? last_->report : recording_.at(shown)->report();
    return plan_.motions.time ? time_of(report).value() : shown;
}

std::shared_ptr<const Snapshot> Film::iterate(int iteration) const {
    if (iteration == last_->report.iteration) return last_;
    return recording_.at(iteration)->restore();
}

FilmFrame Film::frame(int frame) const {
    FilmFrame made{iteration(frame), nullptr, view_, axes_};
    made.snapshot = iterate(made.iteration);
    const double t = place(frame);
    const Size size = size_of(view_);
    if (plan_.motions.blend) made.view.set("blend", (1 - std::cos(2 * std::numbers::pi * t)) / 2);
    if (plan_.motions.turn) {
        const Mesh& mesh = *made.snapshot->mesh;
        Camera camera = before_turn(mesh, view_);
        spin(camera, 2 * std::numbers::pi * t, bounding_box(mesh.nodes).centre());
        const bool whole = shows_all(view_.text("camera")) || view_.text("camera").empty();
        const bool round = radius_of_ball(mesh) > 0; // all views of it are equally large
        made.view.set("camera", whole && round ? format_axes(camera) : format_camera(camera, size));
    }
    if (plan_.motions.camera)
        made.view.set(
            "camera",
            format_camera(between(camera_of(plan_.from, size), camera_of(plan_.to, size), smooth(t)), size));
    return made;
}

} // namespace gaspard

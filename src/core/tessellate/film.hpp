// Films of a solve: which iterate each frame shows, and how.
//
// A film has one motion or several at once: the iterates of the solve, or its time steps, a turn of the
// camera once round the vertical axis, the way from xi to x and back, the way of the camera from one view to
// another. Frame k of n is at t = k / (n - 1); of a turn or of the way to x and back, which end where they
// begin, at t = k / n.
#pragma once

#include "core/mesh/discretisation.hpp"
#include "core/scenario/scenario.hpp"
#include "core/session/recording.hpp"
#include "core/tessellate/colour_map.hpp"
#include "core/tessellate/interval_plots.hpp"

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

struct FilmMotions {
    bool iterations = false, time = false, turn = false, blend = false, camera = false;
    bool shows_iterates() const { return iterations || time; }
    friend bool operator==(const FilmMotions&, const FilmMotions&) = default;
};

/// Their names and what they do, for help and messages.
struct FilmMotionRow {
    std::string_view name, help;
    bool FilmMotions::*member;
};
const std::vector<FilmMotionRow>& film_motions();
/// Of a list such as "iterations,turn". Throws InputError for names that are not known, and for none.
FilmMotions parse_film_motions(std::string_view list);

inline constexpr int most_film_frames = 100000; // whose numbers have five digits
inline constexpr double least_film_rate = 1, most_film_rate = 1000;

struct FilmPlan {
    FilmMotions motions{.iterations = true};
    int frames = 0;           ///< 0: one per iterate or time step, or six seconds of another motion
    double rate = 0;          ///< per second; 0: 25, of iterates alone 10
    std::string from{}, to{}; ///< of motions.camera, as view.camera
    /// Only the iterates of these iterations and between; motions without iterates show the last one.
    std::optional<int> first{}, last{};
    /// Of motions.time: from the mesh whose time is nearest to the one to that nearest to the other.
    std::optional<double> from_time{}, to_time{};
};
/// Iterations, or time steps if the scenario has time: the motion of a film for which none is given.
std::string_view usual_motion(const Scenario& scenario);
/// Throws InputError if the plan makes no sense for a mesh of this kind and a view of this size: a turn of
/// what lies in the plane, a camera that cannot be read.
void check_film(const FilmPlan& plan, const Mesh& mesh, const Values& view);

/// How long a film is: its frames, how many of them a second shows, and for how many seconds the last one
/// stays.
struct FilmLength {
    int frames = 0;
    double rate = 0, hold = 0;
};
/// Of a plan, where so many iterates were recorded. Throws InputError for more than most_film_frames.
FilmLength film_length(const FilmPlan& plan, std::size_t iterates);
/// What was recorded: iterations, ascending, the one whose mesh is that of the first time, and the times from
/// that on; empty if there is no time step.
struct FilmIterates {
    std::vector<int> recorded;
    std::optional<int> first_in_time{};
    std::vector<double> times{};
};
FilmIterates film_iterates(const Recording& recording);
/// Those of the recorded iterations that the plan has: at least one. Throws InputError if it begins after the
/// last one, ends before the first time, or shows time where there is none.
std::vector<int> film_iterations(const FilmPlan& plan, const FilmIterates& iterates);

struct FilmFrame {
    int iteration = 0;
    std::shared_ptr<const Snapshot> snapshot;
    Values view;
    std::vector<ColumnRanges> axes{}; ///< of an interval: what the axes of its plots show in all frames
};

class Film {
  public:
    /// Of a recording and its last iterate. `view` of view_rows(). An automatic range of colours is the same
    /// in all frames: of iterates range_of_recording(), of time steps one that covers all meshes of the film
    /// but tangled ones, since none of them is the result, or all if all are tangled. For that, a film of
    /// time steps looks at each mesh, one after the other. Throws InputError for more than most_film_frames;
    /// Interrupted.
    Film(FilmPlan plan, const Recording& recording, std::shared_ptr<const Snapshot> last, Values view,
         const Progress& progress = {}, const std::stop_token& stop = {});
    int frames() const { return length_.frames; }
    double rate() const { return length_.rate; }
    /// The last frame stays for a second if the film does not end where it begins.
    double hold() const { return length_.hold; }
    bool in_time() const { return plan_.motions.time; } ///< a film of time steps
    int iteration(int frame) const;
    /// The time of its mesh in a film of time steps, otherwise the iteration.
    double moment(int frame) const;
    FilmFrame frame(int frame) const;

  private:
    double place(int frame) const;
    std::size_t place_in_list(int frame) const; ///< in iterations_; of a film of iterates or time steps
    std::vector<bool> shown() const;
    bool holds_camera() const;
    void fit_to_time(const Progress& progress, const std::stop_token& stop);
    void fit_axes(const std::stop_token& stop);
    std::shared_ptr<const Snapshot> iterate(int iteration) const;

    FilmPlan plan_;
    Recording recording_;
    std::vector<int> iterations_;
    std::shared_ptr<const Snapshot> last_;
    Values view_;
    FilmLength length_;
    std::vector<ColumnRanges> axes_{};
};

} // namespace gaspard

// The clock of a scenario whose monitor moves: the times t_k of its meshes, and the scenario at each.
//
//   t_k = start + k step,  k = 0, ..., K;  t_K = end
//
// At time t the monitor has the values of the scenario, but for
//   - parameters whose row "time.monitor.KEY" is a formula in t and the monitor's own parameters, such as
//     "center_x + 0.1*t"; periodic ones are taken modulo their period,
//   - its point, if time.path is not empty: a cubic curve through the places of the path, on a sphere along
//     it; before the first and after the last of them the point rests,
//   - parameters that are a time (ParameterRole::time), such as t of a formula: they are t.
#pragma once

#include "core/scenario/scenario.hpp"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

/// A place at a time, of time.path: x and y, or latitude and longitude in degrees, unwrapped.
struct PathPoint {
    double t = 0, first = 0, second = 0;
    friend bool operator==(const PathPoint&, const PathPoint&) = default;
};
/// Throws InputError if the text is no path: times must increase.
std::vector<PathPoint> parse_path(const std::string& text);
std::string write_path(const std::vector<PathPoint>& path);

class Clock {
  public:
    static constexpr int most_steps = 10'000'000;

    static constexpr int usual_moments = 2000;

    /// Of a scenario with time (has_time). Throws InputError if a formula or the path is invalid, if there
    /// are more than most_steps, or if a value is out of its range at one of `moments` times, evenly chosen
    /// with the first and the last, or of all times if there are fewer. That takes about 20 µs for each and
    /// each formula. 0: values are not checked. 1: at the first time.
    explicit Clock(Scenario scenario, int moments = usual_moments);
    ~Clock();

    int steps() const { return steps_; } ///< K
    double time(int k) const;            ///< t_k
    /// The step whose time is nearest.
    int nearest(double t) const;
    /// Throws InputError if a value is out of its range at this time.
    Scenario at(double t) const;
    /// What sets a parameter of the monitor at all times, so that its value in the scenario means nothing: a
    /// sentence. Empty if the value is used.
    std::string why_unused(std::string_view key) const;

  private:
    struct Motion;
    void take_path();
    void move(Values& values, double t) const;
    void move_along_path(Values& values, double t) const;

    Scenario scenario_;
    double start_, end_, step_;
    int steps_;
    std::vector<Motion> motions_;
    std::vector<PathPoint> path_;
    std::string first_key_{}, second_key_{}; ///< of the point that moves along the path
    bool on_sphere_ = false;
    std::vector<std::string> times_; ///< keys of parameters that are a time
};

/// The rows of the point of a monitor that a path moves, its first one; null if it has none.
struct MovingPoint {
    const ParameterRow *first = nullptr, *second = nullptr; ///< x and y, or latitude and longitude
    bool on_sphere() const { return first && first->role == ParameterRole::latitude; }
    explicit operator bool() const { return first && second; }
};
MovingPoint moving_point(const Values& monitor);

/// Null if the scenario has no time.
std::shared_ptr<const Clock> make_clock(const Scenario& scenario);

} // namespace gaspard

// A study of parameters: a scenario solved for each value of one parameter, once for every value of a second
// one, which gives the lines of a table or a plot. Runs are made in memory, one after the other.
#pragma once

#include "core/session/snapshot.hpp"
#include "core/session/study_axis.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

struct StudyPlan {
    Scenario scenario;
    StudyAxis over;        ///< numbers, ascending
    StudyAxis lines{};     ///< in the order of the lines
    std::string measure{}; ///< see study_value()

    std::size_t line_count() const { return lines.key.empty() ? 1 : lines.values.size(); }
    std::size_t size() const { return line_count() * over.values.size(); }
};
/// Whether both compute the same: names and view of the scenario do not count, nor the speed of its time.
bool same_study(const StudyPlan& a, const StudyPlan& b);

/// The scenario of one run.
Scenario study_scenario(const Catalogue& catalogue, const StudyPlan& plan, std::size_t line,
                        std::size_t place);
/// Throws InputError if one of the scenarios is not allowed, if there are more than 5000, or if no run has
/// the measure, with those that there are. Makes the first mesh, but solves nothing.
void check_study(std::shared_ptr<const Catalogue> catalogue, const StudyPlan& plan);

/// One run of a study.
struct StudyPoint {
    std::size_t line = 0, place = 0;    ///< of the plan's axes
    double x = 0;                       ///< the value of `over`
    std::optional<StepReport> report{}; ///< the last one; empty: it could not be run
    std::optional<double> bound{};      ///< of the energy error (core/layer/layer_pde.hpp)
    std::string complaint{};            ///< why it could not be run
    bool refused = false;               ///< the complaint is about the input
    std::string absence{};              ///< why the run has no value of the measure, where that is known
};
/// A series of the last report by its name, or "iterations", "seconds", "cpu_seconds", "tangled_cells"; NaN
/// where it is not known.
double study_value(const StudyPoint& point, std::string_view measure);
/// "Energy error, P2 reference", for people; the name itself where neither a point nor this program knows it.
std::string measure_label(std::span<const StudyPoint> points, std::string_view measure);
/// "4 iterations, iteration-limit" or the complaint of a run that did not converge; of others the absence.
std::string study_note(const StudyPoint& point);
/// What the runs that converged say of values that are absent, each sentence once.
std::vector<std::string> study_absences(std::span<const StudyPoint> points);

/// The exponent p of value ~ x^p between two points of a line; where cells vary the order of convergence, so
/// that it is positive if the value falls. NaN where it is not defined.
double study_order(const StudyPlan& plan, const StudyPoint& before, const StudyPoint& now);
/// Whether such a key is drawn on a logarithmic axis: cells, and positive numbers whose row has that scale.
bool has_factors(const Scenario& scenario, std::string_view key);
/// Whether these exponents mean something: cells or a row with a logarithmic scale vary.
bool has_orders(const StudyPlan& plan);
/// What they are called: "order" or "exponent".
std::string order_name(const StudyPlan& plan);
/// The point of this line and place; null if it is not there.
const StudyPoint* find_point(std::span<const StudyPoint> points, std::size_t line, std::size_t place);

/// Solves all runs, for each value of `over` those of all lines, measured in full, and passes on each when it
/// is done; what fails in one is its complaint. Ends early if asked to stop; the run at work is then not
/// passed on.
void run_study(std::shared_ptr<const Catalogue> catalogue, const StudyPlan& plan, int threads,
               const std::function<void(StudyPoint)>& done, std::stop_token stop = {});

} // namespace gaspard

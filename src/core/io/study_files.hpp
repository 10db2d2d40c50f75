// A study of parameters as text: its table as CSV and JSON, and its plot.
#pragma once

#include "core/session/parameter_study.hpp"
#include "core/tessellate/plot.hpp"

#include <span>
#include <string>

namespace gaspard {

/// One line per run: the values of the keys, the measure, its order (or exponent, see study_order()), the
/// bound of the energy error, iterations, status, and a note where the run did not converge.
std::string study_csv(const StudyPlan& plan, std::span<const StudyPoint> points);
/// The same, with the names of the scenario and its modified keys, as summary.json has them.
std::string study_json(const StudyPlan& plan, std::span<const StudyPoint> points);

/// The measure over what varies, with markers and one colour per line; the bounds of energy errors thin, in
/// the same colours, with one entry in the legend; runs without a result as marks.
Plot study_plot(const StudyPlan& plan, std::span<const StudyPoint> points);
/// "ε = 10⁻⁴"; empty if there is one line only.
std::string line_label(const StudyPlan& plan, std::size_t line);
/// The colour of what belongs to no line.
inline constexpr std::size_t neutral_colour = 7;

} // namespace gaspard

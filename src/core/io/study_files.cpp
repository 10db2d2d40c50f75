#include "core/io/study_files.hpp"

#include "core/base/csv.hpp"
#include "core/base/join.hpp"
#include "core/base/number_text.hpp"
#include "core/layer/layer_pde.hpp"
#include "core/tessellate/ticks.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

namespace gaspard {

namespace {

using Json = nlohmann::ordered_json;

std::string cell(double number) { return std::isfinite(number) ? format_number(number) : std::string(); }
Json or_null(double number) { return std::isfinite(number) ? Json(number) : Json(nullptr); }

std::string status_of(const StudyPoint& point) {
    return std::string(status_name(point.report ? point.report->status : RunStatus::failed));
}

double order_of(const StudyPlan& plan, std::span<const StudyPoint> points, const StudyPoint& point) {
    const StudyPoint* before = point.place > 0 ? find_point(points, point.line, point.place - 1) : nullptr;
    return before && has_orders(plan) ? study_order(plan, *before, point) : std::nan("");
}

std::string bound_formula(const Scenario& scenario) {
    const auto bound = energy_bound(scenario.pde.type, scenario.pde.values, 1);
    return bound ? bound->formula : std::string();
}

bool bounds_apply(const StudyPlan& plan) { return plan.measure.ends_with("energy_error"); }

Axis axis_of(const StudyPlan& plan) {
    const ParameterRow* row = study_row(plan.scenario, plan.over.key);
    if (!row) return {plan.over.key};
    const ParameterRow* lines = study_row(plan.scenario, plan.lines.key);
    const bool twice = lines && lines->symbol == row->symbol; // the symbol alone would be that of the lines
    return {row->symbol.empty() ? row->label
            : twice             ? row->label + " " + row->symbol
                                : row->symbol,
            has_factors(plan.scenario, plan.over.key)};
}

/// The curve of one line, and its bounds.
std::pair<Curve, Curve> curves_of(const StudyPlan& plan, std::span<const StudyPoint> points,
                                  std::size_t line) {
    const std::size_t colour = line % neutral_colour;
    Curve values{line_label(plan, line), {}, {}, true, colour}, bounds{"", {}, {}, false, colour, true};
    bounds.name = (values.label.empty() ? "" : values.label + ": ") + bound_formula(plan.scenario);
    for (std::size_t place = 0; place < plan.over.values.size(); ++place) {
        const StudyPoint* point = find_point(points, line, place);
        if (!point) continue;
        values.x.push_back(point->x), values.y.push_back(study_value(*point, plan.measure));
        if (point->bound && bounds_apply(plan) && point->absence.empty()) // a bound of nothing misleads
            bounds.x.push_back(point->x), bounds.y.push_back(*point->bound);
    }
    return {std::move(values), std::move(bounds)};
}

/// Whether all values that there are can be shown on a logarithmic axis.
bool all_positive(const std::vector<Curve>& curves) {
    for (const Curve& curve : curves)
        for (const double y : curve.y)
            if (y <= 0) return false;
    return true;
}

} // namespace

std::string study_csv(const StudyPlan& plan, std::span<const StudyPoint> points) {
    const bool lines = !plan.lines.key.empty();
    std::vector<std::string> head{plan.over.key, plan.measure, order_name(plan), "bound", "iterations",
                                  "status",      "note"};
    const bool counts = plan.measure == "iterations"; // which has a column of its own
    if (counts) std::erase(head, "iterations"), head.insert(head.begin() + 1, plan.measure);
    if (lines) head.insert(head.begin(), plan.lines.key);
    std::string text = join(head, ",") + '\n';
    for (std::size_t line = 0; line < plan.line_count(); ++line)
        for (std::size_t place = 0; place < plan.over.values.size(); ++place) {
            const StudyPoint* point = find_point(points, line, place);
            if (!point) continue;
            std::vector<std::string> cells{plan.over.values[place],
                                           cell(study_value(*point, plan.measure)),
                                           cell(order_of(plan, points, *point)),
                                           bounds_apply(plan) ? format_number(point->bound) : "",
                                           cell(study_value(*point, "iterations")),
                                           status_of(*point),
                                           csv_text(study_note(*point))};
            if (counts) cells.erase(cells.begin() + 4);
            if (lines) cells.insert(cells.begin(), csv_text(plan.lines.values[line]));
            text += join(cells, ",") + '\n';
        }
    return text;
}

std::string study_json(const StudyPlan& plan, std::span<const StudyPoint> points) {
    const auto axis = [](const StudyAxis& of) {
        return of.key.empty() ? Json(nullptr) : Json{{"key", of.key}, {"values", of.values}};
    };
    Json json{{"scenario", plan.scenario.name}, {"modified", plan.scenario.modified},
              {"over", axis(plan.over)},        {"lines", axis(plan.lines)},
              {"measure", plan.measure},        {"runs", Json::array()}};
    for (const StudyPoint& point : points) {
        Json one{{plan.over.key, point.x}};
        if (!plan.lines.key.empty()) one[plan.lines.key] = plan.lines.values[point.line];
        one[plan.measure] = or_null(study_value(point, plan.measure));
        one[order_name(plan)] = or_null(order_of(plan, points, point));
        if (bounds_apply(plan)) one["bound"] = point.bound ? Json(*point.bound) : Json(nullptr);
        one["iterations"] = or_null(study_value(point, "iterations"));
        one["status"] = status_of(point);
        one["note"] = study_note(point);
        json["runs"].push_back(std::move(one));
    }
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string line_label(const StudyPlan& plan, std::size_t line) {
    if (plan.lines.key.empty()) return {};
    const std::string& value = plan.lines.values[line];
    const ParameterRow* row = study_row(plan.scenario, plan.lines.key);
    if (!row) return value; // of a type
    const auto number = parse_number(value);
    return (row->symbol.empty() ? row->label : row->symbol) + " = " +
           (number ? short_number(*number) : value);
}

Plot study_plot(const StudyPlan& plan, std::span<const StudyPoint> points) {
    Plot plot{.title = scenario_title(plan.scenario), .x = axis_of(plan), .y = {}, .curves = {}};
    std::vector<Curve> bounds;
    for (std::size_t line = 0; line < plan.line_count(); ++line) {
        auto [values, bound] = curves_of(plan, points, line);
        plot.curves.push_back(std::move(values));
        if (!bound.x.empty()) bounds.push_back(std::move(bound));
    }
    plot.y = {measure_label(points, plan.measure), all_positive(plot.curves)};
    plot.y.whole = plan.measure == "iterations" || plan.measure == "tangled_cells";
    if (!points.empty() && std::all_of(points.begin(), points.end(),
                                       [](const StudyPoint& point) { return !point.absence.empty(); }))
        plot.y.label += ", not measured";
    if (!bounds.empty()) {
        bounds.push_back(
            {bound_formula(plan.scenario), {}, {}, false, neutral_colour, true}); // for the legend
        for (Curve& one : bounds) plot.curves.push_back(std::move(one));
    }
    for (const StudyPoint& point : points)
        if (!point.complaint.empty())
            plot.marks.push_back(
                {point.x, (line_label(plan, point.line).empty() ? std::string()
                                                                : line_label(plan, point.line) + ": ") +
                              point.complaint});
    return plot;
}

} // namespace gaspard

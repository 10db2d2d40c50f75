#include "core/io/interpolation_files.hpp"

#include "core/base/join.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace gaspard {

namespace {

using Json = nlohmann::ordered_json;

/// Empty where it is not a number.
std::string cell(double number) { return std::isfinite(number) ? format_number(number) : std::string(); }

Json or_null(double number) { return std::isfinite(number) ? Json(number) : Json(nullptr); }

template <class Number>
Json per_norm(const Number& number) {
    Json json;
    for (const ErrorNorm norm : error_norms) json[std::string(norm_name(norm))] = or_null(number(norm));
    return json;
}

Json of_mesh(const InterpolationError& error) {
    Json json = per_norm([&](ErrorNorm norm) { return error.of(norm); });
    json["uncertainty"] =
        per_norm([&](ErrorNorm norm) { return error.uncertainty[static_cast<std::size_t>(norm)]; });
    json["tangled_cells"] = error.tangled_cells;
    return json;
}

} // namespace

Json interpolation_json(const InterpolationComparison& errors) {
    return {{"uniform", of_mesh(*errors.uniform)},
            {"adapted", of_mesh(*errors.adapted)},
            {"ratio", per_norm([&](ErrorNorm norm) { return errors.ratio(norm); })}};
}

std::string why_csv(const std::vector<InterpolationRow>& rows) {
    std::string text = "n,cells,norm,uniform,uniform_order,adapted,adapted_order,ratio,uniform_uncertainty,"
                       "adapted_uncertainty,tangled_cells,iterations,status\n";
    for (const InterpolationRow& row : rows)
        for (const ErrorNorm norm : error_norms) {
            const auto i = static_cast<std::size_t>(norm);
            const InterpolationError &uniform = *row.errors.uniform, &adapted = *row.errors.adapted;
            const std::vector<std::string> cells{std::to_string(row.resolution),
                                                 std::to_string(row.cells),
                                                 std::string(norm_name(norm)),
                                                 cell(uniform.norm[i]),
                                                 cell(row.uniform_order[i]),
                                                 cell(adapted.norm[i]),
                                                 cell(row.adapted_order[i]),
                                                 cell(row.errors.ratio(norm)),
                                                 cell(uniform.uncertainty[i]),
                                                 cell(adapted.uncertainty[i]),
                                                 std::to_string(adapted.tangled_cells),
                                                 std::to_string(row.iterations),
                                                 std::string(status_name(row.status))};
            text += join(cells, ",") + '\n';
        }
    return text;
}

std::string why_json(const Scenario& scenario, const std::vector<InterpolationRow>& rows) {
    Json json{{"scenario", scenario.name},
              {"modified", scenario.modified},
              {"n", "domain." + resolution_key(scenario)},
              {"rows", Json::array()}};
    for (const InterpolationRow& row : rows) {
        Json one{{"n", row.resolution},
                 {"cells", row.cells},
                 {"status", status_name(row.status)},
                 {"iterations", row.iterations}};
        one.update(interpolation_json(row.errors));
        one["uniform"]["order"] =
            per_norm([&](ErrorNorm norm) { return row.uniform_order[static_cast<std::size_t>(norm)]; });
        one["adapted"]["order"] =
            per_norm([&](ErrorNorm norm) { return row.adapted_order[static_cast<std::size_t>(norm)]; });
        if (const std::string note = interpolation_note(row); !note.empty()) one["note"] = note;
        json["rows"].push_back(std::move(one));
    }
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

Plot why_plot(const std::vector<InterpolationRow>& rows) {
    Plot plot{"Interpolation error", {"number of cells", true}, {"error", true}, {}};
    for (const ErrorNorm norm : error_norms)
        for (const bool uniform : {true, false}) {
            Curve curve{std::string(norm_label(norm)) + (uniform ? ", uniform" : ", adapted"), {}, {}, true};
            for (const InterpolationRow& row : rows) {
                curve.x.push_back(static_cast<double>(row.cells));
                curve.y.push_back((uniform ? row.errors.uniform : row.errors.adapted)->of(norm));
            }
            plot.curves.push_back(std::move(curve));
        }
    return plot;
}

} // namespace gaspard

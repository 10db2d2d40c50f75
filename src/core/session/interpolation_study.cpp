#include "core/session/interpolation_study.hpp"

#include "core/base/check.hpp"
#include "core/base/error.hpp"
#include "core/base/join.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace gaspard {

namespace {

constexpr std::int64_t most_by_itself = 128; // cells per side
constexpr double precise = 0.01;             // relative; less is not worth a note

/// "-" where it is not a number.
std::string printed(double number, std::chars_format format, int precision) {
    if (!std::isfinite(number)) return "-";
    char text[400];
    const auto end = std::to_chars(text, text + sizeof text, number, format, precision).ptr;
    return {text, end};
}
std::string four_digits(double number) { return printed(number, std::chars_format::scientific, 3); }
std::string two_decimals(double number) { return printed(number, std::chars_format::fixed, 2); }

const ParameterRow& resolution_row(const Scenario& scenario) {
    const Values& domain = scenario.domain.values;
    for (const ParameterRow& row : domain.rows())
        if (row.key == "cells" || row.key == "refinements") return row;
    throw InputError("the domain '" + scenario.domain.type + "' has no number of cells to change");
}

double order(double error, double before, double refinement) {
    if (!(error > 0) || !(before > 0)) return std::numeric_limits<double>::quiet_NaN();
    return std::log(before / error) / std::log(refinement);
}

} // namespace

std::string resolution_key(const Scenario& scenario) { return resolution_row(scenario).key; }

std::vector<std::int64_t> usual_resolutions(const Scenario& scenario) {
    const ParameterRow& row = resolution_row(scenario);
    const std::int64_t given = scenario.domain.values.integer(row.key);
    const bool refinements = row.key == "refinements"; // 5: 20 480 triangles
    const std::int64_t most = std::max(given, refinements ? std::int64_t{5} : most_by_itself);
    std::vector<std::int64_t> all;
    for (const std::int64_t one :
         refinements ? std::array{given - 1, given, given + 1} : std::array{given / 2, given, 2 * given})
        if (static_cast<double>(one) >= row.minimum && static_cast<double>(one) <= row.maximum && one <= most)
            all.push_back(one);
    return all;
}

std::vector<std::int64_t> parse_resolutions(const Scenario& scenario, std::string_view text) {
    const ParameterRow& row = resolution_row(scenario);
    std::vector<std::int64_t> all;
    for (const std::string_view part : split(text, ",")) {
        std::int64_t number = 0;
        const auto [end, code] = std::from_chars(part.data(), part.data() + part.size(), number);
        if (code != std::errc{} || end != part.data() + part.size())
            throw InputError("--cells must be a list of integers such as 15,30,60, not '" +
                             std::string(text) + "'");
        if (static_cast<double>(number) < row.minimum || static_cast<double>(number) > row.maximum)
            throw InputError("--cells: " + std::to_string(number) + " is out of range; domain." + row.key +
                             " may be " + describe_range(row));
        all.push_back(number);
    }
    std::sort(all.begin(), all.end());
    if (const auto twice = std::adjacent_find(all.begin(), all.end()); twice != all.end())
        throw InputError("--cells names " + std::to_string(*twice) + " twice");
    return all;
}

Scenario with_resolution(const Catalogue& catalogue, const Scenario& scenario, std::int64_t resolution) {
    Scenario changed = scenario;
    set_value(catalogue, changed, "domain." + resolution_key(scenario), resolution);
    set_value(catalogue, changed, "method.diagnostics", std::string("full"));
    set_value(catalogue, changed, "method.interpolation", true);
    return changed;
}

void check_comparable(const Scenario& scenario) {
    if (scenario.source.type.empty()) return;
    throw InputError(
        "interpolation errors are compared with those of a uniform mesh of the same domain, which domain '" +
        scenario.domain.type + "' does not have: its meshes go from one domain to another");
}

InterpolationRow interpolation_row(Run& run, const InterpolationRow* before, std::stop_token stop) {
    const auto errors = run.interpolation({.stop = std::move(stop)});
    GASPARD_CHECK(errors != nullptr); // with_resolution() switches them on
    const Mesh& mesh = *run.discretisation().mesh();
    InterpolationRow row{.resolution = run.scenario().domain.values.integer(resolution_key(run.scenario())),
                         .cells = mesh.cell_count(),
                         .dimension = cell_dimension(mesh.kind),
                         .status = run.status(),
                         .iterations = run.history().back().all_iterations,
                         .errors = *errors};
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    row.uniform_order = row.adapted_order = {nan, nan, nan};
    if (before == nullptr) return row;
    const double refinement =
        std::pow(static_cast<double>(row.cells) / static_cast<double>(before->cells), 1.0 / row.dimension);
    for (const ErrorNorm norm : error_norms) {
        const auto i = static_cast<std::size_t>(norm);
        row.uniform_order[i] = order(errors->uniform->of(norm), before->errors.uniform->of(norm), refinement);
        row.adapted_order[i] = order(errors->adapted->of(norm), before->errors.adapted->of(norm), refinement);
    }
    return row;
}

std::vector<std::string> interpolation_heads() {
    return {"n", "cells", "error", "uniform", "order", "adapted", "order", "ratio", "status"};
}

std::vector<std::vector<std::string>> interpolation_lines(const InterpolationRow& row) {
    std::vector<std::vector<std::string>> lines;
    for (const ErrorNorm norm : error_norms) {
        const auto i = static_cast<std::size_t>(norm);
        const bool first = lines.empty();
        lines.push_back({first ? std::to_string(row.resolution) : "", first ? std::to_string(row.cells) : "",
                         std::string(norm_label(norm)), four_digits(row.errors.uniform->of(norm)),
                         two_decimals(row.uniform_order[i]), four_digits(row.errors.adapted->of(norm)),
                         two_decimals(row.adapted_order[i]),
                         printed(row.errors.ratio(norm), std::chars_format::general, 3),
                         first ? std::string(status_name(row.status)) : ""});
    }
    return lines;
}

std::string interpolation_note(const InterpolationRow& row) {
    std::vector<std::string> notes;
    const InterpolationError &uniform = *row.errors.uniform, &adapted = *row.errors.adapted;
    if (row.errors.exact()) notes.emplace_back("both meshes interpolate the function exactly");
    if (adapted.tangled_cells > 0)
        notes.push_back(std::to_string(adapted.tangled_cells) +
                        " cells of the adapted mesh fold, where its H1 error is not defined");
    double worst = 0;
    for (const InterpolationError* of : {&uniform, &adapted})
        worst = std::max({worst, of->uncertainty[0], of->uncertainty[2]});
    if (worst > precise)
        notes.push_back("the function varies so much within cells that the integrals are known to " +
                        printed(100 * worst, std::chars_format::fixed, 0) + " % only");
    if (notes.empty()) return {};
    return "n = " + std::to_string(row.resolution) + ": " + join(notes, "; ");
}

} // namespace gaspard

#include "core/io/run_files.hpp"

#include "core/base/error.hpp"
#include "core/base/read_file.hpp"
#include "core/base/version.hpp"
#include "core/diagnostics/cell_quality.hpp"
#include "core/diagnostics/quality.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/history_file.hpp"
#include "core/io/interpolation_files.hpp"
#include "core/io/section_files.hpp"
#include "core/io/spline_map_file.hpp"
#include "core/io/state_file.hpp"
#include "core/method/spline_map.hpp"
#include "core/scenario/time_rows.hpp"
#include "core/session/time_series.hpp"

#include <algorithm>
#include <exception>
#include <nlohmann/json.hpp>
#include <sys/resource.h>
#include <utility>

namespace gaspard {

namespace {

using Json = nlohmann::ordered_json;

template <class T>
Json or_null(const std::optional<T>& value) {
    return value ? Json(*value) : Json(nullptr);
}

Json section_json(const Section& section) {
    Json json;
    if (!section.type.empty()) json["type"] = section.type;
    for (const auto& row : section.values.rows())
        std::visit([&](const auto& value) { json[row.key] = value; }, section.values.at(row.key));
    return json;
}

std::uint64_t peak_memory_bytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024; // Linux counts in KiB
}

bool is_of_splines(const Run& run) {
    return run.discretisation().patch_map() || run.discretisation().solid_map();
}

std::shared_ptr<const SplinePatch> patch_of(const Run& run) {
    const auto patch_map = run.discretisation().patch_map();
    const auto solid_map = run.discretisation().solid_map();
    auto patch = patch_map   ? adapted_patch(run.state(), *patch_map)
                 : solid_map ? adapted_patch(run.state(), *solid_map)
                             : std::nullopt;
    return patch ? std::make_shared<const SplinePatch>(std::move(*patch)) : nullptr;
}

/// The method's further series, under "measures".
void add_measures(Json& json, const StepReport& report) {
    const SeriesTable& table = *report.series;
    for (std::size_t i = table.first_of_method(); i < table.all().size(); ++i)
        if (const std::string& name = table.all()[i].name; !json.contains(name))
            json["measures"][name] = or_null(report.value(i));
}

/// The values that determine the mesh.
Json values_json(const Scenario& scenario) {
    Json json;
    json["domain"] = section_json(scenario.domain);
    json["monitor"] = section_json(scenario.monitor);
    json["method"] = section_json(scenario.method);
    for (const Section* section : {&scenario.source, &scenario.pde})
        if (!section->type.empty()) json[section->values.section()] = section_json(*section);
    if (has_time(scenario.time)) json["time"] = section_json({"", scenario.time});
    return json;
}

} // namespace

/// Null if nothing is measured, or the function is interpolated exactly, or has no value somewhere.
static Json interpolation_of(Run& run, std::stop_token stop) {
    try {
        // A solid has many cells, each of which is divided into eight.
        const bool solid = cell_dimension(run.discretisation().mesh()->kind) == 3;
        const auto errors = run.interpolation({.tolerance = solid ? 1e-1 : 1e-2,
                                               .parts = solid ? std::size_t{10} : std::size_t{100},
                                               .stop = std::move(stop)});
        if (errors && !errors->exact()) return interpolation_json(*errors);
    } catch (const InputError&) { // the function; the monitor made of it has values
    }
    return nullptr;
}

/// Worst and mean of every measure; null where cells are lines.
static Json cell_quality_of(Run& run) {
    const auto snapshot = run.snapshot();
    if (!has_quality(snapshot->mesh->kind)) return nullptr;
    const CellQualityMeter meter(snapshot->mesh);
    const SeriesValues values = values_of(meter.measure(snapshot->x, snapshot->field("monitor")->values));
    const double* next = values.begin();
    Json json;
    for (const QualityMeasureInfo& measure : quality_measures())
        for (const char* part : {"worst", "mean"}) json[measure.name][part] = *next++;
    return json;
}

std::string summary_json(Run& run, std::stop_token stop) {
    const Json interpolation = interpolation_of(run, std::move(stop));
    const Scenario& scenario = run.scenario();
    const StepReport& last = run.history().back();
    Json json;
    json["scenario"] = scenario.name;
    json["modified"] = scenario.modified;
    json.update(values_json(scenario));
    if (const auto patches = run.discretisation().patches()) json["patch"] = patches->note;
    if (const auto report = run.monitor_report(); report && !report->notes.empty())
        json["monitor_notes"] = report->notes;
    json["cells"] = run.discretisation().mesh()->cell_count();
    json["unknowns"] = run.discretisation().unknowns();
    json["status"] = status_name(last.status);
    json["iterations"] = last.all_iterations;
    json["residual"] = last.residual;
    for (const char* name : {"equidistribution", "theta"}) json[name] = or_null(last.value(name));
    json["tangled_cells"] = or_null(last.tangled_cells);
    if (const auto folded = last.value(folded_drawn_cells_series().name))
        json["folded_drawn_cells"] = static_cast<std::size_t>(*folded);
    for (const char* name : {"min_jacobian", "max_jacobian", "exact_rms", "exact_rms_nodes"})
        json[name] = or_null(last.value(name));
    add_measures(json, last);
    json["cell_quality"] = cell_quality_of(run);
    json["interpolation"] = interpolation;
    json["setup_seconds"] = run.setup_seconds();
    json["solve_seconds"] = last.seconds;
    json["cpu_seconds"] = last.cpu_seconds;
    json["seconds_per_iteration"] =
        last.all_iterations > 0 ? Json(last.seconds / last.all_iterations) : Json(nullptr);
    json["peak_memory_bytes"] = peak_memory_bytes();
    json["version"] = version();
    int inner = 0;
    std::string notes, before;
    for (const auto& row : run.history()) {
        inner += row.inner_iterations;
        if (std::exchange(before, row.note) == row.note || row.note.empty()) continue; // said already
        notes += (notes.empty() ? "" : "; ") + std::to_string(row.iteration) + ": " + row.note;
    }
    json["inner_iterations"] = inner;
    json["note"] = notes; // of all iterations that have one, each once
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::vector<std::string> run_file_names(const Run& run, const std::vector<const Format*>& formats) {
    std::vector<std::string> names{"history.csv", "summary.json", "state.bin"};
    if (is_of_splines(run)) names.emplace_back("map.json");
    if (has_section_files(*run.discretisation().mesh(), run.scenario().view))
        names.insert(names.end(), section_file_names.begin(), section_file_names.end());
    for (const Format* format : formats)
        names.insert(names.end(), format->files.begin(), format->files.end());
    return names;
}

std::vector<std::string> possible_run_file_names() {
    std::vector<std::string> names{"history.csv", "summary.json", "state.bin", "map.json"};
    names.insert(names.end(), section_file_names.begin(), section_file_names.end());
    for (const Format& format : formats())
        names.insert(names.end(), format.files.begin(), format.files.end());
    return names;
}

bool holds_other_values(const std::filesystem::path& folder, const Scenario& scenario) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(folder / "summary.json", ignored)) return false;
    try {
        const Json before = Json::parse(read_file(folder / "summary.json"), nullptr, false);
        const Json now = values_json(scenario);
        if (!before.is_object()) return false;
        for (const auto& [section, values] : now.items())
            if (!before.contains(section) || before[section] != values) return true;
    } catch (const InputError&) { // there is no summary
    }
    return false;
}

void write_run_files(const std::filesystem::path& folder, Run& run, const std::vector<const Format*>& formats,
                     const Progress& progress, std::stop_token stop, HistoryFile* history) {
    run.complete();
    make_folder(folder);
    std::exception_ptr first;
    const bool of_splines = is_of_splines(run);
    const bool of_section = has_section_files(*run.discretisation().mesh(), run.scenario().view);
    const double all = (of_splines ? 4 : 3) + (of_section ? 1 : 0) + static_cast<double>(formats.size());
    double done = 0;
    const auto attempt = [&](const std::string& what, const auto& write) {
        if (stop.stop_requested()) throw Interrupted();
        if (progress) progress(done++ / all, "writing " + what);
        try {
            write();
        } catch (const MachineError&) {
            if (!first) first = std::current_exception();
        }
    };
    // First, because it tells of which run the other files are (run_folder.hpp).
    attempt("summary.json", [&] { write_atomically(folder / "summary.json", summary_json(run, stop)); });
    attempt("history.csv", [&] {
        if (history) return history->finish(run);
        write_atomically(folder / "history.csv", history_csv(run.history()));
    });
    attempt("state.bin", [&] { write_state(folder / "state.bin", run.state()); });
    if (of_splines)
        attempt("map.json", [&] { write_atomically(folder / "map.json", *spline_map_json(run.state())); });
    const bool patch_wanted = std::any_of(formats.begin(), formats.end(),
                                          [](const Format* format) { return format->splines_only; });
    const auto snapshot = run.snapshot();
    const RunResult result{*snapshot,
                           run.history(),
                           run.space(),
                           run.scenario().view,
                           run.scenario().output.real("curve_tolerance"),
                           patch_wanted ? patch_of(run) : nullptr,
                           scenario_title(run.scenario()),
                           tolerance_of(run.scenario(), run.history().back())};
    if (of_section)
        attempt("section.csv", [&] { write_section_files(folder, *snapshot, run.scenario().view); });
    for (const auto* format : formats) attempt(format->files.front(), [&] { format->write(folder, result); });
    if (first) std::rethrow_exception(first);
}

} // namespace gaspard

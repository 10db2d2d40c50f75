#include "cli/commands.hpp"
#include "cli/exit_code.hpp"
#include "cli/interrupt_watch.hpp"
#include "cli/scenario_input.hpp"
#include "core/base/error.hpp"
#include "core/base/user_path.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/image.hpp"
#include "core/io/run_folder.hpp"
#include "core/io/study_files.hpp"
#include "core/io/svg.hpp"
#include "core/session/interpolation_study.hpp"
#include "core/session/layer_study.hpp"
#include "gui/app/viewport_image.hpp"
#include "gui/gl/offscreen.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <optional>
#include <thread>
#include <utility>

namespace gaspard {

namespace {

/// The study of the window over this key; nullopt if that has none.
std::optional<StudyPlan> layer_study(const Catalogue& catalogue, const Scenario& scenario,
                                     const std::string& key) {
    for (const StudyVariable& variable : study_variables(scenario))
        if (study_key(scenario, variable) == key) return usual_study(catalogue, scenario, variable);
    return std::nullopt;
}

StudyPlan plan_over_cells(const Catalogue& catalogue, const Scenario& scenario) {
    if (auto plan = layer_study(catalogue, scenario, "domain.cells")) return *std::move(plan);
    StudyPlan plan{.scenario = scenario, .over = {.key = "domain." + resolution_key(scenario)}};
    for (const std::int64_t one : usual_resolutions(scenario))
        plan.over.values.push_back(std::to_string(one));
    return plan;
}

/// `over`: KEY=VALUES, or a key alone.
StudyPlan plan_over(const Catalogue& catalogue, const Scenario& scenario, const std::string& over) {
    if (over.find('=') != std::string::npos)
        return {.scenario = scenario, .over = parse_study_numbers(catalogue, scenario, over, "--over")};
    if (auto plan = layer_study(catalogue, scenario, over)) return *std::move(plan);
    Scenario copy = scenario;
    check_key(catalogue, copy, over);
    if (over == "domain.cells" || over == "domain.refinements") return plan_over_cells(catalogue, scenario);
    return {.scenario = scenario, .over = usual_axis(catalogue, scenario, over)};
}

/// What the options leave open is that of usual_study(), or of a problem without PDE the equidistribution
/// over the usual numbers of cells.
StudyPlan make_plan(const Catalogue& catalogue, const Scenario& scenario, const StudyArguments& arguments) {
    StudyPlan plan = arguments.over ? plan_over(catalogue, scenario, *arguments.over)
                                    : plan_over_cells(catalogue, scenario);
    plan.scenario = scenario;
    const bool layers = !study_variables(scenario).empty();
    plan.measure = arguments.measure.value_or(layers ? "energy_error" : "equidistribution");
    if (arguments.lines) plan.lines = parse_study_axis(catalogue, scenario, *arguments.lines, "--lines");
    return plan;
}

/// "-" where it is not a number.
std::string printed(double number, std::chars_format format, int precision) {
    if (!std::isfinite(number)) return "-";
    char text[400];
    return {text, std::to_chars(text, text + sizeof text, number, format, precision).ptr};
}
std::string four_digits(double number) { return printed(number, std::chars_format::scientific, 3); }
std::string two_decimals(double number) { return printed(number, std::chars_format::fixed, 2); }

/// A row of the table for each value of what varies; two columns for each line.
class Table {
  public:
    explicit Table(const StudyPlan& plan) : plan_(plan) {
        first_ = plan.over.key.size();
        for (const std::string& value : plan.over.values) first_ = std::max(first_, value.size());
        std::printf("%s of %s\n", plan.measure.c_str(), plan.scenario.name.c_str());
        std::printf("%*s", static_cast<int>(first_), plan.over.key.c_str());
        for (std::size_t line = 0; line < plan.line_count(); ++line) {
            widths_.push_back(std::max<std::size_t>(10, head(line).size()));
            std::printf("  %*s", width(line), head(line).c_str());
            if (has_orders(plan)) std::printf("  %s", order_name(plan).c_str());
        }
        std::printf("\n");
    }
    /// After the last run of a row, all of its runs.
    void add(const std::vector<StudyPoint>& points) const {
        const StudyPoint& last = points.back();
        if (last.line + 1 < plan_.line_count()) return;
        std::printf("%*s", static_cast<int>(first_), plan_.over.values[last.place].c_str());
        for (std::size_t line = 0; line < plan_.line_count(); ++line) print(points, line, last.place);
        std::printf("\n");
        for (std::size_t line = 0; line < plan_.line_count(); ++line) {
            const StudyPoint& point = *find_point(points, line, last.place);
            const std::string note = study_note(point);
            if (note.empty() || note == point.absence) continue; // said once, below the table
            const std::string name = plan_.lines.key.empty() ? "" : head(line) + ", ";
            std::printf("%s%s=%s: %s\n", name.c_str(), plan_.over.key.c_str(),
                        plan_.over.values[last.place].c_str(), note.c_str());
        }
        std::fflush(stdout);
    }

  private:
    std::string head(std::size_t line) const {
        return plan_.lines.key.empty() ? plan_.measure : plan_.lines.key + "=" + plan_.lines.values[line];
    }
    int width(std::size_t line) const { return static_cast<int>(widths_[line]); }
    void print(const std::vector<StudyPoint>& points, std::size_t line, std::size_t place) const {
        const StudyPoint* point = find_point(points, line, place);
        std::printf("  %*s", width(line), four_digits(study_value(*point, plan_.measure)).c_str());
        if (!has_orders(plan_)) return;
        const StudyPoint* before = place > 0 ? find_point(points, line, place - 1) : nullptr;
        const double order = before ? study_order(plan_, *before, *point) : std::nan("");
        std::printf("  %*s", static_cast<int>(order_name(plan_).size()), two_decimals(order).c_str());
    }

    const StudyPlan& plan_;
    std::size_t first_ = 0;
    std::vector<std::size_t> widths_;
};

/// That of the first run that did not converge.
int code_of(const std::vector<StudyPoint>& points) {
    for (const StudyPoint& point : points) {
        const int code = point.report    ? exit_code(point.report->status)
                         : point.refused ? exit_input
                                         : exit_fault;
        if (code != 0) return code;
    }
    return 0;
}

} // namespace

int study_command(std::shared_ptr<const Catalogue> catalogue, const StudyArguments& arguments) {
    ScenarioInput input = load_input(*catalogue, arguments.scenario, arguments.settings);
    check_input(*catalogue, input);
    const StudyPlan plan = make_plan(*catalogue, input.scenario, arguments);
    const std::filesystem::path folder =
        arguments.out.empty() ? std::filesystem::path("gaspard-out") / (plan.scenario.name + "-study")
                              : user_path(arguments.out);
    check_domain(*catalogue, input);
    if (!arguments.no_render) check_offscreen_choice();
    const std::vector<std::string> names{"study.csv", "study.json", "study.svg", "study.png"};
    check_no_folders(folder, names);
    if (!arguments.overwrite && !arguments.out.empty()) // the default folder has the scenario's name
        check_replaceable(folder, names, "study.json", plan.scenario.name);
    const InterruptWatch interrupt; // once the input is read: a signal ends a program that waits for it
    check_study(catalogue, plan);
    check_writable(folder);
    const Table table(plan);
    std::vector<StudyPoint> points;
    const auto threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    run_study(
        catalogue, plan, threads,
        [&](StudyPoint point) { points.push_back(std::move(point)), table.add(points); }, interrupt.token());
    for (const std::string& absence : study_absences(points)) std::printf("-: %s\n", absence.c_str());
    const bool stopped = interrupt.token().stop_requested();
    const int code = stopped ? exit_code(RunStatus::interrupted) : code_of(points);
    if (points.empty()) {
        std::fprintf(stderr, "gaspard: interrupted before the first run; nothing was written\n");
        return code;
    }
    const bool draws = !arguments.no_render && !stopped;
    if (!draws) print_left_over(left_over(folder, names, {"study.csv", "study.json", "study.svg"}));
    write_atomically(folder / "study.json", study_json(plan, points)); // first: what the others are about
    write_atomically(folder / "study.csv", study_csv(plan, points));
    const Plot plot = study_plot(plan, points);
    write_svg(folder / "study.svg", plot);
    if (draws) write_png(folder / "study.png", render_panels({plot}, 1, 900, 675));
    std::printf("files in %s\n", folder.string().c_str());
    return code;
}

} // namespace gaspard

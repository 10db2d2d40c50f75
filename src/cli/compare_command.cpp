#include "cli/commands.hpp"
#include "cli/exit_code.hpp"
#include "cli/interrupt_watch.hpp"
#include "cli/scenario_input.hpp"
#include "core/base/error.hpp"
#include "core/base/join.hpp"
#include "core/base/user_path.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/history_file.hpp"
#include "core/io/image.hpp"
#include "core/io/run_folder.hpp"
#include "core/session/comparison.hpp"
#include "core/session/report_columns.hpp"
#include "core/session/run.hpp"
#include "gui/app/viewport_image.hpp"
#include "gui/gl/offscreen.hpp"

#include <algorithm>
#include <cstdio>
#include <thread>

namespace gaspard {

namespace {

std::vector<std::string> chosen_methods(const Catalogue& catalogue, const Scenario& scenario,
                                        const std::optional<std::string>& list) {
    if (!list) return methods_for(catalogue, scenario);
    std::vector<std::string> names;
    for (const std::string_view part : split(*list, ",")) {
        const std::string name(part);
        catalogue.method(name); // throws if it is unknown
        if (std::find(names.begin(), names.end(), name) != names.end())
            throw InputError("--methods names '" + name + "' twice");
        check(catalogue, with_method(catalogue, scenario, name));
        names.push_back(name);
    }
    return names;
}

void print_cells(const std::vector<std::string>& cells) {
    static const std::vector<std::string> heads = comparison_heads();
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const char* cell = cells[i].c_str();
        if (i == 0)
            std::printf("%-14s", cell);
        else if (i + 1 < cells.size())
            std::printf("  %*s", static_cast<int>(std::max(heads[i].size(), std::size_t{10})), cell);
        else
            std::printf("  %s\n", cell);
    }
    std::fflush(stdout);
}

/// The results of all methods: residual curves and meshes. Residuals are those on the mesh of the run, which
/// are the same measure for all methods; series of a method's own that end it are a plot of their own.
struct Outcome {
    explicit Outcome(const Scenario& scenario) {
        residual.x.label = criteria.x.label = comparison_axis(scenario);
    }
    Plot residual{"Residual", {}, {"normalised residual", true}, {}};
    Plot against_time{"Residual over CPU time", {"CPU seconds", true}, {"normalised residual", true}, {}};
    Plot criteria{"Other stopping criteria", {}, {"", true}, {}};
    std::vector<Panel> meshes;

    void add(const std::string& method, Run& run, const std::string& status) {
        const SeriesInfo* criterion = other_criterion(run.history().back());
        Curve curve{method, {}, {}}, timed{method, {}, {}}, own;
        if (criterion) own.label = method + ": " + criterion->name;
        for (const auto& [x, report] : comparison_points(run.scenario(), run.history())) {
            curve.x.push_back(x), curve.y.push_back(report->residual);
            if (criterion) own.x.push_back(x), own.y.push_back(*report->value(criterion->name));
            if (report->cpu_seconds <= 0) continue;
            timed.x.push_back(report->cpu_seconds), timed.y.push_back(report->residual);
        }
        curve.colour = timed.colour = own.colour = meshes.size();
        residual.curves.push_back(std::move(curve));
        against_time.curves.push_back(std::move(timed));
        if (criterion) criteria.curves.push_back(std::move(own));
        meshes.emplace_back(MeshPanel{.title = method + ": " + status,
                                      .snapshot = run.snapshot(),
                                      .colour = "monitor",
                                      .blend = 1,
                                      .camera = run.scenario().view.text("camera")});
    }
    Image draw() const {
        std::vector<Panel> panels{residual, against_time};
        if (!criteria.curves.empty()) panels.emplace_back(criteria);
        panels.insert(panels.end(), meshes.begin(), meshes.end());
        const int columns = panels.size() > 4 ? 4 : 2;
        const int rows = (static_cast<int>(panels.size()) + columns - 1) / columns;
        return render_panels(panels, columns, 600 * columns, 600 * rows);
    }
};

std::vector<std::string> comparison_file_names(const std::vector<std::string>& methods) {
    std::vector<std::string> names{"comparison.csv", "comparison.json", "comparison.png"};
    for (const std::string& method : methods) names.push_back(method + ".csv");
    return names;
}

} // namespace

int compare_command(std::shared_ptr<const Catalogue> catalogue, const CompareArguments& arguments) {
    ScenarioInput input = load_input(*catalogue, arguments.scenario, arguments.settings);
    check_input(*catalogue, input);
    const Scenario& scenario = input.scenario;
    const auto methods = chosen_methods(*catalogue, scenario, arguments.methods);
    const std::filesystem::path folder =
        arguments.out.empty() ? std::filesystem::path("gaspard-out") / (scenario.name + "-methods")
                              : user_path(arguments.out);
    check_domain(*catalogue, input);
    if (!arguments.no_render) check_offscreen_choice();
    check_no_folders(folder, comparison_file_names(methods));
    if (!arguments.overwrite && !arguments.out.empty()) // the default folder has the scenario's name
        check_replaceable(folder, comparison_file_names(methods), "comparison.json", scenario.name);
    const InterruptWatch interrupt; // once the input is read: a signal ends a program that waits for it
    check_writable(folder);
    std::vector<ComparisonRow> rows;
    Outcome outcome(scenario);
    bool failed = false;
    bool recorded = false;
    const auto record = [&] { // before the files that it is about
        if (recorded) return;
        std::vector<std::string> written = comparison_file_names(methods), possible;
        if (arguments.no_render) std::erase(written, "comparison.png");
        for (const MethodType& method : catalogue->methods) possible.push_back(method.name);
        print_left_over(left_over(folder, comparison_file_names(possible), written));
        write_atomically(folder / "comparison.json", record_json(scenario));
        recorded = true;
    };
    // Sequentially, so that CPU times are comparable.
    for (const std::string& method : methods) {
        if (interrupt.token().stop_requested()) break;
        try {
            Run run(catalogue, with_method(*catalogue, scenario, method),
                    {.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()))}, {},
                    interrupt.token());
            run.solve(interrupt.token());
            if (rows.empty()) print_cells(comparison_heads());
            rows.push_back(comparison_row(method, run.history()));
            print_cells(comparison_cells(rows.back()));
            if (run.status() == RunStatus::invalid_input)
                std::printf("%s: %s\n", method.c_str(), run.history().back().note.c_str());
            record();
            write_atomically(folder / (method + ".csv"), history_csv(run.history()));
            outcome.add(method, run, std::string(status_name(run.status())));
        } catch (const Interrupted&) { // before its first iteration
            break;
        } catch (const InputError& error) { // such as a method that needs a PDE, if the user has not named it
            if (arguments.methods || (rows.empty() && method == methods.back())) throw;
            std::fprintf(stderr, "gaspard: %s is left out: %s\n", method.c_str(), error.what());
        } catch (const std::exception& error) { // this method failed; continue with the others
            std::fprintf(stderr, "gaspard: %s: %s\n", method.c_str(), error.what());
            failed = true;
        }
    }
    record();
    write_atomically(folder / "comparison.csv", comparison_csv(rows));
    if (!arguments.no_render && !rows.empty()) write_png(folder / "comparison.png", outcome.draw());
    std::printf("files in %s\n", folder.string().c_str());
    if (interrupt.token().stop_requested()) return exit_code(RunStatus::interrupted);
    return failed ? exit_code(RunStatus::failed) : 0;
}

} // namespace gaspard

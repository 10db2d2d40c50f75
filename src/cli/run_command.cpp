#include "cli/commands.hpp"
#include "cli/exit_code.hpp"
#include "cli/interrupt_watch.hpp"
#include "cli/progress_line.hpp"
#include "cli/scenario_input.hpp"
#include "core/base/counted.hpp"
#include "core/base/error.hpp"
#include "core/base/user_path.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/history_file.hpp"
#include "core/io/image.hpp"
#include "core/io/run_files.hpp"
#include "core/io/run_folder.hpp"
#include "core/io/state_file.hpp"
#include "core/session/report_columns.hpp"
#include "core/session/run.hpp"
#include "core/session/time_series.hpp"
#include "core/tessellate/snapshot_section.hpp"
#include "gui/app/viewport_image.hpp"
#include "gui/app/whole_window.hpp"
#include "gui/gl/offscreen.hpp"
#include "gui/viewport/viewport.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <iostream>
#include <optional>
#include <stop_token>
#include <thread>

namespace gaspard {

namespace {

/// Options are settings under another name; they take precedence over --set.
std::vector<std::string> settings_of(const RunArguments& arguments) {
    std::vector<std::string> settings = arguments.settings;
    const auto add = [&](const char* key, const std::optional<std::string>& value) {
        if (value) settings.push_back(std::string(key) + "=" + *value);
    };
    add("method.tolerance", arguments.tolerance);
    add("method.max_iterations", arguments.max_iterations);
    add("output.formats", arguments.formats);
    if (arguments.size)
        for (std::string& setting : size_settings(*arguments.size)) settings.push_back(std::move(setting));
    return settings;
}

ScenarioInput input_of(const Catalogue& catalogue, const RunArguments& arguments) {
    ScenarioInput input = load_input(catalogue, arguments.scenario, settings_of(arguments));
    if (arguments.seed) {
        bool used = false;
        for (Values* monitor : {&input.scenario.monitor.values, &input.scenario.source.values})
            if (const ParameterRow* row = find_role(monitor->rows(), ParameterRole::seed)) {
                monitor->parse(row->key, *arguments.seed);
                used = true;
            }
        if (!used)
            throw InputError("--seed does not apply: the monitor of scenario '" + input.scenario.name +
                             "' uses no random numbers");
    }
    note_changes(input); // the seed
    check_input(catalogue, input);
    return input;
}

int threads_of(const RunArguments& arguments) {
    if (!arguments.threads) return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    const std::string& text = *arguments.threads;
    int threads = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), threads);
    if (code != std::errc{} || end != text.data() + text.size() || threads < 1 || threads > 1024)
        throw InputError("--threads must be an integer from 1 to 1024, not '" + text + "'");
    return threads;
}

/// What a run says of its progress; the equidistribution is the last one measured.
class RunProgress {
  public:
    explicit RunProgress(bool quiet) : line_(quiet) {}
    void show(const StepReport& report) {
        if (const auto value = report.value("equidistribution")) equidistribution_ = value;
        if (!line_.due()) return;
        const double rate = report.seconds > 0 ? report.iteration / report.seconds : 0;
        std::array<char, 64> measured{};
        std::array<char, 256> text{};
        if (equidistribution_)
            std::snprintf(measured.data(), measured.size(), "equidistribution %.3e  ", *equidistribution_);
        std::snprintf(text.data(), text.size(), "iteration %d  residual %.3e  %s%.0f iterations/s",
                      report.iteration, report.residual, measured.data(), rate);
        line_.show(text.data());
    }

  private:
    ProgressLine line_;
    std::optional<double> equidistribution_;
};

void iterate(Run& run, bool quiet, HistoryFile* history, const std::stop_token& stop) {
    RunProgress progress(quiet);
    while (run.status() == RunStatus::running) {
        if (stop.stop_requested()) return run.interrupt();
        try {
            const StepReport& report = run.step(stop);
            if (history) history->add(report);
            progress.show(report);
        } catch (const Interrupted&) { // in the middle: the iterate before it is there
            if (!stop.stop_requested()) throw;
        }
    }
}

/// How many have been made; the history has the first and the last, and at the end one that was given up.
int time_steps(const std::vector<StepReport>& history) {
    const auto first = std::ranges::find_if(history, is_time_step);
    if (first == history.end()) return 0;
    return history.back().iteration - first->iteration + (is_given_up(history.back()) ? 0 : 1);
}

void print_outcome(const Run& run, const std::filesystem::path& folder, bool other_values) {
    const StepReport& last = run.history().back();
    const std::string status(status_name(last.status));
    if (const auto time = time_of(last))
        std::printf("%s at t = %s after %s: residual %.3e, ", status.c_str(), format_number(*time).c_str(),
                    counted(time_steps(run.history()), "time step").c_str(), last.residual);
    else
        std::printf("%s after %s: residual %.3e, ", status.c_str(),
                    counted(last.iteration, "iteration").c_str(), last.residual);
    if (const SeriesInfo* criterion = other_criterion(last))
        std::printf("%s %.3e, ", criterion->name.c_str(), last.value(criterion->name).value_or(0));
    if (const auto value = last.value("equidistribution")) // measured only with method.diagnostics=full
        std::printf("equidistribution %.6e, ", *value);
    std::printf("%zu tangled cells, %.3f s\n", last.tangled_cells.value_or(0), last.seconds);
    if (!last.note.empty()) std::printf("%s\n", last.note.c_str());
    if (const auto patches = run.discretisation().patches())
        std::printf("%s; domain.patch selects another\n", patches->note.c_str());
    std::printf("files in %s%s\n", folder.string().c_str(),
                other_values ? " (they replace those of a run with other values)" : "");
}

void draw_view(std::shared_ptr<const Catalogue> catalogue, Run& run, const std::filesystem::path& folder,
               bool whole_window, std::stop_token stop) {
    if (stop.stop_requested()) throw Interrupted();
    const Scenario& scenario = run.scenario();
    const auto width = static_cast<int>(scenario.view.integer("width"));
    const auto height = static_cast<int>(scenario.view.integer("height"));
    if (const std::string note = missing_note(scenario.view, *run.snapshot()); !note.empty())
        std::cerr << "gaspard: " << note << "\n";
    if (whole_window)
        return write_png(folder / "view.png",
                         render_whole_window(std::move(catalogue), {scenario, run.history(), run.snapshot()},
                                             width, height),
                         scenario.view.real("dpi"));
    write_png(folder / "view.png",
              render_view(*run.snapshot(), scenario.view, width, height, scenario_title(scenario),
                          {.stop = std::move(stop)}),
              scenario.view.real("dpi"));
}

} // namespace

std::vector<std::string> size_settings(const std::string& size) {
    const auto cross = size.find('x');
    const auto is_number = [](std::string_view text) {
        return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
    };
    const std::string_view text = size;
    if (cross == std::string::npos || !is_number(text.substr(0, cross)) || !is_number(text.substr(cross + 1)))
        throw InputError("--size must be WIDTHxHEIGHT, such as 1200x900, not '" + size + "'");
    return {"view.width=" + size.substr(0, cross), "view.height=" + size.substr(cross + 1)};
}

int run_command(std::shared_ptr<const Catalogue> catalogue, const RunArguments& arguments) {
    // Check all input before the first iteration.
    const ScenarioInput input = input_of(*catalogue, arguments);
    const Scenario& scenario = input.scenario;
    RunOptions options{.threads = threads_of(arguments)};
    if (arguments.start) options.start = read_state(user_path(*arguments.start));
    InterruptWatch interrupt; // once the input is read: a signal ends a program that waits for it
    const std::filesystem::path folder = arguments.out.empty()
                                             ? std::filesystem::path("gaspard-out") / scenario.name
                                             : user_path(arguments.out);

    try {
        Run run(catalogue, scenario, std::move(options), {}, interrupt.token());
        check_with_mesh(input, *run.discretisation().mesh());
        if (!arguments.no_render) check_offscreen_choice();
        std::vector<std::string> names = run_file_names(run, input.formats);
        if (!arguments.no_render) names.emplace_back("view.png");
        check_no_folders(folder, names);
        if (!arguments.overwrite && !arguments.out.empty()) // the default folder has the scenario's name
            check_replaceable(folder, names, "summary.json", scenario.name);
        const bool other_values = holds_other_values(folder, scenario);
        const auto made = check_writable(folder); // after all checks of the input
        if (const auto report = run.monitor_report(); report && !arguments.quiet) {
            for (const std::string& note : report->notes) std::printf("%s\n", note.c_str());
            std::fflush(stdout);
        }
        std::optional<HistoryFile> history; // of all time steps, of which the run keeps some
        if (run.time()) {
            remove_unfinished(folder);
            history.emplace(folder / "history.csv", run);
        }
        iterate(run, arguments.quiet, history ? &*history : nullptr, interrupt.token());
        if (!arguments.quiet)
            print_outcome(run, folder, other_values);
        else if (run.status() == RunStatus::invalid_input)
            std::cerr << "gaspard: " << run.history().back().note << "\n";
        const std::stop_token stop = interrupt.restart(); // what was interrupted is written, too
        std::exception_ptr failure;                       // rethrown after the other files are written
        std::vector<std::string> possible = possible_run_file_names();
        possible.emplace_back("view.png");
        if (other_values && !arguments.quiet) print_left_over(left_over(folder, possible, names));
        try {
            try {
                write_run_files(folder, run, input.formats, {}, stop, history ? &*history : nullptr);
            } catch (const MachineError&) {
                failure = std::current_exception();
            }
            if (!arguments.no_render) draw_view(catalogue, run, folder, arguments.whole_window, stop);
        } catch (const Interrupted&) {
            history.reset(); // and its temporary file
            remove_empty(made);
            std::cerr << "gaspard: interrupted while files were written; each file in " << folder.string()
                      << " is complete, but some are missing or of an earlier run\n";
            return exit_code(RunStatus::interrupted);
        }
        if (failure) std::rethrow_exception(failure);
        if (const std::string note = note_on_hidden(*run.snapshot(), scenario.view); !note.empty())
            std::cerr << "gaspard: " << note << "\n";
        return exit_code(run.status());
    } catch (const Interrupted&) {
        std::cerr << "gaspard: interrupted before the first iteration; nothing was written\n";
        return exit_code(RunStatus::interrupted);
    }
}

} // namespace gaspard

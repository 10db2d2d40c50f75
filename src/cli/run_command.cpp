#include "cli/commands.hpp"
#include "cli/exit_code.hpp"
#include "cli/interrupt_watch.hpp"
#include "core/base/error.hpp"
#include "core/base/stopwatch.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/formats.hpp"
#include "core/io/image.hpp"
#include "core/io/run_files.hpp"
#include "core/io/state_file.hpp"
#include "core/io/svg.hpp"
#include "core/scenario/toml.hpp"
#include "core/session/report_columns.hpp"
#include "core/session/run.hpp"
#include "core/tessellate/check_view.hpp"
#include "gui/app/viewport_image.hpp"
#include "gui/app/whole_window.hpp"
#include "gui/gl/offscreen.hpp"
#include "gui/viewport/viewport.hpp"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <iostream>
#include <thread>
#include <unistd.h>

namespace gaspard {

namespace {

Scenario scenario_of(const Catalogue& catalogue, const RunArguments& arguments) {
    Scenario scenario = find_scenario(catalogue, arguments.scenario);
    apply_settings(catalogue, scenario, arguments.settings);
    if (arguments.tolerance) scenario.method.values.set("tolerance", *arguments.tolerance);
    if (arguments.max_iterations)
        scenario.method.values.set("max_iterations", std::int64_t{*arguments.max_iterations});
    if (arguments.formats) scenario.output.set("formats", *arguments.formats);
    if (arguments.size) apply_size(scenario, *arguments.size);
    if (arguments.seed) {
        const ParameterRow* row = find_role(scenario.monitor.values.rows(), ParameterRole::seed);
        if (!row)
            throw InputError("--seed does not apply: the monitor of scenario '" + scenario.name +
                             "' uses no random numbers");
        scenario.monitor.values.set(row->key, std::int64_t{*arguments.seed});
    }
    return scenario;
}

int threads_of(const RunArguments& arguments) {
    const long long all = std::max(1u, std::thread::hardware_concurrency());
    const long long threads = arguments.threads.value_or(all);
    if (threads < 1 || threads > 1024)
        throw InputError("--threads = " + std::to_string(threads) + " is out of range: 1 to 1024");
    return static_cast<int>(threads);
}

// A progress line on the terminal, overwritten at most ten times a second.
class ProgressLine {
  public:
    explicit ProgressLine(bool quiet) : on_(!quiet && isatty(STDERR_FILENO) != 0) {}
    ~ProgressLine() {
        if (shown_) std::fputs("\r\033[K", stderr);
    }
    void show(const StepReport& report) {
        const double now = watch_.seconds();
        if (!on_ || now < next_) return;
        next_ = now + 0.1;
        shown_ = true;
        const double rate = report.seconds > 0 ? report.iteration / report.seconds : 0;
        equidistribution_ = report.value("equidistribution").value_or(equidistribution_);
        std::fprintf(stderr, "\riteration %d  residual %.3e  equidistribution %.3e  %.0f iterations/s\033[K",
                     report.iteration, report.residual, equidistribution_, rate);
        std::fflush(stderr);
    }

  private:
    Stopwatch watch_;
    bool on_, shown_ = false;
    double next_ = 0, equidistribution_ = 0;
};

void print_outcome(const Run& run, const std::filesystem::path& folder) {
    const StepReport& last = run.history().back();
    std::printf("%s after %d iterations: residual %.3e, ", std::string(status_name(last.status)).c_str(),
                last.iteration, last.residual);
    if (const SeriesInfo* criterion = other_criterion(last))
        std::printf("%s %.3e, ", criterion->name.c_str(), last.value(criterion->name).value_or(0));
    std::printf("equidistribution %.6e, %zu tangled cells, %.3f s\n",
                last.value("equidistribution").value_or(0), last.tangled_cells.value_or(0), last.seconds);
    if (!last.note.empty()) std::printf("%s\n", last.note.c_str());
    std::printf("files in %s\n", folder.string().c_str());
}

void draw_view(std::shared_ptr<const Catalogue> catalogue, Run& run, const std::filesystem::path& folder,
               bool whole_window) {
    const Scenario& scenario = run.scenario();
    const auto width = static_cast<int>(scenario.view.integer("width"));
    const auto height = static_cast<int>(scenario.view.integer("height"));
    if (const std::string note = missing_note(scenario.view, *run.snapshot()); !note.empty())
        std::cerr << "gaspard: " << note << "\n";
    if (whole_window)
        return write_png(folder / "view.png",
                         render_whole_window(std::move(catalogue), {scenario, run.history(), run.snapshot()},
                                             width, height));
    write_png(folder / "view.png",
              render_view(*run.snapshot(), scenario.view, width, height, scenario.title));
}

} // namespace

void apply_size(Scenario& scenario, const std::string& size) {
    const auto cross = size.find('x');
    std::int64_t width = 0, height = 0;
    const auto read = [](std::string_view text, std::int64_t& number) {
        const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
        return code == std::errc{} && end == text.data() + text.size();
    };
    const std::string_view text = size;
    if (cross == std::string::npos || !read(text.substr(0, cross), width) ||
        !read(text.substr(cross + 1), height))
        throw InputError("--size must be WIDTHxHEIGHT, such as 1200x900, not '" + size + "'");
    scenario.view.set("width", width);
    scenario.view.set("height", height);
}

int run_command(std::shared_ptr<const Catalogue> catalogue, const RunArguments& arguments) {
    const InterruptWatch interrupt;
    // Check all input before the first iteration.
    const Scenario scenario = scenario_of(*catalogue, arguments);
    check(*catalogue, scenario);
    check_view(scenario.view);
    const auto formats = formats_of(*catalogue, scenario);
    RunOptions options{.threads = threads_of(arguments)};
    if (arguments.start) options.start = read_state(*arguments.start);
    const std::filesystem::path folder = arguments.out.empty()
                                             ? std::filesystem::path("gaspard-out") / scenario.name
                                             : std::filesystem::path(arguments.out);

    try {
        Run run(catalogue, scenario, std::move(options), {}, interrupt.token());
        check_view(scenario.view, run.discretisation().mesh().get());
        if (std::any_of(formats.begin(), formats.end(), [](const auto* one) { return one->name == "svg"; }))
            check_svg_camera(run.discretisation().mesh()->nodes, scenario.view.text("camera"),
                             static_cast<double>(scenario.view.integer("height")) /
                                 static_cast<double>(scenario.view.integer("width")));
        if (!arguments.no_render) check_offscreen_choice();
        check_writable(folder); // after all checks of the input
        {
            ProgressLine line(arguments.quiet);
            while (run.status() == RunStatus::running) {
                if (interrupt.token().stop_requested()) {
                    run.interrupt();
                    break;
                }
                line.show(run.step(interrupt.token()));
            }
        }
        if (!arguments.quiet) print_outcome(run, folder);
        std::exception_ptr failure; // rethrown after the other files are written
        try {
            write_run_files(folder, run, formats);
        } catch (const MachineError&) {
            failure = std::current_exception();
        }
        if (!arguments.no_render) draw_view(catalogue, run, folder, arguments.whole_window);
        if (failure) std::rethrow_exception(failure);
        return exit_code(run.status());
    } catch (const Interrupted&) {
        std::cerr << "gaspard: interrupted before the first iteration; nothing was written\n";
        return exit_code(RunStatus::interrupted);
    }
}

} // namespace gaspard

#include "cli/commands.hpp"
#include "cli/exit_code.hpp"
#include "cli/interrupt_watch.hpp"
#include "cli/progress_line.hpp"
#include "cli/scenario_input.hpp"
#include "core/base/counted.hpp"
#include "core/base/error.hpp"
#include "core/base/read_file.hpp"
#include "core/base/user_path.hpp"
#include "core/io/film_writer.hpp"
#include "core/io/run_folder.hpp"
#include "core/scenario/time_rows.hpp"
#include "core/session/run.hpp"
#include "core/session/time_series.hpp"
#include "core/tessellate/film.hpp"
#include "gui/app/viewport_image.hpp"
#include "gui/gl/offscreen.hpp"

#include <charconv>
#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>
#include <thread>
#include <type_traits>

namespace gaspard {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t budget = std::size_t{512} << 20; // of the recorded iterates

template <class Number>
Number number_of(const std::string& option, const std::string& text, Number least, Number most) {
    Number value{};
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code != std::errc{} || end != text.data() + text.size() || !(value >= least) || !(value <= most))
        throw InputError(option + " must be a " + (std::is_integral_v<Number> ? "whole number" : "number") +
                         " from " + std::to_string(static_cast<int>(least)) + " to " +
                         std::to_string(static_cast<int>(most)) + ", not '" + text + "'");
    return value;
}

/// One of the times of a scenario.
double time_of_option(const std::string& option, const std::string& text, const Values& time) {
    if (!has_time(time)) throw InputError(option + " needs a scenario with time: time.end after time.start");
    const double start = time.real("start"), end = time.real("end");
    double value = 0;
    const auto [after, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code != std::errc{} || after != text.data() + text.size() || !(value >= start) || !(value <= end))
        throw InputError(option + " must be a time from " + format_number(start) + " to " +
                         format_number(end) + ", not '" + text + "'");
    return value;
}

FilmPlan plan_of(const RecordArguments& arguments, const Scenario& scenario) {
    FilmPlan plan;
    plan.motions = parse_film_motions(arguments.motion.value_or(std::string(usual_motion(scenario))));
    if (arguments.frames) plan.frames = number_of("--frames", *arguments.frames, 1, most_film_frames);
    if (arguments.rate) plan.rate = number_of("--rate", *arguments.rate, least_film_rate, most_film_rate);
    constexpr int most_iterations = 1000000000;
    if (arguments.first) plan.first = number_of("--first", *arguments.first, 0, most_iterations);
    if (arguments.last) plan.last = number_of("--last", *arguments.last, 0, most_iterations);
    const Values& time = scenario.time;
    if (arguments.from_time) plan.from_time = time_of_option("--from-time", *arguments.from_time, time);
    if (arguments.to_time) plan.to_time = time_of_option("--to-time", *arguments.to_time, time);
    plan.from = arguments.from.value_or("");
    plan.to = arguments.to.value_or("");
    return plan;
}

/// Solves, and keeps the iterates.
void solve(Run& run, Recording& recording, ProgressLine& progress, const std::stop_token& stop) {
    recording.add(*run.snapshot());
    while (run.status() == RunStatus::running) {
        const StepReport& report = run.step(stop);
        const auto time = time_of(report);
        progress.show("iteration " + std::to_string(report.iteration) +
                      (time ? ", t = " + format_number(*time) : ""));
        if (stop.stop_requested()) throw Interrupted();
        recording.add(*run.snapshot());
    }
}

/// Draws and writes what is asked for; files of an earlier part of the same film stay.
void write_all(const Film& film, const Scenario& scenario, const fs::path& folder, FilmWriting writing,
               ProgressLine& progress) {
    const auto width = static_cast<int>(scenario.view.integer("width")),
               height = static_cast<int>(scenario.view.integer("height"));
    std::unique_ptr<OffscreenContext> context; // for the frames, if there are any
    writing.draw = [&](int k) {
        if (!context) context = make_offscreen_context();
        const FilmFrame frame = film.frame(k);
        const auto planner = std::make_shared<ViewportPlanner>();
        planner->prepare(frame);
        return render_view(*frame.snapshot, frame.view, width, height, scenario_title(scenario),
                           {.gl = &context->gl(), .stop = writing.stop, .planner = planner});
    };
    writing.begun = [&](const std::string& what, int number, int count) {
        progress.show(count > 1 ? what + " " + std::to_string(number) + " of " + std::to_string(count)
                                : what);
    };
    write_film(film, folder, writing);
}

/// The record of the film that was begun there.
std::string record_in(const fs::path& folder) {
    try {
        return read_file(folder / "film.json");
    } catch (const InputError&) {
        throw InputError("no film was begun in " + folder.string() + "; leave out --resume");
    }
}

} // namespace

int record_command(std::shared_ptr<const Catalogue> catalogue, const RecordArguments& arguments) {
    std::vector<std::string> settings = arguments.settings;
    if (arguments.size)
        for (std::string& setting : size_settings(*arguments.size)) settings.push_back(std::move(setting));
    ScenarioInput input = load_input(*catalogue, arguments.scenario, settings);
    check_input(*catalogue, input);
    const Scenario& scenario = input.scenario;
    const FilmPlan plan = plan_of(arguments, scenario);
    const auto formats = parse_film_formats(arguments.formats.value_or("apng"));
    check_film_formats(plan, formats);
    const std::size_t nodes =
        arguments.nodes ? static_cast<std::size_t>(number_of("--nodes", *arguments.nodes, 1, 100000000))
                        : usual_film_nodes;
    const fs::path folder = arguments.out.empty() ? fs::path("gaspard-out") / (scenario.name + "-film")
                                                  : user_path(arguments.out);
    const std::vector<std::string> names = film_file_names();
    check_no_folders(folder, names);
    if (!arguments.overwrite && !arguments.resume && !arguments.out.empty())
        check_replaceable(folder, names, "film.json", scenario.name);
    if (arguments.resume) record_in(folder); // before the long work
    check_offscreen_choice();
    const InterruptWatch interrupt; // once the input is read: a signal ends a program that waits for it
    const std::stop_token stop = interrupt.token();
    bool begun = false;
    try {
        Run run(catalogue, scenario,
                {.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()))}, {}, stop);
        check_with_mesh(input, *run.discretisation().mesh());
        check_film(plan, *run.discretisation().mesh(), scenario.view);
        std::optional<ProgressLine> progress(std::in_place, arguments.quiet);
        Recording recording(budget);
        solve(run, recording, *progress, stop);
        const Film film(
            plan, recording, run.snapshot(), scenario.view,
            [&](double, std::string_view what) { progress->show(std::string(what)); }, stop);
        const std::string record = film_record(scenario, plan, film);
        if (arguments.resume && record_in(folder) != record)
            throw InputError(
                "the film in " + folder.string() +
                " has other values, motions, frames or data; give all options of the time before, or "
                "leave out --resume to begin anew");
        const FilmFolder begun_folder(folder, record, arguments.resume); // after all checks of the input
        begun = true;
        write_all(film, scenario, folder,
                  {.formats = formats, .nodes = nodes, .resumed = arguments.resume, .stop = stop}, *progress);
        progress.reset(); // its line is free for the outcome
        const StepReport& last = run.history().back();
        if (!arguments.quiet)
            std::printf("%s after %s; %s in %s\n", std::string(status_name(run.status())).c_str(),
                        counted(last.all_iterations, "iteration").c_str(),
                        counted(film.frames(), "frame").c_str(), folder.string().c_str());
        if (run.status() == RunStatus::invalid_input) std::cerr << "gaspard: " << last.note << "\n";
        return run.status() == RunStatus::invalid_input ? exit_code(run.status()) : 0;
    } catch (const Interrupted&) {
        std::cerr << "gaspard: interrupted"
                  << (begun ? "; the files that are there are complete, and --resume goes on\n"
                            : " before the first frame; nothing was written\n");
        return exit_code(RunStatus::interrupted);
    }
}

} // namespace gaspard

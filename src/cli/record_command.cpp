#include "cli/commands.hpp"
#include "cli/exit_code.hpp"
#include "cli/interrupt_watch.hpp"
#include "cli/progress_line.hpp"
#include "cli/scenario_input.hpp"
#include "core/base/error.hpp"
#include "core/base/read_file.hpp"
#include "core/base/user_path.hpp"
#include "core/io/apng.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/film_files.hpp"
#include "core/io/image.hpp"
#include "core/io/run_folder.hpp"
#include "core/io/video.hpp"
#include "core/session/run.hpp"
#include "core/session/time_series.hpp"
#include "core/tessellate/film.hpp"
#include "gui/app/viewport_image.hpp"
#include "gui/gl/offscreen.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <fcntl.h>
#include <iostream>
#include <optional>
#include <sys/file.h>
#include <thread>
#include <type_traits>
#include <unistd.h>

namespace gaspard {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t budget = std::size_t{512} << 20; // of the recorded iterates
constexpr int most_frames = 100000;                    // of five digits
constexpr double most_per_second = 1000;

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

FilmPlan plan_of(const RecordArguments& arguments, const Scenario& scenario) {
    FilmPlan plan;
    plan.motions = parse_film_motions(arguments.motion.value_or(std::string(usual_motion(scenario))));
    if (arguments.frames) plan.frames = number_of("--frames", *arguments.frames, 1, most_frames);
    if (arguments.rate) plan.rate = number_of("--rate", *arguments.rate, 1.0, most_per_second);
    plan.from = arguments.from.value_or("");
    plan.to = arguments.to.value_or("");
    return plan;
}

std::string counted(const char* what, int done, int all) {
    return std::string(what) + " " + std::to_string(done) + " of " + std::to_string(all);
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
class FilmWriter {
  public:
    FilmWriter(const Film& film, const Scenario& scenario, fs::path folder,
               const std::vector<const FilmFormat*>& formats, bool resumed)
        : film_(film), scenario_(scenario), folder_(std::move(folder)), formats_(formats), resumed_(resumed) {
    }

    void write(std::size_t nodes, ProgressLine& progress, const std::stop_token& stop) {
        const bool drawn = std::any_of(formats_.begin(), formats_.end(),
                                       [](const FilmFormat* format) { return format->drawn; });
        if (drawn) draw(progress, stop);
        for (const FilmFormat* format : formats_) {
            if (stop.stop_requested()) throw Interrupted();
            write(*format, nodes, progress, stop);
        }
    }

  private:
    void draw(ProgressLine& progress, const std::stop_token& stop) {
        const fs::path images = folder_ / "frames";
        make_folder(images);
        const auto context = make_offscreen_context();
        const auto width = static_cast<int>(scenario_.view.integer("width")),
                   height = static_cast<int>(scenario_.view.integer("height"));
        for (int k = 0; k < film_.frames(); ++k) {
            const fs::path file = frame_file(images, k, ".png");
            if (resumed_ && fs::exists(file)) continue; // of an earlier part
            progress.show(counted("frame", k + 1, film_.frames()));
            const FilmFrame frame = film_.frame(k);
            const ImageOptions options{.gl = &context->gl(), .stop = stop};
            write_png(file, render_view(*frame.snapshot, frame.view, width, height, scenario_title(scenario_),
                                        options));
            if (stop.stop_requested()) throw Interrupted();
        }
    }

    void write(const FilmFormat& format, std::size_t nodes, ProgressLine& progress,
               const std::stop_token& stop) {
        const fs::path images = folder_ / "frames", file = folder_ / format.file;
        const auto video = [&](VideoKind kind) {
            write_video(file, kind, images, film_.frames(), film_.rate(), film_.hold(), stop);
        };
        if (format.name == "apng") {
            std::vector<fs::path> frames;
            for (int k = 0; k < film_.frames(); ++k) frames.push_back(frame_file(images, k, ".png"));
            write_apng(file, frames, film_.rate(), film_.hold(), stop);
        }
        if (format.name == "gif") video(VideoKind::gif);
        if (format.name == "mp4") video(VideoKind::mp4);
        if (format.name == "webm") video(VideoKind::webm);
        if (format.name == "pvd") write_meshes(progress, stop);
        if (format.name == "glb") {
            const MovingMesh moving = moving_mesh(film_);
            write_animated_glb(file, moving.frames, moving.rate);
        }
        if (format.name == "csv") write_atomically(file, trajectories_csv(film_, nodes, stop));
    }

    void write_meshes(ProgressLine& progress, const std::stop_token& stop) {
        make_folder(folder_ / "mesh");
        for (const int k : frames_with_meshes(film_)) {
            const fs::path file = frame_file(folder_ / "mesh", k, ".vtu");
            if (resumed_ && fs::exists(file)) continue; // of an earlier part
            progress.show(counted("mesh", k + 1, film_.frames()));
            write_vtu(file, *film_.frame(k).snapshot);
            if (stop.stop_requested()) throw Interrupted();
        }
        write_atomically(folder_ / "mesh.pvd", pvd_of(film_));
    }

    const Film& film_;
    const Scenario& scenario_;
    fs::path folder_;
    const std::vector<const FilmFormat*>& formats_;
    bool resumed_;
};

void check_formats(const FilmPlan& plan, const std::vector<const FilmFormat*>& formats) {
    for (const FilmFormat* format : formats)
        if (!format->drawn && !plan.motions.shows_iterates())
            throw InputError("the format " + std::string(format->name) +
                             " has the iterates of a solve; ask for the motion iterations or time");
}

/// A folder that no other program records into as long as this lives.
class LockedFolder {
  public:
    explicit LockedFolder(const fs::path& folder)
        : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
        if (descriptor_ >= 0 && flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
            ::close(descriptor_);
            throw InputError("another program is recording into " + folder.string() +
                             "; choose another folder with --out");
        }
    }
    ~LockedFolder() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }
    LockedFolder(const LockedFolder&) = delete;
    LockedFolder& operator=(const LockedFolder&) = delete;

  private:
    int descriptor_;
};

/// The record of the film that was begun there.
std::string record_in(const fs::path& folder) {
    try {
        return read_file(folder / "film.json");
    } catch (const InputError&) {
        throw InputError("no film was begun in " + folder.string() + "; leave out --resume");
    }
}

/// Files of another film go before film.json speaks of this one, and film.json first of all, so that nothing
/// passes for a part of this film, whenever the program is killed.
void clear(const fs::path& folder) {
    std::vector<fs::path> files{folder / "film.json"};
    for (const FilmFormat& format : film_formats())
        if (format.name != "png") files.push_back(folder / format.file);
    for (const fs::path& file : files) {
        std::error_code error;
        if (!fs::remove(file, error) && error)
            throw MachineError("cannot remove " + file.string() +
                               ", which is of another film: " + error.message());
    }
    remove_frames(folder / "frames", ".png");
    remove_frames(folder / "mesh", ".vtu");
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
    check_formats(plan, formats);
    const std::size_t nodes =
        arguments.nodes ? static_cast<std::size_t>(number_of("--nodes", *arguments.nodes, 1, 100000000))
                        : 400;
    const fs::path folder = arguments.out.empty() ? fs::path("gaspard-out") / (scenario.name + "-film")
                                                  : user_path(arguments.out);
    std::vector<std::string> names{"film.json", "frames/00000.png", "mesh/00000.vtu"};
    for (const FilmFormat& format : film_formats())
        if (format.name != "png") names.emplace_back(format.file);
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
        const Film film(plan, recording, run.snapshot(), scenario.view);
        if (film.frames() > most_frames)
            throw InputError("the film would have " + std::to_string(film.frames()) +
                             " frames; choose fewer with --frames");
        const std::string record = film_record(scenario, plan, film.frames());
        if (arguments.resume && record_in(folder) != record)
            throw InputError("the film in " + folder.string() +
                             " has other values, motions, frames or data; leave out --resume to begin anew");
        check_writable(folder); // after all checks of the input
        const LockedFolder lock(folder);
        if (!arguments.resume) clear(folder);
        for (const fs::path& part : {folder, folder / "frames", folder / "mesh"}) remove_unfinished(part);
        write_atomically(folder / "film.json", record);
        begun = true;
        FilmWriter(film, scenario, folder, formats, arguments.resume).write(nodes, *progress, stop);
        progress.reset(); // its line is free for the outcome
        if (!arguments.quiet)
            std::printf("%s after %d iterations; %d frames in %s\n",
                        std::string(status_name(run.status())).c_str(), run.history().back().iteration,
                        film.frames(), folder.string().c_str());
        return 0;
    } catch (const Interrupted&) {
        std::cerr << "gaspard: interrupted"
                  << (begun ? "; the files that are there are complete, and --resume goes on\n"
                            : " before the first frame; nothing was written\n");
        return exit_code(RunStatus::interrupted);
    }
}

} // namespace gaspard

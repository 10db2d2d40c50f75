#include "cli/commands.hpp"
#include "cli/exit_code.hpp"
#include "cli/interrupt_watch.hpp"
#include "cli/scenario_input.hpp"
#include "core/base/error.hpp"
#include "core/base/user_path.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/image.hpp"
#include "core/io/interpolation_files.hpp"
#include "core/io/run_folder.hpp"
#include "core/io/svg.hpp"
#include "core/session/run.hpp"
#include "gui/app/viewport_image.hpp"
#include "gui/gl/offscreen.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <stop_token>
#include <thread>

namespace gaspard {

namespace {

void print_line(const std::vector<std::string>& cells) {
    static constexpr std::array<int, 9> widths{5, 8, 8, 10, 6, 10, 6, 8, 0};
    for (std::size_t i = 0; i + 1 < cells.size(); ++i)
        std::printf(i == 2 ? "  %-*s" : "%*s  ", widths[i], cells[i].c_str());
    std::printf("%s\n", cells.back().c_str());
}

void print_row(const InterpolationRow& row, bool first) {
    if (first) print_line(interpolation_heads());
    for (const auto& line : interpolation_lines(row)) print_line(line);
    if (const std::string note = interpolation_note(row); !note.empty()) std::printf("%s\n", note.c_str());
    std::fflush(stdout);
}

std::vector<std::string> notes_of(const Run& run) {
    const auto report = run.monitor_report();
    return report ? report->notes : std::vector<std::string>();
}

/// What the monitor says about itself on a mesh, unless it has said so on the one before.
void print_notes(const std::vector<std::string>& notes, const std::vector<std::string>& before,
                 const std::string& mesh) {
    if (notes == before) return;
    for (const std::string& note : notes) std::printf("%s%s\n", mesh.c_str(), note.c_str());
    if (notes.empty()) std::printf("%sthe notes above do not apply\n", mesh.c_str());
    std::fflush(stdout);
}

/// Both meshes of a run, coloured by the L2 errors of their cells on one scale.
Image error_maps(Run& run, std::stop_token stop) {
    const auto snapshot = run.snapshot();
    const std::string cells = " mesh, " + std::to_string(snapshot->mesh->cell_count()) + " cells";
    const std::string camera = run.scenario().view.text("camera");
    return render_panels({MeshPanel{"uniform" + cells, snapshot, "interpolation_error_uniform", 0, camera},
                          MeshPanel{"adapted" + cells, snapshot, "interpolation_error", 1, camera}},
                         2, 1600, 800, {.light = true, .stop = std::move(stop)});
}

} // namespace

int why_command(std::shared_ptr<const Catalogue> catalogue, const WhyArguments& arguments) {
    ScenarioInput input = load_input(*catalogue, arguments.scenario, arguments.settings);
    check_input(*catalogue, input);
    const Scenario& scenario = input.scenario;
    check_comparable(scenario);
    const auto resolutions =
        arguments.cells ? parse_resolutions(scenario, *arguments.cells) : usual_resolutions(scenario);
    const std::filesystem::path folder = arguments.out.empty()
                                             ? std::filesystem::path("gaspard-out") / (scenario.name + "-why")
                                             : user_path(arguments.out);
    check_domain(*catalogue, input);
    if (!arguments.no_render) check_offscreen_choice();
    const std::vector<std::string> names{"why.csv", "why.json", "why.svg", "why.png"};
    check_no_folders(folder, names);
    if (!arguments.overwrite && !arguments.out.empty()) // the default folder has the scenario's name
        check_replaceable(folder, names, "why.json", scenario.name);
    // The maps are those of the scenario's own mesh, if it is among them.
    const std::int64_t own = scenario.domain.values.integer(resolution_key(scenario));
    const bool has_own = std::find(resolutions.begin(), resolutions.end(), own) != resolutions.end();
    const std::int64_t shown = has_own ? own : resolutions.back();
    const InterruptWatch interrupt; // once the input is read: a signal ends a program that waits for it
    std::vector<InterpolationRow> rows;
    std::vector<std::string> notes; // of the last mesh
    std::optional<Image> maps;
    int code = 0;
    for (const std::int64_t resolution : resolutions) {
        try {
            Run run(catalogue, with_resolution(*catalogue, scenario, resolution),
                    {.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()))}, {},
                    interrupt.token());
            print_notes(notes_of(run), notes, rows.empty() ? "" : "n = " + std::to_string(resolution) + ": ");
            notes = notes_of(run);
            run.solve(interrupt.token());
            if (run.status() == RunStatus::interrupted) break;
            rows.push_back(interpolation_row(run, rows.empty() ? nullptr : &rows.back(), interrupt.token()));
            if (rows.size() == 1) check_writable(folder); // after all checks of the input
            print_row(rows.back(), rows.size() == 1);
            if (run.status() == RunStatus::invalid_input)
                std::printf("n = %lld: %s\n", static_cast<long long>(resolution),
                            run.history().back().note.c_str());
            if (code == 0) code = exit_code(run.status());
            if (resolution == shown && !arguments.no_render && !rows.back().errors.exact())
                maps = error_maps(run, interrupt.token());
        } catch (const Interrupted&) {
            break;
        }
    }
    if (interrupt.token().stop_requested()) code = exit_code(RunStatus::interrupted);
    if (rows.empty()) {
        std::fprintf(stderr, "gaspard: interrupted before the first mesh; nothing was written\n");
        return code;
    }
    if (!maps) print_left_over(left_over(folder, names, {"why.csv", "why.json", "why.svg"}));
    write_atomically(folder / "why.json",
                     why_json(scenario, rows)); // first: it says what the others are about
    write_atomically(folder / "why.csv", why_csv(rows));
    write_svg(folder / "why.svg", why_plot(rows));
    if (maps) write_png(folder / "why.png", *maps);
    std::printf("files in %s\n", folder.string().c_str());
    return code;
}

} // namespace gaspard

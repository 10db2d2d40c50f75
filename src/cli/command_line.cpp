#include "cli/command_line.hpp"

#include "cli/commands.hpp"
#include "cli/exit_code.hpp"
#include "core/base/error.hpp"
#include "core/base/parameter.hpp"
#include "core/base/version.hpp"

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <iostream>

namespace gaspard {

namespace {

constexpr const char* scenario_help = "A built-in name, a .toml file, or - for standard input";

void add_settings(CLI::App& command, std::vector<std::string>& settings) {
    command.add_option("--set", settings, "Set a value, such as monitor.amplitude=20 (repeatable)")
        ->type_name("KEY=VALUE")
        ->expected(1)
        ->take_all();
}

void add_run(CLI::App& app, RunArguments& run) {
    CLI::App* command = app.add_subcommand("run", "Solve without a window and write the results to files");
    command->add_option("SCENARIO", run.scenario, scenario_help)->required();
    add_settings(*command, run.settings);
    command->add_option("--out", run.out, "Output folder (default: ./gaspard-out/SCENARIO)")
        ->type_name("DIR");
    command->add_option("--formats", run.formats, "Comma-separated list of mesh formats")->type_name("LIST");
    command->add_option("--size", run.size, "Size of the image in pixels")->type_name("WxH");
    command->add_flag("--no-render", run.no_render, "Do not draw an image");
    command->add_flag("--whole-window", run.whole_window, "Draw the whole window instead of the view");
    command->add_option("--max-iterations", run.max_iterations, "Maximum number of iterations")
        ->type_name("N");
    command
        ->add_option("--tolerance", run.tolerance,
                     "Converged when the residual (Picard: the increment) is below T")
        ->type_name("T");
    command->add_option("--start", run.start, "Start from a state.bin file")->type_name("FILE");
    command->add_option("--threads", run.threads, "Maximum number of threads; does not affect the results")
        ->type_name("N");
    command->add_option("--seed", run.seed, "Seed of a random monitor")->type_name("N");
    command->add_flag("--overwrite", run.overwrite, "Replace files of a run of another scenario as well");
    command->add_flag("--quiet", run.quiet, "Print only errors");
}

void add_compare(CLI::App& app, CompareArguments& compare) {
    CLI::App* command = app.add_subcommand("compare", "Compare methods on one problem: a table and an image");
    command->add_option("SCENARIO", compare.scenario, scenario_help)->required();
    add_settings(*command, compare.settings);
    command->add_option("--methods", compare.methods, "Comma-separated list of methods (default: all)")
        ->type_name("LIST");
    command->add_option("--out", compare.out, "Output folder (default: ./gaspard-out/SCENARIO-methods)")
        ->type_name("DIR");
    command->add_flag("--no-render", compare.no_render, "Do not draw an image");
    command->add_flag("--overwrite", compare.overwrite,
                      "Replace files of a comparison on another scenario as well");
}

void add_why(CLI::App& app, WhyArguments& why) {
    CLI::App* command =
        app.add_subcommand("why", "Compare interpolation errors of the uniform and the adapted mesh");
    command->add_option("SCENARIO", why.scenario, scenario_help)->required();
    add_settings(*command, why.settings);
    command
        ->add_option("--cells", why.cells,
                     "Comma-separated list of cells per side (default: half, once and twice the scenario's)")
        ->type_name("LIST");
    command->add_option("--out", why.out, "Output folder (default: ./gaspard-out/SCENARIO-why)")
        ->type_name("DIR");
    command->add_flag("--no-render", why.no_render, "Do not draw an image");
    command->add_flag("--overwrite", why.overwrite, "Replace files about another scenario as well");
}

void add_study(CLI::App& app, StudyArguments& study) {
    CLI::App* command =
        app.add_subcommand("study", "Vary one or two parameters: errors and orders as a table and a plot");
    command->add_option("SCENARIO", study.scenario, scenario_help)->required();
    add_settings(*command, study.settings);
    command
        ->add_option("--over", study.over,
                     "What varies, such as domain.cells=8,16,32, domain.cells=8:1024 (times two), "
                     "monitor.q=0.1:0.9:9 (nine values) or monitor.q (values of its range)")
        ->type_name("KEY[=VALUES]");
    command
        ->add_option("--lines", study.lines, "One line per value, such as pde.eps=1:1e-8 (by powers of ten)")
        ->type_name("KEY=VALUES");
    command
        ->add_option("--measure", study.measure,
                     "A series of the run, or iterations, cpu_seconds, tangled_cells (default: energy_error, "
                     "without a PDE equidistribution)")
        ->type_name("NAME");
    command->add_option("--out", study.out, "Output folder (default: ./gaspard-out/SCENARIO-study)")
        ->type_name("DIR");
    command->add_flag("--no-render", study.no_render, "Do not draw an image");
    command->add_flag("--overwrite", study.overwrite, "Replace files about another scenario as well");
}

void add_record(CLI::App& app, RecordArguments& record) {
    CLI::App* command = app.add_subcommand("record", "Make a film of a solve, or of its mesh");
    command->add_option("SCENARIO", record.scenario, scenario_help)->required();
    add_settings(*command, record.settings);
    command
        ->add_option("--motion", record.motion,
                     "What moves: iterations, time, turn, blend, camera, or several (default: "
                     "iterations; where the scenario has time, time)")
        ->type_name("LIST");
    command
        ->add_option("--formats", record.formats,
                     "Comma-separated list: png, apng, gif, mp4, webm, pvd, "
                     "glb, csv (default: apng)")
        ->type_name("LIST");
    command
        ->add_option("--frames", record.frames,
                     "Number of frames (default: one per iterate or time step; 6 seconds of another "
                     "motion)")
        ->type_name("N");
    command->add_option("--rate", record.rate, "Frames per second (default: 25; of iterates alone 10)")
        ->type_name("N");
    command->add_option("--size", record.size, "Size of the frames in pixels")->type_name("WxH");
    command->add_option("--first", record.first, "First iteration to show (default: the start)")
        ->type_name("N");
    command
        ->add_option("--last", record.last,
                     "Last iteration to show, which other motions show too (default: the end)")
        ->type_name("N");
    command
        ->add_option("--from-time", record.from_time,
                     "Of a film of time: first t, or the nearest (default: the start)")
        ->type_name("T");
    command->add_option("--to-time", record.to_time, "Its last t (default: the end)")->type_name("T");
    command->add_option("--from", record.from, "First view of the motion camera, as view.camera")
        ->type_name("CAMERA");
    command->add_option("--to", record.to, "Its last view")->type_name("CAMERA");
    command->add_option("--nodes", record.nodes, "Most nodes in trajectories.csv (default: 400)")
        ->type_name("N");
    command->add_option("--out", record.out, "Output folder (default: ./gaspard-out/SCENARIO-film)")
        ->type_name("DIR");
    command->add_flag("--resume", record.resume, "Go on with a film that was interrupted");
    command->add_flag("--overwrite", record.overwrite, "Replace files of a film of another scenario as well");
    command->add_flag("--quiet", record.quiet, "Print only errors");
}

/// Values that are missing are mistakes, such as those of an unset variable in a script: an empty one, or the
/// next option in its place.
void refuse_missing_values(const CLI::App& app) {
    for (const CLI::Option* option : app.get_options())
        for (const std::string& value : option->results()) {
            if (value.empty()) throw InputError(option->get_name() + " is empty; see gaspard --help");
            const std::string name = value.substr(0, value.find('='));
            if (name.starts_with('-') && app.get_option_no_throw(name) != nullptr)
                throw InputError(option->get_name() + " has no value before " + value +
                                 "; see gaspard --help");
        }
}

/// The arguments that no option takes, with the nearest option of the command.
std::string unexpected(const CLI::App& app) {
    const auto commands = app.get_subcommands();
    const CLI::App& command = commands.empty() ? app : *commands.front();
    std::vector<std::string> known, extras = app.remaining(true);
    for (const CLI::Option* option : command.get_options()) known.push_back(option->get_name());
    const std::string first = extras.empty() ? std::string() : extras.front();
    return "unexpected argument '" + first + "'" +
           (first.starts_with('-') ? did_you_mean(first.substr(0, first.find('=')), known) : "");
}

/// One sentence for an error of the parser.
std::string sentence(const CLI::ParseError& error) {
    const std::string text = error.what();
    const std::string option = text.substr(0, text.find_first_of(": ")); // "--out: 1 required DIR missing"
    if (dynamic_cast<const CLI::RequiredError*>(&error)) return option + " is missing";
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error)) return option + " needs one value";
    if (dynamic_cast<const CLI::ConversionError*>(&error)) return "a flag such as --quiet takes no value";
    return "invalid arguments";
}

int dispatch(int argc, char** argv) {
    CLI::App app("Gaspard: adaptive meshes by optimal transport", "gaspard");
    app.set_version_flag("--version", "gaspard " + std::string(version()));
    app.get_formatter()->column_width(34);
    app.require_subcommand(0, 1);
    app.footer("Without a command, opens SCENARIO in the window (default: plane-ring).");

    std::string scenario = "plane-ring", what, id, out;
    std::vector<std::string> settings, show_settings;
    std::optional<std::string> size;
    RunArguments run;
    bool reproduce_in_full = false, reproduce_without_picture = false;
    std::string show_scenario;
    ShowOptions show_options;
    app.add_option("SCENARIO", scenario, scenario_help);
    add_settings(app, settings);
    app.add_option("--size", size, "Size of the window in pixels")->type_name("WxH");
    add_run(app, run);
    CompareArguments compare;
    add_compare(app, compare);
    WhyArguments why;
    add_why(app, why);
    StudyArguments study;
    add_study(app, study);
    RecordArguments record;
    add_record(app, record);
    CLI::App* list = app.add_subcommand("list", "List what is available, with parameters and ranges");
    list->add_option("WHAT", what,
                     "scenarios, domains, monitors, methods, time, formats, view or output (default: all)");
    CLI::App* show = app.add_subcommand("show", "Print the complete scenario as TOML, including defaults");
    show->add_option("SCENARIO", show_scenario, scenario_help)->required();
    add_settings(*show, show_settings);
    show->add_flag("--as-formula", show_options.as_formula,
                   "Write the built-in monitor as a formula that can be changed");
    show->add_flag("--portable", show_options.portable,
                   "With the content of its data files (at most 2 MB), so that it needs no other file");
    CLI::App* reproduce = app.add_subcommand("reproduce", "Reproduce a published table or figure");
    reproduce->add_option("ID", id, "Table or figure, such as mcrae-fig2 (default: list all)");
    reproduce->add_option("--out", out, "Output folder (default: ./gaspard-out/ID)")->type_name("DIR");
    reproduce->add_flag("--full", reproduce_in_full, "Also the rows of a table that take minutes");
    reproduce->add_flag("--no-render", reproduce_without_picture, "Do not draw an image");

    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& wanted) { // --help, --version
        return app.exit(wanted);
    } catch (const CLI::ExtrasError& error) {
        std::vector<std::string> commands;
        for (const CLI::App* command : app.get_subcommands({})) commands.push_back(command->get_name());
        const bool known_command = !app.get_subcommands().empty();
        const std::string meant = known_command ? "" : did_you_mean(scenario, commands);
        if (meant.empty()) throw InputError(unexpected(app) + "; see gaspard --help");
        throw InputError("unknown command '" + scenario + "'" + meant + "; see gaspard --help");
    } catch (const CLI::ParseError& error) {
        throw InputError(sentence(error) + "; see gaspard --help");
    }
    refuse_missing_values(app);
    for (const CLI::App* command : app.get_subcommands()) refuse_missing_values(*command);
    if (const auto commands = app.get_subcommands(); !commands.empty())
        for (const char* option : {"SCENARIO", "--set", "--size"})
            if (app.get_option(option)->count() > 0)
                throw InputError(std::string(option) + " before '" + commands.front()->get_name() +
                                 "' has no effect: it goes after the command");
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    if (app.got_subcommand("run")) return run_command(catalogue, run);
    if (app.got_subcommand("compare")) return compare_command(catalogue, compare);
    if (app.got_subcommand("why")) return why_command(catalogue, why);
    if (app.got_subcommand("study")) return study_command(catalogue, study);
    if (app.got_subcommand("record")) return record_command(catalogue, record);
    if (app.got_subcommand(list)) return list_command(*catalogue, what);
    if (app.got_subcommand(show)) return show_command(*catalogue, show_scenario, show_settings, show_options);
    if (app.got_subcommand(reproduce))
        return reproduce_command(catalogue, id, out, reproduce_in_full, !reproduce_without_picture);
    return window_command(catalogue, scenario, settings, size);
}

/// As one line without control characters, of a length that can be read: names and values come from the user.
std::string one_line(std::string_view text) {
    constexpr std::size_t longest = 1000;
    std::string line;
    for (const char c : text.substr(0, longest))
        line += static_cast<unsigned char>(c) < ' ' || c == '\x7f' ? ' ' : c;
    while (line.size() == longest && !line.empty() && (static_cast<unsigned char>(line.back()) & 0x80) != 0)
        line.pop_back(); // no half letter
    return text.size() > longest ? line + " ..." : line;
}

} // namespace

int run_command_line(int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN); // exceeding a file size limit then makes write() fail with EFBIG
    try {
        const int code = dispatch(argc, argv);
        std::cout.flush();
        if (std::fflush(stdout) == 0 && std::cout && !std::ferror(stdout)) return code;
        std::cerr << "gaspard: cannot write to standard output\n";
        return code == 0 ? exit_fault : code;
    } catch (const InputError& error) {
        std::cerr << "gaspard: " << one_line(error.what()) << "\n";
        return exit_input;
    } catch (const std::bad_alloc&) {
        std::cerr << "gaspard: not enough memory\n";
    } catch (const std::filesystem::filesystem_error& error) {
        std::cerr << "gaspard: cannot use " << error.path1().string() << ": " << error.code().message()
                  << "\n";
    } catch (const std::exception& error) {
        std::cerr << "gaspard: " << error.what() << "\n";
    }
    return exit_fault;
}

} // namespace gaspard

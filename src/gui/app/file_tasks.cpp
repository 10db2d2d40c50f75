#include "gui/app/file_tasks.hpp"

#include "core/base/error.hpp"
#include "core/base/user_path.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/run_files.hpp"
#include "core/io/svg.hpp"
#include "core/scenario/toml.hpp"
#include "core/tessellate/check_view.hpp"

#include <utility>

namespace gaspard {

void FileTasks::open(const std::filesystem::path& file) {
    writer_.run([catalogue = catalogue_, arrivals = arrivals_, file] {
        const auto absolute = std::filesystem::absolute(user_path(file.string()));
        if (!is_scenario_file(absolute.string()))
            throw InputError(absolute.string() + " is not a scenario file: its name does not end in .toml");
        ScenarioSource source;
        Scenario scenario = load_scenario(*catalogue, absolute, &source);
        try {
            check(*catalogue, scenario);
            check_view(scenario.view);
        } catch (const InputError& error) {
            throw InputError(with_place(source, error.what()));
        }
        std::lock_guard lock(arrivals->mutex);
        arrivals->newest = {std::move(scenario), absolute};
        return "Opening " + absolute.string();
    });
}

std::optional<OpenedScenario> FileTasks::take_opened() {
    std::lock_guard lock(arrivals_->mutex);
    return std::exchange(arrivals_->newest, std::nullopt);
}

void FileTasks::export_run(DocumentRun& run) {
    // The board is shared: the task may run when the window is already closing.
    run.solver->post(
        InspectCommand{[catalogue = catalogue_, board = board_, folder = folder(run.scenario),
                        names = run.scenario.output.text("formats")](Run& solved, const Activity& activity) {
            report_outcome(*board, [&] {
                Scenario chosen = solved.scenario();
                chosen.output.set("formats", names);
                const auto formats = formats_of(*catalogue, chosen);
                check_writable(folder);
                write_run_files(folder, solved, formats, activity.progress, activity.stop);
                return "Exported to " + folder.string();
            });
        }});
}

void FileTasks::save_scenario(const Scenario& scenario) {
    writer_.run(
        [folder = folder(scenario), name = scenario.name, text = to_toml(with_absolute_paths(scenario))] {
            check_writable(folder);
            const auto file = free_name(folder, name, ".toml");
            write_atomically(file, text);
            return "Saved " + file.string();
        });
}

void FileTasks::save_image(const Scenario& scenario, const std::string& name, Image image) {
    writer_.write_image(folder(scenario), name, std::move(image));
}

void FileTasks::save_svg(const Scenario& scenario, const std::string& name, Plot plot) {
    writer_.run([folder = folder(scenario), name, plot = std::move(plot)] {
        check_writable(folder);
        const auto file = free_name(folder, name, ".svg");
        write_svg(file, plot);
        return "Saved " + file.string();
    });
}

} // namespace gaspard

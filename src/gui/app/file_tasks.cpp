#include "gui/app/file_tasks.hpp"

#include "core/base/error.hpp"
#include "core/base/user_path.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/figure.hpp"
#include "core/io/pdf.hpp"
#include "core/io/run_files.hpp"
#include "core/io/run_folder.hpp"
#include "core/io/state_file.hpp"
#include "core/io/svg.hpp"
#include "core/scenario/data_files.hpp"
#include "core/scenario/own_names.hpp"
#include "core/scenario/toml.hpp"
#include "core/tessellate/check_view.hpp"

#include <fstream>
#include <utility>

namespace gaspard {

void FileTasks::open(const std::filesystem::path& file) {
    writer_.run([catalogue = catalogue_, arrivals = arrivals_, file] {
        const auto absolute = std::filesystem::absolute(user_path(file.string()));
        if (!is_scenario_file(absolute.string())) return look_at(*arrivals, absolute);
        ScenarioSource source;
        Scenario scenario = load_scenario(*catalogue, absolute, &source);
        try {
            check(*catalogue, scenario);
            check_view(scenario.view);
        } catch (const InputError& error) {
            throw InputError(with_place(source, error.what()));
        }
        std::lock_guard lock(arrivals->mutex);
        arrivals->opened = {std::move(scenario), absolute};
        return "Opening " + absolute.string();
    });
}

std::optional<ScenarioOnDisk> FileTasks::take_opened() {
    std::lock_guard lock(arrivals_->mutex);
    return std::exchange(arrivals_->opened, std::nullopt);
}

/// Finds out what a file is that is no scenario.
std::string FileTasks::look_at(Arrivals& arrivals, const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string head(head_size, '\0');
    if (!std::filesystem::is_regular_file(file) || !stream)
        throw InputError(
            "cannot read " + file.string() + ": " +
            (std::filesystem::exists(file) ? "it is not a file that can be read" : "there is no such file"));
    stream.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(stream.gcount()));
    const auto use = use_of(file, head);
    if (!use) throw InputError("could not open " + file.string() + "; open or drop " + what_opens());
    DataFile data{*use, file};
    if (*use == FileUse::state) data.state = std::make_shared<const State>(read_state(file));
    std::lock_guard lock(arrivals.mutex);
    arrivals.data.push_back(std::move(data));
    return {};
}

std::vector<DataFile> FileTasks::take_data() {
    std::lock_guard lock(arrivals_->mutex);
    return std::exchange(arrivals_->data, {});
}

void FileTasks::list(FolderWish wish) {
    writer_.run([arrivals = arrivals_, wish = std::move(wish)] {
        FolderListing listing = list_folder(wish);
        std::lock_guard lock(arrivals->mutex);
        arrivals->listing = std::move(listing);
        return std::string();
    });
}

std::optional<FolderListing> FileTasks::take_listing() {
    std::lock_guard lock(arrivals_->mutex);
    return std::exchange(arrivals_->listing, std::nullopt);
}

std::vector<ScenarioOnDisk> FileTasks::take_saved() {
    std::lock_guard lock(arrivals_->mutex);
    return std::exchange(arrivals_->saved, {});
}

std::filesystem::path FileTasks::export_folder(const Scenario& scenario) const {
    return std::filesystem::absolute(output_.preferred / scenario_stem(scenario));
}

void FileTasks::export_run(DocumentRun& run, ExportOrder order) {
    // The board is shared: the task may run when the window is already closing.
    run.solver->post(InspectCommand{[catalogue = catalogue_, board = board_, output = output_,
                                     order = std::move(order)](Run& solved, const Activity& activity) {
        report_outcome(*board, [&] {
            Scenario chosen = solved.scenario();
            chosen.output.set("formats", order.formats);
            const auto formats = formats_of(*catalogue, chosen);
            const auto names = run_file_names(solved, formats);
            const WritableFolder place = order.folder.empty() ? writable_folder(output, scenario_stem(chosen))
                                                              : WritableFolder{order.folder, {}};
            const auto folder = order.replace ? place.folder : free_folder(place.folder, names);
            check_no_folders(folder, names);
            check_writable(folder);
            write_run_files(folder, solved, formats, activity.progress, activity.stop);
            return "Exported to " + folder.string() + place.remark;
        });
    }});
}

namespace {

/// As the file is read back: its name is that of the scenario.
Scenario as_saved(Scenario scenario, const std::filesystem::path& file) {
    scenario = with_own_names(
        with_relative_paths(std::move(scenario), std::filesystem::absolute(file).parent_path()));
    scenario.name = file.stem().string();
    return scenario;
}

} // namespace

void FileTasks::save_scenario(const Scenario& scenario) {
    const std::string stem = scenario_stem(scenario);
    writer_.write_new(output_, stem, stem, ".toml", [arrivals = arrivals_, scenario](const auto& file) {
        save(*arrivals, {as_saved(scenario, file), std::filesystem::absolute(file)});
    });
}

void FileTasks::save_scenario_as(const Scenario& scenario, const std::filesystem::path& file, bool packed) {
    writer_.run([arrivals = arrivals_, scenario, file, packed] {
        const auto absolute = std::filesystem::absolute(user_path(file.string()));
        save(*arrivals, {as_saved(scenario, absolute), absolute, true}, packed);
        return "Saved " + absolute.string();
    });
}

void FileTasks::save(Arrivals& arrivals, ScenarioOnDisk scenario, bool packed) {
    write_atomically(scenario.file,
                     to_toml(packed ? with_packed_data(scenario.scenario) : scenario.scenario));
    std::lock_guard lock(arrivals.mutex);
    arrivals.saved.push_back(std::move(scenario));
}

void FileTasks::save_image(const Scenario& scenario, const std::string& name, Image image) {
    writer_.write_new(output_, scenario_stem(scenario), name, ".png",
                      [image = std::move(image)](const auto& file) { write_png(file, image); });
}

namespace {

/// The chosen file; its folder is made if necessary. If it has come into being since, it is not replaced.
std::filesystem::path figure_file(const FigureDialog::Choice& figure) {
    const auto file = std::filesystem::absolute(user_path(figure.file));
    if (!figure.replace && std::filesystem::exists(file))
        throw InputError(file.string() + " exists already; nothing was written");
    check_writable(file.parent_path());
    return file;
}

} // namespace

void FileTasks::save_figure(const FigureDialog::Choice& figure, const std::string& subject,
                            std::shared_ptr<const Snapshot> snapshot, int last_iteration) {
    writer_.run([figure, subject, snapshot = std::move(snapshot), last_iteration] {
        const auto file = figure_file(figure);
        const std::string svg = svg_of_figure(*snapshot, figure.view, subject, last_iteration);
        if (figure.kind == FigureKind::pdf)
            write_pdf(file, svg);
        else
            write_atomically(file, svg);
        return "Saved " + file.string();
    });
}

void FileTasks::draw_figure(const FigureDialog::Choice& figure, const std::string& subject,
                            const Snapshot& snapshot, ImageOptions options) {
    const auto work = std::make_shared<FigureInWork>();
    const auto pixels = [&](const char* key) { return static_cast<int>(figure.view.integer(key)); };
    options.stop = work->stop.get_token();
    work->image = std::make_unique<PreparedImage>(snapshot, figure.view, pixels("width"), pixels("height"),
                                                  subject, options);
    figures_.push_back(work);
    drawer_.run([figure, board = board_, task = work]() mutable {
        const auto own = std::move(task); // released before the outcome is told
        if (own->stop.stop_requested()) throw Interrupted();
        figure_file(figure); // before the long work
        const Image image = own->image->draw([&](double done) {
            own->done = done;
            board->wake();
        });
        if (own->stop.stop_requested()) throw Interrupted();
        const auto file = figure_file(figure);
        write_png(file, image, figure.view.real("dpi"));
        return "Saved " + file.string();
    });
}

std::optional<double> FileTasks::figure_progress() const {
    if (figures_.empty()) return std::nullopt;
    double done = 0;
    for (const auto& one : figures_) done += one->done;
    return done / static_cast<double>(figures_.size());
}

void FileTasks::cancel_figures() {
    for (const auto& one : figures_) one->stop.request_stop();
}

void FileTasks::forget_drawn() {
    std::erase_if(figures_, [](const auto& one) { return one.use_count() == 1; });
}

void FileTasks::save_svg(const Scenario& scenario, const std::string& name, Plot plot) {
    writer_.write_new(output_, scenario_stem(scenario), name, ".svg",
                      [plot = std::move(plot)](const auto& file) { write_svg(file, plot); });
}

} // namespace gaspard

// The files that the window reads and writes, all of them on other threads. The outcome of each is
// reported as a notice.
#pragma once

#include "core/io/image.hpp"
#include "core/scenario/catalogue.hpp"
#include "core/tessellate/plot.hpp"
#include "gui/app/file_kinds.hpp"
#include "gui/app/viewport_image.hpp"
#include "gui/base/background_writer.hpp"
#include "gui/base/folder_listing.hpp"
#include "gui/base/output_folders.hpp"
#include "gui/document/document.hpp"
#include "gui/panels/figure_dialog.hpp"

#include <atomic>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace gaspard {

/// A scenario that was read from a file and checked, or written to one, with the name that the file gives it.
struct ScenarioOnDisk {
    Scenario scenario;
    std::filesystem::path file; ///< absolute
    bool chosen = false;        ///< the user has chosen the file to save to
};

/// A file that is there and can be taken into the scenario.
struct DataFile {
    FileUse use{};
    std::filesystem::path file;           ///< absolute
    std::shared_ptr<const State> state{}; ///< of a state: what is in it
};

/// What is exported of a run, and where to.
struct ExportOrder {
    std::string formats;            ///< as in output.formats
    std::filesystem::path folder{}; ///< empty: one with the scenario's name in the output folder
    bool replace = false;           ///< files that are in `folder`
};

class FileTasks {
  public:
    /// Files are written to folders of `output` that have the names of scenarios. No file is replaced, except
    /// one that the user has chosen for save_scenario_as().
    FileTasks(std::shared_ptr<const Catalogue> catalogue, std::shared_ptr<NoticeBoard> board,
              OutputFolders output)
        : catalogue_(std::move(catalogue)), board_(board), output_(std::move(output)), writer_(board),
          drawer_(std::move(board)) {}
    ~FileTasks() { cancel_figures(); }

    /// Reads a scenario file; take_opened() gives the scenario if it is valid. Of another file of
    /// file_kinds() it looks at the first bytes; take_data() gives what it is.
    void open(const std::filesystem::path& file);
    /// The data files found since the last call, in order.
    std::vector<DataFile> take_data();
    /// Reads the names in a folder, which may have to be made; take_listing() gives them.
    void list(FolderWish wish);
    std::optional<FolderListing> take_listing();
    /// The scenario read last, once.
    std::optional<ScenarioOnDisk> take_opened();
    /// Writes the files of a live run, on the solver's thread; to "plane-ring-2" if "plane-ring" has such
    /// files already.
    void export_run(DocumentRun& run, ExportOrder order);
    /// The folder that export_run() uses for a scenario if no other is chosen.
    std::filesystem::path export_folder(const Scenario& scenario) const;
    /// "NAME.toml" or the next free name; take_saved() gives the scenario once it is written.
    void save_scenario(const Scenario& scenario);
    /// `packed`: with the content of its data files, so that it needs no other file.
    void save_scenario_as(const Scenario& scenario, const std::filesystem::path& file, bool packed = false);
    /// The scenarios written since the last call, in order.
    std::vector<ScenarioOnDisk> take_saved();
    /// "NAME.png" or the next free name.
    void save_image(const Scenario& scenario, const std::string& name, Image image);
    /// A figure of a snapshot as vectors, to a file that the user has chosen. `last_iteration`: of the run.
    void save_figure(const FigureDialog::Choice& figure, const std::string& subject,
                     std::shared_ptr<const Snapshot> snapshot, int last_iteration);
    /// Draws a figure in pixels on a thread of its own, to a file that the user has chosen.
    void draw_figure(const FigureDialog::Choice& figure, const std::string& subject, const Snapshot& snapshot,
                     ImageOptions options);
    /// The fraction that is drawn of the figures in pixels; nothing if there are none.
    std::optional<double> figure_progress() const;
    /// Those that are being drawn, and those that wait for it, are not written.
    void cancel_figures();
    /// Releases what figures were drawn from; on the window's thread.
    void forget_drawn();
    /// "NAME.svg" or the next free name.
    void save_svg(const Scenario& scenario, const std::string& name, Plot plot);

  private:
    struct Arrivals {
        std::mutex mutex;
        std::optional<ScenarioOnDisk> opened;
        std::vector<ScenarioOnDisk> saved;
        std::vector<DataFile> data;
        std::optional<FolderListing> listing;
    };
    /// A figure that is being drawn.
    struct FigureInWork {
        std::unique_ptr<PreparedImage> image;
        std::stop_source stop{};
        std::atomic<double> done = 0;
    };
    static std::string look_at(Arrivals& arrivals, const std::filesystem::path& file);
    static void save(Arrivals& arrivals, ScenarioOnDisk scenario, bool packed = false);

    std::shared_ptr<const Catalogue> catalogue_;
    std::shared_ptr<NoticeBoard> board_;
    OutputFolders output_;
    std::shared_ptr<Arrivals> arrivals_ = std::make_shared<Arrivals>();
    /// Its images belong to the window's thread.
    std::vector<std::shared_ptr<FigureInWork>> figures_;
    // Last, so that their threads end before what they use.
    BackgroundWriter writer_;
    BackgroundWriter drawer_; ///< of figures, which would keep others waiting
};

} // namespace gaspard

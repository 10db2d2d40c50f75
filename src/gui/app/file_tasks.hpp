// The files that the window reads and writes, all of them on other threads. What became of each is said
// through the notice board.
#pragma once

#include "core/io/image.hpp"
#include "core/scenario/catalogue.hpp"
#include "core/tessellate/plot.hpp"
#include "gui/base/background_writer.hpp"
#include "gui/document/document.hpp"

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace gaspard {

/// A scenario that was read from a file and checked.
struct OpenedScenario {
    Scenario scenario;
    std::filesystem::path file; ///< absolute
};

class FileTasks {
  public:
    /// Files are written to folders of `output` that have the names of scenarios.
    FileTasks(std::shared_ptr<const Catalogue> catalogue, std::shared_ptr<NoticeBoard> board,
              std::filesystem::path output)
        : catalogue_(std::move(catalogue)), board_(board), output_(std::move(output)),
          writer_(std::move(board)) {}

    /// Reads a scenario file; take_opened() gives the scenario if it is valid.
    void open(const std::filesystem::path& file);
    /// The scenario read last, once.
    std::optional<OpenedScenario> take_opened();
    /// Writes the files of a live run in its scenario's formats, on the solver's thread.
    void export_run(DocumentRun& run);
    void save_scenario(const Scenario& scenario);
    /// "NAME.png" or the next free name.
    void save_image(const Scenario& scenario, const std::string& name, Image image);
    /// "NAME.svg" or the next free name.
    void save_svg(const Scenario& scenario, const std::string& name, Plot plot);

  private:
    struct Arrivals {
        std::mutex mutex;
        std::optional<OpenedScenario> newest;
    };
    std::filesystem::path folder(const Scenario& scenario) const { return output_ / scenario.name; }

    std::shared_ptr<const Catalogue> catalogue_;
    std::shared_ptr<NoticeBoard> board_;
    std::filesystem::path output_;
    std::shared_ptr<Arrivals> arrivals_ = std::make_shared<Arrivals>();
    BackgroundWriter writer_; ///< last, so that its thread ends before what it uses
};

} // namespace gaspard

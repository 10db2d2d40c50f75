// history.csv: one row per iterate, whole, or written as a run makes them.
#pragma once

#include "core/base/export.hpp"
#include "core/session/run.hpp"

#include <exception>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard GASPARD_API {

class AtomicFile; // core/io/atomic_file.hpp

/// What every history has, then the further series of the reports, then the note.
std::vector<std::string> history_columns(const std::vector<StepReport>& history);
/// One row per iterate, with these columns; what was not measured is empty.
std::string history_csv(const std::vector<StepReport>& history);

/// Has every time step of a run, also those that its history leaves out (session/history_thinning.hpp). The
/// file appears when it is finished.
class HistoryFile {
  public:
    /// Writes the rows that there are; the last one is written when the next is added, as it may change
    /// until then.
    HistoryFile(std::filesystem::path file, const Run& run);
    ~HistoryFile();
    HistoryFile(const HistoryFile&) = delete;
    HistoryFile& operator=(const HistoryFile&) = delete;
    /// After each step of the run, which is only to step.
    void add(const StepReport& report);
    /// With the last row as the run has it now. Throws MachineError if this, or an earlier row, could not be
    /// written.
    void finish(const Run& run);

  private:
    void write(std::string_view text);

    std::vector<std::string> columns_;
    std::exception_ptr failure_; ///< of a row: the run goes on, as its other files may be possible
    std::unique_ptr<AtomicFile> file_;
    std::string text_; ///< not written yet
    StepReport last_;
};

} // namespace GASPARD_API

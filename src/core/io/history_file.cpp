#include "core/io/history_file.hpp"

#include "core/base/error.hpp"
#include "core/io/atomic_file.hpp"
#include "core/session/report_columns.hpp"

#include <array>
#include <utility>

namespace gaspard {

std::vector<std::string> history_columns(const std::vector<StepReport>& history) {
    static constexpr std::array<std::string_view, 9> always = {
        "iteration",     "residual",  "equidistribution", "exact_rms",       "min_jacobian",
        "tangled_cells", "step_size", "seconds",          "inner_iterations"};
    std::vector<std::string> columns = report_columns(always, history);
    columns.emplace_back("note");
    return columns;
}

std::string history_csv(const std::vector<StepReport>& history) {
    const std::vector<std::string> columns = history_columns(history);
    std::string text = csv_head(columns) + '\n';
    for (const auto& row : history) text += csv_row(row, columns) + '\n';
    return text;
}

HistoryFile::HistoryFile(std::filesystem::path file, const Run& run)
    : columns_(history_columns(run.history())), file_(std::make_unique<AtomicFile>(std::move(file))),
      last_(run.history().front()) {
    write(csv_head(columns_) + '\n');
    for (const StepReport& report : run.history())
        if (&report != &run.history().front()) add(report);
}

HistoryFile::~HistoryFile() = default;

void HistoryFile::add(const StepReport& report) {
    write(csv_row(last_, columns_) + '\n');
    last_ = report;
}

void HistoryFile::write(std::string_view text) {
    constexpr std::size_t at_once = 1 << 16;
    if (failure_) return;
    text_ += text;
    if (text_.size() < at_once) return;
    try {
        file_->write(text_);
    } catch (const MachineError&) {
        failure_ = std::current_exception();
        file_.reset(); // a full disk has space for the other files again
    }
    text_.clear();
}

void HistoryFile::finish(const Run& run) {
    if (failure_) std::rethrow_exception(failure_);
    file_->write(text_ + csv_row(run.history().back(), columns_) + '\n');
    file_->finish();
}

} // namespace gaspard

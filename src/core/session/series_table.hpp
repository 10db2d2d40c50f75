// The series of a run: residual, diagnostics, step size, then those of the method. One immutable table, shared
// by all reports of the run.
#pragma once

#include "core/base/series.hpp"

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace gaspard {

class SeriesTable {
  public:
    SeriesTable(SeriesInfo residual, std::vector<SeriesInfo> diagnostics, std::vector<SeriesInfo> of_method);

    const std::vector<SeriesInfo>& all() const { return all_; }
    std::optional<std::size_t> find(std::string_view name) const;
    static constexpr std::size_t residual() { return 0; }
    std::size_t step_size() const { return step_size_; }
    std::size_t first_of_method() const { return step_size_ + 1; }
    /// Where StepReport::values has the value of a series other than residual and step size, and how many
    /// there are.
    std::size_t slot(std::size_t place) const { return place < step_size_ ? place - 1 : place - 2; }
    std::size_t slots() const { return all_.size() - 2; }

  private:
    std::vector<SeriesInfo> all_;
    std::size_t step_size_;
};

/// What every run reports; for reports that belong to none.
const std::shared_ptr<const SeriesTable>& common_series();

} // namespace gaspard

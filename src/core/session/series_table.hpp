// The series of a run: residual, diagnostics, step size, then those of the method, and by which of them the
// run is judged. One immutable table, shared by all reports of the run.
#pragma once

#include "core/base/export.hpp"
#include "core/base/series.hpp"

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace gaspard GASPARD_API {

class SeriesTable {
  public:
    /// `criterion`: as MethodType::criterion.
    SeriesTable(SeriesInfo residual, std::vector<SeriesInfo> diagnostics, std::vector<SeriesInfo> of_method,
                std::string_view criterion = "residual");

    const std::vector<SeriesInfo>& all() const { return all_; }
    std::optional<std::size_t> find(std::string_view name) const;
    static constexpr std::size_t residual() { return 0; }
    /// The place of the series that the run makes smaller than method.tolerance.
    std::size_t criterion() const { return criterion_; }
    std::size_t step_size() const { return step_size_; }
    std::size_t first_of_method() const { return step_size_ + 1; }
    /// Where StepReport::values has the value of a series other than residual and step size, and how many
    /// there are.
    std::size_t slot(std::size_t place) const { return place < step_size_ ? place - 1 : place - 2; }
    std::size_t slots() const { return all_.size() - 2; }

  private:
    std::vector<SeriesInfo> all_;
    std::size_t step_size_, criterion_;
};

/// What every run reports; for reports that belong to none.
const std::shared_ptr<const SeriesTable>& common_series();

} // namespace GASPARD_API

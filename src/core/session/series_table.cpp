#include "core/session/series_table.hpp"

#include "core/base/check.hpp"
#include "core/diagnostics/quality.hpp"
#include "core/method/method.hpp"

#include <algorithm>
#include <iterator>

namespace gaspard {

SeriesTable::SeriesTable(SeriesInfo residual, std::vector<SeriesInfo> diagnostics,
                         std::vector<SeriesInfo> of_method, std::string_view criterion)
    : step_size_(diagnostics.size() + 1), criterion_(0) {
    GASPARD_CHECK(residual.name == "residual");
    all_.push_back(std::move(residual));
    const auto append = [this](std::vector<SeriesInfo>& more) {
        all_.insert(all_.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
    };
    append(diagnostics);
    all_.push_back({.name = "step_size",
                    .label = "Step size",
                    .symbol = "Δt",
                    .scale = ParameterScale::logarithmic,
                    .help = "of the update that led to the iterate",
                    .column = false});
    append(of_method);
    for (std::size_t i = 0; i < all_.size(); ++i) GASPARD_CHECK(find(all_[i].name) == i); // names are unique
    const auto place = find(criterion);
    GASPARD_CHECK(place && !all_[*place].measured); // every iterate has it
    criterion_ = *place;
}

std::optional<std::size_t> SeriesTable::find(std::string_view name) const {
    const auto found =
        std::find_if(all_.begin(), all_.end(), [&](const auto& one) { return one.name == name; });
    if (found == all_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - all_.begin());
}

const std::shared_ptr<const SeriesTable>& common_series() {
    static const auto table = std::make_shared<const SeriesTable>(normalised_residual(), quality_series(),
                                                                  std::vector<SeriesInfo>{});
    return table;
}

} // namespace gaspard

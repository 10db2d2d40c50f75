#include "core/transport/cell_pattern.hpp"

#include <algorithm>

namespace gaspard {

CellPattern::CellPattern(const CellUnknowns& unknowns) : per_cell_(unknowns.per_cell) {
    std::vector<std::vector<std::int32_t>> rows(unknowns.count);
    for (std::size_t c = 0; c < unknowns.cells(); ++c)
        for (const auto row : unknowns.of(c)) {
            auto& list = rows[static_cast<std::size_t>(row)];
            const auto numbers = unknowns.of(c);
            list.insert(list.end(), numbers.begin(), numbers.end());
        }
    starts_.push_back(0);
    for (auto& row : rows) {
        std::sort(row.begin(), row.end());
        row.erase(std::unique(row.begin(), row.end()), row.end());
        columns_.insert(columns_.end(), row.begin(), row.end());
        starts_.push_back(static_cast<std::uint32_t>(columns_.size()));
    }
    slots_.reserve(unknowns.cells() * per_cell_ * per_cell_);
    for (std::size_t c = 0; c < unknowns.cells(); ++c)
        for (const auto row : unknowns.of(c)) {
            const auto begin = columns_.begin() + starts_[static_cast<std::size_t>(row)],
                       end = columns_.begin() + starts_[static_cast<std::size_t>(row) + 1];
            for (const auto column : unknowns.of(c))
                slots_.push_back(
                    static_cast<std::uint32_t>(std::lower_bound(begin, end, column) - columns_.begin()));
        }
}

} // namespace gaspard

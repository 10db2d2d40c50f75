#include "core/linear/dissection.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <numeric>

namespace gaspard {

namespace {

constexpr std::size_t cells_per_leaf = 3; // parts of at most this many cells are not divided

class Dissector {
  public:
    Dissector(const CellUnknowns& unknowns, const Points& middles)
        : unknowns_(unknowns), middles_(middles), side_(unknowns.count, 0) {
        GASPARD_CHECK(middles.size() == unknowns.cells());
        result_.permutation.assign(unknowns.count, -1);
        result_.cells.resize(unknowns.cells());
        std::iota(result_.cells.begin(), result_.cells.end(), 0);
    }

    Dissection run() {
        std::vector<std::int32_t> all(unknowns_.count);
        std::iota(all.begin(), all.end(), 0);
        cut(0, result_.cells.size(), std::move(all));
        GASPARD_CHECK(static_cast<std::size_t>(next_) == unknowns_.count);
        for (auto& part : result_.parts) {
            for (auto& unknown : part.border)
                unknown = result_.permutation[static_cast<std::size_t>(unknown)];
            std::sort(part.border.begin(), part.border.end());
        }
        return std::move(result_);
    }

  private:
    using Numbers = std::vector<std::int32_t>;

    std::span<const std::int32_t> of(std::size_t i) const {
        return unknowns_.of(static_cast<std::size_t>(result_.cells[i]));
    }

    double middle(std::int32_t cell, int axis) const {
        const auto c = static_cast<std::size_t>(cell);
        return axis == 0 ? middles_.x[c] : axis == 1 ? middles_.y[c] : middles_.z[c];
    }

    /// Partitions the cells begin .. end at the median of their coordinate along an axis.
    void halve(std::size_t begin, std::size_t end, int axis) {
        const auto first = result_.cells.begin() + static_cast<std::ptrdiff_t>(begin);
        std::nth_element(first, first + static_cast<std::ptrdiff_t>((end - begin) / 2),
                         result_.cells.begin() + static_cast<std::ptrdiff_t>(end),
                         [&](std::int32_t a, std::int32_t b) {
                             return std::pair(middle(a, axis), a) < std::pair(middle(b, axis), b);
                         });
    }

    /// Records for each unknown of cells begin .. end the halves it occurs in: 1, 2, or 3 for both.
    void mark(std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            for (const auto unknown : of(i))
                side_[static_cast<std::size_t>(unknown)] |= i < begin + (end - begin) / 2 ? 1 : 2;
    }
    void unmark(std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            for (const auto unknown : of(i)) side_[static_cast<std::size_t>(unknown)] = 0;
    }

    std::size_t cut_size(std::size_t begin, std::size_t end, const Numbers& own) {
        mark(begin, end);
        const auto both = std::count_if(own.begin(), own.end(), [&](std::int32_t unknown) {
            return side_[static_cast<std::size_t>(unknown)] == 3;
        });
        unmark(begin, end);
        return static_cast<std::size_t>(both);
    }

    /// Divides the cells begin .. end. `own`: their unknowns that no separator above contains. Returns the
    /// index of the new part.
    std::int32_t cut(std::size_t begin, std::size_t end, Numbers own) {
        Dissection::Part part;
        Numbers separator;
        if (end - begin <= cells_per_leaf) {
            part.cells_begin = static_cast<std::int32_t>(begin);
            part.cells_end = static_cast<std::int32_t>(end);
            separator = own;
        } else {
            int best_axis = 0;
            std::size_t best = own.size() + 1;
            for (int axis = 0; axis < 3; ++axis) {
                halve(begin, end, axis);
                if (const std::size_t size = cut_size(begin, end, own); size < best)
                    best = size, best_axis = axis;
            }
            halve(begin, end, best_axis);
            mark(begin, end);
            Numbers left, right;
            for (const auto unknown : own) {
                const char side = side_[static_cast<std::size_t>(unknown)];
                (side == 3 ? separator : side == 1 ? left : right).push_back(unknown);
            }
            unmark(begin, end);
            const std::size_t half = begin + (end - begin) / 2;
            part.children[0] = cut(begin, half, std::move(left));
            part.children[1] = cut(half, end, std::move(right));
        }
        part.begin = next_;
        for (const auto unknown : separator) result_.permutation[static_cast<std::size_t>(unknown)] = next_++;
        part.end = next_;
        part.border = border(begin, end);
        result_.parts.push_back(std::move(part));
        return static_cast<std::int32_t>(result_.parts.size()) - 1;
    }

    /// The unknowns of cells begin .. end that are eliminated later, in other parts.
    Numbers border(std::size_t begin, std::size_t end) {
        Numbers list;
        for (std::size_t i = begin; i < end; ++i)
            for (const auto unknown : of(i)) {
                const auto u = static_cast<std::size_t>(unknown);
                if (result_.permutation[u] >= 0 || side_[u]) continue;
                side_[u] = 1;
                list.push_back(unknown);
            }
        for (const auto unknown : list) side_[static_cast<std::size_t>(unknown)] = 0;
        return list;
    }

    const CellUnknowns& unknowns_;
    const Points& middles_;
    std::vector<char> side_;
    Dissection result_;
    std::int32_t next_ = 0;
};

} // namespace

Dissection dissect(const CellUnknowns& unknowns, const Points& middles) {
    return Dissector(unknowns, middles).run();
}

} // namespace gaspard

#include "core/linear/cell_cholesky.hpp"

#include "core/base/check.hpp"

// With -march=native GCC 12 takes the registers that its own AVX-512 header leaves undefined on purpose for
// mistakes of ours, wherever Eigen is inlined (GCC bug 105593).
#pragma GCC diagnostic push
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <Eigen/Dense>
#pragma GCC diagnostic pop

namespace gaspard {

namespace {

using Matrix = Eigen::MatrixXd;

/// What a part leaves for the one above: a symmetric matrix (its lower triangle) over its border.
struct Remainder {
    Matrix matrix;
};

/// Where the unknowns of a front stand in it.
class FrontPlaces {
  public:
    explicit FrontPlaces(std::size_t unknowns) : place_(unknowns, -1) {}
    void set(const Dissection::Part& part) {
        Eigen::Index next = 0;
        for (std::int32_t u = part.begin; u < part.end; ++u) place_[static_cast<std::size_t>(u)] = next++;
        for (const auto u : part.border) place_[static_cast<std::size_t>(u)] = next++;
    }
    Eigen::Index operator()(std::int32_t unknown) const { return place_[static_cast<std::size_t>(unknown)]; }

  private:
    std::vector<Eigen::Index> place_;
};

} // namespace

CellCholesky::CellCholesky(const CellUnknowns& unknowns, std::shared_ptr<const Dissection> dissection,
                           const CellMatrix& cell_matrix, const Advance& advance, std::stop_token stop)
    : size_(unknowns.count) {
    const auto& all = dissection->parts;
    std::vector<Remainder> remainders(all.size());
    std::vector<double> small(unknowns.per_cell * unknowns.per_cell);
    FrontPlaces at(size_);
    Matrix front;
    std::size_t entries = 0, done = 0;
    for (const auto& part : all) {
        const auto own = static_cast<std::size_t>(part.end - part.begin);
        entries += own * (own + 1) / 2 + own * part.border.size();
    }
    values_.reserve(entries);
    parts_.reserve(all.size());
    for (std::size_t p = 0; p < all.size(); ++p) {
        if (stop.stop_requested()) throw Interrupted();
        if (advance && values_.size() >= done) {
            advance(static_cast<double>(values_.size()) /
                    static_cast<double>(std::max<std::size_t>(1, entries)));
            done += entries / 50;
        }
        const auto& part = all[p];
        const Eigen::Index own = part.end - part.begin,
                           border = static_cast<Eigen::Index>(part.border.size());
        at.set(part);
        front.setZero(own + border, own + border);
        for (auto i = part.cells_begin; i < part.cells_end; ++i) {
            const auto cell = static_cast<std::size_t>(dissection->cells[static_cast<std::size_t>(i)]);
            cell_matrix(cell, small);
            const auto numbers = unknowns.of(cell);
            for (std::size_t a = 0; a < numbers.size(); ++a)
                for (std::size_t b = 0; b < numbers.size(); ++b) {
                    const auto row = at(dissection->place[static_cast<std::size_t>(numbers[a])]);
                    const auto column = at(dissection->place[static_cast<std::size_t>(numbers[b])]);
                    if (row >= column) front(row, column) += small[a * numbers.size() + b];
                }
        }
        for (const auto child : part.children) {
            if (child < 0) continue;
            const auto& numbers = all[static_cast<std::size_t>(child)].border;
            const Matrix& rest = remainders[static_cast<std::size_t>(child)].matrix;
            for (std::size_t b = 0; b < numbers.size(); ++b) {
                const auto column = at(numbers[b]);
                for (std::size_t a = b; a < numbers.size(); ++a) // both ascend
                    front(at(numbers[a]), column) +=
                        rest(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b));
            }
            remainders[static_cast<std::size_t>(child)].matrix.resize(0, 0);
        }

        const Eigen::LLT<Matrix, Eigen::Lower> factor(front.topLeftCorner(own, own));
        GASPARD_CHECK(factor.info() == Eigen::Success);
        auto below = front.bottomLeftCorner(border, own);
        if (own > 0 && border > 0) {
            factor.matrixL().transpose().solveInPlace<Eigen::OnTheRight>(below);
            front.bottomRightCorner(border, border).selfadjointView<Eigen::Lower>().rankUpdate(below, -1);
        }
        remainders[p].matrix = front.bottomRightCorner(border, border);

        parts_.push_back({part.begin, part.end - part.begin, static_cast<std::int32_t>(border),
                          values_.size(), indices_.size()});
        for (Eigen::Index i = 0; i < own; ++i) {
            for (Eigen::Index j = 0; j < i; ++j) values_.push_back(factor.matrixLLT()(i, j));
            values_.push_back(1 / factor.matrixLLT()(i, i));
        }
        for (Eigen::Index i = 0; i < border; ++i)
            for (Eigen::Index j = 0; j < own; ++j) values_.push_back(below(i, j));
        indices_.insert(indices_.end(), part.border.begin(), part.border.end());
    }
    if (advance) advance(1);
}

} // namespace gaspard

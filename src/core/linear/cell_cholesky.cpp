#include "core/linear/cell_cholesky.hpp"

#include "core/base/check.hpp"

#include <Eigen/Dense>

namespace gaspard {

namespace {

using Matrix = Eigen::MatrixXd;

/// The dense matrix in which a part eliminates: its own unknowns first, then its border.
class Front {
  public:
    explicit Front(std::size_t unknowns) : place_(unknowns, -1) {}

    void begin(const Dissection::Part& part) {
        Eigen::Index next = 0;
        for (std::int32_t u = part.begin; u < part.end; ++u) at(u) = next++;
        for (const auto u : part.border) at(u) = next++;
        own_ = part.end - part.begin;
        matrix_.setZero(next, next);
    }
    /// A symmetric matrix over some unknowns, row by row.
    void add_cell(std::span<const std::int32_t> numbers, const std::vector<std::int32_t>& place,
                  std::span<const double> values) {
        const auto row_of = [&](std::size_t n) { return at(place[static_cast<std::size_t>(numbers[n])]); };
        for (std::size_t a = 0; a < numbers.size(); ++a)
            for (std::size_t b = 0; b < numbers.size(); ++b)
                if (const auto row = row_of(a), column = row_of(b); row >= column)
                    matrix_(row, column) += values[a * numbers.size() + b];
    }
    /// What another part leaves over its border, ascending: the lower triangle.
    void add_remainder(const std::vector<std::int32_t>& border, const Matrix& rest) {
        for (std::size_t b = 0; b < border.size(); ++b)
            for (std::size_t a = b; a < border.size(); ++a)
                matrix_(at(border[a]), at(border[b])) +=
                    rest(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b));
    }
    /// Leaves the factor's rows in the place of the own columns; returns what remains over the border.
    Matrix eliminate() {
        const Eigen::Index border = matrix_.rows() - own_;
        if (own_ > 0) {
            const Eigen::LLT<Matrix, Eigen::Lower> factor(matrix_.topLeftCorner(own_, own_));
            GASPARD_CHECK(factor.info() == Eigen::Success);
            matrix_.topLeftCorner(own_, own_) = factor.matrixLLT();
            if (border > 0) {
                auto below = matrix_.bottomLeftCorner(border, own_);
                factor.matrixL().transpose().solveInPlace<Eigen::OnTheRight>(below);
                matrix_.bottomRightCorner(border, border)
                    .selfadjointView<Eigen::Lower>()
                    .rankUpdate(below, -1);
            }
        }
        return matrix_.bottomRightCorner(border, border);
    }
    /// As CellCholesky keeps it: the triangle with reciprocals on the diagonal, then the rows of the border.
    void append_to(std::vector<double>& values) const {
        for (Eigen::Index i = 0; i < own_; ++i) {
            for (Eigen::Index j = 0; j < i; ++j) values.push_back(matrix_(i, j));
            values.push_back(1 / matrix_(i, i));
        }
        for (Eigen::Index i = own_; i < matrix_.rows(); ++i)
            for (Eigen::Index j = 0; j < own_; ++j) values.push_back(matrix_(i, j));
    }

  private:
    Eigen::Index& at(std::int32_t unknown) { return place_[static_cast<std::size_t>(unknown)]; }

    std::vector<Eigen::Index> place_; ///< of every unknown of the present part: its row
    Eigen::Index own_ = 0;
    Matrix matrix_;
};

std::size_t entries_of(const Dissection& dissection) {
    std::size_t entries = 0;
    for (const auto& part : dissection.parts) {
        const auto own = static_cast<std::size_t>(part.end - part.begin);
        entries += own * (own + 1) / 2 + own * part.border.size();
    }
    return entries;
}

} // namespace

CellCholesky::CellCholesky(const CellUnknowns& unknowns, std::shared_ptr<const Dissection> dissection,
                           const CellMatrix& cell_matrix, const Advance& advance, std::stop_token stop)
    : size_(unknowns.count) {
    const auto& all = dissection->parts;
    const std::size_t entries = entries_of(*dissection), often = entries / 50;
    std::vector<Matrix> remainders(all.size());
    std::vector<double> small(unknowns.per_cell * unknowns.per_cell);
    Front front(size_);
    values_.reserve(entries);
    parts_.reserve(all.size());
    std::size_t next_advance = 0;
    for (std::size_t p = 0; p < all.size(); ++p) {
        if (stop.stop_requested()) throw Interrupted();
        if (advance && values_.size() >= next_advance) {
            advance(static_cast<double>(values_.size()) / static_cast<double>(entries));
            next_advance += often;
        }
        const auto& part = all[p];
        front.begin(part);
        for (auto i = part.cells_begin; i < part.cells_end; ++i) {
            const auto cell = static_cast<std::size_t>(dissection->cells[static_cast<std::size_t>(i)]);
            cell_matrix(cell, small);
            front.add_cell(unknowns.of(cell), dissection->permutation, small);
        }
        for (const auto child : part.children) {
            if (child < 0) continue;
            Matrix& rest = remainders[static_cast<std::size_t>(child)];
            front.add_remainder(all[static_cast<std::size_t>(child)].border, rest);
            rest.resize(0, 0);
        }
        remainders[p] = front.eliminate();
        parts_.push_back({part.begin, part.end - part.begin, static_cast<std::int32_t>(part.border.size()),
                          values_.size(), indices_.size()});
        front.append_to(values_);
        indices_.insert(indices_.end(), part.border.begin(), part.border.end());
    }
    if (advance) advance(1);
}

} // namespace gaspard

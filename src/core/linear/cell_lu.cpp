#include "core/linear/cell_lu.hpp"

#include "core/base/check.hpp"
#include "core/base/error.hpp"

#include <Eigen/Dense>
#include <utility>

namespace gaspard {

namespace {

/// What is left of a part: its own unknowns are y - x (those of its border).
struct Eliminated {
    Eigen::MatrixXd x;
    Eigen::VectorXd y;
};

/// Eliminates part after part; unknowns are in elimination order.
class PartElimination {
  public:
    PartElimination(const CellUnknowns& unknowns, const Dissection& dissection, Eigen::VectorXd b)
        : unknowns_(unknowns), dissection_(dissection), u_(std::move(b)), place_(unknowns.count, -1),
          remainders_(dissection.parts.size()), eliminated_(dissection.parts.size()) {}

    void eliminate(std::size_t p, const CellMatrixOf& cell_matrix) {
        const Dissection::Part& part = dissection_.parts[p];
        begin(part);
        add_cells(part, cell_matrix);
        for (const auto child : part.children)
            if (child >= 0) add_remainder(static_cast<std::size_t>(child));
        const Eigen::Index own = part.end - part.begin, border = front_.rows() - own;
        if (own == 0) {
            remainders_[p] = front_;
            return;
        }
        const Eigen::PartialPivLU<Eigen::MatrixXd> factors(front_.topLeftCorner(own, own));
        Eliminated& made = eliminated_[p];
        made.y = factors.solve(u_.segment(part.begin, own));
        if (border == 0) return;
        made.x = factors.solve(front_.topRightCorner(own, border));
        const auto below = front_.bottomLeftCorner(border, own);
        remainders_[p] = front_.bottomRightCorner(border, border);
        remainders_[p].noalias() -= below * made.x;
        const Eigen::VectorXd passed = below * made.y;
        for (Eigen::Index i = 0; i < border; ++i) u_[part.border[static_cast<std::size_t>(i)]] -= passed[i];
    }
    /// From the last part to the first.
    void substitute(std::size_t p) {
        const Dissection::Part& part = dissection_.parts[p];
        if (part.begin == part.end) return;
        Eliminated& made = eliminated_[p];
        if (const auto border = static_cast<Eigen::Index>(part.border.size()); border > 0) {
            Eigen::VectorXd known(border);
            for (Eigen::Index i = 0; i < border; ++i) known[i] = u_[part.border[static_cast<std::size_t>(i)]];
            made.y.noalias() -= made.x * known;
        }
        u_.segment(part.begin, part.end - part.begin) = made.y;
    }
    const Eigen::VectorXd& solution() const { return u_; }

  private:
    Eigen::Index& at(std::int32_t unknown) { return place_[static_cast<std::size_t>(unknown)]; }

    void begin(const Dissection::Part& part) {
        Eigen::Index next = 0;
        for (std::int32_t u = part.begin; u < part.end; ++u) at(u) = next++;
        for (const auto u : part.border) at(u) = next++;
        front_.setZero(next, next);
    }
    void add_cells(const Dissection::Part& part, const CellMatrixOf& cell_matrix) {
        const std::size_t n = unknowns_.per_cell;
        small_.resize(n * n);
        std::vector<Eigen::Index> rows(n);
        for (auto i = part.cells_begin; i < part.cells_end; ++i) {
            const auto cell = static_cast<std::size_t>(dissection_.cells[static_cast<std::size_t>(i)]);
            cell_matrix(cell, small_);
            for (std::size_t a = 0; a < n; ++a)
                rows[a] = at(dissection_.permutation[static_cast<std::size_t>(unknowns_.of(cell)[a])]);
            for (std::size_t a = 0; a < n; ++a)
                for (std::size_t c = 0; c < n; ++c) front_(rows[a], rows[c]) += small_[a * n + c];
        }
    }
    void add_remainder(std::size_t child) {
        const auto& border = dissection_.parts[child].border;
        Eigen::MatrixXd rest = std::exchange(remainders_[child], Eigen::MatrixXd());
        for (std::size_t b = 0; b < border.size(); ++b)
            for (std::size_t a = 0; a < border.size(); ++a)
                front_(at(border[a]), at(border[b])) +=
                    rest(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b));
    }

    const CellUnknowns& unknowns_;
    const Dissection& dissection_;
    Eigen::VectorXd u_;               ///< the right-hand side, and from the last part on the solution
    std::vector<Eigen::Index> place_; ///< of every unknown of the present part: its row
    std::vector<Eigen::MatrixXd> remainders_;
    std::vector<Eliminated> eliminated_;
    Eigen::MatrixXd front_; ///< the part's own unknowns, then its border
    std::vector<double> small_;
};

} // namespace

std::vector<double> solve_by_parts(const CellUnknowns& unknowns, const Dissection& dissection,
                                   const CellMatrixOf& cell_matrix, std::span<const double> b,
                                   const std::stop_token& stop) {
    GASPARD_CHECK(b.size() == unknowns.count && dissection.permutation.size() == b.size());
    Eigen::VectorXd ordered(static_cast<Eigen::Index>(b.size()));
    for (std::size_t i = 0; i < b.size(); ++i) ordered[dissection.permutation[i]] = b[i];
    PartElimination elimination(unknowns, dissection, std::move(ordered));
    for (std::size_t p = 0; p < dissection.parts.size(); ++p) {
        if (stop.stop_requested()) throw Interrupted();
        elimination.eliminate(p, cell_matrix);
    }
    for (std::size_t p = dissection.parts.size(); p-- > 0;) elimination.substitute(p);
    std::vector<double> u(b.size());
    for (std::size_t i = 0; i < u.size(); ++i) u[i] = elimination.solution()[dissection.permutation[i]];
    return u;
}

} // namespace gaspard

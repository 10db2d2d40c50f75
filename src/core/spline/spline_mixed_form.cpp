// The mixed form (6.4), solved by Algorithm 2. M and R are restricted to the inner functions of S^p, all but
// the first and the last; D is the mass matrix of S^p-1:
//
//   (D (x) S + S (x) D) phi = <div lift, w> - <g, w>,     S = R^T M^-1 R                  (6.18)
//
//   Psi = lift - (M^-1 R phi, phi R^T M^-1)
//
// The lift has the prescribed normal trace and is orthogonal to all fields with zero normal trace, so it
// makes no other contribution.
#include "core/base/check.hpp"
#include "core/spline/line_matrices.hpp"

namespace gaspard {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Inner {
    explicit Inner(const LineMatrices& all) {
        const Index n = all.mass.rows() - 2;
        const MatrixXd r = all.r.middleRows(1, n);
        const auto mass = all.mass.block(1, 1, n, n).llt();
        gradient = mass.solve(r);
        schur = r.transpose() * gradient;
        first = VectorXd::Zero(n + 2), last = first;
        first(0) = last(n + 1) = 1;
        first.segment(1, n) = -mass.solve(all.mass.col(0).segment(1, n));
        last.segment(1, n) = -mass.solve(all.mass.col(n + 1).segment(1, n));
    }
    MatrixXd gradient; ///< M^-1 R
    MatrixXd schur;
    VectorXd first, last; ///< 1 at one end, 0 at the other; orthogonal to the inner functions
};

VectorXd vector(std::span<const double> values) {
    return Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size()));
}

class MixedForm final : public SplineForm {
  public:
    MixedForm(const SplineLine& line, const LineMatrices& matrices, const Inner& inner,
              const NormalTrace& trace)
        : SplineForm(line, {line_operator(inner.schur), line_operator(matrices.mass_below)},
                     {{{0, false, 0}, {2, true, 0}, {1, false, 0}, {0, false, 1}, {2, true, 1}}}),
          gradient_(inner.gradient) {
        integrals_ = integrals(line_, quadrature_.lower);
        border_flux_ = flux(line_, trace);
        const auto mass = matrices.mass_below.llt();
        // Constants are reproduced exactly: project the difference from the first value.
        const auto project = [&](const std::vector<double>& values) -> VectorXd {
            std::vector<double> rest = values;
            for (double& value : rest) value -= values[0];
            return VectorXd::Constant(static_cast<Index>(size()), values[0]) +
                   mass.solve(vector(moments(line_, quadrature_.lower, rest)));
        };
        const VectorXd left = project(trace.left), right = project(trace.right);
        const VectorXd bottom = project(trace.bottom), top = project(trace.top);
        lift_x_ = inner.first * left.transpose() + inner.last * right.transpose();
        lift_y_ = bottom * inner.first.transpose() + top * inner.last.transpose();
        const MatrixXd load = matrices.r.transpose() * lift_x_ * matrices.mass_below +
                              matrices.mass_below * lift_y_ * matrices.r;
        border_load_.assign(load.data(), load.data() + load.size());
    }

    // Sums along x: psi1 with B and its derivative, psi2 with the functions of S^p-1.
    void expand(std::span<const double> phi, Border border, const SplineGrid& grid, std::size_t fields,
                Workspace& workspace) const override {
        find_map(phi, border, workspace.first, workspace.second);
        sum_along_x(grid.upper, 0, workspace.first, size(), workspace.half[0], workspace);
        if (fields > 2) sum_along_x(grid.upper, 1, workspace.first, size(), workspace.half[1], workspace);
        sum_along_x(grid.lower, 0, workspace.second, size() + 1, workspace.half[2], workspace);
    }
    std::array<SplineFunction, 2> map(std::span<const double> phi) const override {
        std::array<SplineFunction, 2> psi{SplineFunction{{{line_.upper, line_.lower}}, {}},
                                          SplineFunction{{{line_.lower, line_.upper}}, {}}};
        find_map(phi, Border::given, psi[0].coefficients, psi[1].coefficients);
        return psi;
    }
    // The solution of the Poisson problem with div Psi = 2.
    std::vector<double> identity() const override {
        std::vector<double> phi(unknowns());
        for (std::size_t j = 0; j < size(); ++j)
            for (std::size_t i = 0; i < size(); ++i)
                phi[j * size() + i] = border_load_[j * size() + i] - 2 * integrals_[i] * integrals_[j];
        auto workspace = poisson_.make_workspace();
        poisson_.solve(phi, phi, 0, workspace);
        return phi;
    }
    const KnotVector& space() const override { return line_.lower; }
    const LineTable& tests() const override { return quadrature_.lower; }

  private:
    /// The coefficients of psi1 and psi2.
    void find_map(std::span<const double> phi, Border border, std::vector<double>& psi1,
                  std::vector<double>& psi2) const {
        const auto below = static_cast<Index>(size()), above = below + 1;
        psi1.resize(static_cast<std::size_t>(below * above));
        psi2.resize(psi1.size());
        const Eigen::Map<const MatrixXd> potential(phi.data(), below, below);
        Eigen::Map<MatrixXd> first(psi1.data(), above, below), second(psi2.data(), below, above);
        first = border == Border::given ? lift_x_ : MatrixXd::Zero(above, below);
        second = border == Border::given ? lift_y_ : MatrixXd::Zero(below, above);
        first.middleRows(1, above - 2).noalias() -= gradient_ * potential;
        second.middleCols(1, above - 2).noalias() -= potential * gradient_.transpose();
    }

    MatrixXd gradient_, lift_x_, lift_y_;
};

} // namespace

std::unique_ptr<SplineForm> make_mixed_form(const SplineLine& line, const NormalTrace& trace) {
    GASPARD_CHECK(line.upper.degree >= 2);
    const LineMatrices matrices(line);
    return std::make_unique<MixedForm>(line, matrices, Inner(matrices), trace);
}

} // namespace gaspard

// The mixed form (6.4), solved by Algorithms 2 and 3. M and R are restricted to the inner functions of S^p,
// all but the first and the last; D is the mass matrix of S^p-1. In two dimensions
//
//   (D (x) S + S (x) D) phi = <div lift, w> - <g, w>,     S = R^T M^-1 R                  (6.18)
//
//   Psi = lift - (M^-1 R phi, phi R^T M^-1)
//
// and in three the same with the sum over three directions (6.24), where R_2^T M_2^-1 R_3 is a misprint.
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

/// out += scale times the matrix along one direction of a tensor; `before` numbers for each index of it. Rows
/// start with row `first` of out, which has `extent` of them.
void add_along(const MatrixXd& matrix, double scale, std::size_t before, std::span<const double> in,
               std::size_t first, std::size_t extent, std::span<double> out) {
    const auto rows = static_cast<Index>(extent), low = static_cast<Index>(first),
               fast = static_cast<Index>(before);
    const Index columns = matrix.cols(), after = static_cast<Index>(in.size()) / (fast * columns);
    if (fast == 1) {
        const Eigen::Map<const MatrixXd> from(in.data(), columns, after);
        Eigen::Map<MatrixXd>(out.data(), rows, after).middleRows(low, matrix.rows()).noalias() +=
            scale * matrix * from;
        return;
    }
    for (Index a = 0; a < after; ++a) {
        const Eigen::Map<const MatrixXd> from(in.data() + a * fast * columns, fast, columns);
        Eigen::Map<MatrixXd>(out.data() + a * fast * rows, fast, rows)
            .middleCols(low, matrix.rows())
            .noalias() += scale * from * matrix.transpose();
    }
}

template <std::size_t D>
class MixedForm final : public TensorForm<D> {
    using Form = TensorForm<D>;
    using typename Form::Border;
    using typename Form::FieldTerm;
    using typename Form::Half;
    using typename Form::LineSum;
    using typename Form::Workspace;

    /// The derivative along `b` (none if b = D) of psi_a, as the sum along direction d.
    static LineSum sum_along(std::size_t d, std::size_t a, std::size_t b) { return {d == a, d == b ? 1 : 0}; }

    struct Terms {
        std::array<Half, Form::halves> halves{};
        std::array<FieldTerm, Form::fields> fields{};
    };
    /// psi_a, then its derivatives along a and later directions. Halves are those of psi_a and of its
    /// derivatives along all directions but the last.
    static Terms terms() {
        Terms all;
        std::size_t half = 0, upper = D;
        for (std::size_t a = 0; a < D; ++a) {
            const std::size_t own = half;
            for (std::size_t b = a; b <= D; ++b) { // D: psi_a itself, which comes first
                const std::size_t along = b == a ? D : b - 1;
                if (along == D - 1) continue; // the derivative along the last direction needs no other half
                all.halves[half].component = a;
                for (std::size_t d = 0; d + 1 < D; ++d) all.halves[half].sums[d] = sum_along(d, a, along);
                if (along == D)
                    all.fields[a] = {half, sum_along(D - 1, a, D)};
                else
                    all.fields[upper + along - a] = {half, sum_along(D - 1, a, along)};
                ++half;
            }
            all.fields[upper + D - 1 - a] = {own, sum_along(D - 1, a, D - 1)};
            upper += D - a;
        }
        return all;
    }

  public:
    MixedForm(const SplineLine& line, const LineMatrices& matrices, const Inner& inner,
              const FaceTrace<D>& trace)
        : Form(line, {line_operator(inner.schur), line_operator(matrices.mass_below), D}, terms().halves,
               terms().fields),
          gradient_(inner.gradient) {
        this->integrals_ = integrals(this->line_, tests());
        this->border_flux_ = flux(this->line_, trace);
        const MatrixXd inverse = matrices.mass_below.llt().solve(
            MatrixXd::Identity(matrices.mass_below.rows(), matrices.mass_below.cols()));
        this->border_load_.assign(this->unknowns(), 0.0);
        const std::size_t below = this->size(), above = below + 1;
        for (std::size_t d = 0; d < D; ++d) {
            const std::size_t before = stride(d);
            lift_[d].assign(this->unknowns() / below * above, 0.0);
            add_along(inner.first, 1, before, project(inverse, trace.low[d]), 0, above, lift_[d]);
            add_along(inner.last, 1, before, project(inverse, trace.high[d]), 0, above, lift_[d]);
            std::vector<double> load = along(matrices.r.transpose(), before, lift_[d]);
            for (std::size_t other = 0; other < D; ++other)
                if (other != d) load = along(matrices.mass_below, stride(other), load);
            for (std::size_t i = 0; i < load.size(); ++i) this->border_load_[i] += load[i];
        }
    }

    std::array<SplineFunction, D> map(std::span<const double> phi) const override {
        std::array<SplineFunction, D> psi;
        std::array<std::vector<double>, D> coefficients;
        find_map(phi, Border::given, coefficients);
        for (std::size_t d = 0; d < D; ++d) {
            psi[d].space.directions.assign(D, this->line_.lower);
            psi[d].space.directions[d] = this->line_.upper;
            psi[d].coefficients = std::move(coefficients[d]);
        }
        return psi;
    }
    // The solution of the Poisson problem with div Psi = D.
    std::vector<double> identity() const override {
        const std::size_t n = this->size();
        std::vector<double> phi(this->unknowns());
        for (std::size_t i = 0; i < phi.size(); ++i) {
            double product = static_cast<double>(D);
            for (std::size_t rest = i, d = 0; d < D; ++d, rest /= n) product *= this->integrals_[rest % n];
            phi[i] = this->border_load_[i] - product;
        }
        auto workspace = this->poisson_.make_workspace();
        this->poisson_.solve(phi, phi, 0, workspace);
        return phi;
    }
    const KnotVector& space() const override { return this->line_.lower; }
    const LineTable& tests() const override { return this->quadrature_.lower; }

  private:
    /// Of direction d, in arrays with size() numbers along the directions before it.
    std::size_t stride(std::size_t d) const {
        return d == 0 ? 1 : d == 1 ? this->size() : this->size() * this->size();
    }
    static std::vector<double> along(const MatrixXd& matrix, std::size_t before, std::span<const double> in) {
        const auto rows = static_cast<std::size_t>(matrix.rows());
        std::vector<double> out(in.size() / static_cast<std::size_t>(matrix.cols()) * rows, 0.0);
        add_along(matrix, 1, before, in, 0, rows, out);
        return out;
    }
    /// The L2 projection of the trace on a face. Constants are reproduced exactly: of the difference from the
    /// first value.
    std::vector<double> project(const MatrixXd& inverse, const std::vector<double>& values) const {
        std::vector<double> rest = values;
        for (double& value : rest) value -= values[0];
        std::vector<double> result = face_moments<D>(this->line_, tests(), rest);
        for (std::size_t d = 0; d + 1 < D; ++d) result = along(inverse, stride(d), result);
        for (double& value : result) value += values[0];
        return result;
    }
    /// The coefficients of psi_1 to psi_D.
    void find_map(std::span<const double> phi, Border border, std::array<std::vector<double>, D>& psi) const {
        for (std::size_t d = 0; d < D; ++d) {
            if (border == Border::given)
                psi[d] = lift_[d];
            else
                psi[d].assign(lift_[d].size(), 0.0);
            add_along(gradient_, -1, stride(d), phi, 1, this->size() + 1, psi[d]);
        }
    }
    std::array<std::span<const double>, D> components(std::span<const double> phi, Border border,
                                                      Workspace& workspace) const override {
        find_map(phi, border, workspace.map);
        std::array<std::span<const double>, D> all;
        for (std::size_t d = 0; d < D; ++d) all[d] = workspace.map[d];
        return all;
    }

    MatrixXd gradient_;
    std::array<std::vector<double>, D> lift_;
};

} // namespace

template <std::size_t D>
std::unique_ptr<TensorForm<D>> make_mixed_form(const SplineLine& line, const FaceTrace<D>& trace) {
    GASPARD_CHECK(line.upper.degree >= 2);
    const LineMatrices matrices(line);
    return std::make_unique<MixedForm<D>>(line, matrices, Inner(matrices), trace);
}

template std::unique_ptr<SplineForm> make_mixed_form(const SplineLine&, const FaceTrace<2>&);
template std::unique_ptr<SolidForm> make_mixed_form(const SplineLine&, const FaceTrace<3>&);

} // namespace gaspard

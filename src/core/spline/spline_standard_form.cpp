// The standard form (4.5).
#include "core/base/check.hpp"
#include "core/spline/line_matrices.hpp"

namespace gaspard {

namespace {

template <std::size_t D>
class StandardForm final : public TensorForm<D> {
    using Form = TensorForm<D>;
    using typename Form::Border;
    using typename Form::FieldTerm;
    using typename Form::Half;
    using typename Form::Workspace;

    /// All derivatives along x (and y) of an order of at most two, those that share the sum along x in turn.
    static std::array<Half, Form::halves> all_halves() {
        std::array<Half, Form::halves> all{};
        std::size_t h = 0;
        for (int x = 0; x <= 2; ++x)
            for (int y = 0; y <= (D == 3 ? 2 - x : 0); ++y) {
                all[h].sums[0].derivative = x;
                if constexpr (D == 3) all[h].sums[1].derivative = y;
                ++h;
            }
        return all;
    }
    /// The derivative of phi of these orders, one per direction.
    static FieldTerm term(const std::array<int, D>& orders) {
        const auto all = all_halves();
        FieldTerm result{.sum = {true, orders[D - 1]}};
        for (std::size_t h = 0; h < all.size(); ++h) {
            bool equal = true;
            for (std::size_t d = 0; d + 1 < D; ++d) equal = equal && all[h].sums[d].derivative == orders[d];
            if (equal) result.half = h;
        }
        return result;
    }
    static std::array<FieldTerm, Form::fields> terms() {
        std::array<FieldTerm, Form::fields> all{};
        std::size_t f = 0;
        for (std::size_t a = 0; a < D; ++a) {
            std::array<int, D> orders{};
            ++orders[a];
            all[f++] = term(orders);
        }
        for (std::size_t a = 0; a < D; ++a)
            for (std::size_t b = a; b < D; ++b) {
                std::array<int, D> orders{};
                ++orders[a], ++orders[b];
                all[f++] = term(orders);
            }
        return all;
    }

  public:
    StandardForm(const SplineLine& line, const LineMatrices& matrices, const FaceTrace<D>& trace)
        : Form(line, {line_operator(matrices.stiffness), line_operator(matrices.mass), D}, all_halves(),
               terms()) {
        const std::size_t n = this->size();
        this->integrals_ = integrals(this->line_, tests());
        this->border_flux_ = flux(this->line_, trace);
        this->border_load_.assign(this->unknowns(), 0.0);
        for (std::size_t d = 0; d < D; ++d) {
            const auto low = face_moments<D>(this->line_, tests(), trace.low[d]);
            const auto high = face_moments<D>(this->line_, tests(), trace.high[d]);
            const std::size_t stride = d == 0 ? 1 : d == 1 ? n : n * n; // of direction d
            for (std::size_t k = 0; k < low.size(); ++k) {
                const std::size_t at = k % stride + k / stride * stride * n;
                this->border_load_[at] -= low[k];
                this->border_load_[at + (n - 1) * stride] += high[k];
            }
        }
    }

    std::array<SplineFunction, D> map(std::span<const double> phi) const override {
        const SplineFunction potential{{std::vector<KnotVector>(D, this->line_.upper)},
                                       {phi.begin(), phi.end()}};
        std::array<SplineFunction, D> psi;
        for (std::size_t d = 0; d < D; ++d) psi[d] = derivative(potential, d);
        return psi;
    }
    // The potential |xi|^2 / 2.
    std::vector<double> identity() const override {
        const std::size_t n = this->size();
        const auto square = square_coefficients(this->line_.upper);
        std::vector<double> phi(this->unknowns());
        for (std::size_t i = 0; i < phi.size(); ++i) {
            double sum = 0;
            for (std::size_t rest = i, d = 0; d < D; ++d, rest /= n) sum += square[rest % n];
            phi[i] = sum / 2;
        }
        const double average = this->mean(phi);
        for (double& value : phi) value -= average;
        return phi;
    }
    const KnotVector& space() const override { return this->line_.upper; }
    const LineTable& tests() const override { return this->quadrature_.upper; }

  private:
    std::array<std::span<const double>, D> components(std::span<const double> phi, Border,
                                                      Workspace&) const override {
        return {phi};
    }
};

} // namespace

template <std::size_t D>
std::unique_ptr<TensorForm<D>> make_standard_form(const SplineLine& line, const FaceTrace<D>& trace) {
    GASPARD_CHECK(line.upper.degree >= 2);
    return std::make_unique<StandardForm<D>>(line, LineMatrices(line), trace);
}

template std::unique_ptr<SplineForm> make_standard_form(const SplineLine&, const FaceTrace<2>&);
template std::unique_ptr<SolidForm> make_standard_form(const SplineLine&, const FaceTrace<3>&);

} // namespace gaspard

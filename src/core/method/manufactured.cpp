#include "core/method/manufactured.hpp"

#include "core/base/check.hpp"
#include "core/base/error.hpp"
#include "core/base/stopwatch.hpp"
#include "core/spline/tensor_space.hpp"

#include <cmath>

namespace gaspard {

namespace {

constexpr std::size_t coarsest = 8;
constexpr double tolerance = 1e-10, coarse_tolerance = 1e-4;
constexpr int most = 200, least_between = 2; ///< max. iterations; min. iterations on intermediate meshes

/// |xi|^2 at a quadrature point; x runs fastest.
template <std::size_t D>
double square(const std::vector<double>& points, std::size_t at) {
    double sum = 0;
    for (std::size_t d = 0; d < D; ++d, at /= points.size())
        sum += points[at % points.size()] * points[at % points.size()];
    return sum;
}

template <std::size_t D>
FaceTrace<D> exact_trace(const SplineLine& line) {
    FaceTrace<D> trace = identity_trace<D>(line);
    constexpr double d = D;
    for (std::vector<double>& high : trace.high)
        for (std::size_t q = 0; q < high.size(); ++q)
            high[q] = 2 / d * std::exp((1 + square<D - 1>(line.points, q)) / d);
    return trace;
}

template <std::size_t D>
class Source final : public JacobianSource {
  public:
    explicit Source(const SplineLine& line)
        : points_(line.points), slab_(tensor_size<D - 1>(line.points.size())) {
        for (const double x : points_) exponentials_.push_back(std::exp(x * x));
    }
    /// Rows of points along the first direction at a time; exp(|xi|^2) is a product.
    void values(std::size_t y, const Points& psi, std::span<double> f) const override {
        const double d = D, scale = D == 2 ? 1 : 8.0 / 27;
        const std::size_t n = points_.size();
        for (std::size_t i = 0; i < psi.size(); i += n) {
            const std::size_t row = y * slab_ + i;
            const double r = square<D>(points_, row) - points_[0] * points_[0];
            double product = scale;
            for (std::size_t k = 1, at = row / n; k < D; ++k, at /= n) product *= exponentials_[at % n];
            for (std::size_t k = 0; k < n; ++k)
                f[i + k] = (1 + 2 / d * (r + points_[k] * points_[k])) * product * exponentials_[k];
        }
    }
    void gradients(std::size_t y, const Points& psi, std::span<double> f, Points& gradient) const override {
        values(y, psi, f);
        gradient = Points(psi.size()); // f does not depend on Psi
    }

  private:
    std::vector<double> points_, exponentials_; ///< xi and exp(xi^2) along a line
    std::size_t slab_;
};

template <std::size_t D>
double error(const TensorForm<D>& form, std::span<const double> phi) {
    const SplineLine& line = form.line();
    const std::size_t n = line.points.size(), slab = form.slab();
    auto workspace = form.make_workspace();
    std::array<std::vector<double>, D> psi;
    typename TensorForm<D>::Fields out{};
    for (std::size_t d = 0; d < D; ++d) {
        psi[d].resize(slab);
        out[d] = psi[d].data();
    }
    form.expand(phi, TensorForm<D>::Border::given, form.quadrature(), D, workspace);
    double sum = 0;
    for (std::size_t j = 0; j < n; ++j) {
        form.row(form.quadrature(), j, D, out, workspace);
        for (std::size_t i = 0; i < slab; ++i) {
            const std::size_t at = j * slab + i;
            const double slope = 2.0 / D * std::exp(square<D>(line.points, at) / D);
            double weight = 1, distance = 0;
            for (std::size_t d = 0, rest = at; d < D; ++d, rest /= n) {
                const double away = psi[d][i] - slope * line.points[rest % n];
                weight *= line.weights[rest % n];
                distance += away * away;
            }
            sum += weight * distance;
        }
    }
    return std::sqrt(sum);
}

/// Iterates phi until the increment is below `enough`, at least `least` times. Returns the number of
/// iterations.
template <std::size_t D>
int iterate(BfoIteration<D>& bfo, std::vector<double>& phi, double enough, int least,
            const std::stop_token& stop) {
    const Source<D> source(bfo.form().line());
    std::vector<double> next(bfo.form().unknowns()), increment(next.size());
    int iterations = 0;
    for (double residual = 1; iterations < most && (residual >= enough || iterations < least);) {
        if (stop.stop_requested()) throw Interrupted();
        bfo.iterate(source, phi, next);
        phi.resize(next.size()); // the start Psi = 0 is the empty phi; here it becomes phi = 0
        for (std::size_t i = 0; i < next.size(); ++i) increment[i] = next[i] - phi[i];
        residual = bfo.form().norm_without_mean(increment);
        phi.swap(next);
        ++iterations;
    }
    return iterations;
}

template <std::size_t D>
ManufacturedResult solve(const ManufacturedChoice& choice) {
    std::vector<std::size_t> levels = {choice.cells};
    if (choice.multilevel) {
        while (levels.front() > coarsest && levels.front() % 2 == 0)
            levels.insert(levels.begin(), levels.front() / 2);
        if (levels.size() == 1) levels.push_back(choice.cells); // first to the coarse tolerance
    }
    std::vector<double> phi;
    KnotVector before;
    ManufacturedResult result;
    for (std::size_t l = 0; l < levels.size(); ++l) {
        const SplineLine line(uniform_knots(choice.degree, levels[l]));
        const std::shared_ptr<const TensorForm<D>> form = choice.formulation == Formulation::standard
                                                              ? make_standard_form(line, exact_trace<D>(line))
                                                              : make_mixed_form(line, exact_trace<D>(line));
        if (l > 0)
            phi = insert_knots({std::vector<KnotVector>(D, before)}, phi,
                               {std::vector<KnotVector>(D, form->space())});
        before = form->space();
        BfoIteration<D> bfo(form, choice.penalty, choice.threads);
        const bool last = l + 1 == levels.size();
        const Stopwatch watch;
        result.iterations = iterate(bfo, phi, last ? tolerance : coarse_tolerance,
                                    l > 0 && !last ? least_between : 0, choice.stop);
        result.seconds = watch.seconds();
        result.cpu_seconds = watch.cpu_seconds();
        if (last) result.error = error(*form, phi);
    }
    return result;
}

} // namespace

ManufacturedResult solve_manufactured(const ManufacturedChoice& choice) {
    GASPARD_CHECK(choice.dimension == 2 || choice.dimension == 3);
    return choice.dimension == 2 ? solve<2>(choice) : solve<3>(choice);
}

} // namespace gaspard

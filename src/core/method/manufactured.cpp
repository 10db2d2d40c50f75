#include "core/method/manufactured.hpp"

#include "core/spline/tensor_space.hpp"

#include <cmath>

namespace gaspard {

namespace {

constexpr std::size_t coarsest = 8;
constexpr double tolerance = 1e-10, coarse_tolerance = 1e-4;
constexpr int most = 200, least_between = 2; ///< max. iterations; min. iterations on intermediate meshes

NormalTrace trace(const SplineLine& line) {
    NormalTrace trace = identity_trace(line);
    for (std::size_t q = 0; q < line.points.size(); ++q) {
        const double t = line.points[q];
        trace.right[q] = trace.top[q] = std::exp((1 + t * t) / 2);
    }
    return trace;
}

class Source final : public JacobianSource {
  public:
    explicit Source(const SplineLine& line) : points_(line.points) {}
    void values(std::size_t y, const Points& psi, std::span<double> f) const override {
        const std::size_t n = points_.size();
        for (std::size_t i = 0; i < psi.size(); ++i) {
            const double a = points_[i % n], b = points_[y + i / n], square = a * a + b * b;
            f[i] = (1 + square) * std::exp(square);
        }
    }
    void gradients(std::size_t y, const Points& psi, std::span<double> f, Points& gradient) const override {
        values(y, psi, f);
        gradient = Points(psi.size()); // f does not depend on Psi
    }

  private:
    std::vector<double> points_;
};

double error(const SplineForm& form, std::span<const double> phi) {
    const SplineLine& line = form.line();
    const std::size_t n = line.points.size();
    auto workspace = form.make_workspace();
    std::vector<double> first(n), second(n);
    form.expand(phi, SplineForm::Border::given, form.quadrature(), 2, workspace);
    double sum = 0;
    for (std::size_t j = 0; j < n; ++j) {
        form.row(form.quadrature(), j, 2, {first.data(), second.data(), nullptr, nullptr, nullptr},
                 workspace);
        for (std::size_t i = 0; i < n; ++i) {
            const double x = line.points[i], y = line.points[j], e = std::exp((x * x + y * y) / 2);
            const double dx = first[i] - x * e, dy = second[i] - y * e;
            sum += line.weights[i] * line.weights[j] * (dx * dx + dy * dy);
        }
    }
    return std::sqrt(sum);
}

/// Iterates phi until the increment is below `enough`, at least `least` times. Returns the number of
/// iterations.
int iterate(Bfo& bfo, std::vector<double>& phi, double enough, int least) {
    const Source source(bfo.form().line());
    std::vector<double> next(bfo.form().unknowns()), increment(next.size());
    int iterations = 0;
    for (double residual = 1; iterations < most && (residual >= enough || iterations < least);) {
        bfo.iterate(source, phi, next);
        phi.resize(next.size()); // the start Psi = 0 is the empty phi; here it becomes phi = 0
        for (std::size_t i = 0; i < next.size(); ++i) increment[i] = next[i] - phi[i];
        residual = bfo.form().norm_without_mean(increment);
        phi.swap(next);
        ++iterations;
    }
    return iterations;
}

} // namespace

ManufacturedResult solve_manufactured(const ManufacturedChoice& choice) {
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
        const std::shared_ptr<const SplineForm> form = choice.formulation == Formulation::standard
                                                           ? make_standard_form(line, trace(line))
                                                           : make_mixed_form(line, trace(line));
        if (l > 0) phi = insert_knots({{before, before}}, phi, {{form->space(), form->space()}});
        before = form->space();
        Bfo bfo(form, choice.penalty);
        const bool last = l + 1 == levels.size();
        result.iterations =
            iterate(bfo, phi, last ? tolerance : coarse_tolerance, l > 0 && !last ? least_between : 0);
        if (last) result.error = error(*form, phi);
    }
    return result;
}

} // namespace gaspard

// The spline forms and the iteration in three dimensions, against definitions.
#include "core/base/symmetric.hpp"
#include "core/method/bfo.hpp"
#include "core/method/manufactured.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace gaspard {
namespace {

std::vector<double> random_values(std::size_t n, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(-1, 1);
    std::vector<double> all(n);
    for (double& one : all) one = number(random);
    return all;
}

struct SolidCase {
    bool mixed;
    KnotVector space;
};
void PrintTo(const SolidCase& c, std::ostream* out) {
    *out << (c.mixed ? "mixed" : "standard") << " of degree " << c.space.degree;
}

class SolidForms : public testing::TestWithParam<SolidCase> {
  protected:
    using Fields = std::array<std::vector<double>, SolidForm::fields>;

    std::unique_ptr<SolidForm> make(const FaceTrace<3>& trace) const {
        return GetParam().mixed ? make_mixed_form(line, trace) : make_standard_form(line, trace);
    }
    /// Another one on every face, with the flux of the identity.
    FaceTrace<3> some_trace() const {
        FaceTrace<3> trace = identity_trace<3>(line);
        for (std::size_t q = 0; q < n * n; ++q) {
            const double s = line.points[q % n], t = line.points[q / n];
            trace.low[0][q] = s * t * t;
            trace.high[0][q] = 1 + s * t * t;
            trace.low[1][q] = std::sin(s) - t;
            trace.high[1][q] = 1 + std::sin(s) - t;
            trace.low[2][q] = t * s * s;
            trace.high[2][q] = 1 + t * s * s;
        }
        return trace;
    }
    Vec3 point(std::size_t i) const {
        return {line.points[i % n], line.points[i / n % n], line.points[i / n / n]};
    }
    double weight(std::size_t i) const {
        return line.weights[i % n] * line.weights[i / n % n] * line.weights[i / n / n];
    }
    double integral(std::span<const double> values) const {
        double sum = 0;
        for (std::size_t i = 0; i < values.size(); ++i) sum += weight(i) * values[i];
        return sum;
    }
    /// All fields at the quadrature points.
    Fields fields(const SolidForm& form, std::span<const double> phi, SolidForm::Border border) const {
        auto workspace = form.make_workspace();
        Fields all;
        for (auto& field : all) field.resize(n * n * n);
        form.expand(phi, border, form.quadrature(), SolidForm::fields, workspace);
        for (std::size_t z = 0; z < n; ++z) {
            SolidForm::Fields out;
            for (std::size_t f = 0; f < out.size(); ++f) out[f] = &all[f][z * n * n];
            form.row(form.quadrature(), z, SolidForm::fields, out, workspace);
        }
        return all;
    }
    std::vector<double> load(const SolidForm& form, std::span<const double> g) const {
        auto workspace = form.make_workspace();
        std::vector<double> b(form.unknowns());
        form.begin_load(workspace);
        for (std::size_t z = 0; z < n; ++z) form.load_row(n - 1 - z, &g[(n - 1 - z) * n * n], workspace);
        form.end_load(b, workspace);
        return b;
    }

    const SplineLine line{GetParam().space};
    const std::size_t n = line.points.size();
};
const std::vector<double> unequal = {0, 0.3, 1};
INSTANTIATE_TEST_SUITE_P(Kinds, SolidForms,
                         testing::Values(SolidCase{false, uniform_knots(2, 3)},
                                         SolidCase{true, uniform_knots(2, 3)},
                                         SolidCase{false, open_knots(4, unequal, 2)},
                                         SolidCase{true, open_knots(4, unequal, 2)}));

TEST_P(SolidForms, IdentityPotentialGivesTheIdentityMap) {
    const auto form = make(identity_trace<3>(line));
    const Fields at = fields(*form, form->identity(), SolidForm::Border::given);
    const Symmetric<3> unit = {1, 0, 0, 1, 0, 1};
    for (std::size_t i = 0; i < n * n * n; ++i) {
        EXPECT_NEAR(at[0][i], point(i).x, 1e-13);
        EXPECT_NEAR(at[1][i], point(i).y, 1e-13);
        EXPECT_NEAR(at[2][i], point(i).z, 1e-13);
        for (std::size_t e = 0; e < unit.size(); ++e) EXPECT_NEAR(at[3 + e][i], unit[e], 1e-11);
    }
    EXPECT_NEAR(form->border_flux(), 3, 1e-13);
    EXPECT_NEAR(form->mean(form->identity()), 0, 1e-14);
}

TEST_P(SolidForms, SolveTheirPoissonProblem) {
    const auto form = make(some_trace());
    std::vector<double> g = random_values(n * n * n, 1);
    const double total = integral(g);
    for (double& value : g) value += form->border_flux() - total;
    std::vector<double> b = load(*form, g), phi(b), again(b);
    for (std::size_t i = 0; i < b.size(); ++i) b[i] = form->border_load()[i] - b[i];
    auto workspace = form->make_workspace();
    form->poisson().solve(b, phi, 0, workspace.poisson);
    EXPECT_NEAR(form->mean(phi), 0, 1e-13);
    form->poisson().multiply(phi, again, workspace.poisson);
    for (std::size_t i = 0; i < b.size(); ++i) EXPECT_NEAR(again[i], b[i], 1e-12);
    const Fields at = fields(*form, phi, SolidForm::Border::given);
    std::vector<double> products(n * n * n);
    if (GetParam().mixed) { // div Psi = g for all functions of the L2 space
        for (std::size_t i = 0; i < products.size(); ++i) products[i] = at[3][i] + at[6][i] + at[8][i] - g[i];
        for (const double value : load(*form, products)) EXPECT_NEAR(value, 0, 1e-12);
        return;
    }
    // <grad phi, grad v> + <g, v> = <trace, v> for v = x^2 z, which degree 2 has.
    const FaceTrace<3> trace = some_trace();
    double border = 0;
    for (std::size_t q = 0; q < n * n; ++q) {
        const double s = line.points[q % n], t = line.points[q / n];
        const double w = line.weights[q % n] * line.weights[q / n];
        border += w * (trace.high[0][q] * t);                           // x = 1; (y, z) = (s, t)
        border += w * s * s * t * (trace.high[1][q] - trace.low[1][q]); // (x, z) = (s, t)
        border += w * trace.high[2][q] * s * s;                         // z = 1
    }
    for (std::size_t i = 0; i < products.size(); ++i) {
        const Vec3 p = point(i);
        products[i] = 2 * p.x * p.z * at[0][i] + p.x * p.x * at[2][i] + g[i] * p.x * p.x * p.z;
    }
    EXPECT_NEAR(integral(products), border, 1e-12);
}

TEST_P(SolidForms, FieldsAreConsistentDerivatives) {
    const auto form = make(some_trace());
    const auto phi = random_values(form->unknowns(), 2);
    const Fields at = fields(*form, phi, SolidForm::Border::zero);
    const TensorSpace space{std::vector<KnotVector>(3, form->space())};
    if (!GetParam().mixed) {
        const std::array<std::array<int, 3>, 9> orders = {{{1, 0, 0},
                                                           {0, 1, 0},
                                                           {0, 0, 1},
                                                           {2, 0, 0},
                                                           {1, 1, 0},
                                                           {1, 0, 1},
                                                           {0, 2, 0},
                                                           {0, 1, 1},
                                                           {0, 0, 2}}};
        for (std::size_t i = 0; i < n * n * n; i += 7)
            for (std::size_t f = 0; f < orders.size(); ++f)
                EXPECT_NEAR(at[f][i], evaluate(space, phi, point(i), orders[f]), 1e-10) << f;
        return;
    }
    // <Psi, v> = -<phi, div v> for all v with zero flux through the boundary.
    const Fields other = fields(*form, random_values(form->unknowns(), 3), SolidForm::Border::zero);
    std::vector<double> products(n * n * n), divergence(products);
    for (std::size_t i = 0; i < products.size(); ++i) {
        for (std::size_t d = 0; d < 3; ++d) products[i] += at[d][i] * other[d][i];
        divergence[i] = evaluate(space, phi, point(i)) * (other[3][i] + other[6][i] + other[8][i]);
    }
    EXPECT_NEAR(integral(products), -integral(divergence), 1e-10 * std::abs(integral(products)));
    // The fields are those of the map as splines.
    const auto map = form->map(phi);
    const Fields whole = fields(*form, phi, SolidForm::Border::given);
    const std::array<std::pair<std::size_t, std::array<int, 3>>, 9> expected = {{{0, {0, 0, 0}},
                                                                                 {1, {0, 0, 0}},
                                                                                 {2, {0, 0, 0}},
                                                                                 {0, {1, 0, 0}},
                                                                                 {0, {0, 1, 0}},
                                                                                 {0, {0, 0, 1}},
                                                                                 {1, {0, 1, 0}},
                                                                                 {1, {0, 0, 1}},
                                                                                 {2, {0, 0, 1}}}};
    for (std::size_t i = 0; i < n * n * n; i += 5)
        for (std::size_t f = 0; f < expected.size(); ++f) {
            const auto& [component, orders] = expected[f];
            EXPECT_NEAR(whole[f][i],
                        evaluate(map[component].space, map[component].coefficients, point(i), orders), 1e-10)
                << f;
        }
}

TEST_P(SolidForms, TheMixedFormKeepsTheBoundary) {
    if (!GetParam().mixed) return; // the standard form imposes it weakly
    const auto form = make(identity_trace<3>(line));
    const auto map = form->map(random_values(form->unknowns(), 4));
    for (const double s : {0.0, 0.2, 1.0})
        for (const double t : {0.0, 0.6, 1.0})
            for (const double end : {0.0, 1.0}) {
                const auto at = [&](std::size_t d, Vec3 p) {
                    return evaluate(map[d].space, map[d].coefficients, p);
                };
                EXPECT_NEAR(at(0, {end, s, t}), end, 1e-14);
                EXPECT_NEAR(at(1, {s, end, t}), end, 1e-14);
                EXPECT_NEAR(at(2, {s, t, end}), end, 1e-14);
            }
}

TEST_P(SolidForms, MeasureNormsWithoutTheMean) {
    const auto form = make(identity_trace<3>(line));
    const auto phi = random_values(form->unknowns(), 5);
    const TensorSpace space{std::vector<KnotVector>(3, form->space())};
    std::vector<double> values(n * n * n);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = evaluate(space, phi, point(i));
    const double mean = integral(values);
    for (double& value : values) value = (value - mean) * (value - mean);
    EXPECT_NEAR(form->mean(phi), mean, 1e-13);
    EXPECT_NEAR(form->norm_without_mean(phi), std::sqrt(integral(values)), 1e-13);
}

/// f that depends on Psi, in all directions.
class MovingSource final : public JacobianSource {
  public:
    void values(std::size_t, const Points& psi, std::span<double> f) const override {
        for (std::size_t i = 0; i < psi.size(); ++i) f[i] = value(psi[i]);
    }
    void gradients(std::size_t y, const Points& psi, std::span<double> f, Points& gradient) const override {
        values(y, psi, f);
        gradient.resize(psi.size());
        for (std::size_t i = 0; i < psi.size(); ++i) {
            const Vec3 p = psi[i];
            gradient.set(i, {std::cos(p.x + 2 * p.y) / 5, 2 * std::cos(p.x + 2 * p.y) / 5, p.z / 5});
        }
    }
    static double value(Vec3 p) { return 1 + std::sin(p.x + 2 * p.y) / 5 + p.z * p.z / 10; }
};

TEST_P(SolidForms, IterationHasItsDerivative) {
    const std::shared_ptr<const SolidForm> form = make(identity_trace<3>(line));
    BfoIteration<3> bfo(form);
    const MovingSource source;
    std::vector<double> phi = form->identity();
    const auto w = random_values(phi.size(), 6);
    for (std::size_t i = 0; i < phi.size(); ++i) phi[i] += 1e-3 * w[(i * 7 + 3) % w.size()];
    const auto residual = [&](double step) {
        std::vector<double> moved = phi, next(phi), r(phi);
        for (std::size_t i = 0; i < phi.size(); ++i) moved[i] += step * w[i];
        bfo.iterate(source, moved, next);
        bfo.residual(moved, next, r);
        return r;
    };
    constexpr double h = 1e-5;
    const auto above = residual(h), below = residual(-h);
    std::vector<double> slope(phi.size());
    bfo.linearise(source, phi, true);
    bfo.derivative(w, slope);
    double size = 0;
    for (const double value : slope) size = std::max(size, std::abs(value));
    for (std::size_t i = 0; i < slope.size(); ++i)
        EXPECT_NEAR(slope[i], -(above[i] - below[i]) / (2 * h), 2e-5 * size);
}

TEST_P(SolidForms, ThreadsChangeNoBit) {
    const SplineLine longer(uniform_knots(3, 9));
    const auto trace = identity_trace<3>(longer);
    const std::shared_ptr<const SolidForm> form =
        GetParam().mixed ? make_mixed_form(longer, trace) : make_standard_form(longer, trace);
    const std::vector<double> phi = form->identity();
    std::vector<double> first(phi), other(phi);
    BfoIteration<3>::Shape shape, other_shape;
    BfoIteration<3>(form).iterate(MovingSource(), phi, first, &shape);
    BfoIteration<3>(form, 0, 3).iterate(MovingSource(), phi, other, &other_shape);
    EXPECT_EQ(first, other);
    EXPECT_EQ(shape.convexity, other_shape.convexity);
    EXPECT_EQ(shape.slowest, other_shape.slowest);
    EXPECT_EQ(shape.fastest, other_shape.fastest);
    EXPECT_NEAR(shape.convexity, 1, 1e-10);
}

// The numbers of tables 2 and 8 in all digits that are printed; penalty as the published numbers imply.
TEST(SolidTables, HaveTheNumbersOfThePaper) {
    ManufacturedChoice choice{
        .formulation = Formulation::standard, .cells = 8, .penalty = 1e-8, .dimension = 3};
    const auto expect = [&](double error, int iterations) {
        const ManufacturedResult result = solve_manufactured(choice);
        EXPECT_NEAR(result.error / error, 1, 2.6e-4); // half a unit of the last digit
        EXPECT_EQ(result.iterations, iterations);
    };
    expect(5.885e-5, 14);
    choice.multilevel = true;
    expect(5.885e-5, 10);
    choice.cells = 16;
    expect(7.672e-6, 10);
    choice = {.formulation = Formulation::mixed, .cells = 8, .dimension = 3};
    expect(1.966e-5, 14);
    choice.degree = 4;
    expect(6.622e-7, 14);
}

TEST(SymmetricMatrices, HaveTheirDeterminantAndEigenvalues) {
    std::mt19937 random(9);
    std::normal_distribution<double> number;
    for (int k = 0; k < 200; ++k) {
        Symmetric<3> h;
        for (double& entry : h) entry = number(random);
        if (k == 0) h = {2, 0, 0, 2, 0, 2};
        if (k == 1) h = {1, 0, 0, 3, 0, 3};
        const auto values = eigenvalues(h);
        EXPECT_LE(values[0], values[1]);
        EXPECT_LE(values[1], values[2]);
        EXPECT_NEAR(values[0] * values[1] * values[2], determinant(h), 1e-12 * (1 + std::abs(values[2])));
        for (const double lambda : values) { // det(H - lambda) = 0
            Symmetric<3> shifted = h;
            for (const std::size_t d : diagonal<3>) shifted[d] -= lambda;
            EXPECT_NEAR(determinant(shifted), 0,
                        1e-12 * (1 + std::pow(std::abs(values[2]) + std::abs(values[0]), 3)));
        }
        const Symmetric<3> c = cofactors(h);
        for (std::size_t e = 0; e < h.size(); ++e) { // off the diagonal both entries change
            const double step = 1e-6;
            Symmetric<3> above = h, below = h;
            above[e] += step, below[e] -= step;
            const bool on_diagonal = e == 0 || e == 3 || e == 5;
            EXPECT_NEAR((determinant(above) - determinant(below)) / (2 * step), (on_diagonal ? 1 : 2) * c[e],
                        1e-7);
        }
    }
}

} // namespace
} // namespace gaspard

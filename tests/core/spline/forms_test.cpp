#include "core/spline/spline_forms.hpp"
#include "core/spline/tensor_space.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace gaspard {
namespace {

std::vector<double> random_numbers(std::size_t n, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(-1, 1);
    std::vector<double> all(n);
    for (double& one : all) one = number(random);
    return all;
}

/// A trace other than the identity's, with the same flux.
NormalTrace some_trace(const SplineLine& line) {
    NormalTrace trace = identity_trace(line);
    for (std::size_t q = 0; q < line.points.size(); ++q) {
        const double t = line.points[q];
        trace.low[0][q] = t * t;
        trace.high[0][q] = 1 + t * t;
        trace.high[1][q] = std::cos(t);
    }
    return trace;
}

struct Case {
    bool mixed;
    KnotVector space;
};
void PrintTo(const Case& c, std::ostream* out) {
    *out << (c.mixed ? "mixed" : "standard") << " of degree " << c.space.degree;
}

class Forms : public testing::TestWithParam<Case> {
  protected:
    std::unique_ptr<SplineForm> make(const NormalTrace& trace) const {
        return GetParam().mixed ? make_mixed_form(line, trace) : make_standard_form(line, trace);
    }
    /// All fields at the quadrature points.
    std::array<std::vector<double>, map_fields> fields(const SplineForm& form, std::span<const double> phi,
                                                       SplineForm::Border border) const {
        const std::size_t n = line.points.size();
        auto workspace = form.make_workspace();
        std::array<std::vector<double>, map_fields> all;
        for (auto& field : all) field.resize(n * n);
        form.expand(phi, border, form.quadrature(), map_fields, workspace);
        for (std::size_t y = 0; y < n; ++y)
            form.row(form.quadrature(), y, map_fields,
                     {&all[0][y * n], &all[1][y * n], &all[2][y * n], &all[3][y * n], &all[4][y * n]},
                     workspace);
        return all;
    }
    double integral(std::span<const double> values) const {
        const std::size_t n = line.points.size();
        double sum = 0;
        for (std::size_t i = 0; i < n * n; ++i) sum += line.weights[i % n] * line.weights[i / n] * values[i];
        return sum;
    }
    const SplineLine line{GetParam().space};
};
const std::vector<double> breaks = {0, 0.2, 0.3, 0.7, 1};
INSTANTIATE_TEST_SUITE_P(Kinds, Forms,
                         testing::Values(Case{false, uniform_knots(2, 5)}, Case{true, uniform_knots(2, 5)},
                                         Case{false, uniform_knots(3, 6)}, Case{true, uniform_knots(3, 6)},
                                         Case{false, open_knots(4, breaks, 1)},
                                         Case{true, open_knots(4, breaks, 1)},
                                         Case{false, uniform_knots(7, 3)}, Case{true, uniform_knots(7, 3)}));

TEST_P(Forms, IdentityPotentialGivesTheIdentityMap) {
    const auto form = make(identity_trace(line));
    const auto at = fields(*form, form->identity(), SplineForm::Border::given);
    const std::size_t n = line.points.size();
    for (std::size_t i = 0; i < n * n; ++i) {
        EXPECT_NEAR(at[0][i], line.points[i % n], 1e-13);
        EXPECT_NEAR(at[1][i], line.points[i / n], 1e-13);
        EXPECT_NEAR(at[2][i], 1, 2e-11);
        EXPECT_NEAR(at[3][i], 0, 2e-11);
        EXPECT_NEAR(at[4][i], 1, 2e-11);
    }
    EXPECT_NEAR(form->border_flux(), 2, 1e-14);
    EXPECT_NEAR(form->mean(form->identity()), 0, 1e-14);
}

TEST_P(Forms, SolveTheirPoissonProblem) {
    // <grad phi, grad v> (or <div Psi, w>) equals the right-hand side for all test functions.
    const auto form = make(some_trace(line));
    const std::size_t n = line.points.size();
    std::vector<double> g = random_numbers(n * n, 1);
    const double total = integral(g);
    for (double& value : g) value += form->border_flux() - total; // compatibility condition
    auto workspace = form->make_workspace();
    std::vector<double> b(form->unknowns()), phi(b), again(b);
    form->begin_load(workspace);
    for (std::size_t y = 0; y < n; ++y) form->load_row(y, &g[y * n], workspace);
    form->end_load(b, workspace);
    for (std::size_t i = 0; i < b.size(); ++i) b[i] = form->border_load()[i] - b[i];
    form->poisson().solve(b, phi, 0, workspace.poisson);
    EXPECT_NEAR(form->mean(phi), 0, 1e-13);
    form->poisson().multiply(phi, again, workspace.poisson);
    for (std::size_t i = 0; i < b.size(); ++i) EXPECT_NEAR(again[i], b[i], 1e-12);
    // Mixed form: the map has divergence g, tested with all functions of the L2 space.
    if (GetParam().mixed) {
        const auto at = fields(*form, phi, SplineForm::Border::given);
        form->begin_load(workspace);
        std::vector<double> rest(n * n);
        for (std::size_t i = 0; i < rest.size(); ++i) rest[i] = at[2][i] + at[4][i] - g[i];
        for (std::size_t y = 0; y < n; ++y) form->load_row(y, &rest[y * n], workspace);
        form->end_load(again, workspace);
        for (const double value : again) EXPECT_NEAR(value, 0, 1e-12);
    }
}

TEST_P(Forms, FieldsAreConsistentDerivatives) {
    const auto form = make(some_trace(line));
    const auto phi = random_numbers(form->unknowns(), 2);
    const auto at = fields(*form, phi, SplineForm::Border::zero);
    const std::size_t n = line.points.size();
    const std::size_t near = n / 2;
    if (!GetParam().mixed) { // compare with the general evaluation
        const TensorSpace space{{form->space(), form->space()}};
        for (std::size_t i = 0; i < n * n; i += 7) {
            const Vec3 p{line.points[i % n], line.points[i / n], 0};
            EXPECT_NEAR(at[0][i], evaluate(space, phi, p, {1, 0, 0}), 1e-11);
            EXPECT_NEAR(at[1][i], evaluate(space, phi, p, {0, 1, 0}), 1e-11);
            EXPECT_NEAR(at[2][i], evaluate(space, phi, p, {2, 0, 0}), 1e-9);
            EXPECT_NEAR(at[3][i], evaluate(space, phi, p, {1, 1, 0}), 1e-9);
            EXPECT_NEAR(at[4][i], evaluate(space, phi, p, {0, 2, 0}), 1e-9);
        }
        return;
    }
    // <Psi, v> = -<phi, div v> for all v with zero flux through the boundary.
    double products = 0, divergence = 0;
    const TensorSpace space{{form->space(), form->space()}};
    const auto other = fields(*form, random_numbers(form->unknowns(), 3), SplineForm::Border::zero);
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t k = j * n + i;
            const double weight = line.weights[i] * line.weights[j];
            products += weight * (at[0][k] * other[0][k] + at[1][k] * other[1][k]);
            divergence += weight * evaluate(space, phi, {line.points[i], line.points[j], 0}) *
                          (other[2][k] + other[4][k]);
        }
    EXPECT_NEAR(products, -divergence, 1e-10 * std::abs(products));
    EXPECT_GT(std::abs(at[0][near * n + near]), 0);
}

TEST_P(Forms, KeepTheBoundary) {
    const auto form = make(identity_trace(line));
    if (!GetParam().mixed) return; // the standard form imposes it weakly
    const SplineGrid grid(line, {0, 0.1, 0.5, 0.77, 1});
    auto workspace = form->make_workspace();
    std::array<double, 5> first{}, second{};
    form->expand(random_numbers(form->unknowns(), 4), SplineForm::Border::given, grid, 2, workspace);
    for (std::size_t y = 0; y < 5; ++y) {
        form->row(grid, y, 2, {first.data(), second.data(), nullptr, nullptr, nullptr}, workspace);
        EXPECT_NEAR(first[0], 0, 1e-15);
        EXPECT_NEAR(first[4], 1, 1e-15);
        for (const double value : second) {
            if (y == 0) {
                EXPECT_NEAR(value, 0, 1e-15);
            }
            if (y == 4) {
                EXPECT_NEAR(value, 1, 1e-15);
            }
        }
    }
}

TEST_P(Forms, MeasureNormsWithoutTheMean) {
    const auto form = make(identity_trace(line));
    const auto phi = random_numbers(form->unknowns(), 5);
    const TensorSpace space{{form->space(), form->space()}};
    const std::size_t n = line.points.size();
    std::vector<double> values(n * n), squares(n * n);
    for (std::size_t i = 0; i < n * n; ++i)
        values[i] = evaluate(space, phi, {line.points[i % n], line.points[i / n], 0});
    const double mean = integral(values);
    for (std::size_t i = 0; i < n * n; ++i) squares[i] = (values[i] - mean) * (values[i] - mean);
    EXPECT_NEAR(form->mean(phi), mean, 1e-13);
    EXPECT_NEAR(form->norm_without_mean(phi), std::sqrt(integral(squares)), 1e-13);
}

// ---- tensor products in three directions, and the de Rham sequences

TEST(TensorSpaces, StayTheSameInThreeDirectionsWhenKnotsAreInserted) {
    const TensorSpace coarse{{uniform_knots(2, 2), uniform_knots(3, 1), uniform_knots(1, 3)}};
    const TensorSpace fine{{uniform_knots(2, 4), uniform_knots(3, 3), uniform_knots(1, 6)}};
    const auto coefficients = random_numbers(coarse.size(), 6);
    const auto inserted = insert_knots(coarse, coefficients, fine);
    ASSERT_EQ(inserted.size(), fine.size());
    const auto at = random_numbers(60, 7);
    for (std::size_t i = 0; i + 2 < at.size(); i += 3) {
        const Vec3 p{std::abs(at[i]), std::abs(at[i + 1]), std::abs(at[i + 2])};
        EXPECT_NEAR(evaluate(fine, inserted, p), evaluate(coarse, coefficients, p), 1e-13);
        EXPECT_NEAR(evaluate(fine, inserted, p, {1, 1, 0}), evaluate(coarse, coefficients, p, {1, 1, 0}),
                    1e-11);
    }
}

TEST(DeRham, HasTheDegreesOfThePaper) {
    const auto degrees = [](const TensorSpace& space) {
        std::vector<int> all;
        for (const auto& one : space.directions) all.push_back(one.degree);
        return all;
    };
    using List = std::vector<int>;
    const DeRham flat = de_rham({{uniform_knots(3, 4), uniform_knots(4, 5)}});
    EXPECT_EQ(degrees(flat.divergence[0]), (List{3, 3})); // (2.13)
    EXPECT_EQ(degrees(flat.divergence[1]), (List{2, 4}));
    EXPECT_EQ(degrees(flat.square), (List{2, 3}));
    EXPECT_TRUE(flat.curl.empty());
    const DeRham solid = de_rham({{uniform_knots(3, 2), uniform_knots(3, 2), uniform_knots(3, 2)}});
    EXPECT_EQ(degrees(solid.divergence[1]), (List{2, 3, 2})); // (2.14)
    EXPECT_EQ(degrees(solid.curl[1]), (List{3, 2, 3}));       // (2.15)
    EXPECT_EQ(degrees(solid.square), (List{2, 2, 2}));
}

} // namespace
} // namespace gaspard

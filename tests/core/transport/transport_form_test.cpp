// The discrete equation: its linearisation, masses, the scale of the boundary condition, and convexity.
#include "core/base/error.hpp"
#include "core/linear/gmres.hpp"
#include "core/transport/recovery_preconditioner.hpp"
#include "core/transport/transport_form.hpp"
#include "support/messages.hpp"
#include "support/transport_spaces.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

class WavyDensity final : public Monitor {
  public:
    void values(const Points& x, std::span<double> values) const override {
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = 2 + std::sin(x.x[i]) * std::cos(2 * x.y[i]);
    }
    void gradients(const Points& x, Points& gradients) const override {
        gradients.resize(x.size());
        for (std::size_t i = 0; i < x.size(); ++i)
            gradients.set(i, {std::cos(x.x[i]) * std::cos(2 * x.y[i]),
                              -2 * std::sin(x.x[i]) * std::sin(2 * x.y[i]), 0});
    }
};

class LevelDensity final : public Monitor {
  public:
    explicit LevelDensity(double value) : value_(value) {}
    void values(const Points&, std::span<double> values) const override {
        std::fill(values.begin(), values.end(), value_);
    }

  private:
    double value_;
};

TransportForm disk_to_ellipse(int rings, int degree, Recovery recovery) {
    const auto disk = ellipse({}, 1, 1);
    return {std::make_shared<const NonvariationalSpace>(elements_on(disk, rings, degree, true), recovery),
            disk, ellipse({}, 3, 2, 90)};
}

TEST(TransportForm, DerivativeIsThatOfTheResidual) {
    for (const Recovery recovery : {Recovery::none, Recovery::gradient})
        for (int degree = 1; degree <= 2; ++degree) {
            TransportForm form = disk_to_ellipse(4, degree, recovery);
            const TransportDensities densities{std::make_shared<WavyDensity>(),
                                               std::make_shared<WavyDensity>()};
            std::vector<double> u = form.start(), w(u.size()), out(u.size());
            for (double& value : u) value *= 0.8; // images stay within the target
            for (std::size_t i = 0; i < w.size(); ++i) w[i] = std::sin(1.0 + 3 * static_cast<double>(i));
            form.evaluate(densities, u);
            form.linearise();
            form.derivative(w, out);
            constexpr double h = 1e-6;
            const auto shifted = [&](double step) {
                std::vector<double> at = u;
                for (std::size_t i = 0; i < at.size(); ++i) at[i] += step * w[i];
                form.evaluate(densities, at);
                return std::vector<double>(form.residual().begin(), form.residual().end());
            };
            const std::vector<double> after = shifted(h), before = shifted(-h);
            double largest = 0;
            for (const double value : out) largest = std::max(largest, std::abs(value));
            for (std::size_t i = 0; i < out.size(); ++i)
                EXPECT_NEAR(out[i], (before[i] - after[i]) / (2 * h), 1e-6 * largest) << i;
        }
}

TEST(TransportForm, StartIsTheQuadraticPolynomialWithTheMomentsOfTheTarget) {
    TransportForm form = disk_to_ellipse(16, 2, Recovery::gradient);
    form.evaluate({}, form.start());
    const auto d = form.derivatives();
    for (std::size_t i = 0; i < form.space().size(); ++i) {
        const Vec3 x = form.space().elements().nodes()[i];
        EXPECT_NEAR(d[derivative_count * i + g1], 2 * x.x, 2e-3);
        EXPECT_NEAR(d[derivative_count * i + g2], 3 * x.y, 2e-3);
    }
    EXPECT_NEAR(form.boundary_scale(), 6, 2e-2) << "grad b = -(cof H) n";
    EXPECT_NEAR(form.scale_of_iterate(), form.boundary_scale(), 1e-12);
    EXPECT_NEAR(form.theta(), 6, 1e-12) << "the areas' ratio";
    EXPECT_LT(form.normalised_residual(), 1e-2);
    EXPECT_NEAR(form.convexity(), 2, 5e-2);
    EXPECT_LT(form.boundary_defect(), 2e-3);
}

TEST(TransportForm, MassesOfTheDensitiesAreMadeEqual) {
    TransportForm form = disk_to_ellipse(4, 1, Recovery::gradient);
    const auto u = form.start();
    form.evaluate({std::make_shared<LevelDensity>(3), std::make_shared<LevelDensity>(5)}, u);
    EXPECT_NEAR(form.theta(), 6 * 5.0 / 3, 1e-10);
    const std::vector<double> levels(form.residual().begin(), form.residual().end());
    form.evaluate({}, u);
    for (std::size_t i = 0; i < levels.size(); ++i)
        EXPECT_NEAR(levels[i], form.residual()[i], 1e-13) << "constants do not matter";
    const auto within = std::make_shared<WavyDensity>();
    form.evaluate({nullptr, within}, u);
    // The integral of 2 + sin(x) cos(2 y) over an ellipse around the origin.
    EXPECT_NEAR(form.theta(), 12, 1e-6) << "sin is odd";
}

TEST(TransportForm, DensitiesThatAreNotPositiveAreRefused) {
    TransportForm form = disk_to_ellipse(4, 1, Recovery::gradient);
    const auto u = form.start();
    EXPECT_NE(message_of<InputError>([&] {
                  form.evaluate({std::make_shared<LevelDensity>(0), nullptr}, u);
              }).find("the density on the source must be positive"),
              std::string::npos);
    EXPECT_NE(message_of<InputError>([&] {
                  form.evaluate({nullptr, std::make_shared<LevelDensity>(std::nan(""))}, u);
              }).find("the density on the target must be positive"),
              std::string::npos);
}

TEST(TransportForm, RefusedDensityLeavesNothingBehind) {
    TransportForm form = disk_to_ellipse(4, 1, Recovery::gradient);
    const auto u = form.start();
    const TransportDensities good{std::make_shared<WavyDensity>(), nullptr};
    form.evaluate(good, u);
    const std::vector<double> before(form.residual().begin(), form.residual().end());
    EXPECT_THROW(form.evaluate({std::make_shared<LevelDensity>(7), std::make_shared<LevelDensity>(0)}, u),
                 InputError);
    form.evaluate(good, u);
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(form.residual()[i], before[i]) << i;
}

TEST(TransportForm, ConvexityIsNegativeWhereTheFunctionBends) {
    TransportForm form = disk_to_ellipse(6, 2, Recovery::gradient);
    std::vector<double> u(form.size(), 0.0);
    const Points& x = form.space().elements().nodes();
    for (std::size_t i = 0; i + 1 < u.size(); ++i) u[i] = x.x[i] * x.x[i] - 0.5 * x.y[i] * x.y[i];
    form.evaluate({}, u);
    EXPECT_NEAR(form.convexity(), -1, 0.1);
}

TEST(TransportForm, PreconditionerIsSymmetricAndClose) {
    for (const Recovery recovery : {Recovery::none, Recovery::gradient}) {
        TransportForm form = disk_to_ellipse(6, 2, recovery);
        form.evaluate({}, form.start());
        RecoveryPreconditioner preconditioner(form.shared_space());
        preconditioner.factorise(form.derivatives(), {});
        const std::size_t n = form.size();
        std::vector<double> a(n), b(n), of_a(n), of_b(n);
        for (std::size_t i = 0; i < n; ++i) a[i] = std::sin(double(i)), b[i] = std::cos(2 * double(i));
        preconditioner.solve(a, of_a);
        preconditioner.solve(b, of_b);
        EXPECT_NEAR(dot(of_a, b) / dot(of_b, a), 1, 1e-9);
        EXPECT_GT(dot(of_a, a), 0);
    }
}

TEST(TransportForm, AbsurdHessiansCanBeFactorised) {
    TransportForm form = disk_to_ellipse(4, 1, Recovery::gradient);
    RecoveryPreconditioner preconditioner(form.shared_space());
    std::vector<double> h(derivative_count * form.space().size());
    for (std::size_t i = 0; i < h.size(); ++i) h[i] = std::sin(double(i) * double(i)) * 1e3; // indefinite
    preconditioner.factorise(h, {});
    std::fill(h.begin(), h.end(), 0.0);
    preconditioner.factorise(h, {});
    std::vector<double> r(form.size(), 1.0), w(r.size());
    preconditioner.solve(r, w);
    for (const double value : w) EXPECT_TRUE(std::isfinite(value));
}

} // namespace
} // namespace gaspard

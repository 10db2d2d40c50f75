// Interpolation errors: exact ones of simple functions, known orders, independent quadratures, the factor
// that theory gives for a layer, and what is said of meshes that fold.
#include "core/base/error.hpp"
#include "core/diagnostics/interpolation_error.hpp"
#include "core/fem/gauss.hpp"
#include "core/mesh/sphere_mesh.hpp"
#include "support/function_of.hpp"
#include "support/layer.hpp"
#include "support/messages.hpp"
#include "support/polynomials.hpp"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

namespace gaspard {
namespace {

constexpr ErrorNorm l2 = ErrorNorm::l2, maximum = ErrorNorm::maximum, h1 = ErrorNorm::h1;
const Space unit_sphere{SpaceKind::sphere};

const FunctionOf square_of_x([](Vec3 p) { return p.x * p.x; }, [](Vec3 p) { return Vec3{2 * p.x, 0, 0}; });
const FunctionOf smooth([](Vec3 p) { return std::sin(5 * p.x) * std::cos(3 * p.y) + p.x * p.y * p.y; },
                        [](Vec3 p) {
                            return Vec3{5 * std::cos(5 * p.x) * std::cos(3 * p.y) + p.y * p.y,
                                        -3 * std::sin(5 * p.x) * std::sin(3 * p.y) + 2 * p.x * p.y, 0};
                        });
/// A spherical harmonic of degree 3, xyz, with its tangential gradient on the unit sphere.
const FunctionOf harmonic([](Vec3 p) { return p.x * p.y * p.z; },
                          [](Vec3 p) {
                              const Vec3 g{p.y * p.z, p.x * p.z, p.x * p.y};
                              return g - dot(g, p) * p;
                          });

/// Triangles: each square of the mesh divided along its diagonal.
Mesh triangles(int n) {
    Mesh mesh = unit_square_mesh(n);
    std::vector<std::int32_t> cells;
    for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
        const auto q = mesh.cell(c);
        cells.insert(cells.end(), {q[0], q[1], q[2], q[0], q[2], q[3]});
    }
    mesh.kind = {CellShape::triangle, 1};
    mesh.cells = std::move(cells);
    return mesh;
}

TEST(InterpolationError, OfASquareIsExact) {
    for (const int n : {1, 4, 37}) {
        const Mesh mesh = unit_square_mesh(n);
        const double h = 1.0 / n;
        const InterpolationError error = interpolation_error(mesh, mesh.nodes, {}, square_of_x);
        EXPECT_NEAR(error.of(l2), h * h / std::sqrt(30.0), 1e-12 * h);
        EXPECT_NEAR(error.of(maximum), h * h / 4, 1e-12 * h);
        EXPECT_NEAR(error.of(h1), h / std::sqrt(3.0), 1e-12);
        EXPECT_NEAR(error.measure, 1, 1e-13);
        EXPECT_EQ(error.tangled_cells + error.unresolved_cells, 0u);
        ASSERT_EQ(error.of_cells(l2).size(), mesh.cell_count());
        for (std::size_t c = 0; c < mesh.cell_count(); ++c) // all cells have the same part
            EXPECT_NEAR(error.of_cells(l2)[c], h * error.of(l2), 1e-12 * h);
    }
    // On these triangles Iu depends on x alone, too.
    const Mesh mesh = triangles(6);
    const InterpolationError error = interpolation_error(mesh, mesh.nodes, {}, square_of_x);
    EXPECT_NEAR(error.of(maximum), 1.0 / 36 / 4, 1e-12);
    EXPECT_NEAR(error.of(l2), 1.0 / 36 / std::sqrt(30.0), 1e-12);
    EXPECT_NEAR(error.of(h1), 1.0 / 6 / std::sqrt(3.0), 1e-12);
}

TEST(InterpolationError, OnALineAndInASolid) {
    Mesh line{.kind = {CellShape::line, 1}, .space_dimension = 1, .nodes = Points(6), .cells = {}};
    for (std::int32_t i = 0; i < 6; ++i) {
        line.nodes.set(static_cast<std::size_t>(i), {0.2 * i, 0, 0});
        if (i > 0) line.cells.insert(line.cells.end(), {i - 1, i});
    }
    const InterpolationError on_line = interpolation_error(line, line.nodes, {}, square_of_x);
    EXPECT_NEAR(on_line.of(l2), 0.04 / std::sqrt(30.0), 1e-14);
    EXPECT_NEAR(on_line.of(h1), 0.2 / std::sqrt(3.0), 1e-13);
    Mesh cube{.kind = {CellShape::hexahedron, 1}, .space_dimension = 3, .nodes = Points(8), .cells = {}};
    for (std::int32_t i = 0; i < 8; ++i) {
        cube.nodes.set(static_cast<std::size_t>(i), reference_nodes(cube.kind)[static_cast<std::size_t>(i)]);
        cube.cells.push_back(i);
    }
    const InterpolationError in_cube = interpolation_error(cube, cube.nodes, {}, square_of_x);
    EXPECT_NEAR(in_cube.of(l2), 1 / std::sqrt(30.0), 1e-13);
    EXPECT_NEAR(in_cube.of(maximum), 0.25, 1e-13);
    EXPECT_NEAR(in_cube.of(h1), 1 / std::sqrt(3.0), 1e-13);
}

TEST(InterpolationError, OfALinearFunctionIsZero) {
    const FunctionOf linear([](Vec3 p) { return 1e3 + 2 * p.x - p.y; }, [](Vec3) { return Vec3{2, -1, 0}; });
    Mesh mesh = unit_square_mesh(9);
    const auto shift = slow::random_values(2 * mesh.node_count(), -0.02, 0.02, 3);
    Points x = mesh.nodes;
    for (std::size_t i = 0; i < x.size(); ++i) x.set(i, x[i] + Vec3{shift[2 * i], shift[2 * i + 1], 0});
    const InterpolationComparison errors = compare_interpolation(mesh, x, {}, linear);
    EXPECT_TRUE(errors.exact());
    for (const ErrorNorm norm : error_norms) {
        EXPECT_EQ(errors.adapted->of(norm), 0);
        EXPECT_EQ(errors.ratio(norm), 1);
    }
}

/// On rectangles, with 10 Gauss points per direction and the formula of bilinear interpolation in x and y.
std::array<double, 2> slow_errors(int n, const ScalarFunction& u) {
    const LineQuadrature rule = gauss_legendre(10);
    const double h = 1.0 / n;
    double square = 0, slope = 0;
    const auto value = [&](double x, double y) {
        Points p(1);
        p.set(0, {x, y, 0});
        double found = 0;
        u.values(p, {&found, 1});
        return found;
    };
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const double x0 = i * h, y0 = j * h, a = value(x0, y0), b = value(x0 + h, y0),
                         c = value(x0 + h, y0 + h), d = value(x0, y0 + h);
            for (std::size_t k = 0; k < 100; ++k) {
                const double s = rule.points[k % 10], t = rule.points[k / 10];
                const double weight = h * h * rule.weights[k % 10] * rule.weights[k / 10];
                Points p(1), g;
                p.set(0, {x0 + s * h, y0 + t * h, 0});
                u.gradients(p, g);
                const double e =
                    value(p.x[0], p.y[0]) - ((1 - t) * ((1 - s) * a + s * b) + t * ((1 - s) * d + s * c));
                const double ex = g.x[0] - ((1 - t) * (b - a) + t * (c - d)) / h,
                             ey = g.y[0] - ((1 - s) * (d - a) + s * (c - b)) / h;
                square += weight * e * e, slope += weight * (ex * ex + ey * ey);
            }
        }
    return {std::sqrt(square), std::sqrt(slope)};
}

TEST(InterpolationError, AgreesWithAnIndependentQuadrature) {
    for (const int n : {5, 12}) {
        const Mesh mesh = unit_square_mesh(n);
        const auto [square, slope] = slow_errors(n, smooth);
        const InterpolationError usual = interpolation_error(mesh, mesh.nodes, {}, smooth);
        EXPECT_NEAR(usual.of(l2), square, 1e-5 * square);
        EXPECT_NEAR(usual.of(h1), slope, 1e-5 * slope);
        const InterpolationError fine =
            interpolation_error(mesh, mesh.nodes, {}, smooth, {.tolerance = 1e-11});
        EXPECT_NEAR(fine.of(l2), square, 1e-10 * square);
        EXPECT_NEAR(fine.of(h1), slope, 1e-10 * slope);
    }
}

TEST(InterpolationError, HasTheKnownOrders) {
    struct Case {
        const char* name;
        std::function<Mesh(int)> mesh;
        Space space;
        const ScalarFunction& u;
    };
    const Case cases[] = {{"squares", unit_square_mesh, {}, smooth},
                          {"triangles", triangles, {}, smooth},
                          {"cubed sphere",
                           [](int n) {
                               return sphere_mesh({SphereCells::cubed, n}).quadratic;
                           },
                           unit_sphere, harmonic},
                          {"straight cubed sphere",
                           [](int n) {
                               return straightened(sphere_mesh({SphereCells::cubed, n}));
                           },
                           unit_sphere, harmonic},
                          {"icosahedral",
                           [](int n) {
                               return sphere_mesh({SphereCells::icosahedral, n == 10 ? 2 : 3}).quadratic;
                           },
                           unit_sphere, harmonic}};
    for (const Case& one : cases) {
        SCOPED_TRACE(one.name);
        const Mesh coarse = one.mesh(10), fine = one.mesh(20);
        const InterpolationError before = interpolation_error(coarse, coarse.nodes, one.space, one.u),
                                 after = interpolation_error(fine, fine.nodes, one.space, one.u);
        EXPECT_NEAR(std::log2(before.of(l2) / after.of(l2)), 2, 0.06);
        EXPECT_NEAR(std::log2(before.of(maximum) / after.of(maximum)), 2, 0.15);
        EXPECT_NEAR(std::log2(before.of(h1) / after.of(h1)), 1, 0.04);
        const double measure = one.space.kind == SpaceKind::sphere ? 4 * std::numbers::pi : 1;
        EXPECT_NEAR(after.measure, measure, 1e-6 * measure); // projected cells cover the sphere
    }
}

/// By planar subdivision of each flat triangle: Iu by barycentric coordinates of the direction, its gradient
/// by differences along the sphere, areas as solid angles (van Oosterom and Strackee).
std::array<double, 2> slow_errors_on_sphere(const Mesh& mesh, int parts) {
    const auto value = [](Vec3 p) { return p.x * p.y * p.z; };
    double square = 0, slope = 0;
    for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
        const auto cell = mesh.cell(c);
        std::array<Vec3, 3> v;
        for (std::size_t i = 0; i < 3; ++i) v[i] = mesh.nodes[static_cast<std::size_t>(cell[i])];
        const auto unit = [](Vec3 p) { return (1 / norm(p)) * p; };
        const auto error = [&](Vec3 p) {
            const double a = dot(p, cross(v[1], v[2])), b = dot(p, cross(v[2], v[0])),
                         d = dot(p, cross(v[0], v[1]));
            return value(p) - (a * value(v[0]) + b * value(v[1]) + d * value(v[2])) / (a + b + d);
        };
        const auto at = [&](double s, double t) { return v[0] + s * (v[1] - v[0]) + t * (v[2] - v[0]); };
        const auto add = [&](double s, double t, double h) { // the triangle (s, t), (s + h, t), (s, t + h)
            const Vec3 a = unit(at(s, t)), b = unit(at(s + h, t)), d = unit(at(s, t + h));
            const double area =
                2 * std::atan2(std::abs(dot(a, cross(b, d))), 1 + dot(a, b) + dot(b, d) + dot(d, a));
            const Vec3 middle = unit(at(s + h / 3, t + h / 3)), one = any_across(middle),
                       other = cross(middle, one);
            const double step = 1e-5;
            const auto along = [&](Vec3 way) {
                return (error(unit(middle + step * way)) - error(unit(middle - step * way))) / (2 * step);
            };
            const double e = error(middle), g1 = along(one), g2 = along(other);
            square += area * e * e, slope += area * (g1 * g1 + g2 * g2);
        };
        const double h = 1.0 / parts;
        for (int i = 0; i < parts; ++i)
            for (int j = 0; i + j < parts; ++j) {
                add(i * h, j * h, h);
                if (i + j + 1 < parts) add((i + 1) * h, (j + 1) * h, -h);
            }
    }
    return {std::sqrt(square), std::sqrt(slope)};
}

TEST(InterpolationError, OnTheSphereAgreesWithAnIndependentQuadrature) {
    const Mesh mesh = sphere_mesh({SphereCells::icosahedral, 1}).quadratic;
    const auto [square, slope] = slow_errors_on_sphere(mesh, 40);
    const InterpolationError error = interpolation_error(mesh, mesh.nodes, unit_sphere, harmonic);
    EXPECT_NEAR(error.of(l2), square, 2e-3 * square); // of the slow one: order 2, (1/40)^2
    EXPECT_NEAR(error.of(h1), slope, 2e-3 * slope);
    EXPECT_LT(error.uncertainty[0], 1e-2);
    EXPECT_LT(error.uncertainty[2], 1e-2);
}

/// x of a mesh in one direction with cells of length proportional to 1 / density.
Points stretched(const Mesh& mesh, const std::function<double(double)>& density) {
    constexpr int count = 100000;
    std::vector<double> mass(count + 1, 0.0);
    for (std::size_t i = 0; i < count; ++i)
        mass[i + 1] = mass[i] + density((static_cast<double>(i) + 0.5) / count);
    Points x = mesh.nodes;
    for (double& at : x.x) {
        const double wanted = at * mass.back();
        const auto above = std::max(mass.begin() + 1, std::lower_bound(mass.begin(), mass.end(), wanted));
        const double part = (wanted - above[-1]) / (above[0] - above[-1]);
        at = (static_cast<double>(above - mass.begin() - 1) + part) / count;
    }
    return x;
}

TEST(InterpolationError, OfALayerFallsByTheFactorOfTheory) {
    constexpr double width = 0.05;
    const double least = 1e-3 * std::pow(bend_square(width, 0.5 + 0.66 * width), 0.2);
    const auto optimal = [=](double x) { return std::pow(bend_square(width, x), 0.2) + least; };
    const Mesh mesh = unit_square_mesh(200);
    const InterpolationComparison errors =
        compare_interpolation(mesh, stretched(mesh, optimal), {}, layer(width));
    const double expected = factor_of(width, optimal);
    EXPECT_GT(expected, 3);
    EXPECT_NEAR(errors.ratio(l2), expected, 0.03 * expected);
    EXPECT_GT(errors.ratio(h1), 1);
}

TEST(InterpolationError, IsHalvedUntilThinFeaturesAreFound) {
    constexpr double width = 0.003; // a tenth of a cell
    const FunctionOf ridge([=](Vec3 p) { return std::exp(-std::pow((p.x + p.y - 1.02) / width, 2)); },
                           [=](Vec3 p) {
                               const double z = (p.x + p.y - 1.02) / width,
                                            g = -2 * z * std::exp(-z * z) / width;
                               return Vec3{g, g, 0};
                           });
    const Mesh mesh = unit_square_mesh(30);
    const InterpolationError error = interpolation_error(mesh, mesh.nodes, {}, ridge);
    const InterpolationError fine = interpolation_error(mesh, mesh.nodes, {}, ridge,
                                                        {.tolerance = 1e-8, .halvings = 10, .parts = 100000});
    EXPECT_NEAR(error.of(l2), fine.of(l2), 1e-3 * fine.of(l2));
    EXPECT_NEAR(error.of(h1), fine.of(h1), 1e-3 * fine.of(h1));
    EXPECT_EQ(error.unresolved_cells, 0u);
    // Halving once is not enough here, and that is said.
    const InterpolationError rough = interpolation_error(mesh, mesh.nodes, {}, ridge, {.halvings = 1});
    EXPECT_GT(rough.unresolved_cells, 10u);
    EXPECT_GT(rough.uncertainty[0], 0.01);
}

TEST(InterpolationError, CountsCellsThatFold) {
    const Mesh mesh = unit_square_mesh(6);
    Points x = mesh.nodes;
    x.set(3 * 7 + 3, {0.5 + 1.2 / 6, 0.5 + 1.2 / 6, 0}); // beyond the opposite corner of one cell
    const InterpolationComparison errors = compare_interpolation(mesh, x, {}, smooth);
    EXPECT_EQ(errors.uniform->tangled_cells, 0u);
    EXPECT_EQ(errors.adapted->tangled_cells, 3u); // that cell, and the two beside it
    EXPECT_TRUE(std::isnan(errors.adapted->of(h1)));
    EXPECT_TRUE(std::isnan(errors.ratio(h1)));
    EXPECT_TRUE(std::isfinite(errors.adapted->of(l2)));
    EXPECT_GT(errors.adapted->of(l2), errors.uniform->of(l2));
    Points reversed = mesh.nodes;
    for (double& one : reversed.x) one = 1 - one;
    EXPECT_EQ(interpolation_error(mesh, reversed, {}, smooth).tangled_cells, 36u);
}

TEST(InterpolationError, DoesNotDependOnTheNumberOfThreads) {
    const Mesh mesh = unit_square_mesh(41);
    const InterpolationError one = interpolation_error(mesh, mesh.nodes, {}, smooth);
    for (const int threads : {2, 3}) {
        const InterpolationError many =
            interpolation_error(mesh, mesh.nodes, {}, smooth, {.threads = threads});
        EXPECT_EQ(many.norm, one.norm);
        EXPECT_EQ(many.cells, one.cells);
    }
}

TEST(InterpolationError, RefusesWhatHasNoValueAndStops) {
    const Mesh mesh = unit_square_mesh(4);
    const FunctionOf pole([](Vec3 p) { return 1 / (p.x - 0.5); }, [](Vec3) { return Vec3{}; });
    EXPECT_NE(message_of<InputError>([&] {
                  interpolation_error(mesh, mesh.nodes, {}, pole);
              }).find("not finite at (0.5"),
              std::string::npos);
    Points nowhere = mesh.nodes;
    nowhere.x[7] = std::numeric_limits<double>::quiet_NaN();
    const InterpolationError error = interpolation_error(mesh, nowhere, {}, smooth);
    EXPECT_TRUE(std::isnan(error.of(l2)));
    EXPECT_EQ(error.tangled_cells, 16u);
    std::stop_source source;
    source.request_stop();
    EXPECT_THROW(interpolation_error(mesh, mesh.nodes, {}, smooth, {.stop = source.get_token()}),
                 Interrupted);
}

TEST(InterpolationError, OnThePeriodicSquareTakesAnyImage) {
    const double turn = 2 * std::numbers::pi;
    const FunctionOf wave([=](Vec3 p) { return std::sin(turn * p.x); },
                          [=](Vec3 p) {
                              return Vec3{turn * std::cos(turn * p.x), 0, 0};
                          });
    const Mesh mesh = unit_square_mesh(16);
    Points x = mesh.nodes;
    for (double& one : x.x) one += 0.9; // another image
    const Space torus{SpaceKind::periodic_square};
    const InterpolationComparison errors = compare_interpolation(mesh, x, torus, wave);
    EXPECT_NEAR(errors.ratio(l2), 1, 1e-3);
    EXPECT_NEAR(errors.ratio(h1), 1, 1e-3);
}

} // namespace
} // namespace gaspard

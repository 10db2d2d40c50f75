#include "core/base/error.hpp"
#include "core/diagnostics/quality.hpp"
#include "core/fem/cell_quadrature.hpp"
#include "core/monitor/radial.hpp"
#include "core/spline/spline_domain.hpp"
#include "support/built_in.hpp"
#include "support/polynomials.hpp"
#include "support/small_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace gaspard {
namespace {

const std::shared_ptr<const Monitor> one = make_monitor("constant", {});

// 1 + x + 2 y + 3 z. Its integral over an affine cell is the measure of the cell times the value at the
// centroid.
class Linear final : public Monitor {
  public:
    static double at(Vec3 x) { return 1 + x.x + 2 * x.y + 3 * x.z; }
    void values(const Points& x, std::span<double> values) const override {
        for (std::size_t i = 0; i < x.size(); ++i) values[i] = at(x[i]);
    }
    void gradients(const Points&, Points&) const override {}
    void check() const override {}
};

MeshQuality quality(const Mesh& mesh, const Points& x, const Monitor& monitor, int threads = 1) {
    return QualityMeter(std::make_shared<const Mesh>(mesh), threads).measure(x, monitor);
}

template <class Map>
Points moved_by(const Mesh& mesh, const Map& map) {
    Points x(mesh.node_count());
    for (std::size_t i = 0; i < x.size(); ++i) x.set(i, map(mesh.nodes[i]));
    return x;
}

Mesh scaled(Mesh mesh, double size) {
    mesh.nodes = moved_by(mesh, [size](Vec3 xi) { return size * xi; });
    return mesh;
}

// Nodes of the unit square moved at random by up to `by`; those on the boundary stay.
Points shaken(const Mesh& mesh, double by, unsigned seed) {
    const auto shift = slow::random_values(2 * mesh.node_count(), -by, by, seed);
    Points x = mesh.nodes;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Vec3 xi = mesh.nodes[i];
        if (xi.x == 0 || xi.x == 1 || xi.y == 0 || xi.y == 1) continue;
        x.set(i, xi + Vec3{shift[2 * i], shift[2 * i + 1], 0});
    }
    return x;
}

const std::vector<Mesh> every_shape = {unit_square_mesh(5), three_lines(), two_triangles(), curved_square(),
                                       two_cubes()};

TEST(Quality, OfAnUnmovedMeshIsPerfectAtAnySize) {
    for (const double size : {1.0, 1e8, 1e-8})
        for (const Mesh& shape : every_shape) {
            const Mesh mesh = scaled(shape, size);
            SCOPED_TRACE(cell_name(mesh.kind) + ", size " + std::to_string(size));
            const MeshQuality q = quality(mesh, mesh.nodes, *one);
            EXPECT_LT(q.equidistribution, 1e-14);
            EXPECT_NEAR(q.min_jacobian, 1, 1e-14);
            EXPECT_NEAR(q.max_jacobian, 1, 1e-14);
            EXPECT_EQ(q.tangled_cells, 0u);
            ASSERT_EQ(q.cell_mass.size(), mesh.cell_count());
            ASSERT_EQ(q.cell_jacobian.size(), mesh.cell_count());
            for (const double mass : q.cell_mass) EXPECT_NEAR(mass, 1, 1e-14);
            for (const double jacobian : q.cell_jacobian) EXPECT_NEAR(jacobian, 1, 1e-14);
        }
}

TEST(Quality, AddsUpToTheIntegralOfTheMonitor) {
    const int n = 16;
    const Mesh mesh = unit_square_mesh(n);
    const auto monitor = make_monitor("ring", {}, {{"sharpness", 20}, {"center_x", 0.4}});
    const MeshQuality q = quality(mesh, shaken(mesh, 0.2 / n, 1), *monitor);
    double sum = 0;
    for (const double mass : q.cell_mass) sum += mass / (n * n);
    const int fine = 1000; // midpoints
    Points row(static_cast<std::size_t>(fine));
    std::vector<double> m(static_cast<std::size_t>(fine));
    double integral = 0;
    for (int j = 0; j < fine; ++j) {
        for (int i = 0; i < fine; ++i)
            row.set(static_cast<std::size_t>(i), {(i + .5) / fine, (j + .5) / fine, 0});
        monitor->values(row, m);
        for (const double value : m) integral += value / fine / fine;
    }
    EXPECT_NEAR(sum, integral, 2e-6 * integral);
}

// The signed area of the corner at b of the path a, b, c.
double corner(Vec3 a, Vec3 b, Vec3 c) { return cross(c - b, a - b).z; }

std::size_t tangled_by_hand(const Mesh& mesh, const Points& x) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < mesh.cell_count(); ++i) {
        const auto cell = mesh.cell(i);
        bool bad = false;
        for (std::size_t k = 0; k < 4; ++k) {
            const auto node = [&](std::size_t l) { return x[static_cast<std::size_t>(cell[l % 4])]; };
            bad = bad || corner(node(k + 3), node(k), node(k + 1)) <= 0;
        }
        count += bad ? 1 : 0;
    }
    return count;
}

TEST(Quality, CountsTheCellsThatAKnownDisplacementTangles) {
    const int n = 8;
    const Mesh mesh = unit_square_mesh(n);
    const std::size_t node = 4 * 9 + 3;
    const auto with_node_moved_by = [&](double dx, double dy) { // in units of h
        Points x = mesh.nodes;
        x.set(node, mesh.nodes[node] + Vec3{dx / n, dy / n, 0});
        const MeshQuality q = quality(mesh, x, *one);
        EXPECT_EQ(q.tangled_cells, tangled_by_hand(mesh, x)) << dx << ", " << dy;
        EXPECT_EQ(q.tangled_cells > 0, q.min_jacobian <= 0);
        EXPECT_EQ(static_cast<std::size_t>(std::count_if(q.cell_jacobian.begin(), q.cell_jacobian.end(),
                                                         [](double jacobian) { return jacobian <= 0; })),
                  q.tangled_cells);
        return q.tangled_cells;
    };
    EXPECT_EQ(with_node_moved_by(0, 0), 0u);
    EXPECT_EQ(with_node_moved_by(0.999, 0), 0u);
    EXPECT_EQ(with_node_moved_by(1, 0), 2u);   // onto its neighbour: Jacobian 0 counts as tangled
    EXPECT_EQ(with_node_moved_by(1.5, 0), 2u); // beyond it
    EXPECT_EQ(with_node_moved_by(1.25, 1.25), 3u);
    EXPECT_EQ(with_node_moved_by(0.51, 0.51), 1u); // at the corner only, where there is no Gauss point
    EXPECT_EQ(with_node_moved_by(0.49, 0.49), 0u);
    EXPECT_EQ(with_node_moved_by(-2.5, 0.5), tangled_by_hand(mesh, [&] {
                  Points x = mesh.nodes;
                  x.set(node, mesh.nodes[node] + Vec3{-2.5 / n, 0.5 / n, 0});
                  return x;
              }()));
}

TEST(Quality, OfAReflectedMeshIsTangledEverywhere) {
    const Mesh mesh = unit_square_mesh(4);
    const MeshQuality q = quality(mesh, moved_by(mesh, [](Vec3 xi) { return Vec3{xi.y, xi.x, 0}; }), *one);
    EXPECT_EQ(q.tangled_cells, 16u);
    EXPECT_NEAR(q.min_jacobian, -1, 1e-14);
    EXPECT_NEAR(q.max_jacobian, -1, 1e-14);
}

TEST(Quality, OfNanPositionsIsTangled) {
    const Mesh mesh = unit_square_mesh(4);
    Points x = mesh.nodes;
    x.x[6] = std::nan(""); // an inner node: four cells
    const MeshQuality q = quality(mesh, x, *one, 2);
    EXPECT_EQ(q.tangled_cells, 4u);
    EXPECT_TRUE(std::isnan(q.min_jacobian));
    EXPECT_TRUE(std::isnan(q.max_jacobian));
    EXPECT_TRUE(std::isnan(q.equidistribution));
}

TEST(Quality, HasTheJacobiansOfACurvedCell) {
    // One biquadratic cell, curved in both meshes.
    Mesh mesh;
    mesh.kind = {CellShape::quadrilateral, 2};
    for (int k = 0; k < 9; ++k) mesh.cells.push_back(k);
    const auto noise = slow::random_values(36, -0.06, 0.06, 3);
    mesh.nodes = Points(9);
    Points x(9);
    const auto lattice = [](std::size_t k) { // VTK's order on the lattice 0, 1, 2
        const int at[9][2] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {2, 1}, {1, 2}, {0, 1}, {1, 1}};
        return std::pair(at[k][0], at[k][1]);
    };
    for (std::size_t k = 0; k < 9; ++k) {
        const auto [i, j] = lattice(k);
        mesh.nodes.set(k, {i / 2.0 + noise[4 * k], j / 2.0 + noise[4 * k + 1], 0});
        x.set(k, {i + noise[4 * k + 2], j / 3.0 + noise[4 * k + 3], 0});
    }
    slow::Polynomial along[3];
    for (int a = 0; a < 3; ++a) along[a] = slow::lagrange(2, a);
    const auto map = [&](const Points& nodes, double s, double t) {
        Vec3 sum;
        for (std::size_t k = 0; k < 9; ++k)
            sum = sum + slow::evaluate(along[lattice(k).first], s) *
                            slow::evaluate(along[lattice(k).second], t) * nodes[k];
        return sum;
    };
    const auto area = [&](const Points& nodes, double s, double t) {
        const double h = 1e-3; // exact up to rounding: the map has degree 2 in s and in t
        const Vec3 ds = map(nodes, s + h, t) - map(nodes, s - h, t);
        const Vec3 dt = map(nodes, s, t + h) - map(nodes, s, t - h);
        return cross(ds, dt).z / (4 * h * h);
    };
    double smallest = std::numeric_limits<double>::infinity(), largest = -smallest, mass = 0, measure = 0;
    const auto look = [&](double s, double t) {
        const double jacobian = area(x, s, t) / area(mesh.nodes, s, t);
        smallest = std::min(smallest, jacobian), largest = std::max(largest, jacobian);
    };
    for (int j = 0; j <= 2; ++j)
        for (int i = 0; i <= 2; ++i) look(i / 2.0, j / 2.0);
    const slow::Rule rule = slow::gauss(6);
    for (std::size_t q = 0; q < 6; ++q)
        for (std::size_t p = 0; p < 6; ++p) {
            const double s = rule.points[p], t = rule.points[q], weight = rule.weights[p] * rule.weights[q];
            look(s, t);
            mass += weight * area(x, s, t) * Linear::at(map(x, s, t));
            measure += weight * area(mesh.nodes, s, t);
        }
    const MeshQuality q = quality(mesh, x, Linear());
    EXPECT_NEAR(q.min_jacobian, smallest, 1e-10);
    EXPECT_NEAR(q.max_jacobian, largest, 1e-10);
    EXPECT_NEAR(q.cell_jacobian[0], smallest, 1e-10);
    EXPECT_NEAR(q.cell_mass[0], mass / measure, 1e-10);
    EXPECT_EQ(q.equidistribution, 0);
}

TEST(Quality, EquidistributionMatchesAFineMidpointRule) {
    const int n = 4, fine = 200;
    const Mesh mesh = unit_square_mesh(n);
    const Points x = shaken(mesh, 0.05, 4);
    const auto monitor = make_monitor("ring", {}, {{"sharpness", 20}, {"center_y", 0.6}});
    std::vector<double> masses;
    Points row(static_cast<std::size_t>(fine));
    std::vector<double> m(static_cast<std::size_t>(fine)), areas(m);
    for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
        Vec3 p[4];
        for (std::size_t k = 0; k < 4; ++k) p[k] = x[static_cast<std::size_t>(mesh.cell(c)[k])];
        double mass = 0;
        for (int j = 0; j < fine; ++j) {
            const double t = (j + .5) / fine;
            for (int i = 0; i < fine; ++i) {
                const double s = (i + .5) / fine;
                const auto at = static_cast<std::size_t>(i);
                row.set(at, (1 - t) * ((1 - s) * p[0] + s * p[1]) + t * ((1 - s) * p[3] + s * p[2]));
                areas[at] = cross((1 - t) * (p[1] - p[0]) + t * (p[2] - p[3]),
                                  (1 - s) * (p[3] - p[0]) + s * (p[2] - p[1]))
                                .z;
            }
            monitor->values(row, m);
            for (std::size_t i = 0; i < m.size(); ++i) mass += areas[i] * m[i] / fine / fine;
        }
        masses.push_back(mass * n * n);
    }
    const MeshQuality q = quality(mesh, x, *monitor);
    double mean = 0, variance = 0;
    for (const double mass : masses) mean += mass / 16;
    for (const double mass : masses) variance += (mass - mean) * (mass - mean) / 16;
    for (std::size_t c = 0; c < masses.size(); ++c) EXPECT_NEAR(q.cell_mass[c], masses[c], 2e-4 * masses[c]);
    EXPECT_NEAR(q.equidistribution, std::sqrt(variance) / mean, 1e-4);
    EXPECT_GT(q.equidistribution, 0.3);
}

TEST(Quality, DoesNotDependOnTheNumberOfThreads) {
    const Mesh mesh = unit_square_mesh(20);
    const Points x = shaken(mesh, 0.8 / 20, 5); // some cells tangle
    const auto monitor = make_monitor("bell", {});
    const MeshQuality first = quality(mesh, x, *monitor, 1);
    EXPECT_GT(first.tangled_cells, 0u);
    EXPECT_LT(first.tangled_cells, 400u);
    for (const int threads : {2, 3, 7, 500}) {
        const MeshQuality q = quality(mesh, x, *monitor, threads);
        EXPECT_EQ(q.equidistribution, first.equidistribution);
        EXPECT_EQ(q.min_jacobian, first.min_jacobian);
        EXPECT_EQ(q.max_jacobian, first.max_jacobian);
        EXPECT_EQ(q.tangled_cells, first.tangled_cells);
        EXPECT_EQ(q.cell_mass, first.cell_mass);
        EXPECT_EQ(q.cell_jacobian, first.cell_jacobian);
    }
}

TEST(Quality, CanBeMeasuredRepeatedly) {
    const Mesh mesh = unit_square_mesh(9);
    QualityMeter meter(std::make_shared<const Mesh>(mesh), 2);
    const Points x = shaken(mesh, 0.08, 6);
    const MeshQuality before = meter.measure(mesh.nodes, Linear());
    const MeshQuality other = meter.measure(x, Linear());
    EXPECT_NE(other.equidistribution, before.equidistribution);
    const MeshQuality& after = meter.measure(mesh.nodes, Linear());
    EXPECT_EQ(after.cell_mass, before.cell_mass);
    EXPECT_EQ(after.max_jacobian, before.max_jacobian);
    EXPECT_EQ(after.tangled_cells, before.tangled_cells);
    EXPECT_EQ(&meter.quality(), &after);
}

// A linear map with determinant `factor` (of the dimensions that the mesh has).
TEST(Quality, OfStraightImagesIsKnownForEveryShape) {
    const auto shear = [](Vec3 xi) {
        return Vec3{2 * xi.x + 0.5 * xi.y + 0.25 * xi.z, 1.5 * xi.y - 0.5 * xi.z, 0.75 * xi.z};
    };
    const double factor[] = {2, 3, 2.25};
    for (const Mesh& mesh : {unit_square_mesh(3), three_lines(), two_triangles(), two_cubes()}) {
        SCOPED_TRACE(cell_name(mesh.kind));
        const Points x = moved_by(mesh, shear);
        const MeshQuality q = quality(mesh, x, Linear());
        const double expected = factor[cell_dimension(mesh.kind) - 1];
        EXPECT_NEAR(q.min_jacobian, expected, 1e-13);
        EXPECT_NEAR(q.max_jacobian, expected, 1e-13);
        for (std::size_t i = 0; i < mesh.cell_count(); ++i) {
            Vec3 centroid;
            for (const auto node : mesh.cell(i))
                centroid = centroid +
                           1.0 / static_cast<double>(mesh.cell(i).size()) * x[static_cast<std::size_t>(node)];
            EXPECT_NEAR(q.cell_mass[i], expected * Linear::at(centroid), 1e-12);
        }
    }
}

TEST(Quality, OfACurvedLineIsExact) {
    // x = xi^2 on [0, 1] with two quadratic cells: degree 2, derivative 2 xi.
    Mesh mesh = mesh_of({CellShape::line, 2}, 1, {{0, 0, 0}, {.25, 0, 0}, {.5, 0, 0}, {.75, 0, 0}, {1, 0, 0}},
                        {0, 2, 1, 2, 4, 3});
    const MeshQuality q = quality(mesh,
                                  moved_by(mesh,
                                           [](Vec3 xi) {
                                               return Vec3{xi.x * xi.x, 0, 0};
                                           }),
                                  Linear());
    EXPECT_NEAR(q.cell_mass[0], 2 * (0.25 + 0.25 * 0.25 / 2), 1e-14); // integral of 1 + x over [0, 1/4]
    EXPECT_NEAR(q.cell_mass[1], 2 * (1.5 - 0.25 - 0.25 * 0.25 / 2), 1e-14);
    EXPECT_EQ(q.min_jacobian, 0); // at xi = 0
    EXPECT_EQ(q.tangled_cells, 1u);
    EXPECT_NEAR(q.max_jacobian, 2, 1e-14);
}

TEST(Quality, OfAFoldedLineIsTangled) {
    const Mesh straight = three_lines(); // 0, 1/4, 2/3, 1
    Mesh tilted = straight;
    tilted.space_dimension = 2;
    tilted.nodes = moved_by(straight, [](Vec3 xi) { return Vec3{0.6 * xi.x, 0.8 * xi.x, 0}; });
    for (const Mesh& mesh : {straight, tilted}) {
        Points x = mesh.nodes;
        x.set(3, 0.125 / 0.25 * mesh.nodes[2]); // from 2/3 to 1/8, past its neighbour
        const MeshQuality q = quality(mesh, x, *one);
        EXPECT_EQ(q.tangled_cells, 1u);
        EXPECT_NEAR(q.min_jacobian, -0.125 / (2.0 / 3 - 0.25), 1e-14);
        EXPECT_NEAR(q.max_jacobian, 0.875 * 3, 1e-14);
        EXPECT_NEAR(q.cell_mass[1], q.min_jacobian, 1e-14); // reversed parts count negatively
    }
}

TEST(Quality, KeepsTheVolumeWhenInnerNodesOfACubeMove) {
    // 2 x 2 x 2 hexahedra; moving the central node changes all eight volumes but not their sum.
    Mesh mesh;
    mesh.kind = {CellShape::hexahedron, 1};
    mesh.space_dimension = 3;
    mesh.nodes = Points(27);
    for (std::size_t k = 0; k < 27; ++k)
        mesh.nodes.set(k, {static_cast<double>(k % 3) / 2, static_cast<double>(k / 3 % 3) / 2,
                           static_cast<double>(k / 9) / 2});
    for (int k = 0; k < 2; ++k)
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 2; ++i) {
                const int c = 9 * k + 3 * j + i;
                mesh.cells.insert(mesh.cells.end(), {c, c + 1, c + 4, c + 3, c + 9, c + 10, c + 13, c + 12});
            }
    Points x = mesh.nodes;
    x.set(13, {0.4, 0.65, 0.55});
    const MeshQuality q = quality(mesh, x, Linear());
    double sum = 0;
    for (const double mass : q.cell_mass) sum += mass / 8;
    EXPECT_NEAR(sum, 1 + 0.5 + 1 + 1.5, 1e-13);
    EXPECT_EQ(q.tangled_cells, 0u);
    EXPECT_LT(q.min_jacobian, 0.8);
    x.set(13, {0.4, 1.2, 0.55}); // out of the cube: four cells are reversed
    EXPECT_EQ(quality(mesh, x, *one).tangled_cells, 4u);
}

TEST(Quality, OfATiltedSquareInSpaceIsThatOfTheFlatOne) {
    const Mesh flat = unit_square_mesh(4);
    const double c = std::cos(1.1), s = std::sin(1.1);
    const auto tilt = [&](Vec3 p) {
        return Vec3{c * p.x - s * p.y, 0.6 * (s * p.x + c * p.y), 0.8 * (s * p.x + c * p.y)};
    };
    Mesh tilted = flat;
    tilted.space_dimension = 3;
    tilted.nodes = moved_by(flat, tilt);
    const MeshQuality still = quality(tilted, tilted.nodes, *one);
    EXPECT_NEAR(still.min_jacobian, 1, 1e-14);
    EXPECT_LT(still.equidistribution, 1e-14);

    Mesh shaken_flat = flat;
    shaken_flat.nodes = shaken(flat, 0.24, 7); // one or two cells tangle
    Points x(flat.node_count());
    for (std::size_t i = 0; i < x.size(); ++i) x.set(i, tilt(shaken_flat.nodes[i]));
    const MeshQuality ours = quality(tilted, x, *one), expected = quality(flat, shaken_flat.nodes, *one);
    EXPECT_GT(expected.tangled_cells, 0u);
    EXPECT_EQ(ours.tangled_cells, expected.tangled_cells);
    EXPECT_NEAR(ours.min_jacobian, expected.min_jacobian, 1e-13);
    EXPECT_NEAR(ours.equidistribution, expected.equidistribution, 1e-13);
    for (std::size_t i = 0; i < 16; ++i) EXPECT_NEAR(ours.cell_mass[i], expected.cell_mass[i], 1e-13);
}

TEST(Quality, OfAReversedFaceInSpaceIsTangled) {
    Mesh mesh = unit_square_mesh(2);
    mesh.space_dimension = 3;
    Points x = mesh.nodes;
    // Fold the right half over the left half, slightly above it: its two cells face down.
    for (const std::size_t node : {2, 5, 8}) x.set(node, {0.1, mesh.nodes.y[node], 0.01});
    const MeshQuality q = quality(mesh, x, *one);
    EXPECT_EQ(q.tangled_cells, 2u);
    EXPECT_NEAR(q.max_jacobian, 1, 1e-14);
    EXPECT_NEAR(q.min_jacobian, -2 * std::hypot(0.4, 0.01), 1e-13);
}

/// From shape functions at every point, one after the other.
MeshQuality slow_quality(const Mesh& mesh, const Points& x, const Monitor& monitor) {
    const auto count = static_cast<std::size_t>(nodes_per_cell(mesh.kind));
    auto samples = cell_quadrature(mesh.kind.shape, std::max(6, mesh.kind.order));
    for (const Vec3 node : reference_nodes(mesh.kind)) samples.push_back({node, 0});
    std::vector<double> values(count), m(1);
    std::vector<Vec3> gradients(count);
    MeshQuality result;
    for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
        double mass = 0, area = 0, smallest = 1e300;
        for (const CellPoint& sample : samples) {
            shape_functions(mesh.kind, sample.point, values, gradients);
            const auto tangents = [&](const Points& of) {
                return cell_tangents(2, gradients, [&](std::size_t k) {
                    return of[static_cast<std::size_t>(mesh.cell(c)[k])];
                });
            };
            const Tangents from = tangents(mesh.nodes);
            const double before = signed_measure(2, mesh.space_dimension, from, from),
                         after = signed_measure(2, mesh.space_dimension, tangents(x), from);
            smallest = std::min(smallest, after / before);
            Points at(1);
            for (std::size_t k = 0; k < count; ++k)
                at.set(0, at[0] + values[k] * x[static_cast<std::size_t>(mesh.cell(c)[k])]);
            monitor.values(at, m);
            mass += sample.weight * after * m[0];
            area += sample.weight * before;
        }
        result.cell_mass.push_back(mass / area);
        result.cell_jacobian.push_back(smallest);
    }
    return result;
}

TEST(Quality, OfCellsOfHighOrderIsThatOfTheirShapeFunctions) {
    for (const int order : {3, 7})
        for (const auto& map : {quarter_annulus_map(), torus_part_map()}) {
            const Mesh mesh = *SplineDomain(order, 3, map).mesh();
            const Points x = moved_by(mesh, [](Vec3 p) {
                return Vec3{p.x + 0.05 * p.y * p.y, p.y - 0.04 * p.x * p.y, p.z + 0.03 * p.x};
            });
            const MeshQuality ours = quality(mesh, x, Linear()), expected = slow_quality(mesh, x, Linear());
            for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
                EXPECT_NEAR(ours.cell_mass[c], expected.cell_mass[c], 1e-11);
                EXPECT_NEAR(ours.cell_jacobian[c], expected.cell_jacobian[c], 1e-11);
            }
        }
}

// At the corners of the disk the patch has no area: what polynomials make of it there is no Jacobian.
TEST(Quality, PointsWhereThePatchIsSingularDoNotCount) {
    const Mesh mesh = *SplineDomain(3, 16, disk_map()).mesh();
    Points x = mesh.nodes;
    x.x.back() -= 1e-5, x.y.back() -= 1e-5; // the node at such a corner
    const MeshQuality q = quality(mesh, x, *one);
    EXPECT_EQ(q.tangled_cells, 0u);
    EXPECT_GT(q.min_jacobian, 0.8);
    EXPECT_LT(q.max_jacobian, 1.5);
}

// A square between two others, collapsed to an edge.
TEST(Quality, CellsWithoutSizeDoNotCount) {
    const CellKind kind{CellShape::quadrilateral, 1};
    for (const int dimension : {2, 3}) {
        const Mesh all =
            mesh_of(kind, dimension, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {3, 0, 0}, {3, 1, 0}},
                    {0, 1, 2, 3, 1, 1, 2, 2, 1, 4, 5, 2});
        Mesh others = all;
        others.cells.erase(others.cells.begin() + 4, others.cells.begin() + 8);
        Points x = all.nodes;
        x.x[1] = 1.25;
        for (const int threads : {1, 3}) {
            const MeshQuality q = quality(all, x, Linear(), threads), wanted = quality(others, x, Linear());
            EXPECT_NEAR(q.equidistribution, wanted.equidistribution, 1e-14);
            EXPECT_EQ(q.min_jacobian, wanted.min_jacobian);
            EXPECT_EQ(q.max_jacobian, wanted.max_jacobian);
            EXPECT_EQ(q.tangled_cells, 0u);
            EXPECT_EQ(q.cell_jacobian[1], 1);
            EXPECT_NEAR(q.cell_mass[1], (q.cell_mass[0] + q.cell_mass[2]) / 2, 1e-14);
        }
        Mesh only = all;
        only.cells = {1, 1, 2, 2};
        const MeshQuality q = quality(only, x, Linear());
        EXPECT_EQ(q.min_jacobian, 1);
        EXPECT_EQ(q.max_jacobian, 1);
        EXPECT_EQ(q.cell_mass, std::vector<double>{0});
        EXPECT_TRUE(std::isnan(q.equidistribution)) << "not measured";
    }
}

TEST(Quality, RejectsInvalidArguments) {
    const auto mesh = std::make_shared<const Mesh>(unit_square_mesh(2));
    EXPECT_THROW(QualityMeter(mesh, 0), InternalError);
    EXPECT_THROW(QualityMeter(mesh, -1), InternalError);
    EXPECT_THROW(QualityMeter(mesh).measure(Points(8), *one), InternalError);
}

} // namespace
} // namespace gaspard

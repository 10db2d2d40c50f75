// Solids that planes cut: areas and volumes against analytic ones, caps that close what is left.
#include "core/tessellate/section.hpp"
#include "core/tessellate/visible_cells.hpp"
#include "fixtures/fixture_meshes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace gaspard {
namespace {

/// A mesh with its faces, and its nodes where they are shown.
struct Solid {
    explicit Solid(Mesh of)
        : mesh(std::make_shared<const Mesh>(std::move(of))),
          faces(std::make_shared<const SolidFaces>(solid_faces(*mesh))), x(mesh->nodes), maker(mesh, faces) {}

    Tessellation cut(const InsideChoice& choice, int pieces = 2) {
        const std::vector<std::vector<double>> values(choice.only.size());
        return maker.make(x, visible_cells(*mesh, *faces, choice, values, x), choice, pieces);
    }
    Tessellation cut(const std::string& text, int pieces = 2) {
        return cut(InsideChoice{.cut = parse_cut(text)}, pieces);
    }

    std::shared_ptr<const Mesh> mesh;
    std::shared_ptr<const SolidFaces> faces;
    Points x;
    SectionMaker maker;
};

/// The unit cube in n^3 cells, whose inner nodes are moved; every cell keeps to one side of its neighbours.
Solid cube(int n) { return Solid(cube_mesh(n)); }

Vec3 half_cross(const Points& p, const Tessellation& t, std::size_t i) {
    const Vec3 a = p[t.triangles[3 * i]], b = p[t.triangles[3 * i + 1]], c = p[t.triangles[3 * i + 2]];
    return 0.5 * cross(b - a, c - a);
}

struct Sums {
    double area = 0, cap_area = 0, volume = 0;
    Vec3 closing; ///< the sum of all normals times areas: 0 for a closed surface
    std::map<std::uint32_t, double> cap_of_cell;
};

Sums sums_of(const Tessellation& t, const Points& x) {
    const Points p = shown_points(t, x);
    Sums sums;
    const std::size_t count = t.triangle_cells.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 normal = half_cross(p, t, i);
        sums.area += norm(normal);
        sums.closing = sums.closing + normal;
        sums.volume += dot(p[t.triangles[3 * i]], normal) / 3;
        if (i < count - t.caps) continue;
        sums.cap_area += norm(normal);
        sums.cap_of_cell[t.triangle_cells[i]] += norm(normal);
    }
    return sums;
}

/// Every edge of a triangle is passed once in either direction: no gaps, nothing twice.
bool is_closed(const Tessellation& t) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    for (std::size_t i = 0; i < t.triangles.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k) ++sides[{t.triangles[i + k], t.triangles[i + (k + 1) % 3]}];
    return std::all_of(sides.begin(), sides.end(), [&](const auto& side) {
        const auto back = sides.find({side.first.second, side.first.first});
        return side.second == 1 && back != sides.end() && back->second == 1;
    });
}

/// Of the unit cube: the volume where n . x <= d, by inclusion and exclusion over its corners; n > 0.
double volume_below(Vec3 n, double d) {
    double sum = 0;
    for (int i = 0; i < 8; ++i) {
        const double at = (i & 1) * n.x + (i >> 1 & 1) * n.y + (i >> 2) * n.z;
        const int ones = (i & 1) + (i >> 1 & 1) + (i >> 2);
        if (d > at) sum += (ones % 2 == 0 ? 1 : -1) * std::pow(d - at, 3);
    }
    return sum / (6 * n.x * n.y * n.z);
}
/// Its derivative: the area of the cut times |n|.
double area_at(Vec3 n, double d) {
    double sum = 0;
    for (int i = 0; i < 8; ++i) {
        const double at = (i & 1) * n.x + (i >> 1 & 1) * n.y + (i >> 2) * n.z;
        const int ones = (i & 1) + (i >> 1 & 1) + (i >> 2);
        if (d > at) sum += (ones % 2 == 0 ? 1 : -1) * std::pow(d - at, 2);
    }
    return norm(n) * sum / (2 * n.x * n.y * n.z);
}

std::string oblique(Vec3 n, double d) {
    const Vec3 at = (d / dot(n, n)) * n;
    return "normal " + std::to_string(n.x) + " " + std::to_string(n.y) + " " + std::to_string(n.z) + " at " +
           std::to_string(at.x) + " " + std::to_string(at.y) + " " + std::to_string(at.z);
}

TEST(Section, AnObliquePlaneCutsTheAnalyticAreaAndVolume) {
    Solid solid = cube(5);
    for (const Vec3 n : {Vec3{1, 1, 1}, Vec3{1, 2, 3}, Vec3{0.5, 0.25, 2}})
        for (const double share : {0.1, 0.35, 0.5, 0.8}) {
            const double d = share * (n.x + n.y + n.z);
            const Tessellation t = solid.cut(oblique(n, d));
            const Sums sums = sums_of(t, solid.x);
            EXPECT_NEAR(sums.cap_area, area_at(n, d), 1e-5) << share;
            EXPECT_NEAR(sums.volume, volume_below(n, d), 1e-5) << share;
            EXPECT_LT(norm(sums.closing), 1e-13);
            EXPECT_TRUE(is_closed(t)) << share;
        }
}

TEST(Section, CapsFaceOutwardAndLieInThePlane) {
    Solid solid = cube(4);
    const auto cut = parse_cut("normal 1 -2 0.5 at 0.4 0.6 0.3");
    const Tessellation t = solid.cut({.cut = cut});
    const Points p = shown_points(t, solid.x);
    ASSERT_GT(t.caps, 16U);
    for (std::size_t i = t.triangle_cells.size() - t.caps; i < t.triangle_cells.size(); ++i) {
        const Vec3 normal = half_cross(p, t, i);
        EXPECT_NEAR(dot(normal, cut[0][0].normal), norm(normal), 1e-15);
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_NEAR(cut[0][0].distance(p[t.triangles[3 * i + k]]), 0, 1e-14);
    }
}

TEST(Section, TheCapsOfAllCellsOnBothSidesAreTheSame) {
    Solid solid = cube(4);
    const auto cut = parse_cut("normal 3 1 2 at 0.5 0.45 0.5");
    const Sums one = sums_of(solid.cut({.cut = cut}), solid.x),
               other = sums_of(solid.cut({.cut = flipped(cut)}), solid.x);
    EXPECT_NEAR(one.volume + other.volume, 1, 1e-13);
    ASSERT_EQ(one.cap_of_cell.size(), other.cap_of_cell.size());
    for (const auto& [cell, area] : one.cap_of_cell) EXPECT_NEAR(area, other.cap_of_cell.at(cell), 1e-13);
}

/// Planes through nodes, edges, diagonals and faces of the cells.
TEST(Section, APlaneThroughNodesNeitherLosesNorDoublesFaces) {
    Mesh straight = cube_mesh(4);
    for (int k = 0; k <= 4; ++k)
        for (int j = 0; j <= 4; ++j)
            for (int i = 0; i <= 4; ++i)
                straight.nodes.set(static_cast<std::size_t>((k * 5 + j) * 5 + i),
                                   0.25 * Vec3{1.0 * i, 1.0 * j, 1.0 * k});
    Solid solid(straight);
    const struct {
        const char* cut;
        double volume, caps;
    } rows[] = {{"x 0.5", 0.5, 1},
                {"-y 0.25", 0.75, 1},
                {"normal 1 1 0 at 0.5 0.5 0", 0.5, std::sqrt(2.0)},
                {"normal 1 1 1 at 0.5 0.5 0.5", 0.5, 0.75 * std::sqrt(3.0)},
                {"normal 1 0 2 at 0.5 0 0.5", 0.5, std::sqrt(1.25)},
                {"x 0.5 and y 0.5", 0.75, 1},
                {"x 0.5 and y 0.5 and z 0.5", 0.875, 0.75},
                {"x 0.5; y 0.5", 0.25, 1},
                {"x 1", 1, 1},
                {"x 1.5", 1, 0}};
    for (const auto& row : rows) {
        const Tessellation t = solid.cut(row.cut);
        const Sums sums = sums_of(t, solid.x);
        EXPECT_NEAR(sums.volume, row.volume, 1e-13) << row.cut;
        EXPECT_NEAR(sums.cap_area, row.caps, 1e-13) << row.cut;
        EXPECT_TRUE(is_closed(t)) << row.cut;
    }
    EXPECT_EQ(solid.cut("x 0").triangles.size(), 0U);
    // The cap belongs to the cells that are left.
    for (const auto& [cell, area] : sums_of(solid.cut("x 0.5"), solid.x).cap_of_cell) {
        EXPECT_EQ(cell % 4, 1U);
        EXPECT_NEAR(area, 1.0 / 16, 1e-14);
    }
}

TEST(Section, WedgesTakeAwayWhatLiesBeyondAllOfTheirPlanes) {
    Solid solid = cube(5);
    const struct {
        const char* cut;
        double volume;
    } rows[] = {{"x 0.43 and y 0.61", 1 - 0.57 * 0.39},
                {"x 0.43; y 0.61", 0.43 * 0.61},
                {"x 0.43 and y 0.61 and z 0.5", 1 - 0.57 * 0.39 * 0.5},
                {"x 0.43 and y 0.61; -x 0.2", 1 - 0.57 * 0.39 - 0.2},
                {"x 0.43 and y 0.61; x 0.43 and z 0.3", 1 - 0.57 * (1 - 0.61 * 0.3)},
                {"x 0.6; x 0.6; -x 0.2", 0.4},
                {"x 0.6; -x 0.6", 0},
                {"x 0.6 and x 0.7", 0.7}};
    for (const auto& row : rows) {
        const Tessellation t = solid.cut(row.cut);
        const Sums sums = sums_of(t, solid.x);
        EXPECT_NEAR(sums.volume, row.volume, 1e-13) << row.cut;
        EXPECT_LT(norm(sums.closing), 1e-13) << row.cut;
    }
}

/// A mesh of order 2 or higher whose edges are curved: the cube in polar coordinates, a piece of a ring.
Solid bent(int n, int order) {
    const Mesh straight = cube_mesh(n);
    Mesh mesh;
    mesh.kind = {CellShape::hexahedron, order};
    mesh.space_dimension = 3;
    mesh.lattice = {n, n, n};
    std::map<std::array<int, 3>, std::int32_t> numbers;
    std::vector<Vec3> nodes;
    for (int c = 0; c < n * n * n; ++c)
        for (const Vec3 local : reference_nodes(mesh.kind)) {
            const std::array<int, 3> at = {
                order * (c % n) + static_cast<int>(std::lround(order * local.x)),
                order * (c / n % n) + static_cast<int>(std::lround(order * local.y)),
                order * (c / n / n) + static_cast<int>(std::lround(order * local.z))};
            const auto [entry, fresh] = numbers.try_emplace(at, static_cast<std::int32_t>(nodes.size()));
            const double m = order * n, angle = 1.2 * at[0] / m, radius = 1 + at[1] / m;
            if (fresh) nodes.push_back({radius * std::sin(angle), radius * std::cos(angle), at[2] / m});
            mesh.cells.push_back(entry->second);
        }
    mesh.nodes = Points(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) mesh.nodes.set(i, nodes[i]);
    return Solid(std::move(mesh));
}

TEST(Section, CurvedCellsCloseAndTheirCapsConverge) {
    // The plane y = 1.3 from the inner to the outer radius, or to the side at the angle 1.2.
    Solid solid = bent(3, 2);
    double before = 1e300;
    for (const int pieces : {1, 2, 4, 8}) {
        const Tessellation t = solid.cut("z 0.4", pieces);
        EXPECT_TRUE(is_closed(t));
        const Sums sums = sums_of(t, solid.x);
        const double error = std::abs(sums.cap_area - 0.5 * 1.2 * 3);
        EXPECT_LT(error, 0.3 * before) << pieces;
        EXPECT_NEAR(sums.volume, 0.4 * sums.cap_area, 0.02 / pieces);
        before = error;
    }
    EXPECT_LT(before, 1e-3);
    for (const char* oblique : {"normal 1 1 1 at 0.6 1.1 0.5", "normal 1 -1 0.2 at 0.6 1.1 0.5 and y 1.2"}) {
        const Tessellation t = solid.cut(oblique, 4);
        EXPECT_LT(norm(sums_of(t, solid.x).closing), 1e-13);
    }
}

TEST(Section, HiddenCellsLeaveTheFacesOfTheOthers) {
    Solid solid = cube(6);
    const Sums peeled = sums_of(solid.cut({.peel = 2}), solid.x);
    double volume = 0;
    InsideChoice one_by_one;
    const Tessellation all = solid.cut({.cut = parse_cut("x 1.5")});
    EXPECT_NEAR(sums_of(all, solid.x).area, 6, 1e-13);
    EXPECT_EQ(all.caps, 0U);
    for (std::uint32_t k = 2; k < 4; ++k)
        for (std::uint32_t j = 2; j < 4; ++j)
            for (std::uint32_t i = 2; i < 4; ++i) {
                one_by_one.layers = {{{i, i}, {j, j}, {k, k}}};
                const Tessellation t = solid.cut(one_by_one);
                EXPECT_EQ(t.triangle_cells, std::vector<std::uint32_t>(12, (k * 6 + j) * 6 + i));
                EXPECT_EQ(t.segments.size(), 24U);
                volume += sums_of(t, solid.x).volume;
            }
    EXPECT_NEAR(peeled.volume, volume, 1e-13);
    EXPECT_EQ(solid.cut({.peel = 3}).triangles.size(), 0U);
    // Peeled and cut.
    const Tessellation both = solid.cut({.cut = parse_cut("normal 1 1 1 at 0.5 0.5 0.5"), .peel = 1});
    EXPECT_TRUE(is_closed(both));
    EXPECT_GT(both.caps, 0U);
}

TEST(Section, WholeCellsHaveNoCaps) {
    Solid solid = cube(4);
    InsideChoice choice{.cut = parse_cut("x 0.55"), .whole_cells = true};
    const Tessellation one = solid.cut(choice);
    choice.cut = flipped(choice.cut);
    const Tessellation other = solid.cut(choice);
    EXPECT_EQ(one.caps + other.caps, 0U);
    EXPECT_TRUE(is_closed(one));
    EXPECT_NEAR(sums_of(one, solid.x).volume + sums_of(other, solid.x).volume, 1, 1e-13);
}

TEST(Section, CellsApartAreShrunkAndCutToo) {
    Solid solid = cube(3);
    const Tessellation t = solid.cut({.explode = 0.5});
    EXPECT_EQ(t.triangle_cells.size(), 27U * 12);
    EXPECT_EQ(t.segments.size(), 2U * 27 * 12);
    EXPECT_NEAR(sums_of(t, solid.x).volume, 0.125, 1e-13);
    EXPECT_TRUE(is_closed(t));
    const Tessellation cut = solid.cut({.cut = parse_cut("normal 1 2 1 at 0.5 0.5 0.5"), .explode = 0.3});
    EXPECT_TRUE(is_closed(cut));
    EXPECT_GT(cut.caps, 0U);
}

TEST(Section, LinesAreDrawnOnceAndOutlineEveryCap) {
    Solid solid = cube(4);
    for (const char* text : {"x 0.5", "normal 1 2 3 at 0.5 0.5 0.5", "x 0.4 and y 0.6"}) {
        const Tessellation t = solid.cut(text);
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> lines;
        for (std::size_t i = 0; i < t.segments.size(); i += 2)
            ++lines[std::minmax(t.segments[i], t.segments[i + 1])];
        for (const auto& [line, count] : lines) EXPECT_EQ(count, 1) << text;
        std::vector<std::uint32_t> cells(t.triangle_cells.end() - static_cast<std::ptrdiff_t>(t.caps),
                                         t.triangle_cells.end());
        std::sort(cells.begin(), cells.end());
        cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
        Tessellation caps = t; // alone
        caps.triangles.erase(caps.triangles.begin(),
                             caps.triangles.end() - static_cast<std::ptrdiff_t>(3 * t.caps));
        caps.triangle_cells.erase(caps.triangle_cells.begin(),
                                  caps.triangle_cells.end() - static_cast<std::ptrdiff_t>(t.caps));
        for (const auto& loop : cell_outlines(caps, cells))
            for (std::size_t k = 0; k < loop.size(); ++k)
                EXPECT_TRUE(lines.contains(std::minmax(loop[k], loop[(k + 1) % loop.size()]))) << text;
    }
}

} // namespace
} // namespace gaspard

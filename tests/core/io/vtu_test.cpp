// VTU read back by tinyxml2, the arrays by a few lines of our own (support/vtu_reader.hpp), to the last bit.
// That VTK, meshio and F3D read the files too is tried by hand (docs/formats.md).
#include "core/base/error.hpp"
#include "core/base/read_file.hpp"
#include "core/io/formats.hpp"
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"
#include "core/session/time_series.hpp"
#include "core/spline/spline_domain.hpp"
#include "fixtures/fixture_meshes.hpp"
#include "support/comma_locale.hpp"
#include "support/middle_nodes.hpp"
#include "support/sample_snapshot.hpp"
#include "support/temporary_folder.hpp"
#include "support/vtu_reader.hpp"

#include <gtest/gtest.h>
#include <limits>

namespace gaspard {
namespace {

class VtuTest : public testing::TestWithParam<std::size_t> {
  protected:
    TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "adapted.vtu";
    Snapshot snapshot_ = sample_snapshot(meshes_of_every_kind()[GetParam()]);
};
INSTANTIATE_TEST_SUITE_P(Kinds, VtuTest, testing::Range<std::size_t>(0, 8),
                         [](const auto& mesh) { return kind_name(meshes_of_every_kind()[mesh.param].kind); });

TEST_P(VtuTest, HoldsPointsAndFieldsToTheLastBit) {
    write_vtu(file_, snapshot_);
    ReadVtu vtu(file_);
    const Mesh& mesh = *snapshot_.mesh;
    EXPECT_EQ(static_cast<std::size_t>(vtu.point_count), mesh.node_count());
    ASSERT_EQ(vtu.points.size(), 1u);
    EXPECT_EQ(vtu.points.begin()->second.points(), snapshot_.x);
    EXPECT_EQ(vtu.point_data.size(), 3u);
    EXPECT_EQ(vtu.point_data["xi"].points(), mesh.nodes);
    EXPECT_EQ(vtu.point_data["displacement"].points(), snapshot_.x - mesh.nodes);
    EXPECT_EQ(vtu.point_data["monitor"].reals(), snapshot_.field("monitor")->values);
    EXPECT_EQ(vtu.point_data["monitor"].components, 1);
    EXPECT_EQ(vtu.cell_data.size(), mesh.kind.shape == CellShape::line ? 2u : 6u);
    EXPECT_EQ(vtu.cell_data["measure"].reals().size(), mesh.cell_count());
    EXPECT_EQ(vtu.cell_data["jacobian"].reals(), snapshot_.field("jacobian")->values);
}

TEST_P(VtuTest, HoldsTheCellsAsTheyAre) {
    // VTK_LINE, VTK_QUADRATIC_EDGE and so on, from vtkCellType.h.
    const std::map<std::string, int> types = {
        {"line1", 3},          {"line2", 21},          {"triangle1", 5},    {"triangle2", 22},
        {"quadrilateral1", 9}, {"quadrilateral2", 28}, {"hexahedron1", 12}, {"hexahedron2", 29}};
    write_vtu(file_, snapshot_);
    ReadVtu vtu(file_);
    const Mesh& mesh = *snapshot_.mesh;
    EXPECT_EQ(static_cast<std::size_t>(vtu.cell_count), mesh.cell_count());
    EXPECT_EQ(vtu.cells["connectivity"].integers(), mesh.cells); // numbered as in VTK (cell_kind_test.cpp)
    const auto ends = vtu.cells["offsets"].integers();
    ASSERT_EQ(ends.size(), mesh.cell_count());
    for (std::size_t c = 0; c < ends.size(); ++c)
        EXPECT_EQ(static_cast<std::size_t>(ends[c]),
                  (c + 1) * static_cast<std::size_t>(nodes_per_cell(mesh.kind)));
    EXPECT_EQ(vtu.cells["types"].type, "UInt8");
    EXPECT_EQ(vtu.cells["types"].bytes,
              std::string(mesh.cell_count(), static_cast<char>(types.at(kind_name(mesh.kind)))));
}

TEST(Vtu, TheSameInputGivesTheSameFilesOfTimeSteps) {
    const TemporaryFolder folder;
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    Scenario scenario = find_scenario(*catalogue, "plane-ring");
    apply_settings(*catalogue, scenario,
                   {"domain.cells=8", "method.type=newton", "time.end=0.1", "time.step=0.05",
                    "time.monitor.center_x=center_x + t/4"});
    const auto bytes = [&](const char* name) {
        gaspard::Run run(catalogue, scenario);
        while (run.status() == RunStatus::running) run.step();
        EXPECT_TRUE(run.history().back().value(time_names::monitor)) << "histories have it";
        write_vtu(folder / name, *run.snapshot());
        return read_file(folder / name);
    };
    const std::string first = bytes("first.vtu");
    EXPECT_EQ(first, bytes("second.vtu"));
    ReadVtu vtu(folder / "first.vtu");
    EXPECT_TRUE(vtu.field_data.contains("time"));
    EXPECT_TRUE(vtu.field_data.contains(time_names::iterations));
    EXPECT_FALSE(vtu.field_data.contains(time_names::monitor));
}

TEST(Vtu, CellsOfASphereHaveAllTheirMiddleNodes) {
    const TemporaryFolder folder;
    for (const Mesh& mesh : {cubed_sphere_mesh(3), round_octahedron()}) {
        Snapshot snapshot = sample_snapshot(mesh);
        snapshot.x = mesh.nodes;
        write_vtu(folder / "m.vtu", snapshot);
        ReadVtu vtu(folder / "m.vtu");
        const Points x = vtu.points.begin()->second.points();
        for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(norm(x[i]), 1, 1e-15);
        const bool triangles = mesh.kind.shape == CellShape::triangle;
        const std::size_t each = triangles ? 6 : 9; // VTK_QUADRATIC_TRIANGLE, VTK_BIQUADRATIC_QUAD
        EXPECT_EQ(vtu.cells["types"].bytes, std::string(mesh.cell_count(), triangles ? 22 : 28));
        const auto nodes = vtu.cells["connectivity"].integers();
        ASSERT_EQ(nodes.size(), each * mesh.cell_count());
        for (std::size_t first = 0; first < nodes.size(); first += each) {
            std::vector<std::size_t> cell;
            for (std::size_t k = 0; k < each; ++k) cell.push_back(static_cast<std::size_t>(nodes[first + k]));
            expect_middle_nodes(x, cell, triangles ? 3 : 4);
        }
    }
}

TEST(Vtu, PatchesAreLagrangeCellsOfTheirDegree) {
    const TemporaryFolder folder;
    for (const int degree : {3, 7}) {
        const Snapshot snapshot = sample_snapshot(*SplineDomain(degree, 2, quarter_annulus_map()).mesh());
        write_vtu(folder / "m.vtu", snapshot);
        ReadVtu vtu(folder / "m.vtu");
        EXPECT_EQ(vtu.cells["types"].bytes, std::string(4, 70));               // VTK_LAGRANGE_QUADRILATERAL
        EXPECT_EQ(vtu.cells["connectivity"].integers(), snapshot.mesh->cells); // see cell_kind_test.cpp
        EXPECT_EQ(vtu.cells["offsets"].integers().front(), (degree + 1) * (degree + 1));
        EXPECT_EQ(vtu.points.begin()->second.points(), snapshot.x);
    }
}

TEST(Vtu, SolidsAreLagrangeHexahedraOfTheirDegree) {
    const TemporaryFolder folder;
    for (const int degree : {3, 7}) {
        const Snapshot snapshot = sample_snapshot(*SolidDomain(degree, 2, ball_map()).mesh());
        write_vtu(folder / "m.vtu", snapshot);
        ReadVtu vtu(folder / "m.vtu");
        EXPECT_EQ(vtu.cells["types"].bytes, std::string(8, 72)); // VTK_LAGRANGE_HEXAHEDRON
        // As cell_kind_test.cpp has them, but in files of version 1.0 the last two edges are exchanged.
        std::vector<std::int32_t> expected = snapshot.mesh->cells;
        const std::size_t each = static_cast<std::size_t>(nodes_per_cell(snapshot.mesh->kind)),
                          inner = static_cast<std::size_t>(degree) - 1;
        for (std::size_t cell = 0; cell < expected.size(); cell += each)
            for (std::size_t i = 0; i < inner; ++i)
                std::swap(expected[cell + 8 + 10 * inner + i], expected[cell + 8 + 11 * inner + i]);
        EXPECT_EQ(vtu.cells["connectivity"].integers(), expected);
    }
}

TEST(Vtu, SaysHowFarTheRunIs) {
    const TemporaryFolder folder;
    write_vtu(folder / "m.vtu", sample_snapshot(two_triangles()));
    ReadVtu vtu(folder / "m.vtu");
    EXPECT_EQ(vtu.field_data["iteration"].integers(), std::vector<std::int32_t>{17});
    EXPECT_EQ(vtu.field_data["residual"].reals(), std::vector<double>{1.0 / 3});
    EXPECT_EQ(vtu.field_data["tangled_cells"].integers(), std::vector<std::int32_t>{2});
    EXPECT_FALSE(vtu.field_data.contains("equidistribution")) << "it was not measured";
}

TEST(Vtu, MeasuresItsCells) {
    const TemporaryFolder folder;
    Snapshot snapshot = sample_snapshot(unit_square_mesh(4));
    snapshot.x = snapshot.mesh->nodes;
    snapshot.x.x[6] += 0.125; // a node inside
    write_vtu(folder / "m.vtu", snapshot);
    const auto measures = ReadVtu(folder / "m.vtu").cell_data["measure"].reals();
    EXPECT_NEAR(measures[0], 0.0625 + 0.125 * 0.25 / 2, 1e-15); // a triangle more
    EXPECT_NEAR(measures[1], 0.0625 - 0.125 * 0.25 / 2, 1e-15);
    EXPECT_NEAR(measures[15], 0.0625, 1e-15);
}

TEST(Vtu, APeriodicSquareIsUnwrapped) {
    const TemporaryFolder folder;
    write_vtu(folder / "m.vtu", sample_snapshot(unit_square_mesh(7)));
    EXPECT_EQ(ReadVtu(folder / "m.vtu").point_count, 64);
}

TEST(Vtu, DoesNotKnowTheLocale) {
    const TemporaryFolder folder;
    const Snapshot snapshot = sample_snapshot(unit_square_mesh(40)); // more than a thousand points
    write_vtu(folder / "plain.vtu", snapshot);
    {
        const CommaLocale comma;
        write_vtu(folder / "comma.vtu", snapshot);
    }
    EXPECT_EQ(read_file(folder / "plain.vtu"), read_file(folder / "comma.vtu"));
}

TEST(Vtu, ANameThatXmlWouldMisunderstandIsEscaped) {
    const TemporaryFolder folder;
    Snapshot snapshot = sample_snapshot(two_triangles());
    snapshot.fields[0].name = "a<b & \"c\"";
    write_vtu(folder / "m.vtu", snapshot);
    EXPECT_TRUE(ReadVtu(folder / "m.vtu").point_data.contains("a<b & \"c\""));
}

TEST(Vtu, WhatIsNotFiniteIsAFaultAndNothingIsWritten) {
    for (const double wrong :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        const TemporaryFolder folder;
        Snapshot position = sample_snapshot(two_triangles()), field = position, cell = position;
        position.x.z[2] = wrong;
        field.fields[0].values[1] = wrong;
        cell.fields[1].values[0] = wrong;
        for (const Snapshot& snapshot : {position, field, cell})
            EXPECT_THROW(write_vtu(folder / "m.vtu", snapshot), InternalError);
        EXPECT_TRUE(folder.content().empty());
    }
}

} // namespace
} // namespace gaspard

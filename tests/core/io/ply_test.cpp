// PLY files read back by assimp and, since that reads single precision, by a small parser that checks every
// bit.
#include "core/base/error.hpp"
#include "core/base/read_file.hpp"
#include "core/io/formats.hpp"
#include "core/tessellate/colour_map.hpp"
#include "support/little_endian.hpp"
#include "support/sample_snapshot.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <assimp/Importer.hpp>
#include <assimp/scene.h>
#include <gtest/gtest.h>
#include <limits>
#include <set>
#include <sstream>

namespace gaspard {
namespace {

struct Vertex {
    Vec3 position;
    std::array<unsigned char, 3> colour{};
    double monitor = 0;
};

struct ReadPly {
    std::vector<std::string> header;
    std::vector<Vertex> vertices;
    std::vector<std::vector<std::int32_t>> faces, edges;

    explicit ReadPly(const std::filesystem::path& file) {
        const std::string text = read_file(file), mark = "end_header\n";
        const std::size_t end = text.find(mark) + mark.size();
        std::istringstream lines(text.substr(0, end));
        std::size_t vertex_count = 0, face_count = 0, edge_count = 0;
        for (std::string line; std::getline(lines, line);) {
            header.push_back(line);
            std::istringstream words(line);
            std::string element, name;
            std::size_t count = 0;
            words >> element >> name >> count;
            if (element != "element") continue;
            (name == "vertex" ? vertex_count : name == "face" ? face_count : edge_count) = count;
        }
        LittleEndian in(std::string_view(text).substr(end));
        for (std::size_t i = 0; i < vertex_count; ++i) {
            Vertex v;
            v.position.x = in.real(), v.position.y = in.real(), v.position.z = in.real();
            for (auto& channel : v.colour) channel = in.unsigned_number<std::uint8_t>();
            v.monitor = in.real();
            vertices.push_back(v);
        }
        for (std::size_t f = 0; f < face_count; ++f) {
            faces.emplace_back(in.unsigned_number<std::uint8_t>());
            for (auto& corner : faces.back()) corner = in.int32();
        }
        for (std::size_t e = 0; e < edge_count; ++e) {
            edges.emplace_back(2);
            for (auto& corner : edges.back()) corner = in.int32();
        }
        EXPECT_TRUE(in.rest().empty());
    }
};

class PlyTest : public testing::Test {
  protected:
    ReadPly written(Mesh mesh) {
        snapshot_ = sample_snapshot(std::move(mesh));
        write_ply(file_, snapshot_);
        return ReadPly(file_);
    }
    TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "adapted.ply";
    Snapshot snapshot_;
};

TEST_F(PlyTest, HoldsCornersMonitorAndFacesToTheLastBit) {
    const ReadPly ply = written(unit_square_mesh(5));
    EXPECT_EQ(ply.header[0], "ply");
    EXPECT_EQ(ply.header[1], "format binary_little_endian 1.0");
    ASSERT_EQ(ply.vertices.size(), 36u);
    for (std::size_t i = 0; i < 36; ++i) {
        EXPECT_EQ(ply.vertices[i].position, snapshot_.x[i]);
        EXPECT_EQ(ply.vertices[i].monitor, snapshot_.fields[0].values[i]);
    }
    ASSERT_EQ(ply.faces.size(), 25u);
    for (std::size_t c = 0; c < 25; ++c)
        EXPECT_TRUE(std::equal(ply.faces[c].begin(), ply.faces[c].end(), snapshot_.mesh->cell(c).begin(),
                               snapshot_.mesh->cell(c).end()));
}

TEST_F(PlyTest, ColoursFollowTheMonitor) {
    const ReadPly ply = written(unit_square_mesh(5));
    const auto& values = snapshot_.fields[0].values;
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    std::set<std::array<unsigned char, 3>> seen;
    for (std::size_t i = 0; i < values.size(); ++i) {
        EXPECT_EQ(ply.vertices[i].colour,
                  colour_at(colour_maps().front(), (values[i] - *low) / (*high - *low)));
        seen.insert(ply.vertices[i].colour);
    }
    EXPECT_GT(seen.size(), 20u);
}

TEST_F(PlyTest, AssimpReadsIt) {
    for (Mesh mesh : {unit_square_mesh(5), two_triangles()}) {
        const ReadPly ply = written(mesh);
        Assimp::Importer importer;
        const aiScene* scene = importer.ReadFile(file_.string(), 0);
        ASSERT_TRUE(scene) << importer.GetErrorString();
        ASSERT_EQ(scene->mNumMeshes, 1u);
        const aiMesh& read = *scene->mMeshes[0];
        ASSERT_EQ(read.mNumFaces, mesh.cell_count());
        ASSERT_TRUE(read.HasVertexColors(0));
        for (unsigned f = 0; f < read.mNumFaces; ++f) {
            ASSERT_EQ(read.mFaces[f].mNumIndices, static_cast<unsigned>(corners_per_cell(mesh.kind)));
            for (unsigned k = 0; k < read.mFaces[f].mNumIndices; ++k) {
                const auto& p = read.mVertices[read.mFaces[f].mIndices[k]];
                const Vertex& v = ply.vertices[static_cast<std::size_t>(mesh.cell(f)[k])];
                EXPECT_FLOAT_EQ(p.x, static_cast<float>(v.position.x));
                EXPECT_FLOAT_EQ(p.y, static_cast<float>(v.position.y));
                const auto& c = read.mColors[0][read.mFaces[f].mIndices[k]];
                EXPECT_FLOAT_EQ(c.g, static_cast<float>(v.colour[1]) / 255.0f);
            }
        }
    }
}

TEST_F(PlyTest, WritesOnlyTheCornersOfCurvedCells) {
    const ReadPly ply = written(curved_square()); // whose corners are its nodes 2 to 5
    ASSERT_EQ(ply.vertices.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(ply.vertices[i].position, snapshot_.x[i + 2]);
    EXPECT_EQ(ply.faces, (std::vector<std::vector<std::int32_t>>{{0, 1, 2, 3}}));
}

TEST_F(PlyTest, WritesTheBoundaryOfSolids) {
    const ReadPly ply = written(two_cubes());
    EXPECT_EQ(ply.vertices.size(), 12u);
    ASSERT_EQ(ply.faces.size(), 10u);
    for (const auto& face : ply.faces) {
        ASSERT_EQ(face.size(), 4u);
        const auto p = [&](std::size_t i) {
            return snapshot_.mesh->nodes[static_cast<std::size_t>(face[i])];
        };
        const Vec3 middle = 0.25 * (p(0) + p(1) + p(2) + p(3));
        EXPECT_GT(dot(cross(p(1) - p(0), p(3) - p(0)), middle - Vec3{1, .5, .5}), 0) << "outward";
    }
    const Mesh cube = of_order_two(two_cubes());
    EXPECT_EQ(written(cube).vertices.size(), 12u);
}

TEST_F(PlyTest, LinesAreEdges) {
    const ReadPly ply = written(three_lines());
    EXPECT_TRUE(ply.faces.empty());
    EXPECT_EQ(ply.edges, (std::vector<std::vector<std::int32_t>>{{0, 2}, {2, 3}, {3, 1}}));
}

TEST_F(PlyTest, RejectsNonFiniteValuesAndWritesNothing) {
    Snapshot position = sample_snapshot(two_triangles()), field = position;
    position.x.y[3] = std::numeric_limits<double>::quiet_NaN();
    field.fields[0].values[0] = std::numeric_limits<double>::infinity();
    for (const Snapshot& snapshot : {position, field})
        EXPECT_THROW(write_ply(file_, snapshot), InternalError);
    EXPECT_TRUE(folder_.content().empty());
}

} // namespace
} // namespace gaspard

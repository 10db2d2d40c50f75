// Files of surfaces of a solid that is cut open, read back: OBJ by lines, GLB and PLY by assimp.
#include "core/base/read_file.hpp"
#include "core/io/formats.hpp"
#include "core/scenario/view_rows.hpp"
#include "core/spline/solid_domain.hpp"
#include "core/tessellate/snapshot_section.hpp"
#include "support/sample_snapshot.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <assimp/scene.h>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <map>
#include <numbers>
#include <sstream>

namespace gaspard {
namespace {

/// The faces of an OBJ file as triangles.
struct ObjSurface {
    Points x;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::size_t lines = 0;

    explicit ObjSurface(const std::filesystem::path& file) {
        std::istringstream text(read_file(file));
        for (std::string line; std::getline(text, line);) {
            std::istringstream words(line);
            std::string keyword;
            words >> keyword;
            if (keyword == "v") {
                Vec3 p;
                words >> p.x >> p.y >> p.z;
                x.resize(x.size() + 1), x.set(x.size() - 1, p);
            }
            if (keyword == "l") ++lines;
            if (keyword != "f") continue;
            std::vector<std::uint32_t> corners;
            for (std::uint32_t corner = 0; words >> corner;) corners.push_back(corner - 1);
            for (std::size_t i = 2; i < corners.size(); ++i)
                triangles.push_back({corners[0], corners[i - 1], corners[i]});
        }
    }

    /// Every side belongs to two triangles, which go through it in opposite directions.
    bool is_closed() const {
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
        for (const auto& t : triangles)
            for (std::size_t i = 0; i < 3; ++i) ++sides[{t[i], t[(i + 1) % 3]}];
        return std::all_of(sides.begin(), sides.end(), [&](const auto& side) {
            const auto back = sides.find({side.first.second, side.first.first});
            return side.second == 1 && back != sides.end() && back->second == 1;
        });
    }
    double volume() const {
        double sum = 0;
        for (const auto& t : triangles) sum += dot(x[t[0]], cross(x[t[1]], x[t[2]])) / 6;
        return sum;
    }
};

class CutFiles : public testing::Test {
  protected:
    CutFiles() : snapshot_(sample_snapshot(*SolidDomain(2, 8, ball_map()).mesh())) {
        snapshot_.x = snapshot_.mesh->nodes;
    }
    void write(const char* format) {
        const RunResult result{.snapshot = snapshot_, .history = {}, .space = {}, .view = view_};
        parse_formats(format).at(0)->write(folder_.path(), result);
    }
    const aiMesh* faces_of(const char* name) {
        const aiScene* scene = importer_.ReadFile((folder_ / name).string(), 0);
        if (scene == nullptr) ADD_FAILURE() << importer_.GetErrorString();
        for (unsigned i = 0; scene != nullptr && i < scene->mNumMeshes; ++i)
            if (scene->mMeshes[i]->mPrimitiveTypes & aiPrimitiveType_TRIANGLE) return scene->mMeshes[i];
        ADD_FAILURE() << "no triangles";
        return nullptr;
    }
    TemporaryFolder folder_;
    Snapshot snapshot_;
    Values view_{"view", view_rows({})};
    Assimp::Importer importer_;
};

TEST_F(CutFiles, CapsCloseTheBoundaryOfWhatAPlaneLeaves) {
    view_.set("cut", std::string("x 0.05"));
    for (const char* format : {"obj", "obj-curved"}) {
        write(format);
        const ObjSurface obj(folder_ / (std::string(format) == "obj" ? "adapted.obj" : "adapted-curved.obj"));
        EXPECT_TRUE(obj.is_closed());
        EXPECT_GT(obj.lines, 100u) << "edges of cells";
        const double h = 1.05; // of the part of the ball
        EXPECT_NEAR(obj.volume(), std::numbers::pi * h * h * (3 - h) / 3, 0.02);
        double most = -1;
        for (std::size_t i = 0; i < obj.x.size(); ++i) most = std::max(most, obj.x.x[i]);
        EXPECT_NEAR(most, 0.05, 1e-9);
    }
}

TEST_F(CutFiles, AllFormatsHaveTheSameTriangles) {
    view_.set("cut", std::string("x 0.05 and z 0.1"));
    view_.set("peel", std::int64_t{1});
    const auto shape = surface_of_cut(snapshot_, view_);
    ASSERT_TRUE(shape);
    EXPECT_GT(shape->caps, 0u);
    write("obj"), write("glb"), write("ply"), write("glb-curved");
    EXPECT_EQ(ObjSurface(folder_ / "adapted.obj").triangles.size(), shape->triangle_cells.size());
    for (const char* name : {"adapted.glb", "adapted.ply", "adapted-curved.glb"}) {
        const aiMesh* faces = faces_of(name);
        ASSERT_NE(faces, nullptr) << name;
        EXPECT_EQ(faces->mNumFaces, shape->triangle_cells.size()) << name;
        EXPECT_TRUE(faces->HasVertexColors(0)) << name;
    }
}

TEST_F(CutFiles, ThePlyHasTheMonitorOnTheCaps) {
    view_.set("cut", std::string("y 0.03"));
    write("ply");
    const auto shape = surface_of_cut(snapshot_, view_);
    const std::vector<double> values = shown_values(*shape, snapshot_.field("monitor")->values);
    const std::string bytes = read_file(folder_ / "adapted.ply");
    double first = 0; // behind the coordinates and the colour of the first vertex
    std::memcpy(&first, bytes.data() + bytes.find("end_header\n") + 11 + 24 + 3, sizeof first);
    EXPECT_EQ(first, values[0]);
    EXPECT_NE(bytes.find("element vertex " + std::to_string(values.size()) + "\n"), std::string::npos);
}

TEST_F(CutFiles, CellsApartAndChosenCellsAreClosedPieces) {
    view_.set("explode", 0.2);
    view_.set("layers", std::string("i 0 to 1"));
    write("obj");
    const ObjSurface obj(folder_ / "adapted.obj");
    EXPECT_TRUE(obj.is_closed());
    EXPECT_EQ(obj.triangles.size() % (2 * 64 * 6), 0u) << "all six faces of 128 cells";
}

TEST_F(CutFiles, WithoutACutOrWithNothingLeftTheWholeBoundaryIsWritten) {
    write("ply");
    const std::string whole = read_file(folder_ / "adapted.ply");
    view_.set("cut_cells", std::string("whole"));
    write("ply");
    EXPECT_EQ(read_file(folder_ / "adapted.ply"), whole) << "no plane cuts";
    view_.set("cut", std::string("x -5"));
    write("ply");
    EXPECT_EQ(read_file(folder_ / "adapted.ply"), whole) << "all is hidden";
    write("obj");
    EXPECT_EQ(ObjSurface(folder_ / "adapted.obj").triangles.size(), 12u * 512u) << "all faces of all cells";
}

} // namespace
} // namespace gaspard

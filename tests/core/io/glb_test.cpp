// GLB files read back by assimp; what assimp does not report (default weights, accessor bounds, index types)
// is read from the file's JSON with a parser other than the writer's.
#include "core/base/error.hpp"
#include "core/base/read_file.hpp"
#include "core/io/formats.hpp"
#include "core/tessellate/colour_map.hpp"
#include "core/tessellate/fine_tessellation.hpp"
#include "fixtures/fixture_meshes.hpp"
#include "support/comma_locale.hpp"
#include "support/small_meshes.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <assimp/scene.h>
#include <bit>
#include <nlohmann/json.hpp>
#include <set>

namespace gaspard {
namespace {

using Json = nlohmann::json;

Snapshot snapshot_of(Mesh mesh) {
    Snapshot snapshot;
    snapshot.mesh = std::make_shared<const Mesh>(std::move(mesh));
    snapshot.x = moved(*snapshot.mesh);
    Field monitor{{.name = "monitor"}, {}};
    for (std::size_t i = 0; i < snapshot.x.size(); ++i)
        monitor.values.push_back(2 + std::sin(5 * snapshot.x.x[i] + snapshot.x.y[i]));
    snapshot.fields.push_back(std::move(monitor));
    return snapshot;
}

std::uint32_t word(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes.at(at + i))) << (8 * i);
    return value;
}

/// The JSON chunk; checks the container.
Json json_of(const std::string& glb) {
    EXPECT_EQ(glb.substr(0, 4), "glTF");
    EXPECT_EQ(word(glb, 4), 2u);
    EXPECT_EQ(word(glb, 8), glb.size());
    const std::size_t length = word(glb, 12);
    EXPECT_EQ(length % 4, 0u);
    EXPECT_EQ(glb.substr(16, 4), "JSON");
    EXPECT_EQ(glb.substr(20 + length + 4, 4), std::string("BIN\0", 4));
    EXPECT_EQ(word(glb, 20 + length) + 28 + length, glb.size());
    return Json::parse(glb.substr(20, length));
}

/// The mesh with the given type of faces, or null.
const aiMesh* find_mesh(const aiScene& scene, unsigned primitive) {
    for (unsigned i = 0; i < scene.mNumMeshes; ++i)
        if (scene.mMeshes[i]->mPrimitiveTypes == primitive) return scene.mMeshes[i];
    return nullptr;
}

/// The node at which each vertex lies. Importers number vertices as they like (assimp since 5.4).
std::vector<std::size_t> nodes_of(const aiMesh& mesh, const Points& x) {
    std::vector<std::size_t> nodes;
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
        const aiVector3D& p = mesh.mVertices[v];
        const Vec3 at{static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
        std::size_t nearest = 0;
        for (std::size_t i = 1; i < x.size(); ++i)
            if (norm(x[i] - at) < norm(x[nearest] - at)) nearest = i;
        nodes.push_back(nearest);
    }
    return nodes;
}

void expect_near(const aiVector3D& p, Vec3 q) {
    constexpr double rounding = 2e-7; // two roundings to single precision of numbers below 2
    EXPECT_NEAR(static_cast<double>(p.x), q.x, rounding);
    EXPECT_NEAR(static_cast<double>(p.y), q.y, rounding);
    EXPECT_NEAR(static_cast<double>(p.z), q.z, rounding);
}

struct Glb {
    Assimp::Importer importer;
    const aiScene* scene = nullptr;
    const aiMesh *faces = nullptr, *edges = nullptr;
    Json json;

    Glb(const std::filesystem::path& file, const Snapshot& snapshot) {
        write_glb(file, snapshot);
        json = json_of(read_file(file));
        scene = importer.ReadFile(file.string(), 0);
        if (!scene) throw std::runtime_error(importer.GetErrorString());
        faces = find_mesh(*scene, aiPrimitiveType_TRIANGLE);
        edges = find_mesh(*scene, aiPrimitiveType_LINE);
    }
};

class GlbTest : public testing::Test {
  protected:
    TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "adapted.glb";
};

TEST_F(GlbTest, HoldsTheSquareMeshAtX) {
    const Snapshot snapshot = snapshot_of(unit_square_mesh(5));
    const Glb glb(file_, snapshot);
    ASSERT_EQ(glb.scene->mNumMeshes, 2u);
    ASSERT_TRUE(glb.faces && glb.edges);
    EXPECT_EQ(glb.faces->mNumFaces, 2u * 25);
    EXPECT_EQ(glb.edges->mNumFaces, 60u);
    for (const aiMesh* mesh : {glb.faces, glb.edges}) {
        ASSERT_EQ(mesh->mNumVertices, 36u);
        const auto nodes = nodes_of(*mesh, snapshot.x);
        EXPECT_EQ(std::set(nodes.begin(), nodes.end()).size(), 36u) << "every node once";
        for (unsigned i = 0; i < 36; ++i) expect_near(mesh->mVertices[i], snapshot.x[nodes[i]]);
    }
}

TEST_F(GlbTest, TrianglesFillTheCellsAndLinesFollowTheEdges) {
    const Snapshot snapshot = snapshot_of(unit_square_mesh(5));
    const Glb glb(file_, snapshot);
    // The areas of the triangles, and the shoelace formula around the outer nodes.
    double area = 0, outline = 0;
    const auto of_faces = nodes_of(*glb.faces, snapshot.x), of_edges = nodes_of(*glb.edges, snapshot.x);
    for (unsigned f = 0; f < glb.faces->mNumFaces; ++f) {
        const auto corner = [&](std::size_t k) {
            return snapshot.x[of_faces[glb.faces->mFaces[f].mIndices[k]]];
        };
        const Vec3 n = cross(corner(1) - corner(0), corner(2) - corner(0));
        EXPECT_GT(n.z, 0) << "counter-clockwise";
        area += n.z / 2;
    }
    std::vector<std::size_t> around;
    for (std::size_t k = 0; k < 5; ++k) around.push_back(k);
    for (std::size_t k = 0; k < 5; ++k) around.push_back(5 + 6 * k);
    for (std::size_t k = 0; k < 5; ++k) around.push_back(35 - k);
    for (std::size_t k = 0; k < 5; ++k) around.push_back(30 - 6 * k);
    for (std::size_t k = 0; k < around.size(); ++k)
        outline += cross(snapshot.x[around[k]], snapshot.x[around[(k + 1) % around.size()]]).z / 2;
    EXPECT_NEAR(area, outline, 1e-14);
    for (unsigned f = 0; f < glb.edges->mNumFaces; ++f) {
        const auto* i = glb.edges->mFaces[f].mIndices;
        const auto [low, high] = std::minmax(of_edges[i[0]], of_edges[i[1]]);
        const std::size_t step = high - low;
        EXPECT_TRUE(step == 1 || step == 6) << "neighbours in a row or in a column";
    }
}

TEST_F(GlbTest, ColoursFollowTheMonitor) {
    const Snapshot snapshot = snapshot_of(unit_square_mesh(5));
    const Glb glb(file_, snapshot);
    ASSERT_TRUE(glb.faces->HasVertexColors(0));
    const auto& values = snapshot.field("monitor")->values;
    const ColourMap& map = colour_maps().front();
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const auto nodes = nodes_of(*glb.faces, snapshot.x);
    for (unsigned i = 0; i < 36; ++i) {
        const auto expected = colour_at(map, (values[nodes[i]] - *low) / (*high - *low));
        const aiColor4D& c = glb.faces->mColors[0][i];
        const float channels[] = {c.r, c.g, c.b};
        for (std::size_t k = 0; k < 3; ++k) { // from linear back to sRGB
            const double v = static_cast<double>(channels[k]);
            const double srgb = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
            EXPECT_NEAR(255 * srgb, expected[k], 0.01);
        }
    }
    const auto vertex_at = [&](auto value) {
        const auto node = static_cast<std::size_t>(value - values.begin());
        return std::find(nodes.begin(), nodes.end(), node) - nodes.begin();
    };
    EXPECT_NE(glb.faces->mColors[0][vertex_at(low)], glb.faces->mColors[0][vertex_at(high)]);
}

TEST_F(GlbTest, EdgesContrastWithTheirFaces) {
    const Snapshot snapshot = snapshot_of(unit_square_mesh(20));
    const Glb glb(file_, snapshot);
    ASSERT_TRUE(glb.edges->HasVertexColors(0));
    std::vector<const aiColor4D*> edge_colours(snapshot.x.size());
    const auto of_faces = nodes_of(*glb.faces, snapshot.x), of_edges = nodes_of(*glb.edges, snapshot.x);
    for (std::size_t i = 0; i < of_edges.size(); ++i) edge_colours[of_edges[i]] = &glb.edges->mColors[0][i];
    const auto luminance = [](const aiColor4D& c) {
        return static_cast<double>(0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b);
    };
    for (unsigned i = 0; i < glb.faces->mNumVertices; ++i) {
        ASSERT_TRUE(edge_colours[of_faces[i]]);
        const auto [dark, light] =
            std::minmax({luminance(glb.faces->mColors[0][i]), luminance(*edge_colours[of_faces[i]])});
        EXPECT_GE((light + 0.05) / (dark + 0.05), 3) << "the contrast ratio that WCAG asks of graphics";
    }
}

TEST_F(GlbTest, TheMorphTargetIsTheComputationalMesh) {
    const Snapshot snapshot = snapshot_of(unit_square_mesh(5));
    const Glb glb(file_, snapshot);
    for (const aiMesh* mesh : {glb.faces, glb.edges}) {
        ASSERT_EQ(mesh->mNumAnimMeshes, 1u);
        ASSERT_EQ(mesh->mAnimMeshes[0]->mNumVertices, 36u);
        const auto nodes = nodes_of(*mesh, snapshot.x);
        for (unsigned i = 0; i < 36; ++i)
            expect_near(mesh->mAnimMeshes[0]->mVertices[i], snapshot.mesh->nodes[nodes[i]]);
    }
    EXPECT_EQ(glb.json["meshes"][0]["weights"], Json({0.0}));
}

TEST_F(GlbTest, TheAnimationPlaysFromXiToX) {
    const Glb glb(file_, snapshot_of(unit_square_mesh(4)));
    ASSERT_EQ(glb.scene->mNumAnimations, 1u);
    const aiAnimation& animation = *glb.scene->mAnimations[0];
    ASSERT_EQ(animation.mNumMorphMeshChannels, 1u);
    const aiMeshMorphAnim& channel = *animation.mMorphMeshChannels[0];
    ASSERT_GE(channel.mNumKeys, 2u);
    EXPECT_EQ(channel.mKeys[0].mTime, 0);
    double before = 1;
    for (unsigned k = 0; k < channel.mNumKeys; ++k) {
        ASSERT_EQ(channel.mKeys[k].mNumValuesAndWeights, 1u);
        EXPECT_LE(channel.mKeys[k].mWeights[0], before) << "from the whole displacement to none";
        before = channel.mKeys[k].mWeights[0];
    }
    EXPECT_EQ(channel.mKeys[0].mWeights[0], 1);
    EXPECT_EQ(before, 0);
}

TEST_F(GlbTest, BoundsOfPositionsAreExact) {
    const Snapshot snapshot = snapshot_of(unit_square_mesh(5));
    const Glb glb(file_, snapshot);
    const Json& primitive = glb.json["meshes"][0]["primitives"][0];
    const Json& accessor = glb.json["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()];
    const auto& x = snapshot.x;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto& values = k == 0 ? x.x : k == 1 ? x.y : x.z;
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        EXPECT_EQ(accessor["min"][k].get<double>(), static_cast<double>(static_cast<float>(*low)));
        EXPECT_EQ(accessor["max"][k].get<double>(), static_cast<double>(static_cast<float>(*high)));
    }
    const Json& target = glb.json["accessors"][primitive["targets"][0]["POSITION"].get<std::size_t>()];
    EXPECT_TRUE(target.contains("min") && target.contains("max"));
}

/// The positions of an accessor, from the file's bytes.
std::vector<Vec3> positions_in(const std::string& bytes, const Json& json, std::size_t accessor) {
    const Json& view = json["bufferViews"][json["accessors"][accessor]["bufferView"].get<std::size_t>()];
    const std::size_t begin = 20 + word(bytes, 12) + 8 + view.value("byteOffset", std::size_t{0});
    const auto number = [&](std::size_t i) {
        return static_cast<double>(std::bit_cast<float>(word(bytes, begin + 4 * i)));
    };
    std::vector<Vec3> points(json["accessors"][accessor]["count"].get<std::size_t>());
    for (std::size_t i = 0; i < points.size(); ++i)
        points[i] = {number(3 * i), number(3 * i + 1), number(3 * i + 2)};
    return points;
}

TEST_F(GlbTest, KeepsItsShapeFarFromTheOrigin) {
    Snapshot snapshot = snapshot_of(unit_square_mesh(64));
    Mesh far = *snapshot.mesh;
    for (std::size_t i = 0; i < far.node_count(); ++i) {
        far.nodes.set(i, far.nodes[i] + Vec3{5e5, 4e6, 0});
        snapshot.x.set(i, snapshot.x[i] + Vec3{5e5, 4e6, 0});
    }
    snapshot.mesh = std::make_shared<const Mesh>(far);
    const Glb glb(file_, snapshot);
    const std::string bytes = read_file(file_);
    const Json& translation = glb.json["nodes"][0]["translation"];
    ASSERT_EQ(translation.size(), 3u);
    const Vec3 origin{translation[0].get<double>(), translation[1].get<double>(),
                      translation[2].get<double>()};
    const Json& primitive = glb.json["meshes"][0]["primitives"][0];
    const auto position =
        positions_in(bytes, glb.json, primitive["attributes"]["POSITION"].get<std::size_t>());
    const auto target = positions_in(bytes, glb.json, primitive["targets"][0]["POSITION"].get<std::size_t>());
    ASSERT_EQ(position.size(), 4225u);
    std::set<std::array<double, 3>> distinct;
    for (std::size_t i = 0; i < position.size(); ++i) {
        EXPECT_LT(norm(origin + position[i] - snapshot.x[i]), 1e-6);
        EXPECT_LT(norm(origin + position[i] + target[i] - far.nodes[i]), 1e-6)
            << "where the animation begins";
        distinct.insert({position[i].x, position[i].y, position[i].z});
    }
    EXPECT_EQ(distinct.size(), 4225u);
}

TEST_F(GlbTest, ColoursMoveWithTheFramesOfAnAnimation) {
    const auto frame = [](double left, double right) {
        Snapshot snapshot = snapshot_of(unit_square_mesh(4));
        for (Field& field : snapshot.fields)
            if (field.name == "monitor")
                for (std::size_t i = 0; i < field.values.size(); ++i)
                    field.values[i] = snapshot.x.x[i] < 0.5 ? left : right;
        return std::make_shared<const Snapshot>(std::move(snapshot));
    };
    const auto first = frame(4, 1), last = frame(1, 2);
    ASSERT_NE(first->field("monitor"), nullptr);
    write_animated_glb(file_, {first, frame(1, 4), last}, 10);
    const std::string bytes = read_file(file_);
    const Json json = json_of(bytes);
    const Json& faces = json["meshes"][0]["primitives"][0];
    ASSERT_EQ(faces["targets"].size(), 2u);
    const auto colours = [&](const Json& attributes) {
        return positions_in(bytes, json, attributes["COLOR_0"].get<std::size_t>());
    };
    const auto base = colours(faces["attributes"]), to_first = colours(faces["targets"][0]),
               to_second = colours(faces["targets"][1]);
    ASSERT_EQ(base.size(), to_first.size());
    for (std::size_t i = 0; i < base.size(); ++i) {
        const bool left = first->x.x[i] < 0.5;
        const Vec3 there = base[i] + to_first[i], later = base[i] + to_second[i];
        const Vec3 dark{0.05, 0, 0.1}, bright{1, 0.8, 0.02}; // the ends of viridis, in linear light
        EXPECT_LT(norm(there - (left ? bright : dark)), 0.1) << "one range of colours for all frames";
        EXPECT_LT(norm(later - (left ? dark : bright)), 0.1);
    }
}

TEST_F(GlbTest, HasNoTranslationNearTheOrigin) {
    const Glb glb(file_, snapshot_of(unit_square_mesh(4)));
    EXPECT_FALSE(glb.json["nodes"][0].contains("translation"));
}

TEST_F(GlbTest, ManyVerticesUseWiderIndices) {
    const auto index_type = [&](int n) {
        const Glb glb(file_, snapshot_of(unit_square_mesh(n)));
        EXPECT_EQ(glb.faces->mNumFaces, 2u * static_cast<unsigned>(n * n));
        std::uint32_t largest = 0;
        for (unsigned f = 0; f < glb.faces->mNumFaces; ++f)
            for (unsigned i = 0; i < 3; ++i) largest = std::max(largest, glb.faces->mFaces[f].mIndices[i]);
        EXPECT_EQ(largest + 1, static_cast<std::uint32_t>((n + 1) * (n + 1)));
        const auto indices = glb.json["meshes"][0]["primitives"][0]["indices"].get<std::size_t>();
        return glb.json["accessors"][indices]["componentType"].get<int>();
    };
    EXPECT_EQ(index_type(254), 5123); // 255^2 = 65025 vertices: unsigned short
    EXPECT_EQ(index_type(255), 5125); // 256^2 = 65536: unsigned int
}

TEST_F(GlbTest, LinesCarryTheColoursThemselves) {
    const Snapshot snapshot = snapshot_of(three_lines());
    const Glb glb(file_, snapshot);
    ASSERT_EQ(glb.scene->mNumMeshes, 1u);
    ASSERT_TRUE(glb.edges);
    EXPECT_EQ(glb.edges->mNumFaces, 3u);
    EXPECT_TRUE(glb.edges->HasVertexColors(0));
    EXPECT_EQ(glb.edges->mNumAnimMeshes, 1u);
    const auto nodes = nodes_of(*glb.edges, snapshot.x);
    EXPECT_EQ(std::set(nodes.begin(), nodes.end()).size(), 4u) << "every node once";
    for (unsigned i = 0; i < 4; ++i) expect_near(glb.edges->mVertices[i], snapshot.x[nodes[i]]);
}

TEST_F(GlbTest, CurvedCellsAreSubdivided) {
    const Snapshot snapshot = snapshot_of(curved_square());
    const Glb glb(file_, snapshot);
    const auto cuts = static_cast<unsigned>(
        std::max(cuts_for(*snapshot.mesh, snapshot.x), cuts_for(*snapshot.mesh, snapshot.mesh->nodes)));
    EXPECT_GE(cuts, 8u);
    EXPECT_EQ(glb.faces->mNumFaces, 2 * cuts * cuts);
    EXPECT_EQ(glb.edges->mNumFaces, 4 * cuts);
    ASSERT_EQ(glb.faces->mNumVertices, (cuts + 1) * (cuts + 1));
    // All nodes of the cell are shown points.
    for (std::size_t node = 0; node < snapshot.x.size(); ++node) {
        double nearest = 1;
        for (unsigned i = 0; i < glb.faces->mNumVertices; ++i) {
            const aiVector3D& p = glb.faces->mVertices[i];
            const Vec3 q = {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
            nearest = std::min(nearest, norm(q - snapshot.x[node]));
        }
        EXPECT_LT(nearest, 3e-7) << "node " << node;
    }
    EXPECT_FALSE(glb.json["materials"][0].contains("extensions")) << "what is bent is lit";
}

TEST_F(GlbTest, CanBeTessellatedToATolerance) {
    Snapshot snapshot = snapshot_of(cubed_sphere_mesh(2));
    snapshot.x = snapshot.mesh->nodes;
    const Tessellation shape = tessellate_within(*snapshot.mesh, snapshot.x, 1e-3);
    write_glb(file_, snapshot, shape);
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(file_.string(), 0);
    ASSERT_TRUE(scene) << importer.GetErrorString();
    const aiMesh* faces = find_mesh(*scene, aiPrimitiveType_TRIANGLE);
    const aiMesh* edges = find_mesh(*scene, aiPrimitiveType_LINE);
    ASSERT_TRUE(faces && edges);
    EXPECT_EQ(faces->mNumFaces, shape.triangle_cells.size());
    EXPECT_EQ(edges->mNumFaces, shape.segments.size() / 2);
    const Points points = shown_points(shape, snapshot.x);
    ASSERT_EQ(faces->mNumVertices, points.size());
    const auto at = nodes_of(*faces, points);
    EXPECT_EQ(std::set(at.begin(), at.end()).size(), points.size()) << "every point once";
    for (unsigned i = 0; i < faces->mNumVertices; ++i) expect_near(faces->mVertices[i], points[at[i]]);
    EXPECT_TRUE(faces->HasVertexColors(0));
}

TEST_F(GlbTest, ShowsTheBoundaryOfSolids) {
    const Glb glb(file_, snapshot_of(two_cubes()));
    EXPECT_EQ(glb.faces->mNumFaces, 2u * 10); // twelve faces, of which two are interior
    EXPECT_EQ(glb.edges->mNumFaces, 20u);
}

TEST_F(GlbTest, WithoutAMonitorThereAreNoColours) {
    Snapshot snapshot = snapshot_of(unit_square_mesh(4));
    snapshot.fields.clear();
    const Glb glb(file_, snapshot);
    EXPECT_FALSE(glb.faces->HasVertexColors(0));
    EXPECT_FALSE(glb.edges->HasVertexColors(0));
}

TEST_F(GlbTest, BytesDependOnTheInputAlone) {
    const Snapshot snapshot = snapshot_of(unit_square_mesh(12));
    write_glb(file_, snapshot);
    {
        const CommaLocale comma;
        write_glb(folder_ / "again.glb", snapshot);
    }
    EXPECT_EQ(read_file(file_), read_file(folder_ / "again.glb"));
}

TEST_F(GlbTest, RejectsPositionsThatAreNotNumbers) {
    Snapshot snapshot = snapshot_of(two_triangles());
    snapshot.x.x[1] = std::nan("");
    EXPECT_THROW(write_glb(file_, snapshot), InternalError);
    EXPECT_TRUE(folder_.content().empty());
}

// As an iteration that diverges leaves them.
TEST_F(GlbTest, PositionsEndWhereSinglePrecisionEnds) {
    Snapshot snapshot = snapshot_of(two_triangles());
    snapshot.x.x[1] = 1e300, snapshot.x.y[1] = -1.7e308;
    const Glb glb(file_, snapshot);
    const Json& primitive = glb.json["meshes"][0]["primitives"][0];
    const Json& accessor = glb.json["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()];
    constexpr double most = static_cast<double>(std::numeric_limits<float>::max());
    EXPECT_EQ(accessor["max"][0].get<double>(), most);
    EXPECT_EQ(accessor["min"][1].get<double>(), -most);
}

} // namespace
} // namespace gaspard

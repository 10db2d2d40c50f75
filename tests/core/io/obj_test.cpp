// OBJ files read back by OpenMesh and, since that reads single precision, by a small parser that checks every
// bit.
#include "core/base/error.hpp"
#include "core/base/read_file.hpp"
#include "core/io/formats.hpp"
#include "core/scenario/view_rows.hpp"
#include "core/tessellate/fine_tessellation.hpp"
#include "fixtures/fixture_meshes.hpp"
#include "support/comma_locale.hpp"
#include "support/messages.hpp"
#include "support/small_meshes.hpp"
#include "support/temporary_folder.hpp"

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <utility>

namespace gaspard {
namespace {

struct Record {
    std::string keyword;
    std::vector<std::size_t> vertices; ///< from 0
    friend bool operator==(const Record&, const Record&) = default;
};

struct ReadObj {
    std::vector<Vec3> vertices;
    std::vector<Record> records;
    std::vector<std::pair<std::string, std::size_t>> objects; ///< names, each with its first record
};

ReadObj read_obj(const std::filesystem::path& file) {
    ReadObj obj;
    std::istringstream lines(read_file(file));
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string keyword, a, b, c;
        words >> keyword;
        if (keyword == "#") continue;
        if (keyword == "v") {
            EXPECT_TRUE(words >> a >> b >> c) << line;
            obj.vertices.push_back({std::strtod(a.c_str(), nullptr), std::strtod(b.c_str(), nullptr),
                                    std::strtod(c.c_str(), nullptr)});
            continue;
        }
        if (keyword == "o") {
            EXPECT_TRUE(words >> a) << line;
            obj.objects.emplace_back(a, obj.records.size());
            continue;
        }
        obj.records.push_back({keyword, {}});
        for (std::size_t number; words >> number;) obj.records.back().vertices.push_back(number - 1);
        EXPECT_TRUE(words.eof()) << line;
    }
    return obj;
}

void expect_positions(const ReadObj& obj, const Points& positions) {
    ASSERT_EQ(obj.vertices.size(), positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i)
        EXPECT_EQ(obj.vertices[i], positions[i]) << "vertex " << i;
}

TEST(Obj, OpenMeshReadsASquareMesh) {
    const TemporaryFolder folder;
    const Mesh mesh = unit_square_mesh(5);
    const Points x = moved(mesh);
    write_obj(folder / "m.obj", mesh, x);

    OpenMesh::PolyMesh_ArrayKernelT<> read;
    ASSERT_TRUE(OpenMesh::IO::read_mesh(read, (folder / "m.obj").string()));
    ASSERT_EQ(read.n_vertices(), 36u);
    ASSERT_EQ(read.n_faces(), 25u);
    EXPECT_EQ(read.n_edges(), 60u);
    for (std::size_t i = 0; i < x.size(); ++i) {
        const auto p = read.point(OpenMesh::VertexHandle(static_cast<int>(i)));
        EXPECT_FLOAT_EQ(p[0], static_cast<float>(x.x[i]));
        EXPECT_FLOAT_EQ(p[1], static_cast<float>(x.y[i]));
        EXPECT_EQ(p[2], 0.0f);
    }
    for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
        std::vector<std::int32_t> corners;
        for (const auto v : read.fv_range(OpenMesh::FaceHandle(static_cast<int>(c))))
            corners.push_back(v.idx());
        EXPECT_TRUE(
            std::is_permutation(corners.begin(), corners.end(), mesh.cell(c).begin(), mesh.cell(c).end()))
            << "cell " << c;
    }
}

TEST(Obj, CoordinatesReadBackToTheSameDoubles) {
    const TemporaryFolder folder;
    const Mesh mesh = unit_square_mesh(7);
    Points x = moved(mesh);
    x.x[0] = 0.1;
    x.y[0] = 1.0 / 3;
    x.x[1] = 1e-300;
    x.y[1] = -2.2250738585072011e-308;
    x.x[2] = 123456789.123456789;
    x.y[2] = 5e-324;
    write_obj(folder / "m.obj", mesh, x);
    const ReadObj obj = read_obj(folder / "m.obj");
    expect_positions(obj, x);
    ASSERT_EQ(obj.records.size(), mesh.cell_count());
    for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
        const auto cell = mesh.cell(c);
        EXPECT_EQ(obj.records[c], (Record{"f", {cell.begin(), cell.end()}}));
    }
}

TEST(Obj, LinesAreLineRecords) {
    const TemporaryFolder folder;
    const Mesh mesh = three_lines();
    write_obj(folder / "m.obj", mesh, moved(mesh));
    const ReadObj obj = read_obj(folder / "m.obj");
    expect_positions(obj, moved(mesh));
    EXPECT_EQ(obj.records, (std::vector<Record>{{"l", {0, 2}}, {"l", {2, 3}}, {"l", {3, 1}}}));
}

TEST(Obj, WritesOnlyTheCornersOfCurvedCells) {
    const TemporaryFolder folder;
    const Mesh mesh = curved_square();
    write_obj(folder / "m.obj", mesh, mesh.nodes);
    const ReadObj obj = read_obj(folder / "m.obj");
    ASSERT_EQ(obj.vertices.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(obj.vertices[i], mesh.nodes[i + 2]);
    EXPECT_EQ(obj.records, (std::vector<Record>{{"f", {0, 1, 2, 3}}}));
}

TEST(Obj, EverySolidHasItsSixFacesPointingOutward) {
    const TemporaryFolder folder;
    const Mesh mesh = two_cubes();
    write_obj(folder / "m.obj", mesh, mesh.nodes);
    const ReadObj obj = read_obj(folder / "m.obj");
    expect_positions(obj, mesh.nodes);
    ASSERT_EQ(obj.records.size(), 12u);
    for (std::size_t f = 0; f < 12; ++f) {
        const auto& v = obj.records[f].vertices;
        ASSERT_EQ(v.size(), 4u);
        const auto p = [&](std::size_t i) { return obj.vertices[v[i]]; };
        const Vec3 normal = cross(p(1) - p(0), p(3) - p(0));
        const Vec3 centre = {f < 6 ? 0.5 : 1.5, 0.5, 0.5};
        const Vec3 middle = 0.25 * (p(0) + p(1) + p(2) + p(3));
        EXPECT_EQ(dot(normal, middle - centre), 0.5)
            << "face " << f; // unit area, half a unit from the centre
    }
}

TEST(Obj, WritesATessellationAsTrianglesAndPolylines) {
    const TemporaryFolder folder;
    const Mesh mesh = cubed_sphere_mesh(2);
    const Tessellation shape = tessellate_within(mesh, mesh.nodes, 1e-3);
    write_obj(folder / "m.obj", shape, mesh.nodes);
    const ReadObj obj = read_obj(folder / "m.obj");
    const Points points = shown_points(shape, mesh.nodes);
    expect_positions(obj, points);
    std::vector<std::uint32_t> triangles, segments;
    std::size_t lines = 0;
    using Objects = std::vector<std::pair<std::string, std::size_t>>;
    EXPECT_EQ(obj.objects, (Objects{{"cells", 0}, {"edges", shape.triangles.size() / 3}}))
        << "some readers take an object with faces and lines for lines alone";
    for (const auto& [keyword, vertices] : obj.records) {
        if (keyword == "f") {
            ASSERT_EQ(vertices.size(), 3u);
            for (const auto v : vertices) triangles.push_back(static_cast<std::uint32_t>(v));
            continue;
        }
        EXPECT_EQ(keyword, "l");
        ++lines;
        for (std::size_t i = 1; i < vertices.size(); ++i)
            for (const auto v : {vertices[i - 1], vertices[i]})
                segments.push_back(static_cast<std::uint32_t>(v));
    }
    EXPECT_EQ(triangles, shape.triangles);
    EXPECT_EQ(segments, shape.segments);
    EXPECT_LE(lines, 48u) << "an edge is one line, or goes on with the next";

    OpenMesh::TriMesh_ArrayKernelT<> read;
    ASSERT_TRUE(OpenMesh::IO::read_mesh(read, (folder / "m.obj").string()));
    EXPECT_EQ(read.n_vertices(), shape.point_count);
    EXPECT_EQ(read.n_faces(), shape.triangle_cells.size());
    for (const auto v : read.vertices()) EXPECT_FALSE(v.is_boundary()) << "the sphere is closed";
}

TEST(Obj, ATessellationOfLinesIsOneObject) {
    const TemporaryFolder folder;
    const Mesh mesh = three_lines();
    write_obj(folder / "m.obj", tessellate_within(mesh, mesh.nodes, 1e-3), mesh.nodes);
    const ReadObj obj = read_obj(folder / "m.obj");
    ASSERT_EQ(obj.objects.size(), 1u);
    EXPECT_EQ(obj.objects[0].first, "edges");
}

TEST(Obj, IsIndependentOfTheLocale) {
    const TemporaryFolder folder;
    const Mesh mesh = unit_square_mesh(40);
    write_obj(folder / "plain.obj", mesh, moved(mesh));
    {
        const CommaLocale comma;
        write_obj(folder / "comma.obj", mesh, moved(mesh));
    }
    EXPECT_EQ(read_file(folder / "plain.obj"), read_file(folder / "comma.obj"));
}

TEST(Obj, RejectsNonFinitePositions) {
    const TemporaryFolder folder;
    const Mesh mesh = two_triangles();
    Points x = mesh.nodes;
    x.y[2] = std::nan("");
    EXPECT_THROW(write_obj(folder / "m.obj", mesh, x), InternalError);
    EXPECT_TRUE(folder.content().empty());
}

TEST(Formats, TheTableListsTheFilesOfEachFormat) {
    const TemporaryFolder folder;
    const auto mesh = std::make_shared<Mesh>(unit_square_mesh(4));
    Snapshot snapshot{.mesh = mesh, .x = moved(*mesh), .fields = {}, .report = {}, .version = 1};
    snapshot.fields.push_back({{.name = "monitor"}, mesh->nodes.x});
    const std::vector<StepReport> history(3);
    const Values view("view", view_rows());
    std::vector<std::string> expected;
    for (const auto& format : formats()) {
        if (format.splines_only) continue; // for other meshes; rejected before a run (formats_of)
        format.write(folder.path(), {snapshot, history, {}, view});
        expected.insert(expected.end(), format.files.begin(), format.files.end());
        std::sort(expected.begin(), expected.end());
        EXPECT_EQ(folder.content(), expected) << format.name;
        EXPECT_FALSE(format.help.empty());
    }
    EXPECT_EQ(expected, (std::vector<std::string>{
                            "adapted-curved.glb", "adapted-curved.obj", "adapted.csv", "adapted.glb",
                            "adapted.msh", "adapted.obj", "adapted.ply", "adapted.svg", "adapted.ugrid.nc",
                            "adapted.vtu", "computational-curved.obj", "computational.obj",
                            "computational.ugrid.nc", "equidistribution.svg", "figure.pdf", "residual.svg"}));
    expect_positions(read_obj(folder / "computational.obj"), mesh->nodes);
    expect_positions(read_obj(folder / "adapted.obj"), snapshot.x);
}

TEST(Formats, ListsAreParsedAndUnknownNamesReportedWithTheNearest) {
    const auto both = parse_formats("glb,obj,glb");
    ASSERT_EQ(both.size(), 2u);
    EXPECT_EQ(both[0]->name, "glb");
    EXPECT_EQ(both[1]->name, "obj");
    EXPECT_EQ(message_of<InputError>([] { parse_formats("obj,glbb"); }),
              "unknown format 'glbb' (did you mean 'glb'?); allowed: obj, glb, obj-curved, glb-curved, "
              "vtu, msh, ply, csv, ugrid, patch, svg, pdf");
    for (const char* wrong : {"", "obj,", ",obj", "obj glb", "OBJ"})
        EXPECT_THROW(parse_formats(wrong), InputError) << wrong;
}

} // namespace
} // namespace gaspard

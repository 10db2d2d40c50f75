// Surface meshes read from small files written here, from our own exports, and from bad files.
#include "core/base/error.hpp"
#include "core/io/formats.hpp"
#include "core/mesh/sphere_mesh.hpp"
#include "core/mesh/surface_mesh.hpp"
#include "core/mesh/surface_topology.hpp"
#include "support/comma_locale.hpp"
#include "support/messages.hpp"
#include "support/sample_snapshot.hpp"
#include "support/small_meshes.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <bit>
#include <cctype>
#include <fstream>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

using Numbers = std::vector<std::int32_t>;

class SurfaceMesh : public testing::Test {
  protected:
    std::filesystem::path write(const std::string& name, const std::string& bytes) const {
        std::ofstream(folder_ / name, std::ios::binary) << bytes;
        return folder_ / name;
    }
    Mesh read(const std::string& name, const std::string& bytes) const {
        return read_surface_mesh(write(name, bytes));
    }
    /// What is said of a bad file, without "cannot read FILE: ".
    std::string fault(const std::string& name, const std::string& bytes) const {
        return fault(write(name, bytes));
    }
    static std::string fault(const std::filesystem::path& file) {
        const std::string text = message_of<InputError>([&] { read_surface_mesh(file); });
        const std::string start = "cannot read " + file.string() + ": ";
        EXPECT_TRUE(text.starts_with(start)) << text;
        EXPECT_EQ(text.find('\n'), std::string::npos);
        return text.substr(std::min(start.size(), text.size()));
    }

    TemporaryFolder folder_;
};

constexpr CellKind triangle{CellShape::triangle, 1}, quadrilateral{CellShape::quadrilateral, 1};

TEST_F(SurfaceMesh, ReadsObjWithCommentsTexturesAndRelativeNumbers) {
    const Mesh mesh =
        read("m.OBJ", "# two squares\r\nmtllib /dev/zero\r\no name\r\nv 0.1 0 0\r\nv 1 0 0 0.5 0.5 0.5\r\n"
                      "v +1 1e0 0 # corner\r\nv 0 1 0\r\nvt 0 0\r\nvn 0 0 1\r\nusemtl none\r\n"
                      "f 1/1/1 2//1 3/1 4\r\n\r\n  v 2 0 0\r\nv 2 1 0\r\nf -5 -2 -1 -4\r\n");
    EXPECT_EQ(mesh.kind, quadrilateral);
    EXPECT_EQ(mesh.space_dimension, 2);
    EXPECT_EQ(mesh.cells, (Numbers{0, 1, 2, 3, 1, 4, 5, 2}));
    ASSERT_EQ(mesh.node_count(), 6u);
    EXPECT_EQ(mesh.nodes[0], (Vec3{0.1, 0, 0})); // in double precision
    EXPECT_EQ(mesh.nodes[2], (Vec3{1, 1, 0}));
}

TEST_F(SurfaceMesh, ReadsOffWithCommentsAndColours) {
    const std::string text = "OFF # comment\r\n# another\r\n4 2 0\r\n\r\n0.1 0 0\r\n1 0 0 255 0 0\r\n"
                             "1 1 -0.25\r\n0 1 0\r\n3 0 1 2 # face\r\n3 0 2 3 200 200 200\r\n";
    for (const std::string start : {"", "C"}) {
        const Mesh mesh = read("m.off", start + text);
        EXPECT_EQ(mesh.kind, triangle);
        EXPECT_EQ(mesh.space_dimension, 3);
        EXPECT_EQ(mesh.cells, (Numbers{0, 1, 2, 0, 2, 3}));
        EXPECT_EQ(mesh.nodes[0], (Vec3{0.1, 0, 0}));
        EXPECT_EQ(mesh.nodes[2], (Vec3{1, 1, -0.25}));
    }
    EXPECT_EQ(read("m.off", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2").cell_count(), 1u);
}

TEST_F(SurfaceMesh, CutsPolygonsIntoTriangles) {
    const Mesh mesh =
        read("m.off", "OFF\n6 2 0\n9 9 9\n0 0 0\n1 0 0\n2 1 0\n1 2 0\n0 1 0\n5 1 2 3 4 5\n3 3 2 0\n");
    EXPECT_EQ(mesh.kind, triangle);
    EXPECT_EQ(mesh.cells, (Numbers{1, 2, 3, 1, 3, 4, 1, 4, 5, 3, 2, 0}));
}

TEST_F(SurfaceMesh, LeavesOutVerticesWithoutAFace) {
    const Mesh mesh = read("m.obj", "v 7 7 7\nv 0 0 0\nv 1 0 0\nv 8 8 8\nv 0 1 0\nf 2 3 5\n");
    EXPECT_EQ(mesh.node_count(), 3u);
    EXPECT_EQ(mesh.cells, (Numbers{0, 1, 2}));
    EXPECT_EQ(mesh.nodes[2], (Vec3{0, 1, 0}));
    EXPECT_EQ(mesh.space_dimension, 2);
}

const std::string ply_text =
    "comment by hand\r\nelement material 1\r\nproperty float red\r\nelement vertex 4\r\n"
    "property double x\r\nproperty float64 y\r\nproperty float z\r\nproperty uchar red\r\n"
    "element face 2\r\nproperty uchar flag\r\nproperty list uchar uint vertex_index\r\n"
    "end_header\r\n";

TEST_F(SurfaceMesh, ReadsPlyAsText) {
    const Mesh mesh = read("m.ply", "ply\r\nformat ascii 1.0\r\n" + ply_text +
                                        "0.5\r\n0.1 0 0 255\r\n1 0 0 0\r\n1 1 0 0\r\n0 1 0 0\r\n"
                                        "1 3 0 1 2\r\n0 3 0 2 3\r\n");
    EXPECT_EQ(mesh.kind, triangle);
    EXPECT_EQ(mesh.cells, (Numbers{0, 1, 2, 0, 2, 3}));
    EXPECT_EQ(mesh.nodes[0], (Vec3{0.1, 0, 0}));
}

/// The bytes of a number, the highest first.
template <class Number>
std::string big_endian(Number number) {
    std::array<char, sizeof(Number)> bytes = std::bit_cast<std::array<char, sizeof(Number)>>(number);
    if constexpr (std::endian::native == std::endian::little) std::reverse(bytes.begin(), bytes.end());
    return {bytes.data(), bytes.size()};
}
template <class Number>
std::string little_endian_bytes(Number number) {
    std::string bytes = big_endian(number);
    std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

TEST_F(SurfaceMesh, ReadsPlyOfBothByteOrders) {
    for (const bool big : {false, true}) {
        const auto put = [&](auto number) { return big ? big_endian(number) : little_endian_bytes(number); };
        std::string body = put(0.5f);
        for (const Vec3 p : {Vec3{0.1, 0, 0}, {1, 0, 0}, {1, 1, 2}, {0, 1, 0}})
            body += put(p.x) + put(p.y) + put(static_cast<float>(p.z)) + '\n'; // a colour of 10
        for (const auto& face : {Numbers{0, 1, 2}, Numbers{0, 2, 3}}) {
            body += std::string("\0\3", 2);
            for (const auto v : face) body += put(v);
        }
        const Mesh mesh = read("m.ply", "ply\r\nformat binary_" + std::string(big ? "big" : "little") +
                                            "_endian 1.0\r\n" + ply_text + body);
        EXPECT_EQ(mesh.cells, (Numbers{0, 1, 2, 0, 2, 3}));
        EXPECT_EQ(mesh.nodes[0], (Vec3{0.1, 0, 0}));
        EXPECT_EQ(mesh.nodes[2], (Vec3{1, 1, 2}));
    }
}

const std::string stl_text =
    "solid two triangles\r\n facet normal 0 0 1\r\n  outer loop\r\n   vertex 0.1 0 0\r\n"
    "   vertex 1 0 -0.0\r\n   VERTEX 1 1 0\r\n  endloop\r\n endfacet\r\n"
    " facet normal 0 0 1\r\n  outer loop\r\n   vertex 1.0 0 0\r\n   vertex 2 0 0\r\n"
    "   vertex 1 1 0\r\n  endloop\r\n endfacet\r\nendsolid two triangles\r\n";

TEST_F(SurfaceMesh, ReadsStlAsTextAndWeldsItsCorners) {
    const Mesh mesh = read("m.stl", stl_text);
    EXPECT_EQ(mesh.kind, triangle);
    EXPECT_EQ(mesh.cells, (Numbers{0, 1, 2, 1, 3, 2})); // 0 and -0 are one
    EXPECT_EQ(mesh.nodes[0], (Vec3{0.1, 0, 0}));
    std::string capitals = stl_text;
    for (char& c : capitals) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    EXPECT_EQ(read("capitals.stl", capitals).cells, mesh.cells);
}

std::string binary_stl(const std::vector<std::array<Vec3, 3>>& triangles) {
    std::string bytes = "solid, yet binary";
    bytes.resize(80, ' ');
    bytes += little_endian_bytes(static_cast<std::uint32_t>(triangles.size()));
    for (const auto& corners : triangles) {
        bytes.append(12, '\0');
        for (const Vec3 p : corners)
            for (const double c : {p.x, p.y, p.z}) bytes += little_endian_bytes(static_cast<float>(c));
        bytes.append(2, '\0');
    }
    return bytes;
}

TEST_F(SurfaceMesh, ReadsBinaryStlAndWeldsExactly) {
    const Vec3 a{0, 0, 0}, b{1, 0, 0}, c{1, 1, 0}, d{0, 1, 0}, almost{1, 1 + 0x1p-23, 0};
    const Mesh mesh = read("m.stl", binary_stl({{a, b, c}, {a, c, d}, {a, a, b}})); // the last is degenerate
    EXPECT_EQ(mesh.cells, (Numbers{0, 1, 2, 0, 2, 3}));
    EXPECT_EQ(read("m.stl", binary_stl({{a, b, c}, {d, almost, {0, 2, 0}}})).node_count(), 6u);
}

TEST_F(SurfaceMesh, ReadsOurOwnObjAndPlyToTheLastDigit) {
    for (const Mesh& mesh :
         {two_triangles(), unit_square_mesh(3),
          straightened(sphere_mesh({.cells = SphereCells::cubed, .resolution = 2})),
          straightened(sphere_mesh({.cells = SphereCells::icosahedral, .resolution = 1}))}) {
        const Snapshot snapshot = sample_snapshot(mesh);
        write_obj(folder_ / "m.obj", mesh, snapshot.x);
        write_ply(folder_ / "m.ply", snapshot);
        for (const char* name : {"m.obj", "m.ply"}) {
            const Mesh back = read_surface_mesh(folder_ / name);
            EXPECT_EQ(back.kind, mesh.kind);
            EXPECT_EQ(back.cells, mesh.cells);
            EXPECT_EQ(back.space_dimension, mesh.space_dimension);
            EXPECT_EQ(back.nodes, snapshot.x);
            EXPECT_TRUE(SurfaceTopology(back).facts().empty());
        }
    }
}

TEST_F(SurfaceMesh, ReadsTheCornersOfOurCurvedCells) {
    const Mesh sphere = sphere_mesh({.cells = SphereCells::icosahedral, .resolution = 1}).quadratic;
    write_obj(folder_ / "m.obj", sphere, sphere.nodes);
    const Mesh back = read_surface_mesh(folder_ / "m.obj");
    EXPECT_EQ(back.kind, triangle);
    EXPECT_EQ(back.cell_count(), sphere.cell_count());
    EXPECT_EQ(SurfaceTopology(back).euler_characteristic(), 2);
}

TEST_F(SurfaceMesh, DoesNotFollowTheLocale) {
    const CommaLocale comma;
    std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
        "property double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
        "0.5 0 0\n1234.5 0 0\n0 1 0\n3 0 1 2\n";
    const std::string obj = "v 0.5 0 0\nv 1234.5 0 0\nv 0 1 0\nf 1 2 3\n";
    const std::string off = "OFF\n3 1 0\n0.5 0 0\n1234.5 0 0\n0 1 0\n3 0 1 2\n";
    const std::string stl =
        "solid\nfacet\nouter loop\nvertex 0.5 0 0\nvertex 1234.5 0 0\nvertex 0 1 0\nendloop\n"
        "endfacet\nendsolid\n";
    for (const auto& [name, bytes] :
         {std::pair("m.ply", ply), {"m.obj", obj}, {"m.off", off}, {"m.stl", stl}}) {
        const Mesh mesh = read(name, bytes);
        EXPECT_EQ(mesh.nodes.x, (std::vector<double>{0.5, 1234.5, 0})) << name;
    }
    EXPECT_EQ(fault("c.obj", "v 0,5 0 0\n"), "line 1: '0,5' is not a number");
}

TEST_F(SurfaceMesh, SaysWhatIsWrongWithTheFile) {
    EXPECT_EQ(fault(folder_ / "none.obj"), "No such file or directory");
    std::filesystem::create_directory(folder_ / "folder.obj");
    EXPECT_EQ(fault(folder_ / "folder.obj"), "Is a directory");
    std::filesystem::create_symlink("/dev/zero", folder_ / "zero.obj");
    EXPECT_EQ(fault(folder_ / "zero.obj"), "it is not a regular file");
    write("large.obj", "");
    std::filesystem::resize_file(folder_ / "large.obj", largest_surface_file + 1); // a sparse file
    EXPECT_EQ(fault(folder_ / "large.obj"), "it is larger than 1024 MiB");
    EXPECT_EQ(fault("m.obj", ""), "it is empty");
    EXPECT_EQ(fault("m.txt", "v 0 0 0\n"), "surface meshes are .obj, .off, .ply or .stl");
    EXPECT_EQ(fault("m.obj", "# nothing\n"), "it has no faces");
    EXPECT_EQ(fault("m.obj", std::string(1000, '\0')), "it has no faces");
}

TEST_F(SurfaceMesh, SaysWhatIsWrongWithObj) {
    const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    EXPECT_EQ(fault("m.obj", three + "f 1 2 4\n"), "face 1 names vertex 4, but there are 3 vertices");
    EXPECT_EQ(fault("m.obj", three + "f 1 2 3\nf 1 2 2\n"), "face 2 has vertex 2 twice");
    EXPECT_EQ(fault("m.obj", three + "f 1 2\n"), "face 1 has fewer than three corners");
    EXPECT_EQ(fault("m.obj", three + "f 0 1 2\n"),
              "line 4: vertices are counted from 1, or from -1 backwards");
    EXPECT_EQ(fault("m.obj", three + "f -4 1 2\n"), "line 4: vertex -4 lies before the first one");
    EXPECT_EQ(fault("m.obj", three + "f 1 2 x\n"), "line 4: 'x' is not a number");
    EXPECT_EQ(fault("m.obj", three + "f 1 2 99999999999\n"), "line 4: '99999999999' is out of range");
    EXPECT_EQ(fault("m.obj", "v 0 0\n"), "line 1: a number is missing");
    EXPECT_EQ(fault("m.obj", "v 0 nan 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
              "vertex 1 has a coordinate that is not finite");
    EXPECT_EQ(fault("m.obj", "v 0 1e999 0\n"), "line 1: '1e999' is out of range");
}

TEST_F(SurfaceMesh, SaysWhatIsWrongWithOff) {
    EXPECT_EQ(fault("m.off", "ply\n"), "line 1: an OFF file begins with OFF");
    EXPECT_EQ(fault("m.off", "OFF\n"), "line 1: a number is missing");
    EXPECT_EQ(fault("m.off", "OFF\n4000000000 1 0\n0 0 0\n"), "it ends after 1 of 4000000000 vertices");
    EXPECT_EQ(fault("m.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), "it ends after 1 of 2 faces");
    EXPECT_EQ(fault("m.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n"),
              "line 6: a number is missing");
    EXPECT_EQ(fault("m.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n"),
              "face 0 names vertex -1, but there are 3 vertices");
}

TEST_F(SurfaceMesh, SaysWhatIsWrongWithPly) {
    const std::string vertex = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
    const std::string face = "element face 1\nproperty list uchar int vertex_indices\n";
    const std::string text = "ply\nformat ascii 1.0\n", points = "0 0 0 1 0 0 0 1 0\n";
    EXPECT_EQ(fault("m.ply", "OFF\n"), "a PLY file begins with ply");
    EXPECT_EQ(fault("m.ply", text + vertex), "its header does not end");
    EXPECT_EQ(fault("m.ply", "ply\nformat odd 1.0\n"), "line 2: 'odd' is no encoding of PLY");
    EXPECT_EQ(fault("m.ply", text + "element vertex 3\nproperty real x\n"),
              "line 4: 'real' is no type of PLY");
    EXPECT_EQ(fault("m.ply", text + vertex + "end_header\n" + points), "it has no faces");
    EXPECT_EQ(fault("m.ply", text + vertex + face + "end_header\n0 0 0 1\n"), "it ends too early");
    EXPECT_EQ(fault("m.ply", text + "element vertex 4000000000\nproperty float x\nend_header\n"),
              "its vertices lack x, y or z");
    EXPECT_EQ(fault("m.ply", text + "element nothing 4000000000000\nend_header\n"), "it has no faces");
    EXPECT_EQ(fault("m.ply", text + vertex + "element face 1\nproperty int a\nend_header\n" + points),
              "its faces lack a list vertex_indices");
    EXPECT_EQ(fault("m.ply", text + vertex + face + "end_header\n" + points + "-1"),
              "a list has an impossible length");
    EXPECT_EQ(fault("m.ply", text + vertex + face + "end_header\n" + points + "3 0 1 1.5"),
              "a face has a vertex number that is no integer of 32 bits");
    EXPECT_EQ(fault("m.ply", text + vertex + face + "end_header\n" + points + "3 0 1 3"),
              "face 0 names vertex 3, but there are 3 vertices");
    EXPECT_EQ(fault("m.ply", "ply\nformat binary_little_endian 1.0\n" + vertex + face + "end_header\nshort"),
              "it ends too early");
}

TEST_F(SurfaceMesh, SaysWhatIsWrongWithStl) {
    EXPECT_EQ(fault("m.stl", "Not a mesh"),
              "it is neither a text STL file, which begins with solid, nor a binary one of the size that its "
              "number of triangles gives");
    std::string cut = binary_stl({{Vec3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
    cut[0] = 'S';
    cut.pop_back();
    EXPECT_TRUE(fault("m.stl", cut).starts_with("it is neither a text STL file"));
    EXPECT_EQ(fault("m.stl", stl_text.substr(0, stl_text.find("endsolid"))), "it ends before endsolid");
    EXPECT_EQ(fault("m.stl", "solid\nfacet\nouter loop\nvertex 0 0 0\nendloop\n"),
              "line 5: a facet has 1 corners, not 3");
    EXPECT_EQ(fault("m.stl", "solid\nhello\n"), "line 2: 'hello' is no keyword of STL");
    EXPECT_EQ(fault("m.stl", "solid\nendsolid\n"), "it has no faces");
}

TEST_F(SurfaceMesh, NamesWhatIsNotAManifold) {
    EXPECT_EQ(fault("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nf 1 2 3\nf 2 1 4\nf 1 2 5\n"),
              "its surface is not a manifold: edge 1-2 has three faces");
    EXPECT_EQ(fault("m.off", "OFF\n5 2 0\n0 0 0\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n3 0 1 2\n3 0 3 4\n"),
              "its surface is not a manifold: vertex 0 joins 2 fans of faces");
}

TEST_F(SurfaceMesh, KeepsFacesOfOppositeOrientations) {
    const Mesh mesh = read("m.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 4 3\n");
    EXPECT_EQ(mesh.cells, (Numbers{0, 1, 2, 0, 3, 2}));
    EXPECT_EQ(SurfaceTopology(mesh).reversed_faces(), (Numbers{1}));
}

TEST_F(SurfaceMesh, SurvivesWhateverIsCutOff) {
    const Snapshot snapshot = sample_snapshot(two_triangles());
    write_ply(folder_ / "whole.ply", snapshot);
    std::ifstream stream(folder_ / "whole.ply", std::ios::binary);
    const std::string whole((std::istreambuf_iterator<char>(stream)), {});
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_FALSE(fault("cut.ply", whole.substr(0, size)).empty());
    for (std::size_t size = 0; size < stl_text.find("endsolid") + 8; ++size)
        EXPECT_FALSE(fault("cut.stl", stl_text.substr(0, size)).empty());
}

} // namespace
} // namespace gaspard

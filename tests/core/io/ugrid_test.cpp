// UGRID files read back by the NetCDF library, numbers bit by bit. Programs that open them are tested by
// hand (docs/formats.md).
#include "core/base/error.hpp"
#include "core/base/read_file.hpp"
#include "core/base/version.hpp"
#include "core/io/formats.hpp"
#include "core/scenario/view_rows.hpp"
#include "core/tessellate/cell_geometry.hpp"
#include "fixtures/fixture_meshes.hpp"
#include "support/comma_locale.hpp"
#include "support/sample_snapshot.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <netcdf.h>
#include <numbers>
#include <sstream>
#include <thread>

namespace gaspard {
namespace {

void expect(int status) { ASSERT_EQ(status, NC_NOERR) << nc_strerror(status); }

class ReadNetcdf {
  public:
    explicit ReadNetcdf(const std::filesystem::path& file) {
        expect(nc_open(file.c_str(), NC_NOWRITE, &id_));
    }
    ~ReadNetcdf() { nc_close(id_); }
    ReadNetcdf(const ReadNetcdf&) = delete;
    ReadNetcdf& operator=(const ReadNetcdf&) = delete;

    bool has(const std::string& variable) const {
        int id = 0;
        return nc_inq_varid(id_, variable.c_str(), &id) == NC_NOERR;
    }
    /// An attribute of a variable, or of the file if the name is empty.
    std::string text(const std::string& variable, const std::string& attribute) const {
        std::size_t length = 0;
        if (nc_inq_attlen(id_, number(variable), attribute.c_str(), &length) != NC_NOERR) return "none";
        std::string value(length, '\0');
        expect(nc_get_att_text(id_, number(variable), attribute.c_str(), value.data()));
        return value;
    }
    int integer(const std::string& variable, const std::string& attribute) const {
        int value = std::numeric_limits<int>::min();
        expect(nc_get_att_int(id_, number(variable), attribute.c_str(), &value));
        return value;
    }
    /// Names and lengths: "face 96, face_corner 4".
    std::string dimensions(const std::string& variable) const {
        int count = 0, ids[NC_MAX_VAR_DIMS]{};
        expect(nc_inq_var(id_, number(variable), nullptr, nullptr, &count, ids, nullptr));
        std::string names;
        for (int i = 0; i < count; ++i) {
            char name[NC_MAX_NAME + 1] = {};
            std::size_t length = 0;
            expect(nc_inq_dim(id_, ids[i], name, &length));
            names += (i > 0 ? ", " : "") + std::string(name) + ' ' + std::to_string(length);
        }
        return names;
    }
    std::vector<double> reals(const std::string& variable) const {
        EXPECT_EQ(type(variable), NC_DOUBLE) << variable;
        std::vector<double> values(size(variable));
        expect(nc_get_var_double(id_, number(variable), values.data()));
        return values;
    }
    std::vector<std::int32_t> integers(const std::string& variable) const {
        EXPECT_EQ(type(variable), NC_INT) << variable;
        std::vector<std::int32_t> values(size(variable));
        expect(nc_get_var_int(id_, number(variable), values.data()));
        return values;
    }

  private:
    int number(const std::string& variable) const {
        int id = NC_GLOBAL;
        if (!variable.empty()) {
            EXPECT_EQ(nc_inq_varid(id_, variable.c_str(), &id), NC_NOERR) << variable;
        }
        return id;
    }
    nc_type type(const std::string& variable) const {
        nc_type found = NC_NAT;
        expect(nc_inq_vartype(id_, number(variable), &found));
        return found;
    }
    std::size_t size(const std::string& variable) const {
        int count = 0, ids[NC_MAX_VAR_DIMS]{};
        expect(nc_inq_var(id_, number(variable), nullptr, nullptr, &count, ids, nullptr));
        std::size_t all = 1;
        for (int i = 0; i < count; ++i) {
            std::size_t length = 0;
            expect(nc_inq_dimlen(id_, ids[i], &length));
            all *= length;
        }
        return all;
    }

    int id_ = -1;
};

/// The nodes that are corners, ascending, and the index of each among them.
std::map<std::int32_t, std::int32_t> corner_places(const Mesh& mesh) {
    std::map<std::int32_t, std::int32_t> places;
    for (std::size_t c = 0; c < mesh.cell_count(); ++c)
        for (int k = 0; k < corners_per_cell(mesh.kind); ++k)
            places[mesh.cell(c)[static_cast<std::size_t>(k)]] = 0;
    std::int32_t next = 0;
    for (auto& [node, place] : places) place = next++;
    return places;
}

std::vector<double> at_corners(const Mesh& mesh, const std::vector<double>& values) {
    std::vector<double> found;
    for (const auto& [node, place] : corner_places(mesh))
        found.push_back(values[static_cast<std::size_t>(node)]);
    return found;
}

std::string cell_word(CellKind kind) {
    return cell_dimension(kind) == 1 ? "edge" : cell_dimension(kind) == 2 ? "face" : "volume";
}

std::string coordinate_names(const std::string& place, int dimension) {
    std::string names = "mesh_" + place + "_x mesh_" + place + "_y";
    if (dimension > 2) names += " mesh_" + place + "_z";
    return names;
}

class UgridTest : public testing::TestWithParam<std::size_t> {
  protected:
    UgridTest() { write_ugrid(file_, snapshot_, snapshot_.x, "a title"); }
    TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "adapted.ugrid.nc";
    Snapshot snapshot_ = sample_snapshot(meshes_of_every_kind()[GetParam()]);
    const Mesh& mesh_ = *snapshot_.mesh;
    std::string word_ = cell_word(mesh_.kind);
};
INSTANTIATE_TEST_SUITE_P(Kinds, UgridTest, testing::Range<std::size_t>(0, 8),
                         [](const auto& mesh) { return kind_name(meshes_of_every_kind()[mesh.param].kind); });

TEST_P(UgridTest, DescribesItsTopology) {
    const ReadNetcdf file(file_);
    EXPECT_EQ(file.text("", "Conventions"), "CF-1.8 UGRID-1.0");
    EXPECT_EQ(file.text("", "title"), "a title");
    EXPECT_EQ(file.text("", "source"), "Gaspard " + std::string(version()));
    EXPECT_EQ(file.text("mesh", "cf_role"), "mesh_topology");
    EXPECT_EQ(file.text("mesh", "long_name"), "a title");
    EXPECT_EQ(file.dimensions("mesh"), "");
    EXPECT_EQ(file.integer("mesh", "topology_dimension"), cell_dimension(mesh_.kind));
    EXPECT_EQ(file.text("mesh", "node_coordinates"), coordinate_names("node", mesh_.space_dimension));
    EXPECT_EQ(file.text("mesh", word_ + "_coordinates"), coordinate_names(word_, mesh_.space_dimension));
    EXPECT_EQ(file.text("mesh", word_ + "_node_connectivity"), "mesh_" + word_ + "_nodes");
    EXPECT_EQ(file.text("mesh", "volume_shape_type"), word_ == "volume" ? "mesh_volume_shapes" : "none");
}

TEST_P(UgridTest, CellsListTheirCorners) {
    const ReadNetcdf file(file_);
    const std::string name = "mesh_" + word_ + "_nodes";
    EXPECT_EQ(file.text(name, "cf_role"), word_ + "_node_connectivity");
    EXPECT_EQ(file.integer(name, "start_index"), 0);
    EXPECT_EQ(file.text(name, "_FillValue"), "none") << "all cells have as many corners";
    EXPECT_EQ(file.dimensions(name), word_ + ' ' + std::to_string(mesh_.cell_count()) + ", " + word_ +
                                         "_corner " + std::to_string(corners_per_cell(mesh_.kind)));
    const auto places = corner_places(mesh_);
    std::vector<std::int32_t> expected;
    for (std::size_t c = 0; c < mesh_.cell_count(); ++c)
        for (int k = 0; k < corners_per_cell(mesh_.kind); ++k)
            expected.push_back(places.at(mesh_.cell(c)[static_cast<std::size_t>(k)]));
    EXPECT_EQ(file.integers(name), expected);
}

TEST_P(UgridTest, HoldsCornersAndFieldsToTheLastBit) {
    const ReadNetcdf file(file_);
    const std::string nodes = "node " + std::to_string(corner_places(mesh_).size());
    const std::string cells = word_ + ' ' + std::to_string(mesh_.cell_count());
    for (const auto& [name, values] :
         {std::pair("x", &Points::x), std::pair("y", &Points::y), std::pair("z", &Points::z)}) {
        const std::string variable = std::string("mesh_node_") + name;
        ASSERT_EQ(file.has(variable), name[0] != 'z' || mesh_.space_dimension == 3);
        if (!file.has(variable)) continue;
        EXPECT_EQ(file.dimensions(variable), nodes);
        EXPECT_EQ(file.reals(variable), at_corners(mesh_, snapshot_.x.*values));
        EXPECT_EQ(file.text(variable, "units"), "1");
    }
    EXPECT_EQ(file.dimensions("monitor"), nodes);
    EXPECT_EQ(file.reals("monitor"), at_corners(mesh_, snapshot_.field("monitor")->values));
    EXPECT_EQ(file.dimensions("jacobian"), cells);
    EXPECT_EQ(file.reals("jacobian"), snapshot_.field("jacobian")->values);
    EXPECT_EQ(file.reals("measure"), CellGeometry(snapshot_.mesh).measures(snapshot_.x));
    for (const std::string field : {"monitor", "jacobian", "measure"}) {
        const std::string place = field == "monitor" ? "node" : word_;
        EXPECT_EQ(file.text(field, "mesh"), "mesh");
        EXPECT_EQ(file.text(field, "location"), place);
        EXPECT_EQ(file.text(field, "coordinates"), coordinate_names(place, mesh_.space_dimension));
        EXPECT_EQ(file.text(field, "units"), "1");
        EXPECT_EQ(file.text(field, "long_name"), field);
    }
}

TEST_P(UgridTest, CellCoordinatesAreTheMeansOfTheCorners) {
    const ReadNetcdf file(file_);
    const auto x = file.reals("mesh_" + word_ + "_x");
    const auto corners = static_cast<std::size_t>(corners_per_cell(mesh_.kind));
    for (std::size_t c = 0; c < mesh_.cell_count(); ++c) {
        double sum = 0;
        for (std::size_t k = 0; k < corners; ++k)
            sum += snapshot_.x.x[static_cast<std::size_t>(mesh_.cell(c)[k])];
        EXPECT_DOUBLE_EQ(x[c], sum / static_cast<double>(corners));
    }
}

Snapshot sphere_snapshot(Mesh mesh, double radius) {
    for (auto* values : {&mesh.nodes.x, &mesh.nodes.y, &mesh.nodes.z})
        for (double& value : *values) value *= radius;
    Snapshot snapshot = sample_snapshot(std::move(mesh));
    snapshot.x = snapshot.mesh->nodes;
    return snapshot;
}

TEST(Ugrid, WritesLongitudeAndLatitudeOnASphere) {
    const TemporaryFolder folder;
    for (const double radius : {1.0, 6371.0})
        for (const Mesh& mesh : {cubed_sphere_mesh(3), round_octahedron()}) {
            const Snapshot snapshot = sphere_snapshot(mesh, radius);
            write_ugrid(folder / "m.nc", snapshot, snapshot.x, "sphere");
            const ReadNetcdf file(folder / "m.nc");
            EXPECT_EQ(file.text("mesh", "node_coordinates"), "mesh_node_lon mesh_node_lat");
            EXPECT_EQ(file.text("mesh", "face_coordinates"), "mesh_face_lon mesh_face_lat");
            for (const std::string place : {"node", "face"}) {
                EXPECT_EQ(file.text("mesh_" + place + "_lon", "standard_name"), "longitude");
                EXPECT_EQ(file.text("mesh_" + place + "_lon", "units"), "degrees_east");
                EXPECT_EQ(file.text("mesh_" + place + "_lat", "standard_name"), "latitude");
                EXPECT_EQ(file.text("mesh_" + place + "_lat", "units"), "degrees_north");
            }
            const auto longitude = file.reals("mesh_node_lon"), latitude = file.reals("mesh_node_lat");
            const auto x = file.reals("mesh_node_x"), y = file.reals("mesh_node_y"),
                       z = file.reals("mesh_node_z");
            EXPECT_EQ(x, at_corners(*snapshot.mesh, snapshot.x.x));
            EXPECT_EQ(y, at_corners(*snapshot.mesh, snapshot.x.y));
            EXPECT_EQ(z, at_corners(*snapshot.mesh, snapshot.x.z));
            EXPECT_EQ(file.text("mesh_node_z", "long_name"), "Cartesian z");
            EXPECT_EQ(file.text("mesh_node_z", "coordinates"), "mesh_node_lon mesh_node_lat");
            for (std::size_t i = 0; i < x.size(); ++i) {
                const double a = longitude[i] / 180 * std::numbers::pi,
                             b = latitude[i] / 180 * std::numbers::pi;
                EXPECT_NEAR(radius * std::cos(a) * std::cos(b), x[i], 1e-14 * radius);
                EXPECT_NEAR(radius * std::sin(a) * std::cos(b), y[i], 1e-14 * radius);
                EXPECT_NEAR(radius * std::sin(b), z[i], 1e-14 * radius);
            }
        }
}

TEST(Ugrid, PolesAndAxesHaveExactAngles) {
    const TemporaryFolder folder;
    const Snapshot snapshot = sphere_snapshot(round_octahedron(), 1); // its corners lie on the axes
    write_ugrid(folder / "m.nc", snapshot, snapshot.x, "sphere");
    const ReadNetcdf file(folder / "m.nc");
    const auto longitude = file.reals("mesh_node_lon"), latitude = file.reals("mesh_node_lat");
    ASSERT_EQ(longitude.size(), 6u);
    std::map<std::pair<double, double>, int> found;
    for (std::size_t i = 0; i < 6; ++i) ++found[{longitude[i], latitude[i]}];
    const std::map<std::pair<double, double>, int> expected = {{{0, 0}, 1},   {{90, 0}, 1}, {{180, 0}, 1},
                                                               {{-90, 0}, 1}, {{0, 90}, 1}, {{0, -90}, 1}};
    EXPECT_EQ(found, expected);
    for (const double value : file.reals("mesh_face_lat"))
        EXPECT_NEAR(std::abs(value), std::asin(1 / std::sqrt(3.0)) * 180 / std::numbers::pi, 1e-12);
}

TEST(Ugrid, OtherSurfacesHaveThreeCoordinates) {
    const TemporaryFolder folder;
    Mesh mesh = cubed_sphere_mesh(2);
    mesh.nodes.set(3, 1.001 * mesh.nodes[3]);
    const Snapshot snapshot = sphere_snapshot(mesh, 1);
    write_ugrid(folder / "m.nc", snapshot, snapshot.x, "no sphere");
    const ReadNetcdf file(folder / "m.nc");
    EXPECT_EQ(file.text("mesh", "node_coordinates"), "mesh_node_x mesh_node_y mesh_node_z");
    EXPECT_FALSE(file.has("mesh_node_lon"));
}

TEST(Ugrid, ASphereIsRecognisedByXiAlone) {
    const TemporaryFolder folder;
    Snapshot snapshot = sphere_snapshot(round_octahedron(), 1);
    for (double& z : snapshot.x.z)
        if (z == 1) z = 1.25; // the north pole
    write_ugrid(folder / "m.nc", snapshot, snapshot.x, "blown up");
    const ReadNetcdf file(folder / "m.nc");
    const auto latitude = file.reals("mesh_node_lat"), z = file.reals("mesh_node_z");
    EXPECT_EQ(*std::max_element(latitude.begin(), latitude.end()), 90);
    EXPECT_EQ(*std::max_element(z.begin(), z.end()), 1.25);
}

TEST(Ugrid, TheComputationalMeshHasTheSameFormat) {
    const TemporaryFolder folder;
    const Snapshot snapshot = sample_snapshot(unit_square_mesh(3));
    const std::vector<StepReport> history(1);
    const Values view("view", view_rows());
    parse_formats("ugrid").front()->write(folder.path(), {snapshot, history, {}, view});
    EXPECT_EQ(folder.content(), (std::vector<std::string>{"adapted.ugrid.nc", "computational.ugrid.nc"}));
    const ReadNetcdf before(folder / "computational.ugrid.nc"), after(folder / "adapted.ugrid.nc");
    EXPECT_EQ(before.text("", "title"), "computational mesh");
    EXPECT_EQ(after.text("", "title"), "adapted mesh");
    EXPECT_EQ(before.reals("mesh_node_x"), snapshot.mesh->nodes.x);
    EXPECT_EQ(after.reals("mesh_node_x"), snapshot.x.x);
    EXPECT_EQ(before.integers("mesh_face_nodes"), after.integers("mesh_face_nodes"));
    EXPECT_EQ(before.reals("monitor"), after.reals("monitor"));
    for (const double area : before.reals("measure")) EXPECT_NEAR(area, 1.0 / 9, 1e-15);
}

TEST(Ugrid, BytesDependOnTheInputAlone) {
    const TemporaryFolder folder;
    const Snapshot snapshot = sample_snapshot(unit_square_mesh(20));
    write_ugrid(folder / "plain.nc", snapshot, snapshot.x, "t");
    {
        const CommaLocale comma;
        write_ugrid(folder / "comma.nc", snapshot, snapshot.x, "t");
    }
    EXPECT_EQ(read_file(folder / "plain.nc"), read_file(folder / "comma.nc"));
}

TEST(Ugrid, IsThreadSafe) {
    const TemporaryFolder folder;
    const Snapshot snapshot = sample_snapshot(unit_square_mesh(8));
    write_ugrid(folder / "alone.nc", snapshot, snapshot.x, "t");
    {
        std::vector<std::jthread> threads;
        for (int i = 0; i < 4; ++i)
            threads.emplace_back([&, i] {
                for (int k = 0; k < 5; ++k)
                    write_ugrid(folder / (std::to_string(i) + ".nc"), snapshot, snapshot.x, "t");
            });
    }
    for (int i = 0; i < 4; ++i)
        EXPECT_EQ(read_file(folder / (std::to_string(i) + ".nc")), read_file(folder / "alone.nc"));
}

TEST(Ugrid, RejectsNonFiniteValuesAndWritesNothing) {
    const TemporaryFolder folder;
    Snapshot position = sample_snapshot(two_triangles()), field = position;
    position.x.x[2] = std::numeric_limits<double>::quiet_NaN();
    field.fields[0].values[1] = std::numeric_limits<double>::infinity();
    for (const Snapshot& snapshot : {position, field})
        EXPECT_THROW(write_ugrid(folder / "m.nc", snapshot, snapshot.x, "t"), InternalError);
    EXPECT_TRUE(folder.content().empty());
}

TEST(Ugrid, AMissingFolderIsAMachineError) {
    const TemporaryFolder folder;
    const Snapshot snapshot = sample_snapshot(two_triangles());
    EXPECT_THROW(write_ugrid(folder / "gone" / "m.nc", snapshot, snapshot.x, "t"), MachineError);
}

} // namespace
} // namespace gaspard

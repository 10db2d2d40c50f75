// *.ugrid.nc: corners and straight edges of a mesh in NetCDF by the UGRID 1.0 (ugrid-conventions.github.io)
// and CF conventions, as climate and ocean codes read them. On a sphere the coordinates are
//
//   longitude = atan2(y, x),   latitude = atan2(z, sqrt(x^2 + y^2)),   in degrees,
//
// with x, y, z as additional fields; otherwise x, y and, in space, z (y = 0 on an interval, since readers
// expect two coordinates).
#include "core/base/check.hpp"
#include "core/base/version.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/facets.hpp"
#include "core/io/formats.hpp"
#include "core/io/netcdf_file.hpp"
#include "core/mesh/number_anew.hpp"
#include "core/tessellate/cell_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gaspard {

namespace {

/// UGRID's word for cells of a dimension.
std::string cell_word(int dimension) { return dimension == 1 ? "edge" : dimension == 2 ? "face" : "volume"; }

struct CoordinateVariable {
    std::string name; ///< "lon"
    std::vector<double> values;
    std::vector<NetcdfAttribute> attributes;
};

CoordinateVariable angle(const std::string& name, const std::string& standard_name, const std::string& unit) {
    return {name, {}, {{"standard_name", standard_name}, {"units", unit}}};
}

std::vector<CoordinateVariable> longitude_latitude(const Points& points) {
    CoordinateVariable longitude = angle("lon", "longitude", "degrees_east"),
                       latitude = angle("lat", "latitude", "degrees_north");
    constexpr double degrees = 180 / std::numbers::pi;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3 p = points[i];
        longitude.values.push_back(std::atan2(p.y, p.x) * degrees);
        latitude.values.push_back(std::atan2(p.z, std::hypot(p.x, p.y)) * degrees);
    }
    return {longitude, latitude};
}

std::vector<CoordinateVariable> cartesian(const Points& points, int dimension) {
    std::vector<CoordinateVariable> all = {{"x", points.x, {{"units", "1"}, {"axis", "X"}}},
                                           {"y", points.y, {{"units", "1"}, {"axis", "Y"}}},
                                           {"z", points.z, {{"units", "1"}, {"axis", "Z"}}}};
    all.resize(static_cast<std::size_t>(dimension));
    return all;
}

Points chosen(const Points& points, const std::vector<std::size_t>& nodes) {
    Points found(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) found.set(i, points[nodes[i]]);
    return found;
}

/// The mean of each cell's corners.
Points centres(const Points& corners, const std::vector<std::int32_t>& cells, std::size_t each) {
    Points found(cells.size() / each);
    for (std::size_t c = 0; c < found.size(); ++c) {
        Vec3 sum;
        for (std::size_t k = 0; k < each; ++k)
            sum = sum + corners[static_cast<std::size_t>(cells[c * each + k])];
        found.set(c, (1.0 / static_cast<double>(each)) * sum);
    }
    return found;
}

class UgridMaker {
  public:
    UgridMaker(const Snapshot& snapshot, const Points& x)
        : snapshot_(snapshot), mesh_(*snapshot.mesh), x_(x), word_(cell_word(cell_dimension(mesh_.kind))),
          sphere_(radius_of_ball(mesh_) > 0), cells_(corners_of_cells(mesh_)),
          nodes_(number_anew(cells_, mesh_.node_count())) {}

    NetcdfFile make(const std::string& title) {
        const auto corners = static_cast<std::size_t>(corners_per_cell(mesh_.kind));
        file_.dimensions = {
            {"node", nodes_.size()}, {word_, mesh_.cell_count()}, {word_ + "_corner", corners}};
        const Points at_nodes = chosen(x_, nodes_), at_cells = centres(at_nodes, cells_, corners);
        file_.variables.push_back({"mesh", {}, std::vector<std::int32_t>{0}, {}});
        const std::string node_coordinates = add_coordinates("node", at_nodes);
        const std::string cell_coordinates = add_coordinates(word_, at_cells);
        file_.variables.front().attributes = topology(title, node_coordinates, cell_coordinates);
        add_connectivity();
        if (sphere_)
            for (const auto& coordinate : cartesian(at_nodes, 3))
                add_field("mesh_node_" + coordinate.name, "node", coordinate.values, "1", node_coordinates,
                          "Cartesian " + coordinate.name);
        for (const Field& field : snapshot_.fields) {
            const bool of_nodes = field.place == FieldPlace::node;
            add_field(field.name, of_nodes ? "node" : word_,
                      of_nodes ? at_corners(field.values) : field.values,
                      field.unit.empty() ? "1" : field.unit, of_nodes ? node_coordinates : cell_coordinates);
        }
        add_field("measure", word_, CellGeometry(snapshot_.mesh).measures(x_), "1", cell_coordinates);
        file_.attributes = {{"Conventions", "CF-1.8 UGRID-1.0"},
                            {"title", title},
                            {"source", "Gaspard " + std::string(version())}};
        return std::move(file_);
    }

  private:
    std::vector<NetcdfAttribute> topology(const std::string& title, const std::string& node_coordinates,
                                          const std::string& cell_coordinates) const {
        const int dimension = cell_dimension(mesh_.kind);
        std::vector<NetcdfAttribute> attributes = {
            {"cf_role", "mesh_topology"},
            {"long_name", title},
            {"topology_dimension", static_cast<std::int32_t>(dimension)},
            {"node_coordinates", node_coordinates},
            {word_ + "_node_connectivity", "mesh_" + word_ + "_nodes"},
            {word_ + "_coordinates", cell_coordinates}};
        if (dimension > 1) attributes.push_back({word_ + "_dimension", word_});
        if (dimension == 3) attributes.push_back({"volume_shape_type", "mesh_volume_shapes"});
        return attributes;
    }

    /// Returns their names, separated by spaces.
    std::string add_coordinates(const std::string& place, const Points& points) {
        std::string names;
        for (auto& coordinate :
             sphere_ ? longitude_latitude(points) : cartesian(points, std::max(2, mesh_.space_dimension))) {
            const std::string name = "mesh_" + place + '_' + coordinate.name;
            names += (names.empty() ? "" : " ") + name;
            add_reals(name, place, coordinate.values, coordinate.attributes);
        }
        return names;
    }

    void add_connectivity() {
        file_.variables.push_back({"mesh_" + word_ + "_nodes",
                                   {word_, word_ + "_corner"},
                                   cells_,
                                   {{"cf_role", word_ + "_node_connectivity"},
                                    {"long_name", "corners of each cell"},
                                    {"start_index", std::int32_t{0}}}});
        if (cell_dimension(mesh_.kind) == 3)
            file_.variables.push_back({"mesh_volume_shapes",
                                       {word_},
                                       std::vector<std::int32_t>(mesh_.cell_count(), 0),
                                       {{"cf_role", "volume_shape_type"},
                                        {"flag_values", std::int32_t{0}},
                                        {"flag_meanings", "hexahedron"}}});
    }

    void add_field(const std::string& name, const std::string& place, const std::vector<double>& values,
                   const std::string& unit, const std::string& coordinates,
                   const std::string& long_name = {}) {
        add_reals(name, place, values,
                  {{"long_name", long_name.empty() ? name : long_name},
                   {"units", unit},
                   {"mesh", "mesh"},
                   {"location", place},
                   {"coordinates", coordinates}});
    }

    void add_reals(const std::string& name, const std::string& place, const std::vector<double>& values,
                   std::vector<NetcdfAttribute> attributes) {
        GASPARD_CHECK(std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }));
        file_.variables.push_back({name, {place}, values, std::move(attributes)});
    }

    std::vector<double> at_corners(const std::vector<double>& values) const {
        std::vector<double> found;
        for (const std::size_t node : nodes_) found.push_back(values[node]);
        return found;
    }

    const Snapshot& snapshot_;
    const Mesh& mesh_;
    const Points& x_;
    std::string word_; ///< UGRID's word for the cells; also the name of their dimension
    bool sphere_;
    std::vector<std::int32_t> cells_; ///< corners as indices into nodes_
    std::vector<std::size_t> nodes_;  ///< the nodes that are corners
    NetcdfFile file_;
};

} // namespace

void write_ugrid(const std::filesystem::path& file, const Snapshot& snapshot, const Points& positions,
                 const std::string& title) {
    GASPARD_CHECK(positions.size() == snapshot.mesh->node_count());
    write_atomically(file, netcdf_bytes(UgridMaker(snapshot, positions).make(title)));
}

} // namespace gaspard

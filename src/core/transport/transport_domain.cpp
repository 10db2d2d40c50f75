#include "core/transport/transport_domain.hpp"

#include "core/base/eigenvalues.hpp"
#include "core/base/error.hpp"
#include "core/transport/convex_shape.hpp"
#include "core/transport/ring_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <utility>

namespace gaspard {

namespace {

/// The places of the nodes of a triangle of order 2, as the mesh numbers them.
constexpr std::array<std::array<double, 2>, 6> quadratic_nodes = {
    {{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}}};

/// What identifies the source: the values of its shape.
std::string name_of_source(const Values& values) {
    std::string name;
    for (const ParameterRow& row : values.rows()) {
        const bool of_mesh = row.key == "cells" || row.key == "degree" || row.key == "edges";
        if (of_mesh || row.key.starts_with(target_prefix)) continue;
        name += (name.empty() ? "" : " ") + format_value(values.at(row.key));
    }
    return name;
}

/// The mesh of domain.file, or why there is none.
struct SourceContent {
    std::shared_ptr<const SourceMesh> mesh{};
    std::exception_ptr error{};
};

bool is_from_file(const Values& values) { return values.text("shape") == shape_of_file; }

DomainContent read_content(const Values& values, const std::filesystem::path& folder) {
    auto content = std::make_shared<SourceContent>();
    if (!is_from_file(values)) return content;
    try {
        content->mesh = std::make_shared<const SourceMesh>(read_source_mesh(values.text("file"), folder));
    } catch (const std::exception&) {
        content->error = std::current_exception();
    }
    return content;
}

Space space_of(const Box& box) {
    return {.dimension = 2, .box = box, .middle = box.centre(), .reach = {box}};
}

Space space_of_curve(const Values& values, const std::string& prefix) {
    try {
        return space_of(make_shape(values, prefix)->bounding_box());
    } catch (const InputError&) { // which the run reports
        return {.dimension = 2};
    }
}

/// Of a mesh that is not read yet, or invalid: the default ranges.
Space space_of_source(const Values& values, const DomainContent& content) {
    if (!is_from_file(values)) return space_of_curve(values, "");
    const auto* read = static_cast<const SourceContent*>(content.get());
    return read && read->mesh ? space_of(bounding_box(read->mesh->convex.mesh.nodes)) : Space{.dimension = 2};
}

ParameterRow rings_row() {
    return {.key = "cells",
            .label = "Rings",
            .symbol = "n",
            .kind = ParameterKind::integer,
            .minimum = fewest_domain_rings,
            .maximum = most_domain_rings,
            .scale = ParameterScale::logarithmic,
            .slider = SliderRange{4, 64},
            .default_value = std::int64_t{24},
            .help = "the mesh of the source has n rings around its centre, of 6 n² triangles"};
}

ParameterRow refinements_row() {
    return {.key = "refinements",
            .label = "Refinements",
            .kind = ParameterKind::integer,
            .minimum = 0,
            .maximum = most_domain_refinements,
            .default_value = std::int64_t{0},
            .help = "how many times each triangle of the file is divided into four"};
}

ParameterRow degree_row() {
    return {.key = "degree",
            .label = "Degree",
            .symbol = "k",
            .kind = ParameterKind::integer,
            .minimum = 1,
            .maximum = highest_triangle_degree,
            .default_value = std::int64_t{1},
            .help = "of the finite elements, for the potential, its gradient and its Hessian"};
}

ParameterRow edges_row() {
    return {.key = "edges",
            .label = "Boundary edges",
            .kind = ParameterKind::choice,
            .default_value = std::string("curved"),
            .choices = {"curved", "straight"},
            .help =
                "with degree 2 or 3: isoparametric triangles whose edges follow the boundary, or straight "
                "ones as in the paper"};
}

std::vector<ParameterRow> rows_of(const Values& values) {
    std::vector<ParameterRow> rows;
    if (is_from_file(values))
        rows = {refinements_row(), degree_row()};
    else
        rows = {rings_row(), degree_row(), edges_row()};
    const auto add = [&](std::vector<ParameterRow> more) {
        for (ParameterRow& row : more) rows.push_back(std::move(row));
    };
    add(shape_rows(values, "", "Source"));
    rows.push_back(shape_choice_row(target_prefix, "Target"));
    if (values.has(rows.back().key)) add(shape_rows(values, target_prefix, "Target")); // else the next call
    return rows;
}

} // namespace

TransportDomain::TransportDomain(Setup setup, const std::stop_token& stop)
    : setup_(std::move(setup)), elements_(make_elements(stop)) {
    make_mesh();
    constexpr std::size_t corners = 360;
    Points outline(corners);
    for (std::size_t i = 0; i < corners; ++i)
        outline.set(i, setup_.target_origin + setup_.target->point(static_cast<double>(i) / corners));
    outline_ = std::make_shared<const Points>(std::move(outline));
}

LagrangeTriangles TransportDomain::make_elements(const std::stop_token& stop) {
    if (setup_.mesh) {
        auto [mesh, boundary] = refined(setup_.mesh->convex, setup_.refinements);
        if (boundary.size() == mesh.node_count())
            throw InputError(
                "domain.file: all nodes of the mesh are on its boundary; set domain.refinements = " +
                std::to_string(setup_.refinements + (mesh.cell_count() == 1 ? 2 : 1)));
        for (std::size_t i = 0; i < mesh.node_count(); ++i)
            mesh.nodes.set(i, mesh.nodes[i] - setup_.source_origin);
        return {mesh, {.nodes = boundary}, setup_.degree};
    }
    const RingMesh rings = ring_mesh(*setup_.source, setup_.rings);
    if (stop.stop_requested()) throw Interrupted();
    BoundarySides boundary{.nodes = rings.boundary_nodes};
    if (setup_.curved) {
        const auto& t = rings.boundary_parameters;
        boundary.point = [&](std::size_t side, double s) {
            const double from = t[side], to = side + 1 < t.size() ? t[side + 1] : t[0] + 1;
            return setup_.source->point(from + s * (to - from));
        };
    }
    return {rings.mesh, boundary, setup_.degree};
}

namespace {

constexpr double inside = 1 - 1e-9; ///< of the distance from the middle

Vec3 mean_of(const Points& x) {
    Vec3 sum;
    for (std::size_t i = 0; i < x.size(); ++i) sum = sum + x[i];
    return 1 / static_cast<double>(x.size()) * sum;
}

/// Points of a domain that end just inside of its boundary, where formulas are still valid.
std::shared_ptr<const DensityDomain> region_of(const std::shared_ptr<const ConvexCurve>& curve, Vec3 origin) {
    constexpr std::size_t circles = 24, around = 96;
    auto region = std::make_shared<DensityDomain>();
    region->samples = Points(circles * around + 1);
    region->samples.set(circles * around, origin + curve->centre());
    for (std::size_t k = 0; k < circles; ++k)
        for (std::size_t j = 0; j < around; ++j) {
            const double r = inside * static_cast<double>(k + 1) / circles;
            const Vec3 edge = curve->point(static_cast<double>(j) / around);
            region->samples.set(k * around + j, origin + curve->centre() + r * (edge - curve->centre()));
        }
    region->into = [curve, origin](Vec3 p) {
        const Vec3 from = p - origin - curve->centre();
        if (!std::isfinite(from.x + from.y)) return origin + curve->centre();
        const double gauge = curve->gauge(p - origin).value;
        return gauge <= inside ? p : origin + curve->centre() + (inside / gauge) * from;
    };
    return region;
}

} // namespace

std::shared_ptr<const DensityDomain> TransportDomain::source_region() const {
    if (setup_.source) return region_of(setup_.source, setup_.source_origin);
    // Triangles with straight edges leave it by rounding alone, that of the file as well.
    const auto inwards = [centre = mean_of(mesh_->nodes)](Vec3 p) { return centre + inside * (p - centre); };
    auto region = std::make_shared<DensityDomain>();
    region->samples = Points(mesh_->node_count());
    for (std::size_t i = 0; i < mesh_->node_count(); ++i) region->samples.set(i, inwards(mesh_->nodes[i]));
    region->into = inwards;
    return region;
}

std::shared_ptr<const DensityDomain> TransportDomain::target_region() const {
    return region_of(setup_.target, setup_.target_origin);
}

void TransportDomain::make_mesh() {
    const int order = setup_.degree == 1 ? 1 : 2;
    Mesh mesh{
        .kind = {CellShape::triangle, order}, .space_dimension = 2, .nodes = elements_.nodes(), .cells = {}};
    if (setup_.degree < 3) {
        for (std::size_t c = 0; c < elements_.cell_count(); ++c)
            mesh.cells.insert(mesh.cells.end(), elements_.cell(c).begin(), elements_.cell(c).end());
        for (std::size_t i = 0; i < mesh.node_count(); ++i)
            mesh.nodes.set(i, setup_.source_origin + mesh.nodes[i]);
        mesh_ = std::make_shared<const Mesh>(std::move(mesh));
        return;
    }
    // The corners come first; a middle of an edge takes the place of the first node on the edge.
    std::vector<std::int32_t> number(elements_.nodes().size(), -1);
    for (std::size_t c = 0; c < elements_.cell_count(); ++c)
        for (std::size_t i = 0; i < quadratic_nodes.size(); ++i) {
            const auto cell = elements_.cell(c);
            const std::size_t first = 3 + 2 * (i - 3);
            const auto node =
                static_cast<std::size_t>(i < 3 ? cell[i] : std::min(cell[first], cell[first + 1]));
            if (number[node] < 0) {
                number[node] = static_cast<std::int32_t>(shown_.size() / 2);
                shown_.insert(shown_.end(), {c, i});
            }
            mesh.cells.push_back(number[node]);
        }
    mesh.nodes = Points(shown_.size() / 2);
    const std::vector<double> x = at_mesh_nodes(elements_.nodes().x, 1),
                              y = at_mesh_nodes(elements_.nodes().y, 1);
    for (std::size_t i = 0; i < x.size(); ++i) mesh.nodes.set(i, setup_.source_origin + Vec3{x[i], y[i], 0});
    mesh_ = std::make_shared<const Mesh>(std::move(mesh));
}

std::vector<double> TransportDomain::at_mesh_nodes(std::span<const double> values, std::size_t count) const {
    if (shown_.empty()) return {values.begin(), values.end()};
    static const auto shapes = [] {
        std::array<TriangleShapes, quadratic_nodes.size()> all;
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i] = triangle_shapes(3, quadratic_nodes[i][0], quadratic_nodes[i][1]);
        return all;
    }();
    std::vector<double> at(count * shown_.size() / 2, 0.0);
    for (std::size_t i = 0; i < shown_.size() / 2; ++i) {
        const auto cell = elements_.cell(shown_[2 * i]);
        const auto& weights = shapes[shown_[2 * i + 1]].values;
        for (std::size_t a = 0; a < cell.size(); ++a)
            for (std::size_t c = 0; c < count; ++c)
                at[count * i + c] += weights[a] * values[count * static_cast<std::size_t>(cell[a]) + c];
    }
    return at;
}

DomainType transport_domain() {
    return {.name = "convex",
            .label = "Convex domains",
            .help = "a map from one convex domain to another, from boundary to boundary",
            .rows = {shape_choice_row("", "Source")},
            .further_rows = rows_of,
            .space = [](const Values& values,
                        const DomainContent&) { return space_of_curve(values, target_prefix); },
            .source_space = space_of_source,
            .read = read_content};
}

std::shared_ptr<const TransportDomain> make_transport_domain(const Values& values,
                                                             const std::filesystem::path& folder,
                                                             const DomainContent& content,
                                                             const std::stop_token& stop) {
    TransportDomain::Setup setup{.source = nullptr,
                                 .target = nullptr,
                                 .degree = static_cast<int>(values.integer("degree")),
                                 .target_origin = middle_of_shape(values, target_prefix),
                                 .source_name = {}};
    setup.target = make_shape(values, target_prefix, setup.target_origin);
    if (is_from_file(values)) {
        const auto* read = static_cast<const SourceContent*>(content.get());
        if (read && read->error) std::rethrow_exception(read->error);
        setup.mesh = read && read->mesh
                         ? read->mesh
                         : std::make_shared<const SourceMesh>(read_source_mesh(values.text("file"), folder));
        setup.refinements = static_cast<int>(values.integer("refinements"));
        setup.curved = false;
        setup.source_origin = bounding_box(setup.mesh->convex.mesh.nodes).centre();
        setup.source_name = setup.mesh->name;
    } else {
        setup.source_origin = middle_of_shape(values, "");
        setup.source = make_shape(values, "", setup.source_origin);
        setup.rings = static_cast<int>(values.integer("cells"));
        setup.curved = values.text("edges") == "curved";
        setup.source_name = name_of_source(values);
    }
    return std::make_shared<const TransportDomain>(std::move(setup), stop);
}

/// The second moments of points about their mean.
static Covariance covariance_of(const Points& x) {
    const Vec3 mean = mean_of(x);
    Covariance sum;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Vec3 d = x[i] - mean;
        sum.xx += d.x * d.x, sum.xy += d.x * d.y, sum.yy += d.y * d.y;
    }
    return sum;
}

// The error of the recovered gradient is a part of the length of a domain, and may exceed its width.
std::vector<std::string> TransportDomain::notes() const {
    constexpr double thin = 30; // to 1/30 degree 1 converges
    std::vector<std::string> notes;
    if (setup_.degree > 1) return notes;
    const auto look = [&](const Covariance& c, const std::string& whose) {
        const double most = symmetric_eigenvalues(c.xx, c.xy, c.yy).largest;
        const double ratio = most / std::sqrt(std::max(c.xx * c.yy - c.xy * c.xy, 0.0));
        if (!(ratio > thin)) return;
        const bool counted = ratio < 1e6; // beyond, rounding
        notes.push_back("The " + whose + " is " + (counted ? "" : "more than ") +
                        std::to_string(std::lround(counted ? ratio : 1e6)) +
                        " times as long as wide, which is too thin for elements of degree 1; set "
                        "domain.degree = 2");
    };
    look(setup_.source ? setup_.source->covariance() : covariance_of(mesh_->nodes), "source");
    look(setup_.target->covariance(), "target");
    return notes;
}

} // namespace gaspard

#include "core/diagnostics/cell_quality.hpp"

#include "core/base/check.hpp"
#include "core/base/symmetric.hpp"
#include "core/fem/cell_quadrature.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace gaspard {

namespace {

constexpr double to_degrees = 180 / std::numbers::pi;

/// The columns of A: the tangents relative to the ideal cell.
Tangents relative_to_ideal(CellShape shape, Tangents t) {
    if (shape == CellShape::triangle) t[1] = (1 / std::numbers::sqrt3) * (2 * t[1] - t[0]);
    return t;
}

/// AᵀA, which has the eigenvalues of A Aᵀ.
template <std::size_t D>
Symmetric<D> gram(const Tangents& a) {
    Symmetric<D> g{};
    std::size_t at = 0;
    for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = i; j < D; ++j) g[at++] = dot(a[i], a[j]);
    return g;
}

/// Without the cancellation of the smallest eigenvalue in two dimensions, where it is determinant / largest.
double singular_ratio(int dimension, const Tangents& a) {
    double ratio = 0;
    if (dimension == 2) {
        ratio = eigenvalues(gram<2>(a))[1] / norm(cross(a[0], a[1]));
    } else {
        const auto values = eigenvalues(gram<3>(a));
        ratio = std::sqrt(values[2] / std::max(values[0], 0.0));
    }
    return ratio < aspect_limit ? ratio : aspect_limit; // also where it is not a number
}

double corner_angle(Vec3 a, Vec3 b) { return to_degrees * std::atan2(norm(cross(a, b)), dot(a, b)); }

/// hᵀ G⁻¹ h
template <std::size_t D>
double inverse_form(const Symmetric<D>& g, const std::array<double, 3>& h) {
    const Symmetric<D> c = cofactors(g);
    double sum = 0;
    std::size_t at = 0;
    for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = i; j < D; ++j) sum += (i == j ? 1 : 2) * c[at++] * h[i] * h[j];
    return sum / determinant(g);
}

/// The angles between the edges at a corner of the reference cell, whose tangents are `t`.
template <class Add>
void angles_at_corner(CellShape shape, Vec3 corner, const Tangents& t, const Add& add) {
    if (shape == CellShape::triangle) {
        if (corner.x > 0.5)
            add(corner_angle(-1.0 * t[0], t[1] - t[0]));
        else if (corner.y > 0.5)
            add(corner_angle(-1.0 * t[1], t[0] - t[1]));
        else
            add(corner_angle(t[0], t[1]));
        return;
    }
    const std::array<Vec3, 3> outward = {(corner.x > 0.5 ? -1.0 : 1.0) * t[0],
                                         (corner.y > 0.5 ? -1.0 : 1.0) * t[1],
                                         (corner.z > 0.5 ? -1.0 : 1.0) * t[2]};
    add(corner_angle(outward[0], outward[1]));
    if (shape != CellShape::hexahedron) return;
    add(corner_angle(outward[0], outward[2]));
    add(corner_angle(outward[1], outward[2]));
}

/// The corners of a cell's sides, as places in the cell; of edges the third and the fourth are unused.
std::vector<std::array<int, 4>> sides_of(CellKind kind) {
    std::vector<std::array<int, 4>> sides;
    if (kind.shape == CellShape::hexahedron)
        for (const std::vector<int>& face : cell_faces(kind))
            sides.push_back({face[0], face[1], face[2], face[3]});
    else
        for (int k = 0, n = corners_per_cell(kind); k < n; ++k) sides.push_back({k, (k + 1) % n, -1, -1});
    return sides;
}

} // namespace

std::span<const QualityMeasureInfo> quality_measures() {
    static constexpr std::array<QualityMeasureInfo, 4> all{
        {{"aspect_ratio", "Aspect ratio", "max", &CellQuality::aspect_ratio},
         {"skewness", "Skewness", "max", &CellQuality::skewness},
         {"orthogonality", "Non-orthogonality", "max", &CellQuality::orthogonality},
         {"alignment", "Alignment with grad m", "min", &CellQuality::alignment}}};
    return all;
}

bool has_quality(CellKind kind) { return kind.shape != CellShape::line; }

CellQualityMeter::CellQualityMeter(std::shared_ptr<const Mesh> mesh)
    : mesh_(std::move(mesh)), dimension_(cell_dimension(mesh_->kind)) {
    GASPARD_CHECK(has_quality(mesh_->kind));
    const auto corners = static_cast<std::size_t>(corners_per_cell(mesh_->kind));
    for (const Vec3 corner : reference_nodes(mesh_->kind).first(corners)) add_sample(corner, true);
    for (const CellPoint& gauss : cell_quadrature(mesh_->kind.shape, 2)) add_sample(gauss.point, false);
    find_degenerate();
    find_sides();
}

void CellQualityMeter::add_sample(Vec3 point, bool corner) {
    const auto n = static_cast<std::size_t>(nodes_per_cell(mesh_->kind));
    std::vector<double> values(n);
    Sample sample{point, std::vector<Vec3>(n), corner};
    shape_functions(mesh_->kind, point, values, sample.gradients);
    samples_.push_back(std::move(sample));
}

void CellQualityMeter::find_degenerate() {
    const int d = dimension_;
    std::vector<double> measures(samples_.size());
    for (std::size_t i = 0; i < mesh_->cell_count(); ++i) {
        const auto nodes = mesh_->cell(i);
        for (std::size_t s = 0; s < samples_.size(); ++s) {
            const Tangents t = cell_tangents(d, samples_[s].gradients, [&](std::size_t k) {
                return mesh_->nodes[static_cast<std::size_t>(nodes[k])];
            });
            measures[s] = std::abs(signed_measure(d, mesh_->space_dimension, t, t));
        }
        double largest = *std::ranges::max_element(measures);
        std::uint32_t bits = 0;
        for (std::size_t s = 0; s < samples_.size(); ++s)
            if (!(measures[s] > degenerate_measure * largest)) bits |= 1U << s;
        degenerate_.push_back(bits);
    }
}

/// Sides with the same corners are those of neighbours.
void CellQualityMeter::find_sides() {
    struct Found {
        std::array<std::int32_t, 4> key;
        Side side;
    };
    std::vector<Found> found;
    const auto places = sides_of(mesh_->kind);
    found.reserve(places.size() * mesh_->cell_count());
    for (std::size_t i = 0; i < mesh_->cell_count(); ++i)
        for (const std::array<int, 4>& place : places) {
            Side side{.corners = {}, .cells = {static_cast<std::int32_t>(i), -1}};
            for (std::size_t k = 0; k < 4; ++k)
                side.corners[k] = place[k] < 0 ? -1 : mesh_->cell(i)[static_cast<std::size_t>(place[k])];
            Found one{side.corners, side};
            std::ranges::sort(one.key);
            found.push_back(one);
        }
    std::ranges::stable_sort(found, {}, &Found::key);
    for (std::size_t i = 0; i + 1 < found.size(); ++i)
        if (found[i].key == found[i + 1].key) {
            sides_.push_back({found[i].side.corners, {found[i].side.cells[0], found[i + 1].side.cells[0]}});
            ++i;
        }
}

CellQuality CellQualityMeter::measure(const Points& x, std::span<const double> monitor) const {
    const std::size_t cells = mesh_->cell_count();
    GASPARD_CHECK(x.size() == mesh_->node_count() && (monitor.empty() || monitor.size() == x.size()));
    CellQuality quality{std::vector<double>(cells, 1.0), std::vector<double>(cells),
                        std::vector<double>(cells), std::vector<double>(monitor.empty() ? 0 : cells)};
    std::vector<Tangents> tangents(samples_.size());
    std::vector<double> at_nodes(static_cast<std::size_t>(nodes_per_cell(mesh_->kind)));
    for (std::size_t i = 0; i < cells; ++i) {
        const auto nodes = mesh_->cell(i);
        for (std::size_t s = 0; s < samples_.size(); ++s)
            tangents[s] = cell_tangents(dimension_, samples_[s].gradients,
                                        [&](std::size_t k) { return x[static_cast<std::size_t>(nodes[k])]; });
        measure_shape(i, tangents, quality);
        if (monitor.empty()) continue;
        for (std::size_t k = 0; k < nodes.size(); ++k)
            at_nodes[k] = monitor[static_cast<std::size_t>(nodes[k])];
        quality.alignment[i] = alignment(tangents, at_nodes);
    }
    measure_sides(x, quality.orthogonality);
    return quality;
}

void CellQualityMeter::measure_shape(std::size_t cell, std::span<const Tangents> tangents,
                                     CellQuality& quality) const {
    const CellShape shape = mesh_->kind.shape;
    const double ideal = shape == CellShape::triangle ? 60 : 90;
    double ratio = 1, skewness = 0;
    for (std::size_t s = 0; s < samples_.size(); ++s) {
        if ((degenerate_[cell] >> s & 1U) != 0) continue;
        ratio = std::max(ratio, singular_ratio(dimension_, relative_to_ideal(shape, tangents[s])));
        if (!samples_[s].corner) continue;
        angles_at_corner(shape, samples_[s].point, tangents[s], [&](double angle) {
            skewness = std::max({skewness, (angle - ideal) / (180 - ideal), (ideal - angle) / ideal});
        });
    }
    quality.aspect_ratio[cell] = ratio;
    quality.skewness[cell] = std::min(skewness, 1.0);
}

/// With h = W⁻ᵀ dm/ds the gradient of m satisfies Aᵀ grad m = h: |grad m|² = hᵀ (AᵀA)⁻¹ h, and
/// grad m · A Aᵀ grad m = |h|².
double CellQualityMeter::alignment(std::span<const Tangents> tangents, std::span<const double> m) const {
    const CellShape shape = mesh_->kind.shape;
    const auto [low, high] = std::ranges::minmax(m);
    if (!(high - low > 1e-12 * std::abs(high))) return 0; // m differs by rounding alone
    double along = 0, all = 0;
    for (std::size_t s = 0; s < samples_.size(); ++s) {
        if (samples_[s].corner) continue;
        Vec3 slope{};
        for (std::size_t k = 0; k < m.size(); ++k) slope = slope + (m[k] - low) * samples_[s].gradients[k];
        const Tangents a = relative_to_ideal(shape, tangents[s]);
        std::array<double, 3> h = {slope.x, slope.y, slope.z};
        if (shape == CellShape::triangle) h[1] = (2 * h[1] - h[0]) / std::numbers::sqrt3;
        const double weight =
            dimension_ == 2 ? inverse_form<2>(gram<2>(a), h) : inverse_form<3>(gram<3>(a), h);
        const double size = dimension_ == 2 ? trace(gram<2>(a)) : trace(gram<3>(a));
        if (!std::isfinite(weight)) continue; // the cell is flat there
        along += h[0] * h[0] + h[1] * h[1] + (dimension_ == 3 ? h[2] * h[2] : 0);
        all += weight * size;
    }
    const double across = (all - along) / (dimension_ - 1);
    return along > 0 ? std::clamp((across - along) / (across + along), -1.0, 1.0) : 0;
}

void CellQualityMeter::measure_sides(const Points& x, std::vector<double>& orthogonality) const {
    const auto corners = static_cast<std::size_t>(corners_per_cell(mesh_->kind));
    std::vector<Vec3> centres(mesh_->cell_count());
    for (std::size_t i = 0; i < centres.size(); ++i) {
        for (const std::int32_t node : mesh_->cell(i).first(corners))
            centres[i] = centres[i] + x[static_cast<std::size_t>(node)];
        centres[i] = (1.0 / static_cast<double>(corners)) * centres[i];
    }
    for (const Side& side : sides_) {
        const auto one = static_cast<std::size_t>(side.cells[0]),
                   other = static_cast<std::size_t>(side.cells[1]);
        const double found = angle(side, centres[other] - centres[one], x);
        for (const std::size_t cell : {one, other})
            orthogonality[cell] = std::max(orthogonality[cell], found);
    }
}

/// In degrees; 0 if the side is a point.
double CellQualityMeter::angle(const Side& side, Vec3 between, const Points& x) const {
    const auto at = [&](std::size_t k) { return x[static_cast<std::size_t>(side.corners[k])]; };
    if (dimension_ == 2) {
        const Vec3 edge = at(1) - at(0);
        if (!(norm(edge) > 0)) return 0;
        return to_degrees * std::atan2(std::abs(dot(between, edge)), norm(cross(between, edge)));
    }
    const Vec3 normal = cross(at(2) - at(0), at(3) - at(1));
    if (!(norm(normal) > 0)) return 0;
    return to_degrees * std::atan2(norm(cross(between, normal)), std::abs(dot(between, normal)));
}

std::vector<SeriesInfo> cell_quality_series() {
    std::vector<SeriesInfo> all;
    for (const QualityMeasureInfo& measure : quality_measures())
        for (const std::string& part : {std::string(measure.worst), std::string("mean")}) {
            const bool angle = measure.name == "orthogonality";
            const std::string label(measure.label);
            all.push_back({.name = part + "_" + std::string(measure.name),
                           .label = label + ", " + part,
                           .unit = angle ? "°" : "",
                           .help = "of all cells; see Cell quality in the documentation",
                           .plot = SharedPlot{std::string(measure.name), label, part},
                           .measured = true});
        }
    return all;
}

SeriesValues values_of(const CellQuality& quality) {
    SeriesValues found;
    for (const QualityMeasureInfo& measure : quality_measures()) {
        const std::vector<double>& values = quality.*measure.values;
        GASPARD_CHECK(!values.empty());
        const auto [low, high] = std::ranges::minmax(values);
        found.push_back(measure.worst == "min" ? low : high);
        found.push_back(std::accumulate(values.begin(), values.end(), 0.0) /
                        static_cast<double>(values.size()));
    }
    return found;
}

} // namespace gaspard

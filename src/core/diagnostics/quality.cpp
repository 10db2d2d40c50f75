#include "core/diagnostics/quality.hpp"

#include "core/base/check.hpp"
#include "core/fem/cell_quadrature.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gaspard {

namespace {

constexpr std::size_t cells_at_once = 64; // whose quadrature points the monitor evaluates in one call

std::size_t checked(int threads) {
    GASPARD_CHECK(threads >= 1);
    return static_cast<std::size_t>(threads);
}

// Minimum and maximum that return NaN if b is NaN.
double smaller_or_nan(double a, double b) { return std::isnan(b) || b < a ? b : a; }
double larger_or_nan(double a, double b) { return std::isnan(b) || b > a ? b : a; }

} // namespace

QualityMeter::QualityMeter(std::shared_ptr<const Mesh> mesh, int threads, int points, const Space& space)
    : mesh_(std::move(mesh)), dimension_(cell_dimension(mesh_->kind)), workers_(checked(threads)),
      team_(workers_.size()) {
    // So that areas in the plane and volumes are exact.
    const int order = mesh_->kind.order;
    points = std::max(points, mesh_->kind.shape == CellShape::hexahedron ? (3 * order + 1) / 2 : order);
    if (FlatSquares::fits(*mesh_)) flat_.emplace(points);
    if (space.kind == SpaceKind::sphere) sphere_.emplace(mesh_->kind, points);
    for (const auto& [point, weight] : cell_quadrature(mesh_->kind.shape, points)) add_sample(point, weight);
    quadrature_points_ = samples_.size();
    for (const Vec3 node : reference_nodes(mesh_->kind)) add_sample(node, 0);
    const bool solid = mesh_->kind.shape == CellShape::hexahedron;
    if (solid || (mesh_->kind.shape == CellShape::quadrilateral && mesh_->kind.order > 2)) {
        quadrature_cell_.emplace(mesh_->kind, gauss_legendre(points).points);
        std::vector<double> nodes; // of an edge; the order of samples without weight is of no importance
        for (int k = 0; k <= mesh_->kind.order; ++k)
            nodes.push_back(static_cast<double>(k) / mesh_->kind.order);
        node_cell_.emplace(mesh_->kind, nodes);
    }

    const std::size_t cells = mesh_->cell_count();
    std::vector<Vec3> nodes(static_cast<std::size_t>(nodes_per_cell(mesh_->kind)));
    std::vector<PlaceInCell> places;
    TensorCell::Workspace workspace;
    cell_measure_.assign(cells, 0.0);
    for (std::size_t i = 0; i < cells; ++i) {
        gather(i, mesh_->nodes, nodes);
        find_places(nodes, places, workspace);
        for (std::size_t q = 0; q < quadrature_points_; ++q)
            cell_measure_[i] += samples_[q].weight * signed_measure(places[q].tangents, places[q].tangents);
        if (cell_measure_[i] == 0) pointlike_.push_back(i);
    }
    quality_.cell_jacobian.resize(cells);
    for (Worker& worker : workers_) {
        worker.nodes = worker.reference_nodes = nodes;
        worker.points.resize(cells_at_once * quadrature_points_);
        worker.factor.resize(cells_at_once * quadrature_points_);
        worker.monitor.resize(cells_at_once * quadrature_points_);
    }
}

void QualityMeter::add_sample(Vec3 point, double weight) {
    const auto n = static_cast<std::size_t>(nodes_per_cell(mesh_->kind));
    Sample sample{std::vector<double>(n), std::vector<Vec3>(n), weight};
    shape_functions(mesh_->kind, point, sample.values, sample.gradients);
    samples_.push_back(std::move(sample));
}

void QualityMeter::gather(std::size_t cell, const Points& x, std::span<Vec3> nodes) const {
    const auto numbers = mesh_->cell(cell);
    for (std::size_t k = 0; k < nodes.size(); ++k) nodes[k] = x[static_cast<std::size_t>(numbers[k])];
}

Tangents QualityMeter::tangents(std::span<const Vec3> nodes, const Sample& sample) const {
    return cell_tangents(dimension_, sample.gradients, [nodes](std::size_t k) { return nodes[k]; });
}

double QualityMeter::signed_measure(const Tangents& of, const Tangents& reference) const {
    return gaspard::signed_measure(dimension_, mesh_->space_dimension, of, reference);
}

void QualityMeter::find_places(std::span<const Vec3> nodes, std::vector<PlaceInCell>& places,
                               TensorCell::Workspace& workspace) const {
    places.resize(samples_.size());
    if (quadrature_cell_) {
        quadrature_cell_->evaluate(nodes, std::span(places).first(quadrature_points_), workspace);
        node_cell_->evaluate(nodes, std::span(places).subspan(quadrature_points_), workspace);
        return;
    }
    for (std::size_t s = 0; s < samples_.size(); ++s) {
        places[s] = {{}, tangents(nodes, samples_[s])};
        for (std::size_t k = 0; s < quadrature_points_ && k < nodes.size(); ++k)
            places[s].x = places[s].x + samples_[s].values[k] * nodes[k];
    }
}

void QualityMeter::measure_batch(std::size_t begin, std::size_t end, const Points& x, const Monitor* monitor,
                                 Worker& worker) {
    worker.points.resize((end - begin) * quadrature_points_);
    std::size_t at = 0;
    for (std::size_t i = begin; i < end; ++i) {
        gather(i, x, worker.nodes);
        gather(i, mesh_->nodes, worker.reference_nodes);
        double smallest = std::numeric_limits<double>::infinity(), largest = -smallest;
        find_places(worker.nodes, worker.places, worker.tensor);
        find_places(worker.reference_nodes, worker.reference_places, worker.tensor);
        for (std::size_t s = 0; s < samples_.size(); ++s) {
            const Tangents& reference = worker.reference_places[s].tangents;
            const double physical = signed_measure(worker.places[s].tangents, reference);
            const double before = signed_measure(reference, reference);
            if (std::abs(before) > degenerate_measure * std::abs(cell_measure_[i])) {
                smallest = smaller_or_nan(smallest, physical / before);
                largest = larger_or_nan(largest, physical / before);
            }
            if (s >= quadrature_points_ || !monitor) continue;
            worker.points.set(at, worker.places[s].x);
            worker.factor[at++] = samples_[s].weight * physical;
        }
        note_cell(i, smallest, largest, worker);
    }
    if (!monitor) return;
    worker.monitor.resize(at);
    monitor->values(worker.points, worker.monitor);
    at = 0;
    for (std::size_t i = begin; i < end; ++i) {
        double mass = 0;
        for (std::size_t q = 0; q < quadrature_points_; ++q, ++at)
            mass += worker.factor[at] * worker.monitor[at];
        quality_.cell_mass[i] = mass / cell_measure_[i];
    }
}

template <class Meter>
void QualityMeter::measure_many(const Meter& meter, typename Meter::Workspace& workspace, std::size_t begin,
                                std::size_t end, const Points& x, const Monitor* monitor, Worker& worker) {
    for (; begin < end; begin += Meter::batch) {
        const std::size_t stop = std::min(end, begin + Meter::batch);
        const auto measured = meter.measure(*mesh_, begin, stop, x, monitor, workspace);
        for (std::size_t i = begin; i < stop; ++i) {
            note_cell(i, measured.smallest[i - begin], measured.largest[i - begin], worker);
            if (monitor) quality_.cell_mass[i] = measured.mass[i - begin] / cell_measure_[i];
        }
    }
}

void QualityMeter::note_cell(std::size_t cell, double smallest, double largest, Worker& worker) {
    if (cell_measure_[cell] == 0) {
        quality_.cell_jacobian[cell] = 1;
        return;
    }
    quality_.cell_jacobian[cell] = smallest;
    worker.min_jacobian = smaller_or_nan(worker.min_jacobian, smallest);
    worker.max_jacobian = larger_or_nan(worker.max_jacobian, largest);
    if (!(smallest > 0)) ++worker.tangled_cells;
}

void QualityMeter::measure_cells(std::size_t begin, std::size_t end, const Points& x, const Monitor* monitor,
                                 Worker& worker) {
    worker.min_jacobian = std::numeric_limits<double>::infinity();
    worker.max_jacobian = -std::numeric_limits<double>::infinity();
    worker.tangled_cells = 0;
    if (flat_) return measure_many(*flat_, worker.flat, begin, end, x, monitor, worker);
    if (sphere_) return measure_many(*sphere_, worker.sphere, begin, end, x, monitor, worker);
    for (; begin < end; begin += cells_at_once)
        measure_batch(begin, std::min(end, begin + cells_at_once), x, monitor, worker);
}

const MeshQuality& QualityMeter::measure(const Points& x, const Monitor* monitor) {
    GASPARD_CHECK(x.size() == mesh_->node_count());
    const std::size_t cells = mesh_->cell_count();
    quality_.cell_mass.resize(monitor ? cells : 0);
    const auto share = [&](std::size_t worker, std::size_t begin, std::size_t end) {
        measure_cells(begin, end, x, monitor, workers_[worker]);
    };
    const double others_before = team_.other_cpu_seconds();
    team_.share(cells, share);
    other_cpu_seconds_ = team_.other_cpu_seconds() - others_before;
    quality_.min_jacobian = workers_.front().min_jacobian;
    quality_.max_jacobian = workers_.front().max_jacobian;
    quality_.tangled_cells = 0;
    for (const Worker& worker : workers_) {
        quality_.min_jacobian = smaller_or_nan(quality_.min_jacobian, worker.min_jacobian);
        quality_.max_jacobian = larger_or_nan(quality_.max_jacobian, worker.max_jacobian);
        quality_.tangled_cells += worker.tangled_cells;
    }
    if (quality_.min_jacobian > quality_.max_jacobian) quality_.min_jacobian = quality_.max_jacobian = 1;

    quality_.equidistribution = std::numeric_limits<double>::quiet_NaN();
    if (!monitor) return quality_;
    if (pointlike_.size() == cells) {
        std::fill(quality_.cell_mass.begin(), quality_.cell_mass.end(), 0.0);
        return quality_;
    }
    const auto counted = static_cast<double>(cells - pointlike_.size());
    double mean = 0, variance = 0;
    for (const std::size_t i : pointlike_) quality_.cell_mass[i] = 0;
    for (const double mass : quality_.cell_mass) mean += mass / counted;
    for (const std::size_t i : pointlike_) quality_.cell_mass[i] = mean;
    for (const double mass : quality_.cell_mass) variance += (mass - mean) * (mass - mean) / counted;
    quality_.equidistribution = std::sqrt(variance) / std::abs(mean);
    return quality_;
}

} // namespace gaspard

#include "core/diagnostics/interpolation_error.hpp"

#include "core/base/check.hpp"
#include "core/base/error.hpp"
#include "core/base/team.hpp"
#include "core/diagnostics/interpolation_cells.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <span>

namespace gaspard {

namespace {

using Batch = InterpolationCells::Batch;

constexpr std::size_t batch_cells = 32; // independent of the number of threads, as are the results
constexpr std::size_t block = 64;       // parts that are integrated together
constexpr double noise = 1e-13; // relative to the largest |u|: rounding, which no halving makes smaller

struct CellResult {
    ErrorSums sums{};         ///< of the whole cell, later of its parts
    double change_square = 0; ///< by the last halvings
    double change_slope = 0;
    double half_maximum = 0;  ///< with half as many points
    double largest_value = 0; ///< |u| at the corners
    bool tangled = false, unresolved = false;
};

class Measurement {
  public:
    Measurement(const Mesh& mesh, const Points& x, const Space& space, const ScalarFunction& u,
                const InterpolationOptions& options)
        : cells_(mesh, x, space, u), options_(options), results_(mesh.cell_count()) {}

    InterpolationError run() {
        Team team(static_cast<std::size_t>(std::max(1, options_.threads)));
        share(team, [this](Batch& batch) { look(batch); });
        total();
        share(team, [this](Batch& batch) { refine(batch); });
        return result();
    }

  private:
    template <class Work>
    void share(Team& team, const Work& work) {
        const std::size_t count = results_.size(), batches = (count + batch_cells - 1) / batch_cells;
        team.share(batches, [&](std::size_t, std::size_t begin, std::size_t end) {
            Batch batch;
            for (std::size_t b = begin; b < end; ++b) {
                if (options_.stop.stop_requested()) throw Interrupted();
                cells_.begin(b * batch_cells, std::min(count, (b + 1) * batch_cells), batch);
                work(batch);
            }
        });
    }

    /// The sums over whole cells, and the maxima.
    void look(Batch& batch) {
        const std::size_t count = batch.end - batch.begin;
        std::vector<InterpolationCells::Peak> peaks(count);
        const std::size_t corners = batch.corners.size() / count;
        const std::vector<double> values = batch.corners;
        cells_.peaks(batch, peaks);
        std::vector<CellPart> parts(count);
        for (std::size_t c = 0; c < count; ++c) parts[c].cell = static_cast<std::uint32_t>(c);
        std::vector<ErrorSums> sums;
        cells_.integrate(parts, batch, sums);
        for (std::size_t c = 0; c < count; ++c) {
            CellResult& result = results_[batch.begin + c];
            result.sums = sums[c];
            result.half_maximum = std::max(sums[c].maximum, peaks[c].half);
            result.sums.maximum = std::max(sums[c].maximum, peaks[c].whole);
            result.tangled = batch.tangled[c] != 0;
            for (std::size_t n = 0; n < corners; ++n)
                result.largest_value = std::max(result.largest_value, std::abs(values[c * corners + n]));
        }
    }

    /// What the tolerance of a part refers to.
    void total() {
        double square = 0, slope = 0;
        for (const CellResult& result : results_) {
            square += result.sums.square;
            if (!result.tangled) slope += result.sums.slope;
            largest_ = std::max(largest_, result.largest_value);
        }
        const auto count = static_cast<double>(results_.size());
        square_share_ = square / count, slope_share_ = slope / count;
    }

    struct Part : CellPart {
        ErrorSums sums{};
    };

    /// Whether the sum over the halves is close enough to that over the whole.
    bool close(const Part& part, const ErrorSums& halves, const CellResult& result) const {
        const double parts = std::pow(2.0, cells_.dimension() * part.halvings);
        const double floor = noise * noise * largest_ * largest_;
        const double length = std::pow(result.sums.measure, 2.0 / cells_.dimension());
        const auto fits = [&](double whole, double sum, double share, double least) {
            return std::abs(sum - whole) <= options_.tolerance * std::max(sum, share / parts) + least;
        };
        return fits(part.sums.square, halves.square, square_share_, floor * halves.measure) &&
               (result.tangled ||
                fits(part.sums.slope, halves.slope, slope_share_, 100 * floor * halves.measure / length));
    }

    void refine(Batch& batch) {
        std::vector<Part> pending, next;
        std::vector<CellResult> refined(batch.end - batch.begin);
        for (std::size_t c = 0; c < refined.size(); ++c) {
            refined[c] = results_[batch.begin + c];
            Part whole{};
            whole.cell = static_cast<std::uint32_t>(c), whole.sums = refined[c].sums;
            pending.push_back(whole);
            const double maximum = refined[c].sums.maximum, measure = refined[c].sums.measure;
            refined[c].sums = {.maximum = maximum};
            results_[batch.begin + c].sums.measure = measure;
        }
        std::size_t parts_left = options_.parts * batch_cells;
        while (!pending.empty()) {
            next.clear();
            for (std::size_t from = 0; from < pending.size(); from += block)
                halve(std::span(pending).subspan(from, std::min(block, pending.size() - from)), batch,
                      refined, next, parts_left);
            pending.swap(next);
        }
        for (std::size_t c = 0; c < refined.size(); ++c) {
            refined[c].tangled = refined[c].tangled || batch.tangled[c] != 0;
            results_[batch.begin + c] = refined[c];
        }
    }

    /// Integrates over the halves of some parts; those that are not close enough become the next ones.
    void halve(std::span<const Part> parts, Batch& batch, std::vector<CellResult>& refined,
               std::vector<Part>& next, std::size_t& parts_left) const {
        std::vector<CellPart> halves;
        for (const Part& part : parts) cells_.halve(part, halves);
        std::vector<ErrorSums> sums;
        cells_.integrate(halves, batch, sums);
        const std::size_t each = halves.size() / parts.size();
        for (std::size_t p = 0; p < parts.size(); ++p) {
            CellResult& result = refined[parts[p].cell];
            ErrorSums all;
            for (std::size_t h = p * each; h < (p + 1) * each; ++h) all.add(sums[h]);
            const bool enough = close(parts[p], all, results_[batch.begin + parts[p].cell]);
            const bool possible =
                parts[p].halvings + 1 < options_.halvings && parts_left >= each && !result.tangled;
            if (!enough && possible) {
                parts_left -= each;
                for (std::size_t h = p * each; h < (p + 1) * each; ++h) next.push_back({halves[h], sums[h]});
                continue;
            }
            if (!enough) result.unresolved = true;
            result.sums.add(all);
            result.change_square += std::abs(all.square - parts[p].sums.square);
            result.change_slope += std::abs(all.slope - parts[p].sums.slope);
        }
    }

    InterpolationError result() const {
        InterpolationError found;
        for (auto& cells : found.cells) cells.reserve(results_.size());
        ErrorSums all;
        double change_square = 0, change_slope = 0, half_maximum = 0;
        for (const CellResult& one : results_) {
            const double slope = one.tangled ? std::numeric_limits<double>::quiet_NaN() : one.sums.slope;
            found.cells[0].push_back(std::sqrt(one.sums.square));
            found.cells[1].push_back(one.sums.maximum);
            found.cells[2].push_back(std::sqrt(slope));
            all.add(one.sums);
            change_square += one.change_square, change_slope += one.change_slope;
            half_maximum = std::max(half_maximum, one.half_maximum);
            found.tangled_cells += one.tangled ? 1 : 0;
            found.unresolved_cells += one.unresolved ? 1 : 0;
        }
        found.measure = all.measure;
        if (all.maximum <= noise * largest_) { // rounding alone
            for (auto& cells : found.cells) cells.assign(results_.size(), 0.0);
            return found;
        }
        found.norm = {std::sqrt(all.square), all.maximum, std::sqrt(all.slope)};
        if (found.tangled_cells > 0) found.norm[2] = std::numeric_limits<double>::quiet_NaN();
        const auto relative = [](double change, double of) { return of > 0 ? change / of : 0; };
        found.uncertainty = {relative(change_square / 2, all.square),
                             relative(std::abs(all.maximum - half_maximum), all.maximum),
                             relative(change_slope / 2, all.slope)};
        return found;
    }

    InterpolationCells cells_;
    InterpolationOptions options_;
    std::vector<CellResult> results_;
    double square_share_ = 0, slope_share_ = 0, largest_ = 0;
};

bool is_finite(const Points& x) {
    for (const auto* axis : {&x.x, &x.y, &x.z})
        for (const double value : *axis)
            if (!std::isfinite(value)) return false;
    return true;
}

/// Of nodes that lie nowhere.
InterpolationError no_error(std::size_t cells) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    InterpolationError found{.norm = {nan, nan, nan}, .measure = nan, .tangled_cells = cells};
    for (auto& values : found.cells) values.assign(cells, nan);
    return found;
}

} // namespace

InterpolationError interpolation_error(const Mesh& mesh, const Points& x, const Space& space,
                                       const ScalarFunction& u, const InterpolationOptions& options) {
    if (x.size() != mesh.node_count())
        throw InputError("interpolation_error: " + std::to_string(x.size()) + " positions for " +
                         std::to_string(mesh.node_count()) + " nodes");
    if (!is_finite(x)) return no_error(mesh.cell_count());
    return Measurement(mesh, x, space, u, options).run();
}

InterpolationComparison compare_interpolation(const Mesh& mesh, const Points& x, const Space& space,
                                              const ScalarFunction& u, const InterpolationOptions& options) {
    const auto measure = [&](const Points& at) {
        return std::make_shared<const InterpolationError>(interpolation_error(mesh, at, space, u, options));
    };
    return {.uniform = measure(mesh.nodes), .adapted = measure(x)};
}

} // namespace gaspard

#include "core/function/grid_function.hpp"

#include "core/base/check.hpp"
#include "core/base/finite_range.hpp"
#include "core/function/spline_filter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace gaspard {

namespace {

constexpr std::size_t ghosts = 2; ///< coefficients beyond each end

/// The rows of one direction d of the padded array, for one place in the directions above d. `inner` and
/// `outer` are the places below and above d in which the rows are.
struct Padded {
    std::array<std::size_t, 3> counts{1, 1, 1}, padded{1, 1, 1}, strides{1, 1, 1};
    std::size_t dimension = 1, size = 1;

    explicit Padded(const Grid& grid) : dimension(grid.directions.size()) {
        for (std::size_t d = 0; d < dimension; ++d) {
            counts[d] = grid.directions[d].count, padded[d] = counts[d] + 2 * ghosts;
            strides[d] = size, size *= padded[d];
        }
    }
    /// Calls visit(GridRows) for the rows of direction d; all of the padded array in the other directions.
    template <class Visit>
    void each(std::vector<double>& c, std::size_t d, const Visit& visit) const {
        const std::size_t block = strides[d] * padded[d];
        for (std::size_t start = 0; start < size; start += block)
            visit(GridRows{c.data() + start + ghosts * strides[d], counts[d], strides[d], strides[d]});
    }
};

void unite_pole(std::span<double> row) {
    const double mean = std::accumulate(row.begin(), row.end(), 0.0) / static_cast<double>(row.size());
    std::fill(row.begin(), row.end(), mean);
}

std::vector<double> padded_values(const Grid& grid, const Padded& array, std::span<const double> values) {
    std::vector<double> c(array.size, 0.0);
    const auto [nx, ny, nz] = array.counts;
    const bool poles = array.dimension > 1 && grid.directions[1].ends == GridEnds::poles;
    const std::size_t y0 = array.dimension > 1 ? ghosts : 0, z0 = array.dimension > 2 ? ghosts : 0;
    for (std::size_t k = 0; k < nz; ++k)
        for (std::size_t j = 0; j < ny; ++j) {
            double* row = c.data() + ghosts + (j + y0) * array.strides[1] + (k + z0) * array.strides[2];
            std::copy_n(values.data() + (k * ny + j) * nx, nx, row);
            if (poles && (j == 0 || j + 1 == ny)) unite_pole({row, nx});
        }
    return c;
}

std::vector<double> coefficients(const Grid& grid, std::span<const double> values) {
    const Padded array(grid);
    std::vector<double> c = padded_values(grid, array, values);
    const auto pole_rows = [&] { // without the ghosts of the longitudes
        return GridRows{c.data() + ghosts * array.strides[1] + ghosts, array.counts[1], array.counts[0],
                        array.strides[1]};
    };
    for (std::size_t d = 0; d < array.dimension; ++d)
        if (grid.directions[d].ends == GridEnds::poles)
            filter_poles(pole_rows());
        else
            array.each(c, d, [&](const GridRows& rows) { filter_rows(rows, grid.directions[d]); });
    for (std::size_t d = array.dimension; d-- > 0;) // latitudes before longitudes
        if (grid.directions[d].ends == GridEnds::poles)
            extend_poles(pole_rows());
        else
            array.each(c, d, [&](const GridRows& rows) { extend_rows(rows, grid.directions[d]); });
    return c;
}

struct Weights {
    std::ptrdiff_t cell;
    double value[4], slope[4]; ///< slopes with respect to s
};

/// B and B' at the four coefficients around t.
template <bool derivatives>
void weigh(double f, double inverse_spacing, Weights& w) {
    const double g = 1 - f, f2 = f * f, g2 = g * g;
    w.value[0] = g * g2 / 6;
    w.value[1] = (3 * f * f2 - 6 * f2 + 4) / 6;
    w.value[2] = (3 * g * g2 - 6 * g2 + 4) / 6;
    w.value[3] = f * f2 / 6;
    if constexpr (derivatives) {
        w.slope[0] = -0.5 * g2 * inverse_spacing;
        w.slope[1] = (1.5 * f2 - 2 * f) * inverse_spacing;
        w.slope[2] = (2 * g - 1.5 * g2) * inverse_spacing;
        w.slope[3] = 0.5 * f2 * inverse_spacing;
    }
}

} // namespace

GridFunction::GridFunction(Grid grid, std::span<const double> values) : grid_(std::move(grid)) {
    GASPARD_CHECK(grid_.directions.size() == grid_.chart->dimension());
    GASPARD_CHECK(values.size() == grid_.size() && finite_range(values));
    std::size_t stride = 1;
    for (std::size_t d = 0; d < grid_.directions.size(); ++d) {
        const GridDirection& direction = grid_.directions[d];
        const auto count = static_cast<double>(direction.count);
        Line line{.origin = grid_.coordinate(d, 0),
                  .inverse_spacing = 1 / grid_.spacing(d),
                  .count = count,
                  .low = direction.centred ? -0.5 : 0.0,
                  .high = direction.centred ? count - 0.5 : count - 1,
                  .ends = direction.ends,
                  .stride = stride};
        GASPARD_CHECK(direction.count >= 1);
        GASPARD_CHECK(!direction.centred || (line.ends != GridEnds::free && line.ends != GridEnds::poles));
        GASPARD_CHECK(line.ends != GridEnds::poles || (d == 1 && grid_.directions[0].count % 2 == 0));
        stride *= direction.count + 2 * ghosts;
        lines_.push_back(line);
    }
    coefficients_ = coefficients(grid_, values);
}

template <std::size_t dimension, bool derivatives>
void GridFunction::evaluate(const Points& s, double* values, Points* gradients) const {
    const std::array<const double*, 3> coordinates{s.x.data(), s.y.data(), s.z.data()};
    const std::array<Line, dimension> lines = [&] {
        std::array<Line, dimension> copy;
        std::copy_n(lines_.begin(), dimension, copy.begin());
        return copy;
    }();
    for (std::size_t i = 0; i < s.size(); ++i) {
        Weights w[dimension];
        const double* c = coefficients_.data();
        bool defined = true;
        for (std::size_t d = 0; d < dimension; ++d) {
            const Line& line = lines[d];
            double t = (coordinates[d][i] - line.origin) * line.inverse_spacing, beyond = 0;
            bool mirrored = false;
            double last = line.count - 2; // the last cell
            defined = defined && std::isfinite(t);
            if (!defined) break;
            switch (line.ends) {
            case GridEnds::periodic:
                t -= line.count * std::floor(t / line.count);
                last = line.count - 1;
                break;
            case GridEnds::reflecting: {
                const double length = line.high - line.low;
                if (t >= line.low && t <= line.high) {
                } else if (length > 0) {
                    const double way = t - line.low, turns = std::floor(way / length);
                    const double rest = way - turns * length;
                    mirrored = std::fmod(turns, 2.0) != 0;
                    t = line.low + (mirrored ? length - rest : rest);
                }
                last = std::floor(line.high);
                break;
            }
            case GridEnds::free:
            case GridEnds::poles: {
                const double inside = std::clamp(t, line.low, line.high);
                beyond = line.ends == GridEnds::free ? t - inside : 0.0;
                t = inside;
                break;
            }
            }
            const double cell = std::clamp(std::floor(t), std::floor(line.low), std::max(last, 0.0));
            weigh<derivatives>(t - cell, line.inverse_spacing, w[d]);
            w[d].cell = static_cast<std::ptrdiff_t>(cell);
            if (beyond != 0) {
                Weights slope;
                weigh<true>(t - cell, 1.0, slope);
                for (int k = 0; k < 4; ++k) w[d].value[k] += beyond * slope.slope[k];
            }
            if (derivatives && mirrored)
                for (double& slope : w[d].slope) slope = -slope;
            c += (w[d].cell + 1) * static_cast<std::ptrdiff_t>(line.stride);
        }
        if (!defined) {
            constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
            if (values) values[i] = nothing;
            if constexpr (derivatives) gradients->set(i, {nothing, nothing, nothing});
            continue;
        }
        const std::size_t rows = dimension > 1 ? 4 : 1, planes = dimension > 2 ? 4 : 1;
        double value = 0, dx = 0, dy = 0, dz = 0;
        for (std::size_t k = 0; k < planes; ++k) {
            double plane = 0, plane_x = 0, plane_y = 0;
            for (std::size_t j = 0; j < rows; ++j) {
                const double* row = c;
                if constexpr (dimension > 1) row += j * lines[1].stride;
                if constexpr (dimension > 2) row += k * lines[2].stride;
                const double* b = w[0].value;
                const double sum = b[0] * row[0] + b[1] * row[1] + b[2] * row[2] + b[3] * row[3];
                double weight = 1, slope = 0;
                if constexpr (dimension > 1) weight = w[1].value[j];
                plane += weight * sum;
                if constexpr (derivatives) {
                    if constexpr (dimension > 1) slope = w[1].slope[j];
                    const double* a = w[0].slope;
                    plane_x += weight * (a[0] * row[0] + a[1] * row[1] + a[2] * row[2] + a[3] * row[3]);
                    plane_y += slope * sum;
                }
            }
            double weight = 1, slope = 0;
            if constexpr (dimension > 2) weight = w[2].value[k];
            value += weight * plane;
            if constexpr (derivatives) {
                if constexpr (dimension > 2) slope = w[2].slope[k];
                dx += weight * plane_x, dy += weight * plane_y, dz += slope * plane;
            }
        }
        if (values) values[i] = value;
        if constexpr (derivatives) gradients->set(i, {dx, dy, dz});
    }
}

void GridFunction::evaluate(const Points& s, double* values, Points* gradients) const {
    const auto call = [&]<std::size_t dimension>() {
        gradients ? evaluate<dimension, true>(s, values, gradients)
                  : evaluate<dimension, false>(s, values, nullptr);
    };
    switch (lines_.size()) {
    case 1:
        return call.template operator()<1>();
    case 2:
        return call.template operator()<2>();
    default:
        return call.template operator()<3>();
    }
}

void GridFunction::values_at(const Points& s, std::span<double> values) const {
    GASPARD_CHECK(values.size() == s.size());
    evaluate(s, values.data(), nullptr);
}

void GridFunction::derivatives_at(const Points& s, Points& derivatives) const {
    derivatives.resize(s.size());
    evaluate(s, nullptr, &derivatives);
}

void GridFunction::values(const Points& x, std::span<double> values) const {
    if (grid_.chart->kind() == ChartKind::box) return values_at(x, values);
    Points s;
    grid_.chart->coordinates(x, s);
    values_at(s, values);
}

void GridFunction::gradients(const Points& x, Points& gradients) const {
    if (grid_.chart->kind() == ChartKind::box) return derivatives_at(x, gradients);
    Points s;
    grid_.chart->coordinates(x, s);
    if (grid_.chart->kind() == ChartKind::sphere)
        for (double& latitude : s.y) latitude = std::clamp(latitude, pole_margin - 90, 90 - pole_margin);
    derivatives_at(s, gradients);
    grid_.chart->to_cartesian(x, s, gradients);
}

} // namespace gaspard

#include "core/function/field_values.hpp"

#include "core/base/error.hpp"
#include "core/base/parameter.hpp"
#include "core/base/short_number.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace gaspard {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double largest_number = 1e150; ///< squares and differences are finite, too

void check_coordinates(const std::vector<double>& all) {
    for (const double one : all)
        if (std::isfinite(one) && std::abs(one) > largest_number)
            throw InputError("the field has the coordinate " + exact_number(one) +
                             "; beyond 10¹⁵⁰ coordinates are too large to be used");
}

double lowest(const std::vector<double>& values) {
    double low = std::numeric_limits<double>::infinity();
    for (const double one : values)
        if (std::isfinite(one)) low = std::min(low, one);
    return low;
}

std::string counted(std::size_t count, std::size_t all) {
    return std::to_string(count) + " of " + std::to_string(all) + " values " + (count == 1 ? "is" : "are");
}

/// The number of values that are missing afterwards.
std::size_t transform(std::vector<double>& values, FieldTransform how, std::vector<std::string>& notes) {
    if (how == FieldTransform::absolute)
        for (double& one : values) one = std::abs(one);
    if (how == FieldTransform::square)
        for (double& one : values) one = one * one;
    if (how == FieldTransform::logarithm) {
        std::size_t refused = 0;
        for (double& one : values) {
            refused += one <= 0 ? 1 : 0;
            one = one > 0 ? std::log10(one) : nothing;
        }
        if (refused > 0)
            notes.push_back(counted(refused, values.size()) + " not positive and has no logarithm.");
        if (refused > 1)
            notes.back() = counted(refused, values.size()) + " not positive and have no logarithms.";
    }
    for (const double one : values)
        if (std::isfinite(one) && std::abs(one) > largest_number)
            throw InputError("the field has the value " + exact_number(one) +
                             "; beyond 10¹⁵⁰ values are too large to be used");
    const std::size_t missing = count_missing(values);
    if (missing == values.size()) throw InputError("the field has no values that can be used");
    return missing;
}

void note_missing(std::size_t missing, std::size_t all, MissingValues how, std::vector<std::string>& notes) {
    if (how == MissingValues::error) refuse_missing(missing, all);
    notes.push_back(counted(missing, all) + " missing; the " +
                    (how == MissingValues::nearest ? "nearest ones stand" : "lowest one stands") +
                    " in for " + (missing == 1 ? "it." : "them."));
}

/// From present values to their neighbours, step by step.
void spread(GridData& grid) {
    const std::size_t nx = grid.count(0), ny = grid.count(1), plane = nx * ny;
    std::vector<std::uint32_t> front, next;
    for (std::size_t i = 0; i < grid.values.size(); ++i)
        if (std::isfinite(grid.values[i])) front.push_back(static_cast<std::uint32_t>(i));
    while (!front.empty()) {
        next.clear();
        for (const std::uint32_t at : front) {
            const std::size_t i = at % nx, j = at / nx % ny, k = at / plane;
            const auto give = [&](std::size_t to) {
                if (std::isfinite(grid.values[to])) return;
                grid.values[to] = grid.values[at];
                next.push_back(static_cast<std::uint32_t>(to));
            };
            if (i > 0) give(at - 1);
            if (i + 1 < nx) give(at + 1);
            if (j > 0) give(at - nx);
            if (j + 1 < ny) give(at + nx);
            if (k > 0) give(at - plane);
            if (k + 1 < grid.count(2)) give(at + plane);
        }
        front.swap(next);
    }
}

} // namespace

void refuse_missing(std::size_t missing, std::size_t all, const std::string& where) {
    throw InputError(counted(missing, all) + " missing" + where +
                     "; allow the nearest or the lowest to stand in (missing = nearest or floor)");
}

void prepare_values(GridData& grid, const FieldOptions& options, std::vector<std::string>& notes) {
    for (const auto& axis : grid.axes) check_coordinates(axis);
    const std::size_t missing = transform(grid.values, options.transform, notes);
    if (missing == 0) return;
    note_missing(missing, grid.values.size(), options.missing, notes);
    if (options.missing == MissingValues::nearest) return spread(grid);
    const double low = lowest(grid.values);
    for (double& one : grid.values) one = std::isfinite(one) ? one : low;
}

void prepare_values(ScatteredData& data, const FieldOptions& options, std::vector<std::string>& notes) {
    std::size_t without_place = 0, kept = 0;
    const std::size_t all = data.values.size();
    for (std::size_t p = 0; p < all; ++p)
        if (const Vec3 x = data.points[p]; !std::isfinite(x.x + x.y + x.z))
            data.values[p] = nothing, ++without_place;
    for (const auto* axis : {&data.points.x, &data.points.y, &data.points.z}) check_coordinates(*axis);
    const std::size_t missing = transform(data.values, options.transform, notes);
    if (missing == 0) return;
    note_missing(missing, all, options.missing, notes);
    const double low = lowest(data.values);
    for (std::size_t p = 0; p < all; ++p) {
        const Vec3 x = data.points[p];
        const bool placed = std::isfinite(x.x + x.y + x.z), present = std::isfinite(data.values[p]);
        if (!placed || (!present && options.missing == MissingValues::nearest))
            continue; // the fit goes on across it
        data.points.set(kept, x);
        data.values[kept++] = present ? data.values[p] : low;
    }
    data.points.resize(kept), data.values.resize(kept);
}

} // namespace gaspard

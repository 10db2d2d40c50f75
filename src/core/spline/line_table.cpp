#include "core/spline/line_table.hpp"

#include "core/base/check.hpp"

#include <array>
#include <utility>

namespace gaspard {

LineTable::LineTable(const KnotVector& space, std::span<const double> points, int derivatives)
    : functions_(space.size()), width_(static_cast<std::size_t>(space.degree) + 1), first_(points.size()),
      values_(static_cast<std::size_t>(derivatives + 1) * points.size() * width_) {
    std::vector<double> row(static_cast<std::size_t>(derivatives + 1) * width_);
    for (std::size_t q = 0; q < points.size(); ++q) {
        const std::size_t span = find_span(space, points[q]);
        first_[q] = span + 1 - width_;
        basis_functions(space, span, points[q], derivatives, row);
        for (std::size_t d = 0; d <= static_cast<std::size_t>(derivatives); ++d)
            for (std::size_t k = 0; k < width_; ++k)
                values_[(d * points.size() + q) * width_ + k] = row[d * width_ + k];
    }
}

namespace {

// The number of terms is a template parameter, so that the weights stay in registers.
template <std::size_t width>
void sum_lines(const double* weights, const double* lines, std::size_t length, double* __restrict out) {
    for (std::size_t c = 0; c < length; ++c) {
        double sum = weights[0] * lines[c];
        for (std::size_t k = 1; k < width; ++k) sum += weights[k] * lines[k * length + c];
        out[c] = sum;
    }
}

template <std::size_t width>
void add_to_lines(const double* weights, double scale, const double* in, std::size_t length,
                  double* __restrict lines) {
    std::array<double, width> scaled;
    for (std::size_t k = 0; k < width; ++k) scaled[k] = scale * weights[k];
    for (std::size_t k = 0; k < width; ++k)
        for (std::size_t c = 0; c < length; ++c) lines[k * length + c] += scaled[k] * in[c];
}

/// Calls call(std::integral_constant) for a width known at run time.
template <class Call>
void with_width(std::size_t width, const Call& call) {
    const auto choose = [&]<std::size_t... k>(std::index_sequence<k...>) {
        ((k + 1 == width ? call(std::integral_constant<std::size_t, k + 1>{}) : void()), ...);
    };
    choose(std::make_index_sequence<highest_degree + 1>{});
}

} // namespace

void LineTable::combine(int derivative, std::size_t point, const double* lines, std::size_t length,
                        double* out) const {
    const double* weights = row(derivative, point);
    with_width(width_,
               [&](auto width) { sum_lines<width>(weights, lines + first_[point] * length, length, out); });
}

void LineTable::combine_all(int derivative, const double* lines, std::size_t length, double* out) const {
    for (std::size_t q = 0; q < points(); ++q) combine(derivative, q, lines, length, out + q * length);
}

void LineTable::scatter(int derivative, std::size_t point, double scale, const double* in, std::size_t length,
                        double* lines, std::size_t from) const {
    const double* weights = row(derivative, point);
    with_width(width_, [&](auto width) {
        add_to_lines<width>(weights, scale, in, length, lines + (first_[point] - from) * length);
    });
}

} // namespace gaspard

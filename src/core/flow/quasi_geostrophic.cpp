#include "core/flow/quasi_geostrophic.hpp"

#include "core/base/check.hpp"
#include "core/base/error.hpp"
#include "core/base/parameter.hpp"
#include "core/base/short_number.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace gaspard {

namespace {

/// The six planes of a state.
struct Planes {
    const double *lower_left, *lower_right, *lower_top, *upper_left, *upper_right, *upper_top;

    Planes(const double* q, std::size_t plane)
        : lower_left(q), lower_right(q + plane), lower_top(q + 2 * plane), upper_left(q + 3 * plane),
          upper_right(q + 4 * plane), upper_top(q + 5 * plane) {}
};

/// The upwind flux through an edge, by its ends: flux times the integrals of q and the shape functions. q is
/// that of the side from which a positive flux comes, or of the other side.
inline void upwind(double flux, double from_first, double from_second, double to_first, double to_second,
                   double& first, double& second) {
    const double a = flux > 0 ? from_first : to_first, b = flux > 0 ? from_second : to_second;
    const double sixth = flux * (1.0 / 6);
    first = sixth * (2 * a + b);
    second = sixth * (a + 2 * b);
}

void check(const FlowOptions& options) {
    if (options.cells < 3 || options.cells > 4096)
        throw InputError("a flow has 3 to 4096 cells per side, not " + std::to_string(options.cells));
    if (!(options.froude >= 0 && std::isfinite(options.froude)))
        throw InputError("the Froude number of a flow must be at least 0 and finite");
    if (!(options.courant > 0 && options.courant <= 0.5))
        throw InputError("the Courant number of a flow must be positive and at most 0.5");
    if (!std::isfinite(options.background[0]) || !std::isfinite(options.background[1]))
        throw InputError("the background velocity of a flow must be finite");
}

} // namespace

QuasiGeostrophicFlow::QuasiGeostrophicFlow(const FlowOptions& options)
    : options_((check(options), options)), n_(options.cells), q_(corners * n_ * n_), stage_(q_.size()),
      other_(q_.size()), transform_(n_), load_(n_ * n_), psi_(n_ * n_), corners_before_(2 * n_),
      corners_now_(2 * n_), whole_psi_((n_ + 1) * (n_ + 1)) {
    for (EdgeRow* row : {&below_, &above_, &up_, &within_})
        for (std::vector<double>* values : {&row->flux, &row->first, &row->second}) values->resize(n_ + 1);
    const double area = 1 / static_cast<double>(n_ * n_), froude = options_.froude;
    const auto mass = [=](double a, double b) {
        return area * (0.5 + (std::cos(a) + std::cos(b) + std::cos(a + b)) / 6);
    };
    inverse_mass_ = transform_.factors([&](double a, double b) { return 1 / mass(a, b); });
    inverse_ = transform_.factors([&](double a, double b) {
        const double sine_a = std::sin(a / 2), sine_b = std::sin(b / 2);
        const double value = 4 * (sine_a * sine_a + sine_b * sine_b) + froude * mass(a, b);
        return a == 0 && b == 0 && froude == 0 ? 0 : -1 / value;
    });
}

void QuasiGeostrophicFlow::set_state(std::span<const double> q, double time) {
    if (q.size() != q_.size())
        throw InputError("the state of a flow with " + std::to_string(n_) + " cells per side has " +
                         std::to_string(q_.size()) + " values, not " + std::to_string(q.size()));
    if (!std::all_of(q.begin(), q.end(), [](double value) { return std::isfinite(value); }) ||
        !std::isfinite(time))
        throw InputError("the state of a flow has values that are not finite");
    if (options_.froude == 0) {
        double sum = 0, size = 0;
        for (const double value : q) sum += value, size += std::abs(value);
        if (std::abs(sum) > 1e-10 * size)
            throw InputError("with the Froude number 0 the mean of q must be 0, but it is " +
                             exact_number(sum / static_cast<double>(q.size())));
    }
    std::copy(q.begin(), q.end(), q_.begin());
    time_ = time;
    psi_is_current_ = false;
}

// (v, q) for the shape function v of every node: area / 12 (q_k + q_0 + q_1 + q_2) from each triangle.
void QuasiGeostrophicFlow::load(const std::vector<double>& q) {
    const double weight = 1 / (24 * static_cast<double>(n_ * n_));
    const Planes planes(q.data(), n_ * n_);
    const auto upper_corners = [&](std::size_t j, double* upper_left, double* upper_right) {
        for (std::size_t i = 0, at = j * n_; i < n_; ++i, ++at) {
            const double lower = planes.lower_left[at] + planes.lower_right[at] + planes.lower_top[at];
            const double upper = planes.upper_left[at] + planes.upper_right[at] + planes.upper_top[at];
            upper_left[i] = planes.upper_top[at] + upper;
            upper_right[i] = planes.lower_top[at] + lower + planes.upper_right[at] + upper;
        }
    };
    const auto lower_corners = [&](std::size_t j, double* lower_left, double* lower_right) {
        for (std::size_t i = 0, at = j * n_; i < n_; ++i, ++at) {
            const double lower = planes.lower_left[at] + planes.lower_right[at] + planes.lower_top[at];
            const double upper = planes.upper_left[at] + planes.upper_right[at] + planes.upper_top[at];
            lower_left[i] = planes.lower_left[at] + lower + planes.upper_left[at] + upper;
            lower_right[i] = planes.lower_right[at] + lower;
        }
    };
    double *left = corners_now_.data(), *right = left + n_;
    double *left_before = corners_before_.data(), *right_before = left_before + n_;
    upper_corners(n_ - 1, left_before, right_before);
    for (std::size_t j = 0; j < n_; ++j) {
        lower_corners(j, left, right);
        double* to = load_.data() + j * n_;
        to[0] = weight * (left[0] + right[n_ - 1] + left_before[0] + right_before[n_ - 1]);
        for (std::size_t i = 1; i < n_; ++i)
            to[i] = weight * (left[i] + right[i - 1] + left_before[i] + right_before[i - 1]);
        upper_corners(j, left_before, right_before);
    }
}

void QuasiGeostrophicFlow::solve_psi(const std::vector<double>& q) {
    load(q);
    transform_.apply(inverse_, load_, psi_);
    const double h = 1 / static_cast<double>(n_);
    for (std::size_t j = 0; j <= n_; ++j) {
        const double* row = psi_.data() + j % n_ * n_;
        double* whole = whole_psi_.data() + j * (n_ + 1);
        std::copy_n(row, n_, whole);
        whole[n_] = row[0];
    }
    const auto [ux, uy] = options_.background;
    if (ux == 0 && uy == 0) return;
    for (std::size_t j = 0; j <= n_; ++j)
        for (std::size_t i = 0; i <= n_; ++i)
            whole_psi_[j * (n_ + 1) + i] += h * (uy * static_cast<double>(i) - ux * static_cast<double>(j));
}

// The lower edges of the squares of row j, positive upwards; from left to right.
void QuasiGeostrophicFlow::find_edges_across(const double* q, std::size_t j, EdgeRow& row) const {
    const Planes planes(q, n_ * n_);
    const double* psi = whole_psi_.data() + j * (n_ + 1);
    const std::size_t above = j % n_ * n_, below = (j + n_ - 1) % n_ * n_;
    double *flux = row.flux.data(), *first = row.first.data(), *second = row.second.data();
    for (std::size_t i = 0; i < n_; ++i) {
        flux[i] = psi[i + 1] - psi[i];
        upwind(flux[i], planes.upper_top[below + i], planes.upper_right[below + i],
               planes.lower_left[above + i], planes.lower_right[above + i], first[i], second[i]);
    }
}

// The left edges of the squares of row j, positive to the right; upwards. The last is the first once more.
void QuasiGeostrophicFlow::find_edges_up(const double* q, std::size_t j) {
    const Planes planes(q, n_ * n_);
    const double *psi = whole_psi_.data() + j * (n_ + 1), *psi_above = psi + n_ + 1;
    const std::size_t at = j * n_;
    double *flux = up_.flux.data(), *first = up_.first.data(), *second = up_.second.data();
    const auto find = [&](std::size_t i, std::size_t left) {
        flux[i] = psi[i] - psi_above[i];
        upwind(flux[i], planes.lower_right[at + left], planes.lower_top[at + left], planes.upper_left[at + i],
               planes.upper_top[at + i], first[i], second[i]);
    };
    find(0, n_ - 1);
    for (std::size_t i = 1; i < n_; ++i) find(i, i - 1);
    flux[n_] = flux[0], first[n_] = first[0], second[n_] = second[0];
}

// The diagonals of the squares of row j, positive from the lower to the upper triangle; from the lower left.
void QuasiGeostrophicFlow::find_edges_within(const double* q, std::size_t j) {
    const Planes planes(q, n_ * n_);
    const double *psi = whole_psi_.data() + j * (n_ + 1), *psi_above = psi + n_ + 1;
    const std::size_t at = j * n_;
    double *flux = within_.flux.data(), *first = within_.first.data(), *second = within_.second.data();
    for (std::size_t i = 0; i < n_; ++i) {
        flux[i] = psi_above[i + 1] - psi[i];
        upwind(flux[i], planes.lower_left[at + i], planes.lower_top[at + i], planes.upper_left[at + i],
               planes.upper_right[at + i], first[i], second[i]);
    }
}

// next = f + s (q - f), f = now + dt L now: in this form the mean of q does not drift. On a triangle of area
// A, with outward fluxes F_k through the edges opposite to corners k, and q of mean qm,
// (q, u . grad v_k) = -F_k qm / 2; the inverse of its mass matrix is 12 / A (I - 1 1^T / 4).
void QuasiGeostrophicFlow::update_row(const double* now, std::size_t j, double dt, double share_of_start,
                                      double* next) const {
    const std::size_t plane = n_ * n_, at = j * n_;
    const double rate = 24 * static_cast<double>(plane) * dt;
    const double *below = below_.flux.data(), *below_1 = below_.first.data(), *below_2 = below_.second.data();
    const double *above = above_.flux.data(), *above_1 = above_.first.data(), *above_2 = above_.second.data();
    const double *up = up_.flux.data(), *up_1 = up_.first.data(), *up_2 = up_.second.data();
    const double *in = within_.flux.data(), *in_1 = within_.first.data(), *in_2 = within_.second.data();
    const double *q = now + at, *start = q_.data() + at;
    double* to = next + at;
    const auto put = [&](std::size_t i, std::size_t triangle, double r0, double r1, double r2) {
        const double quarter = 0.25 * (r0 + r1 + r2);
        const double r[3] = {r0, r1, r2};
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t p = (3 * triangle + k) * plane + i;
            const double forward = q[p] + rate * (r[k] - quarter);
            to[p] = forward + share_of_start * (start[p] - forward);
        }
    };
    for (std::size_t i = 0; i < n_; ++i) {
        const double half = (q[i] + q[plane + i] + q[2 * plane + i]) * (1.0 / 6);
        put(i, 0, below_1[i] - in_1[i] - half * up[i + 1], below_2[i] - up_1[i + 1] - half * in[i],
            half * below[i] - up_2[i + 1] - in_2[i]);
    }
    for (std::size_t i = 0; i < n_; ++i) {
        const double half = (q[3 * plane + i] + q[4 * plane + i] + q[5 * plane + i]) * (1.0 / 6);
        put(i, 1, up_1[i] + in_1[i] - half * above[i], in_2[i] - above_2[i] + half * up[i],
            up_2[i] - above_1[i] + half * in[i]);
    }
}

void QuasiGeostrophicFlow::stage(const std::vector<double>& now, double dt, double share_of_start,
                                 std::vector<double>& next) {
    find_edges_across(now.data(), 0, below_);
    for (std::size_t j = 0; j < n_; ++j) {
        find_edges_across(now.data(), j + 1, above_);
        find_edges_up(now.data(), j);
        find_edges_within(now.data(), j);
        update_row(now.data(), j, dt, share_of_start, next.data());
        std::swap(below_, above_);
    }
}

void QuasiGeostrophicFlow::step(double dt) {
    GASPARD_CHECK(dt >= 0);
    if (!psi_is_current_) solve_psi(q_);
    stage(q_, dt, 0, stage_);
    solve_psi(stage_);
    stage(stage_, dt, 3.0 / 4, other_);
    solve_psi(other_);
    stage(other_, dt, 1.0 / 3, stage_);
    std::swap(q_, stage_);
    psi_is_current_ = false;
    time_ += dt;
}

// Outflow of a triangle per time and area, the largest of all triangles. The fluxes sum to zero, so that the
// outflow is half of their absolute sum.
double QuasiGeostrophicFlow::largest_rate() const {
    double largest = 0;
    for (std::size_t j = 0; j < n_; ++j) {
        const double *psi = whole_psi_.data() + j * (n_ + 1), *above = psi + n_ + 1;
        for (std::size_t i = 0; i < n_; ++i) {
            const double diagonal = std::abs(above[i + 1] - psi[i]);
            const double lower = std::abs(psi[i + 1] - psi[i]) + std::abs(above[i + 1] - psi[i + 1]);
            const double upper = std::abs(above[i] - psi[i]) + std::abs(above[i + 1] - above[i]);
            largest = std::max(largest, diagonal + std::max(lower, upper));
        }
    }
    return largest * static_cast<double>(n_ * n_); // half the sum, over half a square
}

double QuasiGeostrophicFlow::stable_step() {
    psi();
    const double rate = largest_rate();
    return rate > 0 ? options_.courant / rate : std::numeric_limits<double>::infinity();
}

std::size_t QuasiGeostrophicFlow::advance(double duration, const std::stop_token& stop) {
    GASPARD_CHECK(duration >= 0 && std::isfinite(duration));
    const double end = time_ + duration;
    std::size_t steps = 0;
    for (double left = duration; left > 0; left = end - time_) {
        if (stop.stop_requested()) throw Interrupted();
        const double count = std::ceil(left / stable_step());
        if (!(count + static_cast<double>(steps) <= static_cast<double>(options_.most_steps)))
            throw InputError("the flow would need more than " + std::to_string(options_.most_steps) +
                             " steps until time " + exact_number(end));
        step(left / std::max(count, 1.0));
        ++steps;
        if (count <= 1) break;
    }
    time_ = end;
    return steps;
}

std::span<const double> QuasiGeostrophicFlow::psi() {
    if (!psi_is_current_) solve_psi(q_);
    psi_is_current_ = true;
    return psi_;
}

FlowDiagnostics QuasiGeostrophicFlow::diagnostics() {
    psi();
    load(q_);
    FlowDiagnostics result;
    const auto [low, high] = std::minmax_element(q_.begin(), q_.end());
    result.low = *low, result.high = *high;
    const std::size_t plane = n_ * n_;
    double mean = 0, squares = 0;
    for (std::size_t j = 0; j < n_; ++j) {
        double row_mean = 0, row_squares = 0, row_energy = 0;
        for (std::size_t i = j * n_; i < (j + 1) * n_; ++i) {
            for (std::size_t t = 0; t < 2; ++t) {
                const double a = q_[3 * t * plane + i], b = q_[(3 * t + 1) * plane + i],
                             c = q_[(3 * t + 2) * plane + i], sum = a + b + c;
                row_mean += sum;
                row_squares += a * a + b * b + c * c + sum * sum;
            }
            row_energy -= psi_[i] * load_[i];
        }
        mean += row_mean, squares += row_squares, result.energy += 0.5 * row_energy;
    }
    result.mean = mean / (6 * static_cast<double>(plane));
    result.enstrophy = squares / (48 * static_cast<double>(plane)); // 1/2, and area / 12 of a triangle
    return result;
}

void QuasiGeostrophicFlow::project(std::span<double> nodal) {
    GASPARD_CHECK(nodal.size() == n_ * n_);
    load(q_);
    transform_.apply(inverse_mass_, load_, nodal);
}

} // namespace gaspard

#include "core/flow/burgers.hpp"

#include "core/base/check.hpp"
#include "core/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

namespace gaspard {

namespace {

constexpr double smoothing_length = 1.0 / 25; // of all nodes
constexpr int start_sweeps = 60;              // of de Boor's algorithm at the start
constexpr int most_newton = 30;               // iterations of a stage
constexpr double newton_goal = 1e-13;
const double gamma_sdirk = 1 - 1 / std::numbers::sqrt2;

/// Solves a tridiagonal system by elimination; the rows are diagonally dominant enough for small steps.
void solve_tridiagonal(const std::vector<double>& lower, std::vector<double>& diagonal,
                       const std::vector<double>& upper, std::vector<double>& b) {
    const std::size_t n = b.size();
    for (std::size_t i = 1; i < n; ++i) {
        const double factor = lower[i] / diagonal[i - 1];
        diagonal[i] -= factor * upper[i - 1];
        b[i] -= factor * b[i - 1];
    }
    b[n - 1] /= diagonal[n - 1];
    for (std::size_t i = n - 1; i-- > 0;) b[i] = (b[i] - upper[i] * b[i + 1]) / diagonal[i];
}

/// (I - lambda delta^2) ms = m without flux through the ends.
void smooth(std::vector<double>& m) {
    const double lengths = smoothing_length * static_cast<double>(m.size()), lambda = lengths * lengths;
    std::vector<double> lower(m.size(), -lambda), upper = lower, diagonal(m.size(), 1 + 2 * lambda);
    diagonal.front() = diagonal.back() = 1 + lambda;
    solve_tridiagonal(lower, diagonal, upper, m);
}

/// The mass matrix on a mesh times u.
std::vector<double> mass_times(const std::vector<double>& x, const std::vector<double>& u) {
    std::vector<double> product(u.size());
    for (std::size_t k = 0; k + 1 < x.size(); ++k) {
        const double sixth = (x[k + 1] - x[k]) / 6;
        product[k] += sixth * (2 * u[k] + u[k + 1]);
        product[k + 1] += sixth * (u[k] + 2 * u[k + 1]);
    }
    return product;
}

std::vector<double> uniform_mesh(std::size_t cells) {
    std::vector<double> x(cells + 1);
    for (std::size_t i = 0; i <= cells; ++i) x[i] = static_cast<double>(i) / static_cast<double>(cells);
    return x;
}

void check_burgers(const BurgersOptions& options) {
    if (options.cells < 4 || options.cells > 4096)
        throw InputError("Burgers' equation is solved on 4 to 4096 cells, not " +
                         std::to_string(options.cells));
    for (const double value : {options.nu, options.alpha, options.courant})
        if (!(value > 0 && std::isfinite(value)))
            throw InputError("viscosity, intensity and Courant number of Burgers' equation must be positive");
}

} // namespace

BurgersData burgers_front(double nu, double x0) {
    return [=](double x, double t) { return (1 - std::tanh((x - x0 - t / 2) / (4 * nu))) / 2; };
}

BurgersData burgers_sine() {
    return [](double x, double) {
        if (x <= 0 || x >= 1) return 0.0;
        return std::sin(2 * std::numbers::pi * x) + std::sin(std::numbers::pi * x) / 2;
    };
}

Burgers::Burgers(const BurgersOptions& options, BurgersData data)
    : options_((check_burgers(options), options)), data_(std::move(data)), x_(uniform_mesh(options.cells)),
      u_(x_.size()), velocity_(x_.size()) {
    const auto sample = [&] {
        for (std::size_t i = 0; i < x_.size(); ++i) u_[i] = data_(x_[i], 0);
    };
    sample();
    for (int sweep = 0; options_.adapted && sweep < start_sweeps; ++sweep) {
        x_ = equidistributed();
        sample();
    }
}

void Burgers::set_state(std::span<const double> x, std::span<const double> u, double time) {
    GASPARD_CHECK(x.size() == x_.size() && u.size() == u_.size());
    x_.assign(x.begin(), x.end()), u_.assign(u.begin(), u.end());
    time_ = time;
}

std::vector<double> Burgers::equidistributed() const {
    const std::size_t n = options_.cells;
    std::vector<double> m(n), integral(n + 1);
    for (std::size_t k = 0; k < n; ++k)
        m[k] = std::hypot(1, options_.alpha * (u_[k + 1] - u_[k]) / (x_[k + 1] - x_[k]));
    smooth(m);
    for (std::size_t k = 0; k < n; ++k) integral[k + 1] = integral[k] + m[k] * (x_[k + 1] - x_[k]);
    std::vector<double> x = x_;
    for (std::size_t i = 1, k = 0; i < n; ++i) {
        const double wanted = integral[n] * static_cast<double>(i) / static_cast<double>(n);
        while (integral[k + 1] < wanted) ++k;
        x[i] = x_[k] + (wanted - integral[k]) / m[k];
    }
    return x;
}

/// u^2/2 - x' u - nu u_x, the mean on every cell.
std::vector<double> Burgers::fluxes(const std::vector<double>& mesh, const std::vector<double>& u) const {
    std::vector<double> flux(options_.cells);
    for (std::size_t k = 0; k < flux.size(); ++k) {
        const double a = u[k], b = u[k + 1], p = velocity_[k], q = velocity_[k + 1];
        flux[k] = (a * a + a * b + b * b - 2 * (a * p + b * q) - a * q - b * p) / 6 -
                  options_.nu * (b - a) / (mesh[k + 1] - mesh[k]);
    }
    return flux;
}

/// M u + weight (difference of fluxes) = right inside, boundary values outside; from the given u.
void Burgers::solve_stage(const std::vector<double>& right, const std::vector<double>& mesh, double weight,
                          double time, std::vector<double>& u) const {
    const std::size_t n = options_.cells;
    u[0] = data_(0, time), u[n] = data_(1, time);
    std::vector<double> lower(n + 1), diagonal(n + 1), upper(n + 1), b(n + 1);
    for (int iteration = 0; iteration < most_newton; ++iteration) {
        const std::vector<double> product = mass_times(mesh, u), flux = fluxes(mesh, u);
        std::fill(diagonal.begin(), diagonal.end(), 1.0);
        for (std::size_t i = 1; i < n; ++i) {
            const double left = mesh[i] - mesh[i - 1], next = mesh[i + 1] - mesh[i];
            const auto by_near = [&](double own, double other, double vo, double vt) { // of 6 flux
                return 2 * own + other - 2 * vo - vt;
            };
            const double v = velocity_[i], vl = velocity_[i - 1], vr = velocity_[i + 1];
            lower[i] = left / 6 - weight * (by_near(u[i - 1], u[i], vl, v) / 6 + options_.nu / left);
            upper[i] = next / 6 + weight * (by_near(u[i + 1], u[i], vr, v) / 6 - options_.nu / next);
            diagonal[i] =
                (left + next) / 3 + weight * (by_near(u[i], u[i + 1], v, vr) / 6 + options_.nu / next -
                                              by_near(u[i], u[i - 1], v, vl) / 6 + options_.nu / left);
            b[i] = right[i] - product[i] - weight * (flux[i] - flux[i - 1]);
        }
        b[0] = b[n] = 0;
        solve_tridiagonal(lower, diagonal, upper, b);
        double change = 0, size = 1;
        for (std::size_t i = 0; i <= n; ++i) {
            u[i] += b[i];
            change = std::max(change, std::abs(b[i])), size = std::max(size, std::abs(u[i]));
        }
        if (!std::isfinite(change) || !std::isfinite(size)) break;
        if (change < newton_goal * size || (iteration > 3 && change < 1e-10 * size)) return;
    }
    throw InputError("the solution of Burgers' equation was lost at t = " + std::to_string(time) +
                     "; more cells or a larger nu may help");
}

void Burgers::step(double dt) {
    GASPARD_CHECK(dt > 0);
    const std::vector<double> end = options_.adapted ? equidistributed() : x_;
    std::vector<double> between = x_, u = u_;
    for (std::size_t i = 0; i < x_.size(); ++i) {
        velocity_[i] = (end[i] - x_[i]) / dt;
        between[i] += gamma_sdirk * (end[i] - x_[i]);
    }
    std::vector<double> right = mass_times(x_, u_);
    solve_stage(right, between, gamma_sdirk * dt, time_ + gamma_sdirk * dt, u);
    const std::vector<double> flux = fluxes(between, u);
    for (std::size_t i = 1; i + 1 < right.size(); ++i)
        right[i] -= (1 - gamma_sdirk) * dt * (flux[i] - flux[i - 1]);
    solve_stage(right, end, gamma_sdirk * dt, time_ + dt, u);
    x_ = end, u_ = std::move(u);
    time_ += dt;
}

double Burgers::stable_step() const {
    double thinnest = 1, fastest = 1e-6;
    for (std::size_t k = 0; k < options_.cells; ++k) thinnest = std::min(thinnest, x_[k + 1] - x_[k]);
    for (const double value : u_) fastest = std::max(fastest, std::abs(value));
    return options_.courant * thinnest / fastest;
}

void Burgers::advance(double duration, const std::stop_token& stop) {
    GASPARD_CHECK(duration >= 0 && std::isfinite(duration));
    const double end = time_ + duration;
    for (double left = duration; left > 0; left = end - time_) {
        if (stop.stop_requested()) throw Interrupted();
        const double count = std::ceil(left / stable_step());
        step(left / std::max(count, 1.0));
        if (count <= 1) break;
    }
    time_ = end;
}

double l2_error(const Burgers& equation, const BurgersData& exact) {
    const double third = std::sqrt(0.6), places[3] = {(1 - third) / 2, 0.5, (1 + third) / 2},
                 weights[3] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
    double sum = 0;
    for (std::size_t k = 0; k + 1 < equation.x().size(); ++k)
        for (std::size_t q = 0; q < 3; ++q) {
            const double left = equation.x()[k], width = equation.x()[k + 1] - left, s = places[q];
            const double u = (1 - s) * equation.u()[k] + s * equation.u()[k + 1];
            const double e = u - exact(left + s * width, equation.time());
            sum += weights[q] * width * e * e;
        }
    return std::sqrt(sum);
}

} // namespace gaspard

#include "core/transport/transport_newton.hpp"

#include "core/base/error.hpp"
#include "core/linear/gmres.hpp"

#include <cmath>

namespace gaspard {

TransportNewton transport_newton(TransportForm& form, RecoveryPreconditioner& preconditioner,
                                 const TransportDensities& densities, std::vector<double>& unknowns,
                                 const TransportNewtonLimits& limits, std::stop_token stop) {
    constexpr std::size_t memory = 60;
    Gmres gmres(form.size(), memory);
    std::vector<double> w(form.size());
    TransportNewton result;
    form.evaluate(densities, unknowns);
    while (true) {
        const double residual = form.normalised_residual();
        result.converged = residual <= limits.tolerance;
        if (result.converged || !std::isfinite(residual) ||
            result.inner.size() >= static_cast<std::size_t>(limits.steps))
            return result;
        form.linearise();
        preconditioner.factorise(form.derivatives(), stop);
        const auto solved = gmres.solve(
            [&](std::span<const double> v, std::span<double> out) { form.derivative(v, out); },
            [&](std::span<const double> r, std::span<double> out) { preconditioner.solve(r, out); },
            form.residual(), w, {limits.inner_tolerance, limits.inner}, stop);
        if (stop.stop_requested()) throw Interrupted();
        result.inner.push_back(solved.iterations);
        for (std::size_t i = 0; i < w.size(); ++i) unknowns[i] += w[i];
        form.evaluate(densities, unknowns);
    }
}

} // namespace gaspard

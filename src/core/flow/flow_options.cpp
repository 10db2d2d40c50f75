#include "core/flow/flow_options.hpp"

#include "core/base/check.hpp"
#include "core/base/random.hpp"

namespace gaspard {

std::vector<double> noise_values(std::size_t n, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::vector<double> values(n * n);
    for (double& value : values) value = 2 * uniform(random) - 1;
    return values;
}

std::vector<double> nodal_values(std::size_t n, const std::function<double(double, double)>& f) {
    std::vector<double> values(n * n);
    const auto at = [n](std::size_t i) { return static_cast<double>(i) / static_cast<double>(n); };
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i) values[j * n + i] = f(at(i), at(j));
    return values;
}

std::vector<double> continuous_state(std::size_t n, std::span<const double> nodal) {
    GASPARD_CHECK(nodal.size() == n * n);
    std::vector<double> q(6 * n * n);
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t right = (i + 1) % n, above = (j + 1) % n, at = j * n + i;
            const double corners[6] = {nodal[at], nodal[j * n + right],     nodal[above * n + right],
                                       nodal[at], nodal[above * n + right], nodal[above * n + i]};
            for (std::size_t k = 0; k < 6; ++k) q[k * n * n + at] = corners[k];
        }
    return q;
}

} // namespace gaspard

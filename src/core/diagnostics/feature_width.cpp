#include "core/diagnostics/feature_width.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace gaspard {

double share_within_cell(const Mesh& mesh, std::span<const double> m) {
    if (m.empty()) return 0;
    const auto [least, most] = std::minmax_element(m.begin(), m.end());
    const double range = *most / *least;
    if (!(*least > 0) || !(range > 1.01) || !std::isfinite(range)) return 0;
    const auto corners = static_cast<std::size_t>(corners_per_cell(mesh.kind));
    std::vector<double> ratios(mesh.cell_count());
    for (std::size_t i = 0; i < mesh.cell_count(); ++i) {
        const auto nodes = mesh.cell(i).first(corners);
        double low = *most, high = *least;
        for (const std::int32_t node : nodes) {
            low = std::min(low, m[static_cast<std::size_t>(node)]);
            high = std::max(high, m[static_cast<std::size_t>(node)]);
        }
        ratios[i] = high / low;
    }
    const auto few = static_cast<std::ptrdiff_t>(ratios.size() / 100);
    const auto exceeded = ratios.end() - 1 - few;
    std::nth_element(ratios.begin(), exceeded, ratios.end());
    return std::log(*exceeded) / std::log(range);
}

} // namespace gaspard

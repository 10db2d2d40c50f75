// Consecutive numbers for the nodes that some cells use.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gaspard {

/// Renumbers the nodes in `names` consecutively: returns the distinct nodes in ascending order and replaces
/// each entry of `names` by its position among them.
inline std::vector<std::size_t> number_anew(std::vector<std::int32_t>& names, std::size_t node_count) {
    std::vector<std::int32_t> place(node_count, -1);
    for (const auto node : names) place[static_cast<std::size_t>(node)] = 0;
    std::vector<std::size_t> nodes;
    for (std::size_t i = 0; i < node_count; ++i)
        if (place[i] == 0) {
            place[i] = static_cast<std::int32_t>(nodes.size());
            nodes.push_back(i);
        }
    for (auto& name : names) name = place[static_cast<std::size_t>(name)];
    return nodes;
}

} // namespace gaspard

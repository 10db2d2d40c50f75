// What view.pick names: a cell or a node of the mesh.
#pragma once

#include "core/mesh/mesh.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace gaspard {

/// A cell or a node by its number in the mesh.
struct Pick {
    enum class Kind { cell, node };
    Kind kind = Kind::cell;
    std::uint32_t index = 0;
    friend bool operator==(const Pick&, const Pick&) = default;
};

/// "cell 12", "node 7"
std::string format_pick(const Pick& pick);
/// Nothing for an empty text. Throws InputError if the text names neither a cell nor a node.
std::optional<Pick> parse_pick(std::string_view text);
/// Whether the mesh has this cell or node.
bool has(const Mesh& mesh, const Pick& pick);

} // namespace gaspard

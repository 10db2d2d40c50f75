#include "core/tessellate/pick.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <charconv>

namespace gaspard {

std::string format_pick(const Pick& pick) {
    return (pick.kind == Pick::Kind::cell ? "cell " : "node ") + std::to_string(pick.index);
}

std::optional<Pick> parse_pick(std::string_view text) {
    if (text.empty()) return std::nullopt;
    Pick pick;
    const std::string_view kind = text.substr(0, 5),
                           number = text.substr(std::min<std::size_t>(5, text.size()));
    pick.kind = kind == "node " ? Pick::Kind::node : Pick::Kind::cell;
    const auto [end, code] = std::from_chars(number.data(), number.data() + number.size(), pick.index);
    const bool right = code == std::errc{} && end == number.data() + number.size();
    if (!right || (kind != "cell " && kind != "node "))
        throw InputError("view.pick = '" + std::string(text) +
                         "' is neither a cell nor a node: 'cell 12', 'node 7'");
    return pick;
}

bool has(const Mesh& mesh, const Pick& pick) {
    return pick.index < (pick.kind == Pick::Kind::cell ? mesh.cell_count() : mesh.node_count());
}

} // namespace gaspard

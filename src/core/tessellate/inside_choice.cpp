#include "core/tessellate/inside_choice.hpp"

#include "core/base/error.hpp"
#include "core/base/join.hpp"
#include "core/base/number_text.hpp"
#include "core/mesh/mesh.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

namespace gaspard {

namespace {

constexpr std::string_view directions = "ijk";

std::vector<std::string_view> parts_of(std::string_view text, std::string_view separator) {
    std::vector<std::string_view> words;
    for (const std::string_view word : split(text, separator))
        if (!word.empty()) words.push_back(word);
    return words;
}

[[noreturn]] void refuse_layers(std::string_view text) {
    throw InputError("view.layers = '" + std::string(text) +
                     "' must name layers of cells, counted from 0, such as 'i 4 to 11; k 0'");
}

std::uint32_t layer_number(std::string_view text, std::string_view word) {
    std::uint32_t number = 0;
    const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (code != std::errc() || end != word.data() + word.size()) refuse_layers(text);
    return number;
}

std::array<LayerRange, 3> parse_layers(std::string_view text) {
    std::array<LayerRange, 3> ranges;
    if (parts_of(text, " ").empty()) return ranges;
    std::array<bool, 3> said{};
    for (const std::string_view part : split(text, ";")) {
        const auto words = parts_of(part, " ");
        const bool range = words.size() == 4 && words[2] == "to";
        if ((words.size() != 2 && !range) || words[0].size() != 1) refuse_layers(text);
        const std::size_t direction = directions.find(words[0]);
        if (direction == std::string_view::npos || std::exchange(said[direction], true)) refuse_layers(text);
        const std::uint32_t first = layer_number(text, words[1]);
        ranges[direction] = {first, range ? layer_number(text, words[3]) : first};
        if (ranges[direction].first > ranges[direction].last) refuse_layers(text);
    }
    return ranges;
}

[[noreturn]] void refuse_only(std::string_view text, const std::vector<std::string>& names) {
    throw InputError("view.only = '" + std::string(text) +
                     "' must be conditions such as 'jacobian < 0.5', joined by 'and', on one of: value, " +
                     join(names, ", "));
}

/// What cells can be coloured by.
std::vector<std::string> value_names(const Values& view) {
    for (const ParameterRow& row : view.rows()) {
        if (row.key != "color") continue;
        std::vector<std::string> names = row.choices;
        std::erase(names, "none");
        return names;
    }
    return {};
}

std::vector<CellCondition> parse_only(const Values& view) {
    const std::string& text = view.text("only");
    std::vector<CellCondition> conditions;
    if (parts_of(text, " ").empty()) return conditions;
    const auto names = value_names(view);
    constexpr std::array<std::pair<std::string_view, Relation>, 4> relations = {{{"<=", Relation::at_most},
                                                                                 {">=", Relation::at_least},
                                                                                 {"<", Relation::below},
                                                                                 {">", Relation::above}}};
    for (const std::string_view part : split(text, " and ")) {
        const auto relation = std::find_if(relations.begin(), relations.end(), [&](const auto& one) {
            return part.find(one.first) != std::string_view::npos;
        });
        if (relation == relations.end()) refuse_only(text, names);
        const std::size_t place = part.find(relation->first);
        const auto name = parts_of(part.substr(0, place), " "),
                   bound = parts_of(part.substr(place + relation->first.size()), " ");
        if (name.size() != 1 || bound.size() != 1) refuse_only(text, names);
        const auto number = parse_number(bound[0]);
        const bool known =
            name[0] == "value" || std::find(names.begin(), names.end(), name[0]) != names.end();
        if (!number || !known) refuse_only(text, names);
        conditions.push_back({std::string(name[0]), relation->second, *number});
    }
    return conditions;
}

} // namespace

bool CellCondition::holds(double value) const {
    switch (relation) {
    case Relation::below:
        return value < bound;
    case Relation::at_most:
        return value <= bound;
    case Relation::above:
        return value > bound;
    case Relation::at_least:
        return value >= bound;
    }
    return false;
}

const std::vector<std::string>& inside_keys() {
    static const std::vector<std::string> keys = {"cut", "cut_cells", "peel", "layers", "only", "explode"};
    return keys;
}

InsideChoice inside_choice(const Values& view) {
    return {.cut = parse_cut(view.text("cut")),
            .whole_cells = view.text("cut_cells") == "whole",
            .peel = static_cast<std::uint32_t>(view.integer("peel")),
            .layers = parse_layers(view.text("layers")),
            .only = parse_only(view),
            .explode = view.real("explode")};
}

void check_layers(const InsideChoice& choice, const Mesh& mesh) {
    for (std::size_t d = 0; d < 3; ++d) {
        if (choice.layers[d] == LayerRange{}) continue;
        if (mesh.lattice[d] == 0)
            throw InputError("view.layers is only for meshes whose cells are a lattice");
        const auto count = static_cast<std::uint32_t>(mesh.lattice[d]);
        if (choice.layers[d].last >= count)
            throw InputError("view.layers: the mesh has " + std::to_string(count) +
                             " layers of cells in direction " + directions[d] + ", counted from 0");
    }
}

} // namespace gaspard

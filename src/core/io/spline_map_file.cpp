#include "core/io/spline_map_file.hpp"

#include "core/method/spline_map.hpp"

#include <nlohmann/json.hpp>

namespace gaspard {

std::optional<std::string> spline_map_json(const State& state) {
    const auto map = spline_map(state);
    if (!map) return std::nullopt;
    nlohmann::ordered_json json;
    json["what"] = std::string("Psi, from the parameter ") + (map->size() == 2 ? "square" : "cube") +
                   " to itself, as splines; the mesh is F(Psi)";
    for (const SplineFunction& function : *map) {
        nlohmann::ordered_json component;
        for (const KnotVector& direction : function.space.directions) {
            component["degrees"].push_back(direction.degree);
            component["knots"].push_back(direction.knots);
        }
        component["coefficients"] = function.coefficients;
        json["components"].push_back(std::move(component));
    }
    return json.dump(1) + '\n';
}

} // namespace gaspard

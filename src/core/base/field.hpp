// One number for every node or cell of a mesh: what it is called and how it is shown.
#pragma once

#include "core/base/export.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gaspard GASPARD_API {

enum class FieldPlace { node, cell };

struct FieldInfo {
    std::string name{};   ///< "jacobian": the array in files, and the choice of view.color
    std::string label{};  ///< for a legend: "Jacobian"
    std::string symbol{}; ///< as the source writes it; may be empty
    std::string unit{};   ///< may be empty
    FieldPlace place = FieldPlace::node;
    /// The value in the middle of a diverging colour map; 0 for values of both signs, which have no
    /// logarithm.
    std::optional<double> centre{};
    std::string help{}; ///< one line

    bool is_signed() const { return centre && *centre == 0; }
};

/// The values are in the mesh's numbering.
struct Field : FieldInfo {
    std::vector<double> values{};
    /// The values that an automatic range of colours spans, for fields that are compared; default: all
    /// values.
    std::optional<std::pair<double, double>> range{};
};

} // namespace GASPARD_API

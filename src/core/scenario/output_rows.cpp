#include "core/scenario/output_rows.hpp"

namespace gaspard {

std::vector<ParameterRow> output_rows() {
    return {{.key = "formats",
             .label = "Formats",
             .kind = ParameterKind::text,
             .default_value = std::string("obj,glb"),
             .help = "mesh formats to write, separated by commas; see `gaspard list formats`"},
            {.key = "curve_tolerance",
             .label = "Curve tolerance",
             .minimum = 1e-5,
             .maximum = 0.1,
             .scale = ParameterScale::logarithmic,
             .default_value = default_curve_tolerance,
             .help = "maximum distance of obj-curved and glb-curved from the curved cells, relative to the "
                     "mesh size"}};
}

} // namespace gaspard

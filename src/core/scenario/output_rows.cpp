#include "core/scenario/output_rows.hpp"

namespace gaspard {

std::vector<ParameterRow> output_rows() {
    return {{.key = "formats",
             .label = "Formats",
             .kind = ParameterKind::text,
             .default_value = std::string("obj,glb"),
             .help = "mesh formats to write, separated by commas; see `gaspard list formats`"}};
}

} // namespace gaspard

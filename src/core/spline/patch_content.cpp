#include "core/spline/patch_content.hpp"

namespace gaspard {

DomainContent read_patch_content(const Values& values, const std::filesystem::path& folder,
                                 std::size_t directions) {
    auto content = std::make_shared<PatchContent>();
    try {
        content->found = find_patch(values.text("file"), folder, values.text("patch"), directions);
    } catch (const std::exception&) {
        content->error = std::current_exception();
    }
    return content;
}

FoundPatch patch_of_content(const Values& values, const std::filesystem::path& folder,
                            const DomainContent& content, std::size_t directions) {
    const auto* read = static_cast<const PatchContent*>(content.get());
    if (read && read->error) std::rethrow_exception(read->error);
    return read ? *read->found : find_patch(values.text("file"), folder, values.text("patch"), directions);
}

std::vector<ParameterRow> cells_and_degree_rows(double most, std::int64_t usual, const std::string& of) {
    return {{.key = "cells",
             .label = "Cells per side",
             .symbol = "n",
             .kind = ParameterKind::integer,
             .minimum = 4,
             .maximum = most,
             .scale = ParameterScale::logarithmic,
             .default_value = usual,
             .help = "number of cells per side; " + of},
            {.key = "degree",
             .label = "Degree",
             .symbol = "p",
             .kind = ParameterKind::integer,
             .minimum = 2,
             .maximum = highest_degree,
             .default_value = std::int64_t{3},
             .help = "spline degree; the splines have p − 1 continuous derivatives"}};
}

ParameterRow patch_row() {
    return {.key = "patch",
            .label = "Patch",
            .kind = ParameterKind::text,
            .default_value = std::string(),
            .help = "which patch of a file that has several: its number, from 1, or id:ID with its id "
                    "in the file; if empty, the first",
            .role = ParameterRole::patch};
}

} // namespace gaspard

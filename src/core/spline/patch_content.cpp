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

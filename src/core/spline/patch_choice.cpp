#include "core/spline/patch_choice.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

namespace gaspard {

namespace {

std::string name_of(const PatchEntry& entry) {
    return entry.kind + (entry.id.empty() ? "" : ", id " + entry.id);
}

/// "BSpline, id 3 is a curve, not a surface; ...", once for each kind.
std::string refusals(const std::vector<PatchEntry>& entries) {
    std::vector<std::string> kinds;
    std::string text;
    for (const PatchEntry& entry : entries) {
        const bool list = entry.kind == "MultiPatch" && entries.size() > 1; // its patches say more
        if (list || std::find(kinds.begin(), kinds.end(), entry.kind) != kinds.end()) continue;
        if (kinds.size() == 3) return text + "; ...";
        text += (kinds.empty() ? "" : "; ") + name_of(entry) + " is " + entry.refusal;
        kinds.push_back(entry.kind);
    }
    return text;
}

std::optional<std::size_t> parse_index(const std::string& text) {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return index;
}

[[noreturn]] void refuse_choice(const PatchText& file, std::size_t count, bool ids,
                                const std::string& which = {}) {
    throw InputError("domain.patch = '" + file.which + "': " + file.origin + " has " + std::to_string(count) +
                     (count == 1 ? " patch" : " patches") + which + "; give a number from 1 to " +
                     std::to_string(count) + (ids ? ", or id:ID with an id of the file" : ""));
}

/// Index among all entries of the chosen one; `readable` are the indices of those that can be read.
std::size_t find_entry(const std::vector<PatchEntry>& all, const std::vector<std::size_t>& readable,
                       const PatchText& file) {
    constexpr std::string_view by_id = "id:";
    if (file.which.empty() && !readable.empty()) return readable.front();
    const bool any_id =
        std::any_of(all.begin(), all.end(), [](const PatchEntry& one) { return !one.id.empty(); });
    if (file.which.starts_with(by_id)) {
        const std::string id = file.which.substr(by_id.size());
        std::optional<std::size_t> found; // ids are unique only among geometries of one kind of element
        for (std::size_t i = all.size(); i-- > 0 && !id.empty();) {
            if (all[i].id != id) continue;
            const bool both = found && all[i].refusal.empty() && all[*found].refusal.empty();
            if (both) refuse_choice(file, readable.size(), false, " (several of them with this id)");
            if (!found || all[i].refusal.empty() || !all[*found].refusal.empty()) found = i;
        }
        if (found) return *found;
        if (!readable.empty()) refuse_choice(file, readable.size(), any_id);
    }
    if (readable.empty()) return 0;
    const auto index = parse_index(file.which);
    if (!index || *index < 1 || *index > readable.size()) refuse_choice(file, readable.size(), any_id);
    return readable[*index - 1];
}

} // namespace

void cannot_read(const std::string& origin, const std::string& why) {
    throw InputError("cannot read a patch from " + origin + ": " + why);
}

std::string refusal_of_directions(std::size_t directions, const PatchText& file) {
    static const std::array<const char*, 4> names = {"a point", "a curve", "a surface", "a solid"};
    static const std::array<const char*, 4> domains = {"", "", "spline-patch", "spline-solid"};
    if (directions == file.directions) return {};
    const std::string not_wanted = std::string(", not ") + names.at(file.directions);
    if (directions >= names.size())
        return "a spline of " + std::to_string(directions) + " directions" + not_wanted;
    const std::string domain = domains.at(directions);
    return names.at(directions) + not_wanted +
           (domain.empty() ? "" : " (domain.type = " + domain + " reads it)");
}

ChosenPatch choose_patch(const std::vector<PatchEntry>& entries, const PatchText& file) {
    std::vector<std::size_t> readable;
    for (std::size_t i = 0; i < entries.size(); ++i)
        if (entries[i].refusal.empty()) readable.push_back(i);
    if (entries.empty()) cannot_read(file.origin, "it has no patch");
    ChosenPatch chosen{.entry = find_entry(entries, readable, file), .origin = file.origin};
    const PatchEntry& entry = entries[chosen.entry];
    if (!entry.refusal.empty()) {
        const bool by_id = !entry.id.empty() && file.which == "id:" + entry.id;
        cannot_read(file.origin, by_id ? name_of(entry) + " is " + entry.refusal : refusals(entries));
    }
    if (readable.size() == 1) return chosen;
    PatchList list;
    for (std::size_t i = 0; i < readable.size(); ++i) {
        if (readable[i] == chosen.entry) list.chosen = i;
        list.labels.push_back(std::to_string(i + 1) + ": " + name_of(entries[readable[i]]));
    }
    const std::string place =
        "patch " + std::to_string(list.chosen + 1) + " of " + std::to_string(readable.size());
    list.note = place + " (" + name_of(entry) + ")";
    chosen.origin += ", " + place + ",";
    chosen.patches = std::make_shared<const PatchList>(std::move(list));
    return chosen;
}

} // namespace gaspard

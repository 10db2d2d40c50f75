#include "core/io/run_folder.hpp"

#include "core/base/error.hpp"
#include "core/base/read_file.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>

namespace gaspard {

namespace {

/// Of the run whose record this is; nothing if it cannot be read.
std::optional<std::string> scenario_of(const std::filesystem::path& record) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(record, ignored)) return std::nullopt; // a pipe might never end
    try {
        const auto json = nlohmann::json::parse(read_file(record), nullptr, false);
        if (const auto name = json.find("scenario");
            json.is_object() && name != json.end() && name->is_string())
            return name->get<std::string>();
    } catch (const InputError&) { // there is none
    }
    return std::nullopt;
}

} // namespace

std::string record_json(const Scenario& scenario) {
    const nlohmann::ordered_json json{{"scenario", scenario.name}, {"modified", scenario.modified}};
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

std::string first_present(const std::filesystem::path& folder, const std::vector<std::string>& names) {
    std::error_code ignored; // a folder that cannot be looked into cannot be written to either
    for (const std::string& name : names)
        if (std::filesystem::is_regular_file(folder / name, ignored)) return name;
    return {};
}

void check_no_folders(const std::filesystem::path& folder, const std::vector<std::string>& names) {
    std::error_code ignored; // as above
    for (const std::string& name : names)
        if (std::filesystem::is_directory(folder / name, ignored))
            throw InputError((folder / name).string() + " is a folder, but a file of that name would be "
                                                        "written; choose another folder with --out");
}

void check_replaceable(const std::filesystem::path& folder, const std::vector<std::string>& names,
                       const std::string& record, const std::string& scenario) {
    const std::string present = first_present(folder, names);
    if (present.empty()) return;
    const auto other = scenario_of(folder / record);
    if (other == scenario) return;
    throw InputError(
        (folder / present).string() + " would be replaced, but " +
        (other ? "it belongs to a run of scenario '" + *other + "'"
               : "no " + record + " says that it belongs to a run of scenario '" + scenario + "'") +
        "; choose another folder with --out, or add --overwrite");
}

std::vector<std::string> left_over(const std::filesystem::path& folder, const std::vector<std::string>& all,
                                   const std::vector<std::string>& written) {
    std::vector<std::string> names;
    std::error_code ignored; // one that cannot be seen
    for (const std::string& name : all)
        if (std::find(written.begin(), written.end(), name) == written.end() &&
            std::filesystem::exists(folder / name, ignored))
            names.push_back(name);
    return names;
}

std::filesystem::path free_folder(const std::filesystem::path& base, const std::vector<std::string>& names) {
    std::filesystem::path folder = base;
    std::error_code ignored;
    const auto taken = [&] { // also by a file where a folder is needed
        return !first_present(folder, names).empty() ||
               (std::filesystem::exists(folder, ignored) && !std::filesystem::is_directory(folder, ignored));
    };
    for (int number = 2; taken(); ++number)
        folder = base.parent_path() / (base.filename().string() + "-" + std::to_string(number));
    return folder;
}

} // namespace gaspard

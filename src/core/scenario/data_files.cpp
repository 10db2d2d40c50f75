#include "core/scenario/data_files.hpp"

#include "core/base/data_uri.hpp"
#include "core/base/error.hpp"
#include "core/base/fnv1a.hpp"
#include "core/base/read_file.hpp"
#include "core/base/user_path.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace gaspard {

namespace {

constexpr std::array sections = {&Scenario::domain, &Scenario::monitor, &Scenario::source, &Scenario::method,
                                 &Scenario::pde};

/// Replaces the path of every file.
Scenario with_files(Scenario scenario,
                    const std::function<std::string(const std::filesystem::path&)>& other) {
    for (const auto section : sections) {
        Values& values = (scenario.*section).values;
        for (const ParameterRow& row : std::vector<ParameterRow>(values.rows())) {
            if (row.role != ParameterRole::file) continue;
            const std::string text = values.text(row.key);
            if (is_path(text))
                values.set(row.key, other(std::filesystem::absolute(user_path(text, scenario.folder))));
        }
    }
    return scenario;
}

/// "2 MB", for people.
std::string megabytes(std::uintmax_t bytes) { return std::to_string((bytes + (1U << 19)) >> 20) + " MB"; }

} // namespace

bool has_data_files(const Scenario& scenario) {
    for (const auto section : sections) {
        const Values& values = (scenario.*section).values;
        for (const ParameterRow& row : values.rows())
            if (row.role == ParameterRole::file && is_path(values.text(row.key))) return true;
    }
    return false;
}

std::uint64_t hash_of_data(const Scenario& scenario) {
    std::uint64_t hash = fnv1a_start;
    with_files(scenario, [&](const std::filesystem::path& file) {
        hash = fnv1a(read_file(file), hash);
        return file.string();
    });
    return hash;
}

Scenario with_absolute_paths(Scenario scenario) {
    return with_files(std::move(scenario), [](const auto& file) { return file.string(); });
}

Scenario with_relative_paths(Scenario scenario, const std::filesystem::path& folder) {
    const auto base = folder.lexically_normal();
    scenario = with_files(std::move(scenario), [&](const std::filesystem::path& file) {
        const auto normal = file.lexically_normal();
        auto shared = base.begin(), other = normal.begin();
        std::ptrdiff_t names = 0;
        for (; shared != base.end() && other != normal.end() && *shared == *other; ++shared, ++other) ++names;
        const bool only_root = names <= 1;
        return only_root ? normal.string() : normal.lexically_relative(base).string();
    });
    scenario.folder = folder;
    return scenario;
}

Scenario with_packed_data(Scenario scenario) {
    std::uintmax_t left = most_packed_data;
    return with_files(std::move(scenario), [&](const std::filesystem::path& file) {
        std::error_code failed;
        const std::uintmax_t size = std::filesystem::file_size(file, failed);
        if (!failed && size > left)
            throw InputError(file.string() +
                             " cannot be packed into the scenario: its data would have more than " +
                             megabytes(most_packed_data) + "; save the scenario beside its data instead");
        const std::string bytes = read_file(file, left);
        left -= bytes.size();
        return data_uri(bytes, media_type_of(file));
    });
}

} // namespace gaspard

#include "core/base/growing_values.hpp"

#include "core/base/check.hpp"

#include <algorithm>

namespace gaspard {

namespace {

bool same_keys(const std::vector<ParameterRow>& a, const std::vector<ParameterRow>& b) {
    return std::equal(
        a.begin(), a.end(), b.begin(), b.end(),
        [](const ParameterRow& one, const ParameterRow& other) { return one.key == other.key; });
}

} // namespace

Values grown_values(const std::string& section, const std::vector<ParameterRow>& first,
                    const std::function<std::vector<ParameterRow>(const Values&)>& further,
                    const std::function<void(Values&)>& fill) {
    constexpr int most = 16; // rounds: parts of parts are only a few levels deep
    Values values(section, first);
    fill(values);
    for (int round = 0; round < most; ++round) {
        std::vector<ParameterRow> rows = first;
        for (ParameterRow& row : further(values)) rows.push_back(std::move(row));
        const bool same = same_keys(rows, values.rows());
        values = Values(section, std::move(rows));
        fill(values);
        if (same) return values;
    }
    check_failed("rows that depend on values come to an end");
}

Values grown_part(const Values& values, std::string_view prefix, const std::vector<ParameterRow>& first,
                  const std::function<std::vector<ParameterRow>(const Values&)>& further) {
    const std::string begin(prefix);
    return grown_values(
        values.section() + "." + begin.substr(0, begin.find_last_not_of('.') + 1), without_ranges(first),
        [&](const Values& known) { return without_ranges(further(known)); },
        [&](Values& own) {
            for (const ParameterRow& row : std::vector(own.rows()))
                if (const std::string key = begin + row.key; values.has(key))
                    own.set(row.key, values.at(key));
        });
}

} // namespace gaspard

#include "core/function/source.hpp"

#include "core/base/error.hpp"
#include "core/base/join.hpp"

#include <algorithm>
#include <utility>

namespace gaspard {

SourceType formula_source();
SourceType image_source();
SourceType field_source();
SourceType flow_source();

const std::vector<SourceType>& source_types() {
    static const std::vector<SourceType> all = {formula_source(), image_source(), field_source(),
                                                flow_source()};
    return all;
}

bool is_offered(const SourceType& type, const Space& space) {
    return (type.solids || !space.solid) &&
           (type.spaces.empty() ||
            std::find(type.spaces.begin(), type.spaces.end(), space.kind) != type.spaces.end());
}

const SourceType& source_type(std::string_view name) {
    std::vector<std::string> known;
    for (const SourceType& type : source_types()) {
        if (type.name == name) return type;
        known.push_back(type.name);
    }
    throw InputError("unknown type '" + std::string(name) + "'" + did_you_mean(name, known) +
                     "; available: " + join(known, ", "));
}

std::vector<ParameterRow> all_rows(const SourceType& type, const Values& values, const Space& space) {
    std::vector<ParameterRow> rows = type.rows(space);
    if (type.further_rows)
        for (ParameterRow& row : type.further_rows(values, space)) rows.push_back(std::move(row));
    return rows;
}

std::string key_name(const Values& values, std::string_view key) {
    return values.section() + "." + std::string(key);
}

std::vector<ParameterRow> prefixed(std::vector<ParameterRow> rows, std::string_view prefix) {
    const std::string begin(prefix);
    for (ParameterRow& row : rows) {
        row.key = begin + row.key;
        if (!row.point.empty()) row.point = begin + row.point;
        if (!row.former_key.empty()) row.former_key = begin + row.former_key;
    }
    return rows;
}

} // namespace gaspard

// Sources: the types of scalar functions that a user can choose, such as a formula, an image or a field from
// a file. A monitor is made of one (monitor/source_monitor.hpp) or of several, each with its own part of the
// monitor's rows: keys of a part have a prefix that the source does not know.
#pragma once

#include "core/base/parameter.hpp"
#include "core/function/scalar_function.hpp"
#include "core/mesh/data_context.hpp"
#include "core/mesh/space.hpp"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

/// A function that a source has made, and what it says about it.
struct MadeFunction {
    std::shared_ptr<const ScalarFunction> function;
    std::vector<std::string> notes{}; ///< sentences for people
    /// By keys of text rows, the values that they may take: the variables of a file.
    std::map<std::string, std::vector<std::string>> choices{};
    std::string advice{}; ///< what to do if no mesh can follow it; may be empty
};

/// A type of function as the user sees it. To add one, write a file with its rows and `make`, and add a line
/// to source.cpp. Messages name a row with key_name(values, key).
struct SourceType {
    std::string name;
    std::string label;
    std::string help;
    std::function<std::vector<ParameterRow>(const Space&)> rows;
    /// Throws InputError.
    std::function<MadeFunction(const Values&, const DataContext&)> make;
    /// Further rows that depend on the values of `rows`, such as the parameters of a formula; a row on which
    /// they depend has the role defines_rows. Throws InputError if the values are invalid. May be empty.
    std::function<std::vector<ParameterRow>(const Values&, const Space&)> further_rows{};
    bool solids = true;              ///< offered on solids
    std::vector<SpaceKind> spaces{}; ///< offered on these alone; empty: all
};

/// Whether a source is offered on a domain.
bool is_offered(const SourceType& type, const Space& space);

/// All sources, in the order in which users see them.
const std::vector<SourceType>& source_types();
/// Throws InputError if there is none with this name.
const SourceType& source_type(std::string_view name);
/// `rows` and `further_rows` together.
std::vector<ParameterRow> all_rows(const SourceType& type, const Values& values, const Space& space);

/// "monitor.u.expression", for messages.
std::string key_name(const Values& values, std::string_view key);

/// Rows of a part: their keys, and the points that they belong to, begin with the prefix ("u.").
std::vector<ParameterRow> prefixed(std::vector<ParameterRow> rows, std::string_view prefix);

} // namespace gaspard

// The parameters that a study varies, and their values, from texts.
#pragma once

#include "core/scenario/catalogue.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

/// A parameter and its values, written as for --set.
struct StudyAxis {
    std::string key{};                 ///< "domain.cells"; empty: nothing varies
    std::vector<std::string> values{}; ///< different from each other
    friend bool operator==(const StudyAxis&, const StudyAxis&) = default;
};

/// The row of a key of domain, monitor, method, PDE or time; null if there is none, as for types.
const ParameterRow* study_row(const Scenario& scenario, std::string_view key);
/// Why it makes no difference which value this key of time or of the monitor has: no time passes, another
/// rule is used, a motion sets the value. Empty: it may make one. Throws InputError if the motion is invalid.
std::string why_without_effect(const Scenario& scenario, std::string_view key);

/// An axis from a text such as "method.type=bakhvalov,shishkin", "domain.cells=8,16,32",
/// "domain.cells=8:1024" (times two), "pde.eps=1:1e-8" (by powers of ten) or "monitor.q=0.1:0.9:9" (nine
/// values, evenly on the scale of the row). `option` names it in messages. Throws InputError if there is no
/// such key, if a value is not allowed, or is there twice.
StudyAxis parse_study_axis(const Catalogue& catalogue, const Scenario& scenario, std::string_view text,
                           const std::string& option);
/// The same for numbers alone, which are put in order.
StudyAxis parse_study_numbers(const Catalogue& catalogue, const Scenario& scenario, std::string_view text,
                              const std::string& option);

} // namespace gaspard

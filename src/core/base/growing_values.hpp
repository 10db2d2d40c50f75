// Values whose rows depend on values: the constants of a formula, the rows of a part of the chosen type, and
// the constants of the formula that this part may be.
#pragma once

#include "core/base/parameter.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

/// Values of the rows `first` and of those that `further` returns for them. `further` gets the values of all
/// rows known so far and may thus return rows that depend on further ones. `fill` sets the values that are
/// known already, as far as the rows are there; the others have their defaults. Passes on what both throw.
Values grown_values(const std::string& section, const std::vector<ParameterRow>& first,
                    const std::function<std::vector<ParameterRow>(const Values&)>& further,
                    const std::function<void(Values&)>& fill);

/// The values of a part of a section, whose keys in `values` begin with the prefix ("u."); the part's own
/// rows are without it. Its section is "monitor.u" for the prefix "u." of "monitor". Ranges are not checked.
Values grown_part(const Values& values, std::string_view prefix, const std::vector<ParameterRow>& first,
                  const std::function<std::vector<ParameterRow>(const Values&)>& further);

} // namespace gaspard

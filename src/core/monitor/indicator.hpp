// The indicator q >= 0 of a function u on the grid of a domain (monitor/derived.hpp).
#pragma once

#include "core/monitor/derived.hpp"
#include "core/monitor/domain_grid.hpp"

#include <string>
#include <vector>

namespace gaspard {

struct IndicatorValues {
    std::vector<double> q; ///< at the points of the grid
    double background = 0; ///< the indicator is background + q: 1 or 0
    bool constant = false; ///< u is
};

/// `fine`: q is averaged over the part of the domain that a point of the grid stands for, which matters where
/// it varies from point to point; otherwise it is that of the point. Throws InputError where u, or what is
/// needed of its derivatives, is not finite; Interrupted if asked to stop.
IndicatorValues indicator_on(const DomainGrid& domain, const ScalarFunction& u, const DerivedOptions& options,
                             bool fine, const DataContext& context);

} // namespace gaspard

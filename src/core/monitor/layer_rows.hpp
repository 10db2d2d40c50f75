// Rows that monitors and methods for boundary layers share: a layer decays as exp(-beta d / eps) with the
// distance d from a side, q is the share of cells in it, sigma the order of the grading (Hill, Madden 2021,
// (8), (18)).
#pragma once

#include "core/base/parameter.hpp"

#include <optional>
#include <string>
#include <vector>

namespace gaspard {

/// A width of a layer, or "auto": that of the problem.
ParameterRow layer_width_row(const std::string& key, const std::string& symbol);
/// The width of layers with this key among the values of a problem; for "eps" the smallest if it has several.
/// nullopt if it has none, or if `pde` is null.
std::optional<double> layer_width_of(const Values* pde, const std::string& key);
/// The weight K of a layer; where it is "auto", that which gives it the share q of the cells.
double layer_weight_of(const Values& values);
/// q, sigma and beta.
std::vector<ParameterRow> layer_shape_rows();

} // namespace gaspard

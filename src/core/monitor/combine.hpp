// A monitor made of others, m_1 to m_N, each with a weight w_i > 0 and a power p_i:
//
//   t_i = w_i m_i^p_i
//
//   sum      m = sum of t_i                     product  m = product of t_i
//   maximum  m = (sum of t_i^s)^(1/s)           minimum  m = (sum of t_i^-s)^(-1/s)
//
// The smooth maximum lies between max t_i and N^(1/s) max t_i, the smooth minimum between N^(-1/s) min t_i
// and min t_i; both have gradients everywhere, which Newton's method needs. Without a sharpness s they are
// exact. Gradients follow from those of the parts by the chain rule. In a product the weights change nothing,
// as only ratios of m matter.
#pragma once

#include "core/base/export.hpp"
#include "core/monitor/monitor.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gaspard GASPARD_API {

enum class CombineOperation { sum, product, maximum, minimum };

struct CombinedPart {
    std::shared_ptr<const Monitor> monitor{};
    double power = 1;
    double weight = 1;
    std::string name{}; ///< of its field (Monitor::fields) and in its notes; may be empty: no field
};

struct CombineOptions {
    CombineOperation operation = CombineOperation::sum;
    std::optional<double> sharpness = 8; ///< s > 0 of maximum and minimum; nullopt: the exact ones
};

/// Throws InputError if there is no part, a part has no monitor, a power is not finite, or a weight or s is
/// not positive. A run refuses m where it is not finite, as it does every monitor of the caller's.
std::shared_ptr<const Monitor> combined_monitor(std::vector<CombinedPart> parts,
                                                const CombineOptions& options = {});

} // namespace GASPARD_API

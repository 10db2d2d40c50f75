// Common parts of the tables and figures of Hill, Madden (2021).
#pragma once

#include "core/published/mcrae_runs.hpp"

#include <string>
#include <vector>

namespace gaspard {

/// "ε = 1e-4"; for 1 "ε = 1".
std::string eps_title(const std::string& symbol, double eps);

/// Errors over N, one curve with markers per eps, and what the paper proves of them.
struct HillErrors {
    explicit HillErrors(const std::string& title);

    /// Starts the curve of another eps.
    void begin(const std::string& label);
    /// An error, and the bound of the paper without its constant.
    void add(int cells, double error, double bound);
    /// The curves, then the bounds in the same colours, without markers, with one entry in the legend.
    Plot plot(const std::string& bound) const;

  private:
    Plot plot_;
    std::vector<Curve> bounds_;
};

/// Tables 1 to 4, figures 4 and 7.
std::vector<Recipe> hill_interval_recipes();
/// Figures 10, 11, 13, 14.
std::vector<Recipe> hill_square_recipes();

} // namespace gaspard

#include "core/published/hill.hpp"

#include <cmath>
#include <utility>

namespace gaspard {

std::string eps_title(const std::string& symbol, double eps) {
    const auto exponent = static_cast<int>(std::lround(std::log10(eps)));
    return symbol + " = " + (exponent == 0 ? "1" : "1e" + std::to_string(exponent));
}

HillErrors::HillErrors(const std::string& title) : plot_{title, {"N", true}, {"energy error", true}, {}} {}

void HillErrors::begin(const std::string& label) {
    const std::size_t colour = bounds_.size();
    plot_.curves.push_back({label, {}, {}, true, colour});
    bounds_.push_back({"", {}, {}, false, colour});
}

void HillErrors::add(int cells, double error, double bound) {
    plot_.curves.back().x.push_back(cells), plot_.curves.back().y.push_back(error);
    bounds_.back().x.push_back(cells), bounds_.back().y.push_back(bound);
}

Plot HillErrors::plot(const std::string& bound) const {
    constexpr std::size_t neutral = 7; // the colour of no curve
    Plot plot = plot_;
    plot.curves.insert(plot.curves.end(), bounds_.begin(), bounds_.end());
    plot.curves.push_back({"without dots: " + bound, {}, {}, false, neutral}); // for the legend alone
    return plot;
}

std::vector<Recipe> hill_recipes() {
    std::vector<Recipe> all = hill_interval_recipes();
    for (auto& one : hill_square_recipes()) all.push_back(std::move(one));
    return all;
}

} // namespace gaspard

// Numbers that belong to an iterate as a whole, one value per iterate: what they are called and how they are
// shown. Plots, tables and files find them by name.
#pragma once

#include "core/base/error.hpp"
#include "core/base/export.hpp"
#include "core/base/parameter.hpp"

#include <array>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>

namespace gaspard GASPARD_API {

/// A plot that shows several series of a run together.
struct SharedPlot {
    std::string name;  ///< "jacobian"
    std::string label; ///< "Jacobian range"
    std::string part;  ///< which of them this one is: "min"
    friend bool operator==(const SharedPlot&, const SharedPlot&) = default;
};

struct SeriesInfo {
    std::string name{};   ///< "min_jacobian": the column in files, and the key in settings
    std::string label{};  ///< for people: "Min. Jacobian"
    std::string symbol{}; ///< as the source writes it: "θ"; may be empty
    std::string unit{};   ///< may be empty
    ParameterScale scale = ParameterScale::linear; ///< of the axis on which a plot shows it first
    std::string help{};                            ///< one line
    std::optional<SharedPlot> plot{};              ///< empty: a plot of its own
    bool measured = false; ///< known only where the mesh was measured (method.diagnostics_every)
    /// Whether histories, tables and mesh files have it beside the columns that they always have.
    bool column = true;
    /// Positive, and about the same for all maps: the run has diverged where it is not.
    bool bounded = false;
    friend bool operator==(const SeriesInfo&, const SeriesInfo&) = default;
};

/// Some numbers, without allocating.
class SeriesValues {
  public:
    static constexpr std::size_t capacity = 16;

    SeriesValues() = default;
    SeriesValues(std::initializer_list<double> values) {
        for (const double value : values) push_back(value);
    }
    void push_back(double value) {
        if (size_ == capacity) throw InternalError("internal fault: too many series in an evaluation");
        values_[size_++] = value;
    }
    std::size_t size() const { return size_; }
    double operator[](std::size_t i) const { return values_[i]; }
    const double* begin() const { return values_.data(); }
    const double* end() const { return values_.data() + size_; }

  private:
    std::array<double, capacity> values_{};
    std::size_t size_ = 0;
};

} // namespace GASPARD_API

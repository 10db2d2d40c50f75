// A ScalarFunction from a value and a gradient.
#pragma once

#include "core/function/scalar_function.hpp"

#include <functional>
#include <utility>

namespace gaspard {

class FunctionOf final : public ScalarFunction {
  public:
    using Value = std::function<double(Vec3)>;
    using Gradient = std::function<Vec3(Vec3)>;
    FunctionOf(Value value, Gradient gradient) : value_(std::move(value)), gradient_(std::move(gradient)) {}

    void values(const Points& x, std::span<double> values) const override {
        for (std::size_t i = 0; i < x.size(); ++i) values[i] = value_(x[i]);
    }
    void gradients(const Points& x, Points& gradients) const override {
        gradients.resize(x.size());
        for (std::size_t i = 0; i < x.size(); ++i) gradients.set(i, gradient_(x[i]));
    }

  private:
    Value value_;
    Gradient gradient_;
};

} // namespace gaspard

// A monitor from a formula: a value type with the functions value(Vec3) and gradient(Vec3), which the
// compiler inlines into the loop over the points.
#pragma once

#include "core/base/check.hpp"
#include "core/monitor/monitor.hpp"

namespace gaspard {

/// Formula::check() throws InputError if its parameters do not give a positive monitor.
template <class Formula>
class FormulaMonitor final : public Monitor {
  public:
    explicit FormulaMonitor(Formula formula) : formula_(formula) {}

    void values(const Points& x, std::span<double> values) const override {
        GASPARD_CHECK(values.size() == x.size());
        const Formula formula = formula_;
        const double *px = x.x.data(), *py = x.y.data(), *pz = x.z.data();
        double* __restrict out = values.data();
        for (std::size_t i = 0; i < values.size(); ++i) out[i] = formula.value({px[i], py[i], pz[i]});
    }
    void gradients(const Points& x, Points& gradients) const override {
        gradients.resize(x.size());
        for (std::size_t i = 0; i < x.size(); ++i) gradients.set(i, formula_.gradient(x[i]));
    }
    void check() const override { formula_.check(); }

  private:
    Formula formula_;
};

/// Rows for a centre in space: center_x, center_y, center_z, each in [-10, 10].
std::vector<ParameterRow> center_in_space_rows(Vec3 centre);
Vec3 center_in_space(const Values& values);

} // namespace gaspard

// Monitors that depend on the distance from a centre only:  m(x) = f(|x - c|^2).
// On the periodic square the distance is to the nearest image of the centre.
#pragma once

#include "core/base/exponential.hpp"
#include "core/monitor/monitor.hpp"

#include <cmath>

namespace gaspard {

/// m = 1 + A sech^2( B (|x - c|^2 - r^2) ): the ring (5.3) with r > 0, the bell (5.4) with r = 0.
class SechMonitor final : public Monitor {
  public:
    struct Parameters {
        double amplitude;      ///< A > -1
        double sharpness;      ///< B, in 1 / length^2; larger is narrower
        double radius_squared; ///< r^2
        Vec3 centre;           ///< c
    };
    SechMonitor(Parameters parameters, Space space) : p_(parameters), space_(space) {}

    void values(const Points& x, std::span<double> values) const override;
    void gradients(const Points& x, Points& gradients) const override;
    void check() const override;

  private:
    Parameters p_;
    Space space_;
};

/// 1 / cosh^2 without overflow: for large |t| it is 0 to double precision.
inline double sech_squared(double t) {
    const double e = exponential(-2 * std::abs(t));
    return 4 * e / ((1 + e) * (1 + e));
}
/// Throws InputError where the amplitude is not finite or not above `least`.
void check_amplitude(double amplitude, double least);

/// The rows that ring, bell and cross share; `where` and `half_height` complete their help.
ParameterRow amplitude_row(double maximum, double value, const std::string& where);
ParameterRow sharpness_row(double value, const std::string& half_height,
                           const std::string& unit = "1/length^2");
/// Of the centre: in the square, or on the sphere.
std::vector<ParameterRow> center_rows(const Space& space);

/// The monitor for such values, on the sphere by angles in place of distances; `radius` as a number, as not
/// all have the row.
std::shared_ptr<const Monitor> make_sech_monitor(const Values& values, double radius, const Space& space);

} // namespace gaspard

// Monitors that depend only on the distance from a centre:
//
//   m(x) = f( |x - c|^2 )
//
// On the periodic square, the distance is that to the nearest periodic image of c.
#pragma once

#include "core/base/exponential.hpp"
#include "core/monitor/monitor.hpp"

#include <cmath>

namespace gaspard {

/// McRae, Cotter, Budd: the ring (5.3) for r > 0, the bell (5.4) for r = 0.
///
///   m(x) = 1 + A sech^2( B (|x - c|^2 - r^2) )
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

/// sech^2 t = 1 / cosh^2 t without overflow; underflows to 0 for large |t|.
inline double sech_squared(double t) {
    const double e = exponential(-2 * std::abs(t));
    return 4 * e / ((1 + e) * (1 + e));
}
/// Throws InputError if the amplitude is not finite or not greater than `least`.
void check_amplitude(double amplitude, double least);

/// Rows shared by several monitors; `where` and `half_height` complete their help texts.
ParameterRow amplitude_row(double maximum, double value, const std::string& where);
ParameterRow sharpness_row(double value, const std::string& half_height,
                           const std::string& unit = "1/length²");
/// Rows for the centre: x, y and, for a surface in space, z; on the sphere latitude and longitude.
std::vector<ParameterRow> center_rows(const Space& space);

/// The distance from a point with such rows as a formula: "dist(center_x, center_y)".
std::string distance_formula(const Space& space, const std::string& point = "center");

/// The monitor for the values of these rows; on the sphere, angles replace distances. `radius` is a separate
/// argument because the bell has no such row.
std::shared_ptr<const Monitor> make_sech_monitor(const Values& values, double radius, const Space& space);

} // namespace gaspard

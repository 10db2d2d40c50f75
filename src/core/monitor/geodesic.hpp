// Monitors on the sphere that depend only on the angles from a few centres:
//
//   m(x) = offset + sum over the centres c of f(d),    d = angle between x and c, in radians
//
// Only the direction of x matters; its length |x| (the radius) scales the gradient by 1 / |x|.
#pragma once

#include "core/base/angle.hpp"
#include "core/base/check.hpp"
#include "core/monitor/radial.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace gaspard {

/// `Profile` has value(d) = f(d), slope(d) = f'(d) and check(), which throws InputError.
template <class Profile>
class GeodesicMonitor final : public Monitor {
  public:
    GeodesicMonitor(double offset, Profile profile, std::vector<Vec3> centres)
        : offset_(offset), profile_(profile), centres_(std::move(centres)) {}

    void values(const Points& x, std::span<double> values) const override {
        GASPARD_CHECK(values.size() == x.size());
        std::fill(values.begin(), values.end(), offset_);
        std::array<double, 256> angles; // points are processed in blocks of this size, without branches
        for (std::size_t begin = 0; begin < values.size(); begin += angles.size()) {
            const std::size_t count = std::min(angles.size(), values.size() - begin);
            double* __restrict out = values.data() + begin;
            for (const Vec3 centre : centres_) {
                const double *px = &x.x[begin], *py = &x.y[begin], *pz = &x.z[begin];
                for (std::size_t i = 0; i < count; ++i) angles[i] = angle_from(centre, px[i], py[i], pz[i]);
                const Profile profile = profile_;
                for (std::size_t i = 0; i < count; ++i) out[i] += profile.value(angles[i]);
            }
        }
    }

    /// Tangent to the sphere. A centre contributes 0 at itself and at its antipode.
    void gradients(const Points& x, Points& gradients) const override {
        gradients.resize(x.size());
        for (std::size_t i = 0; i < x.size(); ++i) {
            const double length = norm(x[i]);
            const Vec3 p = (1 / length) * x[i];
            Vec3 sum;
            for (const Vec3 centre : centres_) {
                const Vec3 towards = centre - dot(centre, p) * p; // length: sin d
                const double sine = norm(towards);
                if (sine < 1e-12) continue;
                sum = sum - (profile_.slope(angle_between(p, centre)) / (sine * length)) * towards;
            }
            gradients.set(i, sum);
        }
    }

    void check() const override { profile_.check(); }
    std::optional<Vec3> symmetry_axis() const override {
        return centres_.size() == 1 ? std::optional(centres_.front()) : std::nullopt;
    }

  private:
    double offset_;
    Profile profile_;
    std::vector<Vec3> centres_;
};

/// f(d) = A sech^2( B (d^2 - r^2) ): ring, bell, and each band of the cross.
struct SechProfile {
    double amplitude, sharpness, radius;

    double value(double d) const { return amplitude * sech_squared(sharpness * (d * d - radius * radius)); }
    double slope(double d) const;
    void check() const;
};

/// Rows for a point of the sphere: latitude and longitude in degrees. `prefix` of the keys: "center" or
/// "pole1"; `what` in the labels: "Centre" or "Pole 1".
std::vector<ParameterRow> place_rows(const std::string& prefix, const std::string& what, double latitude,
                                     double longitude);
Vec3 place_of(const Values& values, const std::string& prefix);

} // namespace gaspard

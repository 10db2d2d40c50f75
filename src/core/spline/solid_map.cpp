// The built-in solids of core/spline/patch_map.hpp.
#include "core/spline/map_place.hpp"
#include "core/spline/patch_map.hpp"

#include <cmath>
#include <numbers>

namespace gaspard {

namespace {

using std::numbers::pi;

/// A map from a function of xi that returns a Place. All of them are inlined, so that derivatives that are
/// not used are not computed.
template <class Formula>
class FormulaSolid final : public SolidMap {
  public:
    int space_dimension() const override { return 3; }
    void points(const Points& xi, Points& x) const override {
        x.resize(xi.size());
        for (std::size_t i = 0; i < xi.size(); ++i) x.set(i, Formula::at(xi[i]).x);
    }
    void tangents(const Points& xi, std::array<Points, 3>& tangents) const override {
        for (Points& one : tangents) one.resize(xi.size());
        for (std::size_t i = 0; i < xi.size(); ++i) {
            const Place<3> place = Formula::at(xi[i]);
            for (std::size_t d = 0; d < 3; ++d) tangents[d].set(i, place.first[d]);
        }
    }
    void places(const Points& xi, Points& x, std::span<double> element) const override {
        x.resize(xi.size());
        for (std::size_t i = 0; i < xi.size(); ++i) {
            const Place<3> place = Formula::at(xi[i]);
            x.set(i, place.x);
            element[i] = element_of(place);
        }
    }
    void element_gradients(const Points& xi, std::span<double> element, Points& gradient) const override {
        gradient.resize(xi.size());
        for (std::size_t i = 0; i < xi.size(); ++i) {
            const Element of = element_with_gradient(Formula::at(xi[i]));
            element[i] = of.value;
            gradient.set(i, of.gradient);
        }
    }
    bool is_identity() const override { return Formula::identity; }
};

struct Cube {
    static constexpr bool identity = true;
    [[gnu::always_inline]] static Place<3> at(Vec3 xi) {
        return {xi, {Vec3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {}};
    }
};

/// The disk X = u s(v), Y = v s(u), s(t) = sqrt(1 - t^2/2), u = 2 a - 1, v = 2 b - 1, with derivatives by a
/// and b.
struct DiskSection {
    double x, xa, xb, xab, xbb, y, ya, yb, yaa, yab;
};
[[gnu::always_inline]] inline DiskSection disk_section(double a, double b) {
    const double u = 2 * a - 1, v = 2 * b - 1;
    const double su = std::sqrt(1 - u * u / 2), sv = std::sqrt(1 - v * v / 2);
    const double du = -u / su, dv = -v / sv;                           // of su and sv by a and b
    const double ddu = -2 / (su * su * su), ddv = -2 / (sv * sv * sv); // s'' = -1 / (2 s^3)
    return {u * sv, 2 * sv, u * dv, 2 * dv, u * ddv, v * su, v * du, 2 * su, v * ddu, 2 * du};
}

struct Cylinder {
    static constexpr bool identity = false;
    [[gnu::always_inline]] static Place<3> at(Vec3 xi) {
        const DiskSection d = disk_section(xi.x, xi.y);
        return {{d.x, d.y, 2 * xi.z - 1},
                {Vec3{d.xa, d.ya, 0}, {d.xb, d.yb, 0}, {0, 0, 2}},
                {Vec3{0, d.yaa, 0}, {d.xab, d.yab, 0}, {}, {d.xbb, 0, 0}, {}, {}}};
    }
};

struct HalfTorus {
    static constexpr bool identity = false;
    [[gnu::always_inline]] static Place<3> at(Vec3 xi) {
        const DiskSection d = disk_section(xi.x, xi.y);
        const double r = 2 + d.x, c = std::cos(pi * xi.z), s = std::sin(pi * xi.z);
        return {{r * c, r * s, d.y},
                {Vec3{d.xa * c, d.xa * s, d.ya}, {d.xb * c, d.xb * s, d.yb}, {-pi * r * s, pi * r * c, 0}},
                {Vec3{0, 0, d.yaa},
                 {d.xab * c, d.xab * s, d.yab},
                 {-pi * d.xa * s, pi * d.xa * c, 0},
                 {d.xbb * c, d.xbb * s, 0},
                 {-pi * d.xb * s, pi * d.xb * c, 0},
                 {-pi * pi * r * c, -pi * pi * r * s, 0}}};
    }
};

/// s(p, q) = sqrt(1 - p^2/2 - q^2/2 + p^2 q^2/3) with its derivatives.
struct BallRoot {
    double s, p, q, pp, pq, qq;
};
[[gnu::always_inline]] inline BallRoot ball_root(double p, double q) {
    const double s = std::sqrt(1 - p * p / 2 - q * q / 2 + p * p * q * q / 3);
    const double gp = -p + 2 * p * q * q / 3, gq = -q + 2 * q * p * p / 3; // of s^2
    const double gpp = -1 + 2 * q * q / 3, gqq = -1 + 2 * p * p / 3, gpq = 4 * p * q / 3;
    const double half = 1 / (2 * s), cube = 1 / (4 * s * s * s);
    return {s,
            half * gp,
            half * gq,
            half * gpp - cube * gp * gp,
            half * gpq - cube * gp * gq,
            half * gqq - cube * gq * gq};
}

struct Ball {
    static constexpr bool identity = false;
    [[gnu::always_inline]] static Place<3> at(Vec3 xi) {
        const double u = 2 * xi.x - 1, v = 2 * xi.y - 1, w = 2 * xi.z - 1;
        const BallRoot a = ball_root(v, w), b = ball_root(w, u), c = ball_root(u, v);
        return {{u * a.s, v * b.s, w * c.s},
                {2 * Vec3{a.s, v * b.q, w * c.p}, 2 * Vec3{u * a.p, b.s, w * c.q},
                 2 * Vec3{u * a.q, v * b.p, c.s}},
                {4 * Vec3{0, v * b.qq, w * c.pp}, 4 * Vec3{a.p, b.q, w * c.pq}, 4 * Vec3{a.q, v * b.pq, c.p},
                 4 * Vec3{u * a.pp, 0, w * c.qq}, 4 * Vec3{u * a.pq, b.p, c.q},
                 4 * Vec3{u * a.qq, v * b.pp, 0}}};
    }
};

} // namespace

Points cube_middles(std::size_t side) {
    Points xi(side * side * side);
    const auto middle = [side](std::size_t i) {
        return (static_cast<double>(i) + 0.5) / static_cast<double>(side);
    };
    for (std::size_t i = 0; i < xi.size(); ++i)
        xi.set(i, {middle(i % side), middle(i / side % side), middle(i / side / side)});
    return xi;
}

std::shared_ptr<const SolidMap> cube_map() { return std::make_shared<FormulaSolid<Cube>>(); }
std::shared_ptr<const SolidMap> ball_map() { return std::make_shared<FormulaSolid<Ball>>(); }
std::shared_ptr<const SolidMap> cylinder_map() { return std::make_shared<FormulaSolid<Cylinder>>(); }
std::shared_ptr<const SolidMap> half_torus_map() { return std::make_shared<FormulaSolid<HalfTorus>>(); }

} // namespace gaspard

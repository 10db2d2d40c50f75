#include "core/spline/patch_map.hpp"

#include <cmath>
#include <numbers>

namespace gaspard {

namespace {

using std::numbers::pi;

/// A point of the surface and the two tangents.
struct SurfacePlace {
    Vec3 x, first, second;
};

/// The area element J and its derivatives, up to a common sign.
struct Area {
    double value, first, second;
};

/// A map from functions of (xi1, xi2) that return a SurfacePlace and an Area; unused members are optimised
/// away.
template <int dimension, class Formula>
class FormulaMap final : public PatchMap {
  public:
    int space_dimension() const override { return dimension; }
    void points(const Points& xi, Points& x) const override {
        x.resize(xi.size());
        for (std::size_t i = 0; i < xi.size(); ++i) x.set(i, Formula::at(xi.x[i], xi.y[i]).x);
    }
    void tangents(const Points& xi, std::array<Points, 2>& tangents) const override {
        for (Points& one : tangents) one.resize(xi.size());
        for (std::size_t i = 0; i < xi.size(); ++i) {
            const SurfacePlace place = Formula::at(xi.x[i], xi.y[i]);
            tangents[0].set(i, place.first);
            tangents[1].set(i, place.second);
        }
    }
    void places(const Points& xi, Points& x, std::span<double> area) const override {
        x.resize(xi.size());
        for (std::size_t i = 0; i < xi.size(); ++i) {
            const double a = xi.x[i], b = xi.y[i]; // read once: both formulas have parts in common
            x.set(i, Formula::at(a, b).x);
            area[i] = std::abs(Formula::area(a, b).value);
        }
    }
    void element_gradients(const Points& xi, std::span<double> area, Points& gradient) const override {
        gradient.resize(xi.size());
        for (std::size_t i = 0; i < xi.size(); ++i) {
            const Area of = Formula::area(xi.x[i], xi.y[i]);
            const double sign = of.value > 0 ? 1 : of.value < 0 ? -1 : 0;
            area[i] = sign * of.value;
            gradient.set(i, {sign * of.first, sign * of.second, 0});
        }
    }
    bool is_identity() const override { return Formula::identity; }
};

struct Square {
    static constexpr bool identity = true;
    static SurfacePlace at(double a, double b) { return {{a, b, 0}, {1, 0, 0}, {0, 1, 0}}; }
    static Area area(double, double) { return {1, 0, 0}; }
};

struct Disk {
    static constexpr bool identity = false;
    static SurfacePlace at(double a, double b) {
        const double u = 2 * a - 1, v = 2 * b - 1;
        const double su = std::sqrt(1 - u * u / 2), sv = std::sqrt(1 - v * v / 2);
        return {{u * sv, v * su, 0}, {2 * sv, -u * v / su, 0}, {-u * v / sv, 2 * su, 0}};
    }
    static Area area(double a, double b) { // J = 2 t / w
        const double u = 2 * a - 1, v = 2 * b - 1, t = 2 - u * u - v * v;
        const double uu = 1 - u * u / 2, vv = 1 - v * v / 2, w = std::sqrt(uu) * std::sqrt(vv);
        return {2 * t / w, 2 * u * (t / uu - 4) / w, 2 * v * (t / vv - 4) / w};
    }
};

struct QuarterAnnulus {
    static constexpr bool identity = false;
    static SurfacePlace at(double a, double b) {
        const double r = 0.5 + 0.5 * a, c = std::cos(pi / 2 * b), s = std::sin(pi / 2 * b);
        return {{r * c, r * s, 0}, {0.5 * c, 0.5 * s, 0}, {-pi / 2 * r * s, pi / 2 * r * c, 0}};
    }
    static Area area(double a, double) { return {pi / 8 * (1 + a), pi / 8, 0}; }
};

struct TorusPart {
    static constexpr bool identity = false;
    static SurfacePlace at(double a, double b) {
        const double cu = std::cos(pi * a), su = std::sin(pi * a);
        const double cv = std::cos(1.5 * pi * b), sv = std::sin(1.5 * pi * b), r = 3 + cv;
        return {{r * cu, r * su, sv},
                {-pi * r * su, pi * r * cu, 0},
                {-1.5 * pi * sv * cu, -1.5 * pi * sv * su, 1.5 * pi * cv}};
    }
    static Area area(double, double b) {
        const double angle = 1.5 * pi * b;
        return {1.5 * pi * pi * (3 + std::cos(angle)), 0, -2.25 * pi * pi * pi * std::sin(angle)};
    }
};

struct Moebius {
    static constexpr bool identity = false;
    static SurfacePlace at(double a, double b) {
        const double u = 2 * pi * a, v = b - 0.5, cu = std::cos(u), su = std::sin(u);
        const double ch = std::cos(u / 2), sh = std::sin(u / 2), r = 1 + v * ch, slope = -v * sh / 2;
        return {{r * cu, r * su, v * sh},
                2 * pi * Vec3{slope * cu - r * su, slope * su + r * cu, v * ch / 2},
                {ch * cu, ch * su, sh}};
    }
    static Area area(double a, double b) { // the tangents are orthogonal, the second has length 1
        const double u = 2 * pi * a, v = b - 0.5, ch = std::cos(u / 2), sh = std::sin(u / 2), r = 1 + v * ch;
        const double root = std::sqrt(r * r + v * v / 4);
        return {2 * pi * root, -2 * pi * pi * v * r * sh / root, 2 * pi * (r * ch + v / 4) / root};
    }
};

} // namespace

std::shared_ptr<const PatchMap> square_map() { return std::make_shared<FormulaMap<2, Square>>(); }
std::shared_ptr<const PatchMap> disk_map() { return std::make_shared<FormulaMap<2, Disk>>(); }
std::shared_ptr<const PatchMap> quarter_annulus_map() {
    return std::make_shared<FormulaMap<2, QuarterAnnulus>>();
}
std::shared_ptr<const PatchMap> torus_part_map() { return std::make_shared<FormulaMap<3, TorusPart>>(); }
std::shared_ptr<const PatchMap> moebius_map() { return std::make_shared<FormulaMap<3, Moebius>>(); }

} // namespace gaspard

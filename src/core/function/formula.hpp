// Formulas as people type them, such as "1 + A*sech(B*(dist(0.5, 0.5)^2 - r^2))^2", in the coordinates of a
// space.
// muParser parses and evaluates them. Gradients are differences of order 4 of the values:
//
//   df/ds = (4 D(h) - D(2 h)) / 3,   D(h) = (f(x + h s) - f(x - h s)) / (2 h)
//
// for the directions s of the axes, on a sphere along great circles. The derivatives with respect to u and v
// are multiplied by the gradients of u and v. h is a small fraction of the length over which f changes.
//
// Names in a formula:
//   x, y, z        coordinates; on a sphere those of the unit sphere
//   u, v           on a patch: its parameters, in [0, 1]
//   lat, lon       on a sphere, in degrees
//   dist(...)      distance from a point: dist(x0, y0) or dist(x0, y0, z0); on the periodic square that to
//                  its nearest image; on a sphere dist(lat0, lon0), the angle in radians between 0 and pi
//   pi, e, deg     constants; deg = pi/180
//   the functions of formula_names(); operators + - * / ^ < <= > >= == != && || and a ? b : c
//   any other name is a parameter; of a monitor that moves, t is the time.
#pragma once

#include "core/base/error.hpp"
#include "core/base/export.hpp"
#include "core/base/points.hpp"
#include "core/function/scalar_function.hpp"
#include "core/mesh/patch_parameters.hpp"
#include "core/mesh/space.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gaspard GASPARD_API {

/// Limits of a formula: bytes, parentheses that are open at the same time, and choices a ? b : c.
inline constexpr std::size_t longest_formula = 4000, deepest_formula = 100, most_choices = 100;

/// A formula is wrong; the message names the place, such as "unknown function 'sine' at character 9 (did you
/// mean 'sin'?)".
class ExpressionError : public InputError {
  public:
    /// "WHAT at character CHARACTERHINT"
    ExpressionError(const std::string& what, std::size_t character, const std::string& hint = "")
        : InputError(what + " at character " + std::to_string(character) + hint), character_(character) {}
    /// The whole formula is wrong.
    explicit ExpressionError(const std::string& what) : InputError(what), character_(1) {}
    /// Counted from 1; a letter of several bytes is one character.
    std::size_t character() const { return character_; }

  private:
    std::size_t character_;
};

/// Parses a formula in the coordinates of a space and returns the names of its parameters, in order of
/// appearance. Throws ExpressionError, and nothing else, if the text is not a formula. Takes about 50
/// microseconds, 5 ms for the longest formulas, so that it can be called for every key.
std::vector<std::string> check_formula(const std::string& text, const Space& space);

/// A name that formulas may use: "atan2(y, x)", "the angle of (x, y)".
struct FormulaName {
    std::string name, help;
};
/// Coordinates, constants and functions of formulas in a space, for documentation and completion.
std::vector<FormulaName> formula_names(const Space& space);

/// What a formula needs to become a function.
struct FormulaOptions {
    Space space{SpaceKind::periodic_square}; ///< that of the domain (Run::space)
    /// The values of the parameters, by name.
    std::map<std::string, double> parameters{};
    /// On the periodic square, a point is replaced by its image in the unit square around this point, so that
    /// the formula may jump at the sides of that square only; distances from the centre are those to the
    /// nearest image.
    Vec3 centre{0.5, 0.5, 0};
    /// On a patch: its parameters (Discretisation::parameters), if the formula uses u or v.
    std::shared_ptr<const PatchParameters> patch{};
    /// Points of the domain, from which the step of the differences is chosen. Empty: points of the unit
    /// square or the sphere.
    Points sample{};
};

/// How far a formula is from being periodic.
struct FormulaJump {
    double relative =
        0;     ///< the largest difference across the sides of the square, over the largest |f| there
    Vec3 at{}; ///< where it is
};

/// u(x) = formula(x).
class FormulaFunction : public ScalarFunction {
  public:
    /// On the periodic square; 0 elsewhere.
    virtual FormulaJump jump() const = 0;
};

/// Throws ExpressionError if the text is not a formula, and InputError if a parameter has no value or a value
/// no parameter. The values of the function may be infinite or not a number.
std::shared_ptr<const FormulaFunction> formula_function(const std::string& text, FormulaOptions options);

} // namespace GASPARD_API

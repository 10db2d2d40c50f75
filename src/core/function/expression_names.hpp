// The names that formulas may use, and the first look at a formula's text. For expression.cpp.
#pragma once

#include "core/mesh/space.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

/// A function of one or two numbers, or of any number of them; exactly one pointer is set.
struct NamedFunction {
    std::string_view name, arguments, help; ///< "atan2", "y, x", "the angle of (x, y)"
    double (*one)(double) = nullptr;
    double (*two)(double, double) = nullptr;
    double (*many)(const double*, int) = nullptr;
};
const std::vector<NamedFunction>& named_functions();

struct NamedConstant {
    std::string_view name, help;
    double value;
};
const std::vector<NamedConstant>& named_constants();

/// Names without arguments: the coordinates of a space.
struct NamedCoordinate {
    std::string_view name, help;
};
std::vector<NamedCoordinate> named_coordinates(const Space& space);

/// The calls of dist in a space: "dist(lat0, lon0)" or "dist(x0, y0), dist(x0, y0, z0)".
std::vector<std::string> distance_calls(const Space& space);

/// A name in a formula's text.
struct NameInText {
    std::string name;
    std::size_t begin;         ///< of its first byte
    bool called = false;       ///< an opening parenthesis follows
    std::size_t arguments = 0; ///< of a call, by its commas; 0 if the parenthesis is not closed
};
/// The names of a formula in order. Throws ExpressionError if the text has a character that no formula has,
/// or too many nested parentheses.
std::vector<NameInText> names_in(std::string_view text);

/// Counts from 1, with letters of several bytes as one.
std::size_t character_of(std::string_view text, std::size_t byte);

} // namespace gaspard

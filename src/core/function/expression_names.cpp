#include "core/function/expression_names.hpp"

#include "core/function/expression.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <utility>

namespace gaspard {

namespace {

double sech(double t) { // without overflow
    const double e = std::exp(-std::abs(t));
    return 2 * e / (1 + e * e);
}
double sign(double t) { return t > 0 ? 1 : t < 0 ? -1 : 0; }
double wrap(double d) { return d - std::nearbyint(d); }
double remainder_of(double a, double b) { return a - b * std::floor(a / b); }
double smallest(const double* a, int count) { return *std::min_element(a, a + count); }
double largest(const double* a, int count) { return *std::max_element(a, a + count); }

NamedFunction one(std::string_view name, double (*function)(double), std::string_view help) {
    return {.name = name, .arguments = "t", .help = help, .one = function};
}
NamedFunction two(std::string_view name, std::string_view arguments, double (*function)(double, double),
                  std::string_view help) {
    return {.name = name, .arguments = arguments, .help = help, .two = function};
}

bool letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool digit(char c) { return c >= '0' && c <= '9'; }
bool blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// The end of the number that begins at `at`: 12, 1.5, .5, 1e-3.
std::size_t end_of_number(std::string_view text, std::size_t at) {
    const auto digits = [&](std::size_t i) {
        while (i < text.size() && digit(text[i])) ++i;
        return i;
    };
    std::size_t end = digits(at);
    if (end < text.size() && text[end] == '.') end = digits(end + 1);
    if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
        const bool sign = end + 1 < text.size() && (text[end + 1] == '+' || text[end + 1] == '-');
        const std::size_t power = end + (sign ? 2 : 1), past = digits(power);
        if (past > power) end = past;
    }
    return end;
}

/// The same; throws ExpressionError if no double is that large or small.
std::size_t checked_number(std::string_view text, std::size_t at) {
    const std::size_t end = end_of_number(text, at);
    double number = 0;
    if (std::from_chars(text.data() + at, text.data() + end, number).ec != std::errc{})
        throw ExpressionError("the number", character_of(text, at), " is too large or too small");
    return end;
}

/// What to write instead of signs that other programs and books use.
constexpr std::array<std::pair<std::string_view, std::string_view>, 14> replacements = {{{"**", "^"},
                                                                                         {"²", "^2"},
                                                                                         {"³", "^3"},
                                                                                         {"·", "*"},
                                                                                         {"×", "*"},
                                                                                         {"÷", "/"},
                                                                                         {"−", "-"},
                                                                                         {"–", "-"},
                                                                                         {"π", "pi"},
                                                                                         {"√", "sqrt(...)"},
                                                                                         {"[", "("},
                                                                                         {"]", ")"},
                                                                                         {"{", "("},
                                                                                         {"}", ")"}}};

void check_character(std::string_view text, std::size_t at) {
    const std::string_view rest = text.substr(at);
    for (const auto& [sign, instead] : replacements)
        if (rest.starts_with(sign))
            throw ExpressionError("'" + std::string(sign) + "'", character_of(text, at),
                                  " is not known; write " + std::string(instead));
    const char c = text[at];
    const bool compares = at > 0 && std::string_view("=<>!").find(text[at - 1]) != std::string_view::npos;
    if (c == '=' && !compares && !rest.starts_with("=="))
        throw ExpressionError("'='", character_of(text, at), "; write == to compare");
    if (std::string_view("+-*/^(),.<>=!&|?:").find(c) != std::string_view::npos) return;
    std::size_t length = 1; // of the letter in UTF-8
    while (length < rest.size() && (static_cast<unsigned char>(rest[length]) & 0xC0) == 0x80) ++length;
    const bool printable = static_cast<unsigned char>(c) > ' ' && c != '\x7f';
    throw ExpressionError(printable ? "'" + std::string(rest.substr(0, length)) + "'"
                                    : std::string("a control character"),
                          character_of(text, at), " does not belong in a formula");
}

} // namespace

const std::vector<NamedFunction>& named_functions() {
    static const std::vector<NamedFunction> all = {
        one("sin", std::sin, "sine, t in radians; sin(30*deg) for degrees"),
        one("cos", std::cos, "cosine"),
        one("tan", std::tan, "tangent"),
        one("asin", std::asin, "inverse sine"),
        one("acos", std::acos, "inverse cosine"),
        one("atan", std::atan, "inverse tangent"),
        two("atan2", "y, x", std::atan2, "angle of the point (x, y), from -pi to pi"),
        one("sinh", std::sinh, "hyperbolic sine"),
        one("cosh", std::cosh, "hyperbolic cosine"),
        one("tanh", std::tanh, "hyperbolic tangent"),
        one("sech", sech, "1/cosh(t)"),
        one("asinh", std::asinh, "inverse hyperbolic sine"),
        one("acosh", std::acosh, "inverse hyperbolic cosine"),
        one("atanh", std::atanh, "inverse hyperbolic tangent"),
        one("exp", std::exp, "exponential"),
        one("log", std::log, "natural logarithm"),
        one("ln", std::log, "natural logarithm"),
        one("log2", std::log2, "logarithm to base 2"),
        one("log10", std::log10, "logarithm to base 10"),
        one("sqrt", std::sqrt, "square root"),
        one("cbrt", std::cbrt, "cube root"),
        one("erf", std::erf, "error function"),
        one("abs", std::abs, "absolute value"),
        one("sign", sign, "-1, 0 or 1"),
        one("floor", std::floor, "largest integer that is not larger"),
        one("ceil", std::ceil, "smallest integer that is not smaller"),
        one("round", std::round, "nearest integer"),
        one("wrap", wrap, "t minus the nearest integer: the distance to the nearest image, with its sign"),
        two("mod", "a, b", remainder_of, "a - b*floor(a/b)"),
        two("pow", "a, b", std::pow, "a^b"),
        two("hypot", "a, b", std::hypot, "sqrt(a^2 + b^2)"),
        {.name = "min", .arguments = "a, b, ...", .help = "smallest of the arguments", .many = smallest},
        {.name = "max", .arguments = "a, b, ...", .help = "largest of the arguments", .many = largest}};
    return all;
}

const std::vector<NamedConstant>& named_constants() {
    static const std::vector<NamedConstant> all = {
        {"pi", "3.14159...", std::numbers::pi},
        {"e", "2.71828...", std::numbers::e},
        {"deg", "pi/180, one degree in radians", std::numbers::pi / 180}};
    return all;
}

std::vector<NamedCoordinate> named_coordinates(const Space& space) {
    if (space.kind == SpaceKind::sphere)
        return {{"x", "coordinate on the unit sphere"},
                {"y", "coordinate on the unit sphere"},
                {"z", "coordinate on the unit sphere, towards the north pole"},
                {"lat", "latitude in degrees"},
                {"lon", "longitude in degrees, from -180 to 180"}};
    std::vector<NamedCoordinate> names = {{"x", "coordinate"}, {"y", "coordinate"}, {"z", "0 in the plane"}};
    if (space.patch) {
        names.push_back({"u", "first parameter of the patch, from 0 to 1"});
        names.push_back({"v", "second parameter of the patch, from 0 to 1"});
    }
    return names;
}

std::vector<std::string> distance_calls(const Space& space) {
    if (space.kind == SpaceKind::sphere) return {"dist(lat0, lon0)"};
    if (space.kind == SpaceKind::periodic_square) return {"dist(x0, y0)"};
    return {"dist(x0, y0)", "dist(x0, y0, z0)"};
}

std::vector<NameInText> names_in(std::string_view text) {
    std::vector<NameInText> names;
    std::vector<std::size_t> open; // parentheses: the name before each, or names.size()
    constexpr std::size_t no_call = static_cast<std::size_t>(-1);
    std::vector<std::size_t> commas;
    std::size_t choices = 0;
    bool after_name = false, after_open = false;
    for (std::size_t at = 0; at < text.size();) {
        const char c = text[at];
        if (blank(c)) {
            ++at;
            continue;
        }
        const bool name_before = after_name, open_before = after_open;
        after_name = after_open = false;
        if (digit(c) || (c == '.' && at + 1 < text.size() && digit(text[at + 1]))) {
            at = checked_number(text, at);
        } else if (letter(c)) {
            std::size_t end = at;
            while (end < text.size() && (letter(text[end]) || digit(text[end]))) ++end;
            names.push_back({std::string(text.substr(at, end - at)), at});
            after_name = true;
            at = end;
        } else {
            check_character(text, at);
            if (c == '(') {
                if (open.size() == deepest_formula)
                    throw ExpressionError("more than " + std::to_string(deepest_formula) +
                                              " nested parentheses",
                                          character_of(text, at));
                if (name_before) names.back().called = true;
                open.push_back(name_before ? names.size() - 1 : no_call);
                commas.push_back(0);
                after_open = true;
            } else if (c == ')' && !open.empty()) {
                if (open.back() != no_call)
                    names[open.back()].arguments = open_before ? 0 : commas.back() + 1;
                open.pop_back(), commas.pop_back();
            } else if (c == '?' && ++choices > most_choices) {
                throw ExpressionError("more than " + std::to_string(most_choices) + " choices a ? b : c",
                                      character_of(text, at));
            } else if (c == ',' && !open.empty()) {
                ++commas.back();
            }
            ++at;
        }
    }
    return names;
}

std::size_t character_of(std::string_view text, std::size_t byte) {
    const auto begins = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };
    const auto before = text.substr(0, std::min(byte, text.size()));
    return 1 + static_cast<std::size_t>(std::count_if(before.begin(), before.end(), begins));
}

} // namespace gaspard

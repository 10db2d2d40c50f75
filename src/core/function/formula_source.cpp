// The source whose formula the user types; its parameters become rows.
#include "core/base/error.hpp"
#include "core/base/join.hpp"
#include "core/base/short_number.hpp"
#include "core/function/expression.hpp"
#include "core/function/source.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <sstream>
#include <utility>

namespace gaspard {

namespace {

constexpr std::array<std::string_view, 6> own_keys = {"type",   "target", "expression",
                                                      "ranges", "wrap_x", "wrap_y"};

/// A range that is written for a parameter: "A 0 100 log".
struct WrittenRange {
    std::string name;
    double minimum = 0, maximum = 0;
    bool logarithmic = false;
};

/// A range is wrong; the message lacks the key.
class RangeError : public InputError {
  public:
    using InputError::InputError;
};

[[noreturn]] void bad_range(const std::string& entry) {
    throw RangeError(
        "'" + entry +
        "' is not a range; write NAME MINIMUM MAXIMUM, and log for a logarithmic slider, such as "
        "\"a 0 10, b 0.1 100 log\"");
}

double bound(const std::string& word, const std::string& entry) {
    double value = 0;
    const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (code != std::errc{} || end != word.data() + word.size() || !std::isfinite(value)) bad_range(entry);
    return value;
}

/// Of names that the formula may not have any more; a formula can be changed without losing its ranges.
std::vector<WrittenRange> parse_ranges(const std::string& text) {
    std::vector<WrittenRange> ranges;
    for (const std::string_view part : split(text, ",")) {
        const std::string entry(part);
        std::istringstream stream(entry);
        std::vector<std::string> words;
        for (std::string word; stream >> word;) words.push_back(word);
        if (words.empty() && text.find(',') == std::string::npos) continue; // nothing but blanks
        const bool logarithmic = words.size() == 4 && words[3] == "log";
        if (words.size() != 3 && !logarithmic) bad_range(entry);
        const WrittenRange range{words[0], bound(words[1], entry), bound(words[2], entry), logarithmic};
        if (!(range.minimum < range.maximum)) bad_range(entry);
        if (std::any_of(ranges.begin(), ranges.end(),
                        [&](const auto& one) { return one.name == range.name; }))
            throw RangeError("'" + range.name + "' has two ranges");
        ranges.push_back(range);
    }
    return ranges;
}

/// The other coordinate of a point, by the names of the two: x0 and y0, center_x and center_y, lat1 and lon1.
struct PointName {
    ParameterRole role = ParameterRole::none;
    std::string point, other;
};

PointName point_of(const std::string& name, bool sphere) {
    const std::string first = sphere ? "lat" : "x", second = sphere ? "lon" : "y";
    const auto roles = sphere ? std::pair(ParameterRole::latitude, ParameterRole::longitude)
                              : std::pair(ParameterRole::x, ParameterRole::y);
    for (const bool is_first : {true, false}) {
        const std::string &mine = is_first ? first : second, &others = is_first ? second : first;
        const ParameterRole role = is_first ? roles.first : roles.second;
        if (name.size() > mine.size() && name.starts_with(mine))
            return {role, "point " + name.substr(mine.size()), others + name.substr(mine.size())};
        if (name.size() > mine.size() + 1 && name.ends_with("_" + mine)) {
            const std::string stem = name.substr(0, name.size() - mine.size());
            return {role, stem, stem + others};
        }
    }
    if (sphere && (name.ends_with("_latitude") || name.ends_with("_longitude"))) {
        const std::string stem = name.substr(0, name.rfind('_') + 1);
        const bool latitude = name.ends_with("_latitude");
        return {latitude ? roles.first : roles.second, stem, stem + (latitude ? "longitude" : "latitude")};
    }
    return {};
}

/// What a parameter with such a name usually is.
struct Guess {
    std::array<std::string_view, 6> names;
    double usual, minimum, maximum;
    ParameterScale scale;
};
constexpr auto linear = ParameterScale::linear, logarithmic = ParameterScale::logarithmic;
constexpr std::array<Guess, 7> guesses = {
    {{{"A", "amplitude", "height", "contrast"}, 10, 0, 100, linear},
     {{"B", "sharpness", "steepness"}, 50, 1, 2000, logarithmic},
     {{"r", "R", "radius"}, 0.25, 0, 1, linear},
     {{"w", "width", "sigma", "eps", "epsilon", "delta"}, 0.1, 1e-3, 1, logarithmic},
     {{"n", "N", "waves", "petals", "count"}, 4, 0, 20, linear},
     {{"k", "frequency", "omega", "winding"}, 4, 0, 50, linear},
     {{"phase", "phi", "angle", "theta"}, 0, -std::numbers::pi, std::numbers::pi, linear}}};

void guess_place(ParameterRow& row, const Space& space) {
    const bool x = row.role == ParameterRole::x;
    row.default_value = 0.5;
    row.slider = SliderRange{0, 1};
    if (space.kind == SpaceKind::periodic_square) {
        row.slider.reset();
        row.minimum = 0, row.maximum = 1, row.periodic = true;
    }
    const Box* box = space.box ? &*space.box : space.reach.empty() ? nullptr : &space.reach.front();
    if (!box) return;
    const Vec3 middle = space.box ? space.middle : box->centre();
    row.slider = SliderRange{x ? box->low.x : box->low.y, x ? box->high.x : box->high.y};
    row.default_value = x ? middle.x : middle.y;
}

/// Ranges that are not written: of a point those of the space, of another parameter a guess from its name.
void guess_range(ParameterRow& row, const Space& space) {
    switch (row.role) {
    case ParameterRole::latitude:
        row.unit = "°", row.minimum = -90, row.maximum = 90, row.default_value = 30.0;
        return;
    case ParameterRole::longitude:
        row.unit = "°", row.minimum = -180, row.maximum = 180, row.default_value = 0.0;
        row.periodic = true;
        return;
    case ParameterRole::x:
    case ParameterRole::y:
        guess_place(row, space);
        return;
    default:
        break;
    }
    row.slider = SliderRange{0, 10};
    const std::string_view stem =
        std::string_view(row.key).substr(0, row.key.find_last_not_of("0123456789_") + 1);
    for (const Guess& guess : guesses)
        if (std::find(guess.names.begin(), guess.names.end(), stem) != guess.names.end()) {
            row.slider = SliderRange{guess.minimum, guess.maximum};
            row.default_value = guess.usual;
            row.scale = guess.scale;
            if (guess.maximum == std::numbers::pi) row.unit = "radians";
        }
}

ParameterRow parameter_row(const std::string& name, const std::vector<std::string>& parameters,
                           const std::vector<WrittenRange>& ranges, const Space& space) {
    ParameterRow row{.key = name,
                     .label = name,
                     .minimum = -1e12,
                     .maximum = 1e12,
                     .default_value = 1.0,
                     .help = "parameter of the formula"};
    const PointName point = point_of(name, space.kind == SpaceKind::sphere);
    if (std::find(parameters.begin(), parameters.end(), point.other) != parameters.end())
        row.role = point.role, row.point = point.point;
    guess_range(row, space);
    if (name == "t") {
        row.label = "Time", row.symbol = "t", row.help = "the clock sets it while time passes";
        row.role = ParameterRole::time, row.default_value = 0.0;
    }
    const auto range =
        std::find_if(ranges.begin(), ranges.end(), [&](const auto& r) { return r.name == name; });
    if (range == ranges.end()) return row;
    row.slider.reset();
    row.minimum = range->minimum, row.maximum = range->maximum;
    row.scale = range->logarithmic ? ParameterScale::logarithmic : ParameterScale::linear;
    const double usual = std::get<double>(row.default_value);
    if (usual < row.minimum || usual > row.maximum)
        row.default_value = row.minimum > 0 && range->logarithmic
                                ? std::sqrt(row.minimum) * std::sqrt(row.maximum)
                                : row.minimum / 2 + row.maximum / 2;
    return row;
}

std::string default_formula(const Space& space) {
    return space.kind == SpaceKind::sphere ? "1 + A*exp(-B*dist(lat0, lon0)^2)"
                                           : "1 + A*exp(-B*dist(x0, y0)^2)";
}

std::string coordinates(const Space& space) {
    if (space.kind == SpaceKind::sphere) return "x, y, z (of the unit sphere), lat and lon (in degrees)";
    if (space.patch) return "x, y, z and the parameters u, v of the patch";
    return "x and y";
}

std::vector<ParameterRow> rows(const Space& space) {
    std::vector<ParameterRow> rows = {
        {.key = "expression",
         .label = "Formula",
         .kind = ParameterKind::text,
         .default_value = default_formula(space),
         .help = "a formula in " + coordinates(space) + "; other names become parameters",
         .role = ParameterRole::formula},
        {.key = "ranges",
         .label = "Ranges",
         .kind = ParameterKind::text,
         .default_value = std::string(),
         .help = "ranges of the parameters: \"A 0 100, B 1 2000 log\"; those of others are guessed",
         .role = ParameterRole::defines_rows}};
    if (space.kind == SpaceKind::periodic_square)
        rows.push_back({.key = "wrap",
                        .label = "Wrap",
                        .kind = ParameterKind::choice,
                        .default_value = std::string("off"),
                        .choices = {"off", "center"},
                        .help = "off: the formula on [0, 1] x [0, 1], repeated; center: on the unit square "
                                "around a point, from which distances are those to the nearest image",
                        .role = ParameterRole::defines_rows});
    return rows;
}

bool wrapped(const Values& values) { return values.has("wrap") && values.text("wrap") == "center"; }

std::vector<ParameterRow> wrap_rows() {
    std::vector<ParameterRow> rows;
    for (const bool x : {true, false})
        rows.push_back({.key = x ? "wrap_x" : "wrap_y",
                        .label = x ? "Wrap x" : "Wrap y",
                        .minimum = 0,
                        .maximum = 1,
                        .default_value = 0.5,
                        .help = "middle of the square in which the formula is evaluated",
                        .role = x ? ParameterRole::x : ParameterRole::y,
                        .point = "wrap",
                        .periodic = true});
    return rows;
}

/// The formula of the values; messages name the key.
Expression expression_of(const Values& values, const Space& space) {
    try {
        Expression expression(values.text("expression"), space);
        for (const std::string_view key : own_keys)
            if (const auto& names = expression.parameters();
                std::find(names.begin(), names.end(), key) != names.end())
                throw ExpressionError("a parameter cannot be named '" + std::string(key) +
                                      "', which is a key of the monitor");
        return expression;
    } catch (const ExpressionError& error) {
        throw InputError(key_name(values, "expression") + ": " + error.what());
    }
}

std::vector<ParameterRow> further_rows(const Values& values, const Space& space) {
    const Expression expression = expression_of(values, space);
    std::vector<ParameterRow> rows;
    try {
        const auto ranges = parse_ranges(values.text("ranges"));
        for (const auto& name : expression.parameters())
            rows.push_back(parameter_row(name, expression.parameters(), ranges, space));
    } catch (const RangeError& error) {
        throw InputError(key_name(values, "ranges") + ": " + error.what());
    }
    if (wrapped(values))
        for (ParameterRow& row : wrap_rows()) rows.push_back(std::move(row));
    return rows;
}

std::string percent(double fraction) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2g", 100 * fraction);
    return std::string(text) + " %";
}

/// Where a formula that jumps across the sides should have the middle of its square: at its extreme value, if
/// it hardly jumps then.
std::optional<Vec3> better_centre(const FormulaFunction& function, const std::string& text,
                                  FormulaOptions options) {
    std::vector<double> values(options.sample.size());
    function.values(options.sample, values);
    double mean = 0, furthest = 0;
    for (const double value : values) mean += value / static_cast<double>(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        if (const double distance = std::abs(values[i] - mean); distance > furthest) {
            furthest = distance;
            const Vec3 x = options.sample[i];
            options.centre = {std::round(100 * x.x) / 100, std::round(100 * x.y) / 100, 0};
        }
    const double before = function.jump().relative;
    if (!(furthest > 0) || !(formula_function(text, options)->jump().relative < 0.1 * before)) return {};
    return options.centre;
}

/// Says that the formula is not periodic, and what to do: a jump above what rounding leaves of one that is.
void note_jump(MadeFunction& made, const FormulaFunction& function, const Values& values,
               const std::optional<Vec3>& better) {
    const FormulaJump jump = function.jump();
    if (!(jump.relative > 1e-9)) return;
    const auto key = [&](const char* name) { return key_name(values, name); };
    std::string remedy = "move " + key("wrap_x") + " and " + key("wrap_y") + " to the middle of the feature";
    if (!wrapped(values)) {
        remedy = "set " + key("wrap") + " = \"center\"";
        if (better)
            remedy += ", " + key("wrap_x") + " = " + format_number(better->x) + " and " + key("wrap_y") +
                      " = " + format_number(better->y);
        remedy += " to measure distances from a point to its nearest image, or domain.boundary = \"walls\"";
    }
    std::string sentence = remedy;
    sentence[0] = static_cast<char>(sentence[0] - 'a' + 'A');
    made.notes.push_back("The formula is not periodic: it jumps by up to " + percent(jump.relative) +
                         " of its largest value across the sides, at (" + exact_number(jump.at.x) + ", " +
                         exact_number(jump.at.y) + "). " +
                         (wrapped(values) ? "" : "A mesh may not follow it. ") + sentence + ".");
    made.advice = "the formula jumps across the sides: " + remedy;
}

/// Ranges of names that the formula does not have; they are kept while it is edited.
std::vector<std::string> range_notes(const std::vector<std::string>& parameters, const Values& values) {
    std::vector<std::string> notes;
    for (const WrittenRange& range : parse_ranges(values.text("ranges")))
        if (std::find(parameters.begin(), parameters.end(), range.name) == parameters.end())
            notes.push_back(key_name(values, "ranges") + " has a range for '" + range.name +
                            "', which is no parameter of the formula" + did_you_mean(range.name, parameters) +
                            ".");
    return notes;
}

/// Parameters that are coordinates elsewhere.
std::vector<std::string> name_notes(const std::vector<std::string>& parameters) {
    std::vector<std::string> notes;
    for (const std::string& name : parameters) {
        const bool sphere = name == "lat" || name == "lon", patch = name == "u" || name == "v";
        if (sphere || patch)
            notes.push_back("'" + name + "' is a parameter here; it is a coordinate only on " +
                            (sphere ? "the sphere." : "spline patches."));
    }
    return notes;
}

MadeFunction make(const Values& values, const DataContext& context) {
    const Expression expression = expression_of(values, context.space);
    FormulaOptions options{.space = context.space};
    for (const auto& name : expression.parameters()) options.parameters[name] = values.real(name);
    if (wrapped(values)) options.centre = {values.real("wrap_x"), values.real("wrap_y"), 0};
    if (context.discretisation) {
        options.patch = context.discretisation->parameters();
        options.sample = context.discretisation->mesh()->nodes;
    }
    const auto function = formula_function(expression.text(), options);
    MadeFunction made{.function = function, .notes = name_notes(expression.parameters())};
    for (std::string& note : range_notes(expression.parameters(), values))
        made.notes.push_back(std::move(note));
    std::optional<Vec3> better;
    if (!wrapped(values) && function->jump().relative > 1e-9)
        better = better_centre(*function, expression.text(), std::move(options));
    note_jump(made, *function, values, better);
    return made;
}

} // namespace

SourceType formula_source() {
    return {.name = "formula",
            .label = "Formula",
            .help = "a formula that you type, with a slider for every parameter",
            .rows = rows,
            .make = make,
            .further_rows = further_rows};
}

} // namespace gaspard

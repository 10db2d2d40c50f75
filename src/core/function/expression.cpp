#include "core/function/expression.hpp"

#include "core/base/angle.hpp"
#include "core/base/check.hpp"
#include "core/base/join.hpp"
#include "core/base/parameter.hpp"
#include "core/function/expression_names.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <muParser.h>
#include <mutex>
#include <numbers>
#include <utility>

namespace gaspard {

namespace {

constexpr std::size_t most_parameters = 64;

/// Distances from the point that is being evaluated.
struct EvaluationPlace {
    Space space;
    double x = 0, y = 0, z = 0;
    /// Sphere: the last few centres, since their sines and cosines cost more than the angle.
    struct Centre {
        double latitude = 0, longitude = 0;
        Vec3 direction{1, 0, 0};
    };
    std::array<Centre, 4> centres{};
    std::size_t oldest = 0;

    Vec3 direction(double latitude, double longitude) {
        for (const Centre& one : centres)
            if (one.latitude == latitude && one.longitude == longitude) return one.direction;
        Centre& centre = centres[oldest];
        oldest = (oldest + 1) % centres.size();
        centre = {latitude, longitude, at_latitude_longitude(latitude, longitude)};
        return centre.direction;
    }
    double distance(double a, double b) {
        if (space.kind == SpaceKind::sphere) return angle_from(direction(a, b), x, y, z);
        double dx = x - a, dy = y - b;
        if (space.kind == SpaceKind::periodic_square) dx -= std::nearbyint(dx), dy -= std::nearbyint(dy);
        return std::sqrt(dx * dx + dy * dy);
    }
};

double distance_in_plane(void* place, double a, double b) {
    return static_cast<EvaluationPlace*>(place)->distance(a, b);
}
/// Two or three coordinates; another number is refused before muParser sees the formula.
double distance_in_space(void* place, const double* from, int count) {
    const auto& here = *static_cast<const EvaluationPlace*>(place);
    const double dx = here.x - from[0], dy = here.y - from[1], dz = count > 2 ? here.z - from[2] : 0;
    return std::sqrt(dx * dx + dy * dy + dz * dz);
}

/// A parser with variables of its own, for one thread.
/// muParser reads numbers with a locale of its own. The C++ library makes the tables of a locale when it is
/// first used, and does not guard them, so one thread must use it before others may.
void read_first_number() {
    static const bool done = [] {
        mu::Parser parser;
        parser.SetExpr("0.5");
        return parser.Eval() > 0;
    }();
    static_cast<void>(done);
}

struct Evaluator {
    mu::Parser parser;
    EvaluationPlace place;
    double latitude = 0, longitude = 0, u = 0, v = 0;
    bool uses_angles = false;

    Evaluator(const std::string& text, const Space& space, const std::vector<std::string>& names,
              std::span<const double> values) {
        read_first_number();
        place.space = space;
        parser.ClearFun();
        parser.ClearConst();
        for (const NamedFunction& function : named_functions()) {
            const std::string name(function.name);
            if (function.one) parser.DefineFun(name, function.one);
            if (function.two) parser.DefineFun(name, function.two);
            if (function.many) parser.DefineFun(name, function.many);
        }
        if (space.kind == SpaceKind::euclidean)
            parser.DefineFunUserData("dist", distance_in_space, &place, false);
        else
            parser.DefineFunUserData("dist", distance_in_plane, &place, false);
        for (const NamedConstant& constant : named_constants())
            parser.DefineConst(std::string(constant.name), constant.value);
        parser.DefineVar("x", &place.x);
        parser.DefineVar("y", &place.y);
        parser.DefineVar("z", &place.z);
        if (space.kind == SpaceKind::sphere) {
            parser.DefineVar("lat", &latitude);
            parser.DefineVar("lon", &longitude);
        }
        if (space.patch) {
            parser.DefineVar("u", &u);
            parser.DefineVar("v", &v);
        }
        // As constants, so that muParser computes what depends on them alone once.
        for (std::size_t i = 0; i < names.size(); ++i) parser.DefineConst(names[i], values[i]);
        parser.SetExpr(text);
        const auto& used = parser.GetUsedVar();
        uses_angles = used.contains("lat") || used.contains("lon");
    }
    Evaluator(const Evaluator&) = delete; // the parser points into it
    Evaluator& operator=(const Evaluator&) = delete;

    double at(Vec3 p, Vec3 uv) {
        if (place.space.kind == SpaceKind::sphere) {
            p = (1 / norm(p)) * p;
            if (uses_angles) {
                constexpr double degree = std::numbers::pi / 180;
                latitude = std::atan2(p.z, std::hypot(p.x, p.y)) / degree;
                longitude = std::atan2(p.y, p.x) / degree;
            }
        }
        place.x = p.x, place.y = p.y, place.z = p.z;
        u = uv.x, v = uv.y;
        return parser.Eval();
    }
};

/// The last call of a function that begins before a byte.
std::size_t call_before(const std::vector<NameInText>& names, const std::string& function, std::size_t byte) {
    std::size_t begin = 0;
    for (const NameInText& one : names)
        if (one.called && one.name == function && one.begin <= byte) begin = one.begin;
    return begin;
}

/// How a function is written.
std::string signature(const std::string& name, const Space& space) {
    if (name == "dist") return join(distance_calls(space), " or ");
    for (const NamedFunction& one : named_functions())
        if (one.name == name) return name + "(" + std::string(one.arguments) + ")";
    return name;
}

/// Where the last sign is that opens something without an end; of ':' the first without a '?' before it.
std::size_t unfinished(const std::string& text, char opens, char closes) {
    std::vector<std::size_t> open;
    std::size_t balance = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (opens == ':') {
            if (text[i] == '?') ++balance;
            if (text[i] == ':' && balance-- == 0) return i;
            continue;
        }
        if (text[i] == opens) open.push_back(i);
        if (text[i] == closes && !open.empty()) open.pop_back();
    }
    return open.empty() ? text.size() : open.back();
}

/// What muParser refuses, in our words.
[[noreturn]] void refuse(const mu::ParserError& error, const std::string& text, const Space& space,
                         const std::vector<NameInText>& names) {
    const std::string token = error.GetToken().substr(0, error.GetToken().find_last_not_of(' ') + 1);
    const std::size_t byte = error.GetPos() < 0 ? 0 : static_cast<std::size_t>(error.GetPos());
    const std::size_t character = character_of(text, byte);
    switch (error.GetCode()) {
    case mu::ecEMPTY_EXPRESSION:
        throw ExpressionError("the formula is empty");
    case mu::ecUNEXPECTED_EOF:
        throw ExpressionError("the formula ends too early");
    case mu::ecMISSING_PARENS:
        throw ExpressionError("a closing parenthesis is missing for '('",
                              character_of(text, unfinished(text, '(', ')')));
    case mu::ecMISSING_ELSE_CLAUSE:
        throw ExpressionError("':' is missing for '?'", character_of(text, unfinished(text, '?', ':')),
                              "; write a ? b : c");
    case mu::ecMISPLACED_COLON:
        throw ExpressionError("unexpected ':'", character_of(text, unfinished(text, ':', '?')),
                              "; write a ? b : c");
    case mu::ecTOO_MANY_PARAMS:
    case mu::ecTOO_FEW_PARAMS:
        throw ExpressionError(token + " has the wrong number of arguments",
                              character_of(text, call_before(names, token, byte)),
                              "; write " + signature(token, space));
    case mu::ecUNEXPECTED_VAL:
    case mu::ecUNEXPECTED_VAR:
    case mu::ecUNEXPECTED_FUN:
        throw ExpressionError("unexpected '" + token + "'", character,
                              byte > 0 ? "; an operator such as * is missing before it" : "");
    default:
        throw ExpressionError("unexpected " + (token.empty() ? std::string("end") : "'" + token + "'"),
                              character);
    }
}

bool known(const std::vector<std::string>& words, const std::string& word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

/// The names that mean something in a space.
struct Vocabulary {
    std::vector<std::string> functions = {"dist"}, others;

    explicit Vocabulary(const Space& space) {
        for (const NamedFunction& one : named_functions()) functions.emplace_back(one.name);
        for (const NamedCoordinate& one : named_coordinates(space)) others.emplace_back(one.name);
        for (const NamedConstant& one : named_constants()) others.emplace_back(one.name);
    }
};

void check_call(const NameInText& one, std::size_t character, const Vocabulary& words, const Space& space,
                bool is_parameter) {
    if (!known(words.functions, one.name)) {
        if (known(words.others, one.name) || is_parameter)
            throw ExpressionError("'" + one.name + "' is not a function", character,
                                  "; write * for a product");
        throw ExpressionError("unknown function '" + one.name + "'", character,
                              did_you_mean(one.name, words.functions));
    }
    if (one.name == "dist" && one.arguments != 0 && one.arguments != 2 &&
        (one.arguments != 3 || space.kind != SpaceKind::euclidean))
        throw ExpressionError("dist has the wrong number of arguments", character,
                              "; write " + signature("dist", space));
}

/// Whether other programs write infinity, or what is not a number, like this.
bool is_no_number(std::string name) {
    for (char& c : name) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return name == "nan" || name == "inf" || name == "infinity";
}

/// The parameters among the names. Throws ExpressionError if a function is unknown or a name is out of place.
std::vector<std::string> find_parameters(const std::string& text, const std::vector<NameInText>& names,
                                         const Space& space) {
    const Vocabulary words(space);
    std::vector<std::string> parameters;
    for (const NameInText& one : names) {
        const std::size_t character = character_of(text, one.begin);
        if (one.called) {
            check_call(one, character, words, space, known(parameters, one.name));
        } else if (known(words.functions, one.name)) {
            throw ExpressionError("'" + one.name + "' is a function", character,
                                  "; write " + signature(one.name, space));
        } else if (is_no_number(one.name)) {
            throw ExpressionError("'" + one.name + "'", character,
                                  " is not a finite number; a parameter needs another name");
        } else if (!known(words.others, one.name) && !known(parameters, one.name)) {
            parameters.push_back(one.name);
        }
    }
    if (parameters.size() > most_parameters)
        throw ExpressionError("the formula has more than " + std::to_string(most_parameters) + " parameters");
    return parameters;
}

} // namespace

std::vector<FormulaName> formula_names(const Space& space) {
    std::vector<FormulaName> all;
    for (const auto& one : named_coordinates(space))
        all.push_back({std::string(one.name), std::string(one.help)});
    for (const std::string& call : distance_calls(space))
        all.push_back({call, space.kind == SpaceKind::sphere ? "angle from a point, in radians"
                             : space.kind == SpaceKind::periodic_square
                                 ? "distance from the nearest image of a point"
                                 : "distance from a point"});
    for (const auto& one : named_constants()) all.push_back({std::string(one.name), std::string(one.help)});
    for (const auto& one : named_functions())
        all.push_back(
            {std::string(one.name) + "(" + std::string(one.arguments) + ")", std::string(one.help)});
    return all;
}

std::vector<std::string> check_formula(const std::string& text, const Space& space) {
    return Expression(text, space).parameters();
}

Expression::Expression(std::string text, Space space) : text_(std::move(text)), space_(std::move(space)) {
    if (text_.size() > longest_formula)
        throw ExpressionError("the formula is longer than " + std::to_string(longest_formula) +
                              " characters");
    const auto names = names_in(text_);
    parameters_ = find_parameters(text_, names, space_);
    for (const NameInText& one : names) {
        const bool distance = one.called && one.name == "dist", coordinate = !one.called;
        uses_plane_ |= distance || (coordinate && (one.name == "x" || one.name == "y"));
        uses_z_ |= (distance && one.arguments == 3) || (coordinate && one.name == "z");
        uses_parameters_ |= space_.patch && coordinate && (one.name == "u" || one.name == "v");
    }
    const std::vector<double> ones(parameters_.size(), 1.0);
    try {
        Evaluator evaluator(text_, space_, parameters_, ones);
        evaluator.at({1, 0, 0}, {});
        if (evaluator.parser.GetNumResults() > 1)
            throw ExpressionError("the formula is a list; it must be a single value");
    } catch (const mu::ParserError& error) {
        refuse(error, text_, space_, names);
    }
}

/// Evaluators that no thread uses at the moment.
struct ExpressionFunction::Evaluators {
    std::vector<double> parameters;
    std::mutex mutex;
    std::vector<std::unique_ptr<Evaluator>> idle;

    std::unique_ptr<Evaluator> take(const Expression& expression) {
        {
            const std::lock_guard lock(mutex);
            if (!idle.empty()) {
                auto evaluator = std::move(idle.back());
                idle.pop_back();
                return evaluator;
            }
        }
        return std::make_unique<Evaluator>(expression.text(), expression.space(), expression.parameters(),
                                           parameters);
    }
    void give_back(std::unique_ptr<Evaluator> evaluator) {
        const std::lock_guard lock(mutex);
        idle.push_back(std::move(evaluator));
    }
};

ExpressionFunction::ExpressionFunction(Expression expression, std::span<const double> parameters)
    : expression_(std::move(expression)), evaluators_(std::make_unique<Evaluators>()) {
    GASPARD_CHECK(parameters.size() == expression_.parameters().size());
    evaluators_->parameters.assign(parameters.begin(), parameters.end());
}

ExpressionFunction::~ExpressionFunction() = default;
ExpressionFunction::ExpressionFunction(ExpressionFunction&&) noexcept = default;
ExpressionFunction& ExpressionFunction::operator=(ExpressionFunction&&) noexcept = default;

void ExpressionFunction::values(const Points& x, const Points& uv, std::span<double> values) const {
    GASPARD_CHECK(values.size() == x.size());
    GASPARD_CHECK(uv.size() == (expression_.uses_parameters() ? x.size() : 0));
    try {
        auto evaluator = evaluators_->take(expression_);
        // One point at a time: muParser's evaluation of many starts OpenMP's threads in each call, which
        // costs more than the values.
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = evaluator->at(x[i], uv.size() > 0 ? uv[i] : Vec3{});
        evaluators_->give_back(std::move(evaluator));
    } catch (const mu::ParserError& error) {
        refuse(error, expression_.text(), expression_.space(), names_in(expression_.text()));
    }
}

} // namespace gaspard

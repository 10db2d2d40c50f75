// Formulas as people type them: values, parameters, and messages that say what is wrong and where.
#include "core/function/expression.hpp"
#include "support/comma_locale.hpp"
#include "support/messages.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <thread>

namespace gaspard {
namespace {

const Space plane{SpaceKind::euclidean}, torus{SpaceKind::periodic_square}, sphere{SpaceKind::sphere};

double value(const std::string& text, Vec3 at, Space space = plane, std::vector<double> parameters = {}) {
    Points x(1);
    x.set(0, at);
    double result = 0;
    ExpressionFunction(Expression(text, space), parameters).values(x, {}, {&result, 1});
    return result;
}

std::string complaint(const std::string& text, Space space = plane) {
    return message_of<ExpressionError>([&] { check_formula(text, space); });
}

TEST(Expression, ComputesWhatMathematicsSays) {
    const Vec3 at{0.3, -0.7, 2};
    const double x = at.x, y = at.y, z = at.z;
    EXPECT_EQ(value("1 + 10*exp(-50*(x^2 + y^2))", at), 1 + 10 * std::exp(-50 * (x * x + y * y)));
    EXPECT_EQ(value("-x^2", at), -(x * x));
    EXPECT_EQ(value("2^3^2", at), 512);
    EXPECT_EQ(value("2^-z", at), 0.25);
    EXPECT_EQ(value("x < y ? 1 : z", at), z);
    EXPECT_EQ(value("(x > 0) && (y < 0)", at), 1);
    EXPECT_EQ(value("min(x, y, z) + max(x, y)", at), y + x);
    EXPECT_EQ(value("atan2(y, x)", at), std::atan2(y, x));
    EXPECT_EQ(value("log(e) + ln(e) + sin(90*deg)", at), 3);
    EXPECT_EQ(value("mod(-0.25, 1) + wrap(0.75) + sign(y)", at), 0.75 - 0.25 - 1);
    EXPECT_DOUBLE_EQ(value("sech(x)", at), 1 / std::cosh(x));
    EXPECT_EQ(value("sech(-800)", at), 0) << "no overflow";
    EXPECT_EQ(value("1.5e-3 + .5", at), 0.5015);
    EXPECT_EQ(value("pi", at), std::numbers::pi);
    EXPECT_TRUE(std::isnan(value("sqrt(y)", at)));
}

TEST(Expression, MeasuresDistancesInItsSpace) {
    EXPECT_EQ(value("dist(3, 4)", {0, 0, 7}), 5) << "two coordinates: the distance in the plane";
    EXPECT_EQ(value("dist(0, 0, 5)", {3, 0, 9}), 5);
    EXPECT_NEAR(value("dist(0.9, 0.5)", {0.1, 0.5, 0}, torus), 0.2, 1e-15);
    EXPECT_NEAR(value("dist(90, 0)", {5, 0, 0}, sphere), std::numbers::pi / 2, 1e-15);
    EXPECT_NEAR(value("dist(0, 180)", {2, 0, 0}, sphere), std::numbers::pi, 1e-15);
    EXPECT_NEAR(value("lat + 1000*lon", {0, -3, 3}, sphere), 45 - 90e3, 1e-9);
    EXPECT_NEAR(value("x^2 + y^2 + z^2", {3, 4, 12}, sphere), 1, 1e-15)
        << "the unit sphere, whatever the radius";
    const auto four_and_more = [](const std::string& from) {
        std::string sum;
        for (int i = 0; i < 6; ++i) sum += (i > 0 ? "+" : "") + ("dist(" + std::to_string(10 * i)) + ", 0)";
        return value(sum, at_latitude_longitude(0, 0), sphere) - value(from, {1, 0, 0}, sphere);
    };
    EXPECT_NEAR(four_and_more("150*deg"), 0, 1e-14) << "more centres than are kept";
}

TEST(Expression, FindsParametersInOrder) {
    const Expression expression("1 + A*sech(B*(dist(x0, y0)^2 - r^2))^2 + A*x*pi", plane);
    EXPECT_EQ(expression.parameters(), (std::vector<std::string>{"A", "B", "x0", "y0", "r"}));
    EXPECT_TRUE(Expression("x + y + z + e", plane).parameters().empty());
    EXPECT_EQ(Expression("lat", plane).parameters().size(), 1U) << "only a sphere has latitudes";
    EXPECT_EQ(value("a*x + b", {2, 0, 0}, plane, {3, 4}), 10);
}

TEST(Expression, SaysWhatIsWrongAndWhere) {
    EXPECT_EQ(complaint("1 + 10*sine(x)"), "unknown function 'sine' at character 8 (did you mean 'sin'?)");
    EXPECT_EQ(complaint("1 + 2x"),
              "unexpected 'x' at character 6; an operator such as * is missing before it");
    EXPECT_EQ(complaint("x (1 + y)"), "'x' is not a function at character 1; write * for a product");
    EXPECT_EQ(complaint("a*a(2)"), "'a' is not a function at character 3; write * for a product");
    EXPECT_EQ(complaint("1 + sin"), "'sin' is a function at character 5; write sin(t)");
    EXPECT_EQ(complaint("sin(x, y) + 1"),
              "sin has the wrong number of arguments at character 1; write sin(t)");
    EXPECT_EQ(complaint("1 + max()"),
              "max has the wrong number of arguments at character 5; write max(a, b, ...)");
    EXPECT_EQ(complaint("x²"), "'²' at character 2 is not known; write ^2");
    EXPECT_EQ(complaint("1 − x"), "'−' at character 3 is not known; write -");
    EXPECT_EQ(complaint("2·π"), "'·' at character 2 is not known; write *");
    EXPECT_EQ(complaint("é + §"), "'é' at character 1 does not belong in a formula");
    EXPECT_EQ(complaint("x**2"), "'**' at character 2 is not known; write ^");
    EXPECT_EQ(complaint("x = 3"), "'=' at character 3; write == to compare");
    EXPECT_EQ(complaint("1, 2"), "the formula is a list; it must be a single value");
    EXPECT_EQ(complaint("(1 + x"), "a closing parenthesis is missing for '(' at character 1");
    EXPECT_EQ(complaint("1+x?1"), "':' is missing for '?' at character 4; write a ? b : c");
    EXPECT_EQ(complaint("1 + nan*x"),
              "'nan' at character 5 is not a finite number; a parameter needs another name");
    EXPECT_NE(complaint("x + INF"), "");
    EXPECT_EQ(complaint("1 + x)"), "unexpected ')' at character 6");
    EXPECT_EQ(complaint("1 +"), "the formula ends too early");
    EXPECT_EQ(complaint(" "), "the formula is empty");
    EXPECT_EQ(complaint("1e400"), "the number at character 1 is too large or too small");
    EXPECT_EQ(
        complaint("1 + dist(1)"),
        "dist has the wrong number of arguments at character 5; write dist(x0, y0) or dist(x0, y0, z0)");
    EXPECT_EQ(complaint("x > 2 ? dist(1, 2, 3) : 1", torus),
              "dist has the wrong number of arguments at character 9; write dist(x0, y0)");
    EXPECT_EQ(complaint("dist(1, max(2, 3), 3)", sphere),
              "dist has the wrong number of arguments at character 1; write dist(lat0, lon0)");
    EXPECT_NE(complaint("x ? 1"), "");
    EXPECT_EQ(complaint(std::string(4001, '1')), "the formula is longer than 4000 characters");
    EXPECT_NE(complaint(std::string("1\0", 2)), "");
    EXPECT_NE(complaint("\"a\""), "");
}

TEST(Expression, RefusesEveryDamagedFormulaWithASentence) {
    const std::string good = "1 + A*sech(B*(dist(x0, y0)^2 - r^2))^2";
    const std::string others = "()+*^,.xAs1 e?:<=&|!\"'#@\\~\x80\xc3;{";
    for (std::size_t i = 0; i <= good.size(); ++i) {
        EXPECT_NO_THROW({
            try {
                Expression(good.substr(0, i), plane);
            } catch (const ExpressionError& error) {
                EXPECT_STRNE(error.what(), "");
            }
        });
        for (const char c : others)
            for (std::string damaged : {good.substr(0, i) + c + good.substr(i),
                                        i < good.size() ? good.substr(0, i) + c + good.substr(i + 1) : good})
                try {
                    const Expression accepted(damaged, torus);
                    const std::vector<double> ones(accepted.parameters().size(), 1.0);
                    Points x(1);
                    double v = 0;
                    ExpressionFunction(accepted, ones).values(x, {}, {&v, 1});
                } catch (const ExpressionError& error) {
                    EXPECT_STRNE(error.what(), "");
                }
    }
}

TEST(Expression, LimitsDepthAndLength) {
    const auto nested = [](std::size_t depth) {
        return std::string(depth, '(') + "x" + std::string(depth, ')');
    };
    EXPECT_EQ(value(nested(deepest_formula), {2, 0, 0}), 2);
    EXPECT_EQ(complaint(nested(deepest_formula + 1)), "more than 100 nested parentheses at character 101");
    std::string powers = "x", signs = "x", choices = "1", many = "x";
    for (int i = 0; i < 300; ++i) powers += "^1";
    for (int i = 0; i < 90; ++i) signs = "-(" + signs + ")";
    for (int i = 0; i < 90; ++i) choices = "x > 0 ? (" + choices + ") : 2";
    std::string chain = "1";
    for (int i = 0; i < 101; ++i) chain = "x>0?1:" + chain;
    EXPECT_EQ(complaint(chain), "more than 100 choices a ? b : c at character 604");
    for (int i = 0; i < 65; ++i) many += "+a" + std::to_string(i);
    EXPECT_EQ(value(powers, {2, 0, 0}), 2);
    EXPECT_EQ(value(signs, {2, 0, 0}), 2);
    EXPECT_EQ(value(choices, {2, 0, 0}), 1);
    EXPECT_EQ(complaint(many), "the formula has more than 64 parameters");
}

TEST(Expression, KnowsTheParametersOfPatchesThere) {
    const Space patch{.kind = SpaceKind::euclidean, .dimension = 3, .patch = true};
    EXPECT_TRUE(check_formula("u + v", patch).empty());
    EXPECT_EQ(check_formula("u + v", plane).size(), 2U);
    const Expression expression("u*a + dist(0, 0)", patch);
    EXPECT_TRUE(expression.uses_parameters());
    EXPECT_TRUE(expression.uses_plane());
    EXPECT_FALSE(expression.uses_z());
    EXPECT_TRUE(Expression("dist(0, 0, 1)", patch).uses_z());
    Points x(1), uv(1);
    uv.set(0, {0.25, 0.5, 0});
    double result = 0;
    ExpressionFunction(Expression("u + 4*v", patch), {}).values(x, uv, {&result, 1});
    EXPECT_EQ(result, 2.25);
}

TEST(Expression, ListsItsNamesWithHelp) {
    for (const Space& space : {plane, torus, sphere})
        for (const FormulaName& name : formula_names(space)) {
            EXPECT_NE(name.help, "") << name.name;
            std::string text = name.name; // a formula once t is a number: "sin(t)", "min(a, b, ...)"
            if (const auto dots = text.find(", ..."); dots != std::string::npos) text.erase(dots, 5);
            if (const auto open = text.find("(t)"); open != std::string::npos) text.replace(open, 3, "(1)");
            EXPECT_NO_THROW(check_formula(text, space)) << text;
        }
}

TEST(Expression, ReadsNumbersInEveryLocale) {
    const CommaLocale locale;
    EXPECT_EQ(value("0.5 + 1.25*x", {2, 0, 0}), 3);
}

TEST(Expression, IsEvaluatedByManyThreads) {
    const double a[] = {2.0};
    const ExpressionFunction function(Expression("a*x + y", plane), a);
    std::vector<std::vector<double>> results(4, std::vector<double>(1000));
    {
        std::vector<std::jthread> threads;
        for (std::size_t k = 0; k < results.size(); ++k)
            threads.emplace_back([&, k] {
                Points x(1000);
                for (std::size_t i = 0; i < x.size(); ++i)
                    x.set(i, {static_cast<double>(i), static_cast<double>(k), 0});
                for (int again = 0; again < 20; ++again) function.values(x, {}, results[k]);
            });
    }
    for (std::size_t k = 0; k < results.size(); ++k)
        for (std::size_t i = 0; i < 1000; ++i)
            EXPECT_EQ(results[k][i], 2.0 * static_cast<double>(i) + static_cast<double>(k));
}

} // namespace
} // namespace gaspard

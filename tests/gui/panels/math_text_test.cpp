#include "core/scenario/toml.hpp"
#include "gui/headless_ui.hpp"
#include "gui/panels/equation_box.hpp"
#include "gui/panels/math_text.hpp"
#include "gui/panels/sections.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

/// "frac(1; pow(x; 2))"
std::string written(const MathNode& node) {
    using Kind = MathNode::Kind;
    std::string parts;
    for (const MathNode& part : node.parts)
        parts += (parts.empty() || node.kind == Kind::row ? "" : "; ") + written(part);
    switch (node.kind) {
    case Kind::text:
        return node.text;
    case Kind::row:
        return parts;
    case Kind::fraction:
        return "frac(" + parts + ")";
    case Kind::power:
        return "pow(" + parts + ")";
    case Kind::index:
        return "sub(" + parts + ")";
    case Kind::root:
        return "root(" + parts + ")";
    case Kind::group:
        return node.text.substr(0, 1) + parts + node.text.substr(1);
    }
    return {};
}

std::string parsed(std::string_view text) {
    const auto node = parse_math(text);
    return node ? written(*node) : "no formula";
}

TEST(MathText, ReadsEquationsAsTheyAreWritten) {
    EXPECT_EQ(parsed("m(x) = 1 + A sech²( B (|x - c|² - r²) )"),
              "m(x) = 1 + A pow(sech; 2)(B (pow(|x − c|; 2) − pow(r; 2)))");
    EXPECT_EQ(parsed("m(x) = 1 + A exp( -B | |x - c|² - r² | )"),
              "m(x) = 1 + A exp(−B |pow(|x − c|; 2) − pow(r; 2)|)");
    EXPECT_EQ(parsed("m(x) = 1 / (2 + cos(2 π k |x - c|))"), "m(x) = frac(1; 2 + cos(2 π k |x − c|))");
    EXPECT_EQ(parsed("sqrt( (1 - γ)/2 (tanh((β - d)/α) + 1) + γ ), γ = 1/N⁴"),
              "root(frac(1 − γ; 2) (tanh(frac(β − d; α)) + 1) + γ), γ = frac(1; pow(N; 4))");
    EXPECT_EQ(parsed("-ε² u'' + r u = f"), "−pow(ε; 2) u'' + r u = f");
    EXPECT_EQ(parsed("Σᵢ aᵢ cos( kᵢ · x ), 0 ≤ g"), "sub(Σ; i) sub(a; i) cos(sub(k; i) x), 0 ≤ g");
    EXPECT_EQ(parsed("(±sqrt(3)/2, 0)"), "(±frac(root(3); 2), 0)");
}

TEST(MathText, ReadsTypedFormulas) {
    EXPECT_EQ(parsed("1 + 10*exp(-50*((x-0.5)^2+y^2))"), "1 + 10 exp(−50 (pow((x − 0.5); 2) + pow(y; 2)))");
    EXPECT_EQ(parsed("2*3e-4*q"), "2 · 3 · pow(10; −4) q");
    EXPECT_EQ(parsed("x^-2/alpha_1"), "frac(pow(x; −2); sub(α; 1))");
    EXPECT_EQ(parsed("a/b/c"), "frac(frac(a; b); c)");
    EXPECT_EQ(parsed("e*x"), "e x");
    EXPECT_EQ(parsed("2^x^y + x^sin(y)"), "pow(2; pow(x; y)) + pow(x; sin(y))");
    EXPECT_EQ(parsed("(1+x)^-cos(y)^2"), "pow((1 + x); −pow(cos(y); 2))");
    EXPECT_EQ(parsed("2e3^2"), "pow((2 · pow(10; 3)); 2)");
}

TEST(MathText, LeavesSentencesAndMistakesAlone) {
    for (const char* text : {"", "1 +", "(1", "1)", "|x", "max{1, 2}", "a < b", "u, limited; q", "^2", "/2",
                             "2 ^", "f(x", "sqrt(", "x ? 1 : 2"})
        EXPECT_FALSE(parse_math(text)) << text;
    EXPECT_FALSE(parse_math(std::string(100000, '('))) << "it does not take the stack";
    std::string slow = "2+x";
    for (int i = 0; i < 1900; ++i) slow += "/1";
    EXPECT_FALSE(parse_math(slow)) << "it takes no time either";
}

TEST(MathText, IsAsLargeAsWhatItShows) {
    const Theme theme = dark_theme();
    HeadlessUi ui(800, 600, &theme);
    ui.frame([] {
        const float size = 15;
        const auto of = [&](const char* text) { return math_size(*parse_math(text), size); };
        EXPECT_GT(of("1/2").height(), 1.5F * of("1").height());
        EXPECT_GT(of("x^2").ascent, of("x").ascent);
        EXPECT_GT(of("sub_2").descent, of("sub").descent);
        EXPECT_LT(of("1/1000").width, of("1000 + 1").width);
        EXPECT_NEAR(of("(1/2)").height(), of("1/2").height(), 1e-3F)
            << "brackets grow with what they enclose";
        const auto whole = *parse_math("m(x) = 1 + A exp(-B x) + C exp(-D x) + E exp(-F x)");
        const float width = math_size(whole, size).width;
        EXPECT_EQ(math_lines(whole, size, width + 1).size(), 1U);
        const auto lines = math_lines(whole, size, 0.4F * width);
        ASSERT_GT(lines.size(), 2U);
        float sum = 0;
        for (const MathNode& line : lines) {
            EXPECT_LE(math_size(line, size).width, 0.4F * width);
            sum += math_size(line, size).width;
        }
        EXPECT_NEAR(sum, width, 1e-2F) << "nothing is lost";
    });
}

TEST(EquationBox, SaysTheValuesByTheirSymbols) {
    const Catalogue catalogue = builtin_catalogue();
    Scenario ring = find_scenario(catalogue, "plane-ring");
    EXPECT_EQ(values_by_symbol(ring.monitor.values), "A = 10   B = 200   r = 0.25   c = (0.5, 0.5)");
    EXPECT_EQ(values_by_symbol(Values()), "");
    EXPECT_EQ(values_at_time(ring.monitor.values, 0.5),
              "t = 0.5   A = 10   B = 200   r = 0.25   c = (0.5, 0.5)");
    EXPECT_EQ(equation_of(catalogue, SectionKind::monitor, ring.monitor),
              "m(x) = 1 + A sech²( B (|x - c|² - r²) )");
    EXPECT_EQ(equation_of(catalogue, SectionKind::method, ring.method), "");
    Scenario typed = find_scenario(catalogue, "plane-formula");
    EXPECT_EQ(equation_of(catalogue, SectionKind::monitor, typed.monitor),
              "m = " + typed.monitor.values.text("expression"));
}

TEST(EquationBox, MostEquationsAreFormulas) {
    const Catalogue catalogue = builtin_catalogue();
    std::vector<std::string> sentences;
    std::size_t formulas = 0;
    for (const MonitorType& type : catalogue.monitors)
        parse_math(type.equation) ? (void)++formulas : sentences.push_back(type.name);
    EXPECT_GT(formulas, 12U);
    std::string names;
    for (const std::string& name : sentences) names += name + " ";
    EXPECT_EQ(names.find("ring "), std::string::npos) << names;
    EXPECT_EQ(names.find("spiral"), std::string::npos) << names;
    EXPECT_EQ(names.find("x-n"), std::string::npos) << names;
    for (const char* computed : {"flow", "burgers"})
        EXPECT_EQ(std::ranges::count(sentences, computed), 0) << computed;
    EXPECT_EQ(parsed(catalogue.monitor("flow").equation),
              "m(x, t) = 1 + (C − 1) pow((frac(|q|; max(|q|))); γ), blurred, sub(q; t) + div(q u) = 0");
    EXPECT_EQ(parsed(catalogue.monitor("burgers").equation),
              "m(x, t) = root(1 + pow((α sub(u; x)); 2)), sub(u; t) + u sub(u; x) = ν sub(u; xx)");
}

} // namespace
} // namespace gaspard

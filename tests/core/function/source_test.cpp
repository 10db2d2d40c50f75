// Sources: their table, and parts of a monitor's rows with a prefix.
#include "core/base/error.hpp"
#include "core/base/growing_values.hpp"
#include "core/function/source.hpp"
#include "support/messages.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

const Space periodic_plane{SpaceKind::periodic_square};

TEST(Sources, HaveNames) {
    for (const SourceType& type : source_types()) EXPECT_EQ(source_type(type.name).label, type.label);
    EXPECT_NE(message_of<InputError>([] { source_type("formul"); }).find("(did you mean 'formula'?)"),
              std::string::npos);
}

TEST(Sources, ArePartsOfAMonitorThatDoNotKnowTheirPrefix) {
    const SourceType& formula = source_type("formula");
    const auto own = all_rows(formula, Values("monitor", formula.rows(periodic_plane)), periodic_plane);
    Values whole("monitor", prefixed(own, "u."));
    EXPECT_TRUE(whole.has("u.expression"));
    EXPECT_TRUE(whole.has("u.A"));
    for (const ParameterRow& row : whole.rows())
        EXPECT_TRUE(row.point.empty() || row.point.starts_with("u.")) << row.key;
    whole.set("u.A", 7.0);
    const auto part = [&] {
        return grown_part(whole, "u.", formula.rows(periodic_plane),
                          [&](const Values& known) { return formula.further_rows(known, periodic_plane); });
    };
    const Values values = part();
    EXPECT_EQ(values.section(), "monitor.u");
    EXPECT_EQ(values.real("A"), 7);
    const MadeFunction made = formula.make(values, {.space = periodic_plane});
    Points x(1);
    x.set(0, {0.5, 0.5, 0});
    double value = 0;
    made.function->values(x, {&value, 1});
    EXPECT_EQ(value, 8) << "1 + A at the centre";
    whole.set("u.expression", std::string("1 + sine(x)"));
    EXPECT_EQ(message_of<InputError>(part),
              "monitor.u.expression: unknown function 'sine' at character 5 (did you mean 'sin'?)");
}

} // namespace
} // namespace gaspard

#include "core/scenario/catalogue.hpp"
#include "core/scenario/toml.hpp"
#include "gui/base/value_text.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

class ValueTextTest : public testing::Test {
  protected:
    const ParameterRow& row(const Values& values, const std::string& key) {
        const auto& rows = values.rows();
        return *std::find_if(rows.begin(), rows.end(), [&](const auto& one) { return one.key == key; });
    }
    Catalogue catalogue = builtin_catalogue();
    Scenario ring = find_scenario(catalogue, "plane-ring"), disc = find_scenario(catalogue, "sphere-x4");
};

TEST_F(ValueTextTest, NumbersAreWrittenAsInPlots) {
    const ParameterRow& tolerance = row(ring.method.values, "tolerance");
    EXPECT_EQ(value_text(tolerance, 5.5e-9), "5.5×10⁻⁹");
    EXPECT_EQ(range_text(tolerance).find('e'), std::string::npos) << range_text(tolerance);
    const ParameterRow& most = row(ring.method.values, "max_iterations");
    EXPECT_EQ(value_text(most, std::int64_t{1234567}), "1234567") << "in full";
    EXPECT_EQ(value_text(row(ring.method.values, "step_size"), std::string("auto")), "auto");
    EXPECT_EQ(value_text(row(ring.domain.values, "boundary"), std::string("walls")), "walls");
    EXPECT_EQ(value_text(row(ring.method.values, "interpolation"), true), "on");
}

TEST_F(ValueTextTest, AnglesSayTheirUnit) {
    const ParameterRow& latitude = row(disc.monitor.values, "center_latitude");
    EXPECT_EQ(value_text(latitude, -30.0), "−30°");
    EXPECT_EQ(range_text(latitude), "−90° to 90°");
    const ParameterRow& radius = row(disc.monitor.values, "beta");
    EXPECT_EQ(value_text(radius, 0.25), "0.25 rad");
    EXPECT_TRUE(range_text(radius).ends_with(" rad")) << range_text(radius);
    EXPECT_EQ(value_text(row(ring.monitor.values, "radius"), 0.25), "0.25") << "a length";
}

} // namespace
} // namespace gaspard

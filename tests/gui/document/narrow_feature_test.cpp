#include "gui/document/narrow_feature.hpp"
#include "gui/document_fixture.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

class NarrowFeatureTest : public DocumentFixture {
  protected:
    std::string warning_at(double sharpness, const std::string& method = "auto") {
        Scenario scenario = find_scenario(*catalogue, "plane-ring");
        apply_settings(*catalogue, scenario, {"method.type=" + method});
        set_value(*catalogue, scenario, "monitor.sharpness", sharpness);
        document.open(scenario);
        EXPECT_TRUE(wait_until([&] { return run().ended(); }));
        return NarrowFeature().warning(*catalogue, run());
    }
};

TEST_F(NarrowFeatureTest, ARingThatTheCellsCarryIsFine) { EXPECT_EQ(warning_at(200), ""); }

TEST_F(NarrowFeatureTest, ANarrowerOneIsSaidAndWhatHelps) {
    const std::string warning = warning_at(1900);
    EXPECT_NE(warning.find("Narrower than the cells"), std::string::npos) << warning;
    EXPECT_NE(warning.find("larger value of \"Cells per side\""), std::string::npos) << warning;
    EXPECT_NE(warning.find("smaller \"Sharpness\""), std::string::npos) << warning;
}

TEST_F(NarrowFeatureTest, NothingIsSaidOfAMeshThatHasNotAdapted) {
    ASSERT_NE(warning_at(1900), "");
    auto early = std::make_shared<Snapshot>(*run().snapshot);
    early->report.residual = 0.5;
    DocumentRun one;
    one.scenario = run().scenario, one.history = run().history, one.snapshot = early;
    EXPECT_EQ(NarrowFeature().warning(*catalogue, one), "");
}

TEST_F(NarrowFeatureTest, AResetDoesNotHideIt) {
    Scenario scenario = find_scenario(*catalogue, "plane-ring");
    apply_settings(*catalogue, scenario, {"method.type=auto", "monitor.sharpness=1900"});
    document.open(scenario);
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    NarrowFeature narrow;
    const std::string warning = narrow.warning(*catalogue, run());
    ASSERT_NE(warning, "");
    document.reset(run().id);
    ASSERT_TRUE(wait_until([&] { return run().history.size() == 1; }));
    ASSERT_GT(run().snapshot->report.residual, 0.3) << "the uniform mesh";
    EXPECT_EQ(narrow.warning(*catalogue, run()), warning);
    set_value(*catalogue, scenario, "monitor.sharpness", 200.0);
    document.change(run().id, scenario);
    EXPECT_EQ(narrow.warning(*catalogue, run()), "") << "not known of other values";
}

TEST_F(NarrowFeatureTest, NothingIsSaidOfData) {
    Scenario portrait = find_scenario(*catalogue, "plane-portrait");
    set_value(*catalogue, portrait, "method.max_iterations", std::int64_t{5});
    document.open(portrait);
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    NarrowFeature narrow;
    EXPECT_EQ(narrow.warning(*catalogue, run()), "");
    EXPECT_EQ(narrow.warning(*catalogue, DocumentRun()), "");
}

} // namespace
} // namespace gaspard

#include "core/scenario/toml.hpp"
#include "gui/document/cell_study.hpp"

#include <atomic>
#include <gtest/gtest.h>
#include <memory>

namespace gaspard {
namespace {

class CellStudyTest : public testing::Test {
  protected:
    Scenario ring(std::int64_t cells) const {
        Scenario scenario = find_scenario(*catalogue, "plane-ring");
        set_value(*catalogue, scenario, "domain.cells", cells);
        set_value(*catalogue, scenario, "method.type", std::string("auto"));
        return scenario;
    }
    CellStudy::Result finished() const {
        for (;;) {
            const int seen = news;
            if (study.result().done) return study.result();
            news.wait(seen);
        }
    }

    std::shared_ptr<const Catalogue> catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    std::atomic<int> news = 0;
    CellStudy study{catalogue, [this] { ++news, news.notify_all(); }};
};

TEST_F(CellStudyTest, ItHasTheErrorsOfTheUsualMeshes) {
    const Scenario scenario = ring(24);
    EXPECT_FALSE(study.describes(scenario));
    study.begin(scenario);
    EXPECT_TRUE(study.describes(scenario));
    EXPECT_FALSE(study.describes(ring(25)));
    const CellStudy::Result result = finished();
    EXPECT_EQ(result.complaint, "");
    ASSERT_EQ(result.rows.size(), 3U);
    const auto resolutions = usual_resolutions(scenario);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(result.rows[i].resolution, resolutions[i]);
        gaspard::Run run(catalogue, with_resolution(*catalogue, scenario, resolutions[i]));
        run.solve();
        const InterpolationRow row = interpolation_row(run, nullptr);
        EXPECT_DOUBLE_EQ(result.rows[i].errors.adapted->of(ErrorNorm::l2),
                         row.errors.adapted->of(ErrorNorm::l2));
    }
}

TEST_F(CellStudyTest, ANewStudyReplacesTheOneBefore) {
    study.begin(ring(200));
    study.begin(ring(10));
    const CellStudy::Result result = finished();
    ASSERT_FALSE(result.rows.empty());
    EXPECT_EQ(result.rows.back().resolution, 20);
}

TEST_F(CellStudyTest, WhatCannotBeSolvedIsSaid) {
    Scenario scenario = ring(10);
    set_value(*catalogue, scenario, "monitor.type", std::string("formula"));
    set_value(*catalogue, scenario, "monitor.expression", std::string("x - 2"));
    study.begin(scenario);
    const CellStudy::Result result = finished();
    EXPECT_TRUE(result.rows.empty());
    EXPECT_NE(result.complaint, "");
}

} // namespace
} // namespace gaspard

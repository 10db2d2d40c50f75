#include "core/tessellate/caption.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

StepReport report_at(int iteration, RunStatus status) {
    StepReport report;
    report.iteration = iteration;
    report.residual = 1e-3;
    report.status = status;
    return report;
}

TEST(Caption, SaysHowARunHasEnded) {
    EXPECT_EQ(caption_parts("Ring", report_at(52, RunStatus::converged), 52),
              (std::vector<std::string>{"Ring", "iteration 52", "residual 0.001", "converged"}));
}

TEST(Caption, AnEarlierIterateSaysOfHowMany) {
    EXPECT_EQ(caption_parts("Ring", report_at(12, RunStatus::running), 52),
              (std::vector<std::string>{"Ring", "iteration 12 of 52", "residual 0.001"}));
    EXPECT_EQ(caption_parts("", report_at(12, RunStatus::running)),
              (std::vector<std::string>{"iteration 12", "residual 0.001"}))
        << "without the status also if the last is not known";
}

} // namespace
} // namespace gaspard

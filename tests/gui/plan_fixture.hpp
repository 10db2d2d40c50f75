// Viewports planned and drawn with ImGui alone.
#pragma once

#include "gui/headless_ui.hpp"
#include "gui/scenes.hpp"
#include "gui/viewport/viewport.hpp"

#include <gtest/gtest.h>
#include <string>
#include <utility>

namespace gaspard {

class PlanFixture : public testing::Test {
  protected:
    PlanFixture(std::string subject, ScreenRect whole) : subject_(std::move(subject)), whole_(whole) {}

    ViewportPlan plan(const Snapshot& snapshot, const Values& values, ScreenRect rect) {
        ViewportPlan made;
        ui_.frame([&] {
            made = planner_.plan(snapshot, values, {.subject = subject_}, rect, 1);
            draw_viewport_overlay(*ImGui::GetBackgroundDrawList(), made, dark_theme(), 1);
        });
        return made;
    }
    ViewportPlan plan(const Snapshot& snapshot, const Values& values) {
        return plan(snapshot, values, whole_);
    }
    ViewportPlan plan(const Snapshot& snapshot) { return plan(snapshot, view_); }

    std::string subject_;
    ScreenRect whole_;
    Theme theme_ = dark_theme();
    HeadlessUi ui_{1000, 800, &theme_};
    ViewportPlanner planner_;
    Values view_ = view("monitor");
};

} // namespace gaspard

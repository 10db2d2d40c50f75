// An application with frames and input but without a window: around a small ring, or around what a test says.
#pragma once

#include "core/scenario/toml.hpp"
#include "gui/app/application.hpp"
#include "gui/headless_ui.hpp"
#include "support/temporary_folder.hpp"

#include <chrono>
#include <filesystem>
#include <functional>
#include <future>
#include <gtest/gtest.h>
#include <memory>
#include <thread>
#include <utility>

namespace gaspard {

class ApplicationFixture : public testing::Test {
  protected:
    ApplicationFixture(std::shared_ptr<const Catalogue> of, const Scenario& scenario)
        : catalogue(std::move(of)), application(catalogue, scenario, {.output = {folder}}) {}

    void frame() {
        application.collect();
        ui.frame([this] { application.frame(); });
    }
    std::function<void()> drawing() {
        return [this] {
            application.collect();
            application.frame();
        };
    }
    template <class Condition>
    bool wait_until(Condition condition) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        while (std::chrono::steady_clock::now() < end) {
            frame();
            if (condition()) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        return false;
    }
    DocumentRun& run() { return application.document().active(); }
    Values& look() { return application.document().viewports().front().view; }
    const ShownView& shown(std::size_t i = 0) { return application.views().at(i); }
    static Size size_of(const ShownView& scene) {
        return {static_cast<double>(scene.rectangle.width()), static_cast<double>(scene.rectangle.height())};
    }
    void replace_text(const ItemRectangle& field, const std::string& text) {
        ui.replace_text(field, text, drawing());
    }
    /// With the rows under "More", in a window that is high enough for all.
    void show_all_view_rows() {
        ImGui::GetIO().DisplaySize.y = 3000;
        frame();
        frame();
        const auto more = application.items().find("view.more");
        ASSERT_NE(more, application.items().end());
        ui.click(more->second, drawing());
        frame();
    }
    /// What the solver thread itself works with.
    Scenario solved_scenario() {
        const auto seen = std::make_shared<std::promise<Scenario>>(); // outlives a test that gave up waiting
        auto answer = seen->get_future();
        run().solver->post(InspectCommand{
            [seen](gaspard::Run& solved, const Activity&) { seen->set_value(solved.scenario()); }});
        if (wait_until([&] { return answer.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }))
            return answer.get();
        ADD_FAILURE() << "the solver does not answer";
        return {};
    }

    TemporaryFolder temporary; ///< gone after the application has ended
    const std::filesystem::path folder = temporary.path();
    HeadlessUi ui;
    std::shared_ptr<const Catalogue> catalogue;
    Application application;
};

class ApplicationTest : public ApplicationFixture {
  protected:
    ApplicationTest() : ApplicationTest(std::make_shared<Catalogue>(builtin_catalogue())) {}
    Scenario small_ring() const { return small_ring(*catalogue); }

  private:
    explicit ApplicationTest(const std::shared_ptr<const Catalogue>& of)
        : ApplicationFixture(of, small_ring(*of)) {}
    static Scenario small_ring(const Catalogue& catalogue) {
        Scenario scenario = find_scenario(catalogue, "plane-ring");
        set_value(catalogue, scenario, "domain.cells", std::int64_t{12});
        return scenario;
    }
};

} // namespace gaspard

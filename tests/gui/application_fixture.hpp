// An application around a small ring, with frames and input but without a window.
#pragma once

#include "core/scenario/toml.hpp"
#include "gui/application.hpp"
#include "gui/headless_ui.hpp"
#include "support/temporary_folder.hpp"

#include <chrono>
#include <filesystem>
#include <functional>
#include <future>
#include <gtest/gtest.h>
#include <memory>
#include <thread>

namespace gaspard {

class ApplicationTest : public testing::Test {
  protected:
    Scenario small_ring() const {
        Scenario scenario = find_scenario(*catalogue, "plane-ring");
        set_value(*catalogue, scenario, "domain.cells", std::int64_t{12});
        return scenario;
    }
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
    DocumentRun& run() { return application.document().runs().front(); }
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
    std::shared_ptr<const Catalogue> catalogue = std::make_shared<Catalogue>(builtin_catalogue());
    Application application{catalogue, small_ring(), {.output = folder}};
};

} // namespace gaspard

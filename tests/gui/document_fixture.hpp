// A document with solvers at work, for tests that wait for what they do.
#pragma once

#include "core/scenario/toml.hpp"
#include "gui/document/document.hpp"

#include <atomic>
#include <chrono>
#include <future>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <thread>

namespace gaspard {

class DocumentFixture : public testing::Test {
  protected:
    template <class Condition>
    bool wait_until(Condition condition) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        while (std::chrono::steady_clock::now() < end) {
            document.collect();
            if (condition()) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        return false;
    }
    DocumentRun& run() { return document.active(); }
    /// Waits until the solver has executed all commands and the document has collected what came of them.
    bool solver_is_idle() {
        // The thread publishes between two batches of commands: what precedes the second answer is published.
        for (int batch = 0; batch < 2; ++batch) {
            const auto reached = std::make_shared<std::promise<void>>();
            auto answer = reached->get_future();
            run().solver->post(
                InspectCommand{[reached](gaspard::Run&, const Activity&) { reached->set_value(); }});
            if (!wait_until(
                    [&] { return answer.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }))
                return false;
        }
        return wait_until([&] { return run().changes.settled(); });
    }
    /// A small ring that is solved at once.
    Scenario small_ring() const {
        Scenario scenario = find_scenario(*catalogue, "plane-ring");
        set_value(*catalogue, scenario, "domain.cells", std::int64_t{12});
        set_value(*catalogue, scenario, "method.max_iterations", std::int64_t{40});
        return scenario;
    }
    /// A ring that is not solved within a test.
    Scenario endless_ring() const {
        Scenario scenario = small_ring();
        set_value(*catalogue, scenario, "method.tolerance", 1e-14);
        set_value(*catalogue, scenario, "method.max_iterations", std::int64_t{1000000});
        set_value(*catalogue, scenario, "method.step_size", 1e-4);
        return scenario;
    }

    std::shared_ptr<const Catalogue> catalogue = std::make_shared<Catalogue>(builtin_catalogue());
    std::atomic<int> notified = 0;
    Document document{catalogue, [this] { ++notified; }};
};

} // namespace gaspard

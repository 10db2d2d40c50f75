#include "core/flow/flow_history.hpp"

#include "core/base/check.hpp"
#include "core/flow/quasi_geostrophic.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace gaspard {

namespace {

constexpr double steps_per_interval = 10, longest_interval = 1;

class FlowEvolution final : public Evolution {
  public:
    explicit FlowEvolution(const FlowOptions& options) : flow_(options) {}

    void set(std::span<const double> state, double time) override { flow_.set_state(state, time); }
    void advance(double duration, const std::stop_token& stop) override { flow_.advance(duration, stop); }
    std::span<const double> state() const override { return flow_.q(); }
    std::vector<double> values() override {
        std::vector<double> nodal(flow_.cells() * flow_.cells());
        flow_.project(nodal);
        return nodal;
    }

  private:
    QuasiGeostrophicFlow flow_;
};

} // namespace

std::shared_ptr<const Checkpoints> flow_history(const FlowOptions& options, std::vector<double> nodal,
                                                std::size_t budget) {
    GASPARD_CHECK(nodal.size() == options.cells * options.cells);
    if (options.froude == 0) {
        const double mean =
            std::accumulate(nodal.begin(), nodal.end(), 0.0) / static_cast<double>(nodal.size());
        for (double& value : nodal) value -= mean;
    }
    QuasiGeostrophicFlow flow(options);
    std::vector<double> start = continuous_state(options.cells, nodal);
    flow.set_state(start);
    const double interval = std::min(steps_per_interval * flow.stable_step(), longest_interval);
    return std::make_shared<const Checkpoints>([options] { return std::make_unique<FlowEvolution>(options); },
                                               std::move(start), interval, budget);
}

} // namespace gaspard

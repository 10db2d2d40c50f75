#include "core/flow/burgers_history.hpp"

#include <utility>

namespace gaspard {

namespace {

constexpr double burgers_interval = 0.02;
constexpr std::size_t burgers_budget = std::size_t{16} << 20; // bytes

class BurgersEvolution final : public Evolution {
  public:
    explicit BurgersEvolution(Burgers equation) : equation_(std::move(equation)) { store(); }

    void set(std::span<const double> state, double time) override {
        const std::size_t half = state.size() / 2;
        equation_.set_state(state.first(half), state.last(half), time);
        store();
    }
    void advance(double duration, const std::stop_token& stop) override {
        equation_.advance(duration, stop);
        store();
    }
    std::span<const double> state() const override { return state_; }
    std::vector<double> values() override { return state_; }

  private:
    void store() {
        state_ = equation_.x();
        state_.insert(state_.end(), equation_.u().begin(), equation_.u().end());
    }

    Burgers equation_;
    std::vector<double> state_;
};

} // namespace

std::shared_ptr<const Checkpoints> burgers_history(const BurgersOptions& options, const BurgersData& data) {
    const Burgers at_start(options, data);
    const BurgersEvolution first(at_start);
    return std::make_shared<const Checkpoints>(
        [at_start] { return std::make_unique<BurgersEvolution>(at_start); },
        std::vector<double>(first.state().begin(), first.state().end()), burgers_interval, burgers_budget);
}

} // namespace gaspard

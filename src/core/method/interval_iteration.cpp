#include "core/method/interval_iteration.hpp"

namespace gaspard {

std::vector<SeriesInfo> IntervalIteration::series() const {
    std::vector<SeriesInfo> all = IntervalMethod::series();
    all.push_back(level_series());
    return all;
}

Evaluation IntervalIteration::evaluate(const ProblemData& data, const State& state, std::stop_token) {
    levels_.begin();
    Evaluation evaluation = look(data, mesh_of(state));
    if (level() > 0) evaluation.ending = Ending::not_yet;
    return evaluation;
}

Evaluation IntervalIteration::step(const ProblemData& data, State& state, std::stop_token) {
    const std::size_t level = levels_.next(this->level());
    if (level != this->level())
        look(data, level > this->level()
                       ? uniform_interval(domain().interval(), levels_.cells(level))
                       : resampled_interval(x(), static_cast<std::size_t>(levels_.cells(level))));
    if (level == 0)
        if (auto evaluation = finish(data, state)) return std::move(*evaluation);
    mesh_of(state) = next_interval_mesh(densities_, domain().interval());
    Evaluation evaluation = look(data, mesh_of(state));
    evaluation.step_size = 1;
    evaluation.ending = levels_.ending(level);
    return evaluation;
}

Evaluation IntervalIteration::look(const ProblemData& data, const std::vector<double>& mesh) {
    densities_ = densities(data, mesh);
    double mass = 0;
    for (std::size_t i = 0; i < densities_.size(); ++i) mass += densities_[i] * (mesh[i + 1] - mesh[i]);
    return {.residual = residual_unit(data, mass) * interval_residual(densities_, mesh),
            .series = {static_cast<double>(level())}};
}

} // namespace gaspard

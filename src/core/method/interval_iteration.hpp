// Iterations of mesh PDEs on an interval, from coarse meshes to fine ones (method/mesh_levels.hpp): a step is
// one solve of (15), layer/interval_mesh.hpp, for densities of cells that the derived class knows.
#pragma once

#include "core/method/interval_method.hpp"
#include "core/method/mesh_levels.hpp"

#include <optional>
#include <vector>

namespace gaspard {

class IntervalIteration : public IntervalMethod {
  public:
    using IntervalMethod::IntervalMethod;

    /// Those of IntervalMethod and level_series().
    std::vector<SeriesInfo> series() const override;
    Evaluation evaluate(const ProblemData& data, const State& state, std::stop_token stop) override;
    Evaluation step(const ProblemData& data, State& state, std::stop_token stop) override;

  protected:
    /// The densities of the cells of a mesh; calls look_at().
    virtual std::vector<double> densities(const ProblemData& data, const std::vector<double>& mesh) = 0;
    /// The factor of the residual (16); `mass` is the integral of the densities.
    virtual double residual_unit(const ProblemData&, double mass) const { return 1 / mass; }
    /// Another step on the mesh of the run; nullopt: a solve.
    virtual std::optional<Evaluation> finish(const ProblemData&, State&) { return std::nullopt; }

    MeshLevels& levels() { return levels_; }
    Evaluation look(const ProblemData& data, const std::vector<double>& mesh);

  private:
    std::size_t level() const { return levels_.level_of(static_cast<int>(x().size()) - 1); }

    MeshLevels levels_;
    std::vector<double> densities_; ///< of the mesh last looked at
};

} // namespace gaspard

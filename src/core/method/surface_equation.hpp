// The Monge-Ampère equation on the sphere, or on a flat surface with the same elements (fem/surface_q2.hpp).
#pragma once

#include "core/fem/surface_q2.hpp"
#include "core/method/monge_ampere.hpp"

namespace gaspard {

class SurfaceEquation final : public MongeAmpereEquation {
  public:
    explicit SurfaceEquation(std::shared_ptr<const SurfaceQ2> surface);

    /// Accepts states of any mesh of the sphere, with any cells; on flat surfaces only states of the same
    /// mesh.
    std::optional<State> adopt(const State& other, const Discretisation* of) override;
    State adopt(NonlinearProblem& other, std::span<const double> phi) override;
    std::unique_ptr<NonlinearProblem> coarser(const Progress& progress, std::stop_token stop) const override;

    Evaluation evaluate(const ProblemData& data, std::span<const double> phi) override;
    const Points& positions() const override { return positions_; }
    void move(std::span<const double> phi) override;
    std::span<const double> residual() const override { return residual_; }
    /// Extremes over the mesh nodes.
    Ellipticity ellipticity() const override;
    void direction(std::span<double> u) override { surface_->poisson(residual_, u, workspace_); }

    void linearise(const ProblemData& data, Linearised how) override;
    void derivative(std::span<const double> w, std::span<double> out) override;
    void precondition(std::span<const double> r, std::span<double> u) override;

  private:
    State adopt(const SurfaceQ2& from, std::span<const double> phi) const;

    std::shared_ptr<const SurfaceQ2> surface_;
    SurfaceQ2::Workspace workspace_;
    Points gradient_; ///< w' of (4.11)
    Points positions_;
    std::vector<double> monitor_; ///< m at the mesh nodes
    double theta_ = 1;            ///< in the unit of the data
    std::vector<double> residual_;
    // The linearisation:
    std::optional<SurfaceQ2::Workspace> d_workspace_; ///< nullopt before the first linearise()
    Points slope_, displacement_;                     ///< at the nodes: grad m, displacement for w
    std::vector<double> d_monitor_;                   ///< at the nodes: derivative of m for w
    std::vector<double> scale_;                       ///< 1 / S of the preconditioner
};

} // namespace gaspard

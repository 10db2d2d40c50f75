// The Monge-Ampère equation on the unit square (fem/plane_q2.hpp).
#pragma once

#include "core/fem/plane_q2.hpp"
#include "core/method/monge_ampere.hpp"

namespace gaspard {

class PlaneEquation final : public MongeAmpereEquation {
  public:
    explicit PlaneEquation(std::shared_ptr<const PlaneQ2> plane);

    void use_threads(int threads) override { workspace_ = plane_->make_workspace(threads); }
    double other_cpu_seconds() const override { return workspace_.team->other_cpu_seconds(); }

    /// Accepts states of any resolution with the same boundary.
    std::optional<State> adopt(const State& other, const Discretisation* of) override;
    State adopt(NonlinearProblem& other, std::span<const double> phi) override;
    std::unique_ptr<NonlinearProblem> coarser(const Progress& progress, std::stop_token stop) const override;

    Evaluation evaluate(const ProblemData& data, std::span<const double> phi) override;
    const Points& positions() const override { return positions_; }
    void move(std::span<const double> phi) override { plane_->positions(phi, positions_, workspace_); }
    std::span<const double> residual() const override { return residual_; }
    /// Extremes over the vertices.
    Ellipticity ellipticity() const override {
        Ellipticity extremes = gaspard::ellipticity(plane_->grid(), monitor_, sigma_);
        extremes.theta = theta_;
        return extremes;
    }
    void direction(std::span<double> u) override { plane_->poisson(residual_, u, workspace_); }

    void linearise(const ProblemData& data, Linearised how) override;
    void derivative(std::span<const double> w, std::span<double> out) override;
    void precondition(std::span<const double> r, std::span<double> u) override;

  private:
    std::shared_ptr<const PlaneQ2> plane_;
    PlaneQ2::Workspace workspace_;
    Points positions_;
    std::vector<double> monitor_; ///< m at the mesh nodes
    WeakHessian sigma_;
    double theta_ = 1; ///< in the unit of the data
    std::vector<double> residual_;
    // The linearisation:
    Points slope_, displacement_;   ///< at the nodes: grad m, displacement for w
    std::vector<double> d_monitor_; ///< at the nodes: derivative of m for w
    WeakHessian d_sigma_;
    std::vector<double> scale_, scaled_; ///< 1 / S of the preconditioner; S^-1 r
};

} // namespace gaspard

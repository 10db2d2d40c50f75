// The equation of the plane (fem/plane_q2.hpp).
#pragma once

#include "core/fem/plane_q2.hpp"
#include "core/method/monge_ampere.hpp"

namespace gaspard {

class PlaneEquation final : public MongeAmpereEquation {
  public:
    explicit PlaneEquation(std::shared_ptr<const PlaneQ2> plane);

    void use_threads(int threads) override { workspace_ = plane_->make_workspace(threads); }
    double other_cpu_seconds() const override { return workspace_.team->other_cpu_seconds(); }

    /// From any plane with the same boundary.
    std::optional<State> adopt(const State& other, const Discretisation* of) override;
    State adopt(NonlinearProblem& other, std::span<const double> phi) override;
    std::unique_ptr<NonlinearProblem> coarser(const Progress& progress, std::stop_token stop) const override;

    Evaluation evaluate(const ProblemData& data, std::span<const double> phi) override;
    const Points& positions() const override { return positions_; }
    void move(std::span<const double> phi) override { plane_->positions(phi, positions_, workspace_); }
    std::span<const double> residual() const override { return residual_; }
    /// At the vertices.
    Ellipticity ellipticity() const override {
        return gaspard::ellipticity(plane_->grid(), monitor_, sigma_);
    }
    void direction(std::span<double> u) override { plane_->poisson(residual_, u, workspace_); }

    void linearise(const ProblemData& data, Linearised how) override;
    void derivative(std::span<const double> w, std::span<double> out) override;
    void precondition(std::span<const double> r, std::span<double> u) override;

  private:
    std::shared_ptr<const PlaneQ2> plane_;
    PlaneQ2::Workspace workspace_;
    Points positions_;
    std::vector<double> monitor_; ///< m at the mesh's nodes
    WeakHessian sigma_;
    std::vector<double> residual_;
    // Of the linearisation:
    Points slope_, displacement_;   ///< grad m at the nodes; how far they move with w
    std::vector<double> d_monitor_; ///< how much m changes there
    WeakHessian d_sigma_;
    std::vector<double> scale_, scaled_; ///< of the preconditioner
};

} // namespace gaspard

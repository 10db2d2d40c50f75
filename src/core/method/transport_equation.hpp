// The Monge-Ampère equation with transport boundary condition (transport/transport_form.hpp) as a nonlinear
// problem:
//
//   x = grad u(xi) from the source domain to the target, boundary to boundary
//   det D^2 u = theta rho / sigma(grad u),   b(grad u) = 0 on the boundary
//
// sigma is the monitor on the target, ProblemData::source is rho on the source. A State holds the array "u":
// u at the nodes of the elements, then the multiplier c. Coordinates are relative to the origins of source
// and target (transport/transport_domain.hpp), so that u says nothing about where they lie, and is as
// accurate far away.
#pragma once

#include "core/method/nonlinear_problem.hpp"
#include "core/transport/recovery_preconditioner.hpp"
#include "core/transport/transport_domain.hpp"
#include "core/transport/transport_form.hpp"

#include <memory>
#include <optional>

namespace gaspard {

class TransportEquation final : public NonlinearProblem {
  public:
    /// Throws Interrupted if asked to stop.
    TransportEquation(std::shared_ptr<const TransportDomain> domain, Recovery recovery,
                      std::stop_token stop = {});

    std::vector<double> start() const override { return start_; }
    /// Of another mesh, degree or recovery on the same source.
    std::optional<State> adopt(const State& other, const Discretisation* of) override;
    State adopt(NonlinearProblem& other, std::span<const double> unknowns) override;
    std::unique_ptr<NonlinearProblem> coarser(const Progress& progress, std::stop_token stop) const override;

    Evaluation evaluate(const ProblemData& data, std::span<const double> unknowns) override;
    const Points& positions() const override { return positions_; }
    void move(std::span<const double> unknowns) override;
    std::vector<SeriesInfo> series() const override;
    std::span<const double> residual() const override { return form_.residual(); }
    IterateShape shape() const override;
    void direction(std::span<double> d) override;
    bool begins_anew() const override { return true; }

    void linearise(const ProblemData& data, Linearised how) override;
    void derivative(std::span<const double> w, std::span<double> out) override { form_.derivative(w, out); }
    void precondition(std::span<const double> r, std::span<double> w) override {
        preconditioner_.solve(r, w);
    }

    ProblemData continued(const ProblemData& data, double t) const override;
    std::string name_of_continued(double t) const override;

    const TransportForm& form() const { return form_; }
    /// The images of the mesh's nodes where the map is known (transport/exact_transport.hpp); otherwise null.
    std::shared_ptr<const Points> exact(const ProblemData& data);
    /// The values of nvfem_fields(), of the unknowns last evaluated or moved to.
    std::vector<std::vector<double>> fields() const;

  private:
    void take_positions();
    TransportDensities densities(const ProblemData& data);

    std::shared_ptr<const TransportDomain> domain_;
    TransportForm form_;
    RecoveryPreconditioner preconditioner_;
    std::vector<double> start_;
    Points positions_;
    std::vector<double> derivatives_; ///< behind positions_
    bool factorised_ = false;         ///< for the unknowns last evaluated
    std::stop_token stop_;            ///< of the data last seen
    /// The densities last seen, and the same relative to the domains' origins.
    TransportDensities given_{}, relative_{};
};

/// The smallest eigenvalue of H, and |b| / |grad b| on the boundary.
std::vector<FieldInfo> nvfem_fields();

} // namespace gaspard

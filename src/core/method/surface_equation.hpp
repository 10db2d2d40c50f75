// The equation of the sphere, or of a flat surface by the same elements (fem/surface_q2.hpp).
#pragma once

#include "core/fem/surface_q2.hpp"
#include "core/method/equation.hpp"

namespace gaspard {

class SurfaceEquation final : public Equation {
  public:
    explicit SurfaceEquation(std::shared_ptr<const SurfaceQ2> surface);

    void use_threads(int) override {}
    double other_cpu_seconds() const override { return 0; }

    /// From any mesh of the sphere, of whatever cells; of flat surfaces from the same alone.
    std::optional<State> adopt(const State& other) override;
    State adopt(Equation& other, std::span<const double> phi) override;
    std::unique_ptr<Equation> coarser() const override;

    Evaluation evaluate(const Monitor& monitor, std::span<const double> phi) override;
    const Points& positions() const override { return positions_; }
    void move(std::span<const double> phi) override;
    std::span<const double> residual() const override { return residual_; }
    /// At the mesh's nodes.
    Ellipticity ellipticity() const override;
    void direction(std::span<double> u) override { surface_->poisson(residual_, u, room_); }

  private:
    std::shared_ptr<const SurfaceQ2> surface_;
    SurfaceQ2::Room room_;
    Points gradient_; ///< w' (4.11)
    Points positions_;
    std::vector<double> monitor_; ///< m at the mesh's nodes
    std::vector<double> residual_;
};

} // namespace gaspard

// What the methods on an interval share: states, positions, and the solution of the problem on the mesh of
// the iterate, with its errors (layer/interval_problem.hpp).
//
// A State is the mesh x_0 < ... < x_n, of the domain's number of cells or of a coarser one; positions() are
// those of the domain's nodes, x(xi) in P1.
#pragma once

#include "core/layer/interval_domain.hpp"
#include "core/layer/layer_pde.hpp"
#include "core/method/method.hpp"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gaspard {

class IntervalMethod : public Method {
  public:
    explicit IntervalMethod(std::shared_ptr<const IntervalDomain> domain);

    State initial_state() const override;
    /// Accepts meshes of any interval and any number of cells.
    std::optional<State> adopt(const State& other, const Discretisation* of) override;
    const Points& positions() override;
    std::vector<SeriesInfo> series() const override;
    std::vector<double> measures(const ProblemData& data) override;
    std::vector<std::vector<double>> fields(const ProblemData& data) override;

  protected:
    const IntervalDomain& domain() const { return *domain_; }
    /// Makes a mesh of the domain, or a coarser one, that of the last evaluation. Throws InputError if the
    /// problem's formulas are wrong.
    void look_at(const ProblemData& data, std::vector<double> x);
    const std::vector<double>& x() const { return x_; }
    /// The mesh of a state of this method.
    static const std::vector<double>& mesh_of(const State& state);
    static std::vector<double>& mesh_of(State& state);

  private:
    struct Solved {
        IntervalSolution solution;
        double reference_error = 0, exact_error = 0; ///< the latter NaN if the solution is not known
    };
    void take_problem(const ProblemData& data);
    Solved solved_on(std::span<const double> x) const;
    const Solved& solved();
    const Solved& solved_on_uniform();

    std::shared_ptr<const IntervalDomain> domain_;
    std::vector<double> x_; ///< of the last evaluation
    Points positions_;
    std::shared_ptr<const Values> pde_values_; ///< of which pde_ was made
    std::string pde_type_;
    std::optional<IntervalPde> pde_;
    std::optional<Solved> solved_, uniform_; ///< on the positions and on the uniform mesh, if it is there
};

/// MethodType::fields of these methods.
std::vector<FieldInfo> interval_fields();

/// x(xi) in P1 at n + 1 equidistant places.
std::vector<double> resampled_interval(std::span<const double> x, std::size_t n);

} // namespace gaspard

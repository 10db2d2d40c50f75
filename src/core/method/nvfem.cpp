// The nonvariational finite element method of Kawecki, Lakkis, Pryer (2018): Newton's method for the
// transport equation (transport_equation.hpp), damped, with continuation in powers of the densities, on
// nested meshes.
#include "core/mesh/discretisation_as.hpp"
#include "core/method/nested.hpp"
#include "core/method/transport_equation.hpp"

namespace gaspard {

namespace {

class Nvfem final : public Method {
  public:
    Nvfem(const MethodContext& context, const Values& values)
        : Nvfem(
              std::make_unique<TransportEquation>(discretisation_as<TransportDomain>(context.discretisation),
                                                  recovery_of(values), context.stop),
              context, values) {}

    State initial_state() const override { return nested_.initial_state(); }
    std::optional<State> adopt(const State& other, const Discretisation* of) override {
        return nested_.adopt(other, of);
    }
    Evaluation evaluate(const ProblemData& data, const State& state, std::stop_token stop) override {
        return nested_.evaluate(data, state, std::move(stop));
    }
    Evaluation step(const ProblemData& data, State& state, std::stop_token stop) override {
        return nested_.step(data, state, std::move(stop));
    }
    const Points& positions() override { return nested_.positions(); }
    std::vector<SeriesInfo> series() const override { return nested_.series(); }
    std::shared_ptr<const Points> exact(const ProblemData& data) override { return equation_.exact(data); }
    void configure(const Values& values) override { nested_.configure(values); }
    std::vector<std::vector<double>> fields(const ProblemData&) override {
        nested_.positions(); // prolongs to the finest mesh
        return equation_.fields();
    }

  private:
    Nvfem(std::unique_ptr<TransportEquation> equation, const MethodContext& context, const Values& values)
        : equation_(*equation),
          nested_(std::move(equation), make_newton_stepper(), values, context.progress, context.stop) {}

    static Recovery recovery_of(const Values& values) {
        return values.boolean("recovery") ? Recovery::gradient : Recovery::none;
    }

    TransportEquation& equation_; ///< the finest of nested_
    Nested nested_;
};

} // namespace

MethodType nvfem_method() {
    return {
        .name = "nvfem",
        .label = "Transport (NVFEM)",
        .help = "the nonvariational finite element method with Newton's iteration, for maps from one convex "
                "domain to another",
        .rows =
            {{.key = "recovery",
              .label = "Gradient recovery",
              .kind = ParameterKind::boolean,
              .default_value = true,
              .help =
                  "project the gradient to continuous functions before the Hessian is formed; without it, "
                  "degree 1 finds no convex solution"}},
        .fields = nvfem_fields(),
        .make = [](const MethodContext& context, const Values& values) -> std::unique_ptr<Method> {
            return std::make_unique<Nvfem>(context, values);
        }};
}

} // namespace gaspard

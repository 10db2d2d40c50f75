// Meshes of an interval that need no iteration: Bakhvalov's (8), Shishkin's, and the equidistribution of the
// monitor to rounding, which mesh PDEs approach. One step goes from any mesh to the result.
#include "core/base/error.hpp"
#include "core/mesh/discretisation_as.hpp"
#include "core/method/interval_method.hpp"
#include "core/monitor/layer_rows.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace gaspard {

namespace {

using MakeMesh = std::function<std::vector<double>(const ProblemData&, const Values&, Interval, int cells)>;

class IntervalFormula final : public IntervalMethod {
  public:
    IntervalFormula(std::shared_ptr<const IntervalDomain> domain, MakeMesh make, const Values& values)
        : IntervalMethod(std::move(domain)), make_(std::move(make)) {
        configure(values);
    }

    void configure(const Values& values) override { values_ = values; }

    Evaluation evaluate(const ProblemData& data, const State& state, std::stop_token) override {
        target_ = make_(data, values_, domain().interval(), domain().cells());
        return look(data, mesh_of(state));
    }

    Evaluation step(const ProblemData& data, State& state, std::stop_token) override {
        mesh_of(state) = target_;
        Evaluation evaluation = look(data, target_);
        evaluation.step_size = 1;
        return evaluation;
    }

  private:
    Evaluation look(const ProblemData& data, const std::vector<double>& x) {
        look_at(data, x);
        double furthest = 0;
        if (x.size() == target_.size())
            for (std::size_t i = 0; i < x.size(); ++i)
                furthest = std::max(furthest, std::abs(x[i] - target_[i]));
        return {.residual = furthest / (domain().interval().b - domain().interval().a)};
    }

    MakeMesh make_;
    Values values_;
    std::vector<double> target_;
};

MethodType formula_method(std::string name, std::string label, std::string help,
                          std::vector<ParameterRow> rows, MakeMesh make) {
    return {.name = std::move(name),
            .label = std::move(label),
            .help = std::move(help),
            .rows = std::move(rows),
            .residual = {.name = "residual",
                         .label = "Distance to the result",
                         .scale = ParameterScale::logarithmic,
                         .help = "largest distance of a node from its place in the result, over b - a"},
            .fields = layer_fields(),
            .colour = "solution",
            .make = [make = std::move(make)](const MethodContext& context,
                                             const Values& values) -> std::unique_ptr<Method> {
                auto domain = discretisation_as<IntervalDomain>(context.discretisation);
                return std::make_unique<IntervalFormula>(std::move(domain), make, values);
            }};
}

std::vector<ParameterRow> layer_rows() {
    std::vector<ParameterRow> rows = {layer_width_row("eps", "ε"),
                                      {.key = "layers",
                                       .label = "Layers",
                                       .kind = ParameterKind::choice,
                                       .default_value = std::string("left"),
                                       .choices = {"left", "right", "both"},
                                       .help = "the ends with a layer; both: an even number of cells"}};
    for (ParameterRow& row : layer_shape_rows()) rows.push_back(std::move(row));
    return rows;
}

LayerShape shape_of(const ProblemData& data, const Values& values) {
    auto eps = values.real_or_auto("eps");
    if (!eps) eps = layer_width_of(data.pde.get(), "eps");
    if (!eps) throw InputError("method.eps = auto: the problem has no eps; set it to a number");
    return {.eps = *eps, .beta = values.real("beta"), .sigma = values.real("sigma"), .q = values.real("q")};
}

/// A mesh with its layer at the other end: x -> a + b - x.
std::vector<double> mirrored(std::vector<double> x) {
    const double a = x.front(), b = x.back();
    std::reverse(x.begin(), x.end());
    for (double& one : x) one = a == 0 ? b - one : b - (one - a);
    x.front() = a, x.back() = b;
    return x;
}

/// `left(interval, cells)`: a mesh with a layer at the left end.
template <class Left>
std::vector<double> with_layers(const std::string& layers, Interval interval, int cells, const Left& left) {
    if (layers == "left") return left(interval, cells);
    if (layers == "right") return mirrored(left(interval, cells));
    if (cells % 2 != 0)
        throw InputError("method.layers = both needs an even number of cells, not " + std::to_string(cells));
    const double middle = interval.a + 0.5 * (interval.b - interval.a);
    std::vector<double> x = left(Interval{interval.a, middle}, cells / 2);
    std::vector<double> other = mirrored(left(Interval{interval.a, middle}, cells / 2));
    for (std::size_t i = 1; i < other.size(); ++i) x.push_back(middle + (other[i] - interval.a));
    x.back() = interval.b;
    return x;
}

} // namespace

MethodType bakhvalov_method() {
    return formula_method(
        "bakhvalov", "Bakhvalov", "graded in the layers, uniform elsewhere, by formula (8)", layer_rows(),
        [](const ProblemData& data, const Values& values, Interval interval, int cells) {
            const LayerShape shape = shape_of(data, values);
            return with_layers(values.text("layers"), interval, cells,
                               [&](Interval on, int n) { return bakhvalov_mesh(shape, on, n).x; });
        });
}

MethodType shishkin_method() {
    return formula_method("shishkin", "Shishkin", "uniform in the layers and uniform elsewhere", layer_rows(),
                          [](const ProblemData& data, const Values& values, Interval interval, int cells) {
                              const LayerShape shape = shape_of(data, values);
                              return with_layers(
                                  values.text("layers"), interval, cells,
                                  [&](Interval on, int n) { return shishkin_mesh(shape, on, n); });
                          });
}

MethodType equidistribute_method() {
    return formula_method("equidistribute", "Equidistribution",
                          "inverts the integral of the monitor; what iterations approach", {},
                          [](const ProblemData& data, const Values&, Interval interval, int cells) {
                              return equidistributed_interval(*data.monitor, interval, cells);
                          });
}

} // namespace gaspard

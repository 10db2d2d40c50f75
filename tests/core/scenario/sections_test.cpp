// Sections and rows that only some problems have: monitor.source, pde, and rows that follow from values.
#include "core/base/error.hpp"
#include "core/scenario/toml.hpp"
#include "core/session/comparison.hpp"
#include "core/session/run.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <sstream>

namespace gaspard {
namespace {

class Stretch final : public TensorMonitor {
  public:
    explicit Stretch(double factor) : factor_(factor) {}
    void values(const Points& x, std::span<SymmetricTensor> values) const override {
        for (std::size_t i = 0; i < x.size(); ++i) values[i] = {.xx = factor_ * (1 + x.x[i]), .xy = 0.5};
    }
    void check() const override {
        if (!positive_definite({.xx = factor_, .xy = 0.5})) throw InputError("monitor.factor is too small");
    }

  private:
    double factor_;
};

/// A row for every name in the value of `names`: "a b" gives the rows a and b.
std::vector<ParameterRow> named_rows(const Values& values, const Space&) {
    std::vector<ParameterRow> rows;
    std::istringstream words(values.text("names"));
    for (std::string name; words >> name;) {
        if (name == "names") throw InputError("monitor.names must not contain 'names'");
        rows.push_back({.key = name, .label = name, .minimum = 0, .maximum = 10, .default_value = 1.0});
    }
    return rows;
}

/// How a monitor was made.
struct Made {
    int times = 0;
    bool with_operators = false;
    std::filesystem::path folder;
};

class SectionsTest : public testing::Test {
  protected:
    SectionsTest() {
        auto all = std::make_shared<Catalogue>(builtin_catalogue());
        const auto constant = [](double value) {
            return scalar_problem(monitor_types()[2].make(
                [&] {
                    Values values("monitor", monitor_types()[2].rows({}));
                    values.set("value", value);
                    return values;
                }(),
                {}));
        };
        all->monitors.push_back({.name = "named",
                                 .label = "Named",
                                 .help = "constants by name",
                                 .equation = "m = 1",
                                 .rows =
                                     [](const Space&) {
                                         return std::vector<ParameterRow>{
                                             {.key = "names",
                                              .label = "Names",
                                              .kind = ParameterKind::text,
                                              .default_value = std::string("a"),
                                              .role = ParameterRole::defines_rows}};
                                     },
                                 .make =
                                     [this, constant](const Values&, const MonitorContext& context) {
                                         ++made.times;
                                         made.with_operators = context.discretisation != nullptr;
                                         made.folder = context.folder;
                                         return constant(1).monitor;
                                     },
                                 .further_rows = named_rows});
        all->monitors.push_back({.name = "stretch",
                                 .label = "Stretch",
                                 .help = "a tensor",
                                 .equation = "M = [f (1 + x), 1/2; 1/2, 1]",
                                 .rows =
                                     [](const Space&) {
                                         return std::vector<ParameterRow>{{.key = "factor",
                                                                           .label = "Factor",
                                                                           .minimum = 0,
                                                                           .maximum = 10,
                                                                           .default_value = 4.0}};
                                     },
                                 .make_tensor =
                                     [](const Values& values, const MonitorContext&) {
                                         return std::make_shared<Stretch>(values.real("factor"));
                                     }});
        all->pdes.push_back({.name = "heat",
                             .label = "Heat",
                             .help = "diffusion",
                             .equation = "-div(k grad u) = 1",
                             .rows = {{.key = "conductivity",
                                       .label = "Conductivity",
                                       .minimum = 0.1,
                                       .maximum = 10,
                                       .default_value = 1.0}}});
        auto& plane = all->capabilities.front();
        plane.monitors.insert(plane.monitors.end(), {"named", "stretch"});
        Capability with_pde = plane;
        std::erase(plane.methods, "quasi-newton");
        with_pde.methods = {"quasi-newton"};
        with_pde.pdes = {"heat"};
        with_pde.sources = {"constant", "bell"};
        all->capabilities.push_back(with_pde);
        catalogue = all;
    }
    Scenario with(const std::vector<std::string>& settings) {
        Scenario scenario = default_scenario(*catalogue);
        apply_settings(*catalogue, scenario, settings);
        return scenario;
    }

    Made made;
    std::shared_ptr<const Catalogue> catalogue;
};

TEST_F(SectionsTest, AreThereOnlyForProblemsThatHaveThem) {
    EXPECT_THROW(with({"pde.conductivity=2"}), InputError);
    EXPECT_THROW(with({"monitor.source.type=bell"}), InputError);
    const Scenario scenario =
        with({"pde.conductivity=2", "monitor.source.amplitude=7", "monitor.source.type=bell",
              "method.type=quasi-newton", "domain.cells=8"});
    EXPECT_EQ(scenario.pde.type, "heat");
    EXPECT_EQ(scenario.pde.values.real("conductivity"), 2);
    EXPECT_EQ(scenario.source.type, "bell");
    EXPECT_EQ(scenario.source.values.real("amplitude"), 7);
    EXPECT_EQ(parse_scenario(*catalogue, to_toml(scenario), "untitled.toml"), scenario);
    Scenario other = scenario;
    set_value(*catalogue, other, "method.type", std::string("relaxation"));
    EXPECT_TRUE(other.pde.type.empty());
    EXPECT_TRUE(other.source.type.empty());
    EXPECT_THROW(parse_scenario(*catalogue, "[pde]\n", "test.toml"), InputError);
    EXPECT_THROW(parse_scenario(*catalogue, "[monitor.source]\ntype = \"bell\"\n", "test.toml"), InputError);
}

TEST_F(SectionsTest, MethodsGetThemAsProblemData) {
    const Scenario scenario = with({"method.type=quasi-newton", "monitor.source.type=bell"});
    const ProblemData data = make_problem_data(*catalogue, scenario, nullptr, {});
    ASSERT_TRUE(data.source && data.pde && !data.tensor);
    Points x(1);
    x.set(0, {0.5, 0.5, 0});
    std::vector<double> value(1);
    data.source->values(x, value);
    EXPECT_EQ(value[0], 51);
    EXPECT_EQ(data.pde->real("conductivity"), 1);
}

TEST_F(SectionsTest, RowsFollowFromValues) {
    Scenario scenario = with({"monitor.b=3", "monitor.names=b c", "monitor.type=named"});
    EXPECT_EQ(scenario.monitor.values.real("b"), 3);
    EXPECT_EQ(scenario.monitor.values.real("c"), 1);
    EXPECT_FALSE(scenario.monitor.values.has("a"));
    set_value(*catalogue, scenario, "monitor.names", std::string("b d"));
    EXPECT_EQ(scenario.monitor.values.real("b"), 3) << "a value that was chosen stays";
    EXPECT_FALSE(scenario.monitor.values.has("c"));
    EXPECT_EQ(parse_scenario(*catalogue, to_toml(scenario), "untitled.toml"), scenario);
    const Scenario before = scenario;
    EXPECT_THROW(set_value(*catalogue, scenario, "monitor.names", std::string("names")), InputError);
    EXPECT_EQ(scenario, before) << "all or nothing";
}

TEST_F(SectionsTest, ComparisonOffersMethodsWithOtherSections) {
    const Scenario scenario = with({"method.type=relaxation"});
    const auto methods = methods_for(*catalogue, scenario);
    EXPECT_NE(std::find(methods.begin(), methods.end(), "quasi-newton"), methods.end());
    EXPECT_EQ(with_method(*catalogue, scenario, "quasi-newton").pde.type, "heat");
}

TEST_F(SectionsTest, AnErrorNamesTheFirstUnknownKey) {
    try {
        with({"monitor.first=1", "monitor.second=1"});
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("monitor.first"), std::string::npos) << error.what();
    }
}

TEST_F(SectionsTest, AMonitorIsMadeOnceAfterTheOperators) {
    Scenario scenario = with({"monitor.type=named", "domain.cells=8"});
    scenario.folder = "there";
    check(*catalogue, scenario);
    EXPECT_EQ(made.times, 0);
    gaspard::Run run(catalogue, scenario);
    EXPECT_EQ(made.times, 1);
    EXPECT_TRUE(made.with_operators);
    EXPECT_EQ(made.folder, "there");
    set_value(*catalogue, scenario, "method.type", std::string("relaxation"));
    run.change(scenario);
    EXPECT_EQ(made.times, 1) << "another method for the same data";
    set_value(*catalogue, scenario, "monitor.a", 2.0);
    run.change(scenario);
    EXPECT_EQ(made.times, 2);
}

TEST_F(SectionsTest, ATensorIsMeasuredByItsDensity) {
    gaspard::Run run(catalogue, with({"monitor.type=stretch", "domain.cells=8", "domain.boundary=walls"}));
    const auto snapshot = run.snapshot();
    const Field* density = snapshot->field("monitor");
    for (std::size_t i = 0; i < density->values.size(); ++i)
        EXPECT_NEAR(density->values[i], std::sqrt(4 * (1 + snapshot->x.x[i]) - 0.25), 1e-14);
    EXPECT_THROW(gaspard::Run(catalogue, with({"monitor.type=stretch", "monitor.factor=0.1"})), InputError);
}

TEST(Tensor, DensityHasTheGradientOfItsValues) {
    const auto density = density_of(std::make_shared<Stretch>(4));
    Points x(1), gradient;
    x.set(0, {0.3, 0.2, 0});
    density->gradients(x, gradient);
    EXPECT_NEAR(gradient.x[0], 2 / std::sqrt(4 * 1.3 - 0.25), 1e-9);
    EXPECT_NEAR(gradient.y[0], 0, 1e-9);
}

TEST(Tensor, PositiveDefiniteIsSylvestersCriterion) {
    EXPECT_TRUE(positive_definite({.xx = 2, .yy = 1, .xy = 1}));
    EXPECT_FALSE(positive_definite({.xx = 1, .yy = 1, .xy = 1}));
    EXPECT_FALSE(positive_definite({.xx = -1, .yy = -1}));
    EXPECT_FALSE(positive_definite({.zz = -1}));
    EXPECT_FALSE(positive_definite({.xx = std::nan("")}));
    EXPECT_DOUBLE_EQ(determinant({.xx = 2, .yy = 3, .zz = 4, .xy = 1, .xz = 0.5, .yz = 0.25}),
                     2 * (12 - 0.0625) - 1 * (4 - 0.125) + 0.5 * (0.25 - 1.5));
}

} // namespace
} // namespace gaspard

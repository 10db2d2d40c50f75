// The mesh for a formula that is given as text, for example by a user of your program.
#include <cstdio>
#include <gaspard/gaspard.hpp>
#include <string>

using namespace gaspard;

int main(int argc, char** argv) {
    const std::string text = argc > 1 ? argv[1] : "1 + A*exp(-50*dist(0.3, 0.5)^2)";
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    Scenario scenario = default_scenario(*catalogue); // the periodic unit square
    apply_settings(*catalogue, scenario, {"domain.cells=40", "method.type=auto"});
    Run run(catalogue, scenario);
    try {
        FormulaOptions options{.space = run.space()};
        for (const std::string& name : check_formula(text, run.space())) options.parameters[name] = 10;
        run.follow(formula_monitor(text, options));
    } catch (const InputError& error) { // "unknown function 'sine' at character 5 (did you mean 'sin'?)"
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
    const StepReport& report = run.solve();
    std::printf("%s after %d iterations\n", status_name(report.status).data(), report.iteration);
}

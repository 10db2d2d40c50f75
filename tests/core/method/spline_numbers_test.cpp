// The numbers of Bahari, Habbal, Ratnani, Sonnendruecker (2024) on small meshes, and those that an
// independent prototype found. All tables: gaspard reproduce bahari-table1 and so on.
#include "core/method/manufactured.hpp"
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

struct Solve {
    Formulation formulation;
    int degree;
    std::size_t cells;
    double error, within; ///< relative
    int iterations, multilevel;
};

TEST(BahariNumbers, KnownSolutions) {
    const Formulation standard = Formulation::standard, mixed = Formulation::mixed;
    for (const Solve& s : {Solve{standard, 3, 8, 1.783e-4, 4e-4, 35, 26},
                           {standard, 3, 16, 2.308e-5, 4e-4, 35, 28},
                           {standard, 3, 32, 2.934e-6, 4e-4, 35, 27},
                           {standard, 4, 8, 6.037e-6, 4e-4, 35, 26},
                           {standard, 4, 16, 4.020e-7, 4e-4, 35, 26},
                           {standard, 5, 8, 3.584e-7, 4e-4, 35, 26},
                           {standard, 5, 16, 1.325e-8, 5e-4, 35, 26},
                           {mixed, 3, 8, 4.986e-5, 4e-4, 35, 26}}) {
        ManufacturedChoice choice{s.formulation, s.degree, s.cells, false,
                                  s.formulation == standard ? 1e-8 : 0};
        const auto plain = solve_manufactured(choice);
        EXPECT_NEAR(plain.error, s.error, s.within * s.error);
        EXPECT_EQ(plain.iterations, s.iterations);
        choice.multilevel = true;
        EXPECT_EQ(solve_manufactured(choice).iterations, s.multilevel);
    }
}

struct Map {
    const char* scenario;
    const char* method;
    int degree, cells;
    double err, qual, min_jacobian, max_jacobian, border;
    bool qual_over_f;
};

void expect_digits(double ours, double published, const std::string& what) {
    EXPECT_NEAR(ours, published, 1.1e-3 * std::abs(published)) << what; // of the last of four digits
}

void expect_map(const Map& map) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    Scenario scenario = find_scenario(*catalogue, map.scenario);
    apply_settings(*catalogue, scenario,
                   {std::string("method.type=") + map.method, "domain.degree=" + std::to_string(map.degree),
                    "domain.cells=" + std::to_string(map.cells), "method.diagnostics_every=1000"});
    gaspard::Run run(catalogue, scenario);
    const StepReport& last = run.solve();
    const auto value = [&](const std::string& name) {
        const auto found = last.value(name);
        EXPECT_TRUE(found) << name;
        return found.value_or(0);
    };
    const std::string what =
        std::string(map.scenario) + " p=" + std::to_string(map.degree) + " n=" + std::to_string(map.cells);
    expect_digits(value("err"), map.err, what);
    if (map.qual > 0) {
        expect_digits(value(map.qual_over_f ? "qual_f" : "qual"), map.qual, what);
        expect_digits(value("min_jacobian_psi"), map.min_jacobian, what);
        expect_digits(value("max_jacobian_psi"), map.max_jacobian, what);
    }
    if (map.border > 0) expect_digits(value("border_error"), map.border, what);
}

TEST(BahariNumbers, Square) {
    expect_map({"spline-circle", "picard", 3, 16, 4.195e-2, 6.030e-2, 0.2784, 1.796, 0, false}); // table 3
    expect_map({"spline-circle", "picard", 3, 32, 1.124e-2, 6.003e-2, 0.2759, 1.627, 0, false});
    expect_map({"spline-circle", "picard", 4, 32, 6.038e-3, 6.005e-2, 0.2803, 1.626, 0, false});
    expect_map({"spline-spiral", "picard", 3, 16, 0.4816, 0.1512, -2.286e-2, 3.587, 0, false}); // table 4
    expect_map({"spline-spiral", "picard", 3, 32, 0.1892, 0.1201, -7.120e-2, 3.644, 0, false});
    expect_map(
        {"spline-cosine-waves", "picard-mixed", 3, 32, 4.665e-3, 1.902e-2, 0.5681, 1.722, 0, false}); // 9
    expect_map({"spline-spiral", "picard-mixed", 3, 32, 0.1231, 0.1111, 3.123e-2, 3.413, 0, false});  // 10
}

TEST(BahariNumbers, PatchesInThePlane) {
    expect_map(
        {"spline-three-circles", "picard", 3, 32, 7.321e-2, 5.786e-2, 9.899e-2, 1.412, 3.969e-4, true}); // 5
    expect_map(
        {"spline-two-circles", "picard", 3, 32, 1.646e-2, 9.627e-2, 0.1706, 1.926, 3.079e-4, true}); // 6
    expect_map({"spline-face", "picard-mixed", 3, 32, 8.835e-2, 0, 0, 0, 0, false}); // 11, the prototype's
}

TEST(BahariNumbers, Surfaces) {
    expect_map({"spline-moebius", "picard-mixed", 3, 32, 7.748e-2, 8.802e-2, 0.1635, 1.944, 0, false}); // 15
    expect_map({"spline-torus", "picard-mixed", 3, 32, 0.2698, 0, 0, 0, 0, false});                     // 14
}

struct SolidNumbers {
    const char* scenario;
    int degree, cells;
    double err, err_last_layer, qual_last_layer, min_jacobian, max_jacobian;
};

// Tables 16 to 19 print integrals over the last layer of cells; those over the cube (0: not known) are those
// of the prototype.
TEST(BahariNumbers, SolidsInSpace) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    for (const SolidNumbers& row :
         {SolidNumbers{"spline-cube", 3, 16, 3.127e-2, 5.303e-3, 4.925e-3, 0.4922, 1.791},
          {"spline-cube", 4, 16, 0, 3.763e-3, 4.922e-3, 0.5166, 1.779},
          {"spline-ball", 3, 16, 0.1228, 2.148e-2, 3.108e-3, 0.3825, 1.920},
          {"spline-cylinder", 3, 16, 0.1559, 3.196e-2, 2.769e-3, 0.3252, 1.845},
          {"spline-half-torus", 3, 16, 0, 4.801e-2, 2.029e-3, 0.3284, 1.893}}) {
        Scenario scenario = find_scenario(*catalogue, row.scenario);
        apply_settings(*catalogue, scenario,
                       {"domain.degree=" + std::to_string(row.degree),
                        "domain.cells=" + std::to_string(row.cells), "method.diagnostics_every=1000",
                        "method.interpolation=false"});
        gaspard::Run run(catalogue, scenario);
        const StepReport& last = run.solve();
        EXPECT_EQ(last.status, RunStatus::converged) << row.scenario;
        EXPECT_EQ(last.tangled_cells, 0U) << row.scenario;
        if (row.err > 0) expect_digits(*last.value("err"), row.err, row.scenario);
        expect_digits(*last.value("err_last_layer"), row.err_last_layer, row.scenario);
        expect_digits(*last.value("qual_last_layer"), row.qual_last_layer, row.scenario);
        expect_digits(*last.value("min_jacobian_psi"), row.min_jacobian, row.scenario);
        expect_digits(*last.value("max_jacobian_psi"), row.max_jacobian, row.scenario);
        EXPECT_LT(*last.value("border_error"), 1e-14) << row.scenario;
    }
}

} // namespace
} // namespace gaspard

// Fields of files with a time axis, between their time steps.
#include "core/base/data_uri.hpp"
#include "core/base/error.hpp"
#include "core/function/field_function.hpp"
#include "core/io/netcdf_file.hpp"
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"
#include "core/session/time_series.hpp"
#include "support/messages.hpp"
#include "support/monitor_defaults.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

constexpr std::size_t points_a_side = 9, moments_in_file = 3;

/// v(x, y, k) = 1 + (k + 1)^2 x in the unit square, k = 0, 1, 2, as a data: URI.
/// From the time step `missing` on, the first `count` values are missing.
std::string file_in_time(std::size_t missing = moments_in_file, std::size_t count = 0) {
    std::vector<double> axis, values, times;
    for (std::size_t i = 0; i < points_a_side; ++i)
        axis.push_back(static_cast<double>(i) / (points_a_side - 1));
    for (std::size_t k = 0; k < moments_in_file; ++k) {
        times.push_back(10 * static_cast<double>(k));
        const double factor = static_cast<double>((k + 1) * (k + 1));
        for (std::size_t j = 0; j < points_a_side; ++j)
            for (std::size_t i = 0; i < points_a_side; ++i) values.push_back(1 + factor * axis[i]);
    }
    const std::size_t a_time = points_a_side * points_a_side;
    for (std::size_t k = missing; k < moments_in_file; ++k)
        for (std::size_t i = 0; i < count; ++i) values[k * a_time + i] = std::nan("");
    const NetcdfFile file{{{"time", moments_in_file}, {"y", points_a_side}, {"x", points_a_side}},
                          {{"time", {"time"}, times},
                           {"y", {"y"}, axis},
                           {"x", {"x"}, axis},
                           {"v", {"time", "y", "x"}, values}}};
    return data_uri(netcdf_bytes(file), "application/x-netcdf");
}

Values values_of_file() {
    Values values = default_values(monitor_type("field"), Space{});
    values.set("file", file_in_time());
    return values;
}

/// v at x = 1, the largest.
double at_right(const Values& values, std::shared_ptr<FileCache> files = nullptr) {
    DataContext context;
    context.files = std::move(files);
    return values_of(*read_field(values, context))[points_a_side - 1];
}

TEST(FieldMoment, InterpolatesBetweenTimeSteps) {
    Values values = values_of_file();
    values.set("time", std::int64_t{1});
    EXPECT_EQ(at_right(values), 5) << "auto: the step 'time'";
    const auto files = std::make_shared<FileCache>();
    for (const auto& cache : {std::shared_ptr<FileCache>(), files, files}) {
        for (const auto& [moment, expected] :
             {std::pair{0.0, 2.0}, {0.25, 2 + 0.25 * 3}, {1.0, 5.0}, {1.5, 7.5}, {2.0, 10.0}}) {
            values.set("moment", moment);
            EXPECT_NEAR(at_right(values, cache), expected, 1e-12) << moment;
        }
        values.set("moment", 7.5);
        EXPECT_EQ(at_right(values, cache), 10) << "after the last step it stays";
    }
    values.set("moment", std::string("auto")), values.set("time", std::int64_t{7});
    EXPECT_NE(message_of<InputError>([&] { at_right(values); }).find("there is no time 7; it has 0 to 2"),
              std::string::npos);
}

TEST(FieldMoment, NeedsTheSamePoints) {
    GridData a{Coordinates::cartesian, {{{0, 1}, {0, 1}, {}}}, {1, 2, 3, 4}}, b = a;
    b.values = {3, 4, 5, 8};
    const FieldData between = interpolated({"v", {"v"}, a}, {"v", {"v"}, b}, 0.25);
    EXPECT_EQ(values_of(between), (std::vector<double>{1.5, 2.5, 3.5, 5}));
    b.axes[0][1] = 2;
    EXPECT_THROW(interpolated({"v", {"v"}, a}, {"v", {"v"}, b}, 0.25), InputError);
}

TEST(FieldMoment, MovesWithTheClock) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    Scenario scenario = find_scenario(*catalogue, "walls-ring");
    apply_settings(*catalogue, scenario,
                   {"domain.cells=12", "monitor.type=field", "monitor.file=" + file_in_time(),
                    "monitor.density=values", "method.type=newton", "time.end=1.5", "time.step=0.5",
                    "method.diagnostics_every=1"});
    gaspard::Run run(catalogue, scenario);
    const auto columns = [&] { // the mean of x
        double sum = 0;
        const auto snapshot = run.snapshot();
        for (const double x : snapshot->x.x) sum += x;
        return sum / static_cast<double>(snapshot->x.size());
    };
    while (run.status() == RunStatus::running && run.time().value_or(0) == 0) run.step();
    const double early = columns();
    run.solve();
    EXPECT_EQ(run.status(), RunStatus::converged);
    EXPECT_EQ(run.time(), 1.5);
    EXPECT_GT(columns(), early + 0.02) << "nodes gather where v grows";
}

TEST(FieldMoment, NamesTheTimeStepThatCannotBeUsed) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    const auto note_of = [&](const std::string& file, const std::string& missing) {
        Scenario scenario = find_scenario(*catalogue, "walls-ring");
        apply_settings(*catalogue, scenario,
                       {"domain.cells=12", "monitor.type=field", "monitor.file=" + file,
                        "monitor.missing=" + missing, "method.type=newton", "time.end=1.5", "time.step=0.25"});
        gaspard::Run run(catalogue, scenario);
        const StepReport& last = run.solve();
        return std::to_string(*time_of(last)) + ' ' + last.note;
    };
    EXPECT_EQ(note_of(file_in_time(2, points_a_side * points_a_side), "nearest"),
              "1.000000 cannot read the packed data: all values of 'v' are missing in time step 2 (the first "
              "is 0), at t = 1.25");
    EXPECT_EQ(note_of(file_in_time(1, 7), "error"),
              "0.000000 7 of 81 values are missing in time step 1 (the first is 0); allow the nearest or the "
              "lowest to stand in (missing = nearest or floor), at t = 0.25");
    EXPECT_EQ(note_of(file_in_time(1, 1), "error"),
              "0.000000 1 of 81 values is missing in time step 1 (the first is 0); allow the nearest or the "
              "lowest to stand in (missing = nearest or floor), at t = 0.25");
    EXPECT_EQ(note_of(file_in_time(1, 7), "nearest"), "1.500000 ");
}

} // namespace
} // namespace gaspard

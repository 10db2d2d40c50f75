// Fields on domains: placement, interpolation, missing values.
#include "core/base/error.hpp"
#include "core/data/field_file.hpp"
#include "core/function/field_function.hpp"
#include "core/function/line_resampling.hpp"
#include "core/function/scattered_fit.hpp"
#include "core/spline/spline_domain.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <random>

namespace gaspard {
namespace {

using std::numbers::pi;
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

DataContext on(SpaceKind kind) {
    DataContext context;
    context.space.kind = kind;
    return context;
}

template <class Function>
FieldData grid(std::vector<double> x, std::vector<double> y, const Function& f,
               Coordinates coordinates = Coordinates::cartesian) {
    GridData data{coordinates, {std::move(x), std::move(y)}, {}};
    for (const double b : data.axes[1])
        for (const double a : data.axes[0]) data.values.push_back(f(a, b));
    return {"u", {"u"}, std::move(data)};
}

std::vector<double> steps(double first, double step, std::size_t count) {
    std::vector<double> all;
    for (std::size_t i = 0; i < count; ++i) all.push_back(first + step * static_cast<double>(i));
    return all;
}

double value_at(const ScalarFunction& u, Vec3 x) {
    Points points(1);
    points.set(0, x);
    double value = 0;
    u.values(points, std::span(&value, 1));
    return value;
}

template <class Function>
double largest_error(const ScalarFunction& u, const std::vector<Vec3>& places, const Function& f) {
    double error = 0;
    for (const Vec3 x : places) error = std::max(error, std::abs(value_at(u, x) - f(x)));
    return error;
}

std::vector<Vec3> places_in_square(double low, double high) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> at(low, high);
    std::vector<Vec3> all;
    for (int i = 0; i < 200; ++i) all.push_back({at(random), at(random), 0});
    return all;
}

std::vector<Vec3> places_on_sphere() {
    std::mt19937 random(4);
    std::normal_distribution<double> normal;
    std::vector<Vec3> all = {{0, 0, 1}, {0, 0, -1}};
    for (int i = 0; i < 200; ++i) {
        const Vec3 x{normal(random), normal(random), normal(random)};
        all.push_back((1 / norm(x)) * x);
    }
    return all;
}

std::string error_of(const FieldData& field, const FieldOptions& options, const DataContext& context) {
    try {
        field_function(field, options, context);
    } catch (const InputError& error) {
        return error.what();
    }
    return "none";
}

TEST(LineResampling, HasOrderFourOnUnevenAxes) {
    double before = 0;
    for (const std::size_t n : {20u, 40u, 80u}) {
        std::vector<double> axis, given, wanted(300);
        for (std::size_t i = 0; i <= n; ++i) {
            const double t = static_cast<double>(i) / static_cast<double>(n);
            axis.push_back(t + 0.1 * std::sin(2 * pi * t) / (2 * pi) * 3);
            given.push_back(std::sin(4 * axis.back()));
        }
        LineResampling(axis, 0, 1.0 / 299, 300, std::nullopt).apply(given, wanted);
        double error = 0;
        for (std::size_t i = 0; i < 300; ++i)
            error = std::max(error, std::abs(wanted[i] - std::sin(4 * static_cast<double>(i) / 299)));
        if (before > 0) {
            EXPECT_GT(before / error, 11);
        }
        before = error;
    }
    EXPECT_LT(before, 1e-6);
}

TEST(LineResampling, ReproducesCubicsAndGoesAround) {
    const std::vector<double> axis = {0, 0.5, 0.7, 1.5, 2};
    std::vector<double> given, wanted(9);
    for (const double t : axis) given.push_back(1 + t - t * t + 0.5 * t * t * t);
    LineResampling(axis, 0, 0.25, 9, std::nullopt).apply(given, wanted);
    for (std::size_t i = 0; i < 9; ++i) {
        const double t = 0.25 * static_cast<double>(i);
        EXPECT_NEAR(wanted[i], 1 + t - t * t + 0.5 * t * t * t, 1e-12);
    }
    // 0 to 350 degrees for -180 to 180.
    std::vector<double> waves, around(36);
    for (const double degree : steps(0, 10, 36)) waves.push_back(std::cos(degree * pi / 180 - 0.3));
    const LineResampling lines(steps(0, 10, 36), -175, 10, 36, 360.0);
    lines.apply(waves, around);
    for (std::size_t i = 0; i < 36; ++i) {
        EXPECT_TRUE(lines.covers(i));
        EXPECT_NEAR(around[i], std::cos((-175 + 10.0 * static_cast<double>(i)) * pi / 180 - 0.3), 2e-5);
    }
}

TEST(LineResampling, AveragesWhereItIsCoarser) {
    std::vector<double> given, wanted(10);
    for (std::size_t i = 0; i < 1000; ++i) given.push_back(i % 2 == 0 ? 1 : 0);
    LineResampling(steps(0, 0.001, 1000), 0.05, 0.1, 10, std::nullopt).apply(given, wanted);
    for (const double one : wanted) EXPECT_NEAR(one, 0.5, 0.15);
}

TEST(ScatteredFit, ReproducesLinearFunctions) {
    for (const int dimension : {2, 3}) {
        std::mt19937 random(1);
        std::uniform_real_distribution<double> at(0, 1);
        Points points(400);
        std::vector<double> values;
        for (std::size_t p = 0; p < 400; ++p) {
            points.set(p, {at(random), at(random), dimension == 3 ? at(random) : 0});
            values.push_back(2 - points.x[p] + 3 * points.y[p] + 5 * points.z[p]);
        }
        const ScatteredFit fit(points, values, dimension);
        for (int k = 0; k < 50; ++k) {
            const Vec3 x{0.25 + 0.5 * at(random), 0.25 + 0.5 * at(random),
                         dimension == 3 ? 0.25 + 0.5 * at(random) : 0};
            EXPECT_NEAR(fit.at(x).value, 2 - x.x + 3 * x.y + 5 * x.z, 1e-6);
        }
    }
}

TEST(ScatteredFit, TakesOnePointAndPointsAtOnePlace) {
    EXPECT_EQ(ScatteredFit(Points(1), {7}, 2).at({1, 1, 0}).value, 7);
    const ScatteredFit same(Points(40), std::vector<double>(40, 7), 2);
    EXPECT_NEAR(same.at({1, 1, 0}).value, 7, 1e-12);
    EXPECT_EQ(same.at({0, 0, 0}).value, 7);
}

TEST(LineResampling, StaysBetweenItsNeighboursWhereDataAreRough) {
    const std::vector<double> axis = {0, 1, 2, 9, 9.1, 9.2, 9.3, 20, 21, 40, 40.5, 41};
    const std::vector<double> rough = {1, 102, 101, 100, 1, 2, 1, 90, 102, 1, 1, 1};
    const std::size_t count = 801;
    const LineResampling fine(axis, 0, 41.0 / (count - 1), count, std::nullopt);
    std::vector<double> wanted(count);
    fine.apply(rough, wanted);
    for (std::size_t i = 0, at = 0; i < count; ++i) {
        const double x = 41.0 / (count - 1) * static_cast<double>(i);
        while (at + 2 < axis.size() && x > axis[at + 1]) ++at;
        EXPECT_GE(wanted[i], std::min(rough[at], rough[at + 1]) - 1e-12) << x;
        EXPECT_LE(wanted[i], std::max(rough[at], rough[at + 1]) + 1e-12) << x;
    }
}

TEST(LineResampling, KeepsItsOrderAtExtremaAndWhatIsPositive) {
    std::vector<double> errors;
    for (const std::size_t n : {24u, 48u, 96u}) {
        std::vector<double> axis, values, wanted(1000);
        for (std::size_t i = 0; i <= n; ++i) { // uneven, by a smooth map
            const double s = static_cast<double>(i) / static_cast<double>(n);
            axis.push_back(s + 0.05 * std::sin(2 * pi * s)), values.push_back(std::cos(2 * pi * axis.back()));
        }
        LineResampling(axis, 0.0005, 0.001, 1000, std::nullopt).apply(values, wanted);
        double error = 0;
        for (std::size_t i = 0; i < 1000; ++i)
            error = std::max(
                error, std::abs(wanted[i] - std::cos(2 * pi * (0.0005 + 0.001 * static_cast<double>(i)))));
        errors.push_back(error);
    }
    EXPECT_GT(errors[0] / errors[1], 12);
    EXPECT_GT(errors[1] / errors[2], 12);
    std::vector<double> parabola, wanted(100);
    for (const double x : steps(-2.5, 1, 6)) parabola.push_back(x * x - 0.2);
    LineResampling(steps(-2.5, 1, 6), -2.5, 5.0 / 99, 100, std::nullopt).apply(parabola, wanted);
    EXPECT_NEAR(*std::min_element(wanted.begin(), wanted.end()), 0.025, 1e-12);
}

TEST(FieldFunction, OnThePlaneByCoordinates) {
    const auto f = [](double x, double y) { return std::sin(2 * pi * x) * std::cos(2 * pi * y); };
    const FieldData field = grid(steps(0, 1.0 / 40, 40), steps(0, 1.0 / 40, 40), f);
    const MadeFunction made = field_function(field, {}, on(SpaceKind::periodic_square));
    EXPECT_LT(largest_error(*made.function, places_in_square(-1, 2), [&](Vec3 x) { return f(x.x, x.y); }),
              2e-5);
    EXPECT_TRUE(made.notes.empty());
}

TEST(FieldFunction, FitsABoxOfAnotherSize) {
    const auto f = [](double x, double y) { return std::sin(x / 1000) + y / 1000; };
    const FieldData field = grid(steps(-1000, 50, 41), steps(5000, 25, 41), f);
    const MadeFunction made = field_function(field, {}, on(SpaceKind::euclidean));
    EXPECT_LT(largest_error(*made.function, places_in_square(0.02, 0.98),
                            [&](Vec3 x) { return f(-1000 + 2000 * x.x, 5000 + 1000 * x.y); }),
              2e-4);
    EXPECT_EQ(made.notes, std::vector<std::string>{"The data are fitted to the box of the domain."});
    EXPECT_EQ(error_of(field, {.placement = FieldPlacement::coordinates}, on(SpaceKind::euclidean)),
              "the data lie outside of the domain; fit them to it (placement = fit)");
}

/// Smooth at the poles.
double on_sphere(Vec3 x) { return x.x * x.y + 0.5 * x.z + x.x; }

TEST(FieldFunction, OnTheSphereByLatitudeAndLongitude) {
    const auto f = [](double lon, double lat) { return on_sphere(at_latitude_longitude(lat, lon)); };
    for (const double first : {0.0, -180.0, 3.0}) {
        const FieldData field = grid(steps(first, 3, 120), steps(-88.5, 3, 60), f, Coordinates::geographic);
        const MadeFunction made = field_function(field, {}, on(SpaceKind::sphere));
        EXPECT_LT(largest_error(*made.function, places_on_sphere(), on_sphere), 2e-5) << first;
        EXPECT_TRUE(made.notes.empty());
    }
    // With both poles, and the meridian of 0 degrees twice.
    const FieldData closed = grid(steps(0, 3, 121), steps(-90, 3, 61), f, Coordinates::geographic);
    EXPECT_LT(largest_error(*field_function(closed, {}, on(SpaceKind::sphere)).function, places_on_sphere(),
                            on_sphere),
              2e-5);
}

TEST(FieldFunction, RegionsOfTheSphereGoOnAtTheirEdges) {
    const FieldData field = grid(
        steps(350, 1, 30), steps(30, 1, 20), [](double lon, double) { return lon; }, Coordinates::geographic);
    const MadeFunction made = field_function(field, {}, on(SpaceKind::sphere));
    EXPECT_NEAR(value_at(*made.function, at_latitude_longitude(40, 5)), 365, 0.1);
    EXPECT_NEAR(value_at(*made.function, at_latitude_longitude(40, -90)), 350, 0.1);
    ASSERT_EQ(made.notes.size(), 1u);
    EXPECT_TRUE(made.notes[0].ends_with("% of the domain; the nearest values are used there."))
        << made.notes[0];
    EXPECT_EQ(
        error_of(field, {.missing = MissingValues::error}, on(SpaceKind::sphere)),
        "the data do not cover 99 % of the domain; allow the nearest or the lowest value there (missing = "
        "nearest or floor)");
}

FieldData scattered(const std::vector<Vec3>& places, double (*f)(Vec3), int dimension, Coordinates kind) {
    ScatteredData data{kind, dimension, Points(places.size()), {}};
    for (std::size_t p = 0; p < places.size(); ++p) {
        data.points.set(p, places[p]);
        data.values.push_back(f(places[p]));
    }
    return {"u", {"u"}, std::move(data)};
}

TEST(FieldFunction, ScatteredPointsOnThePeriodicPlane) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> at(0, 1);
    std::vector<Vec3> places;
    for (int i = 0; i < 4000; ++i) places.push_back({at(random), at(random), 0});
    const auto f = [](Vec3 x) { return std::sin(2 * pi * x.x) + std::cos(2 * pi * x.y); };
    const MadeFunction made =
        field_function(scattered(places, f, 2, Coordinates::cartesian), {}, on(SpaceKind::periodic_square));
    EXPECT_LT(largest_error(*made.function, places_in_square(0, 1), f), 0.03);
    EXPECT_EQ(made.notes,
              std::vector<std::string>{"The field is a moving least-squares fit of 4000 points (linear, "
                                       "Gaussian weights, 12 neighbours)."});
}

TEST(FieldFunction, CoincidentPointsCountOnce) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> at(0, 1);
    std::vector<Vec3> places;
    for (int i = 0; i < 1000; ++i) {
        const Vec3 x{at(random), at(random), 0};
        places.insert(places.end(), 20, x); // more than the fit has neighbours
    }
    const auto f = [](Vec3 x) { return 1 + 2 * x.x - x.y; };
    const MadeFunction made =
        field_function(scattered(places, f, 2, Coordinates::cartesian), {}, on(SpaceKind::euclidean));
    EXPECT_LT(largest_error(*made.function, places_in_square(0.1, 0.9), f), 0.02);
    EXPECT_EQ(made.notes, (std::vector<std::string>{
                              "19000 points coincide with others; the means of the values at such points are "
                              "used.",
                              "The field is a moving least-squares fit of 1000 points (linear, Gaussian "
                              "weights, 12 neighbours)."}));
}

TEST(FieldFunction, PointsThatDoNotSpanThePlaneAreRefused) {
    const auto error = [](const std::vector<Vec3>& places, SpaceKind kind, Coordinates coordinates) {
        return error_of(scattered(
                            places, [](Vec3 x) { return x.x; }, 2, coordinates),
                        {}, on(kind));
    };
    const std::string line =
        "all points of the field lie on a line, so that it is not known between and beside "
        "them in the plane";
    std::vector<Vec3> diagonal, column;
    for (const double t : steps(0.1, 0.05, 15)) diagonal.push_back({t, t, 0}), column.push_back({0.5, t, 0});
    for (const SpaceKind kind : {SpaceKind::euclidean, SpaceKind::periodic_square}) {
        EXPECT_EQ(error(diagonal, kind, Coordinates::cartesian), line);
        EXPECT_EQ(error(column, kind, Coordinates::cartesian), line);
    }
    const std::vector<Vec3> two = {{0.1, 0.2, 0}, {0.7, 0.2, 0}};
    EXPECT_EQ(error(two, SpaceKind::euclidean, Coordinates::cartesian),
              "the field has values at two points only; at least three that are not on a line are needed");
    const std::string place =
        "all points of the field lie at one place; at least three that are not on a line are needed";
    EXPECT_EQ(error({{0.1, 0.2, 0}, {0.1, 0.2, 0}}, SpaceKind::euclidean, Coordinates::cartesian), place);
    EXPECT_EQ(error(two, SpaceKind::periodic_square, Coordinates::cartesian), place)
        << "fitted to a period, whose ends are one place";
    EXPECT_EQ(error({{0, 90, 0}, {50, 90, 0}}, SpaceKind::sphere, Coordinates::geographic), place);
    EXPECT_EQ(error({{0, 0, 0}, {50, 0, 0}, {90, 0, 0}}, SpaceKind::sphere, Coordinates::geographic), "none")
        << "on a great circle, but on no line";
}

TEST(FieldFunction, NumbersThatAreTooLargeAreRefused) {
    for (const double sign : {-1.0, 1.0}) {
        const FieldData values = grid(steps(0, 0.25, 5), steps(0, 0.25, 5),
                                      [&](double x, double) { return x > 0.4 ? sign * 1.7e308 : 0.0; });
        const std::string number = sign < 0 ? "−1.7×10³⁰⁸" : "1.7×10³⁰⁸";
        EXPECT_EQ(error_of(values, {}, on(SpaceKind::euclidean)),
                  "the field has the value " + number + "; beyond 10¹⁵⁰ values are too large to be used");
    }
    const FieldData far = grid({-1.7e308, 0, 1.7e308}, steps(0, 0.5, 3), [](double, double y) { return y; });
    EXPECT_EQ(error_of(far, {}, on(SpaceKind::euclidean)),
              "the field has the coordinate −1.7×10³⁰⁸; beyond 10¹⁵⁰ coordinates are too large to be used");
}

TEST(FieldFunction, ScatteredPointsOnTheSphereInBothKindsOfCoordinates) {
    std::mt19937 random(6);
    std::normal_distribution<double> normal;
    std::vector<Vec3> in_space;
    ScatteredData map{Coordinates::geographic, 2, {}, {}};
    for (int i = 0; i < 4000; ++i) {
        const Vec3 x{normal(random), normal(random), normal(random)}, unit = (1 / norm(x)) * x;
        in_space.push_back(unit);
        map.points.x.push_back(std::atan2(unit.y, unit.x) * 180 / pi);
        map.points.y.push_back(std::asin(unit.z) * 180 / pi);
        map.points.z.push_back(0);
        map.values.push_back(on_sphere(unit));
    }
    const auto points =
        field_function(scattered(in_space, on_sphere, 3, Coordinates::cartesian), {}, on(SpaceKind::sphere));
    const auto degrees = field_function({"u", {"u"}, map}, {}, on(SpaceKind::sphere));
    EXPECT_LT(largest_error(*points.function, places_on_sphere(), on_sphere), 0.03);
    EXPECT_LT(largest_error(*degrees.function, places_on_sphere(), on_sphere), 0.03);
}

TEST(FieldFunction, MissingValuesAreCountedAndReplaced) {
    const auto f = [](double x, double y) { return x < 0.2 && y < 0.2 ? nothing : 2 + x; };
    const FieldData field = grid(steps(0, 0.05, 21), steps(0, 0.05, 21), f);
    const DataContext walls = on(SpaceKind::euclidean);
    const MadeFunction near = field_function(field, {}, walls);
    EXPECT_EQ(near.notes,
              std::vector<std::string>{"16 of 441 values are missing; the nearest ones stand in for them."});
    EXPECT_GT(value_at(*near.function, {0.01, 0.01, 0}), 1.95);
    const MadeFunction low = field_function(field, {.missing = MissingValues::lowest}, walls);
    EXPECT_EQ(low.notes,
              std::vector<std::string>{"16 of 441 values are missing; the lowest one stands in for them."});
    EXPECT_NEAR(value_at(*low.function, {0.05, 0.05, 0}), 2, 0.02);
    EXPECT_EQ(error_of(field, {.missing = MissingValues::error}, walls),
              "16 of 441 values are missing; allow the nearest or the lowest to stand in (missing = nearest "
              "or floor)");
}

TEST(FieldFunction, Transforms) {
    const DataContext walls = on(SpaceKind::euclidean);
    const FieldData field =
        grid(steps(0, 0.1, 11), steps(0, 0.1, 11), [](double x, double) { return x < 0.05 ? 0 : -x; });
    EXPECT_NEAR(value_at(*field_function(field, {.transform = FieldTransform::absolute}, walls).function,
                         {0.5, 0.5, 0}),
                0.5, 0.01);
    EXPECT_NEAR(value_at(*field_function(field, {.transform = FieldTransform::square}, walls).function,
                         {0.7, 0.5, 0}),
                0.49, 0.002);
    EXPECT_EQ(error_of(field, {.transform = FieldTransform::logarithm}, walls),
              "the field has no values that can be used");
    const FieldData powers = grid(steps(0, 0.1, 11), steps(0, 0.1, 11),
                                  [](double x, double y) { return x + y < 0.05 ? 0 : std::pow(10, x); });
    const MadeFunction made = field_function(powers, {.transform = FieldTransform::logarithm}, walls);
    EXPECT_NEAR(value_at(*made.function, {0.5, 0.5, 0}), 0.5, 1e-3);
    EXPECT_EQ(made.notes[0], "1 of 121 values is not positive and has no logarithm.");
}

TEST(FieldFunction, OnASurfaceInSpace) {
    const Values values = [] {
        for (const DomainType& type : spline_domains())
            if (type.name == "spline-torus") return Values("domain", type.rows);
        return Values();
    }();
    const auto torus = make_spline_domain("spline-torus", values);
    DataContext context;
    context.space.dimension = 3;
    context.discretisation = torus.get();
    const Points& nodes = torus->mesh()->nodes;
    std::vector<Vec3> places;
    for (std::size_t i = 0; i < nodes.size(); ++i) places.push_back(nodes[i]);
    const auto f = [](Vec3 x) { return x.x + 2 * x.y - x.z; };
    const MadeFunction made = field_function(scattered(places, f, 3, Coordinates::cartesian), {}, context);
    double error = 0;
    for (const Vec3 x : places) error = std::max(error, std::abs(value_at(*made.function, x) - f(x)));
    EXPECT_LT(error, 0.05 * bounding_box(nodes).size());
    const FieldData parameters =
        grid(steps(0, 0.1, 11), steps(0, 0.1, 11), [](double u, double) { return u; });
    const MadeFunction fitted = field_function(parameters, {}, context);
    EXPECT_EQ(fitted.notes,
              std::vector<std::string>{"The data are fitted to the parameters of the surface."});
    EXPECT_EQ(
        error_of(parameters, {.placement = FieldPlacement::coordinates}, context),
        "a grid with two coordinates cannot be placed by them on a surface in space; use placement = fit");
}

} // namespace
} // namespace gaspard

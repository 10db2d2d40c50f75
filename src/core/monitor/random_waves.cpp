// A sum of random waves, determined by a seed and scaled to a given contrast C = max m / min m:
//
//   m(x) = C^g,   g = (f - min f) / (max f - min f),   f(x) = sum_i a_i cos( k_i . x + p_i )
//
// In the square, which is periodic, k_i is 2 pi times a pair of integers; on the sphere, k_i is any vector in
// R^3. min f and max f are taken over a 32 x 32 grid of points, so the contrast is only approximately C.
#include "core/base/check.hpp"
#include "core/monitor/monitor.hpp"
#include "core/monitor/random.hpp"

#include <algorithm>
#include <limits>

namespace gaspard {

namespace {

struct Wave {
    double amplitude, phase;
    Vec3 k;
};

class WavesMonitor final : public Monitor {
  public:
    WavesMonitor(std::vector<Wave> waves, double contrast, Space space)
        : waves_(std::move(waves)), contrast_(contrast), sphere_(space.kind == SpaceKind::sphere) {
        constexpr int side = 32;
        double least = std::numeric_limits<double>::infinity(), largest = -least;
        for (int j = 0; j < side; ++j)
            for (int i = 0; i < side; ++i) {
                const double u = (i + 0.5) / side, v = (j + 0.5) / side;
                const double f = height(sphere_ ? direction_from(u, v) : Vec3{u, v, 0});
                least = std::min(least, f), largest = std::max(largest, f);
            }
        slope_ = largest > least ? std::log(contrast) / (largest - least) : 0;
        least_ = least;
    }

    void values(const Points& x, std::span<double> values) const override {
        GASPARD_CHECK(values.size() == x.size());
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = value(place(x[i]));
    }

    void gradients(const Points& x, Points& gradients) const override {
        gradients.resize(x.size());
        for (std::size_t i = 0; i < x.size(); ++i) {
            const Vec3 p = place(x[i]);
            Vec3 sum;
            for (const Wave& wave : waves_)
                sum = sum - (wave.amplitude * std::sin(dot(wave.k, p) + wave.phase)) * wave.k;
            if (sphere_) sum = (1 / norm(x[i])) * (sum - dot(sum, p) * p);
            gradients.set(i, (slope_ * value(p)) * sum);
        }
    }

    void check() const override { GASPARD_CHECK(contrast_ >= 1); }

  private:
    Vec3 place(Vec3 x) const { return sphere_ ? (1 / norm(x)) * x : x; }
    double height(Vec3 p) const {
        double sum = 0;
        for (const Wave& wave : waves_) sum += wave.amplitude * std::cos(dot(wave.k, p) + wave.phase);
        return sum;
    }
    double value(Vec3 p) const { return std::exp(slope_ * (height(p) - least_)); }

    std::vector<Wave> waves_;
    double contrast_;
    bool sphere_;
    double slope_ = 0, least_ = 0; ///< log C / (max f - min f); min f
};

std::shared_ptr<const Monitor> make_random_waves(const Values& values, const MonitorContext& context) {
    const Space& space = context.space;
    std::mt19937_64 random(static_cast<std::uint64_t>(values.integer("seed")));
    constexpr double turn = 2 * std::numbers::pi;
    const double highest = values.real("wave_number");
    std::vector<Wave> waves;
    for (std::int64_t i = 0; i < values.integer("count"); ++i) {
        const double amplitude = 0.25 + 0.75 * uniform(random), phase = turn * uniform(random);
        const double u = uniform(random), v = uniform(random), w = uniform(random);
        Vec3 k;
        if (space.kind == SpaceKind::sphere) {
            k = (highest * (0.25 + 0.75 * w)) * direction_from(u, v);
        } else { // integer wave numbers, not both zero
            const double length = highest * std::sqrt(w);
            k = {std::round(length * std::cos(turn * u)), std::round(length * std::sin(turn * u)), 0};
            if (norm(k) == 0) k.x = 1;
            k = turn * k;
        }
        waves.push_back({amplitude, phase, k});
    }
    return std::make_shared<WavesMonitor>(std::move(waves), values.real("contrast"), space);
}

} // namespace

MonitorType random_waves_monitor() {
    return {.name = "random-waves",
            .label = "Random waves",
            .help = "a random smooth field, determined by a seed",
            .equation = "m(x) = C^g, g = Σᵢ aᵢ cos( kᵢ · x + pᵢ ), 0 ≤ g ≤ 1",
            .figure = MonitorFigure::unit_square,
            .rows =
                [](const Space& space) {
                    const bool sphere = space.kind == SpaceKind::sphere;
                    return std::vector<ParameterRow>{
                        seed_row("directions, wavelengths, amplitudes and phases"),
                        {.key = "count",
                         .label = "Number of waves",
                         .kind = ParameterKind::integer,
                         .minimum = 1,
                         .maximum = 20,
                         .default_value = std::int64_t{6},
                         .help = "number of waves"},
                        {.key = "contrast",
                         .label = "Contrast",
                         .symbol = "C",
                         .minimum = 1,
                         .maximum = 1e5,
                         .scale = ParameterScale::logarithmic,
                         .default_value = 20.0,
                         .help = "max m / min m, approximately"},
                        {.key = "wave_number",
                         .label = "Wave number",
                         .symbol = "k",
                         .unit = sphere ? "1/radian" : "waves per side",
                         .minimum = 1,
                         .maximum = 8,
                         .scale = ParameterScale::logarithmic,
                         .default_value = sphere ? 5.0 : 2.0,
                         .help = "wave number of the shortest waves; larger is finer"}};
                },
            .make = make_random_waves};
}

} // namespace gaspard

// Hills and valleys without a pattern, from a seed: a sum of random waves, scaled to a given contrast.
//
//   m(x) = C^g,   g = (f - least f) / (largest f - least f),   f(x) = sum of a_i cos( k_i . x + p_i )
//
// k_i is 2 pi times a pair of integers in the square, which is periodic; on the sphere any vector in space.
// The extremes of f are those of 32 x 32 places, so that C is the contrast nearly.
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
    double slope_ = 0, least_ = 0; ///< log C over the range of f; where that begins
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
        } else { // whole waves, at least one
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
            .help = "hills and valleys without a pattern, which a seed chooses",
            .equation = "m(x) = C^g, g from 0 to 1 with the sum of a_i cos( k_i . x + p_i )",
            .rows =
                [](const Space& space) {
                    const bool sphere = space.kind == SpaceKind::sphere;
                    return std::vector<ParameterRow>{seed_row("directions, lengths, heights and phases"),
                                                     {.key = "count",
                                                      .label = "Waves",
                                                      .kind = ParameterKind::integer,
                                                      .minimum = 1,
                                                      .maximum = 20,
                                                      .default_value = std::int64_t{6},
                                                      .help = "how many there are"},
                                                     {.key = "contrast",
                                                      .label = "Contrast",
                                                      .symbol = "C",
                                                      .minimum = 1,
                                                      .maximum = 1e5,
                                                      .scale = ParameterScale::logarithmic,
                                                      .default_value = 20.0,
                                                      .help = "largest m over smallest m"},
                                                     {.key = "wave_number",
                                                      .label = "Wave number",
                                                      .symbol = "k",
                                                      .unit = sphere ? "1/radian" : "waves a side",
                                                      .minimum = 1,
                                                      .maximum = 8,
                                                      .scale = ParameterScale::logarithmic,
                                                      .default_value = sphere ? 5.0 : 2.0,
                                                      .help = "of the shortest waves; larger is finer"}};
                },
            .make = make_random_waves};
}

} // namespace gaspard

#include "core/mesh/chart.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gaspard {

namespace {

constexpr double degree = std::numbers::pi / 180;

class BoxChart final : public Chart {
  public:
    using Chart::Chart;

    void coordinates(const Points& x, Points& s) const override { s = x; }
    void points(const Points& s, Points& x) const override { x = s; }
    void tangents(const Points& s, std::array<Points, 3>& tangents) const override {
        for (std::size_t i = 0; i < dimension(); ++i) {
            tangents[i] = Points(s.size());
            auto& own = i == 0 ? tangents[i].x : i == 1 ? tangents[i].y : tangents[i].z;
            std::fill(own.begin(), own.end(), 1.0);
        }
    }
    void to_cartesian(const Points&, const Points&, Points&) const override {}
};

class SphereChart final : public Chart {
  public:
    explicit SphereChart(double radius)
        : Chart(ChartKind::sphere,
                {{"longitude", -180, 180, ChartEnds::periodic}, {"latitude", -90, 90, ChartEnds::poles}}),
          radius_(radius) {}

    void coordinates(const Points& x, Points& s) const override {
        s.resize(x.size());
        for (std::size_t i = 0; i < x.size(); ++i) {
            s.x[i] = std::atan2(x.y[i], x.x[i]) / degree;
            s.y[i] = std::atan2(x.z[i], std::hypot(x.x[i], x.y[i])) / degree;
            s.z[i] = 0;
        }
    }
    void points(const Points& s, Points& x) const override {
        x.resize(s.size());
        for (std::size_t i = 0; i < s.size(); ++i) x.set(i, radius_ * at_latitude_longitude(s.y[i], s.x[i]));
    }
    void tangents(const Points& s, std::array<Points, 3>& tangents) const override {
        tangents[0].resize(s.size()), tangents[1].resize(s.size());
        const double length = radius_ * degree;
        for (std::size_t i = 0; i < s.size(); ++i) {
            const double longitude = s.x[i] * degree, latitude = s.y[i] * degree;
            const double c = std::cos(longitude), e = std::sin(longitude);
            tangents[0].set(i, length * std::cos(latitude) * Vec3{-e, c, 0});
            tangents[1].set(
                i, length * Vec3{-std::sin(latitude) * c, -std::sin(latitude) * e, std::cos(latitude)});
        }
    }
    void to_cartesian(const Points& x, const Points& s, Points& derivatives) const override {
        const double scale = 1 / (radius_ * degree);
        for (std::size_t i = 0; i < x.size(); ++i) {
            const double ring = std::sqrt(x.x[i] * x.x[i] + x.y[i] * x.y[i]);
            const double r = std::sqrt(ring * ring + x.z[i] * x.z[i]);
            // At a pole coordinates() has taken the meridian that atan2 gives.
            const double c = ring > 0 ? x.x[i] / ring : std::cos(s.x[i] * degree);
            const double e = ring > 0 ? x.y[i] / ring : std::sin(s.x[i] * degree);
            const double thinnest = std::sin(pole_margin * degree);
            const double east = scale * derivatives.x[i] / std::max(ring / r, thinnest);
            const double north = scale * derivatives.y[i], sine = x.z[i] / r, cosine = ring / r;
            derivatives.set(i, {-e * east - sine * c * north, c * east - sine * e * north, cosine * north});
        }
    }

  private:
    double radius_;
};

class SurfaceChart final : public Chart {
  public:
    explicit SurfaceChart(std::shared_ptr<const PatchParameters> parameters)
        : Chart(ChartKind::surface,
                {direction("u", parameters->closure()[0]), direction("v", parameters->closure()[1])}),
          parameters_(std::move(parameters)) {}

    void coordinates(const Points& x, Points& s) const override { parameters_->find(x, s); }
    void points(const Points& s, Points& x) const override { parameters_->points(s, x); }
    void tangents(const Points& s, std::array<Points, 3>& tangents) const override {
        parameters_->tangents(s, tangents[0], tangents[1]);
    }
    void to_cartesian(const Points&, const Points& s, Points& derivatives) const override {
        Points u, v;
        parameters_->tangents(s, u, v);
        for (std::size_t i = 0; i < s.size(); ++i) {
            const double uu = dot(u[i], u[i]), uv = dot(u[i], v[i]), vv = dot(v[i], v[i]);
            const double determinant = uu * vv - uv * uv;
            // Where the patch is degenerate there is no gradient.
            const double factor = determinant > 1e-14 * uu * vv ? 1 / determinant : 0.0;
            const double a = derivatives.x[i], b = derivatives.y[i];
            derivatives.set(i, factor * ((vv * a - uv * b) * u[i] + (uu * b - uv * a) * v[i]));
        }
    }

  private:
    /// Flipped ends do not fit to a grid: such a patch is taken as if it was cut open.
    static ChartDirection direction(const char* name, PatchClosure closure) {
        return {name, 0, 1, closure == PatchClosure::periodic ? ChartEnds::periodic : ChartEnds::open};
    }
    std::shared_ptr<const PatchParameters> parameters_;
};

/// Around a planar patch, whatever its mesh.
Box box_around(const PatchParameters& patch) {
    constexpr std::size_t n = 129;
    Points uv(n * n), x;
    for (std::size_t i = 0; i < uv.size(); ++i)
        uv.set(i, {static_cast<double>(i % n) / (n - 1), static_cast<double>(i / n) / (n - 1), 0});
    patch.points(uv, x);
    return bounding_box(x);
}

} // namespace

std::shared_ptr<const Chart> box_chart(const Box& box, std::size_t dimension, ChartEnds ends) {
    GASPARD_CHECK(dimension >= 1 && dimension <= 3);
    std::vector<ChartDirection> directions = {{"x", box.low.x, box.high.x, ends},
                                              {"y", box.low.y, box.high.y, ends},
                                              {"z", box.low.z, box.high.z, ends}};
    directions.resize(dimension);
    return std::make_shared<BoxChart>(ChartKind::box, std::move(directions));
}

std::shared_ptr<const Chart> sphere_chart(double radius) { return std::make_shared<SphereChart>(radius); }

std::shared_ptr<const Chart> chart_of(const DataContext& context) {
    const Space& space = context.space;
    const auto mesh = context.discretisation ? context.discretisation->mesh() : nullptr;
    const Box unit{{0, 0, 0}, {1, 1, 1}};
    switch (space.kind) {
    case SpaceKind::periodic_square:
        return box_chart(unit, 2, ChartEnds::periodic);
    case SpaceKind::sphere:
        return sphere_chart(mesh ? norm(mesh->nodes[0]) : 1.0);
    case SpaceKind::euclidean:
        break;
    }
    if (!mesh) return box_chart(space.box.value_or(unit), space.solid ? 3 : 2, ChartEnds::open);
    const auto patch = context.discretisation->parameters();
    const bool surface = cell_dimension(mesh->kind) == 2 && mesh->space_dimension == 3;
    if (patch && surface) return std::make_shared<SurfaceChart>(patch);
    const auto dimension = static_cast<std::size_t>(mesh->space_dimension);
    return box_chart(patch ? box_around(*patch) : bounding_box(mesh->nodes), dimension, ChartEnds::open);
}

} // namespace gaspard

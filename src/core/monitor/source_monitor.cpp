#include "core/monitor/source_monitor.hpp"

#include "core/base/check.hpp"
#include "core/base/error.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace gaspard {

namespace {

class SourceMonitor final : public Monitor {
  public:
    SourceMonitor(MadeFunction made, double floor, DensityWords words, const DataContext& context)
        : made_(std::move(made)), floor_(floor), words_(std::move(words)), space_(context.space) {
        GASPARD_CHECK(made_.function != nullptr);
        if (context.discretisation) mesh_ = context.discretisation->mesh();
    }

    void values(const Points& x, std::span<double> values) const override {
        made_.function->values(x, values);
        if (floor_ > 0)
            for (double& value : values) value = value < floor_ ? floor_ : value;
        bool good = true; // a loop without branches
        for (const double value : values) good &= (value > 0) & (value <= std::numeric_limits<double>::max());
        for (std::size_t i = 0; !good && i < values.size(); ++i)
            if (!(values[i] > 0) || !std::isfinite(values[i])) refuse(x[i], values[i]);
    }

    void gradients(const Points& x, Points& gradients) const override {
        made_.function->gradients(x, gradients);
        if (!(floor_ > 0)) return;
        std::vector<double> values(x.size());
        made_.function->values(x, values);
        for (std::size_t i = 0; i < values.size(); ++i)
            if (values[i] < floor_) gradients.set(i, {});
    }

    void check() const override {
        if (!mesh_) return;
        std::vector<double> values(mesh_->nodes.size());
        this->values(mesh_->nodes, values);
    }
    std::optional<SpaceKind> made_for() const override { return space_.kind; }
    MonitorReport report() const override { return {made_.notes, made_.choices, made_.advice}; }

  private:
    [[noreturn]] void refuse(Vec3 x, double value) const {
        std::string place = "(" + format_number(x.x) + ", " + format_number(x.y);
        if (x.z != 0 || space_.kind == SpaceKind::sphere) place += ", " + format_number(x.z);
        const std::string remedy = value <= 0 && !words_.remedy.empty() ? "; " + words_.remedy : "";
        throw InputError(words_.what + " must be positive and finite, but is " + format_number(value) +
                         " at " + place + ")" + remedy);
    }

    MadeFunction made_;
    double floor_;
    DensityWords words_;
    Space space_;
    std::shared_ptr<const Mesh> mesh_;
};

} // namespace

std::shared_ptr<const Monitor> source_monitor(MadeFunction made, double floor, DensityWords words,
                                              const DataContext& context) {
    return std::make_shared<SourceMonitor>(std::move(made), floor, std::move(words), context);
}

ParameterRow floor_row() {
    return {.key = "floor",
            .label = "Floor",
            .minimum = 0,
            .maximum = 1e12,
            .slider = SliderRange{0, 1},
            .default_value = 0.0,
            .help = "smallest value of m, which must be positive; 0: none"};
}

} // namespace gaspard

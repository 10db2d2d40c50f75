#include "core/monitor/source_monitor.hpp"

#include "core/base/check.hpp"
#include "core/base/error.hpp"
#include "core/base/short_number.hpp"
#include "core/monitor/inside_monitor.hpp"

#include <algorithm>
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
        if (context.within)
            within_ = context.within, raise_floor();
        else if (context.discretisation)
            mesh_ = context.discretisation->mesh();
    }

    void values(const Points& x, std::span<double> values) const override {
        made_.function->values(x, values);
        if (floor_ > 0)
            for (double& value : values) value = value < floor_ ? floor_ : value;
        bool good = true; // a loop without branches
        for (const double value : values) good &= (value > 0) & (value <= std::numeric_limits<double>::max());
        for (std::size_t i = 0; !good && i < values.size(); ++i)
            if ((!(values[i] > 0) || !std::isfinite(values[i])) && std::isfinite(norm(x[i])))
                refuse(x[i], values[i]); // the value at a place that is none is for the method to see
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
        if (!mesh_ && !within_) return;
        const Points& x = within_ ? within_->samples : mesh_->nodes;
        std::vector<double> values(x.size());
        this->values(x, values);
    }
    std::optional<SpaceKind> made_for() const override { return space_.kind; }
    MonitorReport report() const override { return {made_.notes, made_.choices, made_.advice}; }

  private:
    /// A map cannot spread no mass: where u is 0 or nearly so, m is a part of its mean.
    void raise_floor() {
        constexpr double none = 1e-6, part = 1e-2;
        if (floor_ > 0) return;
        std::vector<double> values(within_->samples.size());
        made_.function->values(within_->samples, values);
        double sum = 0, least = std::numeric_limits<double>::infinity(), most = 0;
        for (const double value : values) {
            if (!(value >= 0) || !std::isfinite(value)) return; // which check() refuses
            sum += value, least = std::min(least, value), most = std::max(most, value);
        }
        if (!(most > 0) || least > none * most) return;
        floor_ = part * sum / static_cast<double>(values.size());
        made_.notes.push_back("Where " + words_.what + " is 0 or nearly so, " + exact_number(100 * part) +
                              " % of its mean counts instead");
    }
    [[noreturn]] void refuse(Vec3 x, double value) const {
        std::string place = "(" + exact_number(x.x) + ", " + exact_number(x.y);
        if (x.z != 0 || space_.kind == SpaceKind::sphere) place += ", " + exact_number(x.z);
        const std::string remedy = value <= 0 && !words_.remedy.empty() ? "; " + words_.remedy : "";
        throw InputError(words_.what + " must be positive and finite, but is " + exact_number(value) +
                         " at " + place + ")" + remedy);
    }

    MadeFunction made_;
    double floor_;
    DensityWords words_;
    Space space_;
    std::shared_ptr<const Mesh> mesh_;
    std::shared_ptr<const DensityDomain> within_;
};

} // namespace

std::shared_ptr<const Monitor> source_monitor(MadeFunction made, double floor, DensityWords words,
                                              const DataContext& context) {
    auto monitor = std::make_shared<SourceMonitor>(std::move(made), floor, std::move(words), context);
    if (!context.within) return monitor;
    return std::make_shared<InsideMonitor>(std::move(monitor), context.within);
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

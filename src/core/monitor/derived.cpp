#include "core/monitor/derived.hpp"

#include "core/base/check.hpp"
#include "core/base/error.hpp"
#include "core/base/short_number.hpp"
#include "core/function/grid_function.hpp"
#include "core/monitor/derived_fields.hpp"
#include "core/monitor/grid_density.hpp"
#include "core/monitor/indicator.hpp"
#include "core/monitor/stages.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

namespace gaspard {

namespace {

constexpr double points_per_cell = 6;

std::string two_digits(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2g", value);
    return text;
}

class DerivedMonitor final : public Monitor {
  public:
    struct Stages {
        std::shared_ptr<const ScalarFunction> u;
        std::vector<std::pair<FieldInfo, GridFunction>> fields; ///< the stages before the last
        std::shared_ptr<const Monitor> last;                    ///< m, with what there is to say
    };
    explicit DerivedMonitor(Stages stages) : stages_(std::move(stages)) {}

    void values(const Points& x, std::span<double> values) const override { stages_.last->values(x, values); }
    void gradients(const Points& x, Points& gradients) const override {
        stages_.last->gradients(x, gradients);
    }
    std::optional<SpaceKind> made_for() const override { return stages_.last->made_for(); }
    MonitorReport report() const override { return stages_.last->report(); }
    std::shared_ptr<const ScalarFunction> solution() const override { return stages_.u; }

    std::vector<Field> fields(const Points& x) const override {
        std::vector<Field> fields;
        const auto add = [&](const FieldInfo& info, const ScalarFunction& function) {
            Field field{info, std::vector<double>(x.size())};
            function.values(x, field.values);
            fields.push_back(std::move(field));
        };
        add(derived_fields().front(), *stages_.u);
        for (const auto& [info, function] : stages_.fields) add(info, function);
        return fields;
    }

  private:
    Stages stages_;
};

void check_options(const DerivedOptions& o) {
    const auto require = [](bool good, const char* text) {
        if (!good) throw InputError(std::string("derived_monitor: ") + text);
    };
    require(o.alpha > 0 && std::isfinite(o.alpha), "alpha must be positive and finite");
    require(o.order > 0 && std::isfinite(o.order), "order must be positive and finite");
    require(std::isfinite(o.level), "level must be finite");
    require(o.width > 0 && std::isfinite(o.width), "width must be positive and finite");
    require(o.fraction >= 0 && o.fraction < 1, "fraction must be at least 0 and less than 1");
    require(o.floor >= 0 && std::isfinite(o.floor), "floor must be at least 0 and finite");
    require(o.contrast >= 1 && std::isfinite(o.contrast), "contrast must be at least 1 and finite");
    require(!o.smoothing || (*o.smoothing >= 0 && *o.smoothing <= 1000),
            "smoothing must be from 0 to 1000 cells");
}

/// The stages as far as they are computed.
class Maker {
  public:
    Maker(std::shared_ptr<const ScalarFunction> u, const DerivedOptions& options,
          const MonitorContext& context, MonitorReport of_u)
        : options_(options), context_(context), domain_(domain_grid(context, points_per_cell)),
          u_(std::move(u)), report_(std::move(of_u)) {}

    std::shared_ptr<const Monitor> make() {
        const IndicatorValues indicator = indicator_on(domain_, *u_, options_, options_.smooth, context_);
        if (indicator.constant) report_.notes.emplace_back("u is constant on the domain.");
        values_ = indicator.q;
        for (double& value : values_) value += indicator.background;
        add_field(1);
        if (options_.average) {
            values_ = indicator.q;
            average_stage(domain_, values_, options_.fraction);
        }
        add_field(2);
        if (options_.limit) limit();
        add_field(3);
        check_positive_values();
        if (options_.smooth) smooth();
        auto last = grid_density(domain_.grid, std::move(values_), std::move(report_), context_.space.kind);
        return std::make_shared<DerivedMonitor>(
            DerivedMonitor::Stages{u_, std::move(fields_), std::move(last)});
    }

  private:
    void add_field(std::size_t number) {
        fields_.emplace_back(derived_fields()[number], GridFunction(domain_.grid, values_));
    }
    /// Of all cells, those that go to what is above the least value.
    double fraction() const { return 1 - domain_.least(values_) / domain_.mean(values_); }

    void limit() {
        const double before = fraction();
        limit_stage(domain_, values_, options_.floor, options_.contrast);
        const double after = fraction();
        if (options_.average && std::abs(after - before) > 0.02)
            report_.notes.push_back("The limit changes the fraction of cells that go to the feature from " +
                                    two_digits(before) + " to " + two_digits(after) + ".");
    }

    void smooth() {
        Followed followed = follow(domain_, std::move(values_), options_.smoothing, context_);
        values_ = std::move(followed.values);
        report_.notes.insert(report_.notes.end(), followed.notes.begin(), followed.notes.end());
    }

    void check_positive_values() const {
        for (std::size_t i = 0; i < values_.size(); ++i)
            if (!(values_[i] > 0))
                throw InputError("the derived monitor is " + exact_number(values_[i]) +
                                 " at some points; turn on monitor.average, or monitor.limit with a floor");
    }

    const DerivedOptions& options_;
    const MonitorContext& context_;
    DomainGrid domain_;
    std::shared_ptr<const ScalarFunction> u_;
    std::vector<double> values_;
    std::vector<std::pair<FieldInfo, GridFunction>> fields_;
    MonitorReport report_;
};

} // namespace

std::vector<FieldInfo> derived_fields() {
    const auto info = [](const char* name, const char* label, const char* help) {
        FieldInfo field;
        field.name = name, field.label = label, field.help = help;
        return field;
    };
    return {info("u", "u", "the function from which the monitor is derived"),
            info("indicator", "indicator", "of u, before the other stages"),
            info("averaged", "averaged", "the indicator after the average"),
            info("limited", "limited", "after floor and limit; the monitor is this, smoothed")};
}

std::shared_ptr<const Monitor> derived_monitor(std::shared_ptr<const ScalarFunction> u,
                                               const DerivedOptions& options, const MonitorContext& context,
                                               MonitorReport of_u) {
    if (!u) throw InputError("derived_monitor: the function is null");
    check_options(options);
    return Maker(std::move(u), options, context, std::move(of_u)).make();
}

} // namespace gaspard

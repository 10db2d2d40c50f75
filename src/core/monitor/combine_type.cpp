// The type "combine": up to four parts, each a monitor of any other kind with its own rows, whose keys begin
// with the part's letter ("a.amplitude").
#include "core/base/check.hpp"
#include "core/base/growing_values.hpp"
#include "core/function/source.hpp"
#include "core/monitor/combine.hpp"
#include "core/monitor/grid_density.hpp"
#include "core/monitor/placement.hpp"
#include "core/monitor/stages.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gaspard {

namespace {

constexpr std::string_view own_name = "combine", no_part = "none";
constexpr std::array<const char*, 4> letters{"a", "b", "c", "d"};
/// Of the first two parts; there may be no others.
constexpr std::array<std::string_view, 4> first_types{"ring", "bell", no_part, no_part};

bool can_be_part(const MonitorType& type, const Space& space) {
    const auto& spaces = type.spaces;
    return type.make && type.name != own_name && (type.solids || !space.solid) &&
           (spaces.empty() || std::find(spaces.begin(), spaces.end(), space.kind) != spaces.end());
}

const MonitorType& type_of(const std::vector<MonitorType>& types, std::string_view name) {
    const auto type =
        std::find_if(types.begin(), types.end(), [&](const MonitorType& one) { return one.name == name; });
    GASPARD_CHECK(type != types.end()); // the row has no other choices
    return *type;
}

ParameterRow type_row(std::size_t part, const Space& space) {
    std::vector<std::string> choices;
    if (part >= 2) choices.emplace_back(no_part);
    for (const MonitorType& type : monitor_types())
        if (can_be_part(type, space)) choices.push_back(type.name);
    const std::string letter = letters[part];
    return {.key = letter + ".type",
            .label = letter + ": Monitor",
            .kind = ParameterKind::choice,
            .default_value = std::string(first_types[part]),
            .choices = std::move(choices),
            .help =
                part < 2 ? "one of the monitors that are combined" : "a further monitor; none: no such part",
            .role = ParameterRole::defines_rows};
}

std::vector<ParameterRow> rows(const Space& space) {
    std::vector<ParameterRow> rows = {
        {.key = "operation",
         .label = "Operation",
         .kind = ParameterKind::choice,
         .default_value = std::string("sum"),
         .choices = {"sum", "product", "maximum", "minimum"},
         .help = "how the terms weight * monitor^power become one monitor"},
        {.key = "smooth",
         .label = "Smooth",
         .kind = ParameterKind::boolean,
         .default_value = true,
         .help = "maximum and minimum: smooth, so that Newton's method converges; false: the exact ones"},
        {.key = "sharpness",
         .label = "Sharpness",
         .symbol = "s",
         .minimum = 1,
         .maximum = 64,
         .scale = ParameterScale::logarithmic,
         .default_value = 8.0,
         .help = "smooth maximum and minimum of N terms: at most a factor of N^(1/s) from the exact one"}};
    rows.push_back({.key = "smoothing",
                    .label = "Smoothing length",
                    .symbol = "L",
                    .unit = "cells",
                    .kind = ParameterKind::real_or_auto,
                    .minimum = 0,
                    .maximum = 100,
                    .default_value = std::string("auto"),
                    .help = "of the whole, in cells of the uniform mesh; auto: as much as the mesh needs to "
                            "follow the monitor; 0: none"});
    for (std::size_t part = 0; part < letters.size(); ++part) rows.push_back(type_row(part, space));
    return rows;
}

ParameterRow power_row(const std::string& letter) {
    return {.key = letter + ".power",
            .label = letter + ": Power",
            .minimum = -4,
            .maximum = 4,
            .default_value = 1.0,
            .help = "exponent of the part; negative: large cells where the part is large"};
}

ParameterRow weight_row(const std::string& letter) {
    return {.key = letter + ".weight",
            .label = letter + ": Weight",
            .minimum = 1e-6,
            .maximum = 1e6,
            .scale = ParameterScale::logarithmic,
            .default_value = 1.0,
            .help = "factor of the part; without effect in a product"};
}

/// The values of one part, by the keys of its own type.
Values part_values(const Values& values, const std::string& letter, const MonitorType& type,
                   const Space& space) {
    return grown_part(values, letter + ".", rows_on(type, space),
                      [&](const Values& known) { return further_rows_on(type, known, space); });
}

/// Whether there is such a part.
bool has_part(const Values& values, const std::string& letter) {
    return values.text(letter + ".type") != no_part;
}

void add_part(std::vector<ParameterRow>& rows, const std::string& letter, std::vector<ParameterRow> part) {
    for (ParameterRow& row : prefixed(std::move(part), letter + ".")) {
        row.label = letter + ": " + row.label;
        row.former_key.clear();
        rows.push_back(std::move(row));
    }
}

std::vector<ParameterRow> further_rows(const Values& values, const Space& space) {
    const auto types = monitor_types();
    std::vector<ParameterRow> rows;
    for (const std::string letter : letters) {
        if (!has_part(values, letter)) continue;
        rows.push_back(weight_row(letter));
        rows.push_back(power_row(letter));
        const MonitorType& type = type_of(types, values.text(letter + ".type"));
        add_part(rows, letter, rows_on(type, space));
        add_part(rows, letter, further_rows_on(type, part_values(values, letter, type, space), space));
    }
    return rows;
}

CombineOperation operation_of(const std::string& name) {
    constexpr std::pair<std::string_view, CombineOperation> names[] = {
        {"sum", CombineOperation::sum},
        {"product", CombineOperation::product},
        {"maximum", CombineOperation::maximum},
        {"minimum", CombineOperation::minimum}};
    for (const auto& [text, operation] : names)
        if (text == name) return operation;
    check_failed("the operation is one of the choices");
}

/// A monitor that a mesh can follow in place of the exact one, with its fields and notes.
class FollowedMonitor final : public Monitor {
  public:
    FollowedMonitor(std::shared_ptr<const Monitor> exact, std::shared_ptr<const Monitor> smoothed,
                    const std::vector<std::string>& notes)
        : exact_(std::move(exact)), used_(smoothed ? std::move(smoothed) : exact_),
          report_(exact_->report()) {
        report_.notes.insert(report_.notes.end(), notes.begin(), notes.end());
    }

    void values(const Points& x, std::span<double> values) const override { used_->values(x, values); }
    void gradients(const Points& x, Points& gradients) const override { used_->gradients(x, gradients); }
    void check() const override { exact_->check(); }
    std::optional<SpaceKind> made_for() const override { return exact_->made_for(); }
    std::vector<Field> fields(const Points& x) const override { return exact_->fields(x); }
    MonitorReport report() const override { return report_; }

  private:
    std::shared_ptr<const Monitor> exact_, used_;
    MonitorReport report_;
};

/// The monitor as it is if a mesh can follow it, otherwise smoothed (`length` cells; nullopt: as needed) or
/// with a note.
std::shared_ptr<const Monitor> followed(std::shared_ptr<const Monitor> exact, std::optional<double> length,
                                        const MonitorContext& context) {
    constexpr double points_per_cell = 6;
    const DomainGrid domain = domain_grid(context, points_per_cell);
    std::vector<double> m(domain.x.size());
    exact->values(domain.x, m);
    const double largest = *std::max_element(m.begin(), m.end());
    for (double& value : m) { // in a unit in which averages do not overflow
        value /= largest;
        if (!(value >= std::numeric_limits<double>::min())) return exact; // the run says what is wrong
    }
    Followed made = follow(domain, std::move(m), length, context);
    for (double& value : made.values) value *= largest;
    std::shared_ptr<const Monitor> smoothed;
    if (made.length > 0) smoothed = grid_density(domain.grid, std::move(made.values), {}, context.space.kind);
    return std::make_shared<FollowedMonitor>(std::move(exact), std::move(smoothed), made.notes);
}

std::shared_ptr<const Monitor> make(const Values& values, const MonitorContext& context) {
    const auto types = monitor_types();
    std::vector<CombinedPart> parts;
    for (const std::string letter : letters) {
        if (!has_part(values, letter)) continue;
        const MonitorType& type = type_of(types, values.text(letter + ".type"));
        const Values own = part_values(values, letter, type, context.space);
        parts.push_back({.monitor = make_on(type, own, context),
                         .power = values.real(letter + ".power"),
                         .weight = values.real(letter + ".weight"),
                         .name = letter});
    }
    CombineOptions options{.operation = operation_of(values.text("operation"))};
    options.sharpness = values.boolean("smooth") ? std::optional(values.real("sharpness")) : std::nullopt;
    return followed(combined_monitor(std::move(parts), options), values.real_or_auto("smoothing"), context);
}

std::vector<FieldInfo> fields() {
    std::vector<FieldInfo> infos;
    for (const std::string letter : letters) {
        FieldInfo info;
        info.name = "part-" + letter;
        info.help = "part " + letter + " of the combined monitor";
        infos.push_back(std::move(info));
    }
    return infos;
}

std::vector<MonitorStage> stages() {
    std::vector<MonitorStage> parts;
    for (const std::string letter : letters)
        parts.push_back({"Part " + letter, "part-" + letter, {letter + "."}});
    return parts;
}

} // namespace

MonitorType combined_monitor_type() {
    return {.name = std::string(own_name),
            .label = "Combine",
            .help = "the sum, product, maximum or minimum of up to four monitors",
            .equation = "m(x) = t_a + t_b + ..., t_a t_b ..., max(t_a, t_b, ...) or min(t_a, t_b, ...), "
                        "t_i = w_i m_i^p_i",
            .rows = rows,
            .make = make,
            .further_rows = further_rows,
            .fields = fields(),
            .stages = stages()};
}

} // namespace gaspard

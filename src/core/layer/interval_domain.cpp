#include "core/layer/interval_domain.hpp"

#include "core/base/check.hpp"
#include "core/base/error.hpp"
#include "core/base/short_number.hpp"

#include <algorithm>
#include <utility>

namespace gaspard {

IntervalDomain::IntervalDomain(Interval interval, int cells) : interval_(interval) {
    GASPARD_CHECK(cells > 0 && interval.a < interval.b);
    Mesh mesh{.kind = {CellShape::line, 1},
              .space_dimension = 1,
              .nodes = Points(static_cast<std::size_t>(cells) + 1),
              .cells = {}};
    mesh.nodes.x = uniform_interval(interval, cells);
    for (std::int32_t i = 0; i < cells; ++i) mesh.cells.insert(mesh.cells.end(), {i, i + 1});
    mesh_ = std::make_shared<const Mesh>(std::move(mesh));
}

static ParameterRow end_row(const char* key, const char* label, const char* symbol, double value) {
    return {.key = key,
            .label = label,
            .symbol = symbol,
            .unit = "length",
            .minimum = -1e6,
            .maximum = 1e6,
            .slider = SliderRange{-1, 2},
            .default_value = value,
            .help = "the interval is [a, b]"};
}

DomainType interval_domain() {
    return {.name = "interval",
            .label = "Interval",
            .help = "an interval [a, b], divided into N cells",
            .rows = {{.key = "cells",
                      .label = "Cells",
                      .symbol = "N",
                      .kind = ParameterKind::integer,
                      .minimum = 1,
                      .maximum = 65536,
                      .scale = ParameterScale::logarithmic,
                      .slider = SliderRange{4, 1024},
                      .default_value = std::int64_t{32},
                      .help = "the mesh has N cells"},
                     end_row("start", "Left end", "a", 0),
                     end_row("end", "Right end", "b", 1)},
            .space = [](const Values& values, const DomainContent&) {
                const double a = values.real("start"), b = values.real("end");
                Space space{.dimension = 1};
                space.reach = {Box{{std::min(a, b), 0, 0}, {std::max(a, b), 0, 0}}};
                return space;
            }};
}

std::shared_ptr<const IntervalDomain> make_interval(const Values& values) {
    const Interval interval{values.real("start"), values.real("end")};
    if (!(interval.a < interval.b))
        throw InputError("domain.end (" + exact_number(interval.b) + ") must be greater than domain.start (" +
                         exact_number(interval.a) + ")");
    return std::make_shared<IntervalDomain>(interval, static_cast<int>(values.integer("cells")));
}

} // namespace gaspard

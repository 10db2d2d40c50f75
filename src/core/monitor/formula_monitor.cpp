#include "core/monitor/formula_monitor.hpp"

#include "core/monitor/source_monitor.hpp"

#include <utility>

namespace gaspard {

std::shared_ptr<const Monitor> formula_monitor(const std::string& text, FormulaOptions options) {
    const DataContext context{.space = options.space};
    return source_monitor({.function = formula_function(text, std::move(options))}, 0,
                          {"the formula", "max(..., 0.01) around it makes it positive"}, context);
}

MonitorType typed_formula_monitor() {
    const SourceType source = source_type("formula");
    return {.name = source.name,
            .label = source.label,
            .help = source.help,
            .equation = "m(x) = the formula",
            .rows =
                [source](const Space& space) {
                    std::vector<ParameterRow> rows = source.rows(space);
                    rows.push_back(floor_row());
                    return rows;
                },
            .make =
                [source](const Values& values, const MonitorContext& context) {
                    return source_monitor(
                        source.make(values, context), values.real("floor"),
                        {"the formula", "set " + key_name(values, "floor") + " to a positive number"},
                        context);
                },
            .further_rows = source.further_rows};
}

} // namespace gaspard

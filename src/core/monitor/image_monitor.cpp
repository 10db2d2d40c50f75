#include "core/monitor/image_monitor.hpp"

#include "core/function/density_rows.hpp"
#include "core/function/image_function.hpp"
#include "core/monitor/grid_density.hpp"

#include <algorithm>
#include <utility>

namespace gaspard {

std::shared_ptr<const Monitor> image_monitor(const GreyImage& image, const ImageMonitorOptions& options,
                                             const DataContext& context) {
    ImageOptions dense = options.image; // d is large where the picture is dark
    dense.invert = !dense.invert;
    ImageGrid made = image_grid(image, dense, context);
    const DomainGrid domain = domain_on(made.grid, context);
    go_on_beside(domain, made.values);
    for (double& value : made.values) value = std::clamp(value, 0.0, 1.0); // a spline may overshoot
    to_density(made.values, options.contrast);
    made.sigma = blur_density(domain, made.values, made.sigma, context);
    made.notes.insert(made.notes.begin(), blur_note(options.image, made));
    return grid_density(std::move(made.grid), std::move(made.values), {std::move(made.notes), {}},
                        context.space.kind);
}

std::shared_ptr<const Monitor> image_monitor(const std::string& file, const ImageMonitorOptions& options,
                                             const DataContext& context) {
    return image_monitor(*read_image(file, "file", context), options, context);
}

MonitorType image_file_monitor() {
    return {.name = "image",
            .label = "Image",
            .help = "small cells where a picture is dark (or bright)",
            .equation = "m(x) = 1 + (C - 1) (1 - brightness)^γ, blurred",
            .solids = false,
            .rows =
                [](const Space& space) {
                    std::vector<ParameterRow> rows =
                        image_rows(space, "small cells where the picture is bright instead of dark");
                    rows.insert(rows.begin() + 1,
                                contrast_row("the largest ratio of densities (1 / cell area)"));
                    return rows;
                },
            .make =
                [](const Values& values, const MonitorContext& context) {
                    const auto image = read_image(values.text("file"), key_name(values, "file"), context);
                    return image_monitor(
                        *image, {image_options(values, context.space), values.real("contrast")}, context);
                }};
}

} // namespace gaspard

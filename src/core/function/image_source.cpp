// The source whose function is a picture, and its rows.
#include "core/base/error.hpp"
#include "core/base/read_data_file.hpp"
#include "core/function/density_rows.hpp"
#include "core/function/image_function.hpp"

#include <utility>

namespace gaspard {

std::shared_ptr<const GreyImage> read_image(const std::string& file, const std::string& key,
                                            const DataContext& context) {
    if (file.empty()) throw InputError(key + " is empty; it is the path of a PNG or JPEG picture");
    const std::string path = data_file_name(file, context.folder);
    const std::function<std::shared_ptr<const GreyImage>()> decode = [&] {
        const auto report = [&](double done) {
            if (context.progress) context.progress(done, "Reading the picture");
        };
        return std::make_shared<const GreyImage>(
            decode_image(read_data_file(file, context.folder), path, 2048, report, context.stop));
    };
    if (!context.files) return decode();
    return context.files->get<GreyImage>(
        is_data_uri(file) ? file : path, "image", decode,
        [](const GreyImage& image) { return sizeof image + image.grey.size() * sizeof(float); });
}

std::vector<ParameterRow> image_rows(const Space& space, const std::string& invert_help) {
    std::vector<ParameterRow> rows = {
        {.key = "file",
         .label = "Picture",
         .kind = ParameterKind::text,
         .default_value = std::string(),
         .help = "a PNG or JPEG file, relative to the folder of the scenario's file",
         .role = ParameterRole::file},
        invert_row(invert_help),
        gamma_row("exponent of the grey values: larger than 1 leaves the strongest, smaller lifts the weak"),
        {.key = "floor",
         .label = "Floor",
         .minimum = 0,
         .maximum = 1,
         .default_value = 0.0,
         .help = "weaker grey values count as this one, from 0 to 1"},
        blur_row(),
        {.key = "blur_unit",
         .label = "Blur unit",
         .kind = ParameterKind::choice,
         .default_value = std::string("cells"),
         .choices = {"cells", "pixels"},
         .help = "cells of the uniform mesh, or pixels of the picture"}};
    if (space.kind == SpaceKind::sphere)
        rows.push_back({.key = "left_longitude",
                        .label = "Left edge",
                        .unit = "degrees",
                        .minimum = -180,
                        .maximum = 180,
                        .default_value = -180.0,
                        .help = "longitude of the picture's left edge; the picture is an equirectangular map",
                        .periodic = true});
    else
        rows.push_back({.key = "fit",
                        .label = "Fit",
                        .kind = ParameterKind::choice,
                        .default_value = std::string("fill"),
                        .choices = {"fit", "fill", "stretch"},
                        .help =
                            "fit: all of the picture is on the domain; fill: it covers the domain and is cut "
                            "off; stretch: it gets the domain's width and height"});
    return rows;
}

ImageOptions image_options(const Values& values, const Space& space) {
    ImageOptions options{.invert = values.boolean("invert"),
                         .gamma = values.real("gamma"),
                         .floor = values.real("floor"),
                         .blur = values.real("blur"),
                         .blur_unit =
                             values.text("blur_unit") == "pixels" ? LengthUnit::pixels : LengthUnit::cells};
    if (space.kind == SpaceKind::sphere) {
        options.left_longitude = values.real("left_longitude");
    } else {
        const std::string& fit = values.text("fit");
        options.fit = fit == "fit" ? ImageFit::fit : fit == "fill" ? ImageFit::fill : ImageFit::stretch;
    }
    return options;
}

SourceType image_source() {
    return {
        .name = "image",
        .label = "Image",
        .help = "brightness of a PNG or JPEG picture, from 0 (black) to 1 (white)",
        .rows = [](const Space& space) { return image_rows(space, "1 - brightness instead of brightness"); },
        .make =
            [](const Values& values, const DataContext& context) {
                const auto image = read_image(values.text("file"), key_name(values, "file"), context);
                return image_function(*image, image_options(values, context.space), context);
            },
        .solids = false};
}

} // namespace gaspard

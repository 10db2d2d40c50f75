// Pictures as functions on a domain:
//
//   u(x) = G_sigma * max( b^gamma, floor )
//
// with the brightness b, 0 (black) to 1 (white), or 1 - b if inverted, and the Gaussian blur G_sigma of
// function/smoothing.hpp. The picture stands as on the screen, its top at large y (v, or the north pole), in
// the box of the domain's chart; on a sphere it is an equirectangular map. Beside the picture its edges go
// on.
#pragma once

#include "core/data/image.hpp"
#include "core/function/grid_function.hpp"
#include "core/function/image_options.hpp"
#include "core/function/source.hpp"

#include <memory>
#include <string>
#include <vector>

namespace gaspard {

/// A picture on a grid of the domain's chart before it is blurred, and what to tell the user.
struct ImageGrid {
    Grid grid;
    std::vector<double> values{}; ///< max(b^gamma, floor)
    double sigma = 0, wanted = 0; ///< the blur, and that of the options, as lengths
    double cell = 0;              ///< size of the cells of the uniform mesh
    std::vector<std::string> notes{};
};

/// The grid is fine enough for the blur. Throws InputError if the domain is not of dimension two.
ImageGrid image_grid(const GreyImage& image, const ImageOptions& options, const DataContext& context);
/// "The picture is blurred over 2.2 cells instead of 1, so that the mesh can follow."
std::string blur_note(const ImageOptions& options, const ImageGrid& made);
/// u. Throws InputError, and Interrupted if asked to stop.
MadeFunction image_function(const GreyImage& image, const ImageOptions& options, const DataContext& context);

/// Reads a picture (core/data/image.hpp) through the context's files; `key` names the row in messages.
std::shared_ptr<const GreyImage> read_image(const std::string& file, const std::string& key,
                                            const DataContext& context);

/// The rows of the options, and the options of such rows; `invert_help` says what the row `invert` does.
std::vector<ParameterRow> image_rows(const Space& space, const std::string& invert_help);
ImageOptions image_options(const Values& values, const Space& space);

} // namespace gaspard

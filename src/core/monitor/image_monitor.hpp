// Monitors made of pictures:
//
//   m(x) = G_sigma * ( 1 + (C - 1) d ),      d = max( (1 - b)^gamma, floor )
//
// with the brightness b, 0 (black) to 1 (white), and the Gaussian blur G_sigma (function/image_function.hpp):
// the mesh is dense where the picture is dark, or bright if it is inverted. C is the contrast, the largest
// ratio of densities.
//
// sigma is at least one cell of the uniform mesh, and so large that the mesh can follow
// (monitor/grid_density.hpp).
#pragma once

#include "core/base/export.hpp"
#include "core/data/image.hpp"
#include "core/function/image_options.hpp"
#include "core/monitor/monitor.hpp"

#include <memory>
#include <string>

namespace gaspard GASPARD_API {

struct ImageMonitorOptions {
    ImageOptions image{}; ///< invert: dense where the picture is bright
    double contrast = 20;
};

/// The monitor of a picture that is in memory, on the domain of the context. Throws InputError, and
/// Interrupted if asked to stop.
std::shared_ptr<const Monitor> image_monitor(const GreyImage& image, const ImageMonitorOptions& options,
                                             const DataContext& context);
/// The same of a file, relative to the context's folder.
std::shared_ptr<const Monitor> image_monitor(const std::string& file, const ImageMonitorOptions& options,
                                             const DataContext& context);

} // namespace GASPARD_API

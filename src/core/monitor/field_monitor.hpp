// Monitors made of fields (function/field_function.hpp): with u the field, low and high its extremes on the
// domain,
//
//   scaled      m(x) = G_sigma * ( 1 + (C - 1) max(d, floor) ),   d = ((u - low) / (high - low))^gamma
//   values      m(x) = G_sigma * max(u, floor)
//
// where G_sigma is the Gaussian blur. The mesh is dense where u is large; inverted, where it is small.
#pragma once

#include "core/base/export.hpp"
#include "core/data/field_data.hpp"
#include "core/function/field_options.hpp"
#include "core/monitor/monitor.hpp"

#include <memory>
#include <string>

namespace gaspard GASPARD_API {

struct FieldMonitorOptions {
    FieldOptions
        field{};        ///< its blur is at least so much that the mesh can follow (monitor/grid_density.hpp)
    bool scaled = true; ///< false: the values of the field are the density
    double contrast = 20;
    bool invert = false;
    double gamma = 1;
    double floor = 0;
};

/// The monitor of a field that is in memory, on the domain of the context. Throws InputError, and Interrupted
/// if asked to stop.
std::shared_ptr<const Monitor> field_monitor(const FieldData& field, const FieldMonitorOptions& options,
                                             const DataContext& context);
/// The same of a file, relative to the context's folder.
std::shared_ptr<const Monitor> field_monitor(const std::string& file, const FieldRequest& request,
                                             const FieldMonitorOptions& options, const DataContext& context);

} // namespace GASPARD_API

// Gaspard as a library: meshes that move to where a monitor m(x) > 0 is large, by the Monge-Ampere equation.
//
// All that a simulation needs, in the order in which it needs it:
//
//   scenario/catalogue.hpp   the available domains, monitors and methods; scenarios: plain, checked values
//   scenario/toml.hpp        scenarios from built-in names and files
//   scenario/data_files.hpp  the files that a scenario refers to: their paths, or their content
//   monitor/function.hpp     a monitor from a function of your own
//   monitor/formula_monitor.hpp  a monitor from a formula, as text
//   monitor/field_monitor.hpp    a monitor from a field: a variable of a NetCDF, CSV or VTK file
//   monitor/image_monitor.hpp    a monitor from a picture
//   monitor/derived.hpp      a monitor from a function u, such as the solution of a PDE
//   monitor/combine.hpp      a monitor from several others
//   monitor/monitor.hpp      the class of monitors: many points per call, gradients
//   spline/spline_patch.hpp  a domain from a patch of your own; patch_file.hpp reads and writes them
//   session/run.hpp          a problem being solved; follow() and solve() move the mesh along
//   session/snapshot.hpp     the positions of the nodes, with fields and numbers
//   diagnostics/interpolation_error.hpp  why adapt: errors of a function on the uniform and the adapted mesh
//   session/interpolation_study.hpp  the same against the number of cells
//   io/run_files.hpp         meshes, history and state as files
//   io/history_file.hpp      the history, also as a file that has every time step of a long run
//   io/state_file.hpp        the unknowns, to continue later
//   mesh/surface_mesh.hpp    surface meshes read from OBJ, OFF, PLY and STL
//   mesh/surface_topology.hpp  edges, one-rings, boundary loops and orientation of a surface
//
// Coordinates are those of the domain (the unit square: 0 to 1 in x and y, z = 0; a sphere around the
// origin), in double precision; lengths have no unit. xi is the position of a node in the uniform mesh, x
// its adapted position. Errors are exceptions (base/error.hpp); how an iteration ends is a value (RunStatus).
// There is no global state: a run is used by one thread at a time, different runs by several threads.
#pragma once

#include "core/base/error.hpp"
#include "core/base/version.hpp"
#include "core/diagnostics/interpolation_error.hpp"
#include "core/io/formats.hpp"
#include "core/io/history_file.hpp"
#include "core/io/run_files.hpp"
#include "core/io/state_file.hpp"
#include "core/mesh/surface_mesh.hpp"
#include "core/mesh/surface_topology.hpp"
#include "core/monitor/field_monitor.hpp"
#include "core/monitor/combine.hpp"
#include "core/monitor/derived.hpp"
#include "core/monitor/formula_monitor.hpp"
#include "core/monitor/function.hpp"
#include "core/monitor/image_monitor.hpp"
#include "core/monitor/monitor.hpp"
#include "core/scenario/catalogue.hpp"
#include "core/scenario/data_files.hpp"
#include "core/scenario/toml.hpp"
#include "core/session/interpolation_study.hpp"
#include "core/session/run.hpp"
#include "core/session/snapshot.hpp"
#include "core/spline/patch_file.hpp"
#include "core/tessellate/check_view.hpp"

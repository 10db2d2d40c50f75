// The histories of runs as one table of comma-separated values, for a spreadsheet or a script.
#pragma once

#include "gui/document/document.hpp"

#include <string>
#include <vector>

namespace gaspard {

/// "run,iteration,seconds,residual,equidistribution,min_jacobian,max_jacobian,step_size,tangled_cells" and
/// the further series of the runs' methods, then a row per report of every run that is not hidden. Numbers
/// read back to the same doubles; empty where nothing was measured. A name with a comma or a quotation mark
/// is quoted (RFC 4180).
std::string runs_csv(const DocumentRuns& runs);

} // namespace gaspard

// Checks the header of a classic NetCDF file (CDF-1, CDF-2, CDF-5; "NetCDF Classic Format Specification")
// before the library reads it: the library allocates memory for whatever counts and lengths a damaged header
// has.
#pragma once

#include <string_view>

namespace gaspard {

/// Throws InputError if a list or a name has more entries than the file has bytes, a dimension does not
/// exist, or a variable begins beyond the end of the file.
void check_classic_netcdf(std::string_view bytes);

} // namespace gaspard

// HDF5 files can take data from other files of the machine: by links, external storage and virtual datasets.
#pragma once

#include <string_view>

namespace gaspard {

/// Throws InputError if an HDF5 file in memory refers to others, before these are opened. The caller holds
/// the lock of the NetCDF library.
void check_hdf5_is_complete(std::string_view bytes);

} // namespace gaspard

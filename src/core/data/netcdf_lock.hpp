// The NetCDF library is not thread-safe: its callers must hold this lock.
#pragma once

#include <mutex>

namespace gaspard {

std::mutex& netcdf_mutex();

} // namespace gaspard

// The NetCDF library is not thread-safe: whoever calls it holds this lock.
#pragma once

#include <mutex>

namespace gaspard {

std::mutex& netcdf_mutex();

} // namespace gaspard

// A NetCDF file as a value, and its bytes by the NetCDF library (classic format with 64-bit offsets, which
// every reader knows and which is the same bytes for the same content).
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace gaspard {

struct NetcdfAttribute {
    std::string name;
    std::variant<std::string, double, std::int32_t> value;
};

struct NetcdfVariable {
    std::string name;
    std::vector<std::string> dimensions; ///< by name; the last runs fastest; none: one value
    std::variant<std::vector<double>, std::vector<std::int32_t>> values;
    std::vector<NetcdfAttribute> attributes{};
};

struct NetcdfFile {
    std::vector<std::pair<std::string, std::size_t>> dimensions;
    std::vector<NetcdfVariable> variables{};
    std::vector<NetcdfAttribute> attributes{}; ///< of the file
};

/// Made in memory, so that it can be written like every other file. From any thread. Throws MachineError with
/// the library's own words.
std::string netcdf_bytes(const NetcdfFile& file);

} // namespace gaspard

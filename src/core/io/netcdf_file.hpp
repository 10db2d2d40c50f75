// A NetCDF file as plain data, encoded by the NetCDF library (classic format with 64-bit offsets, which all
// readers support and which is deterministic).
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
    std::vector<std::string> dimensions; ///< names, the last runs fastest; none for a scalar
    std::variant<std::vector<double>, std::vector<std::int32_t>, std::vector<float>> values;
    std::vector<NetcdfAttribute> attributes{};
};

struct NetcdfFile {
    std::vector<std::pair<std::string, std::size_t>> dimensions;
    std::vector<NetcdfVariable> variables{};
    std::vector<NetcdfAttribute> attributes{}; ///< global attributes
};

/// The bytes of the file. Thread-safe. Throws MachineError with the library's message on failure.
std::string netcdf_bytes(const NetcdfFile& file);

} // namespace gaspard

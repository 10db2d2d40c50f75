// Reads NetCDF files in memory through the NetCDF library, with its errors as sentences, and unpacks values.
#pragma once

#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

struct NetcdfInputDimension {
    int id = 0;
    std::string name;
    std::size_t length = 0;
};

struct NetcdfInputVariable {
    int id = 0;
    std::string name;
    int type = 0;                ///< NC_DOUBLE and so on
    std::vector<int> dimensions; ///< indices into NetcdfInput::dimensions; the last runs fastest
};

/// One file; holds the lock of the library while it lives. All functions throw InputError.
class NetcdfInput {
  public:
    explicit NetcdfInput(std::string_view bytes);
    ~NetcdfInput();
    NetcdfInput(const NetcdfInput&) = delete;
    NetcdfInput& operator=(const NetcdfInput&) = delete;

    const std::vector<NetcdfInputDimension>& dimensions() const { return dimensions_; }
    /// Variables of numbers only.
    const std::vector<NetcdfInputVariable>& variables() const { return variables_; }
    /// The names of the groups in the file, whose variables are not read.
    std::vector<std::string> groups() const;
    /// Null if there is none.
    const NetcdfInputVariable* find(std::string_view name) const;
    std::size_t length(const NetcdfInputVariable& variable, std::size_t dimension) const;

    /// A text attribute; empty if there is none.
    std::string text(const NetcdfInputVariable& variable, const char* attribute) const;
    /// A numeric attribute; empty if there is none.
    std::vector<double> numbers(const NetcdfInputVariable& variable, const char* attribute) const;
    /// The values from `start`, `count` along each dimension, in the order of the file. Unpacked: v =
    /// scale_factor * stored + add_offset; NaN where the stored number is _FillValue (or the fill value of
    /// its type), missing_value or outside of valid_range. Refuses more values than largest_field.
    std::vector<double> values(const NetcdfInputVariable& variable, const std::vector<std::size_t>& start,
                               const std::vector<std::size_t>& count) const;
    std::vector<double> values(const NetcdfInputVariable& variable) const; ///< all of them

  private:
    void read_dimensions();
    void read_variables();

    std::scoped_lock<std::mutex> lock_;
    std::string bytes_;
    int id_ = -1;
    std::vector<NetcdfInputDimension> dimensions_;
    std::vector<NetcdfInputVariable> variables_;
};

} // namespace gaspard

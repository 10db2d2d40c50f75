#include "core/data/netcdf_input.hpp"

#include "core/base/error.hpp"
#include "core/data/field_data.hpp"
#include "core/data/hdf5_links.hpp"
#include "core/data/netcdf_header.hpp"
#include "core/data/netcdf_lock.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <netcdf.h>
#include <netcdf_mem.h>

namespace gaspard {

namespace {

constexpr std::size_t most_variables = 10'000; // and dimensions
constexpr std::size_t longest_attribute = 1 << 16;
constexpr std::size_t largest_chunk = std::size_t{256} << 20; ///< bytes, which the library unpacks at once

void demand(int status) {
    if (status == NC_NOERR) return;
    if (status == NC_ENOMEM) throw InputError("it is damaged, or too large for the memory of this machine");
    if (status == NC_EFILTER || status == NC_ENOFILTER)
        throw InputError("it is compressed in a way that the NetCDF library of this machine cannot read");
    throw InputError("it is damaged, or not a NetCDF file");
}

bool is_number(int type) { return type == NC_BYTE || (type >= NC_SHORT && type <= NC_UINT64); }

/// What the library writes where no value was written; bytes have none.
std::optional<double> fill_of(int type) {
    switch (type) {
    case NC_SHORT:
        return NC_FILL_SHORT;
    case NC_INT:
        return NC_FILL_INT;
    case NC_FLOAT:
        return double{NC_FILL_FLOAT};
    case NC_DOUBLE:
        return NC_FILL_DOUBLE;
    case NC_USHORT:
        return NC_FILL_USHORT;
    case NC_UINT:
        return NC_FILL_UINT;
    case NC_INT64:
        return static_cast<double>(NC_FILL_INT64);
    case NC_UINT64:
        return static_cast<double>(NC_FILL_UINT64);
    default:
        return std::nullopt;
    }
}

/// Signed integers of the file that stand for unsigned ones have their negative numbers 2^bits too low.
double unsigned_shift(int type) {
    return type == NC_BYTE ? 256.0 : type == NC_SHORT ? 65536.0 : type == NC_INT ? 4294967296.0 : 0;
}

/// Which stored numbers are values, and what they stand for.
struct Packing {
    std::vector<double> missing{};
    double low = -std::numeric_limits<double>::infinity(), high = -low;
    double scale = 1, offset = 0, shift = 0;

    double stored(double number) const { return number < 0 ? number + shift : number; }
    double unpack(double number) const {
        const double raw = stored(number);
        const bool absent = !std::isfinite(raw) || raw < low || raw > high ||
                            std::find(missing.begin(), missing.end(), raw) != missing.end();
        return absent ? std::numeric_limits<double>::quiet_NaN() : scale * raw + offset;
    }
};

Packing packing_of(const NetcdfInput& file, const NetcdfInputVariable& variable) {
    Packing packing;
    if (file.text(variable, "_Unsigned") == "true") packing.shift = unsigned_shift(variable.type);
    const auto first = [&](const char* name, double otherwise) {
        const auto all = file.numbers(variable, name);
        return all.empty() ? otherwise : all[0];
    };
    const auto fill = file.numbers(variable, "_FillValue");
    if (!fill.empty())
        packing.missing.push_back(packing.stored(fill[0]));
    else if (const auto usual = fill_of(variable.type))
        packing.missing.push_back(packing.stored(*usual));
    for (const double one : file.numbers(variable, "missing_value"))
        packing.missing.push_back(packing.stored(one));
    const auto range = file.numbers(variable, "valid_range");
    packing.low = range.size() == 2 ? packing.stored(range[0]) : packing.low;
    packing.high = range.size() == 2 ? packing.stored(range[1]) : packing.high;
    if (range.size() != 2) {
        const double low = first("valid_min", packing.low), high = first("valid_max", packing.high);
        packing.low = std::isfinite(low) ? packing.stored(low) : packing.low;
        packing.high = std::isfinite(high) ? packing.stored(high) : packing.high;
    }
    if (variable.type == NC_FLOAT) // a missing_value of another type
        for (double& one : packing.missing) one = static_cast<double>(static_cast<float>(one));
    packing.scale = first("scale_factor", 1), packing.offset = first("add_offset", 0);
    if (!std::isfinite(packing.scale) || !std::isfinite(packing.offset))
        throw InputError("scale_factor or add_offset of '" + variable.name + "' is not finite");
    if (packing.scale == 0) throw InputError("scale_factor of '" + variable.name + "' is zero");
    return packing;
}

/// The number of values; of a file without compression no more than it has bytes.
std::size_t product(const NetcdfInputVariable& variable, const std::vector<std::size_t>& count,
                    std::string_view file) {
    std::size_t size = 1;
    for (const std::size_t one : count) {
        if (one > 0 && size > largest_field / one)
            throw InputError("'" + variable.name + "' has more than " + std::to_string(largest_field) +
                             " values");
        size *= one;
    }
    if (file.starts_with("CDF") && size > file.size())
        throw InputError("it is damaged: '" + variable.name + "' has more values than the file has bytes");
    return size;
}

/// Before the library unpacks a whole chunk for a few values of it.
void check_chunks(int file, const NetcdfInputVariable& variable) {
    int storage = NC_CONTIGUOUS;
    std::vector<std::size_t> chunk(std::max<std::size_t>(1, variable.dimensions.size()));
    if (nc_inq_var_chunking(file, variable.id, &storage, chunk.data()) != NC_NOERR || storage != NC_CHUNKED)
        return;
    std::size_t bytes = sizeof(double);
    for (const std::size_t one : chunk) {
        if (one > 0 && bytes > largest_chunk / one)
            throw InputError("'" + variable.name + "' is stored in chunks of more than 256 MiB");
        bytes *= one;
    }
}

} // namespace

std::mutex& netcdf_mutex() {
    static std::mutex mutex;
    return mutex;
}

NetcdfInput::NetcdfInput(std::string_view bytes) : lock_(netcdf_mutex()), bytes_(bytes) {
    if (bytes.starts_with("CDF"))
        check_classic_netcdf(bytes);
    else
        check_hdf5_is_complete(bytes);
    const int status = nc_open_mem("gaspard.nc", NC_NOWRITE, bytes_.size(), bytes_.data(), &id_);
    if (status != NC_NOERR) id_ = -1;
    demand(status);
    try {
        read_dimensions();
        read_variables();
    } catch (...) {
        nc_close(id_);
        throw;
    }
}

NetcdfInput::~NetcdfInput() { nc_close(id_); }

void NetcdfInput::read_dimensions() {
    int count = 0;
    demand(nc_inq_dimids(id_, &count, nullptr, 0));
    if (count < 0 || static_cast<std::size_t>(count) > most_variables)
        throw InputError("it has more than " + std::to_string(most_variables) + " dimensions");
    std::vector<int> ids(static_cast<std::size_t>(count));
    demand(nc_inq_dimids(id_, &count, ids.data(), 0));
    for (const int id : ids) {
        char name[NC_MAX_NAME + 1] = {};
        std::size_t length = 0;
        demand(nc_inq_dim(id_, id, name, &length));
        dimensions_.push_back({id, name, length});
    }
}

void NetcdfInput::read_variables() {
    int count = 0;
    demand(nc_inq_nvars(id_, &count));
    if (count < 0 || static_cast<std::size_t>(count) > most_variables)
        throw InputError("it has more than " + std::to_string(most_variables) + " variables");
    for (int id = 0; id < count; ++id) {
        char name[NC_MAX_NAME + 1] = {};
        int type = 0, rank = 0;
        demand(nc_inq_var(id_, id, name, &type, &rank, nullptr, nullptr));
        if (!is_number(type) || rank < 0 || rank > NC_MAX_VAR_DIMS) continue;
        std::vector<int> ids(static_cast<std::size_t>(rank));
        demand(nc_inq_vardimid(id_, id, ids.data()));
        NetcdfInputVariable variable{id, name, type, {}};
        for (const int dimension : ids) {
            const auto found = std::find_if(dimensions_.begin(), dimensions_.end(),
                                            [&](const auto& one) { return one.id == dimension; });
            if (found == dimensions_.end())
                throw InputError("'" + variable.name + "' has an unknown dimension");
            variable.dimensions.push_back(static_cast<int>(found - dimensions_.begin()));
        }
        variables_.push_back(std::move(variable));
    }
}

std::vector<std::string> NetcdfInput::groups() const {
    int count = 0;
    demand(nc_inq_grps(id_, &count, nullptr));
    std::vector<int> ids(static_cast<std::size_t>(std::max(count, 0)));
    if (!ids.empty()) demand(nc_inq_grps(id_, &count, ids.data()));
    std::vector<std::string> names;
    for (const int id : ids) {
        char name[NC_MAX_NAME + 1] = {};
        demand(nc_inq_grpname(id, name));
        names.emplace_back(name);
    }
    return names;
}

const NetcdfInputVariable* NetcdfInput::find(std::string_view name) const {
    for (const auto& variable : variables_)
        if (variable.name == name) return &variable;
    return nullptr;
}

std::size_t NetcdfInput::length(const NetcdfInputVariable& variable, std::size_t dimension) const {
    return dimensions_[static_cast<std::size_t>(variable.dimensions[dimension])].length;
}

std::string NetcdfInput::text(const NetcdfInputVariable& variable, const char* attribute) const {
    int type = 0;
    std::size_t length = 0;
    if (nc_inq_att(id_, variable.id, attribute, &type, &length) != NC_NOERR || length == 0) return {};
    if (length > longest_attribute) throw InputError("an attribute of '" + variable.name + "' is too long");
    if (type == NC_STRING) {
        std::vector<char*> texts(length, nullptr);
        demand(nc_get_att_string(id_, variable.id, attribute, texts.data()));
        const std::string first = texts[0] == nullptr ? "" : texts[0];
        nc_free_string(length, texts.data());
        return first;
    }
    if (type != NC_CHAR) return {};
    std::string text(length, '\0');
    demand(nc_get_att_text(id_, variable.id, attribute, text.data()));
    return text.substr(0, text.find('\0'));
}

std::vector<double> NetcdfInput::numbers(const NetcdfInputVariable& variable, const char* attribute) const {
    int type = 0;
    std::size_t length = 0;
    if (nc_inq_att(id_, variable.id, attribute, &type, &length) != NC_NOERR || !is_number(type)) return {};
    if (length > longest_attribute) throw InputError("an attribute of '" + variable.name + "' is too long");
    std::vector<double> all(length);
    if (length > 0) demand(nc_get_att_double(id_, variable.id, attribute, all.data()));
    return all;
}

std::vector<double> NetcdfInput::values(const NetcdfInputVariable& variable,
                                        const std::vector<std::size_t>& start,
                                        const std::vector<std::size_t>& count) const {
    const std::size_t size = product(variable, count, bytes_);
    if (!bytes_.starts_with("CDF")) check_chunks(id_, variable);
    std::vector<double> all(size);
    if (size > 0) demand(nc_get_vara_double(id_, variable.id, start.data(), count.data(), all.data()));
    const Packing packing = packing_of(*this, variable);
    for (double& one : all) one = packing.unpack(one);
    return all;
}

std::vector<double> NetcdfInput::values(const NetcdfInputVariable& variable) const {
    std::vector<std::size_t> count;
    for (std::size_t d = 0; d < variable.dimensions.size(); ++d) count.push_back(length(variable, d));
    return values(variable, std::vector<std::size_t>(count.size(), 0), count);
}

} // namespace gaspard

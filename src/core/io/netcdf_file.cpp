#include "core/io/netcdf_file.hpp"

#include "core/base/check.hpp"
#include "core/base/error.hpp"
#include "core/data/netcdf_lock.hpp"

#include <cstdlib>
#include <map>
#include <memory>
#include <mutex>
#include <netcdf.h>
#include <netcdf_mem.h>

namespace gaspard {

namespace {

void demand(int status) {
    if (status != NC_NOERR)
        throw MachineError(std::string("cannot create a NetCDF file: ") + nc_strerror(status));
}

/// A NetCDF file in memory, discarded unless its bytes are taken.
class OpenFile {
  public:
    OpenFile() { demand(nc_create_mem("gaspard", NC_64BIT_OFFSET, 0, &id_)); }
    ~OpenFile() {
        if (id_ >= 0) nc_abort(id_);
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    int id() const { return id_; }

    std::string take_bytes() {
        NC_memio memory{};
        const int status = nc_close_memio(id_, &memory);
        id_ = -1;
        const std::unique_ptr<void, decltype(&std::free)> owner(memory.memory, &std::free);
        demand(status);
        return {static_cast<const char*>(memory.memory), memory.size};
    }

  private:
    int id_ = -1;
};

void put(int file, int variable, const NetcdfAttribute& attribute) {
    const char* name = attribute.name.c_str();
    if (const auto* text = std::get_if<std::string>(&attribute.value))
        demand(nc_put_att_text(file, variable, name, text->size(), text->data()));
    else if (const auto* real = std::get_if<double>(&attribute.value))
        demand(nc_put_att_double(file, variable, name, NC_DOUBLE, 1, real));
    else
        demand(nc_put_att_int(file, variable, name, NC_INT, 1, &std::get<std::int32_t>(attribute.value)));
}

int define(int file, const NetcdfVariable& variable, const std::map<std::string, int>& dimensions) {
    std::vector<int> of_variable;
    for (const auto& name : variable.dimensions) of_variable.push_back(dimensions.at(name));
    const nc_type types[] = {NC_DOUBLE, NC_INT, NC_FLOAT}; // in the order of the variant
    int id = 0;
    demand(nc_def_var(file, variable.name.c_str(), types[variable.values.index()],
                      static_cast<int>(of_variable.size()), of_variable.data(), &id));
    for (const auto& attribute : variable.attributes) put(file, id, attribute);
    return id;
}

std::size_t size_of(const NetcdfFile& file, const NetcdfVariable& variable) {
    std::size_t size = 1;
    for (const auto& name : variable.dimensions)
        for (const auto& dimension : file.dimensions)
            if (dimension.first == name) size *= dimension.second;
    return size;
}

void put_values(int file, int id, const NetcdfVariable& variable, std::size_t size) {
    std::visit([&](const auto& values) { GASPARD_CHECK(values.size() == size); }, variable.values);
    if (const auto* reals = std::get_if<std::vector<double>>(&variable.values))
        demand(nc_put_var_double(file, id, reals->data()));
    else if (const auto* floats = std::get_if<std::vector<float>>(&variable.values))
        demand(nc_put_var_float(file, id, floats->data()));
    else
        demand(nc_put_var_int(file, id, std::get<std::vector<std::int32_t>>(variable.values).data()));
}

} // namespace

std::string netcdf_bytes(const NetcdfFile& file) {
    const std::lock_guard lock(netcdf_mutex());
    OpenFile open;
    std::map<std::string, int> dimensions;
    for (const auto& [name, size] : file.dimensions) {
        GASPARD_CHECK(size > 0); // 0 would mean an unlimited dimension
        demand(nc_def_dim(open.id(), name.c_str(), size, &dimensions[name]));
    }
    for (const auto& attribute : file.attributes) put(open.id(), NC_GLOBAL, attribute);
    std::vector<int> ids;
    for (const auto& variable : file.variables) ids.push_back(define(open.id(), variable, dimensions));
    int before = 0;
    demand(nc_set_fill(open.id(), NC_NOFILL, &before)); // every value is written
    demand(nc_enddef(open.id()));
    for (std::size_t i = 0; i < ids.size(); ++i)
        put_values(open.id(), ids[i], file.variables[i], size_of(file, file.variables[i]));
    return open.take_bytes();
}

} // namespace gaspard

#include "core/data/hdf5_links.hpp"

#include "core/base/error.hpp"

#include <hdf5.h>
#include <string>

namespace gaspard {

namespace {

/// An object of the library, closed at the end.
class Handle {
  public:
    Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
    ~Handle() {
        if (id_ >= 0) close_(id_);
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    hid_t id() const { return id_; }
    bool valid() const { return id_ >= 0; }

  private:
    hid_t id_;
    herr_t (*close_)(hid_t);
};

/// The library prints its errors otherwise.
class Quiet {
  public:
    Quiet() {
        H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
        H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    }
    ~Quiet() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }
    Quiet(const Quiet&) = delete;
    Quiet& operator=(const Quiet&) = delete;

  private:
    H5E_auto2_t function_ = nullptr;
    void* data_ = nullptr;
};

/// How the storage of an object refers to other files; empty if it does not.
std::string storage_elsewhere(hid_t object) {
    if (H5Iget_type(object) != H5I_DATASET) return {};
    const Handle list(H5Dget_create_plist(object), &H5Pclose);
    if (!list.valid()) return "has a storage that is not known";
    if (H5Pget_layout(list.id()) == H5D_VIRTUAL) return "is a virtual dataset";
    return H5Pget_external_count(list.id()) != 0 ? "is stored in another file" : "";
}

struct Finding {
    std::string name, what; ///< `what` is empty if nothing was found
};

/// Called by C code, which exceptions must not cross.
template <class Info>
herr_t visit(hid_t group, const char* name, const Info* link, void* data) noexcept {
    Finding& found = *static_cast<Finding*>(data);
    if (link->type == H5L_TYPE_SOFT) return 0; // to a place in this file, which is visited
    if (link->type != H5L_TYPE_HARD) {
        found = {name, "is a link to another file"};
        return 1;
    }
    const Handle object(H5Oopen(group, name, H5P_DEFAULT), &H5Oclose);
    if (!object.valid()) return 0; // damaged
    found = {name, storage_elsewhere(object.id())};
    return found.what.empty() ? 0 : 1;
}

} // namespace

void check_hdf5_is_complete(std::string_view bytes) {
    H5open();
    const Quiet quiet;
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), &H5Pclose);
    std::string image(bytes); // which the library does not take as constant
    constexpr std::size_t increment = 1 << 16;
    const bool ready = access.valid() && H5Pset_fapl_core(access.id(), increment, 0) >= 0 &&
                       H5Pset_file_image(access.id(), image.data(), image.size()) >= 0;
    const Handle file(ready ? H5Fopen("gaspard.nc", H5F_ACC_RDONLY, access.id()) : hid_t{-1}, &H5Fclose);
    Finding found;
    const bool visited =
        file.valid() && H5Lvisit(file.id(), H5_INDEX_NAME, H5_ITER_NATIVE, &visit<H5L_info_t>, &found) >= 0;
    if (!visited) throw InputError("it is damaged, or not a NetCDF file");
    if (!found.what.empty())
        throw InputError("'" + found.name.substr(0, 100) + "' " + found.what +
                         "; only files that are complete in themselves are read");
}

} // namespace gaspard

// A type of domain as the user sees it: its name, its parameter rows, and how distances are measured on it.
#pragma once

#include "core/base/export.hpp"
#include "core/base/parameter.hpp"
#include "core/mesh/space.hpp"
#include "core/mesh/sphere_mesh.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace gaspard GASPARD_API {

struct DomainType {
    std::string name;
    std::string label;
    std::string help;
    std::vector<ParameterRow> rows;
    std::function<Space(const Values&)> space;
    /// The same for a domain that lies where its file says; `folder` is the base of relative paths. Does not
    /// throw: if the file is invalid, which the run reports, the ranges of monitors are as wide as possible.
    std::function<Space(const Values&, const std::filesystem::path& folder)> find_space{};
    /// True if its meshes are images of a spline patch, so that spline formats can be written.
    bool spline_patch = false;
};

/// The unit square: doubly periodic, or with straight sides along which boundary nodes slide.
DomainType plane_domain();

/// The sphere, divided into quadrilaterals or into triangles.
DomainType cubed_sphere_domain();
DomainType icosahedral_sphere_domain();
/// The mesh for the parameter values of these domains.
SphereGrid cubed_sphere_grid(const Values& values);
SphereGrid icosahedral_sphere_grid(const Values& values);

} // namespace GASPARD_API

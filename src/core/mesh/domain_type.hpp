// A type of domain as the user sees it: its name, its parameter rows, and how distances are measured on it.
#pragma once

#include "core/base/export.hpp"
#include "core/base/parameter.hpp"
#include "core/mesh/space.hpp"
#include "core/mesh/sphere_mesh.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace gaspard GASPARD_API {

/// What a type of domain has read from files; only the type knows what it is.
using DomainContent = std::shared_ptr<const void>;

struct DomainType {
    std::string name;
    std::string label;
    std::string help;
    std::vector<ParameterRow> rows;
    /// Further rows that depend on the values of `rows`, which have the role defines_rows
    /// (base/growing_values.hpp); empty: none.
    std::function<std::vector<ParameterRow>(const Values&)> further_rows{};
    /// `content`: what `read` has returned for these values; null if the type has no `read` or the file is
    /// not read yet. Does not throw: if the file is invalid, which the run reports, the ranges of monitors
    /// are as wide as possible.
    std::function<Space(const Values&, const DomainContent& content)> space;
    /// Of transport between two domains: the source, where `space` is the target; empty: they are the same.
    std::function<Space(const Values&, const DomainContent& content)> source_space{};
    /// Reads the files of a domain that lies where they say (rows with the role `file`), relative to
    /// `folder`. Does not throw: errors are part of the content, and `Capability::prepare` throws them.
    std::function<DomainContent(const Values&, const std::filesystem::path& folder)> read{};
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

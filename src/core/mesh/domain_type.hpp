// A kind of domain as the user sees it: a name, its parameter rows, and what its points know of distance.
#pragma once

#include "core/base/parameter.hpp"
#include "core/mesh/space.hpp"
#include "core/mesh/sphere_mesh.hpp"

#include <functional>
#include <string>
#include <vector>

namespace gaspard {

struct DomainType {
    std::string name;
    std::string label;
    std::string help;
    std::vector<ParameterRow> rows;
    std::function<Space(const Values&)> space;
    /// Its meshes are images of a spline patch, so that formats of splines can be written.
    bool spline_patch = false;
};

/// The unit square: doubly periodic, or with walls along which nodes slide.
DomainType plane_domain();

/// The sphere, of quadrilaterals or of triangles.
DomainType cubed_sphere_domain();
DomainType icosahedral_sphere_domain();
/// The mesh that the values of one of these stand for.
SphereGrid cubed_sphere_grid(const Values& values);
SphereGrid icosahedral_sphere_grid(const Values& values);

} // namespace gaspard

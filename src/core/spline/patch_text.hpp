// Patches in text files of other programs: MFEM's NURBS meshes and GeoPDEs' geometries.
#pragma once

#include "core/spline/patch_choice.hpp"

namespace gaspard {

/// "MFEM NURBS mesh v1.0" or v1.1 with a section `patches`, in two dimensions. Meshes with `weights` and a
/// finite element space, which number their control points across patches, are refused.
FoundPatch read_mfem(const PatchText& file);

/// "# nurbs mesh v.0.7" (or .6) and "v.2.1", as written by the NURBS toolbox for GeoPDEs: all x, then all y
/// (z) of the homogeneous control points, then the weights.
FoundPatch read_geopdes(const PatchText& file);

} // namespace gaspard

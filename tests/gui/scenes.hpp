// Meshes to draw: made up, the same on every machine.
#pragma once

#include "core/base/parameter.hpp"
#include "core/io/image.hpp"
#include "core/session/snapshot.hpp"
#include "gui/gl/offscreen.hpp"

#include <string>
#include <vector>

namespace gaspard {

/// n x n squares drawn towards a circle, on which the field "monitor" is large.
Snapshot ring_snapshot(int n);
/// The same with one node pulled across its neighbours: one cell is tangled.
Snapshot tangled_snapshot(int n);
/// Six times n x n curved squares on the unit sphere.
Snapshot sphere_snapshot(int n);
/// n x n x n cubes, sheared.
Snapshot cube_snapshot(int n);
/// n x n x n curved cells of order 2: a quarter of a thick ring, twisted.
Snapshot bent_snapshot(int n);
/// n lines in [0, 1], finer towards 0.
Snapshot interval_snapshot(int n);

/// n cells in [0, 1], half of them in a layer of this width at both ends, with a solution there and on the
/// uniform mesh.
Snapshot layer_snapshot(int n, double width);

/// n x n squares of two triangles each, half of them in layers of this width at x = 1 and at y = 1, with a
/// solution that is up to 0.9 high between them.
Snapshot corner_layer_snapshot(int n, double width);

/// A view with everything else as by default.
Values view(const std::string& colour, double blend = 1);

/// A picture that is compared with tests/goldens/NAME.png.
struct Scene {
    std::string name;
    Image (*draw)(OffscreenBackend backend);
};
const std::vector<Scene>& scenes();

} // namespace gaspard

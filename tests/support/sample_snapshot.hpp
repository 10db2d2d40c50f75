// A snapshot with a nodal field and a cell field, for tests of file writers.
#pragma once

#include "core/session/snapshot.hpp"
#include "support/small_meshes.hpp"

#include <cmath>
#include <memory>
#include <utility>

namespace gaspard {

inline Snapshot sample_snapshot(Mesh mesh) {
    Snapshot snapshot;
    snapshot.mesh = std::make_shared<const Mesh>(std::move(mesh));
    snapshot.x = moved(*snapshot.mesh);
    Field monitor{{.name = "monitor"}, {}}, jacobian{{.name = "jacobian", .place = FieldPlace::cell}, {}};
    for (std::size_t i = 0; i < snapshot.x.size(); ++i)
        monitor.values.push_back(2 + std::sin(5 * snapshot.x.x[i] + snapshot.x.y[i]));
    for (std::size_t c = 0; c < snapshot.mesh->cell_count(); ++c)
        jacobian.values.push_back(1 + 0.1 * static_cast<double>(c));
    snapshot.fields = {monitor, jacobian};
    snapshot.report.iteration = 17;
    snapshot.report.residual = 1.0 / 3;
    snapshot.report.tangled_cells = 2;
    return snapshot;
}

/// A name for a test's parameter: "quadrilateral2".
inline std::string kind_name(const CellKind& kind) {
    const std::string name = cell_name(kind);
    return name.substr(0, name.find(',')) + std::to_string(kind.order);
}

} // namespace gaspard

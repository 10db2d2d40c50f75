#include "gui/mesh_picture.hpp"

#include "core/base/check.hpp"

namespace gaspard {

namespace {

/// Cells with a Jacobian of zero or less, where the snapshot has measured it.
std::shared_ptr<const std::vector<std::uint32_t>> tangled_cells(const Snapshot& snapshot) {
    const Field* jacobian = snapshot.field("jacobian");
    if (jacobian == nullptr) return nullptr;
    std::vector<std::uint32_t> cells;
    for (std::size_t i = 0; i < jacobian->values.size(); ++i)
        if (!(jacobian->values[i] > 0)) cells.push_back(static_cast<std::uint32_t>(i));
    if (cells.empty()) return nullptr;
    return std::make_shared<const std::vector<std::uint32_t>>(std::move(cells));
}

} // namespace

MeshPicture PictureMaker::make(const Snapshot& snapshot, std::string_view colour, double blend) {
    GASPARD_CHECK(snapshot.mesh != nullptr);
    const bool new_mesh = mesh_ != snapshot.mesh;
    if (new_mesh) {
        mesh_ = snapshot.mesh;
        tessellation_ = std::make_shared<const Tessellation>(tessellate(*mesh_));
        computational_ = std::make_shared<const Points>(shown_points(*tessellation_, mesh_->nodes));
        computational_box_ = bounding_box(*computational_);
        last_ = {};
    }
    const bool new_positions = new_mesh || snapshot.version != last_version_;
    if (new_positions) {
        last_.tessellation = tessellation_;
        last_.cell_dimension = cell_dimension(mesh_->kind);
        last_.computational = computational_;
        last_.physical = std::make_shared<const Points>(shown_points(*tessellation_, snapshot.x));
        last_.tangled = tangled_cells(snapshot);
        last_.box = merge(computational_box_, bounding_box(*last_.physical));
        last_version_ = snapshot.version;
    }
    if (new_positions || last_.scalar_name != colour) {
        const Field* field = snapshot.field(colour);
        const bool shown = field != nullptr && field->place == FieldPlace::node;
        last_.scalar_name = shown ? colour : "";
        last_.scalar = nullptr;
        if (shown) {
            last_.scalar =
                std::make_shared<const std::vector<double>>(shown_values(*tessellation_, field->values));
            last_.range = range_of(*last_.scalar);
        }
    }
    last_.blend = blend;
    return last_;
}

} // namespace gaspard

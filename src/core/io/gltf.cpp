// adapted.glb: one node with one mesh; faces and edges are two primitives with shared vertices.
#include "core/base/box.hpp"
#include "core/base/check.hpp"
#include "core/base/version.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/formats.hpp"
#include "core/tessellate/colour_map.hpp"
#include "core/tessellate/colouring.hpp"
#include "core/tessellate/tessellation.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <tiny_gltf.h>

namespace gaspard {

namespace {

/// Three numbers per vertex.
using Triples = std::vector<float>;

/// The largest number of a file; nodes of a mesh that diverged end there.
constexpr double single_most = static_cast<double>(std::numeric_limits<float>::max());

/// The origin of the positions in the file, which the node's translation adds again: the middle of the mesh,
/// x and xi, if it is so far from the origin that single precision would round its shape, else zero.
Vec3 local_origin(const Points& x, const Points& xi) {
    constexpr double far = 4; // sizes of the mesh
    const Box box = merge(bounding_box(x), bounding_box(xi));
    double farthest = 0;
    for (const Vec3 corner : {box.low, box.high})
        farthest = std::max({farthest, std::abs(corner.x), std::abs(corner.y), std::abs(corner.z)});
    const bool beyond = farthest > single_most; // a mesh that diverged: there is no shape to keep
    return !beyond && farthest > far * longest_side(box) ? box.low + 0.5 * (box.high - box.low) : Vec3{};
}

Points relative_to(Vec3 origin, Points points) {
    for (std::size_t i = 0; i < points.size(); ++i) points.set(i, points[i] - origin);
    return points;
}

Triples single_precision(const Points& points) {
    Triples triples;
    triples.reserve(3 * points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        for (const double value : {points.x[i], points.y[i], points.z[i]}) {
            GASPARD_CHECK(std::isfinite(value));
            triples.push_back(static_cast<float>(std::clamp(value, -single_most, single_most)));
        }
    return triples;
}

/// Colour maps are in sRGB; glTF vertex colours are linear.
float linear_light(unsigned char srgb) {
    const double s = srgb / 255.0;
    return static_cast<float>(s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
}

Triples colours_of(const std::vector<double>& values, const ColourRange& range) {
    const ColourMap& map = colour_maps().front();
    Triples triples;
    triples.reserve(3 * values.size());
    for (const double value : values)
        for (const unsigned char channel : colour_at(map, range.position(value)))
            triples.push_back(linear_light(channel));
    return triples;
}

constexpr float dark_grey = 0.01f, light_grey = 0.5f; // linear

/// Line colours with a contrast ratio of at least 3 to the given face colours.
Triples ink_on(const Triples& faces) {
    Triples triples;
    triples.reserve(faces.size());
    for (std::size_t i = 0; i < faces.size(); i += 3) {
        const float luminance = 0.2126f * faces[i] + 0.7152f * faces[i + 1] + 0.0722f * faces[i + 2];
        triples.insert(triples.end(), 3, luminance < 0.13f ? light_grey : dark_grey);
    }
    return triples;
}

/// Appends arrays to the model's only buffer; each function returns the index of the new accessor.
class Packer {
  public:
    explicit Packer(tinygltf::Model& model) : model_(model) { model_.buffers.resize(1); }

    int positions(const Triples& triples) {
        const int number = vertices(triples);
        auto& accessor = model_.accessors.back();
        accessor.minValues.assign(3, std::numeric_limits<double>::infinity());
        accessor.maxValues.assign(3, -std::numeric_limits<double>::infinity());
        for (std::size_t i = 0; i < triples.size(); ++i) {
            const double value = static_cast<double>(triples[i]);
            accessor.minValues[i % 3] = std::min(accessor.minValues[i % 3], value);
            accessor.maxValues[i % 3] = std::max(accessor.maxValues[i % 3], value);
        }
        return number;
    }

    int vertices(const Triples& triples) {
        return add(triples, TINYGLTF_TYPE_VEC3, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TARGET_ARRAY_BUFFER);
    }

    /// 16-bit indices if possible; glTF reserves the largest value of either type.
    int indices(const std::vector<std::uint32_t>& numbers, std::size_t vertex_count) {
        const int target = TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER;
        if (vertex_count > std::numeric_limits<std::uint16_t>::max())
            return add(numbers, TINYGLTF_TYPE_SCALAR, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, target);
        std::vector<std::uint16_t> small;
        small.reserve(numbers.size());
        for (const auto number : numbers) small.push_back(static_cast<std::uint16_t>(number));
        return add(small, TINYGLTF_TYPE_SCALAR, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, target);
    }

    int times(const std::vector<float>& seconds) {
        const int number = weights(seconds);
        model_.accessors.back().minValues = {static_cast<double>(seconds.front())};
        model_.accessors.back().maxValues = {static_cast<double>(seconds.back())};
        return number;
    }

    int weights(const std::vector<float>& values) {
        return add(values, TINYGLTF_TYPE_SCALAR, TINYGLTF_COMPONENT_TYPE_FLOAT, 0);
    }

  private:
    template <class T>
    int add(const std::vector<T>& values, int type, int component, int target) {
        auto& bytes = model_.buffers[0].data;
        tinygltf::BufferView view;
        view.buffer = 0;
        view.byteOffset = bytes.size();
        view.byteLength = values.size() * sizeof(T);
        view.target = target;
        bytes.resize((view.byteOffset + view.byteLength + 3) / 4 * 4); // align arrays to 4 bytes
        std::memcpy(bytes.data() + view.byteOffset, values.data(), view.byteLength);
        model_.bufferViews.push_back(view);

        tinygltf::Accessor accessor;
        accessor.bufferView = static_cast<int>(model_.bufferViews.size()) - 1;
        accessor.componentType = component;
        accessor.type = type;
        accessor.count = values.size() / (type == TINYGLTF_TYPE_VEC3 ? 3 : 1);
        model_.accessors.push_back(accessor);
        return static_cast<int>(model_.accessors.size()) - 1;
    }

    tinygltf::Model& model_;
};

int add_material(tinygltf::Model& model, const std::string& name, std::vector<double> colour, bool lit) {
    tinygltf::Material material;
    material.name = name;
    material.doubleSided = true;
    material.pbrMetallicRoughness.baseColorFactor = std::move(colour);
    material.pbrMetallicRoughness.metallicFactor = 0;
    if (!lit) {
        const std::string unlit = "KHR_materials_unlit";
        material.extensions[unlit] = tinygltf::Value(tinygltf::Value::Object());
        if (model.extensionsUsed.empty()) model.extensionsUsed.push_back(unlit);
    }
    model.materials.push_back(material);
    return static_cast<int>(model.materials.size()) - 1;
}

/// What a shape looks like and how it moves: base + sum of weights times targets.
struct MovingShape {
    const Tessellation& shape;
    const Snapshot& snapshot; ///< whose colours it has
    Points base;
    std::vector<Points> targets;             ///< displacements
    std::vector<std::vector<double>> values; ///< of the monitor, for each target; empty: the colours stay
    std::string motion;                      ///< the name of the animation
    std::vector<float> times;                ///< seconds
    std::vector<float> weights;              ///< at each of them one per target
};

void add_animation(tinygltf::Model& model, Packer& packer, const MovingShape& moving) {
    tinygltf::AnimationSampler sampler;
    sampler.input = packer.times(moving.times);
    sampler.output = packer.weights(moving.weights);
    tinygltf::AnimationChannel channel;
    channel.sampler = 0;
    channel.target_node = 0;
    channel.target_path = "weights";
    tinygltf::Animation animation;
    animation.name = moving.motion;
    animation.samplers.push_back(sampler);
    animation.channels.push_back(channel);
    model.animations.push_back(animation);
}

void add_scene(tinygltf::Model& model, tinygltf::Mesh mesh, Vec3 origin) {
    model.asset.version = "2.0";
    model.asset.generator = "Gaspard " + std::string(version());
    mesh.name = "adapted";
    mesh.weights.assign(mesh.primitives.front().targets.size(), 0.0);
    model.meshes.push_back(std::move(mesh));
    tinygltf::Node node;
    node.name = "adapted";
    node.mesh = 0;
    if (!(origin == Vec3{})) node.translation = {origin.x, origin.y, origin.z};
    model.nodes.push_back(node);
    tinygltf::Scene scene;
    scene.nodes = {0};
    model.scenes.push_back(scene);
    model.defaultScene = 0;
}

tinygltf::Primitive primitive(int mode, int indices, int material, int position,
                              const std::vector<int>& displacements) {
    tinygltf::Primitive result;
    result.mode = mode;
    result.indices = indices;
    result.material = material;
    result.attributes["POSITION"] = position;
    for (const int displacement : displacements) result.targets.push_back({{"POSITION", displacement}});
    return result;
}

ColourRange range_of_all(const std::vector<double>& base, const std::vector<std::vector<double>>& others) {
    ColourRange range = range_of(base);
    for (const std::vector<double>& values : others) {
        const ColourRange own = range_of(values);
        range.low = std::min(range.low, own.low), range.high = std::max(range.high, own.high);
    }
    return range;
}

Triples difference(Triples a, const Triples& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
    return a;
}

/// The colours of faces and edges, and of each target. On a mesh of lines, the edges are the cells.
void add_colours(Packer& packer, const MovingShape& moving, const std::vector<double>& base, bool has_faces,
                 tinygltf::Mesh& mesh) {
    const ColourRange range = range_of_all(base, moving.values);
    tinygltf::Primitive &faces = mesh.primitives.front(), &edges = mesh.primitives.back();
    const Triples colours = colours_of(base, range), ink = ink_on(colours);
    faces.attributes["COLOR_0"] = packer.vertices(colours);
    if (has_faces) edges.attributes["COLOR_0"] = packer.vertices(ink);
    for (std::size_t k = 0; k < moving.values.size(); ++k) {
        const Triples there = colours_of(moving.values[k], range);
        faces.targets[k]["COLOR_0"] = packer.vertices(difference(there, colours));
        if (has_faces) edges.targets[k]["COLOR_0"] = packer.vertices(difference(ink_on(there), ink));
    }
}

tinygltf::Model build_model(const MovingShape& moving) {
    const Tessellation& shape = moving.shape;
    const Points& x = moving.base;
    Points end = x;
    for (std::size_t i = 0; i < x.size() && !moving.targets.empty(); ++i)
        end.set(i, x[i] + moving.targets.back()[i]);
    const Vec3 origin = local_origin(x, end);

    tinygltf::Model model;
    Packer packer(model);
    const int position = packer.positions(single_precision(relative_to(origin, x)));
    std::vector<int> displacements;
    for (const Points& target : moving.targets)
        displacements.push_back(packer.positions(single_precision(target)));
    const std::vector<double> white = {1, 1, 1, 1},
                              ink = {static_cast<double>(dark_grey), static_cast<double>(dark_grey),
                                     static_cast<double>(dark_grey), 1};
    const Field* monitor = moving.snapshot.field("monitor");
    const bool has_faces = !shape.triangles.empty();

    tinygltf::Mesh mesh;
    if (has_faces) {
        // Lighting shows the shape of curved surfaces; on a flat mesh it would only distort the colours.
        const int material = add_material(model, "faces", white, moving.snapshot.mesh->space_dimension == 3);
        mesh.primitives.push_back(primitive(TINYGLTF_MODE_TRIANGLES,
                                            packer.indices(shape.triangles, x.size()), material, position,
                                            displacements));
    }
    mesh.primitives.push_back(primitive(TINYGLTF_MODE_LINE, packer.indices(shape.segments, x.size()),
                                        add_material(model, "edges", monitor ? white : ink, false), position,
                                        displacements));
    if (monitor) {
        GASPARD_CHECK(monitor->place == FieldPlace::node);
        add_colours(packer, moving, shown_values(shape, monitor->values), has_faces, mesh);
    }
    if (!moving.targets.empty()) add_animation(model, packer, moving);
    add_scene(model, std::move(mesh), origin);
    return model;
}

void write_model(const std::filesystem::path& file, const MovingShape& moving) {
    const tinygltf::Model model = build_model(moving);
    write_atomically(file, [&](std::ostream& stream) {
        const bool done = tinygltf::TinyGLTF().WriteGltfSceneToStream(&model, stream, false, true);
        GASPARD_CHECK(done);
    });
}

} // namespace

void write_glb(const std::filesystem::path& file, const Snapshot& snapshot) {
    const Mesh& mesh = *snapshot.mesh;
    const int cuts =
        std::max(cuts_for(mesh, snapshot.x), cuts_for(mesh, mesh.nodes)); // the animation shows both
    write_glb(file, snapshot, tessellate(mesh, cuts));
}

void write_glb(const std::filesystem::path& file, const Snapshot& snapshot, const Tessellation& shape) {
    GASPARD_CHECK(snapshot.mesh && snapshot.x.size() == snapshot.mesh->node_count());
    const Points x = shown_points(shape, snapshot.x), xi = shown_points(shape, snapshot.mesh->nodes);
    // It stays at xi, moves to x and stays there, so that a looping viewer shows both ends.
    write_model(file, {shape,
                       snapshot,
                       x,
                       {xi - x},
                       {},
                       "from computational to adapted",
                       {0.0F, 0.5F, 3.5F, 4.5F},
                       {1.0F, 1.0F, 0.0F, 0.0F}});
}

void write_animated_glb(const std::filesystem::path& file,
                        const std::vector<std::shared_ptr<const Snapshot>>& frames, double rate) {
    GASPARD_CHECK(!frames.empty() && rate > 0);
    const Mesh& mesh = *frames.back()->mesh;
    int cuts = 1;
    for (const auto& frame : frames) cuts = std::max(cuts, cuts_for(mesh, frame->x));
    const Tessellation shape = tessellate(mesh, cuts);
    MovingShape moving{shape, *frames.back(), shown_points(shape, frames.back()->x), {}, {}, "frames", {},
                       {}};
    const std::size_t count =
        frames.size() - 1; // the last one is the base, which viewers without motion show
    const bool coloured =
        std::ranges::all_of(frames, [](const auto& frame) { return frame->field("monitor") != nullptr; });
    for (std::size_t k = 0; k < count; ++k) {
        moving.targets.push_back(shown_points(shape, frames[k]->x) - moving.base);
        if (coloured) moving.values.push_back(shown_values(shape, frames[k]->field("monitor")->values));
    }
    for (std::size_t k = 0; k < frames.size(); ++k) {
        moving.times.push_back(static_cast<float>(static_cast<double>(k) / rate));
        for (std::size_t target = 0; target < count; ++target)
            moving.weights.push_back(target == k ? 1.0F : 0.0F);
    }
    write_model(file, moving);
}

} // namespace gaspard

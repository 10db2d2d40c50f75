#include "fuzz/targets.hpp"

#include "core/base/check.hpp"
#include "core/base/error.hpp"
#include "core/data/field_file.hpp"
#include "core/data/image.hpp"
#include "core/function/formula.hpp"
#include "core/io/state_file.hpp"
#include "core/mesh/surface_mesh.hpp"
#include "core/scenario/catalogue.hpp"
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"
#include "core/spline/patch_file.hpp"
#include "core/tessellate/background.hpp"
#include "core/tessellate/camera.hpp"
#include "core/tessellate/check_view.hpp"
#include "core/tessellate/pick.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <unistd.h>
#include <vector>

namespace gaspard {

namespace {

/// A file with these bytes for as long as it lives.
class InputFile {
  public:
    InputFile(std::string_view bytes, const std::string& ending)
        : path_(std::filesystem::temp_directory_path() /
                ("gaspard-fuzz-" + std::to_string(getpid()) + ending)) {
        std::ofstream(path_, std::ios::binary)
            .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    }
    ~InputFile() {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

std::shared_ptr<const Catalogue> catalogue() {
    static const auto made = std::make_shared<const Catalogue>(builtin_catalogue());
    return made;
}

std::vector<std::string> lines_of(std::string_view bytes) {
    std::vector<std::string> lines;
    while (!bytes.empty()) {
        const auto end = bytes.find('\n');
        lines.emplace_back(bytes.substr(0, end));
        bytes.remove_prefix(end == std::string_view::npos ? bytes.size() : end + 1);
    }
    return lines;
}

void expect_the_same_from_toml(const Scenario& scenario) {
    const std::string text = to_toml(scenario);
    GASPARD_CHECK(to_toml(parse_scenario(*catalogue(), text, "again")) == text);
}

void read_scenario(std::string_view bytes) {
    const Scenario scenario = parse_scenario(*catalogue(), bytes, "fuzz");
    expect_the_same_from_toml(scenario);
    check(*catalogue(), scenario);
}

/// Every line is a setting.
void read_settings(std::string_view bytes) {
    Scenario scenario = default_scenario(*catalogue());
    apply_settings(*catalogue(), scenario, lines_of(bytes));
    expect_the_same_from_toml(scenario);
    check(*catalogue(), scenario);
}

/// The first line says what the second is.
void read_view(std::string_view bytes) {
    const auto lines = lines_of(bytes);
    if (lines.size() != 2) return;
    const Mesh mesh = unit_square_mesh(2);
    if (lines[0] == "camera") {
        const Size size{400, 300};
        const std::string text = format_camera(parse_camera(lines[1], size), size);
        GASPARD_CHECK(format_camera(parse_camera(text, size), size) == text);
    } else if (lines[0] == "pick") {
        if (const auto pick = parse_pick(lines[1])) GASPARD_CHECK(parse_pick(format_pick(*pick)) == pick);
    } else if (lines[0] == "background") {
        parse_background(lines[1]);
    }
    Values view = view_section(*catalogue(), "relaxation", "ring");
    view.parse(lines[0], lines[1]);
    check_view(view, &mesh);
}

/// With the right checksum, which random bytes would never have; then started from.
void read_picture(std::string_view bytes) {
    const GreyImage image = decode_image(bytes, "picture", 64);
    GASPARD_CHECK(image.width >= 1 && image.width <= 64 && image.height >= 1 && image.height <= 64);
    GASPARD_CHECK(image.grey.size() == image.width * image.height);
    for (const float grey : image.grey) GASPARD_CHECK(grey >= 0 && grey <= 1);
}

void read_state_bytes(std::string_view bytes) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
    std::string whole(bytes);
    for (int shift = 0; shift < 64; shift += 8) whole += static_cast<char>((hash >> shift) & 0xffU);
    State state;
    {
        const InputFile file(whole, ".bin");
        state = read_state(file.path());
    }
    Scenario scenario = default_scenario(*catalogue());
    apply_settings(*catalogue(), scenario,
                   {"domain.cells=4", "method.type=relaxation", "method.max_iterations=2"});
    Run run(catalogue(), scenario, {.start = std::move(state)});
    run.solve();
}

void evaluate_formula(const std::string& text, const Space& space) {
    FormulaOptions options{.space = space, .sample = Points(3)};
    for (std::size_t i = 0; i < options.sample.size(); ++i)
        options.sample.set(i, {0.3 * static_cast<double>(i), 0.7, 0.1});
    for (const std::string& name : check_formula(text, space)) options.parameters[name] = 0.5;
    const Points x = options.sample;
    const auto function = formula_function(text, std::move(options));
    std::vector<double> values(x.size());
    Points gradients;
    function->values(x, values);
    function->gradients(x, gradients);
    GASPARD_CHECK(gradients.size() == x.size());
    function->jump();
}

/// In the spaces in which it is a formula, with its gradients.
void read_formula(std::string_view bytes) {
    const std::string text(bytes);
    try {
        evaluate_formula(text, {SpaceKind::periodic_square});
    } catch (const ExpressionError&) { // dist may have three arguments elsewhere
    }
    try {
        evaluate_formula(text, {SpaceKind::sphere});
    } catch (const ExpressionError&) {
    }
    evaluate_formula(text, {.kind = SpaceKind::euclidean, .dimension = 3});
}

void read_surface(std::string_view bytes, const char* ending) {
    const InputFile file(bytes, ending);
    const Mesh mesh = read_surface_mesh(file.path());
    GASPARD_CHECK(mesh.cell_count() > 0);
}

void read_patch_file(std::string_view bytes, const char* ending, std::size_t directions) {
    SplinePatch patch;
    {
        const InputFile file(bytes, ending);
        patch = read_patch(file.path(), {}, directions).patch;
    }
    const std::string text = patch_json(patch);
    GASPARD_CHECK(patch_json(parse_patch({text, "again", {}, directions}).patch) == text);
}

/// For a surface, and if there is none for a solid.
void read_patch_file(std::string_view bytes, const char* ending) {
    try {
        read_patch_file(bytes, ending, 2);
    } catch (const InputError&) {
        read_patch_file(bytes, ending, 3);
    }
}

/// All variables of a file.
void read_fields(std::string_view bytes, FieldData (*read)(std::string_view, const FieldRequest&)) {
    const FieldData first = read(bytes, {});
    GASPARD_CHECK(find_variable(first.variable, first.variables) == 0);
    for (std::size_t i = 1; i < first.variables.size() && i < 4; ++i) {
        const FieldData other = read(bytes, {.variable = first.variables[i], .time = -1, .level = -1});
        if (const auto* data = std::get_if<ScatteredData>(&other.data))
            GASPARD_CHECK(data->points.size() == data->values.size());
    }
    try {
        const FieldData in_space = read(bytes, {.dimension = 3});
        if (const auto* grid = std::get_if<GridData>(&in_space.data))
            GASPARD_CHECK(grid->values.size() == grid->count(0) * grid->count(1) * grid->count(2));
    } catch (const InputError&) { // a matrix of four columns is no list of points
    }
}

/// Files of HDF5 are read by its library alone, which is not ours to test.
void read_netcdf(std::string_view bytes) {
    if (bytes.starts_with("CDF")) read_fields(bytes, &parse_netcdf_field);
}

} // namespace

std::span<const FuzzTarget> fuzz_targets() {
    static constexpr FuzzTarget targets[] = {
        {"scenario", &read_scenario},
        {"settings", &read_settings},
        {"view", &read_view},
        {"state", &read_state_bytes},
        {"formula", &read_formula},
        {"image", &read_picture},
        {"surface-obj", [](std::string_view bytes) { read_surface(bytes, ".obj"); }},
        {"surface-off", [](std::string_view bytes) { read_surface(bytes, ".off"); }},
        {"surface-ply", [](std::string_view bytes) { read_surface(bytes, ".ply"); }},
        {"surface-stl", [](std::string_view bytes) { read_surface(bytes, ".stl"); }},
        {"patch-json", [](std::string_view bytes) { read_patch_file(bytes, ".json"); }},
        {"patch-xml", [](std::string_view bytes) { read_patch_file(bytes, ".xml"); }},
        {"csv", [](std::string_view bytes) { read_fields(bytes, &parse_csv_field); }},
        {"netcdf", &read_netcdf},
        {"vtk", [](std::string_view bytes) { read_fields(bytes, &parse_legacy_vtk_field); }},
        {"vtu", [](std::string_view bytes) { read_fields(bytes, &parse_xml_vtk_field); }},
        {"patch-text", [](std::string_view bytes) { read_patch_file(bytes, ".txt"); }},
    };
    return targets;
}

void run_target(const FuzzTarget& target, std::string_view bytes) {
    try {
        target.read(bytes);
    } catch (const InputError& error) {
        const std::string_view text = error.what();
        if (text.empty() || text.size() > 20'000)
            throw std::logic_error("an InputError has a text of " + std::to_string(text.size()) + " bytes");
    }
}

} // namespace gaspard

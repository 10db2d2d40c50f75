// Scenarios as commands get them: by name, file or standard input, with settings, and checked.
#pragma once

#include "core/io/formats.hpp"
#include "core/mesh/mesh.hpp"
#include "core/scenario/toml.hpp"

#include <string>
#include <vector>

namespace gaspard {

struct ScenarioInput {
    Scenario scenario;
    Scenario named; ///< without settings
    ScenarioSource source; ///< of the keys that no setting has replaced
    std::vector<const Format*> formats{};
};

/// Loads a scenario and applies key=value settings; of two for one key the later one counts. Throws
/// InputError.
ScenarioInput load_input(const Catalogue& catalogue, const std::string& name,
                         const std::vector<std::string>& settings);
/// Updates Scenario::modified.
void note_changes(ScenarioInput& input);
/// Applies further settings.
void change_input(const Catalogue& catalogue, ScenarioInput& input, const std::vector<std::string>& settings);
/// Checks the combination, the view and the list of formats, and fills `formats`. Throws InputError, with
/// file and line where the file has the value that is wrong. Makes nothing and reads no file.
void check_input(const Catalogue& catalogue, ScenarioInput& input);
/// Makes the mesh if something has to be checked with it that `run` would refuse: a patch file, a layout, a
/// camera for SVG. Throws InputError.
void check_domain(const Catalogue& catalogue, const ScenarioInput& input);
/// Makes the monitors that depend on a file or a formula: `run` would refuse a file that is not there, or a
/// formula that is not positive. Throws InputError.
void check_data(const Catalogue& catalogue, const ScenarioInput& input);
/// The checks of the view and the formats that need the mesh.
void check_with_mesh(const ScenarioInput& input, const Mesh& mesh);

/// Says which files in a folder are not of this run (left_over).
void print_left_over(const std::vector<std::string>& names);

} // namespace gaspard

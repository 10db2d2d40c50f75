// The commands of the program. Each returns the exit code and may throw InputError or MachineError.
#pragma once

#include "core/scenario/catalogue.hpp"

#include <optional>
#include <string>
#include <vector>

namespace gaspard {

/// The options of `run`, not yet checked.
struct RunArguments {
    std::string scenario;
    std::vector<std::string> settings; ///< key=value
    std::string out;                   ///< empty: ./gaspard-out/SCENARIO
    std::optional<std::string> formats, size, start, max_iterations, threads, seed, tolerance;
    bool no_render = false, whole_window = false, quiet = false;
    bool overwrite = false; ///< also files of a run of another scenario
};

/// The options of `compare`, not yet checked.
struct CompareArguments {
    std::string scenario;
    std::vector<std::string> settings;
    std::optional<std::string> methods; ///< comma-separated; default: all applicable
    std::string out;                    ///< empty: ./gaspard-out/SCENARIO-methods
    bool no_render = false;
    bool overwrite = false; ///< also files of a comparison on another scenario
};

/// The options of `why`, not yet checked.
struct WhyArguments {
    std::string scenario;
    std::vector<std::string> settings;
    std::optional<std::string> cells; ///< comma-separated; default: usual_resolutions()
    std::string out;                  ///< empty: ./gaspard-out/SCENARIO-why
    bool no_render = false;
    bool overwrite = false; ///< also files about another scenario
};

/// The options of `study`, not yet checked.
struct StudyArguments {
    std::string scenario;
    std::vector<std::string> settings;
    std::optional<std::string> over, lines; ///< key=values, over also a key alone; default: usual_study()
    std::optional<std::string> measure;
    std::string out; ///< empty: ./gaspard-out/SCENARIO-study
    bool no_render = false;
    bool overwrite = false; ///< also files about another scenario
};

/// The options of `record`, not yet checked.
struct RecordArguments {
    std::string scenario;
    std::vector<std::string> settings;
    std::optional<std::string> motion, frames, rate, first, last, from_time, to_time, from, to, formats, size,
        nodes;
    std::string out; ///< empty: ./gaspard-out/SCENARIO-film
    bool resume = false, quiet = false;
    bool overwrite = false; ///< also files of another scenario
};

int record_command(std::shared_ptr<const Catalogue> catalogue, const RecordArguments& arguments);
int run_command(std::shared_ptr<const Catalogue> catalogue, const RunArguments& arguments);
int compare_command(std::shared_ptr<const Catalogue> catalogue, const CompareArguments& arguments);
int why_command(std::shared_ptr<const Catalogue> catalogue, const WhyArguments& arguments);
int study_command(std::shared_ptr<const Catalogue> catalogue, const StudyArguments& arguments);
int list_command(const Catalogue& catalogue, const std::string& what);
/// Options of `gaspard show`.
struct ShowOptions {
    bool as_formula = false; ///< with the built-in monitor as a formula
    bool portable = false;   ///< with the content of its data files
};
int show_command(const Catalogue& catalogue, const std::string& scenario,
                 const std::vector<std::string>& settings, const ShowOptions& options);
int reproduce_command(std::shared_ptr<const Catalogue> catalogue, const std::string& id,
                      const std::string& out, bool full, bool render);
int window_command(std::shared_ptr<const Catalogue> catalogue, const std::string& scenario,
                   const std::vector<std::string>& settings, const std::optional<std::string>& size);

/// The settings of view.width and view.height from a text such as "1200x900". Throws InputError if it is
/// malformed.
std::vector<std::string> size_settings(const std::string& size);

} // namespace gaspard

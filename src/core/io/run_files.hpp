// The files that `run` writes: summary.json, history.csv, state.bin and the meshes in the chosen formats.
#pragma once

#include "core/base/export.hpp"
#include "core/io/formats.hpp"
#include "core/session/run.hpp"

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

namespace gaspard GASPARD_API {

class HistoryFile; // core/io/history_file.hpp

/// Scenario, status, numbers, times, memory; what was not measured is null. "measures" are the method's
/// further series.
std::string summary_json(Run& run, std::stop_token stop = {});
/// The names of the files that write_run_files() writes.
std::vector<std::string> run_file_names(const Run& run, const std::vector<const Format*>& formats);
/// Those that some run may have written, of any domain and with any formats.
std::vector<std::string> possible_run_file_names();
/// Whether the summary.json in a folder has other values of domain, monitor, method or PDE than the scenario.
bool holds_other_values(const std::filesystem::path& folder, const Scenario& scenario);
/// Writes all of them into a folder, which is made with its parents if it is not there, each under a
/// temporary name that is then renamed; what fails does not keep the others from being tried. `history`:
/// history.csv as it was written so far; null: it has the rows of Run::history(). Throws the first
/// MachineError; Interrupted when stopped between two files, each of which is whole.
void write_run_files(const std::filesystem::path& folder, Run& run, const std::vector<const Format*>& formats,
                     const Progress& progress = {}, std::stop_token stop = {},
                     HistoryFile* history = nullptr);

} // namespace GASPARD_API

// Which files a folder holds already, so that no other run's files are replaced.
#pragma once

#include "core/scenario/scenario.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace gaspard {

/// A record of what the files of a folder are about: the scenario's name as "scenario", its modified keys as
/// "modified". summary.json has the same entries.
std::string record_json(const Scenario& scenario);

/// The first of these names that the folder has a file of; empty if there is none.
std::string first_present(const std::filesystem::path& folder, const std::vector<std::string>& names);

/// Throws InputError if the folder has a folder of one of these names, which no file can replace.
void check_no_folders(const std::filesystem::path& folder, const std::vector<std::string>& names);

/// Throws InputError if the folder has files of these names that are not those of a run of this scenario: its
/// `record`, a JSON file such as summary.json, has another name as "scenario" or cannot be read.
void check_replaceable(const std::filesystem::path& folder, const std::vector<std::string>& names,
                       const std::string& record, const std::string& scenario);

/// The files of the names `all` that a folder has, except those of `written`: they are of something else, but
/// may pass for files of this run.
std::vector<std::string> left_over(const std::filesystem::path& folder, const std::vector<std::string>& all,
                                   const std::vector<std::string>& written);

/// `base`, or the first of "base-2", "base-3", ... that has no file of these names.
std::filesystem::path free_folder(const std::filesystem::path& base, const std::vector<std::string>& names);

} // namespace gaspard

// The geometries of a file, and the choice of one by domain.patch:
//
//   ""        the first that can be read
//   "3"       the third that can be read, as counted in "patch 3 of 312"
//   "id:100"  the geometry whose id in the file is 100; refused where several have it
#pragma once

#include "core/base/export.hpp"
#include "core/mesh/patch_list.hpp"
#include "core/spline/spline_patch.hpp"

#include <memory>
#include <string>
#include <vector>

namespace gaspard GASPARD_API {

/// A geometry of a file.
struct PatchEntry {
    std::string kind;    ///< "TensorNurbs2"
    std::string id;      ///< as the file has it; may be empty
    std::string refusal; ///< "a hierarchical spline": why it is not read; empty if it can be read
};

/// A patch that was read.
struct FoundPatch {
    SplinePatch patch;
    std::string origin;                         ///< for messages: "p.xml, patch 3 of 312"
    std::shared_ptr<const PatchList> patches{}; ///< null if the file has only one
};

/// What a reader of a format gets.
struct PatchText {
    std::string_view text;
    std::string origin; ///< the file's name, for messages
    std::string which;  ///< domain.patch
    /// Of the geometry that is wanted: 2, surfaces, or 3, solids.
    std::size_t directions = 2;
};

/// Why a geometry with this number of directions is not what `file` is read for: "a solid, not a surface,
/// ..."; empty if it is.
std::string refusal_of_directions(std::size_t directions, const PatchText& file);

struct ChosenPatch {
    std::size_t entry = 0; ///< its index among all entries
    std::string origin;
    std::shared_ptr<const PatchList> patches{};
};

/// Throws InputError if no entry can be read or the chosen one cannot; the message says what the file has.
ChosenPatch choose_patch(const std::vector<PatchEntry>& entries, const PatchText& file);

/// Throws InputError that the file is no patch file that is read: "p.xml: it is ...".
[[noreturn]] void cannot_read(const std::string& origin, const std::string& why);

} // namespace GASPARD_API

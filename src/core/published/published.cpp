#include "core/published/published.hpp"

#include "core/base/csv.hpp"
#include "core/base/error.hpp"

#include <algorithm>

namespace gaspard {

std::vector<Recipe> recipes() {
    std::vector<Recipe> all = mcrae_recipes();
    for (auto& one : bahari_recipes()) all.push_back(std::move(one));
    return all;
}

Recipe find_recipe(std::string_view id) {
    std::vector<std::string> known;
    for (auto& recipe : recipes()) {
        if (recipe.id == id) return recipe;
        known.push_back(recipe.id);
    }
    throw InputError("unknown table or figure '" + std::string(id) + "'" + did_you_mean(id, known) +
                     "; `gaspard reproduce` lists them");
}

std::string published_csv(const std::vector<PublishedRow>& rows) {
    std::string csv = "row,quantity,ours,published,note\n";
    for (const auto& row : rows)
        csv += csv_text(row.row) + "," + csv_text(row.quantity) + "," + format_number(row.ours) + "," +
               (row.published ? format_number(*row.published) : "") + "," + csv_text(row.note) + "\n";
    return csv;
}

} // namespace gaspard

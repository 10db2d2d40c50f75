#include "core/published/published.hpp"

#include "core/base/csv.hpp"
#include "core/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace gaspard {

std::vector<Recipe> recipes() {
    std::vector<Recipe> all = mcrae_recipes();
    for (auto& one : bahari_recipes()) all.push_back(std::move(one));
    for (auto& one : hill_recipes()) all.push_back(std::move(one));
    for (auto& one : kawecki_recipes()) all.push_back(std::move(one));
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

Printed printed(double value, int digits) {
    const double leading = value == 0 ? 0 : std::floor(std::log10(std::abs(value)));
    return {value, std::pow(10.0, leading - (digits - 1))};
}

std::optional<double> difference(const PublishedRow& row) {
    return row.published ? std::optional(row.ours - row.published->value) : std::nullopt;
}

bool differs(const PublishedRow& row) {
    constexpr double rounding = 1 + 1e-9; // of the decimal numbers
    return row.published && std::abs(*difference(row)) > rounding * row.published->last_digit;
}

std::string full_note(const PublishedRow& row) {
    if (!differs(row)) return row.note;
    std::string text = "differs beyond the last digit printed";
    if (row.published->value != 0) {
        char percent[40];
        std::snprintf(percent, sizeof percent, " (%+.2g %%)",
                      100 * *difference(row) / std::abs(row.published->value));
        text += percent;
    }
    text += ": " + (row.reason.empty() ? "cause unknown" : row.reason);
    return row.note.empty() ? text : text + "; " + row.note;
}

std::string published_csv(const std::vector<PublishedRow>& rows) {
    std::string csv = "row,quantity,ours,published,difference,note\n";
    for (const auto& row : rows)
        csv += csv_text(row.row) + "," + csv_text(row.quantity) + "," + format_number(row.ours) + "," +
               (row.published ? format_number(row.published->value) : "") + "," +
               format_number(difference(row)) + "," + csv_text(full_note(row)) + "\n";
    return csv;
}

} // namespace gaspard

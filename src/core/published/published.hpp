// Tables and figures of the papers as recipes: what to compute, with the published numbers for comparison.
#pragma once

#include "core/published/figure.hpp"
#include "core/scenario/catalogue.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

/// A number as a paper prints it.
struct Printed {
    double value = 0;
    double last_digit = 0; ///< unit of the last digit; 0 for a count, which is printed exactly
};
/// A number printed with so many significant digits.
Printed printed(double value, int digits);

struct PublishedRow {
    std::string row;      ///< "ring, n = 60"
    std::string quantity; ///< "iterations"
    double ours = 0;
    std::optional<Printed> published{}; ///< nullopt if the paper prints a curve without numbers
    std::string note{};
    std::string reason{}; ///< why ours may differ by more than the last digit; empty where it is not known
};
/// ours - published; nullopt if nothing is published.
std::optional<double> difference(const PublishedRow& row);
/// Whether the difference exceeds a unit of the last digit printed.
bool differs(const PublishedRow& row);
/// The difference in percent and its reason if the row differs, then PublishedRow::note.
std::string full_note(const PublishedRow& row);

struct Reproduction {
    std::vector<PublishedRow> rows;
    std::optional<Figure> figure; ///< nullopt for tables
};

/// Reports what is being computed; called before each run.
using Announce = std::function<void(const std::string&)>;

struct Recipe {
    std::string id;    ///< "mcrae-fig2"
    std::string title; ///< content of the table or figure
    using Make = std::function<Reproduction(const std::shared_ptr<const Catalogue>&, const Announce&,
                                            std::stop_token)>;
    Make make;
    Make full{}; ///< with rows that take minutes; empty if `make` computes all
};

std::vector<Recipe> recipes();
/// Throws InputError if the id is unknown; the message names the nearest.
Recipe find_recipe(std::string_view id);

/// Columns row, quantity, ours, published, difference, note (full_note()).
std::string published_csv(const std::vector<PublishedRow>& rows);

/// The recipes of McRae, Cotter, Budd, "Optimal-transport-based mesh adaptivity on the plane and sphere using
/// finite elements", SIAM J. Sci. Comput. 40 (2018).
std::vector<Recipe> mcrae_recipes();
/// The recipes of Bahari, Habbal, Ratnani, Sonnendruecker, "Adaptive isogeometric analysis using optimal
/// transport and their fast solvers", Comput. Methods Appl. Mech. Engrg. 418 (2024).
std::vector<Recipe> bahari_recipes();
/// The recipes of Hill, Madden, "Generating layer-adapted meshes using mesh partial differential equations"
/// (2021).
std::vector<Recipe> hill_recipes();
/// The recipes of Kawecki, Lakkis, Pryer, "A finite element method for the Monge-Ampère equation with
/// transport boundary conditions" (2018).
std::vector<Recipe> kawecki_recipes();

} // namespace gaspard

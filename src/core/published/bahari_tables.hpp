// The numbers of the tables of Bahari, Habbal, Ratnani, Sonnendruecker (2024).
#pragma once

#include <span>

namespace gaspard {

/// A row of tables 1, 2, 7 and 8: a problem with a known solution.
struct PublishedSolve {
    int degree, cells;
    double error, error_multilevel;
    int iterations, iterations_multilevel;
};
std::span<const PublishedSolve> published_solves(int table);

/// A row of tables 3 to 6 and 9 to 19: an adapted mesh.
struct PublishedMap {
    int degree, cells;
    double err, qual, min_jacobian, max_jacobian, border;
};
std::span<const PublishedMap> published_maps(int table);

} // namespace gaspard

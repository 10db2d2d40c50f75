// The univariate matrices from which spline_*_form.cpp build the two forms.
#pragma once

#include "core/spline/spline_forms.hpp"

#include <Eigen/Dense>

namespace gaspard {

/// M, D and R of (6.10), with R as in (6.13) and (6.18): one row per function of S^p, one column per function
/// of S^p-1.
struct LineMatrices {
    explicit LineMatrices(const SplineLine& line);
    Eigen::MatrixXd mass, stiffness, mass_below, r;
};

LineOperator line_operator(const Eigen::MatrixXd& symmetric);

/// The integrals of a function, given at the line's quadrature points, against every function of `table`.
std::vector<double> moments(const SplineLine& line, const LineTable& table, std::span<const double> values);
/// The same on a face of [0, 1]^D: in D - 1 directions.
template <std::size_t D>
std::vector<double> face_moments(const SplineLine& line, const LineTable& table,
                                 std::span<const double> values);
/// The integrals of the functions of `table`.
std::vector<double> integrals(const SplineLine& line, const LineTable& table);

} // namespace gaspard

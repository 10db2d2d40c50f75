// The matrices of one direction that the two forms are made of; for spline_*_form.cpp.
#pragma once

#include "core/spline/spline_forms.hpp"

#include <Eigen/Dense>

namespace gaspard {

/// M, D and R of (6.10), R as (6.13) and (6.18) have it: a row per function of S^p, a column per one of
/// S^p-1.
struct LineMatrices {
    explicit LineMatrices(const SplineLine& line);
    Eigen::MatrixXd mass, stiffness, mass_below, r;
};

LineOperator line_operator(const Eigen::MatrixXd& symmetric);

/// The integrals of a function, given at the line's quadrature points, times every function of a table there.
std::vector<double> moments(const SplineLine& line, const LineTable& table, std::span<const double> values);
/// Of the functions themselves.
std::vector<double> integrals(const SplineLine& line, const LineTable& table);

} // namespace gaspard

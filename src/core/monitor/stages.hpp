// From an indicator q >= 0 on a domain to a monitor m > 0, in stages on a grid:
//
//   average     m = 1 + f / (1 - f) q / <q>,       <q> the average over the domain
//   limit       m = ((m^4 + (F <m>)^4)^(1/4))^-4 + (C M)^-4)^(-1/4),       M the least value after the floor
//   smoothing   (I - L^2/2 Delta)^2 g = m - 1
//
// The average is that of Beckett and Mackenzie (2000), with a parameter as in Huang and Russell (2011,
// section 2.4): of a mesh that equidistributes m, the fraction f of all cells goes to q, that is, the average
// of q / m over the cells is f. Floor and limit on the contrast are smooth: m >= F <m> and max m <= C min m
// hold exactly. Smoothing twice, over L / sqrt(2) each time, has the variance of one Helmholtz filter over L,
// but no crease where a feature is thinner than the grid. It keeps the average of m.
#pragma once

#include "core/monitor/domain_grid.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gaspard {

/// Replaces q by m. Where q is zero everywhere, m = 1.
void average_stage(const DomainGrid& domain, std::span<double> values, double fraction);
/// `floor` relative to the average of m, 0: none; `contrast` >= 1.
void limit_stage(const DomainGrid& domain, std::span<double> values, double floor, double contrast);
/// `length` L in the unit of the domain.
void smoothing_stage(const DomainGrid& domain, std::span<double> values, double length,
                     const DataContext& context);

/// How much m changes over a cell of the adapted mesh, which has the size h (<m> / m)^(1/d): the largest of
///
///   h (<m> / m)^(1/d) |grad log m|
///
/// over the domain, for cells of size h of the uniform mesh. A mesh cannot follow m where this is large.
double steepness(const DomainGrid& domain, std::span<const double> values);
/// The limit of it on the square: for a monitor made of a function u or of other monitors, and for one made
/// of data. Found by experiment: interpolation errors of u are smaller with the first; with the second, which
/// blurs less, `auto` still converges for every picture tried (bench/images.py, docs/monitors.md).
inline constexpr double steepest_stages = 1.0, steepest_data = 1.2;
/// The limit on a domain: `on_square`, or 0.5 on the sphere, on patches and on solids.
double steepest(const DomainGrid& domain, double on_square);

/// A monitor that a mesh can follow, or a note that it may not.
struct Followed {
    std::vector<double> values; ///< m
    double length = 0;          ///< over which it was smoothed, in cells
    std::vector<std::string> notes;
};
/// m smoothed over `length` cells; nullopt: over the least of some lengths for which it is not too steep, or
/// not at all.
Followed follow(const DomainGrid& domain, std::vector<double> values, std::optional<double> length,
                const DataContext& context);

} // namespace gaspard

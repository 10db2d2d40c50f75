// A form on a patch: where its map puts the nodes of the mesh, and how good it is by the measures of Bahari
// et al.
#pragma once

#include "core/method/method.hpp"
#include "core/method/patch_source.hpp"
#include "core/spline/spline_domain.hpp"

#include <optional>
#include <string>

namespace gaspard {

enum class Formulation { standard, mixed };

/// What the layout of a patch's State says: "spline standard p=3 n=32".
struct SplineLayout {
    Formulation formulation = Formulation::standard;
    int degree = 3;
    std::size_t cells = 0;
};
std::string spline_layout(const SplineLayout& layout);
std::optional<SplineLayout> parse_spline_layout(const std::string& text);
/// On equal cells, with the identity at the border.
std::unique_ptr<SplineForm> make_form(const SplineLayout& layout);

/// How good a map is, as Bahari et al. print and define it.
struct PatchMeasures {
    double err_printed = 0;  ///< L2 norm of det / f - 1, which the paper's tables show
    double err_defined = 0;  ///< L2 norm of det - f, (5.6)
    double qual_det = 0;     ///< root of the integral of |Psi - xi|^2 / |det|
    double qual_f = 0;       ///< the same over f, (5.6)
    double min_jacobian = 0; ///< of Psi, on a grid of 100 x 100 points without the outermost
    double max_jacobian = 0;
    double border_error = 0; ///< largest |(Psi - xi) . n| on that grid's border
};
/// As reports name them, and their values in the same order.
std::vector<SeriesInfo> patch_series();
std::vector<double> values_of(const PatchMeasures& measures);

/// One form on a patch, with n cells or fewer than its mesh has.
class PatchForm {
  public:
    PatchForm(std::shared_ptr<const SplineDomain> domain, Formulation formulation, std::size_t cells);

    const std::shared_ptr<const SplineForm>& form() const { return form_; }
    const SplineDomain& domain() const { return *domain_; }
    Formulation formulation() const { return formulation_; }
    std::size_t cells() const { return cells_; }
    std::string layout() const { return spline_layout({formulation_, domain_->degree(), cells_}); }
    PatchSource source(const Monitor& monitor) const { return {monitor, *domain_->map(), form_->line()}; }

    /// Phi = phi + the potential of the identity; states hold phi, which is 0 where no node has moved.
    void add_identity(std::span<const double> phi, std::span<double> whole) const;
    std::vector<double> without_identity(std::span<const double> whole) const;
    /// phi on this mesh, from one of another (exact where this one is a refinement of it); empty where a
    /// layout means no such thing.
    std::vector<double> adopt(const std::string& layout, std::span<const double> phi) const;
    /// F(Psi) at the nodes of the domain's mesh. In the mixed form those at the border stand there exactly.
    void positions(std::span<const double> whole, Points& x);

    PatchMeasures measure(const Monitor& monitor, std::span<const double> whole);

  private:
    std::shared_ptr<const SplineDomain> domain_;
    Formulation formulation_;
    std::size_t cells_;
    std::shared_ptr<const SplineForm> form_;
    std::vector<double> identity_;
    SplineGrid nodes_;
    SplineForm::Workspace workspace_;
    Points psi_;
};

} // namespace gaspard

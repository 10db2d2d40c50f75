// A spline form (standard or mixed) on a patch or a solid: node positions of its map, and the quality
// measures of Bahari et al. (2024).
#pragma once

#include "core/method/method.hpp"
#include "core/method/patch_source.hpp"
#include "core/spline/jacobian_bounds.hpp"
#include "core/spline/tensor_domain.hpp"

#include <optional>
#include <string>

namespace gaspard {

enum class Formulation { standard, mixed };

/// The layout of a State on a patch: "spline standard p=3 n=32", or on a solid: "solid standard p=3 n=32".
struct SplineLayout {
    Formulation formulation = Formulation::standard;
    int degree = 3;
    std::size_t cells = 0;
    std::size_t dimension = 2;
};
std::string spline_layout(const SplineLayout& layout);
/// nullopt if the text is not such a layout.
std::optional<SplineLayout> parse_spline_layout(const std::string& text);
/// The form on uniform cells, with the normal trace of the identity as boundary data.
template <std::size_t D>
std::unique_ptr<TensorForm<D>> make_form(const SplineLayout& layout);

/// The row of method.measure, and its value.
ParameterRow measure_row();
Measure measure_of(const Values& method);

/// Quality measures of a map as Bahari et al. print and define them; det = det grad Psi.
struct PatchMeasures {
    double err_printed = 0;  ///< L2 norm of det / f - 1, as printed in the paper's tables
    double err_defined = 0;  ///< L2 norm of det - f, (5.6)
    double qual_det = 0;     ///< sqrt( integral of |Psi - xi|^2 / |det| )
    double qual_f = 0;       ///< sqrt( integral of |Psi - xi|^2 / f ), (5.6)
    double min_jacobian = 0; ///< min det on the inner points of a grid of 100 points per direction
    double max_jacobian = 0;
    /// Of patches: lower bound of det on the whole square (core/spline/jacobian_bounds.hpp).
    double bound_jacobian = 0;
    double border_error = 0; ///< max |(Psi - xi) . n| on the boundary of that grid
    /// Standard deviation over mean of the integrals of rho(F(Psi)) det over the cells of the form. What the
    /// quality of a mesh (diagnostics/quality.hpp) measures in space, in the parameter square or cube.
    double variation_in_square = 0;
    /// As in tables 16 to 19 of the paper: err_printed and qual_det over the last layer of cells alone.
    double err_last_layer = 0, qual_last_layer = 0;
};
/// As reports name them on patches (2) and solids (3), and their values in the same order.
std::vector<SeriesInfo> patch_series(std::size_t dimension);
std::vector<double> values_of(const PatchMeasures& measures, std::size_t dimension);

/// A form on a patch (D = 2) or a solid (D = 3) with `cells` cells per direction, possibly fewer than the
/// mesh of the domain.
template <std::size_t D>
class MappedForm {
    using Form = TensorForm<D>;

  public:
    MappedForm(std::shared_ptr<const TensorDomain<D>> domain, Formulation formulation, std::size_t cells);

    const std::shared_ptr<const Form>& form() const { return form_; }
    const TensorDomain<D>& domain() const { return *domain_; }
    Formulation formulation() const { return formulation_; }
    std::size_t cells() const { return cells_; }
    std::string layout() const { return spline_layout({formulation_, domain_->degree(), cells_, D}); }
    /// Measure::parameter until another one is set.
    void set_measure(Measure measure);
    TensorSource<D> source(const Monitor& monitor) const {
        return {monitor, *domain_->map(), form_->line(), elements_};
    }

    /// whole = Phi = phi + (potential of the identity map). States hold phi, which is 0 for the identity map.
    void add_identity(std::span<const double> phi, std::span<double> whole) const;
    std::vector<double> without_identity(std::span<const double> whole) const;
    /// phi transferred from another mesh; exact if this mesh is a refinement of it. Empty if `layout` is not
    /// that of a patch or does not match the size of phi.
    std::vector<double> adopt(const std::string& layout, std::span<const double> phi) const;
    /// x = F(Psi) at the nodes of the domain's mesh. In the mixed form, boundary nodes lie exactly on the
    /// boundary.
    void positions(std::span<const double> whole, Points& x);

    PatchMeasures measure(const Monitor& monitor, std::span<const double> whole);
    /// Of patches: bounds of det grad Psi on the cells of the domain's mesh. The reference is valid until the
    /// next call.
    const JacobianBounds& jacobian(std::span<const double> whole) requires(D == 2);
    /// The cells of the domain's mesh in which the map folds.
    std::vector<std::uint32_t> folded_cells(std::span<const double> whole);

  private:
    /// Psi of the standard form may leave the square or cube; where it must not, it is put back.
    void keep_sides();
    /// The measures that are integrals over the square or cube.
    void integrate(const Monitor& monitor, std::span<const double> whole, PatchMeasures& result);
    /// The extremes on the grid that is shown.
    void find_extremes(std::span<const double> whole, PatchMeasures& result);

    std::shared_ptr<const TensorDomain<D>> domain_;
    Formulation formulation_;
    std::size_t cells_;
    std::shared_ptr<const Form> form_;
    std::vector<double> identity_;
    SplineGrid nodes_;
    typename Form::Workspace workspace_;
    Points psi_;
    std::vector<double> elements_; ///< J of F at the quadrature points, if they are in use
    JacobianBounds jacobian_;
    std::vector<double> whole_of_jacobian_; ///< the argument of the last call of jacobian()
};
using PatchForm = MappedForm<2>;

} // namespace gaspard

// The fixed-point iteration of Benamou, Froese and Oberman with splines; Bahari, Habbal, Ratnani,
// Sonnendruecker (2024), sections 4 and 6:
//
//   div Psi^{k+1} = s G(Psi^k),   G = ( (div Psi)^d + delta (f(Psi) - det grad Psi) )^(1/d)   (4.2), (6.2)
//
//   s = (flux of Psi through the boundary) / (integral of G)
//
// in d = 2 and 3 dimensions with delta = 2 and 27. In three dimensions the paper's numbers follow from 27,
// not from the d! of its text.
//
// s makes the Neumann problem solvable; the paper does not state it, but its numbers agree with it. The
// standard and the mixed form are in spline/spline_forms.hpp. T denotes the map phi^k -> phi^{k+1}.
#pragma once

#include "core/base/points.hpp"
#include "core/base/symmetric.hpp"
#include "core/spline/spline_forms.hpp"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace gaspard {

/// f(xi, Psi), the prescribed Jacobian determinant of the map.
class JacobianSource {
  public:
    virtual ~JacobianSource() = default;
    /// f at the quadrature points of slabs y, y + 1, ... (spline_forms.hpp); psi holds Psi at these points.
    /// In three dimensions called by several threads at once.
    virtual void values(std::size_t y, const Points& psi, std::span<double> f) const = 0;
    /// f and its derivatives df/dPsi, in x and y (and z) of `gradient`.
    virtual void gradients(std::size_t y, const Points& psi, std::span<double> f, Points& gradient) const = 0;
};

template <std::size_t D>
class BfoIteration {
    using Form = TensorForm<D>;

  public:
    /// `shift`: epsilon of the paper (standard form). 0 eliminates the constant exactly instead. More than
    /// one thread is used in three dimensions only; results do not depend on their number.
    explicit BfoIteration(std::shared_ptr<const Form> form, double shift = 0, std::size_t threads = 1);

    const Form& form() const { return *form_; }
    double shift() const { return shift_; }

    /// Properties of a map, evaluated at the quadrature points.
    struct Shape {
        double convexity = 0; ///< smallest eigenvalue of grad Psi
        /// lambda_min and lambda_max of phi - T(phi), linearised with f fixed:
        ///
        ///   lambda = 1 - s (eigenvalue of A),   A = ((div Psi)^(d-1) I - delta/d cof grad Psi) / G^(d-1)
        ///
        /// In two dimensions A = grad Psi / G.
        double slowest = 0, fastest = 0;
    };
    /// next = T(phi). An empty phi stands for Psi = 0 everywhere, also at the boundary: the start of the
    /// paper. Fills `shape` if it is not null.
    void iterate(const JacobianSource& source, std::span<const double> phi, std::span<double> next,
                 Shape* shape = nullptr);
    /// b, the right-hand side of the Poisson problem A next = b of the last iterate(); valid until the next
    /// call of anything here.
    std::span<const double> load() const { return load_; }
    /// r = A (next - phi) with next = T(phi) and A the matrix of the Poisson problem. It equals load() minus
    /// the load of the iteration that led to phi.
    void residual(std::span<const double> phi, std::span<const double> next, std::span<double> r);
    /// Solves A u = r.
    void poisson(std::span<const double> r, std::span<double> u);

    /// Linearises at phi. If `moving` is false, the derivative of f with respect to Psi is neglected.
    void linearise(const JacobianSource& source, std::span<const double> phi, bool moving);
    /// out = -dr/dphi w, exact for the discrete problem.
    void derivative(std::span<const double> w, std::span<double> out);

    double other_cpu_seconds() const { return workspace_.team->other_cpu_seconds(); }

  private:
    static constexpr std::size_t entries = D * (D + 1) / 2; ///< of the upper triangle of grad Psi

    /// Slabs of quadrature points that are processed at once: Psi, df/dPsi, grad Psi, f, G.
    struct Band {
        std::size_t first = 0, slabs = 0;
        Points psi, slope;
        std::array<std::vector<double>, entries> h;
        std::vector<double> f, g;

        std::size_t size() const { return psi.size(); }
        Symmetric<D> hessian(std::size_t i) const {
            Symmetric<D> all;
            for (std::size_t e = 0; e < entries; ++e) all[e] = h[e][i];
            return all;
        }
    };
    /// A fixed part of the slabs, so that sums do not depend on the number of threads.
    struct Part {
        std::size_t begin = 0, end = 0;  ///< slabs
        std::size_t first = 0, last = 0; ///< functions along the last direction that are not zero there
        std::vector<double> load{};      ///< their lines; in two dimensions the form's own are used
        double integral = 0;
        double convexity = 0, least = 0, most = 0;
    };
    /// Calls work(band, part) for all slabs, in bands with grad Psi read, and sums what it writes to Band::g:
    /// the integral, and the integrals against all test functions in the form's workspace.
    template <class Work>
    double integrate(bool at_rest, const Work& work);
    void read(Band& band) const;
    /// The integral of Band::g; adds its integrals against the test functions to the part's.
    void load(const Band& band, Part& part);
    static void fill_g(Band& band);

    std::shared_ptr<const Form> form_;
    double shift_;
    typename Form::Workspace workspace_;
    std::vector<Band> bands_; ///< of the workers
    std::vector<Part> parts_;
    std::vector<double> load_;
    /// Coefficients of the linearisation at all quadrature points, in the order of the form's fields:
    ///
    ///   dG = (sum over fields) coefficients[field] d(field)
    std::array<std::vector<double>, Form::fields> coefficients_;
    std::vector<double> g_load_; ///< <G, v>
    double g_integral_ = 0;
};
using Bfo = BfoIteration<2>;

/// |<v, d>|, the l2 norm over all basis functions v, by which |r| is normalised: d is the divergence of the
/// identity map.
template <std::size_t D>
double norm_of_divergence(const TensorForm<D>& form);

} // namespace gaspard

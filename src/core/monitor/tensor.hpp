// Tensor monitors: a symmetric positive definite matrix M(x) instead of a scalar m(x). A mesh that is uniform
// in the metric M has cells that are short along the eigenvectors of large eigenvalues.
#pragma once

#include "core/base/export.hpp"
#include "core/monitor/monitor.hpp"

namespace gaspard GASPARD_API {

/// The upper triangle of a symmetric 3 x 3 matrix; in two dimensions zz = 1, xz = yz = 0.
struct SymmetricTensor {
    double xx = 1, yy = 1, zz = 1, xy = 0, xz = 0, yz = 0;
};
double determinant(const SymmetricTensor& m);
/// By Sylvester's criterion; false if an entry is not finite.
bool positive_definite(const SymmetricTensor& m);

/// Immutable once a run has it; may be called from several threads at once.
class TensorMonitor {
  public:
    virtual ~TensorMonitor() = default;
    /// M at every point (physical coordinates). `values`: x.size() entries.
    virtual void values(const Points& x, std::span<SymmetricTensor> values) const = 0;
    /// Throws InputError if M is not positive definite at some point; the message names the parameter to
    /// change.
    virtual void check() const = 0;
};

/// m = sqrt(det M): the density of cells in a mesh that is uniform in the metric M. Gradients are central
/// differences with a step of 1e-5.
std::shared_ptr<const Monitor> density_of(std::shared_ptr<const TensorMonitor> tensor);

} // namespace GASPARD_API

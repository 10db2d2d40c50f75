#include "core/linear/gmres.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <cmath>

namespace gaspard {

Gmres::Gmres(std::size_t size, std::size_t memory)
    : size_(size), memory_(memory), basis_((memory + 1) * size), hessenberg_((memory + 1) * memory),
      cosine_(memory), sine_(memory), g_(memory + 1), y_(memory), preconditioned_(size), sum_(size) {
    GASPARD_CHECK(memory >= 1);
}

void Gmres::begin(double norm) {
    for (double& value : basis(0)) value /= norm;
    std::fill(g_.begin(), g_.end(), 0.0);
    g_[0] = norm;
}

// Orthogonalises the newest vector against all others by modified Gram-Schmidt; returns its remaining norm.
double Gmres::orthogonalise(std::size_t k) {
    double* column = hessenberg_.data() + k * (memory_ + 1);
    double* __restrict newest = basis(k + 1).data();
    for (std::size_t j = 0; j <= k; ++j) {
        const double* other = basis(j).data();
        const double h = dot(basis(j), basis(k + 1));
        column[j] = h;
        for (std::size_t i = 0; i < size_; ++i) newest[i] -= h * other[i];
    }
    return std::sqrt(dot(basis(k + 1), basis(k + 1)));
}

// Adds a column to the Hessenberg matrix. False if the Krylov space is exhausted (breakdown).
bool Gmres::advance(std::size_t k) {
    constexpr double breakdown = 1e-14; // breakdown threshold, relative to the norm before orthogonalisation
    const double before = std::sqrt(dot(basis(k + 1), basis(k + 1)));
    const double left = orthogonalise(k);
    double* column = hessenberg_.data() + k * (memory_ + 1);
    for (std::size_t j = 0; j < k; ++j) {
        const double upper = column[j], lower = column[j + 1];
        column[j] = cosine_[j] * upper + sine_[j] * lower;
        column[j + 1] = -sine_[j] * upper + cosine_[j] * lower;
    }
    const double diagonal = std::hypot(column[k], left);
    cosine_[k] = diagonal == 0 ? 0 : column[k] / diagonal; // zero column: the residual stays
    sine_[k] = diagonal == 0 ? 1 : left / diagonal;
    column[k] = diagonal;
    g_[k + 1] = -sine_[k] * g_[k];
    g_[k] *= cosine_[k];
    if (!(left > breakdown * before)) return false;
    for (double& value : basis(k + 1)) value /= left;
    return true;
}

// Adds the combination of the first basis vectors that minimises the residual. A column with zero diagonal,
// where the operator is singular, does not contribute.
void Gmres::combine(std::size_t columns) {
    std::fill(sum_.begin(), sum_.end(), 0.0);
    for (std::size_t k = columns; k-- > 0;) {
        double value = g_[k];
        for (std::size_t j = k + 1; j < columns; ++j) value -= hessenberg_[j * (memory_ + 1) + k] * y_[j];
        const double diagonal = hessenberg_[k * (memory_ + 1) + k];
        y_[k] = diagonal != 0 ? value / diagonal : 0.0;
    }
    for (std::size_t k = 0; k < columns; ++k) {
        const double* vector = basis(k).data();
        for (std::size_t i = 0; i < size_; ++i) sum_[i] += y_[k] * vector[i];
    }
}

} // namespace gaspard

#include "core/method/patch_source.hpp"

#include <algorithm>

namespace gaspard {

namespace {

// J(xi) / J(Psi) is 1 / (the derivative of Psi across the edge) at an edge that is one point, and likewise at
// a corner where J = 0, since Psi keeps edges and corners. The weak boundary condition of the standard form
// keeps them up to an error only, so on coarse meshes a point near such an edge may come arbitrarily close to
// it: this bounds the ratio.
constexpr double least_element = 1e-3; // J(Psi), relative to J(xi)

} // namespace

template <std::size_t D>
class TensorSource<D>::Borrowed {
  public:
    explicit Borrowed(const TensorSource& of) : of_(of) {
        const std::lock_guard lock(of_.mutex_);
        if (of_.free_.empty()) {
            of_.free_.reserve(++of_.made_); // so that none is lost when all come back
            of_.free_.push_back(std::make_unique<Workspace>());
        }
        mine_ = std::move(of_.free_.back());
        of_.free_.pop_back();
    }
    ~Borrowed() {
        const std::lock_guard lock(of_.mutex_);
        of_.free_.push_back(std::move(mine_));
    }
    Borrowed(const Borrowed&) = delete;
    Borrowed& operator=(const Borrowed&) = delete;
    Workspace& operator*() const { return *mine_; }

  private:
    const TensorSource& of_;
    std::unique_ptr<Workspace> mine_;
};

template <std::size_t D>
TensorSource<D>::TensorSource(const Monitor& monitor, const TensorMap<D>& map, const SplineLine& line,
                              std::span<const double> elements)
    : monitor_(monitor), map_(map), elements_(elements), slab_(tensor_size<D - 1>(line.points.size())) {
    const Borrowed workspace(*this);
    std::vector<double> rho(slab_);
    double total = 0; // the integral of J
    for_each_slab<D>(line, [&](std::size_t s, const Points& xi, std::span<const double> weights) {
        densities(xi, rho, *workspace);
        double sum = 0, size = 0;
        if (elements_.empty())
            for (std::size_t i = 0; i < slab_; ++i) sum += weights[i] * rho[i];
        else
            for (std::size_t i = 0; i < slab_; ++i) {
                const double weight = weights[i] * elements_[s * slab_ + i];
                sum += weight * rho[i];
                size += weight;
            }
        sigma_ += line.weights[s] * sum;
        total += line.weights[s] * size;
    });
    if (!elements_.empty()) sigma_ /= total;
}

template <std::size_t D>
void TensorSource<D>::densities(const Points& psi, std::span<double> rho, Workspace& workspace) const {
    if (elements_.empty() && map_.is_identity()) return monitor_.values(psi, rho);
    if (elements_.empty()) {
        map_.points(psi, workspace.x);
    } else {
        workspace.element.resize(psi.size());
        map_.places(psi, workspace.x, workspace.element);
    }
    monitor_.values(workspace.x, rho);
}

template <std::size_t D>
void TensorSource<D>::sources(std::size_t y, std::span<double> f, const Workspace& workspace) const {
    if (elements_.empty()) {
        for (double& value : f) value = sigma_ / value;
        return;
    }
    const std::span<const double> before = elements_at(y, f.size());
    for (std::size_t i = 0; i < f.size(); ++i)
        f[i] = sigma_ * before[i] / (f[i] * std::max(workspace.element[i], least_element * before[i]));
}

template <std::size_t D>
void TensorSource<D>::values(std::size_t y, const Points& psi, std::span<double> f) const {
    const Borrowed workspace(*this);
    densities(psi, f, *workspace);
    sources(y, f, *workspace);
}

template <std::size_t D>
void TensorSource<D>::values(std::size_t y, const Points& psi, std::span<double> f,
                             std::span<double> rho) const {
    const Borrowed workspace(*this);
    densities(psi, rho, *workspace);
    std::copy(rho.begin(), rho.end(), f.begin());
    sources(y, f, *workspace);
}

template <std::size_t D>
void TensorSource<D>::gradients(std::size_t y, const Points& psi, std::span<double> f,
                                Points& gradient) const {
    const Borrowed borrowed(*this);
    auto& [x, slope, tangents, element] = *borrowed;
    densities(psi, f, *borrowed);
    sources(y, f, *borrowed);
    monitor_.gradients(elements_.empty() && map_.is_identity() ? psi : x, slope);
    map_.tangents(psi, tangents);
    gradient.resize(psi.size());
    /// factor grad rho, by the parameters
    const auto pulled_back = [&](std::size_t i, double factor) {
        Vec3 all{factor * dot(slope[i], tangents[0][i]), factor * dot(slope[i], tangents[1][i]), 0};
        if constexpr (D == 3) all.z = factor * dot(slope[i], tangents[2][i]);
        return all;
    };
    if (elements_.empty()) {
        for (std::size_t i = 0; i < psi.size(); ++i) // d(sigma / rho) = -f^2 / sigma drho
            gradient.set(i, pulled_back(i, -f[i] * f[i] / sigma_));
        return;
    }
    // df = -f (drho / rho + dJ / J), J = J(Psi)
    map_.element_gradients(psi, element, gradient);
    const std::span<const double> before = elements_at(y, f.size());
    for (std::size_t i = 0; i < psi.size(); ++i) {
        const bool bounded = !(element[i] > least_element * before[i]);
        const double here = bounded ? least_element * before[i] : element[i];
        const Vec3 turn = bounded ? Vec3{} : (-f[i] / here) * gradient[i];
        gradient.set(i, pulled_back(i, -f[i] * f[i] * here / (sigma_ * before[i])) + turn);
    }
}

template <std::size_t D>
std::vector<double> elements_of(const TensorMap<D>& map, const SplineLine& line) {
    const std::size_t n = line.points.size(), slab = tensor_size<D - 1>(n);
    std::vector<double> elements(n * slab);
    Points x;
    for_each_slab<D>(line, [&](std::size_t s, const Points& xi, std::span<const double>) {
        map.places(xi, x, std::span(elements).subspan(s * slab, slab));
    });
    return elements;
}

template class TensorSource<2>;
template class TensorSource<3>;
template std::vector<double> elements_of(const TensorMap<2>& map, const SplineLine& line);
template std::vector<double> elements_of(const TensorMap<3>& map, const SplineLine& line);

} // namespace gaspard

#include "core/fem/surface_elements.hpp"

#include "core/base/check.hpp"
#include "core/fem/exponential_map.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace gaspard {

namespace {

constexpr std::size_t batch = SurfaceElements::batch;
using Lanes = Eigen::Array<double, batch, 1>;

template <class Number>
struct Vector {
    Number x, y, z;
};

template <class Number>
Number product(const Vector<Number>& a, const Vector<Number>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Basis functions at the quadrature points: point q, node n at index q * nodes + n.
struct Table {
    std::size_t nodes = 0;
    std::vector<double> value, ds, dt;

    Table(CellKind kind, const std::vector<CellPoint>& points)
        : nodes(static_cast<std::size_t>(nodes_per_cell(kind))) {
        std::vector<double> values(nodes);
        std::vector<Vec3> gradients(nodes);
        for (const auto& point : points) {
            shape_functions(kind, point.point, values, gradients);
            for (std::size_t n = 0; n < nodes; ++n) {
                value.push_back(values[n]);
                ds.push_back(gradients[n].x);
                dt.push_back(gradients[n].y);
            }
        }
    }
};

double root(double a) { return std::sqrt(a); }
Lanes root(const Lanes& a) { // Eigen's sqrt is not correctly rounded on every machine
    Lanes result;
    for (Eigen::Index l = 0; l < Lanes::SizeAtCompileTime; ++l) result[l] = std::sqrt(a[l]);
    return result;
}

/// A quadrature point of a facet: position, surface gradients of the reference coordinates s and t, and the
/// area element times the weight.
template <class Number>
struct Place {
    Vector<Number> xi, grad_s, grad_t;
    Number area;
};

/// `nodes`: coordinates of the facet's nodes, x, y, z of the first, then of the second, ...
template <int count, class Number>
Place<Number> place_on_facet(const Number* nodes, const double* value, const double* ds, const double* dt,
                             double weight) {
    Vector<Number> xi, s, t;
    xi.x = value[0] * nodes[0], xi.y = value[0] * nodes[1], xi.z = value[0] * nodes[2];
    s.x = ds[0] * nodes[0], s.y = ds[0] * nodes[1], s.z = ds[0] * nodes[2];
    t.x = dt[0] * nodes[0], t.y = dt[0] * nodes[1], t.z = dt[0] * nodes[2];
    for (int n = 1; n < count; ++n) {
        const Number &x = nodes[3 * n], &y = nodes[3 * n + 1], &z = nodes[3 * n + 2];
        xi.x += value[n] * x, xi.y += value[n] * y, xi.z += value[n] * z;
        s.x += ds[n] * x, s.y += ds[n] * y, s.z += ds[n] * z;
        t.x += dt[n] * x, t.y += dt[n] * y, t.z += dt[n] * z;
    }
    const Number ss = product(s, s), st = product(s, t), tt = product(t, t);
    const Number determinant = ss * tt - st * st, inverse = 1 / determinant;
    const Number a = tt * inverse, b = st * inverse, c = ss * inverse;
    Place<Number> place;
    place.xi = xi;
    place.grad_s = {a * s.x - b * t.x, a * s.y - b * t.y, a * s.z - b * t.z};
    place.grad_t = {c * t.x - b * s.x, c * t.y - b * s.y, c * t.z - b * s.z};
    place.area = weight * root(determinant);
    return place;
}

/// `phi_nodes` basis functions of phi per cell, `facet_nodes` of the facet.
template <SurfaceShape shape, int phi_nodes, int facet_nodes>
class Elements final : public SurfaceElements {
  public:
    explicit Elements(SurfaceCells cells)
        : SurfaceElements(cells.phi.size() / phi_nodes), cells_of_(std::move(cells)),
          rule_(quadrature_of_degree_8(cells_of_.quadratic.shape)), phi_(cells_of_.quadratic, rule_),
          facet_(cells_of_.geometry, rule_),
          monitor_(cells_of_.monitor_at_corners ? CellKind{cells_of_.geometry.shape, 1} : cells_of_.geometry,
                   rule_) {
        facets_.resize(batches() * facet_nodes * 3);
        for (std::size_t b = 0; b < batches(); ++b)
            for (std::size_t l = 0; l < batch; ++l)
                for (std::size_t n = 0; n < facet_nodes; ++n) {
                    const Vec3 p = node(cell_of(b, l), n);
                    Lanes* at = &facets_[(b * facet_nodes + n) * 3];
                    at[0][static_cast<Eigen::Index>(l)] = p.x;
                    at[1][static_cast<Eigen::Index>(l)] = p.y;
                    at[2][static_cast<Eigen::Index>(l)] = p.z;
                }
    }

    void add_map_loads(std::size_t begin, std::size_t end, const double* phi, double* loads,
                       double* gradient_loads) const override {
        add_loads(begin, end, phi, nullptr, loads, gradient_loads);
    }
    void add_map_derivative(std::size_t begin, std::size_t end, const double* phi, const double* d_phi,
                            double* loads, double* gradient_loads) const override {
        add_loads(begin, end, phi, d_phi, loads, gradient_loads);
    }

    void add_residual(std::size_t begin, std::size_t end, const double* phi, const double* sigma,
                      const double* monitor, double* r) const override {
        for (std::size_t b = begin; b < end; ++b) {
            const AtNodes nodes = gather_all(b, {phi, sigma, monitor});
            Lanes density[max_points];
            for (std::size_t q = 0; q < rule_.size(); ++q) density[q] = density_at(b, q, nodes);
            add_tested(b, density, r);
        }
    }
    void add_residual_derivative(std::size_t begin, std::size_t end, const Fields& at,
                                 const Fields& direction, double* r) const override {
        for (std::size_t b = begin; b < end; ++b) {
            const AtNodes nodes = gather_all(b, at), d_nodes = gather_all(b, direction);
            Lanes density[max_points];
            for (std::size_t q = 0; q < rule_.size(); ++q)
                density[q] = density_derivative_at(b, q, nodes, d_nodes);
            add_tested(b, density, r);
        }
    }

    void mass(std::size_t cell, std::span<double> matrix) const override {
        product_matrix<phi_nodes>(
            cell, matrix, [&](const auto& place, std::size_t q, std::size_t a, std::size_t b) {
                return place.area * phi_.value[q * phi_nodes + a] * phi_.value[q * phi_nodes + b];
            });
    }
    void facet_mass(std::size_t cell, std::span<double> matrix) const override {
        product_matrix<facet_nodes>(
            cell, matrix, [&](const auto& place, std::size_t q, std::size_t a, std::size_t b) {
                return place.area * facet_.value[q * facet_nodes + a] * facet_.value[q * facet_nodes + b];
            });
    }
    void stiffness(std::size_t cell, std::span<double> matrix) const override {
        product_matrix<phi_nodes>(
            cell, matrix, [&](const auto& place, std::size_t q, std::size_t a, std::size_t b) {
                const double ss = product(place.grad_s, place.grad_s),
                             st = product(place.grad_s, place.grad_t),
                             tt = product(place.grad_t, place.grad_t);
                const double *s = &phi_.ds[q * phi_nodes], *t = &phi_.dt[q * phi_nodes];
                return place.area * (ss * s[a] * s[b] + st * (s[a] * t[b] + t[a] * s[b]) + tt * t[a] * t[b]);
            });
    }
    void weights(std::size_t cell, std::span<double> weights) const override {
        GASPARD_CHECK(weights.size() == phi_nodes);
        std::fill(weights.begin(), weights.end(), 0.0);
        for_places(cell, [&](const auto& place, std::size_t q) {
            for (std::size_t n = 0; n < phi_nodes; ++n)
                weights[n] += place.area * phi_.value[q * phi_nodes + n];
        });
    }

  private:
    static constexpr std::size_t max_points = 25;

    struct AtNodes { ///< of the cells of a batch
        Lanes phi[phi_nodes], sigma[phi_nodes * 9], monitor[facet_nodes];
    };
    struct Tensor {
        Lanes a[9]; ///< by rows
    };

    /// The cell in a lane of batch b; the last batch repeats the last cell.
    std::size_t cell_of(std::size_t b, std::size_t lane) const {
        return std::min(b * batch + lane, cells_ - 1);
    }
    std::size_t lanes_of(std::size_t b) const { return std::min(batch, cells_ - b * batch); }
    Vec3 node(std::size_t cell, std::size_t n) const {
        return cells_of_.places[static_cast<std::size_t>(cells_of_.nodes[cell * facet_nodes + n])];
    }

    void gather(std::size_t b, const double* from, Lanes* values) const {
        for (std::size_t l = 0; l < batch; ++l) {
            const std::int32_t* numbers = &cells_of_.phi[cell_of(b, l) * phi_nodes];
            for (std::size_t n = 0; n < phi_nodes; ++n)
                values[n][static_cast<Eigen::Index>(l)] = from[numbers[n]];
        }
    }
    void gather_rows(std::size_t b, const double* from, Lanes* values) const {
        for (std::size_t l = 0; l < batch; ++l) {
            const std::int32_t* numbers = &cells_of_.phi[cell_of(b, l) * phi_nodes];
            for (std::size_t n = 0; n < phi_nodes; ++n) {
                const double* row = from + static_cast<std::size_t>(numbers[n]) * 12;
                for (std::size_t c = 0; c < 9; ++c) values[9 * n + c][static_cast<Eigen::Index>(l)] = row[c];
            }
        }
    }
    template <int columns, int nodes>
    void scatter(std::size_t b, const Lanes* sums, const std::vector<std::int32_t>& numbers,
                 double* to) const {
        for (std::size_t l = 0; l < lanes_of(b); ++l)
            for (std::size_t n = 0; n < nodes; ++n) {
                double* row = to + static_cast<std::size_t>(numbers[cell_of(b, l) * nodes + n]) * columns;
                for (std::size_t c = 0; c < columns; ++c)
                    row[c] += sums[columns * n + c][static_cast<Eigen::Index>(l)];
            }
    }

    AtNodes gather_all(std::size_t b, const Fields& from) const {
        AtNodes nodes;
        gather(b, from.phi, nodes.phi);
        gather_rows(b, from.sigma, nodes.sigma);
        for (std::size_t l = 0; l < batch; ++l)
            for (std::size_t n = 0; n < monitor_.nodes; ++n)
                nodes.monitor[n][static_cast<Eigen::Index>(l)] =
                    from.monitor[cells_of_.nodes[cell_of(b, l) * facet_nodes + n]];
        return nodes;
    }
    void add_tested(std::size_t b, const Lanes* density, double* r) const {
        Lanes sums[phi_nodes];
        test_values<phi_nodes>(phi_, density, sums, 1, 1);
        scatter<1, phi_nodes>(b, sums, cells_of_.phi, r);
    }
    /// The map loads, or their derivative if d_phi is given.
    void add_loads(std::size_t begin, std::size_t end, const double* phi, const double* d_phi, double* loads,
                   double* gradient_loads) const {
        for (std::size_t b = begin; b < end; ++b) {
            Lanes flux[max_points * 18], gradient[max_points * 3];
            Lanes values[phi_nodes], d_values[phi_nodes];
            gather(b, phi, values);
            if (d_phi) gather(b, d_phi, d_values);
            for (std::size_t q = 0; q < rule_.size(); ++q)
                map_at(b, q, values, d_phi ? d_values : nullptr, flux + 18 * q, gradient + 3 * q);
            Lanes sums[phi_nodes * 12];
            for (std::size_t c = 0; c < 9; ++c) test_gradients(flux + 2 * c, sums + c);
            if constexpr (facet_nodes == phi_nodes) {
                for (std::size_t c = 0; c < 3; ++c)
                    test_values<phi_nodes>(phi_, gradient + c, sums + 9 + c, 12);
                scatter<12, phi_nodes>(b, sums, cells_of_.phi, loads);
            } else {
                for (std::size_t n = 0; n < phi_nodes; ++n)
                    for (std::size_t c = 9; c < 12; ++c) sums[12 * n + c].setZero();
                scatter<12, phi_nodes>(b, sums, cells_of_.phi, loads);
                for (std::size_t c = 0; c < 3; ++c)
                    test_values<facet_nodes>(facet_, gradient + c, sums + c, 4);
                for (std::size_t n = 0; n < facet_nodes; ++n) sums[4 * n + 3].setZero();
                scatter<4, facet_nodes>(b, sums, cells_of_.gradient, gradient_loads);
            }
        }
    }

    Place<Lanes> place_at(std::size_t b, std::size_t q) const {
        return place_on_facet<facet_nodes, Lanes>(&facets_[b * facet_nodes * 3],
                                                  &facet_.value[q * facet_nodes], &facet_.ds[q * facet_nodes],
                                                  &facet_.dt[q * facet_nodes], rule_[q].weight);
    }
    Vector<Lanes> gradient(const Place<Lanes>& place, std::size_t q, const Lanes* phi) const {
        const double *ds = &phi_.ds[q * phi_nodes], *dt = &phi_.dt[q * phi_nodes];
        Lanes s = ds[0] * phi[0], t = dt[0] * phi[0];
        for (std::size_t n = 1; n < phi_nodes; ++n) s += ds[n] * phi[n], t += dt[n] * phi[n];
        return {place.grad_s.x * s + place.grad_t.x * t, place.grad_s.y * s + place.grad_t.y * t,
                place.grad_s.z * s + place.grad_t.z * t};
    }
    static Vector<Lanes> moved(const Place<Lanes>& place, const Vector<Lanes>& g) {
        if constexpr (shape == SurfaceShape::flat) return g;
        const Lanes squared = product(g, g);
        const auto [cosine, sinc] = cosine_and_sinc<Lanes>(squared);
        return {cosine * place.xi.x + sinc * g.x, cosine * place.xi.y + sinc * g.y,
                cosine * place.xi.z + sinc * g.z};
    }

    /// The derivative of e in direction d of the gradient g.
    static Vector<Lanes> moved_derivative(const Place<Lanes>& place, const Vector<Lanes>& g,
                                          const Vector<Lanes>& d) {
        if constexpr (shape == SurfaceShape::flat) return d;
        const Lanes squared = product(g, g);
        const Lanes change = 2 * product(g, d);
        const auto [cosine, sinc] = cosine_and_sinc<Lanes>(squared);
        const Lanes d_cosine = -0.5 * sinc * change, d_sinc = sinc_slope<Lanes>(squared) * change;
        return {d_cosine * place.xi.x + d_sinc * g.x + sinc * d.x,
                d_cosine * place.xi.y + d_sinc * g.y + sinc * d.y,
                d_cosine * place.xi.z + d_sinc * g.z + sinc * d.z};
    }

    /// The factors of the derivatives of the test functions in the map loads, -e_i grad_j s and -e_i grad_j
    /// t, and the gradient; or, if d_phi is given, their derivatives.
    void map_at(std::size_t b, std::size_t q, const Lanes* phi, const Lanes* d_phi, Lanes* flux,
                Lanes* gradients) const {
        const Place<Lanes> place = place_at(b, q);
        Vector<Lanes> g = gradient(place, q, phi), e;
        if (d_phi) {
            const Vector<Lanes> d = gradient(place, q, d_phi);
            e = moved_derivative(place, g, d);
            g = d;
        } else {
            e = moved(place, g);
        }
        const Lanes along[3] = {e.x * place.area, e.y * place.area, e.z * place.area};
        for (std::size_t i = 0; i < 3; ++i) {
            flux[6 * i + 0] = along[i] * place.grad_s.x;
            flux[6 * i + 1] = along[i] * place.grad_t.x;
            flux[6 * i + 2] = along[i] * place.grad_s.y;
            flux[6 * i + 3] = along[i] * place.grad_t.y;
            flux[6 * i + 4] = along[i] * place.grad_s.z;
            flux[6 * i + 5] = along[i] * place.grad_t.z;
        }
        gradients[0] = g.x * place.area, gradients[1] = g.y * place.area, gradients[2] = g.z * place.area;
    }

    /// sigma P + e (x) k = sigma + (e - sigma k) (x) k on the sphere; sigma on a flat surface.
    Tensor tensor_at(const Place<Lanes>& place, std::size_t q, const Lanes* sigma,
                     const Vector<Lanes>& e_of_map) const {
        const double* value = &phi_.value[q * phi_nodes];
        Tensor tensor;
        Lanes* a = tensor.a;
        for (std::size_t c = 0; c < 9; ++c) a[c] = value[0] * sigma[c];
        for (std::size_t n = 1; n < phi_nodes; ++n)
            for (std::size_t c = 0; c < 9; ++c) a[c] += value[n] * sigma[9 * n + c];
        if constexpr (shape == SurfaceShape::unit_sphere) {
            const Vector<Lanes>& e = e_of_map;
            const Lanes inverse = 1 / root(product(place.xi, place.xi));
            const Vector<Lanes> k = {place.xi.x * inverse, place.xi.y * inverse, place.xi.z * inverse};
            const Lanes x = e.x - (a[0] * k.x + a[1] * k.y + a[2] * k.z);
            const Lanes y = e.y - (a[3] * k.x + a[4] * k.y + a[5] * k.z);
            const Lanes z = e.z - (a[6] * k.x + a[7] * k.y + a[8] * k.z);
            a[0] += x * k.x, a[1] += x * k.y, a[2] += x * k.z;
            a[3] += y * k.x, a[4] += y * k.y, a[5] += y * k.z;
            a[6] += z * k.x, a[7] += z * k.y, a[8] += z * k.z;
        }
        return tensor;
    }
    /// The tensor A.
    Tensor map_tensor_at(const Place<Lanes>& place, std::size_t q, const AtNodes& nodes,
                         const Vector<Lanes>& g) const {
        Tensor tensor = tensor_at(place, q, nodes.sigma, moved(place, g));
        if constexpr (shape == SurfaceShape::flat) tensor.a[0] += 1, tensor.a[4] += 1, tensor.a[8] += 1;
        return tensor;
    }
    Lanes monitor_at(std::size_t q, const AtNodes& nodes) const {
        const double* weight = &monitor_.value[q * monitor_.nodes];
        Lanes monitor = weight[0] * nodes.monitor[0];
        for (std::size_t n = 1; n < monitor_.nodes; ++n) monitor += weight[n] * nodes.monitor[n];
        return monitor;
    }

    /// m det A times the area element.
    Lanes density_at(std::size_t b, std::size_t q, const AtNodes& nodes) const {
        const Place<Lanes> place = place_at(b, q);
        const auto [a] = map_tensor_at(place, q, nodes, gradient(place, q, nodes.phi));
        return monitor_at(q, nodes) * place.area *
               (a[0] * (a[4] * a[8] - a[5] * a[7]) - a[1] * (a[3] * a[8] - a[5] * a[6]) +
                a[2] * (a[3] * a[7] - a[4] * a[6]));
    }
    /// dm det A + m cof A : dA, times the area element.
    Lanes density_derivative_at(std::size_t b, std::size_t q, const AtNodes& nodes,
                                const AtNodes& d_nodes) const {
        const Place<Lanes> place = place_at(b, q);
        const Vector<Lanes> g = gradient(place, q, nodes.phi);
        const auto [a] = map_tensor_at(place, q, nodes, g);
        const auto [d] =
            tensor_at(place, q, d_nodes.sigma, moved_derivative(place, g, gradient(place, q, d_nodes.phi)));
        const Lanes c0 = a[4] * a[8] - a[5] * a[7], c1 = a[5] * a[6] - a[3] * a[8],
                    c2 = a[3] * a[7] - a[4] * a[6];
        const Lanes determinant = a[0] * c0 + a[1] * c1 + a[2] * c2;
        Lanes change = c0 * d[0] + c1 * d[1] + c2 * d[2];
        change += (a[2] * a[7] - a[1] * a[8]) * d[3] + (a[0] * a[8] - a[2] * a[6]) * d[4] +
                  (a[1] * a[6] - a[0] * a[7]) * d[5];
        change += (a[1] * a[5] - a[2] * a[4]) * d[6] + (a[2] * a[3] - a[0] * a[5]) * d[7] +
                  (a[0] * a[4] - a[1] * a[3]) * d[8];
        return place.area * (monitor_at(q, d_nodes) * determinant + monitor_at(q, nodes) * change);
    }

    /// sums[12 n] = - integral of (d_s v_n flux_0 + d_t v_n flux_1); 18 fluxes per point.
    void test_gradients(const Lanes* flux, Lanes* sums) const {
        Lanes sum[phi_nodes];
        for (auto& one : sum) one.setZero();
        for (std::size_t q = 0; q < rule_.size(); ++q) {
            const Lanes s = flux[18 * q], t = flux[18 * q + 1];
            const double *ds = &phi_.ds[q * phi_nodes], *dt = &phi_.dt[q * phi_nodes];
            for (std::size_t n = 0; n < phi_nodes; ++n) sum[n] -= ds[n] * s + dt[n] * t;
        }
        for (std::size_t n = 0; n < phi_nodes; ++n) sums[12 * n] = sum[n];
    }
    /// sums[columns n] = integral of v_n f; `per_point` numbers per point.
    template <int nodes>
    void test_values(const Table& table, const Lanes* f, Lanes* sums, std::size_t columns,
                     std::size_t per_point = 3) const {
        Lanes sum[nodes];
        for (auto& one : sum) one.setZero();
        for (std::size_t q = 0; q < rule_.size(); ++q) {
            const Lanes at = f[per_point * q];
            const double* value = &table.value[q * nodes];
            for (std::size_t n = 0; n < nodes; ++n) sum[n] += value[n] * at;
        }
        for (std::size_t n = 0; n < nodes; ++n) sums[columns * n] = sum[n];
    }

    template <class Use>
    void for_places(std::size_t cell, const Use& use) const {
        double nodes[3 * facet_nodes];
        for (std::size_t n = 0; n < facet_nodes; ++n) {
            const Vec3 p = node(cell, n);
            nodes[3 * n] = p.x, nodes[3 * n + 1] = p.y, nodes[3 * n + 2] = p.z;
        }
        for (std::size_t q = 0; q < rule_.size(); ++q)
            use(place_on_facet<facet_nodes, double>(nodes, &facet_.value[q * facet_nodes],
                                                    &facet_.ds[q * facet_nodes], &facet_.dt[q * facet_nodes],
                                                    rule_[q].weight),
                q);
    }
    template <std::size_t nodes, class Entry>
    void product_matrix(std::size_t cell, std::span<double> matrix, const Entry& entry) const {
        GASPARD_CHECK(matrix.size() == nodes * nodes);
        std::fill(matrix.begin(), matrix.end(), 0.0);
        for_places(cell, [&](const Place<double>& place, std::size_t q) {
            for (std::size_t a = 0; a < nodes; ++a)
                for (std::size_t b = 0; b <= a; ++b) matrix[a * nodes + b] += entry(place, q, a, b);
        });
        for (std::size_t a = 0; a < nodes; ++a)
            for (std::size_t b = 0; b < a; ++b) matrix[b * nodes + a] = matrix[a * nodes + b];
    }

    SurfaceCells cells_of_;
    std::vector<CellPoint> rule_;
    Table phi_, facet_, monitor_;
    std::vector<Lanes> facets_; ///< nodes of the facets of each batch
};

template <SurfaceShape shape>
std::unique_ptr<SurfaceElements> make(SurfaceCells cells) {
    const bool triangles = cells.quadratic.shape == CellShape::triangle, curved = cells.geometry.order == 2;
    if (triangles && curved) return std::make_unique<Elements<shape, 6, 6>>(std::move(cells));
    if (triangles) return std::make_unique<Elements<shape, 6, 3>>(std::move(cells));
    if (curved) return std::make_unique<Elements<shape, 9, 9>>(std::move(cells));
    return std::make_unique<Elements<shape, 9, 4>>(std::move(cells));
}

} // namespace

std::unique_ptr<SurfaceElements> make_surface_elements(SurfaceCells cells) {
    GASPARD_CHECK(cells.quadratic.order == 2 && cells.quadratic.shape == cells.geometry.shape);
    GASPARD_CHECK(cells.quadratic.shape == CellShape::triangle ||
                  cells.quadratic.shape == CellShape::quadrilateral);
    return cells.shape == SurfaceShape::flat ? make<SurfaceShape::flat>(std::move(cells))
                                             : make<SurfaceShape::unit_sphere>(std::move(cells));
}

} // namespace gaspard

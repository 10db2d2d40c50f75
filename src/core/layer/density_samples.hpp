// Densities in the triangles of a crossed mesh (square_mesh_pde.hpp), from samples.
//
// The moments of a function m on a triangle T with the barycentric coordinates lambda_k are
//
//   M_k = (1 / |T|) integral over T of lambda_k m,   k = 0, 1, 2,
//
// by the rule of the samples. Their sum is the mean of m, and the moments of its slopes are the derivatives
// of the mean by the positions of the corners. Samples on edges are shared by the triangles there, and taken
// one row of quadrilaterals at a time, which stays in the cache.
#pragma once

#include "core/layer/square_mesh_pde.hpp"

#include <array>
#include <functional>
#include <vector>

namespace gaspard {

/// Corners of the four triangles of a quadrilateral: (0,0), (1,0), (0,1), (1,1), centre = 0..4.
constexpr std::array<std::array<std::size_t, 3>, 4> crossed_triangles = {
    {{0, 1, 4}, {1, 3, 4}, {3, 2, 4}, {2, 0, 4}}};

class DensitySampler {
  public:
    /// Of n x n quadrilaterals.
    DensitySampler(int n, DensitySamples samples);

    /// Means of both densities. Throws InputError where a
    /// density is not positive and finite.
    void means(const LayerDensities& densities, const Points& nodes, const Points& centres,
               TriangleDensities& means) const;

    /// Derivatives of the means by the positions of the corners, [axis][coordinate][4 q + t][corner], by
    /// differences. The shift is small beside the thinnest layer and large beside the spacing of numbers; it
    /// goes towards `middle`, so that it does not leave the domain.
    using Derivatives = std::array<std::array<std::vector<std::array<double, 3>>, 2>, 2>;
    Derivatives derivatives(const LayerDensities& densities, const Points& nodes, const Points& centres,
                            Vec3 middle) const;

  private:
    using Index = std::size_t;
    using Fields = std::vector<std::vector<double>>; ///< values at the samples of a row
    /// A sample that each quadrilateral of a row has: its weights of corners and centre.
    struct Place {
        std::array<double, 5> of{};
        Index first = 0, count = 0; ///< among the samples of a row
        Index below = 0;            ///< on upper sides: where the row above has it
    };
    struct Term {
        Index at; ///< the sample of the row's first quadrilateral
        std::array<double, 3> weights;
    };

    /// Of nodes, below and above a row of quadrilaterals.
    struct Rows {
        Index lower, upper;
    };
    using Evaluate = std::function<void(const Points& at, Fields& fields)>;

    Index place(const std::array<double, 5>& of);
    void put_points(const Points& nodes, const Points& centres, Rows rows, const Place& place, Index to,
                    Points& at) const;
    static void evaluate(const LayerDensities& densities, const Points& at, Fields& fields);
    /// Evaluates fields at the samples of every row, from below, and uses them.
    void sweep(const Points& nodes, const Points& centres, Index count, const Evaluate& evaluate,
               const std::function<void(Index row, const Fields&)>& use) const;

    Index n_;
    std::vector<Place> places_;              ///< evaluated in every row
    Index evaluated_ = 0;                    ///< number of samples of a row, without those of its lower side
    Index size_ = 0;                         ///< with them
    std::array<std::vector<Term>, 4> terms_; ///< by triangles
};

} // namespace gaspard

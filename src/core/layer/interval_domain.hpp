// The interval [a, b], divided into N lines; the computational mesh is uniform: xi_i = a + (b - a) i / N.
#pragma once

#include "core/layer/interval_mesh.hpp"
#include "core/mesh/discretisation.hpp"
#include "core/mesh/domain_type.hpp"

#include <memory>

namespace gaspard {

class IntervalDomain final : public Discretisation {
  public:
    IntervalDomain(Interval interval, int cells);

    std::shared_ptr<const Mesh> mesh() const override { return mesh_; }
    std::size_t unknowns() const override { return mesh_->node_count() - 2; }
    Interval interval() const { return interval_; }
    int cells() const { return static_cast<int>(mesh_->cell_count()); }

  private:
    Interval interval_;
    std::shared_ptr<const Mesh> mesh_;
};

DomainType interval_domain();
/// Throws InputError if the interval is empty.
std::shared_ptr<const IntervalDomain> make_interval(const Values& values);

} // namespace gaspard

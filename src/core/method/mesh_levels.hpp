// The order of solves of mesh PDEs: some on every mesh, from the coarsest to that of the run, where they go
// on until the method's criterion or a fixed number ends them (Hill, Madden 2021, Algorithms 1 to 3).
#pragma once

#include "core/method/method.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace gaspard {

class MeshLevels {
  public:
    /// Rows "refine", "start_cells", "inner_solves" and "final_solves", with defaults of the last three.
    static std::vector<ParameterRow> rows(int start_cells, int inner_solves, int final_solves);

    /// `even`: meshes are halved only while their number of cells is even. Throws InputError if the coarsest
    /// mesh would be finer than that of the run.
    void configure(const Values& values, int cells, bool even);

    /// The number of cells of a level; 0 is the mesh of the run.
    int cells(std::size_t level) const { return cells_[level]; }
    std::size_t coarsest() const { return cells_.size() - 1; }
    /// The level with this number of cells; 0 if there is none.
    std::size_t level_of(int cells) const;

    /// A state was given from outside.
    void begin() { fresh_ = true, solves_ = 0; }
    /// Before a step: the level on which it is made, from the present one. The first step from a mesh of the
    /// run goes back to the coarsest, so that results do not depend on where they start.
    std::size_t next(std::size_t level);
    /// After a solve on a level.
    Ending ending(std::size_t level);

  private:
    std::vector<int> cells_ = {1};
    int inner_ = 1, final_ = 0;
    int solves_ = 0; ///< on the present level
    bool fresh_ = false;
};

} // namespace gaspard

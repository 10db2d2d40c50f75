#include "core/linear/tensor_poisson.hpp"

#include "core/base/check.hpp"
#include "core/linear/transpose.hpp"

#include <algorithm>

namespace gaspard {

namespace {

constexpr std::size_t lines_at_once = LineSpectrum::lanes;

/// Calls work(worker, line) for the first line of every batch of eight. The last batch may overlap the one
/// before it; one worker handles both.
template <class Work>
void for_each_batch(Team& team, std::size_t lines, const Work& work) {
    const std::size_t whole = lines / lines_at_once;
    team.share(whole, [&](std::size_t worker, std::size_t begin, std::size_t end) {
        for (std::size_t batch = begin; batch < end; ++batch) work(worker, batch * lines_at_once);
        if (end == whole && begin < end && lines % lines_at_once != 0) work(worker, lines - lines_at_once);
    });
}

} // namespace

TensorPoisson::TensorPoisson(LineSpectrum line)
    : line_(std::move(line)), modal_(line_.cells(), line_.periodic(), line_.eigenvalues()) {
    GASPARD_CHECK(line_.size() >= lines_at_once);
}

TensorPoisson::Workspace TensorPoisson::make_workspace(std::size_t workers) const {
    const Workspace::Worker worker{line_.make_workspace(), ModalLines::make_workspace(),
                                   std::vector<double>(lines_at_once * line_.size())};
    return {std::vector<Workspace::Worker>(workers, worker),
            std::vector<double>(line_.size() * line_.size())};
}

// The mode that is constant in y: K u = b along x with mean of u = 0. It is the first column.
void TensorPoisson::solve_constant_mode(Workspace& workspace) const {
    const std::size_t n = line_.size();
    auto& [line, modal, batch] = workspace.workers.front();
    std::fill(batch.begin(), batch.end(), 0.0);
    for (std::size_t i = 0; i < n; ++i) batch[i * lines_at_once] = workspace.modes[i * n];
    line_.analyse(batch.data(), lines_at_once, batch.data(), line);
    batch[0] = 0;
    for (std::size_t i = 1; i < n; ++i) batch[i * lines_at_once] /= line_.eigenvalues()[i];
    line_.synthesise(batch.data(), batch.data(), lines_at_once, line);
    for (std::size_t i = 0; i < n; ++i) workspace.modes[i * n] = batch[i * lines_at_once];
}

void TensorPoisson::solve(const double* b, double* u, Workspace& workspace, Team& team) const {
    GASPARD_CHECK(workspace.workers.size() >= team.workers());
    const std::size_t n = line_.size();
    double* modes = workspace.modes.data();
    for_each_batch(team, n, [&](std::size_t worker, std::size_t x) {
        auto& [line, modal, batch] = workspace.workers[worker];
        line_.analyse(b + x, n, batch.data(), line);
        transpose(batch.data(), lines_at_once, modes + x * n, n, n, lines_at_once);
    });
    const std::size_t batches = (n - 1 + lines_at_once - 1) / lines_at_once;
    team.share(batches, [&](std::size_t worker, std::size_t begin, std::size_t end) {
        modal_.solve(modes, n, std::min(n, 1 + begin * lines_at_once), std::min(n, 1 + end * lines_at_once),
                     workspace.workers[worker].modal);
    });
    solve_constant_mode(workspace);
    for_each_batch(team, n, [&](std::size_t worker, std::size_t x) {
        auto& [line, modal, batch] = workspace.workers[worker];
        transpose(modes + x * n, n, batch.data(), lines_at_once, lines_at_once, n);
        line_.synthesise(batch.data(), u + x, n, line);
    });
}

} // namespace gaspard

#include "core/tessellate/coarse_tessellation.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <span>

namespace gaspard {

namespace {

/// The points of a face that is divided into a grid, read from its triangles in the order of tessellate().
class FaceGrid {
  public:
    FaceGrid(int corners, int cuts) : triangular_(corners == 3), cuts_(cuts) {
        points_.resize(static_cast<std::size_t>((cuts + 1) * (cuts + 1)));
    }

    std::size_t triangles() const {
        return static_cast<std::size_t>(cuts_) * static_cast<std::size_t>(cuts_) * (triangular_ ? 1 : 2);
    }

    /// False if triangles that should meet do not.
    bool read(std::span<const std::uint32_t> corners) {
        std::fill(points_.begin(), points_.end(), unread);
        const std::uint32_t* next = corners.data();
        bool agrees = true;
        const auto note = [&](int i, int j) {
            std::uint32_t& known = points_[index(i, j)];
            agrees = agrees && (known == unread || known == *next);
            known = *next++;
        };
        walk(
            1, [&](int i, int j) { note(i, j), note(i + 1, j), note(i, j + 1); },
            [&](int i, int j) { note(i + 1, j), note(i + 1, j + 1), note(i, j + 1); });
        return agrees;
    }

    /// Appends the triangles between every stride-th line.
    void put(int stride, std::uint32_t cell, Tessellation& out) const {
        const auto add = [&](std::initializer_list<std::uint32_t> corners) {
            out.triangles.insert(out.triangles.end(), corners);
            out.triangle_cells.push_back(cell);
        };
        const auto at = [&](int i, int j) { return points_[index(i, j)]; };
        const int s = stride;
        walk(
            s,
            [&](int i, int j) {
                add({at(i, j), at(i + s, j), at(i, j + s)});
            },
            [&](int i, int j) {
                add({at(i + s, j), at(i + s, j + s), at(i, j + s)});
            });
    }

  private:
    static constexpr std::uint32_t unread = 0xffffffff;

    std::size_t index(int i, int j) const { return static_cast<std::size_t>(j * (cuts_ + 1) + i); }
    /// Both halves of each square, in the order of tessellate(), for the lower corner (i, j).
    template <class Lower, class Upper>
    void walk(int stride, Lower lower, Upper upper) const {
        for (int j = 0; j < cuts_; j += stride)
            for (int i = 0; i < (triangular_ ? cuts_ - j : cuts_); i += stride) {
                lower(i, j);
                if (!triangular_ || i + stride < cuts_ - j) upper(i, j);
            }
    }

    bool triangular_;
    int cuts_;
    std::vector<std::uint32_t> points_;
};

/// The smallest divisor of `cuts` that leaves few enough triangles.
int stride_for(int cuts, std::size_t triangles, std::size_t most) {
    for (int stride = 1; stride < cuts; ++stride) {
        const auto fewer = static_cast<std::size_t>(stride) * static_cast<std::size_t>(stride);
        if (cuts % stride == 0 && triangles / fewer <= most) return stride;
    }
    return cuts;
}

bool put_faces(const Tessellation& fine, FaceGrid& grid, int stride, Tessellation& out) {
    const std::size_t each = grid.triangles();
    if (fine.triangle_cells.size() % each != 0) return false;
    for (std::size_t first = 0; first < fine.triangle_cells.size(); first += each) {
        const std::uint32_t cell = fine.triangle_cells[first];
        if (fine.triangle_cells[first + each - 1] != cell) return false;
        if (!grid.read(std::span(fine.triangles).subspan(3 * first, 3 * each))) return false;
        grid.put(stride, cell, out);
    }
    return true;
}

bool put_edges(const Tessellation& fine, int stride, Tessellation& out) {
    const auto step = 2 * static_cast<std::size_t>(stride);
    const auto& ends = fine.segments;
    if (ends.size() % (2 * static_cast<std::size_t>(fine.cuts)) != 0) return false;
    for (std::size_t i = 0; i < ends.size(); i += step) {
        for (std::size_t k = i + 2; k < i + step; k += 2)
            if (ends[k] != ends[k - 1]) return false;
        const std::size_t last = i + step - 2;
        out.segments.insert(out.segments.end(), {ends[i], ends[last + 1]});
        out.segment_sides.insert(out.segment_sides.end(),
                                 {fine.segment_sides[last], fine.segment_sides[last + 1]});
    }
    return true;
}

} // namespace

std::optional<Tessellation> coarsened(const Tessellation& fine, int face_corners,
                                      std::size_t most_triangles) {
    GASPARD_CHECK(face_corners == 3 || face_corners == 4);
    const int stride = stride_for(fine.cuts, fine.triangle_cells.size(), most_triangles);
    if (stride == 1 || fine.triangles.empty() || fine.base || fine.caps > 0) return std::nullopt;
    Tessellation coarse;
    coarse.point_count = fine.point_count;
    coarse.cuts = fine.cuts / stride;
    FaceGrid grid(face_corners, fine.cuts);
    if (!put_faces(fine, grid, stride, coarse) || !put_edges(fine, stride, coarse)) return std::nullopt;
    return coarse;
}

} // namespace gaspard

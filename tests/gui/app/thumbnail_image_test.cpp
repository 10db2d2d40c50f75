// The pictures of the scenarios show what the program draws.
#include "core/session/run.hpp"
#include "gui/app/thumbnails.hpp"
#include "gui/app/viewport_image.hpp"
#include "gui/similarity.hpp"
#include "support/solved_run.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

/// As scripts/thumbnails.sh draws it: at twice the size, then reduced.
Image drawn_thumbnail(const std::string& name, const std::vector<std::string>& settings = {}) {
    std::vector<std::string> all = {"view.layout=single", "view.theme=dark",    "view.background=theme",
                                    "view.legend=false",  "view.caption=false", "view.note=false",
                                    "view.axes=false"};
    all.insert(all.end(), settings.begin(), settings.end());
    gaspard::Run run = solved_run(name, all);
    const Image large =
        render_view(*run.snapshot(), run.scenario().view, 2 * thumbnail_width, 2 * thumbnail_height);
    Image small{thumbnail_width, thumbnail_height, {}};
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x)
            for (int c = 0; c < 4; ++c) {
                int sum = 2;
                for (const int corner : {0, 1, large.width, large.width + 1})
                    sum +=
                        large.rgba[static_cast<std::size_t>(4 * (2 * y * large.width + 2 * x + corner) + c)];
                small.rgba.push_back(static_cast<std::uint8_t>(sum / 4));
            }
    return small;
}

Similarity likeness(const std::string& name, const std::vector<std::string>& settings = {}) {
    return compare(decode_png(thumbnail_file(name), name), drawn_thumbnail(name, settings));
}

TEST(ThumbnailPicture, ShowsWhatTheProgramDraws) {
    for (const char* name : {"plane-ring", "sphere-x4", "spline-two-circles"}) {
        const Similarity same = likeness(name);
        EXPECT_LT(same.mean_difference, 6) << name;
        EXPECT_GT(same.mean_structure, 0.9) << name << ": scripts/thumbnails.sh draws it anew";
    }
}

TEST(ThumbnailPicture, AnotherMeshDoesNotLookLikeIt) {
    EXPECT_LT(likeness("plane-ring", {"monitor.radius=0.4", "monitor.center_x=0.3"}).mean_structure, 0.8);
}

} // namespace
} // namespace gaspard

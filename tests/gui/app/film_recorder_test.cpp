// What is told of a film that is cancelled, and when.
#include "core/io/film_files.hpp"
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"
#include "gui/app/film_recorder.hpp"
#include "support/temporary_folder.hpp"

#include <atomic>
#include <chrono>
#include <filesystem>
#include <gtest/gtest.h>
#include <semaphore>
#include <string>
#include <thread>
#include <vector>

namespace gaspard {
namespace {

using namespace std::chrono_literals;

/// A film of time steps, whose colours and camera are fitted to its meshes first.
FilmOrder film_of_time(const std::filesystem::path& file) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    Scenario scenario = find_scenario(*catalogue, "plane-ring");
    apply_settings(*catalogue, scenario,
                   {"domain.cells=8", "method.type=newton", "time.end=1", "time.step=0.1",
                    "time.monitor.center_x=center_x + t/10"});
    const auto recording = std::make_shared<Recording>(std::size_t{1} << 30);
    Run run(catalogue, scenario);
    recording->add(*run.snapshot());
    while (run.status() == RunStatus::running) {
        run.step();
        recording->add(*run.snapshot());
    }
    return {.plan = {.motions = {.time = true}},
            .format = parse_film_formats("csv").front(),
            .file = file,
            .scenario = scenario,
            .recording = recording,
            .last = run.snapshot()};
}

TEST(FilmRecorder, CanBeCancelledBeforeTheFirstFrame) {
    const TemporaryFolder folder;
    std::binary_semaphore reached(0), cancelled(0);
    std::atomic<int> calls = 0;
    const auto board = std::make_shared<NoticeBoard>([&] {
        if (++calls != 2) return;
        reached.release(); // the film's thread looks at the second mesh
        cancelled.acquire();
    });
    FilmRecorder all(board);
    all.begin(film_of_time(folder.path() / "film.csv"));
    const bool second = reached.try_acquire_for(10s);
    const std::string what = all.progress()->what;
    all.cancel();
    cancelled.release();
    ASSERT_TRUE(second);
    for (const auto end = std::chrono::steady_clock::now() + 10s;
         all.busy() && std::chrono::steady_clock::now() < end; std::this_thread::sleep_for(1ms))
        all.work();
    ASSERT_FALSE(all.busy());
    EXPECT_EQ(what, "film: fitting colours and camera");
    const std::vector<Notice> notices = board->take();
    ASSERT_EQ(notices.size(), 1U);
    EXPECT_EQ(notices[0].text, "Film cancelled; no file was written");
    EXPECT_EQ(calls, 3) << "the third is that of the notice";
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

} // namespace
} // namespace gaspard

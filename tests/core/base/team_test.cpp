#include "core/base/error.hpp"
#include "core/base/team.hpp"

#include <gtest/gtest.h>
#include <numeric>
#include <stdexcept>

namespace gaspard {
namespace {

TEST(Team, ProcessesEveryItemOncePerCall) {
    for (const std::size_t workers : {1, 2, 5}) {
        Team team(workers);
        EXPECT_EQ(team.workers(), workers);
        for (const std::size_t count : {0, 1, 4, 100, 3}) {
            std::vector<int> hits(count, 0), calls(workers, 0);
            team.share(count, [&](std::size_t worker, std::size_t begin, std::size_t end) {
                ++calls[worker];
                for (std::size_t i = begin; i < end; ++i) ++hits[i];
            });
            EXPECT_EQ(hits, std::vector<int>(count, 1));
            EXPECT_EQ(calls, std::vector<int>(workers, 1));
        }
    }
}

TEST(Team, RunsWorkersOnSeparateThreads) {
    Team team(3);
    std::vector<std::thread::id> ids(3);
    const auto note = [&](std::size_t worker, std::size_t, std::size_t) {
        ids[worker] = std::this_thread::get_id();
    };
    team.share(3, note);
    EXPECT_EQ(ids[0], std::this_thread::get_id());
    EXPECT_NE(ids[1], ids[0]);
    EXPECT_NE(ids[2], ids[1]);
    const auto before = ids;
    team.share(3, note);
    EXPECT_EQ(ids, before); // the same threads
}

TEST(Team, RethrowsAnExceptionAndStaysUsable) {
    Team team(3);
    for (const std::size_t culprit : {0, 1, 2}) {
        const auto fail = [&](std::size_t worker, std::size_t, std::size_t) {
            if (worker == culprit) throw std::runtime_error("no");
        };
        EXPECT_THROW(team.share(3, fail), std::runtime_error);
        std::vector<int> hits(9, 0);
        team.share(9, [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) ++hits[i];
        });
        EXPECT_EQ(std::accumulate(hits.begin(), hits.end(), 0), 9);
    }
}

TEST(Team, CountsTheTimeOfItsOtherWorkers) {
    Team alone, pair(2);
    const auto spend = [](std::size_t, std::size_t, std::size_t) {
        const Stopwatch watch;
        while (watch.cpu_seconds() < 0.02) {
        }
    };
    alone.share(2, spend);
    pair.share(2, spend);
    EXPECT_EQ(alone.other_cpu_seconds(), 0);
    EXPECT_GE(pair.other_cpu_seconds(), 0.02);
    EXPECT_LT(pair.other_cpu_seconds(), 0.04);
}

TEST(Team, NeedsAWorker) { EXPECT_THROW(Team(0), InternalError); }

} // namespace
} // namespace gaspard

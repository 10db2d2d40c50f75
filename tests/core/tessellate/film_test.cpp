// What the frames of films show.
#include "core/base/error.hpp"
#include "core/io/film_files.hpp"
#include "core/scenario/toml.hpp"
#include "core/scenario/view_rows.hpp"
#include "core/session/run.hpp"
#include "core/tessellate/camera.hpp"
#include "core/tessellate/colouring.hpp"
#include "core/tessellate/film.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gaspard {
namespace {

struct Solved {
    Scenario scenario;
    Recording recording{std::size_t{1} << 30};
    std::shared_ptr<const Snapshot> last;
};

Solved solved(const std::string& name, const std::vector<std::string>& settings) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    Solved result;
    result.scenario = find_scenario(*catalogue, name);
    apply_settings(*catalogue, result.scenario, settings);
    Run run(catalogue, result.scenario);
    result.recording.add(*run.snapshot());
    while (run.status() == RunStatus::running) {
        run.step();
        result.recording.add(*run.snapshot());
    }
    result.last = run.snapshot();
    return result;
}

Solved ring() { return solved("plane-ring", {"domain.cells=8", "method.type=auto"}); }
Solved sphere() { return solved("sphere-x2", {"domain.cells=4"}); }

TEST(Film, ShowsEveryIterateOnce) {
    const Solved run = ring();
    const Film film({.motions = {.iterations = true}}, run.recording, run.last, run.scenario.view);
    ASSERT_EQ(film.frames(), run.last->report.iteration + 1);
    for (int k = 0; k < film.frames(); ++k) EXPECT_EQ(film.iteration(k), k);
    EXPECT_EQ(film.frame(0).snapshot->x.x, run.last->mesh->nodes.x) << "begins with the uniform mesh";
    EXPECT_EQ(film.frame(film.frames() - 1).snapshot, run.last) << "in double precision";
    EXPECT_EQ(film.rate(), 10);
    EXPECT_EQ(film.hold(), 1);
}

TEST(Film, AxesOfAnIntervalCoverItsSoundMeshes) {
    const auto axes = [](bool tangled, bool sound_too) {
        const Solved run = solved("layer-1d", {"domain.cells=8"});
        Recording recording{std::size_t{1} << 30};
        Snapshot snapshot = *run.last;
        for (int i = sound_too ? 0 : 1; i < 2; ++i) {
            snapshot.report.iteration = i, snapshot.version = static_cast<std::uint64_t>(i) + 1;
            snapshot.report.tangled_cells = i == 1 && tangled ? 1 : 0;
            if (i == 1) snapshot.x.x[1] = 1e-9; // a very narrow cell
            recording.add(snapshot);
        }
        const Film film({.motions = {.iterations = true}}, recording,
                        std::make_shared<const Snapshot>(snapshot), run.scenario.view);
        return film.frame(0).axes.at(0).spacing.low;
    };
    EXPECT_LT(axes(false, true), -9);
    EXPECT_GT(axes(true, true), -8) << "a tangled mesh does not count";
    EXPECT_LT(axes(true, false), -9) << "but where there is no other";
}

TEST(Film, OfARunThatEndsEarlyHasEachTimeOnce) {
    for (const double last : {0.0, 0.1}) { // before the first time step, or later
        const Solved run = solved("plane-ring", {"domain.cells=8", "method.type=newton",
                                                 "monitor.type=formula", "time.end=0.2", "time.step=0.05",
                                                 "monitor.expression=1 + x*(1-x)*(1+t) + (t > " +
                                                     std::to_string(last + 0.01) + " ? log(x-0.3) : 0)"});
        ASSERT_EQ(run.last->report.status, RunStatus::invalid_input);
        const Film film({.motions = {.time = true}}, run.recording, run.last, run.scenario.view);
        std::vector<double> times;
        for (int k = 0; k < film.frames(); ++k) times.push_back(film.moment(k));
        EXPECT_EQ(times, last == 0 ? std::vector<double>{0} : (std::vector<double>{0, 0.05, 0.1}));
    }
}

TEST(Film, SpreadsIteratesOverTheFramesThatAreAskedFor) {
    const Solved run = ring();
    const int last = run.last->report.iteration;
    for (const int frames : {1, 2, 3, 100}) {
        const Film film({.motions = {.iterations = true}, .frames = frames}, run.recording, run.last,
                        run.scenario.view);
        EXPECT_EQ(film.frames(), frames);
        EXPECT_EQ(film.iteration(frames - 1), last);
        EXPECT_EQ(film.iteration(0), frames > 1 ? 0 : last);
        for (int k = 1; k < frames; ++k) EXPECT_GE(film.iteration(k), film.iteration(k - 1));
    }
}

TEST(Film, HasOnlyTheIteratesThatAreAskedFor) {
    const Solved run = ring();
    const int end = run.last->report.iteration;
    const Film part({.first = 1, .last = 3}, run.recording, run.last, run.scenario.view);
    ASSERT_EQ(part.frames(), 3);
    EXPECT_EQ(part.iteration(0), 1);
    EXPECT_EQ(part.iteration(2), 3);
    EXPECT_EQ(part.frame(2).snapshot->report.iteration, 3);
    const Film rest({.first = 2}, run.recording, run.last, run.scenario.view);
    EXPECT_EQ(rest.frames(), end - 1);
    EXPECT_EQ(rest.frame(rest.frames() - 1).snapshot, run.last) << "in double precision";
    EXPECT_EQ(part.frame(0).view.real("high"), rest.frame(0).view.real("high")) << "of the whole recording";
    const Film still({.motions = {.blend = true}, .last = 2}, run.recording, run.last, run.scenario.view);
    EXPECT_EQ(still.frame(7).snapshot->report.iteration, 2);
    EXPECT_EQ(film_iterations({.first = 3, .last = 5}, {{0, 2, 4, 8}}), (std::vector<int>{4}));
    EXPECT_EQ(film_iterations({.first = 5, .last = 7}, {{0, 2, 4, 8}}), (std::vector<int>{4}));
    EXPECT_EQ(film_iterations({.last = 0}, {{2, 4}}), (std::vector<int>{2}));
    EXPECT_THROW(film_iterations({.first = 9}, {{0, 2, 4, 8}}), InputError);
    EXPECT_THROW(check_film({.first = 3, .last = 2}, *run.last->mesh, run.scenario.view), InputError);
}

TEST(Film, IsAsLongAsItsPlanSays) {
    EXPECT_EQ(film_length({}, 28).frames, 28);
    EXPECT_EQ(film_length({}, 28).rate, 10);
    EXPECT_EQ(film_length({.rate = 50}, 28).frames, 28);
    EXPECT_EQ(film_length({.motions = {.blend = true}, .rate = 50}, 28).frames, 300) << "six seconds";
    EXPECT_EQ(film_length({.frames = 7}, 28).frames, 7);
    EXPECT_THROW(film_length({}, most_film_frames + 1), InputError);
}

TEST(Film, HoldsTheRangeOfTheColours) {
    const Solved run = ring();
    const Film film({.motions = {.iterations = true}}, run.recording, run.last, run.scenario.view);
    const Values first = film.frame(0).view, last = film.frame(film.frames() - 1).view;
    EXPECT_EQ(first.text("range"), "fixed");
    EXPECT_EQ(first.real("low"), last.real("low"));
    EXPECT_EQ(first.real("high"), last.real("high"));
    EXPECT_LT(first.real("low"), 1.2);
    EXPECT_GT(first.real("high"), 5);
}

TEST(Film, TheRangeLeavesOutWhatIsTangled) {
    const Solved run = ring();
    Recording recording(std::size_t{1} << 30);
    EXPECT_EQ(last_sound(recording), nullptr);
    for (int k = 0; k < 4; ++k) {
        Snapshot snapshot = *run.last;
        snapshot.report.iteration = k;
        snapshot.report.tangled_cells = k < 2 ? 0 : 5;
        snapshot.version = static_cast<std::uint64_t>(100 + k);
        for (Field& field : snapshot.fields)
            if (field.name == "monitor")
                for (double& value : field.values) value *= k < 2 ? 1 + k : 1000;
        recording.add(snapshot);
        EXPECT_EQ(last_sound(recording)->iteration(), std::min(k, 1));
    }
    const ColourChoice choice = colour_choice(run.scenario.view);
    const auto range = range_of_recording(recording, nullptr, choice);
    const auto of_one = make_colouring(*run.last, choice)->range;
    ASSERT_TRUE(range);
    EXPECT_NEAR(range->low, of_one.low, 1e-6 * of_one.high);
    EXPECT_NEAR(range->high, 2 * of_one.high, 1e-6 * of_one.high)
        << "of the iterate before the first tangled one";
}

TEST(Film, OfTimeHasOneRangeForAllOfItsMeshes) {
    // The mesh rests at the start and at the end, and is fastest in between.
    const Solved run = solved(
        "plane-ring", {"domain.cells=8", "method.type=newton", "time.end=2", "time.step=0.1",
                       "time.monitor.center_x=center_x + 0.1*(1 - cos(pi*t))", "view.color=mesh_speed"});
    const Film film({.motions = {.time = true}}, run.recording, run.last, run.scenario.view);
    double fastest = 0;
    for (int k = 0; k < film.frames(); ++k)
        fastest = std::max(
            fastest, make_colouring(*film.frame(k).snapshot, colour_choice(run.scenario.view))->range.high);
    const ColourChoice choice = colour_choice(run.scenario.view);
    ASSERT_GT(fastest, 2 * make_colouring(*run.last, choice)->range.high);
    for (int k = 0; k < film.frames(); ++k) {
        EXPECT_EQ(film.frame(k).view.text("range"), "fixed");
        EXPECT_EQ(film.frame(k).view.real("high"), fastest) << "none is beyond";
        EXPECT_EQ(film.frame(k).view.real("low"), 0) << "the first mesh rests";
    }
    const Film part({.motions = {.time = true}, .last = film.iteration(3)}, run.recording, run.last,
                    run.scenario.view);
    EXPECT_LT(part.frame(0).view.real("high"), 0.8 * fastest) << "of those that are shown";
    Values own = run.scenario.view;
    own.set("range", std::string("fixed")), own.set("high", 7.0);
    EXPECT_EQ(Film({.motions = {.time = true}}, run.recording, run.last, own).frame(2).view.real("high"), 7);
}

/// A film of time, and its recording with the monitor of the last mesh but one a thousand times as large;
/// that mesh, or all, are tangled.
struct TangledTime {
    explicit TangledTime(bool all) {
        end = run.last->report.iteration;
        for (const int k : run.recording.iterations()) {
            Snapshot snapshot = *run.recording.at(k)->restore();
            const bool large = k == end - 1;
            snapshot.report.tangled_cells = all || large ? 3 : 0;
            for (Field& field : snapshot.fields)
                if (field.name == "monitor" && large)
                    for (double& value : field.values) value *= 1000;
            recording.add(snapshot);
        }
    }
    Film film(std::optional<int> first = {}, std::optional<int> last = {}) const {
        return {{.motions = {.time = true}, .first = first, .last = last},
                recording,
                run.last,
                run.scenario.view};
    }

    Solved run = solved("plane-ring", {"domain.cells=8", "method.type=newton", "time.end=1", "time.step=0.25",
                                       "time.monitor.center_x=center_x + t/10"});
    Recording recording{std::size_t{1} << 30};
    int end = 0;
};

TEST(Film, OfTimeTheRangeLeavesOutWhatIsTangled) {
    const TangledTime one(false);
    EXPECT_LT(one.film().frame(0).view.real("high"), 100);
    EXPECT_GT(one.film(one.end - 1, one.end - 1).frame(0).view.real("high"), 1000) << "it shows nothing else";
}

TEST(Film, OfTangledMeshesAloneTheRangeCoversAll) {
    const TangledTime all(true);
    const Film film = all.film(all.end - 2, all.end - 1);
    ASSERT_EQ(film.frames(), 2);
    EXPECT_LT(film.frame(0).view.real("low"), 10) << "of the first one";
    EXPECT_GT(film.frame(0).view.real("high"), 1000) << "of the second one";
}

TEST(Film, OfTimeLooksAtEachMeshOnceUntilItIsStopped) {
    const Solved run = solved("plane-ring", {"domain.cells=8", "method.type=newton", "time.end=1",
                                             "time.step=0.1", "time.monitor.center_x=center_x + t/10"});
    std::vector<double> done;
    std::size_t most = 1000;
    std::stop_source source;
    const auto make = [&] {
        return Film(
            {.motions = {.time = true}}, run.recording, run.last, run.scenario.view,
            [&](double part, std::string_view) {
                done.push_back(part);
                if (done.size() == most) source.request_stop();
            },
            source.get_token());
    };
    EXPECT_EQ(make().frames(), 11);
    ASSERT_EQ(done.size(), 11U) << "for the camera and the colours together";
    EXPECT_TRUE(std::ranges::is_sorted(done));
    EXPECT_GE(done.front(), 0);
    EXPECT_LT(done.back(), 1);
    done.clear(), most = 3;
    EXPECT_THROW(make(), Interrupted);
    EXPECT_EQ(done.size(), 3U);
}

TEST(Film, GoesToTheAdaptedMeshAndBack) {
    const Solved run = ring();
    const Film film({.motions = {.blend = true}, .frames = 8}, run.recording, run.last, run.scenario.view);
    EXPECT_EQ(film.frame(0).view.real("blend"), 0);
    EXPECT_EQ(film.frame(4).view.real("blend"), 1);
    EXPECT_NEAR(film.frame(2).view.real("blend"), film.frame(6).view.real("blend"), 1e-12);
    EXPECT_GT(film.frame(7).view.real("blend"), 0) << "the next one is the first again";
    EXPECT_EQ(film.hold(), 0);
    EXPECT_EQ(Film({.motions = {.blend = true}}, run.recording, run.last, run.scenario.view).frames(), 150);
}

TEST(Film, TurnsOnceRoundTheVerticalAxis) {
    const Solved run = sphere();
    const Film film({.motions = {.turn = true}, .frames = 4}, run.recording, run.last, run.scenario.view);
    const Size size{static_cast<double>(run.scenario.view.integer("width")),
                    static_cast<double>(run.scenario.view.integer("height"))};
    std::vector<Vec3> towards;
    for (int k = 0; k < 4; ++k) {
        const std::string text = film.frame(k).view.text("camera");
        EXPECT_TRUE(shows_all(text)) << "a ball is equally large from all sides";
        towards.push_back(towards_viewer(parse_camera(text, size)));
    }
    for (int k = 0; k < 4; ++k) {
        EXPECT_NEAR(towards[static_cast<std::size_t>(k)].z, towards[0].z, 1e-9);
        const Vec3 a = towards[static_cast<std::size_t>(k)],
                   b = towards[static_cast<std::size_t>((k + 1) % 4)];
        EXPECT_NEAR(a.x * b.x + a.y * b.y, 0, 1e-9) << "a quarter of a turn";
    }
}

TEST(Film, SeesAllOfWhatTurnsInOneSize) {
    const Solved run = solved("spline-half-torus", {"domain.cells=4", "method.max_iterations=1"});
    const Film film({.motions = {.turn = true}, .frames = 16}, run.recording, run.last, run.scenario.view);
    const Size size{static_cast<double>(run.scenario.view.integer("width")),
                    static_cast<double>(run.scenario.view.integer("height"))};
    double scale = 0, highest = 0;
    for (int k = 0; k < 16; ++k) {
        const Camera camera = parse_camera(film.frame(k).view.text("camera"), size);
        scale = k == 0 ? camera.scale : scale;
        EXPECT_NEAR(camera.scale, scale, 1e-9 * scale);
        const Points& nodes = run.last->mesh->nodes;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const Pixel at = to_pixel(camera, size, nodes[i]);
            ASSERT_TRUE(at.x > 0 && at.x < 0.85 * size.width && at.y > 0 && at.y < 0.95 * size.height)
                << "left of the legend, above the caption";
            highest = std::max(highest, at.y);
        }
    }
    EXPECT_GT(highest, 0.6 * size.height) << "no smaller than it need be";
}

TEST(Film, GoesFromOneViewToAnother) {
    const Solved run = sphere();
    const FilmPlan plan{.motions = {.camera = true},
                        .frames = 3,
                        .from = "centre 0 0 0 height 4 right 0 1 0 up 0 0 1",
                        .to = "centre 0 0 1 height 1 right -1 0 0 up 0 0 1"};
    check_film(plan, *run.last->mesh, run.scenario.view);
    const Film film(plan, run.recording, run.last, run.scenario.view);
    const Size size{static_cast<double>(run.scenario.view.integer("width")),
                    static_cast<double>(run.scenario.view.integer("height"))};
    EXPECT_EQ(film.frame(0).view.text("camera"), format_camera(parse_camera(plan.from, size), size));
    EXPECT_EQ(film.frame(2).view.text("camera"), format_camera(parse_camera(plan.to, size), size));
    const Camera middle = parse_camera(film.frame(1).view.text("camera"), size);
    EXPECT_NEAR(middle.scale * size.height, 2, 1e-6) << "the geometric mean";
    EXPECT_NEAR(middle.centre.z, 0.5, 1e-9);
    EXPECT_NEAR(middle.right.x, -std::sqrt(0.5), 1e-9);
}

TEST(Film, OfTimeHoldsItsCamera) {
    const std::vector<std::string> moving{"domain.cells=8", "method.type=newton", "time.end=1",
                                          "time.step=0.25", "time.monitor.center_x=center_x + 0.4*sin(pi*t)"};
    const Solved run = solved("plane-ring", moving);
    const Film film({.motions = {.time = true}}, run.recording, run.last, run.scenario.view);
    const std::string camera = film.frame(0).view.text("camera");
    ASSERT_FALSE(camera.empty());
    const Size size{static_cast<double>(run.scenario.view.integer("width")),
                    static_cast<double>(run.scenario.view.integer("height"))};
    const Camera shown = parse_camera(camera, size);
    for (int k = 0; k < film.frames(); ++k) {
        const FilmFrame frame = film.frame(k);
        EXPECT_EQ(frame.view.text("camera"), camera);
        for (std::size_t i = 0; i < frame.snapshot->x.size(); ++i) { // all of every mesh is in sight
            const Vec3 from_centre = frame.snapshot->x[i] - shown.centre;
            EXPECT_LT(std::abs(from_centre.x) / shown.scale, size.width / 2);
            EXPECT_LT(std::abs(from_centre.y) / shown.scale, size.height / 2);
        }
    }
    const Film last_alone({.motions = {.time = true}, .first = run.last->report.iteration}, run.recording,
                          run.last, run.scenario.view);
    EXPECT_NE(last_alone.frame(0).view.text("camera"), camera) << "the ring has come back";
    Values own = run.scenario.view;
    own.set("camera", std::string("centre 0.5 0.5 height 1.2"));
    const Film chosen({.motions = {.time = true}}, run.recording, run.last, own);
    EXPECT_EQ(chosen.frame(1).view.text("camera"), "centre 0.5 0.5 height 1.2");
    const Film of_iterates({.motions = {.iterations = true}}, run.recording, run.last, run.scenario.view);
    EXPECT_EQ(of_iterates.frame(0).view.text("camera"), "");
}

TEST(Film, OfTimeBeginsWithTheSolvedMesh) {
    const Solved run = solved("plane-ring", {"domain.cells=8", "method.type=newton", "time.start=2",
                                             "time.end=3", "time.step=0.25", "time.monitor.center_x=t/10"});
    const Film film({.motions = {.time = true}}, run.recording, run.last, run.scenario.view);
    ASSERT_EQ(film.frames(), 5);
    for (int k = 0; k < 5; ++k) EXPECT_NEAR(film.moment(k), 2 + 0.25 * k, 1e-12);
    EXPECT_GT(film.iteration(0), 1) << "not with the solve";
    EXPECT_EQ(film.frame(4).snapshot, run.last);
    EXPECT_EQ(film.rate(), 25);
    const Film of_iterates({.motions = {.iterations = true}}, run.recording, run.last, run.scenario.view);
    EXPECT_EQ(of_iterates.frames(), run.last->report.iteration + 1);
    EXPECT_EQ(of_iterates.moment(1), 1);
    const Solved still = ring();
    EXPECT_THROW(Film({.motions = {.time = true}}, still.recording, still.last, still.scenario.view),
                 InputError);
    EXPECT_EQ(usual_motion(run.scenario), "time");
    EXPECT_EQ(usual_motion(still.scenario), "iterations");
    EXPECT_THROW(parse_film_motions("time,iterations"), InputError);
    EXPECT_TRUE(parse_film_motions("time,turn").time);
}

/// So that a film goes on whatever its part is called.
TEST(Film, IsRecordedByItsFramesRatherThanItsOptions) {
    const Solved run = solved("plane-ring", {"domain.cells=8", "method.type=newton", "time.end=1",
                                             "time.step=0.25", "time.monitor.center_x=t/10"});
    const auto record = [&](FilmPlan plan) {
        plan.motions = {.time = true};
        return film_record(run.scenario, plan, Film(plan, run.recording, run.last, run.scenario.view));
    };
    EXPECT_EQ(record({.from_time = 0, .to_time = 0.5}), record({.to_time = 0.5}));
    EXPECT_NE(record({.from_time = 0.25, .to_time = 0.5}), record({.to_time = 0.5}));
    EXPECT_NE(record({.from_time = 0.25, .to_time = 0.5}), record({.to_time = 0.25})) << "as many frames";
    FilmPlan turn{.frames = 10, .to_time = 0.5}, part = turn;
    part.from_time = 0.25;
    EXPECT_NE(record(part), record(turn)) << "with the same last one";
}

TEST(Film, OfTimeIsFromOneTimeToAnother) {
    const Solved run = solved("plane-ring", {"domain.cells=8", "method.type=newton", "time.start=2",
                                             "time.end=3", "time.step=0.25", "time.monitor.center_x=t/10"});
    const auto times = [&](std::optional<double> from, std::optional<double> to) {
        const Film film({.motions = {.time = true}, .from_time = from, .to_time = to}, run.recording,
                        run.last, run.scenario.view);
        std::vector<double> all;
        for (int k = 0; k < film.frames(); ++k) all.push_back(film.moment(k));
        return all;
    };
    using Times = std::vector<double>;
    EXPECT_EQ(times(2.25, 2.75), (Times{2.25, 2.5, 2.75}));
    EXPECT_EQ(times({}, 2.25), (Times{2, 2.25}));
    EXPECT_EQ(times(2.6, {}), (Times{2.5, 2.75, 3})) << "the nearest mesh";
    EXPECT_EQ(times(2.51, 2.52), (Times{2.5}));
    EXPECT_EQ(times(2, 3), times({}, {}));
    for (const auto& [from, to] : {std::pair(3.5, 4.0), {0.0, 1.0}}) try {
            times(from, to);
            ADD_FAILURE() << from;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find("t = 2 to 3"), std::string::npos) << error.what();
        }
    const auto refused = [&](const FilmPlan& plan) {
        EXPECT_THROW(check_film(plan, *run.last->mesh, run.scenario.view), InputError);
    };
    refused({.motions = {.iterations = true}, .from_time = 2});
    refused({.motions = {.time = true}, .from_time = 2.5, .to_time = 2.25});
    refused({.motions = {.time = true}, .first = 3, .from_time = 2.5});
    refused({.motions = {.time = true}, .last = 3, .to_time = 2.5});
}

TEST(Film, RefusesWhatMakesNoSense) {
    EXPECT_EQ(parse_film_motions("iterations,turn"), (FilmMotions{.iterations = true, .turn = true}));
    for (const char* list : {"", "spin", "turn,camera", "turn,,blend"})
        EXPECT_THROW(parse_film_motions(list), InputError) << list;
    const Solved run = ring();
    const auto refused = [&](const FilmPlan& plan) {
        EXPECT_THROW(check_film(plan, *run.last->mesh, run.scenario.view), InputError);
    };
    refused({.motions = {.turn = true}});
    refused({.motions = {.camera = true}});
    refused({.motions = {.iterations = true}, .from = "centre 0 0 height 1"});
    refused({.motions = {.camera = true}, .from = "centre 0 0 height 1", .to = "right 1 0 0 up 0 1 0"});
    refused({.motions = {.camera = true},
             .from = "centre 0 0 0 height 1",
             .to = "centre 0 0 0 height 1 right 0 1 0 up 0 0 1"});
    const Solved ball = sphere();
    EXPECT_THROW(check_film({.motions = {.camera = true},
                             .from = "centre 0 0 0 height 1 right 1 0 0 up 0 0 1",
                             .to = "centre 0 0 0 height 1 right -1 0 0 up 0 0 1"},
                            *ball.last->mesh, ball.scenario.view),
                 InputError)
        << "from opposite sides";
}

} // namespace
} // namespace gaspard

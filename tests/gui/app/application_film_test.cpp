// Films that are recorded from the window, as by a user.
#include "core/base/read_file.hpp"
#include "core/io/film_files.hpp"
#include "core/io/image.hpp"
#include "core/session/run.hpp"
#include "gui/app/viewport_image.hpp"
#include "gui/file_dialogs_fixture.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

namespace gaspard {
namespace {

namespace fs = std::filesystem;

class FilmFromWindowTest : public FileDialogsTest {
  protected:
    void SetUp() override {
        Scenario few = small_ring(); // iterates
        apply_settings(*catalogue, few, {"method.type=auto"});
        application.document().replace(run().id, few);
        ASSERT_TRUE(wait_until([&] { return run().openings > 0; }));
        ASSERT_TRUE(wait_until([&] { return run().ended() && !application.views().empty(); }));
        look().set("width", std::int64_t{160}), look().set("height", std::int64_t{120});
    }
    void choose_format(const std::string& name) {
        click("film.format");
        click("film.format=" + name);
    }
    void begin(const std::string& format, const std::string& name) {
        if (!shows("film.ok")) click("action.record-film");
        choose_format(format);
        fill("film.file", (folder / name).string());
        click("film.ok");
    }
    bool saved(const std::string& name, int frames) {
        return says("Film saved: " + (folder / name).string() + ", " + std::to_string(frames) + " frames");
    }
    int iterates() { return static_cast<int>(run().recording->iterations().size()); }
    std::vector<std::string> files(const fs::path& in) {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(in))
            names.push_back(entry.path().filename().string());
        std::sort(names.begin(), names.end());
        return names;
    }
    Image frame_of(const std::string& film, int k) {
        return read_image(frame_file(folder / film / "frames", k, ".png"));
    }
    Scenario shown_scenario() {
        Scenario scenario = run().scenario;
        scenario.view = look();
        return scenario;
    }
    /// What `gaspard record` films: it solves again.
    Film film_again(const FilmPlan& plan) {
        const Scenario scenario = shown_scenario();
        gaspard::Run solve(catalogue, scenario);
        Recording recording(std::size_t{1} << 30);
        recording.add(*solve.snapshot());
        while (solve.status() == RunStatus::running) {
            solve.step();
            recording.add(*solve.snapshot());
        }
        return {plan, recording, solve.snapshot(), scenario.view};
    }
    /// And draws: every frame by itself.
    std::vector<Image> recorded_again(const FilmPlan& plan) {
        const Scenario scenario = shown_scenario();
        const Film film = film_again(plan);
        std::vector<Image> images;
        for (int k = 0; k < film.frames(); ++k) {
            const FilmFrame frame = film.frame(k);
            images.push_back(render_view(*frame.snapshot, frame.view, 160, 120, scenario_title(scenario)));
        }
        return images;
    }
};

TEST_F(FilmFromWindowTest, FramesAreThoseOfTheCommand) {
    begin("png", "ring");
    ASSERT_TRUE(saved("ring", iterates())) << said();
    const std::vector<Image> expected = recorded_again({});
    ASSERT_EQ(static_cast<int>(expected.size()), iterates());
    ASSERT_EQ(static_cast<int>(files(folder / "ring" / "frames").size()), iterates());
    for (int k = 0; k < iterates(); ++k)
        EXPECT_EQ(frame_of("ring", k).rgba, expected[static_cast<std::size_t>(k)].rgba) << k;
    EXPECT_NE(frame_of("ring", 0).rgba, frame_of("ring", 3).rgba);
    EXPECT_EQ(read_file(folder / "ring" / "film.json"), film_record(shown_scenario(), {}, film_again({})))
        << "the command can go on with it";
}

TEST_F(FilmFromWindowTest, TheChosenMotionSizeAndLengthAreThose) {
    click("action.record-film");
    click("film.motion=iterations");
    click("film.motion=blend");
    fill("film.width", "200");
    fill("film.height", "100");
    fill("film.rate", "20");
    fill("film.seconds", "0.5");
    click("film.legend");
    begin("png", "blend");
    ASSERT_TRUE(saved("blend", 10)) << said();
    EXPECT_EQ(look().integer("width"), 200) << "a script draws the same";
    EXPECT_FALSE(look().boolean("legend"));
    EXPECT_EQ(frame_of("blend", 0).width, 200);
    EXPECT_EQ(frame_of("blend", 0).height, 100);
    Values view = look();
    view.set("blend", 1.0);
    EXPECT_EQ(frame_of("blend", 5).rgba,
              render_view(*run().snapshot, view, 200, 100, scenario_title(run().scenario)).rgba);
}

TEST_F(FilmFromWindowTest, OnlySomeIteratesInOneFile) {
    click("action.record-film");
    fill("film.first", "1");
    fill("film.last", "3");
    const fs::path killed = folder / ".gaspard-999999999-film-0.tmp"; // what a film of no process has left
    fs::create_directories(killed / "frames");
    std::ofstream(killed / "frames" / "00000.png") << "killed";
    begin("apng", "part");
    ASSERT_TRUE(saved("part.apng", 3)) << said();
    EXPECT_EQ(read_image(folder / "part.apng").width, 160);
    EXPECT_EQ(files(folder), (std::vector<std::string>{"part.apng"})) << "no frames are left beside it";
}

TEST_F(FilmFromWindowTest, AFilmOfTimeIsChosenByTimes) {
    Scenario moving = small_ring();
    apply_settings(*catalogue, moving,
                   {"method.type=newton", "time.end=1", "time.step=0.1",
                    "time.monitor.center_x=center_x + t/9", "view.color=mesh_speed", "view.width=160",
                    "view.height=120"});
    const auto before = run().openings;
    application.document().replace(run().id, moving);
    ASSERT_TRUE(wait_until([&] { return run().openings > before && run().ended(); }));
    click("action.record-film");
    EXPECT_FALSE(shows("film.first")) << "rows of the history say nothing";
    fill("film.from-time", "0.3");
    fill("film.to-time", "1.5");
    click("film.ok");
    EXPECT_TRUE(shows("film.ok")) << "there is no such time";
    fill("film.to-time", "0.7");
    begin("png", "part");
    ASSERT_TRUE(saved("part", 5)) << said();
    const FilmPlan plan{.motions = {.time = true}, .from_time = 0.3, .to_time = 0.7};
    const std::vector<Image> expected = recorded_again(plan);
    ASSERT_EQ(expected.size(), 5U);
    for (int k = 0; k < 5; ++k)
        EXPECT_EQ(frame_of("part", k).rgba, expected[static_cast<std::size_t>(k)].rgba)
            << "with one range of colours, as of the command: " << k;
    EXPECT_EQ(read_file(folder / "part" / "film.json"),
              film_record(shown_scenario(), plan, film_again(plan)));
}

TEST_F(FilmFromWindowTest, FilesOfTheMesh) {
    begin("csv", "nodes");
    ASSERT_TRUE(saved("nodes.csv", iterates())) << said();
    EXPECT_TRUE(read_file(folder / "nodes.csv").starts_with("frame,iteration,node,x,y\n"));
    begin("pvd", "series");
    ASSERT_TRUE(saved("series", iterates())) << said();
    EXPECT_EQ(files(folder / "series"), (std::vector<std::string>{"film.json", "mesh", "mesh.pvd"}));
    begin("glb", "moving");
    ASSERT_TRUE(saved("moving.glb", iterates())) << said();
    EXPECT_TRUE(read_file(folder / "moving.glb").starts_with("glTF"));
    EXPECT_EQ(files(folder).size(), 3U);
}

/// PATH, for as long as this lives.
class OtherPath {
  public:
    explicit OtherPath(const std::string& path) { ::setenv("PATH", path.c_str(), 1); }
    ~OtherPath() { ::setenv("PATH", before_.c_str(), 1); }
    OtherPath(const OtherPath&) = delete;
    OtherPath& operator=(const OtherPath&) = delete;

  private:
    std::string before_ = std::getenv("PATH");
};

TEST_F(FilmFromWindowTest, AVideoIsMadeOfTheFrames) {
    TemporaryFolder tools; // a program of that name which notes what it is asked for
    const fs::path tool = tools.path() / "ffmpeg";
    std::ofstream(tool) << "#!/bin/sh\nfor last; do :; done\necho \"$@\" > \"${last#file:}\"\n";
    fs::permissions(tool, fs::perms::owner_all);
    const OtherPath path(tools.path().string() + ":/usr/bin:/bin");
    begin("mp4", "video");
    ASSERT_TRUE(saved("video.mp4", iterates())) << said();
    const std::string words = read_file(folder / "video.mp4");
    EXPECT_NE(words.find("-framerate 10 "), std::string::npos) << words;
    EXPECT_NE(words.find("-frames:v " + std::to_string(iterates() + 10) + " "), std::string::npos) << words;
    EXPECT_EQ(files(folder), (std::vector<std::string>{"video.mp4"}));
}

TEST_F(FilmFromWindowTest, ReplacesNothingUnlessAsked) {
    std::ofstream(folder / "mine.csv") << "mine";
    begin("csv", "mine");
    EXPECT_TRUE(shows("film.ok")) << "to replace a file has to be confirmed";
    EXPECT_EQ(read_file(folder / "mine.csv"), "mine");
    click("film.ok");
    ASSERT_TRUE(saved("mine.csv", iterates())) << said();
    EXPECT_TRUE(read_file(folder / "mine.csv").starts_with("frame,"));

    fs::create_directories(folder / "ours" / "frames");
    std::ofstream(folder / "ours" / "frames" / "00000.png") << "ours";
    begin("png", "ours");
    EXPECT_TRUE(shows("film.ok")) << "so has a folder with frames";
    EXPECT_EQ(read_file(folder / "ours" / "frames" / "00000.png"), "ours");
    click("film.cancel");
    EXPECT_FALSE(shows("film.ok"));
    EXPECT_EQ(read_file(folder / "ours" / "frames" / "00000.png"), "ours");
}

TEST_F(FilmFromWindowTest, AFolderIsNotReplacedByAFile) {
    fs::create_directories(folder / "mine.csv" / "inner");
    begin("csv", "mine");
    click("film.ok"); // agrees
    ASSERT_TRUE(wait_until([&] { return application.messages().error().open(); }));
    EXPECT_EQ(application.messages().error().sentence(),
              (folder / "mine.csv").string() + " is a folder; choose another name");
    EXPECT_TRUE(fs::exists(folder / "mine.csv" / "inner"));
    EXPECT_EQ(files(folder).size(), 1U);
}

TEST_F(FilmFromWindowTest, TheBrowserChoosesTheFile) {
    click("action.record-film");
    choose_format("csv");
    click("film.browse");
    EXPECT_FALSE(shows("film.ok")) << "the browser comes first";
    fill("image.path", (folder / "browsed").string());
    click("image.ok");
    click("film.ok");
    ASSERT_TRUE(saved("browsed.csv", iterates())) << said();
}

TEST_F(FilmFromWindowTest, TheWindowGoesOnAndTheFilmIsThatOfItsBeginning) {
    click("action.record-film");
    click("film.motion=iterations");
    click("film.motion=blend");
    const std::string title = scenario_title(run().scenario);
    const auto snapshot = run().snapshot;
    Values view = look();
    view.set("blend", 1.0);
    fill("film.seconds", "1.2");
    begin("png", "meanwhile");
    ASSERT_TRUE(wait_until([&] { return shows("film-progress"); }));
    EXPECT_FALSE(application.press_key("Ctrl+Shift+P")) << "one film at a time";
    Scenario other = run().scenario;
    set_value(*catalogue, other, "monitor.amplitude", 3.0);
    application.document().change(run().id, other);
    ASSERT_TRUE(wait_until([&] { return run().changes.settled() && run().snapshot != snapshot; }));
    EXPECT_TRUE(shows("film-progress")) << "solved while the film is made";
    look().set("camera", std::string("centre 0.2 0.3 height 0.1"));
    int frames_meanwhile = 0;
    ASSERT_TRUE(wait_until([&] {
        ++frames_meanwhile;
        return said() == "Film saved: " + (folder / "meanwhile").string() + ", 30 frames";
    })) << said();
    EXPECT_GT(frames_meanwhile, 20);
    frames(2);
    EXPECT_FALSE(shows("film-progress"));
    EXPECT_EQ(frame_of("meanwhile", 15).rgba, render_view(*snapshot, view, 160, 120, title).rgba);
}

TEST_F(FilmFromWindowTest, ACancelledFileIsNotThere) {
    click("action.record-film");
    fill("film.seconds", "60");
    begin("apng", "deep/long"); // in a folder that is not there yet
    ASSERT_TRUE(wait_until([&] { return shows("film-progress.cancel"); }));
    click("film-progress.cancel");
    ASSERT_TRUE(says("Film cancelled; no file was written")) << said();
    EXPECT_TRUE(files(folder).empty()) << files(folder).front();
    EXPECT_TRUE(wait_until([&] { return !shows("film-progress"); }));
}

TEST_F(FilmFromWindowTest, EscapeCancelsASequenceAndItsFramesAreComplete) {
    click("action.record-film");
    fill("film.seconds", "60");
    begin("png", "long");
    ASSERT_TRUE(wait_until([&] { return fs::exists(folder / "long" / "frames" / "00002.png"); }));
    look().set("pick", std::string("cell 3"));
    frame();
    ASSERT_TRUE(application.press_key("Escape"));
    EXPECT_TRUE(look().text("pick").empty());
    frames(3);
    EXPECT_TRUE(shows("film-progress")) << "the pick comes first";
    ASSERT_TRUE(application.press_key("Escape"));
    ASSERT_TRUE(says("Film cancelled; the files that are in " + (folder / "long").string() + " are complete"))
        << said();
    for (const std::string& name : files(folder / "long" / "frames"))
        EXPECT_EQ(read_image(folder / "long" / "frames" / name).width, 160) << name;
    EXPECT_TRUE(fs::exists(folder / "long" / "film.json"));
}

TEST_F(FilmFromWindowTest, ClosingTheWindowLeavesNothingUnfinished) {
    {
        Application other(catalogue, small_ring(), {.output = {folder}});
        const auto draw = [&] {
            other.collect();
            ui.frame([&] { other.frame(); });
        };
        while (!other.document().active().ended()) draw();
        other.perform("record-film");
        for (int i = 0; i < 5; ++i) draw();
        const auto field = other.items().find("film.seconds")->second;
        ui.double_click(field, [&] { other.frame(); });
        ui.type("60", [&] { other.frame(); });
        ui.click(other.items().find("film.ok")->second, [&] { other.frame(); });
        for (int i = 0; i < 20; ++i) draw();
        EXPECT_EQ(other.items().count("film-progress"), 1U);
    }
    EXPECT_TRUE(files(folder).empty()) << "nor the folder plane-ring";
}

TEST_F(FilmFromWindowTest, WhatCannotBeFilmedIsSaid) {
    click("action.record-film");
    click("film.motion=turn");
    choose_format("csv");
    click("film.motion=iterations"); // none is left: a turn does not suit a mesh in the plane
    fill("film.file", (folder / "none").string());
    click("film.ok");
    EXPECT_TRUE(shows("film.ok")) << "no motion is chosen";
    click("film.motion=blend");
    click("film.ok");
    EXPECT_TRUE(shows("film.ok")) << "a table has the iterates of a solve";
    choose_format("apng");
    fill("film.width", "10");
    click("film.ok");
    EXPECT_TRUE(shows("film.ok")) << "10 pixels are too few";
    EXPECT_TRUE(files(folder).empty());
}

TEST_F(FilmFromWindowTest, TheCameraGoesFromACopiedViewToThePresentOne) {
    ImGui::SetClipboardText("centre 0 0 height 0.2");
    look().set("camera", std::string("centre 0.1 0.1 height 0.4"));
    frames(2);
    click("action.record-film");
    click("film.motion=iterations");
    click("film.motion=camera");
    fill("film.seconds", "0.2");
    begin("png", "way");
    ASSERT_TRUE(saved("way", 5)) << said();
    Values view = look();
    for (const auto& [k, camera] :
         {std::pair(0, "centre 0 0 height 0.2"), {4, "centre 0.1 0.1 height 0.4"}}) {
        view.set("camera", std::string(camera));
        EXPECT_EQ(frame_of("way", k).rgba,
                  render_view(*run().snapshot, view, 160, 120, scenario_title(run().scenario)).rgba)
            << k;
    }
}

TEST_F(FilmFromWindowTest, AFrameIsTheSameInEveryKindOfView) {
    struct Kind {
        const char* name;
        std::vector<std::string> settings;
    };
    for (const Kind& kind :
         {Kind{"spline-cube",
               {"domain.cells=4", "view.cut=normal 1 1 0.3 at 0.5 0.5 0.5", "view.layout=side-by-side"}},
          Kind{"sphere-x2", {"view.layout=projection", "view.contours=5"}},
          Kind{"layer-1d", {"view.width=480", "view.height=360"}},
          Kind{"plane-bell", {"view.elevation=1", "view.arrows=true", "view.color=interpolation_error"}}}) {
        Scenario scenario = find_scenario(*catalogue, kind.name);
        apply_settings(*catalogue, scenario, {"domain.cells=8", "view.width=160", "view.height=120"});
        apply_settings(*catalogue, scenario, kind.settings);
        const auto before = run().openings;
        application.document().replace(run().id, scenario);
        ASSERT_TRUE(wait_until([&] { return run().openings > before && run().ended(); })) << kind.name;
        const bool plots = run().snapshot->mesh->space_dimension == 1; // whose axes are those of all frames
        const FilmPlan plan{.first = plots ? 0 : last_iteration(run()) - 1};
        click("action.record-film");
        fill("film.first", std::to_string(*plan.first));
        begin("png", kind.name);
        ASSERT_TRUE(saved(kind.name, last_iteration(run()) - *plan.first + 1)) << said();
        const Film film(plan, *run().recording, run().snapshot, look());
        for (int k = 0; k < film.frames(); ++k) {
            const FilmFrame frame = film.frame(k);
            const auto planner = std::make_shared<ViewportPlanner>();
            planner->prepare(frame);
            EXPECT_EQ(frame_of(kind.name, k).rgba,
                      render_view(*frame.snapshot, frame.view, static_cast<int>(frame.view.integer("width")),
                                  static_cast<int>(frame.view.integer("height")), scenario_title(scenario),
                                  {.planner = planner})
                          .rgba)
                << kind.name << " " << k;
        }
    }
}

TEST(FilmDialogTest, FilesOfMeshesHaveNoRateAndNoLength) {
    const auto catalogue = std::make_shared<Catalogue>(builtin_catalogue());
    const Scenario scenario = find_scenario(*catalogue, "plane-ring");
    HeadlessUi ui;
    ItemRectangles items;
    FilmDialog dialog;
    gaspard::Run solve(catalogue, scenario);
    dialog.show({{{0, 1, 2, 3}}, 2, solve.snapshot()->mesh, "", ""}, scenario.view, "/nowhere/film");
    const auto draw = [&] { dialog.draw(items); };
    const auto type = [&](const std::string& field, const std::string& text) {
        ui.replace_text(items.at(field), text, draw);
        ui.key(ImGuiKey_Tab, true), ui.frame(draw), ui.key(ImGuiKey_Tab, false), ui.frame(draw);
    };
    const auto choose = [&](const std::string& format) {
        ui.click(items.at("film.format"), draw);
        ui.frame(draw);
        ui.click(items.at("film.format=" + format), draw);
        ui.frame(draw);
    };
    for (int i = 0; i < 3; ++i) ui.frame(draw);
    type("film.rate", "20");
    type("film.seconds", "1");
    EXPECT_EQ(dialog.estimate(), "20 frames, 1 s, and 1 s more at the end");
    for (const char* format : {"pvd", "csv"}) {
        choose(format);
        EXPECT_EQ(dialog.estimate(), "4 meshes") << format;
        type("film.seconds", "3"); // it is grey
        type("film.rate", "5");
        EXPECT_EQ(dialog.estimate(), "4 meshes") << format;
        EXPECT_EQ(dialog.problem(), "");
    }
    choose("glb"); // an animation
    EXPECT_EQ(dialog.estimate(), "20 frames, 1 s, and 1 s more at the end") << "what was typed before";
}

TEST(FilmDialogTest, AFormatWithoutItsProgramSaysHowToGetIt) {
    const OtherPath path("/nowhere");
    const auto catalogue = std::make_shared<Catalogue>(builtin_catalogue());
    const Scenario scenario = find_scenario(*catalogue, "plane-ring");
    HeadlessUi ui;
    ItemRectangles items;
    FilmDialog dialog;
    gaspard::Run solve(catalogue, scenario);
    dialog.show({{{0, 1, 2}}, 2, solve.snapshot()->mesh, "", ""}, scenario.view, "/nowhere/film");
    const auto draw = [&] { dialog.draw(items); };
    for (int i = 0; i < 3; ++i) ui.frame(draw);
    EXPECT_EQ(dialog.problem(), "");
    EXPECT_EQ(dialog.estimate(), "3 frames, 0.3 s, and 1 s more at the end");
    ui.click(items.at("film.format"), draw);
    ui.frame(draw);
    ui.click(items.at("film.format=mp4"), draw);
    ui.frame(draw);
    EXPECT_NE(dialog.problem().find("apt install ffmpeg"), std::string::npos) << dialog.problem();
    EXPECT_EQ(dialog.file(), "/nowhere/film.mp4");
}

} // namespace
} // namespace gaspard

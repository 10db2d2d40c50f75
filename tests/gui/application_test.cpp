#include "core/base/error.hpp"
#include "core/scenario/toml.hpp"
#include "gui/application.hpp"
#include "gui/headless_ui.hpp"
#include "gui/status_bar.hpp"
#include "support/temporary_folder.hpp"

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <future>
#include <gtest/gtest.h>
#include <random>
#include <thread>

namespace gaspard {
namespace {

constexpr auto patience = std::chrono::seconds(60);

class ApplicationTest : public testing::Test {
  protected:
    Scenario small_ring() const {
        Scenario scenario = find_scenario(*catalogue, "plane-ring");
        set_value(*catalogue, scenario, "domain.cells", std::int64_t{12});
        return scenario;
    }
    void frame() {
        application.collect();
        ui.frame([this] { application.frame(); });
    }
    std::function<void()> drawing() {
        return [this] {
            application.collect();
            application.frame();
        };
    }
    template <class Condition>
    bool wait_until(Condition condition) {
        const auto end = std::chrono::steady_clock::now() + patience;
        while (std::chrono::steady_clock::now() < end) {
            frame();
            if (condition()) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        return false;
    }
    DocumentRun& run() { return application.document().runs().front(); }
    /// What the solver thread itself works with.
    Scenario solved_scenario() {
        const auto seen = std::make_shared<std::promise<Scenario>>(); // outlives a test that gave up waiting
        auto answer = seen->get_future();
        run().solver->post(InspectCommand{
            [seen](gaspard::Run& solved, const Activity&) { seen->set_value(solved.scenario()); }});
        if (wait_until([&] { return answer.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }))
            return answer.get();
        ADD_FAILURE() << "the solver does not answer";
        return {};
    }

    TemporaryFolder temporary; ///< gone after the application has ended
    const std::filesystem::path folder = temporary.path();
    HeadlessUi ui;
    std::shared_ptr<const Catalogue> catalogue = std::make_shared<Catalogue>(builtin_catalogue());
    Application application{catalogue, small_ring(), {.output = folder}};
};

TEST_F(ApplicationTest, EveryPartHasItsPlaceInTheWindow) {
    for (const auto& [width, height] : {std::pair{1400.0F, 900.0F}, {900.0F, 600.0F}, {640.0F, 480.0F}}) {
        ImGui::GetIO().DisplaySize = {width, height};
        frame();
        frame();
        for (const char* key :
             {"action.run", "action.step", "action.reset", "action.home", "action.screenshot",
              "action.export", "scenario", "monitor.type", "monitor.amplitude", "viewport", "plot.first",
              "plot.second", "status.0", "message"}) {
            ASSERT_TRUE(application.items().count(key)) << key;
            const ItemRectangle& item = application.items().find(key)->second;
            EXPECT_GT(item.width(), 10) << key << " at " << width;
            EXPECT_GE(item.left, 0) << key;
            EXPECT_LE(item.right, width + 1) << key << " at " << width;
        }
        EXPECT_GT(application.viewport_rectangle().height(), 100);
    }
}

TEST_F(ApplicationTest, ADraggedSliderReachesTheSolver) {
    ASSERT_TRUE(wait_until([&] { return run().history.size() > 3; }));
    const double before = solved_scenario().monitor.values.real("amplitude");
    ui.drag(application.items().find("monitor.amplitude")->second, 0.4F, 0.6F, drawing());
    const double shown = run().scenario.monitor.values.real("amplitude");
    EXPECT_GT(shown, before);
    EXPECT_EQ(solved_scenario().monitor.values.real("amplitude"), shown);
}

TEST_F(ApplicationTest, SpacePausesAndGoesOnOncePerPress) {
    ASSERT_TRUE(wait_until([&] { return run().history.size() > 3; }));
    EXPECT_TRUE(application.press_key("Space"));
    ASSERT_TRUE(wait_until([&] { return run().status.paused; }));
    const auto count = run().history.size();
    frame();
    EXPECT_EQ(run().history.size(), count);
    EXPECT_TRUE(application.press_key("N"));
    ASSERT_TRUE(wait_until([&] { return run().history.size() == count + 1; }));
    EXPECT_TRUE(application.press_key("Space"));
    ASSERT_TRUE(wait_until([&] { return run().history.size() > count + 5; }));
    EXPECT_FALSE(application.press_key("Ctrl+J"));
}

TEST_F(ApplicationTest, KeysAreNotShortcutsWhileTyping) {
    frame();
    ui.click(application.items().find("monitor.amplitude.input")->second, drawing());
    ASSERT_TRUE(ImGui::GetIO().WantTextInput);
    EXPECT_FALSE(application.press_key("Ctrl+Q"));
    EXPECT_FALSE(application.quit_requested());
    ui.click(application.items().find("viewport")->second, drawing());
    frame();
    EXPECT_TRUE(application.press_key("Ctrl+Q"));
    EXPECT_TRUE(application.quit_requested());
}

TEST_F(ApplicationTest, ButtonsDoWhatKeysDo) {
    ASSERT_TRUE(wait_until([&] { return run().history.size() > 3; }));
    ui.click(application.items().find("action.run")->second, drawing());
    EXPECT_FALSE(run().wants_to_run);
    ASSERT_TRUE(wait_until([&] { return run().status.paused; }));
    ui.click(application.items().find("action.reset")->second, drawing());
    ASSERT_TRUE(wait_until([&] { return run().history.size() == 1; }));
    ui.click(application.items().find("action.screenshot")->second, drawing());
    bool taken = application.take_screenshot_request();
    for (int frame = 0; frame < 3 && !taken; ++frame) {
        ui.frame(drawing());
        taken = application.take_screenshot_request();
    }
    EXPECT_TRUE(taken);
    EXPECT_FALSE(application.take_screenshot_request());
}

TEST_F(ApplicationTest, AnEndedRunRunsAgain) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    const int last = run().history.back().iteration;
    EXPECT_FALSE(application.press_key("N")) << "there is no step beyond the end";
    EXPECT_TRUE(application.press_key("Space"));
    ASSERT_TRUE(wait_until([&] { return !run().ended(); }));
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    EXPECT_EQ(run().history.back().iteration, last);
}

TEST_F(ApplicationTest, ExportWritesTheFilesAndSaysSo) {
    ASSERT_TRUE(wait_until([&] { return run().history.size() > 3; }));
    EXPECT_TRUE(application.press_key("E"));
    ASSERT_TRUE(wait_until([&] { return application.message().text.starts_with("Exported to "); }))
        << application.message().text;
    for (const char* file : {"summary.json", "history.csv", "state.bin", "adapted.obj", "adapted.glb"})
        EXPECT_TRUE(std::filesystem::exists(folder / "plane-ring" / file)) << file;
}

TEST_F(ApplicationTest, AnExportThatFailsIsASentence) {
    std::filesystem::remove_all(folder);
    std::ofstream(folder) << "a file where a folder should be";
    application.perform(ActionId::export_files);
    ASSERT_TRUE(wait_until([&] { return application.message().error; }));
    EXPECT_NE(application.message().text.find(folder.string()), std::string::npos)
        << application.message().text;
}

TEST_F(ApplicationTest, PicturesAreNumbered) {
    const Image image{2, 2, std::vector<std::uint8_t>(16, 200)};
    for (const char* name : {"view.png", "view-2.png", "view-3.png"}) {
        application.save_picture(image);
        const auto file = folder / "plane-ring" / name;
        ASSERT_TRUE(wait_until([&] { return application.message().text == "Saved " + file.string(); }));
        EXPECT_EQ(read_image(file).width, 2);
    }
}

TEST_F(ApplicationTest, AKeptRunStaysInThePlotsWhenTheLiveOneStartsOver) {
    EXPECT_FALSE(application.press_key("K")) << "there is nothing to keep yet";
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    EXPECT_TRUE(application.press_key("K"));
    ASSERT_EQ(application.document().runs().size(), 2U);
    EXPECT_EQ(application.message().text, "Kept as Ring");
    EXPECT_TRUE(application.press_key("R"));
    ASSERT_TRUE(wait_until([&] { return run().history.size() == 1; }));
    EXPECT_GT(application.document().runs()[1].history.size(), 100U);
    frame();
    EXPECT_TRUE(application.items().count("runs.1.name"));
}

TEST_F(ApplicationTest, APlotIsCopiedAsNumbers) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    application.press_key("K");
    frame();
    ui.click(application.items().find("plot.first.menu")->second, drawing());
    frame();
    ui.click(application.items().find("plot.first.menu.csv")->second, drawing());
    const std::string copied = ImGui::GetClipboardText();
    EXPECT_TRUE(copied.starts_with("run,iteration,seconds,residual,")) << copied.substr(0, 80);
    EXPECT_EQ(std::count(copied.begin(), copied.end(), '\n'),
              static_cast<std::ptrdiff_t>(1 + 2 * run().history.size()));
    EXPECT_TRUE(application.message().text.starts_with("Copied")) << application.message().text;
}

TEST_F(ApplicationTest, APlotIsSavedAsAPicture) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    const auto ask = [&] {
        ui.click(application.items().find("plot.second.menu")->second, drawing());
        frame();
        ui.click(application.items().find("plot.second.menu.png")->second, drawing());
    };
    std::string title;
    const auto draw = [&](const Plot& plot) {
        title = plot.title;
        return Image{2, 2, std::vector<std::uint8_t>(16, 200)};
    };
    application.save_plot(draw);
    EXPECT_EQ(title, "") << "nobody has asked";
    for (const char* name : {"equidistribution.png", "equidistribution-2.png"}) {
        ask();
        application.save_plot(draw);
        const auto file = folder / "plane-ring" / name;
        ASSERT_TRUE(wait_until([&] { return application.message().text == "Saved " + file.string(); }))
            << application.message().text;
        EXPECT_EQ(read_image(file).width, 2);
    }
    EXPECT_EQ(title, "Equidistribution");
    ask();
    application.save_plot([](const Plot&) -> Image { throw MachineError("no picture today"); });
    EXPECT_TRUE(application.message().error);
    EXPECT_EQ(application.message().text, "no picture today");
}

TEST_F(ApplicationTest, APlotIsSavedAsVectorGraphics) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    ui.click(application.items().find("plot.first.menu")->second, drawing());
    frame();
    ui.click(application.items().find("plot.first.menu.svg")->second, drawing());
    const auto file = folder / "plane-ring" / "residual.svg";
    ASSERT_TRUE(wait_until([&] { return application.message().text == "Saved " + file.string(); }))
        << application.message().text;
    std::ifstream stream(file);
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    EXPECT_NE(text.find("<svg"), std::string::npos);
    EXPECT_NE(text.find("Residual"), std::string::npos);
}

TEST_F(ApplicationTest, WhatThePlotsShowIsRemembered) {
    frame(), frame();
    ui.click(application.items().find("plot.first.log")->second, drawing());
    EXPECT_EQ(application.settings().window.text("first_plot"), "residual,iterations,linear,linear");
    Settings settings;
    settings.window.set("second_plot", std::string("step-size,seconds,log,log"));
    settings.window.set("first_plot", std::string("nonsense"));
    Application other(catalogue, small_ring(), {.output = folder, .settings = settings});
    ui.frame([&] { other.frame(); });
    EXPECT_EQ(other.settings().window.text("second_plot"), "step-size,seconds,log,log");
    EXPECT_EQ(other.settings().window.text("first_plot"), "residual,iterations,linear,log");
}

TEST_F(ApplicationTest, ATangledRunIsRedAndSaysHowToGoOn) {
    Scenario wild = run().scenario;
    set_value(*catalogue, wild, "monitor.amplitude", 500.0);
    set_value(*catalogue, wild, "method.step_size", 5.0);
    application.document().change(0, wild);
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    const auto cells = status_cells(run());
    EXPECT_EQ(cells[0].tone, Tone::bad) << cells[0].value;
    EXPECT_EQ(cells[5].label, "Tangled cells");
    EXPECT_EQ(cells[5].tone, Tone::bad) << cells[5].value;
    EXPECT_NE(closing_note(run()).find("R starts from the beginning"), std::string::npos)
        << closing_note(run());
    EXPECT_TRUE(application.press_key("R"));
    ASSERT_TRUE(wait_until([&] { return run().history.size() == 1; }));
    EXPECT_TRUE(closing_note(run()).empty());
    EXPECT_EQ(status_cells(run())[5].value, "0");
    EXPECT_EQ(status_cells(run())[5].tone, Tone::plain);
}

TEST_F(ApplicationTest, WhatTheSolverRefusesIsASentenceAndThePictureStays) {
    ASSERT_TRUE(wait_until([&] { return run().history.size() > 3 && !application.pictures().empty(); }));
    Scenario impossible = run().scenario;
    impossible.method.type = "no-such-method";
    application.document().change(0, impossible);
    ASSERT_TRUE(wait_until([&] { return application.message().error; }));
    EXPECT_NE(application.message().text.find("no-such-method"), std::string::npos)
        << application.message().text;
    EXPECT_FALSE(application.pictures().empty());
    EXPECT_NE(run().status.run, RunStatus::failed);
}

TEST_F(ApplicationTest, TheMouseSteersTheCamera) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && !application.pictures().empty(); }));
    application.press_key("H"); // for the mesh as it now stands
    frame();
    const ItemRectangle view = application.items().find("viewport")->second;
    const Size size{static_cast<double>(view.width()), static_cast<double>(view.height())};
    const Camera home = application.pictures().front().camera;

    ui.drag(view, 0.5F, 0.6F, drawing());
    const Pixel moved = to_pixel(application.pictures().front().camera, size, home.centre);
    EXPECT_NEAR(moved.x, 0.6 * size.width, 2) << "the mesh follows the mouse";
    EXPECT_NEAR(moved.y, 0.5 * size.height, 2);

    const Pixel pointer{std::floor(0.25 * size.width), std::floor(0.75 * size.height)};
    ui.move(view.left + static_cast<float>(pointer.x), view.top + static_cast<float>(pointer.y));
    frame();
    const Camera before = application.pictures().front().camera;
    ui.wheel(3);
    frame();
    EXPECT_LT(application.pictures().front().camera.scale, before.scale);
    const Vec3 there = to_world(before, size, pointer),
               now = to_world(application.pictures().front().camera, size, pointer);
    EXPECT_NEAR(there.x, now.x, 1e-6) << "what is under the pointer stays there";
    EXPECT_NEAR(there.y, now.y, 1e-6);

    EXPECT_TRUE(application.press_key("H"));
    frame();
    EXPECT_EQ(application.pictures().front().camera, home);
    ui.drag(view, 0.5F, 0.6F, drawing());
    EXPECT_NE(application.pictures().front().camera, home);
    for (int i = 0; i < 30; ++i) frame(); // so that the drag is not the first of two clicks
    const Camera dragged = application.pictures().front().camera;
    ItemRectangle corner = view; // clicked at its middle
    corner.right = view.left + 0.6F * view.width();
    corner.bottom = view.top + 0.6F * view.height();
    ui.click(corner, drawing());
    EXPECT_NE(application.document().viewports()[0].view.text("pick"), "") << "a click picks";
    EXPECT_EQ(application.pictures().front().camera, dragged);
    ui.click(corner, drawing());
    frame();
    const Vec3 clicked = to_world(dragged, size, {0.3 * size.width, 0.3 * size.height});
    const Pixel middle = to_pixel(application.pictures().front().camera, size, clicked);
    EXPECT_NEAR(middle.x, size.width / 2, 1) << "a double click brings a point to the middle";
    EXPECT_NEAR(middle.y, size.height / 2, 1);
    EXPECT_EQ(application.document().viewports()[0].view.text("pick"), "") << "and picks nothing";
}

TEST_F(ApplicationTest, TheCameraIsCopiedAndPastedAsText) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && !application.pictures().empty(); }));
    application.press_key("H");
    frame();
    const Camera home = application.pictures().front().camera;
    EXPECT_TRUE(application.press_key("Ctrl+C"));
    const std::string copied = ImGui::GetClipboardText();
    ui.drag(application.items().find("viewport")->second, 0.5F, 0.6F, drawing());
    EXPECT_NE(application.pictures().front().camera, home);
    EXPECT_TRUE(application.press_key("Ctrl+V"));
    frame();
    EXPECT_EQ(application.pictures().front().camera.centre, home.centre);
    EXPECT_EQ(application.document().viewports()[0].view.text("camera"), copied);
    ImGui::SetClipboardText("milk, bread");
    EXPECT_TRUE(application.press_key("Ctrl+V"));
    EXPECT_NE(application.message().text.find("the camera 'milk, bread'"), std::string::npos);
    EXPECT_EQ(application.document().viewports()[0].view.text("camera"), copied) << "nothing is lost";
}

TEST_F(ApplicationTest, EscapeEndsThePickAndNotTheSolving) {
    ASSERT_TRUE(wait_until([&] { return run().history.size() > 3 && !application.pictures().empty(); }));
    ui.click(application.items().find("viewport")->second, drawing());
    const Values& values = application.document().viewports()[0].view;
    EXPECT_NE(values.text("pick"), "");
    EXPECT_TRUE(application.press_key("Escape"));
    EXPECT_EQ(values.text("pick"), "");
}

TEST_F(ApplicationTest, TheViewIsSwitchedByKeys) {
    ASSERT_TRUE(wait_until([&] { return !application.pictures().empty(); }));
    const Values& values = application.document().viewports()[0].view;
    EXPECT_TRUE(application.press_key("B"));
    frame();
    EXPECT_EQ(application.pictures().size(), 2U);
    EXPECT_TRUE(application.press_key("B"));
    EXPECT_TRUE(application.press_key("L"));
    EXPECT_TRUE(application.press_key("A"));
    frame();
    EXPECT_EQ(application.pictures().size(), 1U);
    EXPECT_FALSE(application.pictures()[0].picture.lines);
    EXPECT_NE(application.pictures()[0].picture.arrows, nullptr);
    EXPECT_FALSE(application.press_key("3")) << "a plane has one side";
    EXPECT_EQ(values.text("direction"), "home");
}

TEST_F(ApplicationTest, AFixedRangeBeginsAsWhatIsSeen) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && !application.pictures().empty(); }));
    const ColourRange seen = application.pictures()[0].picture.colouring->range;
    ui.click(application.items().find("view.range")->second, drawing());
    frame();
    ui.click(application.items().find("view.range=fixed")->second, drawing());
    frame();
    const Values& values = application.document().viewports()[0].view;
    EXPECT_EQ(values.text("range"), "fixed");
    EXPECT_EQ(values.real("low"), seen.low);
    EXPECT_EQ(values.real("high"), seen.high);
    EXPECT_EQ(application.pictures()[0].picture.colouring->range, seen);
}

TEST_F(ApplicationTest, BlendShowsTheComputationalMeshAndSolvesNothing) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    const auto rows = run().history.size();
    EXPECT_EQ(application.pictures().front().picture.blend, 1);
    ui.drag(application.items().find("view.blend")->second, 0.9F, -0.5F, drawing());
    frame();
    EXPECT_EQ(application.pictures().front().picture.blend, 0);
    solved_scenario();
    EXPECT_EQ(run().history.size(), rows);
}

TEST_F(ApplicationTest, AnotherScenarioStartsFromItsOwnBeginning) {
    ASSERT_TRUE(wait_until([&] { return run().history.size() > 3; }));
    ui.click(application.items().find("scenario")->second, drawing());
    frame();
    ASSERT_TRUE(application.items().count("scenario=plane-bell"));
    ui.click(application.items().find("scenario=plane-bell")->second, drawing());
    ASSERT_TRUE(wait_until([&] { return run().scenario.name != "plane-ring"; }));
    EXPECT_EQ(run().scenario.name, "plane-bell");
    EXPECT_EQ(solved_scenario().monitor.type, "bell");
    ASSERT_TRUE(wait_until([&] { return run().snapshot && run().snapshot->mesh->cell_count() == 3600; }));
}

TEST_F(ApplicationTest, AScenarioFileIsOpenedAndRemembered) {
    Scenario other = small_ring();
    other.title = "Another one";
    set_value(*catalogue, other, "monitor.amplitude", 3.0);
    std::ofstream(folder / "other.toml") << to_toml(other);
    application.open_file(folder / "other.toml");
    ASSERT_TRUE(wait_until([&] { return application.title() == "Another one"; }));
    EXPECT_EQ(solved_scenario().monitor.values.real("amplitude"), 3);
    ASSERT_EQ(application.settings().recent.size(), 1U);
    EXPECT_EQ(application.settings().recent.front(),
              std::filesystem::absolute(folder / "other.toml").string());
    EXPECT_FALSE(application.error().open());
}

TEST_F(ApplicationTest, AFileThatIsNoScenarioIsOneSentenceAndLosesNothing) {
    std::ofstream(folder / "broken.toml") << "[monitor]\namplitud = 3\n";
    std::ofstream(folder / "combination.toml") << "[domain]\nboundary = 'walls'\n[method]\ntype='magic'\n";
    std::ofstream(folder / "picture.png") << "no";
    const std::string title = application.title();
    for (const char* name : {"broken.toml", "combination.toml", "picture.png", "missing.toml"}) {
        application.open_file(folder / name);
        ASSERT_TRUE(wait_until([&] { return application.error().open(); })) << name;
        EXPECT_NE(application.error().sentence().find(name), std::string::npos)
            << application.error().sentence();
        EXPECT_EQ(application.log().lines().back().notice.text, application.error().sentence());
        EXPECT_EQ(application.title(), title);
        frame();
        ASSERT_TRUE(application.items().count("error.ok"));
        ui.click(application.items().find("error.ok")->second, drawing());
        EXPECT_FALSE(application.error().open()) << name;
    }
    EXPECT_TRUE(application.settings().recent.empty());
    EXPECT_EQ(solved_scenario(), small_ring());
}

TEST_F(ApplicationTest, AnErrorComesBeforeTheOpenDialog) {
    application.perform(ActionId::open);
    frame();
    frame();
    application.open_file(folder / "missing.toml");
    ASSERT_TRUE(wait_until([&] { return application.items().count("error.ok") == 1; }));
    frame();
    EXPECT_FALSE(application.press_key("Space")) << "a dialog comes first";
    ui.click(application.items().find("error.ok")->second, drawing());
    EXPECT_FALSE(application.error().open());
    for (int i = 0; i < 3; ++i) frame();
    ui.click(application.items().find("open.cancel")->second, drawing());
    frame();
    EXPECT_EQ(application.items().count("open.path"), 0U);
}

TEST_F(ApplicationTest, AScenarioThatTheSolverRefusesLeavesEverythingAsItWas) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    const std::size_t rows = run().history.size();
    Scenario wrong = small_ring();
    wrong.title = "Wrong";
    wrong.method.type = "magic";
    application.document().replace(0, wrong);
    ASSERT_TRUE(wait_until([&] { return application.error().open(); }));
    EXPECT_EQ(application.title(), small_ring().title);
    EXPECT_EQ(run().opened, small_ring());
    EXPECT_EQ(run().history.size(), rows);
    EXPECT_TRUE(run().ended());
}

TEST_F(ApplicationTest, ExportWritesTheChosenFormatsColouredAsTheViewIs) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    ui.click(application.items().find("menu.File")->second, drawing());
    ASSERT_TRUE(application.items().count("menu.export"));
    auto output = run().scenario;
    output.output.set("formats", std::string("svg"));
    application.document().change(0, output);
    application.document().viewports().front().view.set("color", std::string("area"));
    application.perform(ActionId::export_files);
    ASSERT_TRUE(wait_until([&] { return application.message().text.starts_with("Exported to "); }));
    std::ifstream file(folder / "plane-ring" / "adapted.svg");
    const std::string svg((std::istreambuf_iterator<char>(file)), {});
    EXPECT_NE(svg.find("cell area"), std::string::npos) << svg.substr(0, 1000);
    EXPECT_FALSE(std::filesystem::exists(folder / "plane-ring" / "adapted.obj"));
}

TEST_F(ApplicationTest, TheOpenDialogTakesAPath) {
    Scenario other = small_ring();
    other.title = "Typed";
    std::ofstream(folder / "typed.toml") << to_toml(other);
    EXPECT_TRUE(application.press_key("Ctrl+O"));
    for (int i = 0; i < 3; ++i) frame();
    ui.click(application.items().find("open.path")->second, drawing());
    ui.type((folder / "typed.toml").string(), drawing());
    ui.click(application.items().find("open.ok")->second, drawing());
    EXPECT_TRUE(wait_until([&] { return application.title() == "Typed"; })) << application.message().text;
    EXPECT_TRUE(application.press_key("Ctrl+O"));
    frame();
    application.perform(ActionId::cancel);
    frame();
    EXPECT_EQ(application.items().count("open.path"), 0U);
}

TEST_F(ApplicationTest, ASavedScenarioOpensAgain) {
    ASSERT_TRUE(wait_until([&] { return run().history.size() > 3; }));
    ui.drag(application.items().find("monitor.amplitude")->second, 0.4F, 0.6F, drawing());
    const double amplitude = run().scenario.monitor.values.real("amplitude");
    EXPECT_TRUE(application.press_key("Ctrl+S"));
    const auto file = folder / "plane-ring" / "plane-ring.toml";
    ASSERT_TRUE(wait_until([&] { return application.message().text == "Saved " + file.string(); }));
    EXPECT_EQ(load_scenario(*catalogue, file).monitor.values.real("amplitude"), amplitude);
}

TEST_F(ApplicationTest, PartsAreShownHiddenAndMadeWider) {
    for (const char* key : {"F2", "F3", "F4"}) application.press_key(key);
    frame();
    EXPECT_EQ(application.items().count("monitor.type"), 0U);
    EXPECT_EQ(application.items().count("plot.first"), 0U);
    EXPECT_EQ(application.items().count("log"), 1U);
    EXPECT_EQ(application.viewport_rectangle().width(), ImGui::GetIO().DisplaySize.x);
    for (const char* key : {"F2", "F3", "F4"}) application.press_key(key);
    frame();
    const auto drag_edge = [&](const char* name, float by) {
        const ItemRectangle edge = application.items().find(name)->second;
        ui.move(edge.center_x(), edge.center_y());
        frame();
        ui.button(true);
        frame();
        ui.move(edge.center_x() + by, edge.center_y());
        frame();
        ui.button(false);
        frame();
    };
    const ItemRectangle before = application.viewport_rectangle();
    drag_edge("edge.sidebar", 50);
    EXPECT_NEAR(application.viewport_rectangle().left, before.left + 50, 5);
    const ItemRectangle between = application.viewport_rectangle();
    drag_edge("edge.plots", -60);
    EXPECT_NEAR(application.viewport_rectangle().right, between.right - 60, 6);
    for (int i = 0; i < 10; ++i) drag_edge("edge.sidebar", -500);
    EXPECT_GT(application.viewport_rectangle().left, 100) << "the sliders stay within reach";
}

TEST_F(ApplicationTest, ThemeAndSizeAreChangedByKeysAndRemembered) {
    EXPECT_EQ(application.theme().background, dark_theme().background);
    application.press_key("T");
    EXPECT_EQ(application.theme().background, light_theme().background);
    EXPECT_EQ(application.settings().window.text("theme"), "light");
    application.press_key("F10");
    EXPECT_NEAR(application.text_size(), 1.7, 1e-6);
    application.press_key("F10");
    EXPECT_EQ(application.text_size(), 1);
    for (int i = 0; i < 30; ++i) application.press_key("Ctrl+=");
    EXPECT_EQ(application.text_size(), 3);
    for (int i = 0; i < 60; ++i) application.press_key("Ctrl+-");
    EXPECT_NEAR(application.text_size(), 0.6, 1e-6);
    application.press_key("F11");
    EXPECT_TRUE(application.fullscreen());
}

TEST_F(ApplicationTest, EverythingHasRoomAtTheSizeForProjectors) {
    ui.scale(1.7F);
    application.set_scale(1.7F);
    ImGui::GetIO().DisplaySize = {1920, 1080};
    for (int i = 0; i < 3; ++i) frame();
    for (const char* key : {"action.run", "action.export", "scenario", "monitor.amplitude", "viewport",
                            "plot.first", "plot.second", "status.0", "message"}) {
        ASSERT_TRUE(application.items().count(key)) << key;
        EXPECT_LE(application.items().find(key)->second.right, 1921) << key;
    }
    EXPECT_GT(application.viewport_rectangle().width(), 500);
}

TEST_F(ApplicationTest, RandomInputBreaksNothing) {
    std::mt19937 random(8); // the same input every time
    const auto draw_int = [&](int low, int high) { return std::uniform_int_distribution(low, high)(random); };
    std::vector<std::string_view> keys;
    for (const Action& row : actions())
        if (row.id != ActionId::export_files && row.id != ActionId::screenshot)
            keys.insert(keys.end(), row.keys.begin(), row.keys.end());
    for (int i = 0; i < 10000; ++i) {
        ImGuiIO& io = ImGui::GetIO();
        if (draw_int(0, 3) == 0) // mostly where the sliders are
            ui.move(static_cast<float>(draw_int(-20, draw_int(0, 1) ? 420 : 1420)),
                    static_cast<float>(draw_int(-20, 920)));
        if (draw_int(0, 2) == 0) ui.button(draw_int(0, 1) == 1, draw_int(0, 2));
        if (draw_int(0, 9) == 0) ui.wheel(static_cast<float>(draw_int(-3, 3)));
        if (draw_int(0, 9) == 0) io.KeyCtrl = !io.KeyCtrl;
        if (draw_int(0, 4) == 0) io.AddInputCharacter(static_cast<unsigned>(draw_int(32, 126)));
        if (draw_int(0, 19) == 0)
            application.press_key(
                keys[static_cast<std::size_t>(draw_int(0, static_cast<int>(keys.size()) - 1))]);
        if (draw_int(0, 49) == 0)
            io.DisplaySize = {static_cast<float>(draw_int(1, 2000)), static_cast<float>(draw_int(1, 1500))};
        if (i % 40 == 0) application.perform(ActionId::cancel); // a dialog would keep the rest away
        if (i % 200 == 0 && application.items().count("monitor.type") == 0)
            application.perform(ActionId::sidebar);
        frame();
        for (const Values* values : {&run().scenario.domain.values, &run().scenario.monitor.values})
            for (const auto& row : values->rows()) {
                Values copy = *values;
                ASSERT_NO_THROW(copy.set(row.key, values->at(row.key)));
            }
    }
    EXPECT_NE(run().status.run, RunStatus::failed) << application.message().text;
    EXPECT_NE(application.document().runs().front().scenario, small_ring()) << "the input reached nothing";
}

} // namespace
} // namespace gaspard

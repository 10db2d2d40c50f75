// The program in a real window on a screen in memory, with synthetic mouse and keys.
#include "core/io/image.hpp"
#include "core/scenario/toml.hpp"
#include "gui/app/application.hpp"
#include "gui/headless_ui.hpp"
#include "gui/virtual_display.hpp"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>
#include <utility>

namespace gaspard {
namespace {

using namespace std::chrono_literals;

bool eventually(const std::function<bool()>& condition, std::chrono::seconds patience = 60s) {
    const auto end = std::chrono::steady_clock::now() + patience;
    while (std::chrono::steady_clock::now() < end) {
        if (condition()) return true;
        std::this_thread::sleep_for(50ms);
    }
    return false;
}

std::string text_of(const std::filesystem::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Where the window's items are at this size, by the window's own code.
ItemRectangles layout_of(int width, int height) {
    const Theme theme = dark_theme();
    HeadlessUi ui(static_cast<float>(width), static_cast<float>(height), &theme);
    const auto catalogue = std::make_shared<Catalogue>(builtin_catalogue());
    Application application(catalogue, find_scenario(*catalogue, "plane-ring"));
    application.perform("run");
    for (int i = 0; i < 3; ++i) ui.frame([&] { application.frame(); });
    return application.items();
}

class WindowTest : public testing::Test {
  protected:
    WindowTest() {
        std::filesystem::remove_all(folder);
        std::filesystem::create_directories(folder);
    }
    ~WindowTest() override {
        program.reset();
        std::filesystem::remove_all(folder);
    }

    void start(const std::string& scenario, int width, int height,
               const std::vector<std::string>& options = {}) {
        ChildProcess::Setup setup;
        setup.command = {GASPARD_PROGRAM, scenario};
        if (width > 0) // else: as it was remembered
            for (const auto& word :
                 {std::string("--size"), std::to_string(width) + "x" + std::to_string(height)})
                setup.command.push_back(word);
        setup.command.insert(setup.command.end(), options.begin(), options.end());
        setup.environment = {{"DISPLAY", display.name()},
                             {"WAYLAND_DISPLAY", ""},
                             {"XDG_CONFIG_HOME", (folder / "config").string()}};
        setup.folder = folder;
        setup.output = folder / "log";
        program.emplace(setup);
        ASSERT_TRUE(eventually([&] {
            // The title names the scenario from the frame on that shows it.
            window = display.xdotool({"search", "--onlyvisible", "--name", "^Gaspard: "});
            return !window.empty() || !program->running();
        }));
        ASSERT_FALSE(window.empty()) << text_of(folder / "log");
        display.xdotool({"windowmove", window, "0", "0"});
    }
    void move(float x, float y) {
        display.xdotool({"mousemove", "--window", window, std::to_string(std::lround(x)),
                         std::to_string(std::lround(y))});
    }
    /// Waits for a frame that has seen everything so far: it takes a screenshot, whose key comes last.
    void settle() {
        press("p");
        EXPECT_TRUE(eventually([&] {
            std::error_code none; // the folder is not there yet, or files in it come and go
            std::filesystem::recursive_directory_iterator file(folder / "gaspard-out", none);
            for (; !none && file != end(file); file.increment(none)) {
                const auto path = file->path();
                if (path.filename() == "screenshot.png") return std::filesystem::remove(path);
            }
            return false;
        })) << text_of(folder / "log");
    }
    void drag(const ItemRectangle& item, float from, float to) {
        move(item.left + from * item.width(), item.center_y());
        display.xdotool({"mousedown", "1"});
        for (int i = 1; i <= 4; ++i)
            move(item.left + (from + (to - from) * static_cast<float>(i) / 4) * item.width(),
                 item.center_y());
        settle(); // the value follows the pointer only while the button is down
        display.xdotool({"mouseup", "1"});
    }
    void press(const std::string& key) { display.xdotool({"key", key}); }
    /// A ring that solves for as long as a test needs, whatever its sliders say.
    void write_slow_ring(int cells) const {
        const Catalogue catalogue = builtin_catalogue();
        Scenario scenario = find_scenario(catalogue, "plane-ring");
        set_value(catalogue, scenario, "domain.cells", std::int64_t{cells});
        set_value(catalogue, scenario, "method.tolerance", 1e-14);
        set_value(catalogue, scenario, "method.step_size", 1e-3);
        set_value(catalogue, scenario, "method.max_iterations", std::int64_t{1000000});
        std::ofstream(folder / "slow.toml") << to_toml(scenario);
    }
    /// One that has converged soon.
    void write_quick_ring() const {
        const Catalogue catalogue = builtin_catalogue();
        Scenario scenario = find_scenario(catalogue, "plane-ring");
        set_value(catalogue, scenario, "domain.cells", std::int64_t{24});
        std::ofstream(folder / "quick.toml") << to_toml(scenario);
    }
    std::filesystem::path out(const std::string& scenario) const { return folder / "gaspard-out" / scenario; }
    /// The summary of the next export, each of which has a folder of its own.
    nlohmann::json exported(const std::string& name = "slow") {
        const int number = ++exports[name];
        const auto file = out(number == 1 ? name : name + "-" + std::to_string(number)) / "summary.json";
        press("e");
        EXPECT_TRUE(eventually([&] { return std::filesystem::exists(file); })) << text_of(folder / "log");
        return nlohmann::json::parse(text_of(file));
    }

    /// The screenshot of the whole mesh, as soon as it has this size and is the same twice: the window has
    /// settled.
    Image settled_screenshot(const std::string& scenario, const ItemRectangle& area) {
        const auto file = out(scenario) / "screenshot.png";
        Image image;
        EXPECT_TRUE(eventually([&] {
            press("h"); // the camera does not follow the size of the window
            press("p");
            if (!eventually([&] { return std::filesystem::exists(file); })) return false;
            Image next = read_image(file);
            std::filesystem::remove(file);
            const bool same = next.rgba == image.rgba;
            image = std::move(next);
            return same && image.width == std::lround(area.width()) &&
                   image.height == std::lround(area.height());
        })) << text_of(folder / "log");
        return image;
    }

    std::filesystem::path folder =
        std::filesystem::path(testing::TempDir()) /
        (std::string("gaspard-window-") + testing::UnitTest::GetInstance()->current_test_info()->name());
    VirtualDisplay display{1500, 1000};
    std::optional<ChildProcess> program;
    std::string window;
    std::map<std::string, int> exports; ///< so far, by the name of their folder
};

TEST_F(WindowTest, ASliderDraggedWithTheMouseAndKeysPressedReachTheFiles) {
    const ItemRectangles items = layout_of(1200, 800);
    write_slow_ring(60);
    start("slow.toml", 1200, 800);
    const auto before = exported();
    EXPECT_EQ(before["monitor"]["amplitude"], 10.0);

    drag(items.find("monitor.sharpness")->second, 0.7F, 0.3F);
    drag(items.find("monitor.amplitude")->second, 0.05F, 0.3F);
    press("space");
    const auto after = exported("slow-modified");
    EXPECT_NE(after["monitor"]["amplitude"], 10.0);
    EXPECT_NE(after["monitor"]["sharpness"], 200.0);
    EXPECT_GT(after["iterations"], 0);
    std::string history; // is written after the summary
    EXPECT_TRUE(eventually([&] {
        history = text_of(out("slow-modified") / "history.csv");
        return history.rfind("iteration,residual,", 0) == 0;
    }));
    EXPECT_GT(std::count(history.begin(), history.end(), '\n'), 3);

    EXPECT_EQ(exported("slow-modified")["iterations"], after["iterations"]) << "space pauses";
    press("n");
    EXPECT_EQ(exported("slow-modified")["iterations"], after["iterations"].get<int>() + 1)
        << "n does one step";
    press("ctrl+q");
    EXPECT_EQ(program->wait(10s), 0) << text_of(folder / "log");
}

TEST_F(WindowTest, OpensWithTheAutomaticMethod) {
    start("plane-ring", 1000, 700);
    press("e");
    const auto summary = out("plane-ring") / "summary.json";
    ASSERT_TRUE(eventually([&] { return std::filesystem::exists(summary); }));
    EXPECT_EQ(nlohmann::json::parse(text_of(summary))["method"]["type"], "auto");
}

TEST_F(WindowTest, APinnedMethodStaysWhereASettingSpeaksOfIt) {
    start("plane-ring", 1000, 700, {"--set", "method.step_size=0.05"});
    press("e");
    const auto summary = out("plane-ring-modified") / "summary.json";
    ASSERT_TRUE(eventually([&] { return std::filesystem::exists(summary); })) << text_of(folder / "log");
    const auto method = nlohmann::json::parse(text_of(summary))["method"];
    EXPECT_EQ(method["type"], "relaxation");
    EXPECT_EQ(method["step_size"], 0.05);
}

TEST_F(WindowTest, ItDrawsWhatIsDrawnOffscreenAtEverySizeItIsGiven) {
    write_quick_ring();
    start("quick.toml", 1000, 700);
    move(5, 5);
    ASSERT_TRUE(eventually([&] { return exported("quick")["status"] == "converged"; }));
    for (const auto& [width, height] : {std::pair{1000, 700}, {1300, 850}, {900, 640}}) {
        display.xdotool({"windowsize", window, std::to_string(width), std::to_string(height)});
        const ItemRectangle area = layout_of(width, height).find("viewport")->second;
        const Image shown = settled_screenshot("quick", area);

        ChildProcess::Setup setup;
        setup.command = {GASPARD_PROGRAM,  "run",    "quick.toml",
                         "--whole-window", "--size", std::to_string(width) + "x" + std::to_string(height),
                         "--quiet",        "--out",  "offscreen"};
        setup.folder = folder;
        setup.output = folder / "offscreen-log";
        ASSERT_EQ(ChildProcess(setup).wait(60s), 0) << text_of(folder / "offscreen-log");
        const Image whole = read_image(folder / "offscreen" / "view.png");
        ASSERT_EQ(shown.width, std::lround(area.width()));
        ASSERT_EQ(shown.height, std::lround(area.height()));
        const auto row_of = [](const Image& image, int y, float left) {
            return image.rgba.data() + 4 * (std::ptrdiff_t{y} * image.width + std::lround(left));
        };
        int different = 0;
        for (int y = 0; y < shown.height; ++y) {
            const auto *here = row_of(shown, y, 0),
                       *there = row_of(whole, y + static_cast<int>(std::lround(area.top)), area.left);
            for (int x = 0; x < 4 * shown.width; ++x) different += here[x] != there[x] ? 1 : 0;
        }
        EXPECT_EQ(different, 0) << "of " << shown.rgba.size() << " at " << width << " x " << height;
    }
}

TEST_F(WindowTest, WhatIsTypedFasterThanFramesArriveIsNotLost) {
    write_quick_ring();
    start("plane-ring", 1000, 700);
    move(5, 5);
    // In one burst: the first letters come before the dialog can be written in.
    display.xdotool({"key", "--delay", "0", "h", "ctrl+o", "q", "u", "i", "c", "k", "period", "t", "o", "m",
                     "l", "z", "BackSpace", "Return"});
    EXPECT_TRUE(eventually([&] {
        press("e");
        return std::filesystem::exists(out("quick") / "summary.json");
    })) << text_of(folder / "log");
}

TEST_F(WindowTest, AFormulaIsTypedRightAfterTheKeyThatOpensIt) {
    write_quick_ring();
    start("quick.toml", 1000, 700);
    move(5, 5);
    // Ctrl is released before A, within a frame.
    display.xdotool({"keydown", "ctrl", "keydown", "e", "keyup", "ctrl", "keyup", "e", "keydown", "ctrl",
                     "keydown", "a", "keyup", "ctrl", "keyup", "a"});
    display.xdotool({"key", "--delay", "0", "3", "plus", "x", "asterisk", "0", "Return"});
    EXPECT_EQ(exported("quick-modified")["monitor"]["expression"], "3+x*0");
}

TEST_F(WindowTest, EscapeAndQuitWorkWhileADialogsFieldIsWrittenIn) {
    start("plane-ring", 1000, 700);
    move(5, 5);
    press("ctrl+o");
    press("Escape");
    EXPECT_TRUE(eventually([&] {
        press("e"); // not a letter for the field any more
        return std::filesystem::exists(out("plane-ring") / "summary.json");
    })) << text_of(folder / "log");
    press("ctrl+o");
    press("ctrl+q");
    EXPECT_EQ(program->wait(10s), 0) << text_of(folder / "log");
}

TEST_F(WindowTest, ClosingWhileSolvingEndsQuickly) {
    write_slow_ring(300);
    start("slow.toml", 1000, 700);
    const double before = program->cpu_seconds();
    EXPECT_TRUE(eventually([&] { return program->cpu_seconds() - before > 0.3; })) << "it is not solving";
    press("ctrl+q");
    EXPECT_EQ(program->wait(8s), 0) << text_of(folder / "log");
}

TEST_F(WindowTest, WhatWasChangedIsThereTheNextTime) {
    write_slow_ring(120);
    start("slow.toml", 1000, 700);
    press("t");
    press("F10");
    press("F4");
    display.xdotool({"windowsize", window, "1100", "760"});
    EXPECT_TRUE(eventually([&] {
        const std::string size = display.xdotool({"getwindowgeometry", "--shell", window});
        return size.find("WIDTH=1100") != std::string::npos && size.find("HEIGHT=760") != std::string::npos;
    }));
    settle();
    move(700, 300); // over the view: pan, zoom
    display.xdotool({"mousedown", "1"});
    move(740, 330);
    settle();
    display.xdotool({"mouseup", "1", "click", "4", "click", "4"});
    press("ctrl+q"); // while it solves
    ASSERT_EQ(program->wait(10s), 0) << text_of(folder / "log");
    const std::string remembered = text_of(folder / "config" / "gaspard" / "window.toml");
    for (const char* line :
         {"theme = 'light'", "text_size = 1.7", "log = true", "width = 1100", "height = 760", "slow.toml"})
        EXPECT_NE(remembered.find(line), std::string::npos) << line << " in\n" << remembered;

    program.reset();
    window.clear();
    start("slow.toml", 0, 0);
    const std::string geometry = display.xdotool({"getwindowgeometry", "--shell", window});
    EXPECT_NE(geometry.find("WIDTH=1100"), std::string::npos) << geometry;
    EXPECT_NE(geometry.find("HEIGHT=760"), std::string::npos) << geometry;
    press("p");
    const auto file = out("slow") / "screenshot.png";
    ASSERT_TRUE(eventually([&] { return std::filesystem::exists(file); })) << text_of(folder / "log");
    const Image picture = read_image(file);
    EXPECT_EQ(picture.rgba[picture.rgba.size() - 4], 255) << "a corner of a light picture, beside the mesh";
}

TEST_F(WindowTest, SignalsThatEndItSaveTheSettings) {
    write_slow_ring(60);
    const auto settings = folder / "config" / "gaspard" / "window.toml";
    for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
        std::filesystem::remove(settings);
        window.clear();
        start("slow.toml", 1000, 700);
        std::filesystem::remove_all(out("slow"));
        press("F4");
        press("p"); // once this is done, so is what was pressed before
        ASSERT_TRUE(eventually([&] { return std::filesystem::exists(out("slow") / "screenshot.png"); }));
        program->send(signal);
        EXPECT_EQ(program->wait(10s), 0) << "signal " << signal << ": " << text_of(folder / "log");
        EXPECT_NE(text_of(settings).find("log = true"), std::string::npos) << text_of(settings);
        program.reset();
    }
}

TEST_F(WindowTest, OnADenseScreenEverythingIsLargerAndTheWindowStaysAsItIs) {
    ASSERT_TRUE(display.set_density(120));
    std::string first;
    for (int time = 0; time < 3; ++time) {
        window.clear();
        start("plane-ring", time == 0 ? 900 : 0, 600);
        const std::string geometry = display.xdotool({"getwindowgeometry", "--shell", window});
        const std::string size = geometry.substr(geometry.find("WIDTH="));
        if (time == 0) first = size;
        EXPECT_EQ(size, first) << "at start " << time;
        press("ctrl+q");
        ASSERT_EQ(program->wait(10s), 0) << text_of(folder / "log");
        program.reset();
    }
    EXPECT_NE(first.find("WIDTH=1125"), std::string::npos) << first;
}

TEST_F(WindowTest, SettingsThatCannotBeReadOrWrittenAreNoReasonToFail) {
    std::filesystem::create_directories(folder / "config");
    std::ofstream(folder / "config" / "gaspard") << "a file where a folder belongs";
    start("plane-ring", 1000, 700);
    press("ctrl+q");
    EXPECT_EQ(program->wait(10s), 0) << text_of(folder / "log");
    EXPECT_NE(text_of(folder / "log").find("cannot save the window settings"), std::string::npos)
        << text_of(folder / "log");
}

TEST_F(WindowTest, AnIdleWindowCostsNothing) {
    write_slow_ring(60);
    start("slow.toml", 1000, 700);
    press("space"); // pause
    move(10, 10);
    settle(); // a machine that is busy with something else looks idle, too
    double before = program->cpu_seconds();
    ASSERT_TRUE(eventually([&] { // paused, and its last frames drawn
        std::this_thread::sleep_for(200ms);
        const double last = std::exchange(before, program->cpu_seconds());
        return before - last < 0.005;
    }));
    double cost = 1;
    for (int i = 0; i < 5 && !(cost < 0.05); ++i) { // what else runs on the machine adds to some
        before = program->cpu_seconds();
        std::this_thread::sleep_for(3s); // the time that is measured
        cost = program->cpu_seconds() - before;
    }
    EXPECT_LT(cost, 0.05);
    ASSERT_TRUE(program->running());
}

TEST_F(WindowTest, AnImageDroppedOntoTheWindowBecomesTheMonitor) {
    constexpr std::uint8_t dark = 30, white = 255;
    Image disc{64, 64, {}};
    for (int y = -32; y < 32; ++y)
        for (int x = -32; x < 32; ++x) {
            const std::uint8_t grey = x * x + y * y < 150 ? dark : white;
            disc.rgba.insert(disc.rgba.end(), {grey, grey, grey, white});
        }
    write_png(folder / "a disc.png", disc);
    write_quick_ring();
    start("quick.toml", 1000, 700);
    ChildProcess::Setup setup;
    setup.command = {"/usr/bin/python3", GASPARD_SOURCE_DIR "/tests/gui/drop_file.py", display.name(), window,
                     (folder / "a disc.png").string()};
    setup.output = folder / "drop-log";
    ASSERT_EQ(ChildProcess(setup).wait(60s), 0) << text_of(folder / "drop-log");
    ASSERT_TRUE(eventually([&] {
        const auto summary = exported("quick-modified");
        return summary["monitor"]["type"] == "image" && summary["status"] == "converged";
    })) << text_of(folder / "log");
    press("ctrl+z");
    EXPECT_EQ(exported("quick")["monitor"]["type"], "ring");
}

TEST(WithoutADisplay, TheWindowIsRefusedInOneSentence) {
    const auto log = std::filesystem::path(testing::TempDir()) / "gaspard-no-display";
    ChildProcess::Setup setup;
    setup.command = {GASPARD_PROGRAM};
    setup.environment = {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}};
    setup.output = log;
    ChildProcess process(setup);
    EXPECT_EQ(process.wait(20s), 1);
    const std::string text = text_of(log);
    EXPECT_NE(text.find("No display"), std::string::npos) << text;
    EXPECT_NE(text.find("gaspard run"), std::string::npos) << text;
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
    std::filesystem::remove(log);
}

TEST_F(WindowTest, ADragAcrossAnErrorStudySetsItsParameter) {
    const ItemRectangles items = layout_of(1400, 900);
    std::filesystem::create_directories(folder / "config" / "gaspard");
    std::ofstream(folder / "config" / "gaspard" / "window.toml")
        << "[window]\nfirst_plot = 'error-study,K,log,log'\n";
    start("layer-1d", 1400, 900);
    nlohmann::json values;
    int exports = 0;
    // Until the study has begun, a drag moves the axes; and the axis reaches as far as has been solved.
    ASSERT_TRUE(eventually([&] {
        drag(items.find("plot.first.curves")->second, 0.5F, 0.9F);
        press("e");
        const std::string number = exports > 0 ? "-" + std::to_string(exports + 1) : "";
        const auto summary = out("layer-1d-modified" + number) / "summary.json";
        if (!eventually([&] { return std::filesystem::exists(summary); }, 3s)) return false;
        ++exports;
        values = nlohmann::json::parse(text_of(summary));
        return values["monitor"]["K"].is_number() && values["monitor"]["K"].get<double>() > 1; // 0.4 before
    })) << text_of(folder / "log")
        << values;
    EXPECT_EQ(values["modified"], nlohmann::json({"monitor.K"}));
}

} // namespace
} // namespace gaspard

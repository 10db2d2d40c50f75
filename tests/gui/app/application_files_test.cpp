#include "core/spline/patch_file.hpp"
#include "gui/application_fixture.hpp"

#include <cstdlib>
#include <fstream>
#include <imgui.h>
#include <iterator>

namespace gaspard {
namespace {

TEST_F(ApplicationTest, ExportWritesTheFilesAndSaysSo) {
    ASSERT_TRUE(wait_until([&] { return run().history.size() > 3; }));
    EXPECT_TRUE(application.press_key("E"));
    ASSERT_TRUE(wait_until([&] { return application.messages().last().text.starts_with("Exported to "); }))
        << application.messages().last().text;
    for (const char* file : {"summary.json", "history.csv", "state.bin", "adapted.obj", "adapted.glb"})
        EXPECT_TRUE(std::filesystem::exists(folder / "plane-ring" / file)) << file;
}

std::string text_of(const std::filesystem::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

TEST_F(ApplicationTest, ASecondExportLeavesTheFirstOneAlone) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    const auto export_to = [&](const std::string& name) {
        application.perform("export");
        const std::string said = "Exported to " + (folder / name).string();
        EXPECT_TRUE(wait_until([&] { return application.messages().last().text == said; }))
            << application.messages().last().text;
    };
    std::filesystem::create_directories(folder / "plane-ring");
    std::ofstream(folder / "plane-ring" / "notes.txt") << "of no export";
    export_to("plane-ring");
    const std::string first = text_of(folder / "plane-ring" / "summary.json");
    Scenario other = run().scenario;
    set_value(*catalogue, other, "monitor.amplitude", 3.0);
    application.document().change(run().id, other);
    ASSERT_TRUE(wait_until([&] { return run().changes.settled(); }));
    export_to("plane-ring-modified");
    export_to("plane-ring-modified-2");
    EXPECT_TRUE(application.document().undo());
    export_to("plane-ring-2");
    EXPECT_EQ(text_of(folder / "plane-ring" / "summary.json"), first);
    EXPECT_NE(text_of(folder / "plane-ring-modified" / "summary.json").find("\"monitor.amplitude\""),
              std::string::npos)
        << "the summary lists what was modified";
}

class UnwritableTest : public ApplicationTest {
  protected:
    UnwritableTest() { std::ofstream(folder / "file") << "a file where a folder should be"; }
    Application elsewhere{catalogue, small_ring(), {.output = {folder / "file", folder / "home"}}};
};

TEST_F(UnwritableTest, FilesGoToTheOtherFolderAndTheNoticeSaysSo) {
    const auto end = [&](const std::string& text) {
        for (int i = 0; i < 20000 && elsewhere.messages().last().text != text; ++i) {
            elsewhere.collect();
            ui.frame([this] { elsewhere.frame(); });
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        EXPECT_EQ(elsewhere.messages().last().text, text);
    };
    const std::string why = ", because " + (folder / "file").string() + " cannot be written";
    const auto there = folder / "home" / "plane-ring";
    elsewhere.perform("save");
    end("Saved " + (there / "plane-ring.toml").string() + why);
    for (int i = 0; i < 20000 && elsewhere.document().active().history.size() < 3; ++i) {
        elsewhere.collect();
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    elsewhere.perform("export");
    end("Exported to " + there.string() + why);
    EXPECT_TRUE(std::filesystem::exists(there / "summary.json"));
}

TEST_F(ApplicationTest, AnExportThatFailsIsASentence) {
    std::filesystem::remove_all(folder);
    std::ofstream(folder) << "a file where a folder should be";
    application.perform("export");
    ASSERT_TRUE(wait_until([&] { return application.messages().last().error; }));
    EXPECT_NE(application.messages().last().text.find(folder.string()), std::string::npos)
        << application.messages().last().text;
}

TEST_F(ApplicationTest, PicturesAreNumbered) {
    const Image image{2, 2, std::vector<std::uint8_t>(16, 200)};
    for (const char* name : {"screenshot.png", "screenshot-2.png", "screenshot-3.png"}) {
        application.save_image(image);
        const auto file = folder / "plane-ring" / name;
        ASSERT_TRUE(
            wait_until([&] { return application.messages().last().text == "Saved " + file.string(); }));
        EXPECT_EQ(read_image(file).width, 2);
    }
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
    EXPECT_EQ(solved_scenario().method.type, "auto") << "the method chooses by itself";
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
    EXPECT_FALSE(application.messages().error().open());
}

TEST_F(ApplicationTest, AFileThatIsNoScenarioIsOneSentenceAndLosesNothing) {
    std::ofstream(folder / "broken.toml") << "[monitor]\namplitud = 3\n";
    std::ofstream(folder / "combination.toml") << "[domain]\nboundary = 'walls'\n[method]\ntype='magic'\n";
    std::ofstream(folder / "picture.png") << "no";
    const std::string title = application.title();
    for (const char* name : {"broken.toml", "combination.toml", "picture.png", "missing.toml"}) {
        application.open_file(folder / name);
        ASSERT_TRUE(wait_until([&] { return application.messages().error().open(); })) << name;
        EXPECT_NE(application.messages().error().sentence().find(name), std::string::npos)
            << application.messages().error().sentence();
        EXPECT_EQ(application.messages().log().lines().back().notice.text,
                  application.messages().error().sentence());
        EXPECT_EQ(application.title(), title);
        frame();
        ASSERT_TRUE(application.items().count("error.ok"));
        ui.click(application.items().find("error.ok")->second, drawing());
        EXPECT_FALSE(application.messages().error().open()) << name;
    }
    EXPECT_TRUE(application.settings().recent.empty());
    EXPECT_EQ(solved_scenario(), small_ring());
}

TEST_F(ApplicationTest, AnErrorComesBeforeTheOpenDialog) {
    application.perform("open");
    frame();
    frame();
    application.open_file(folder / "missing.toml");
    ASSERT_TRUE(wait_until([&] { return application.items().count("error.ok") == 1; }));
    frame();
    EXPECT_FALSE(application.press_key("Space")) << "a dialog comes first";
    ui.click(application.items().find("error.ok")->second, drawing());
    EXPECT_FALSE(application.messages().error().open());
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
    application.document().replace(run().id, wrong);
    ASSERT_TRUE(wait_until([&] { return application.messages().error().open(); }));
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
    application.document().change(run().id, output);
    application.document().viewports().front().view.set("color", std::string("area"));
    application.perform("export");
    ASSERT_TRUE(wait_until([&] { return application.messages().last().text.starts_with("Exported to "); }));
    const std::string svg = text_of(folder / "plane-ring" / "adapted.svg");
    EXPECT_NE(svg.find("cell area"), std::string::npos) << svg.substr(0, 1000);
    EXPECT_FALSE(std::filesystem::exists(folder / "plane-ring" / "adapted.obj"));
}

TEST_F(ApplicationTest, TheOpenDialogTakesAPath) {
    Scenario other = small_ring();
    other.title = "Typed";
    std::ofstream(folder / "typed.toml") << to_toml(other);
    EXPECT_TRUE(application.press_key("Ctrl+O"));
    for (int i = 0; i < 3; ++i) frame();
    replace_text(application.items().find("open.path")->second, (folder / "typed.toml").string());
    ui.click(application.items().find("open.ok")->second, drawing());
    EXPECT_TRUE(wait_until([&] { return application.title() == "Typed"; }))
        << application.messages().last().text;
    EXPECT_TRUE(application.press_key("Ctrl+O"));
    frame();
    application.perform("cancel");
    frame();
    EXPECT_EQ(application.items().count("open.path"), 0U);
}

TEST_F(ApplicationTest, AChangedScenarioIsCalledModifiedAndUndoGivesItsNameBack) {
    const std::string title = small_ring().title;
    EXPECT_EQ(application.title(), title);
    Scenario bell = run().scenario;
    bell = *with_type(*catalogue, bell, bell, SectionKind::monitor, "bell");
    application.document().change(run().id, bell);
    EXPECT_EQ(application.title(), title + " (modified)");
    EXPECT_EQ(run().scenario.modified, std::vector<std::string>{"monitor.type"});
    ASSERT_TRUE(wait_until([&] { return run().changes.settled(); }));
    EXPECT_EQ(solved_scenario().modified, std::vector<std::string>{"monitor.type"})
        << "what is exported says so";
    EXPECT_TRUE(application.document().undo());
    EXPECT_EQ(application.title(), title);
    EXPECT_TRUE(application.document().redo());
    EXPECT_EQ(application.title(), title + " (modified)");
}

/// Types into the fields of the dialog, instead of what they hold, and accepts.
class SaveAsTest : public ApplicationTest {
  protected:
    void fill(const std::string& field, const std::string& text) {
        replace_text(application.items().find(field)->second, text);
    }
    void save_as(const std::string& file, const std::string& title = {}) {
        EXPECT_TRUE(application.press_key("Ctrl+Shift+S"));
        for (int i = 0; i < 3; ++i) frame();
        fill("save.path", file);
        if (!title.empty()) fill("save.title", title);
        ui.click(application.items().find("save.ok")->second, drawing());
    }
    bool says(const std::string& text) {
        return wait_until([&] { return application.messages().last().text == text; });
    }
};

TEST_F(SaveAsTest, AsksForFileAndTitleAndGivesTheirName) {
    const std::string title = small_ring().title;
    Scenario changed = run().scenario;
    set_value(*catalogue, changed, "monitor.amplitude", 3.0);
    application.document().change(run().id, changed);
    const auto file = folder / "gentle.toml";
    const auto save = [&] { save_as(file.string(), "A gentle ring"); };
    save();
    ASSERT_TRUE(wait_until([&] { return application.title() == "A gentle ring"; })) << application.title();
    EXPECT_EQ(load_scenario(*catalogue, file).title, "A gentle ring");
    EXPECT_EQ(load_scenario(*catalogue, file).description, small_ring().description + " (modified)");
    EXPECT_EQ(run().scenario.name, "gentle");
    set_value(*catalogue, changed, "monitor.amplitude", 4.0);
    application.document().change(run().id, changed);
    EXPECT_EQ(application.title(), "A gentle ring (modified)");
    application.document().undo();
    EXPECT_EQ(application.title(), "A gentle ring") << "as it was saved";
    application.document().undo();
    EXPECT_EQ(application.title(), title) << "as it was opened";
    application.document().redo();

    std::ofstream(file) << "something else";
    save();
    frame();
    EXPECT_EQ(application.items().count("save.ok"), 1U) << "to replace it has to be confirmed";
    EXPECT_EQ(text_of(file), "something else");
    ui.click(application.items().find("save.ok")->second, drawing());
    ASSERT_TRUE(wait_until([&] { return application.messages().last().text == "Saved " + file.string(); }));
    EXPECT_EQ(load_scenario(*catalogue, file).monitor.values.real("amplitude"), 3);
    application.document().change(run().id, changed);
    EXPECT_TRUE(application.press_key("Ctrl+S"));
    ASSERT_TRUE(
        wait_until([&] { return load_scenario(*catalogue, file).monitor.values.real("amplitude") == 4; }));
}

TEST_F(SaveAsTest, ARelativePathIsNotModifiedBySavingAndIsFoundFromTheSavedFile) {
    const auto here = folder / "here", there = folder / "there";
    std::filesystem::create_directories(here);
    std::filesystem::create_directories(there);
    std::ofstream(here / "p.json") << patch_json(nurbs_disk());
    std::ofstream(here / "s.toml") << R"(title = "Disk of a file"
[domain]
type = "spline-patch"
file = "p.json"
cells = 4
[monitor]
type = "circle"
[method]
type = "picard-mixed"
)";
    application.open_file(here / "s.toml");
    ASSERT_TRUE(wait_until([&] { return application.title() == "Disk of a file"; }))
        << application.messages().last().text;
    Scenario other = run().scenario;
    set_value(*catalogue, other, "monitor.amplitude", 2.0);
    application.document().change(run().id, other);
    const auto file = there / "saved.toml";
    save_as(file.string());
    ASSERT_TRUE(says("Saved " + file.string())) << application.messages().last().text;
    frame();
    EXPECT_EQ(run().scenario.name, "saved");
    EXPECT_TRUE(run().scenario.modified.empty());
    EXPECT_EQ(run().scenario.domain.values.text("file"), "p.json") << "the run keeps its values";
    application.open_file(file);
    ASSERT_TRUE(says("Opened " + file.string())) << application.messages().last().text;
    EXPECT_EQ(run().scenario.domain.values.text("file"), "../here/p.json");
    EXPECT_TRUE(run().scenario.modified.empty());
    other = run().scenario;
    std::filesystem::copy(here / "p.json", there / "p.json");
    other.domain.values.set("file", (there / "p.json").string());
    application.document().change(run().id, other);
    EXPECT_EQ(run().scenario.modified, std::vector<std::string>{"domain.file"}) << "of the same name";
}

TEST_F(SaveAsTest, ASaveThatFailsLeavesTheFileToSaveTo) {
    const auto file = folder / "good.toml";
    save_as(file.string());
    ASSERT_TRUE(says("Saved " + file.string())) << application.messages().last().text;
    std::ofstream(folder / "obstacle") << "a file where a folder should be";
    save_as((folder / "obstacle" / "bad.toml").string());
    ASSERT_TRUE(wait_until([&] { return application.messages().error().open(); }));
    frame();
    ui.click(application.items().find("error.ok")->second, drawing());
    Scenario changed = run().scenario;
    set_value(*catalogue, changed, "monitor.amplitude", 4.0);
    application.document().change(run().id, changed);
    EXPECT_TRUE(application.press_key("Ctrl+S"));
    ASSERT_TRUE(says("Saved " + file.string())) << application.messages().last().text;
    EXPECT_EQ(load_scenario(*catalogue, file).monitor.values.real("amplitude"), 4);
}

TEST_F(SaveAsTest, TheFileIsTakenAsEverywhereElse) {
    save_as((folder / "upper.TOML").string());
    EXPECT_TRUE(says("Saved " + (folder / "upper.TOML").string())) << application.messages().last().text;
    save_as((folder / "none").string());
    EXPECT_TRUE(says("Saved " + (folder / "none.toml").string())) << application.messages().last().text;
    const char* home = std::getenv("HOME");
    const std::string before = home ? home : "";
    ::setenv("HOME", folder.c_str(), 1);
    save_as("~/at-home");
    EXPECT_TRUE(says("Saved " + (folder / "at-home.toml").string())) << application.messages().last().text;
    ::unsetenv("HOME");
    save_as("~/lost");
    EXPECT_TRUE(wait_until([&] { return application.messages().last().error; }));
    EXPECT_EQ(application.messages().last().text, "cannot expand '~/lost.toml': HOME is not set");
    if (home) ::setenv("HOME", before.c_str(), 1);
}

TEST_F(ApplicationTest, ASavedScenarioOpensAgain) {
    ASSERT_TRUE(wait_until([&] { return run().history.size() > 3; }));
    ui.drag(application.items().find("monitor.amplitude")->second, 0.4F, 0.6F, drawing());
    const double amplitude = run().scenario.monitor.values.real("amplitude");
    EXPECT_TRUE(application.press_key("Ctrl+S"));
    const auto file = folder / "plane-ring-modified" / "plane-ring-modified.toml";
    ASSERT_TRUE(wait_until([&] { return application.messages().last().text == "Saved " + file.string(); }));
    EXPECT_EQ(load_scenario(*catalogue, file).monitor.values.real("amplitude"), amplitude);
}

} // namespace
} // namespace gaspard

// Opening, saving and exporting with the dialogs of the window.
#include "core/base/read_file.hpp"
#include "core/io/figure.hpp"
#include "core/io/image.hpp"
#include "core/io/state_file.hpp"
#include "gui/app/viewport_image.hpp"
#include "gui/file_dialogs_fixture.hpp"

#include <fstream>
#include <imgui.h>
#include <iterator>

namespace gaspard {
namespace {

TEST_F(FileDialogsTest, ExportAsExportsOneFormatAtOnceAndKeepsTheChoice) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    const std::string before = run().scenario.output.text("formats");
    click("menu.File");
    click("menu.export-as");
    click("format.ply");
    ASSERT_TRUE(says("Exported to " + (folder / "plane-ring").string())) << said();
    EXPECT_TRUE(exists("plane-ring/adapted.ply"));
    EXPECT_FALSE(exists("plane-ring/adapted.obj"));
    EXPECT_EQ(run().scenario.output.text("formats"), before);
    EXPECT_FALSE(application.document().edits().can_undo());
}

TEST_F(FileDialogsTest, TheExportDialogChoosesFormatsAndFolder) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    click("action.export-to");
    click("export.obj");
    click("export.glb");
    click("export.csv");
    click("export.browse");
    EXPECT_FALSE(shows("export.obj")) << "the browser comes first";
    click("folder.new-folder");
    click("folder.new-name");
    ui.type("results", drawing());
    click("folder.new-ok");
    EXPECT_TRUE(wait_until([&] { return exists("plane-ring/results"); }));
    click("folder.cancel");
    fill("export.folder", (folder / "mine").string());
    click("export.ok");
    ASSERT_TRUE(says("Exported to " + (folder / "mine").string())) << said();
    EXPECT_TRUE(exists("mine/adapted.csv"));
    EXPECT_TRUE(exists("mine/state.bin"));
    EXPECT_FALSE(exists("mine/adapted.obj"));
    EXPECT_EQ(run().scenario.output.text("formats"), "csv") << "E exports the same";
}

TEST_F(FileDialogsTest, AnExportReplacesNothingUnlessAsked) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    const auto export_to = [&](bool replace) {
        click("action.export-to");
        fill("export.folder", (folder / "mine").string());
        if (replace) click("export.replace");
        click("export.ok");
    };
    export_to(false);
    ASSERT_TRUE(says("Exported to " + (folder / "mine").string())) << said();
    std::ofstream(folder / "mine" / "adapted.obj") << "mine";
    export_to(false);
    ASSERT_TRUE(says("Exported to " + (folder / "mine-2").string())) << said();
    EXPECT_EQ(std::filesystem::file_size(folder / "mine" / "adapted.obj"), 4U);
    export_to(true);
    ASSERT_TRUE(says("Exported to " + (folder / "mine").string())) << said();
    EXPECT_GT(std::filesystem::file_size(folder / "mine" / "adapted.obj"), 4U);
}

TEST_F(FileDialogsTest, AFigureHasTheChosenSizeAndParts) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    click("action.figure");
    click("figure.svg");
    fill("figure.width", "800");
    fill("figure.height", "600");
    fill("figure.dpi", "200");
    click("figure.legend");
    fill("figure.file", (folder / "paper").string());
    click("figure.ok");
    ASSERT_TRUE(says("Saved " + (folder / "paper.svg").string())) << said();
    EXPECT_EQ(read_file(folder / "paper.svg"), svg_of_figure(*run().snapshot, look(), small_ring().title));
    EXPECT_EQ(look().integer("width"), 800);
    EXPECT_EQ(look().real("dpi"), 200);
    EXPECT_FALSE(look().boolean("legend")) << "a script draws the same";
    EXPECT_TRUE(look().boolean("caption"));
}

TEST_F(FileDialogsTest, AFigureInMillimetresIsDrawnInPixels) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    click("action.figure");
    click("figure.unit");
    ui.move(ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y + 2.6F * ImGui::GetFontSize());
    frame(); // "mm" is the second in the list
    ui.button(true);
    frame();
    ui.button(false);
    frames(2);
    fill("figure.width", "80");
    fill("figure.height", "60");
    fill("figure.dpi", "300");
    frames(2);
    fill("figure.file", (folder / "talk").string());
    click("figure.ok");
    ASSERT_TRUE(says("Saved " + (folder / "talk.png").string())) << said();
    const Image image = read_image(folder / "talk.png");
    EXPECT_EQ(image.width, 945) << "80 mm";
    EXPECT_EQ(image.height, 709) << "60 mm";
    EXPECT_EQ(image.rgba, render_view(*run().snapshot, look(), 945, 709, small_ring().title).rgba);
    EXPECT_NE(read_file(folder / "talk.png").find("pHYs"), std::string::npos);
}

TEST_F(FileDialogsTest, TheSizeOfTextsIsDraggedOrTyped) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    click("action.figure");
    EXPECT_LT(item("figure.text_size").right, item("figure.text_size.number").left)
        << "the knob does not cover the number";
    fill("figure.text_size.number", "1.75");
    fill("figure.file", (folder / "texts").string());
    click("figure.ok");
    ASSERT_TRUE(says("Saved " + (folder / "texts.png").string())) << said();
    EXPECT_DOUBLE_EQ(look().real("text_size"), 1.75);
}

TEST_F(FileDialogsTest, TheWindowGoesOnWhileALargeFigureIsDrawn) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    draw_figure("6000", "large");
    int frames_meanwhile = 0;
    bool progress = false;
    ASSERT_TRUE(wait_until([&] {
        ++frames_meanwhile;
        progress |= shows("progress");
        return said() == "Saved " + (folder / "large.png").string();
    })) << said();
    EXPECT_TRUE(progress);
    EXPECT_GT(frames_meanwhile, 20);
    frames(2);
    EXPECT_FALSE(shows("progress"));
    EXPECT_EQ(read_image(folder / "large.png").width, 6000);
}

TEST_F(FileDialogsTest, ALargeFigureIsCancelled) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    draw_figure("6000", "large");
    ASSERT_TRUE(wait_until([&] { return shows("progress.cancel"); }));
    click("progress.cancel");
    ASSERT_TRUE(says("Cancelled.")) << said();
    EXPECT_FALSE(std::filesystem::exists(folder / "large.png"));
    frames(2);
    EXPECT_FALSE(shows("progress"));
}

TEST_F(FileDialogsTest, AFigureReplacesNothingUnlessAsked) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    std::ofstream(folder / "mine.svg") << "mine";
    click("action.figure");
    click("figure.svg");
    fill("figure.width", "10");
    fill("figure.file", (folder / "mine").string());
    click("figure.ok");
    EXPECT_TRUE(shows("figure.ok")) << "10 pixels are too few";
    fill("figure.width", "400");
    click("figure.ok");
    EXPECT_TRUE(shows("figure.ok")) << "to replace a file has to be confirmed";
    EXPECT_EQ(read_file(folder / "mine.svg"), "mine");
    click("figure.ok");
    ASSERT_TRUE(says("Saved " + (folder / "mine.svg").string())) << said();
    EXPECT_TRUE(read_file(folder / "mine.svg").starts_with("<svg"));
}

TEST_F(FileDialogsTest, FoldersAreBrowsedWithKeys) {
    std::filesystem::create_directories(folder / "one" / "inner");
    std::filesystem::create_directories(folder / "two");
    std::ofstream(folder / "one" / "inner" / "deep.toml") << to_toml(titled("Deep"));
    std::ofstream(folder / "one" / "notes.md") << "does not fit";
    std::ofstream(folder / "one" / ".hidden.toml") << "";
    application.perform("open");
    frames(4);
    fill("open.path", (folder / "").string() + "O");
    ASSERT_TRUE(wait_until([&] { return shows("open.entry.one"); }));
    EXPECT_FALSE(shows("open.entry.two")) << "only what begins as typed";
    press(ImGuiKey_Tab); // completes the name
    ASSERT_TRUE(wait_until([&] { return shows("open.entry.inner"); })) << "and enters the only folder";
    EXPECT_FALSE(shows("open.entry.notes.md"));
    EXPECT_FALSE(shows("open.entry..hidden.toml"));
    click("open.all");
    EXPECT_TRUE(wait_until([&] { return shows("open.entry.notes.md"); }));
    click("open.hidden");
    EXPECT_TRUE(wait_until([&] { return shows("open.entry..hidden.toml"); }));
    click("open.path");
    press(ImGuiKey_Backspace);
    ASSERT_TRUE(wait_until([&] { return shows("open.entry.two"); })) << "the folder above";
    press(ImGuiKey_DownArrow); // one
    press(ImGuiKey_Enter);
    ASSERT_TRUE(wait_until([&] { return shows("open.entry.inner"); }));
    frames(4);
    press(ImGuiKey_DownArrow);
    press(ImGuiKey_Enter);
    ASSERT_TRUE(wait_until([&] { return shows("open.entry.deep.toml"); }));
    frames(4);
    press(ImGuiKey_DownArrow);
    press(ImGuiKey_Enter);
    ASSERT_TRUE(wait_until([&] { return application.title() == "Deep"; })) << said();
    ASSERT_FALSE(application.settings().folders.empty());
    EXPECT_EQ(application.settings().folders.front(), (folder / "one" / "inner").string());
    EXPECT_FALSE(shows("open.path"));
    application.perform("open");
    EXPECT_TRUE(wait_until([&] { return shows("open.entry.deep.toml"); })) << "where the last file was";
}

TEST_F(FileDialogsTest, AFolderThatCannotBeReadSaysWhy) {
    const FolderListing none = list_folder({.folder = folder / "none"});
    EXPECT_EQ(none.problem, "No such file or directory");
    EXPECT_TRUE(list_folder({.folder = folder}).problem.empty());
}

TEST_F(FileDialogsTest, ListingsHaveFoldersFirstWithSizesAndTimes) {
    std::filesystem::create_directories(folder / "zoo");
    std::ofstream(folder / "a.toml") << "12345";
    std::ofstream(folder / "b.txt") << "";
    const FolderListing fits = list_folder({.folder = folder, .endings = {".toml"}});
    ASSERT_EQ(fits.entries.size(), 2U);
    EXPECT_EQ(fits.entries[0].name, "zoo");
    EXPECT_EQ(fits.entries[1].size, 5U);
    EXPECT_GT(fits.entries[1].time, 1'600'000'000);
    EXPECT_EQ(list_folder({.folder = folder}).entries.size(), 3U);
    EXPECT_EQ(list_folder({.folder = folder, .files = false}).entries.size(), 1U);
    EXPECT_EQ(list_folder({.folder = folder / "new", .create = true}).entries.size(), 0U);
    EXPECT_TRUE(exists("new"));
    EXPECT_THROW(list_folder({.folder = folder / "a.toml" / "new", .create = true}), InputError);
    EXPECT_EQ(size_text(5), "5 B");
    EXPECT_EQ(size_text(12345), "12 kB");
    EXPECT_EQ(size_text(999'999), "1.0 MB");
    EXPECT_EQ(time_text(0), "");
}

TEST_F(FileDialogsTest, AStateIsOpenedAndTheRunStartsFromIt) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    const double solved = run().history.back().residual;
    application.perform("export");
    ASSERT_TRUE(says("Exported to " + (folder / "plane-ring").string())) << said();
    application.perform("reset");
    ASSERT_TRUE(wait_until([&] { return run().history.size() == 1 && run().history[0].residual > solved; }));
    application.open_file(folder / "plane-ring" / "state.bin");
    ASSERT_TRUE(wait_until([&] { return run().ended() && run().history[0].residual <= solved * 1.0001; }))
        << said() << " " << run().history[0].residual;
    EXPECT_EQ(run().history.back().status, RunStatus::converged);
    EXPECT_FALSE(application.document().edits().can_undo());
}

TEST_F(FileDialogsTest, AStateThatDoesNotFitIsASentenceAndChangesNothing) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    State other;
    other.layout = "of something else";
    write_state(folder / "other.bin", other);
    const std::size_t rows = run().history.size();
    application.open_file(folder / "other.bin");
    ASSERT_TRUE(wait_until([&] { return application.messages().error().open(); }));
    EXPECT_NE(application.messages().error().sentence().find("of something else"), std::string::npos)
        << application.messages().error().sentence();
    EXPECT_EQ(run().history.size(), rows);
    std::ofstream(folder / "broken.bin") << "GASPARD STATE\n" << '\0' << '\0' << "no more";
    application.open_file(folder / "broken.bin");
    ASSERT_TRUE(wait_until(
        [&] { return application.messages().error().sentence().find("broken.bin") != std::string::npos; }));
}

} // namespace
} // namespace gaspard

// An application whose dialogs for files and figures are used as by a user.
#pragma once

#include "gui/application_fixture.hpp"

#include <filesystem>
#include <string>

namespace gaspard {

class FileDialogsTest : public ApplicationTest {
  protected:
    void frames(int count) {
        for (int i = 0; i < count; ++i) frame();
    }
    bool shows(const std::string& key) { return application.items().count(key) == 1; }
    ItemRectangle item(const std::string& key) {
        EXPECT_TRUE(wait_until([&] { return shows(key); })) << key;
        return shows(key) ? application.items().find(key)->second : ItemRectangle{};
    }
    void click(const std::string& key) {
        ui.click(item(key), drawing());
        frames(2);
    }
    void press(ImGuiKey key) {
        ui.key(key, true);
        frame();
        ui.key(key, false);
        frames(3);
    }
    void fill(const std::string& field, const std::string& text) {
        item(field); // waits until it is shown
        replace_text(item(field), text);
        frames(2);
    }
    bool says(const std::string& text) {
        return wait_until([&] { return application.messages().last().text == text; });
    }
    std::string said() { return application.messages().last().text; }
    bool exists(const std::string& path) { return std::filesystem::exists(folder / path); }
    Scenario titled(const std::string& title) {
        Scenario scenario = small_ring();
        scenario.title = title;
        return scenario;
    }
    /// A square PNG of so many pixels a side, by the dialog.
    void draw_figure(const std::string& pixels, const std::string& name) {
        click("action.figure");
        fill("figure.width", pixels);
        fill("figure.height", pixels);
        fill("figure.file", (folder / name).string());
        click("figure.ok");
    }
};

} // namespace gaspard

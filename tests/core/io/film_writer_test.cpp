// What is drawn and written of a film that goes on.
#include "core/base/read_file.hpp"
#include "core/io/film_writer.hpp"
#include "core/scenario/catalogue.hpp"
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"
#include "support/temporary_folder.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <vector>

namespace gaspard {
namespace {

namespace fs = std::filesystem;

class FilmWriterTest : public testing::Test {
  protected:
    FilmWriterTest() {
        const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
        Scenario scenario = find_scenario(*catalogue, "plane-ring");
        apply_settings(*catalogue, scenario, {"domain.cells=6", "method.type=auto"});
        gaspard::Run run(catalogue, scenario);
        recording_.add(*run.snapshot());
        while (run.status() == RunStatus::running) {
            run.step();
            recording_.add(*run.snapshot());
        }
        film_ = std::make_unique<Film>(FilmPlan{.last = 4}, recording_, run.snapshot(), scenario.view);
    }
    /// The frames that are drawn.
    std::vector<int> write(bool resumed) {
        std::vector<int> drawn;
        write_film(*film_, folder(),
                   {.formats = parse_film_formats("png,pvd"), .resumed = resumed, .draw = [&](int k) {
                        drawn.push_back(k);
                        return Image{2, 1, std::vector<unsigned char>(8, static_cast<unsigned char>(k))};
                    }});
        return drawn;
    }
    const fs::path& folder() const { return temporary_.path(); }
    fs::path frame(int k) const { return frame_file(folder() / "frames", k, ".png"); }
    fs::path mesh(int k) const { return frame_file(folder() / "mesh", k, ".vtu"); }

  private:
    TemporaryFolder temporary_;
    Recording recording_{std::size_t{1} << 30};
    std::unique_ptr<Film> film_;
};

TEST_F(FilmWriterTest, WhatIsNotWholeIsMadeAgain) {
    EXPECT_EQ(write(false), (std::vector<int>{0, 1, 2, 3, 4}));
    const std::string whole = read_file(frame(2)), frame_of_3 = read_file(frame(3)),
                      mesh_of_3 = read_file(mesh(3));
    const auto leave = [](const fs::path& file, const std::string& bytes) {
        std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
    };
    leave(frame(0), "");
    leave(frame(1), std::string(whole.size(), '\0'));    // blocks that were never written
    leave(frame(2), whole.substr(0, whole.size() - 12)); // without IEND
    const auto middle = whole.find("IDAT") + 6; // within the image data
    leave(frame(3), std::string(frame_of_3).replace(middle, 4, 4, '\0'));
    leave(mesh(2), "");
    leave(mesh(3), mesh_of_3.substr(0, mesh_of_3.size() / 2));
    const auto untouched = fs::last_write_time(mesh(1));
    EXPECT_EQ(write(true), (std::vector<int>{0, 1, 2, 3}));
    EXPECT_EQ(read_file(frame(2)), whole);
    EXPECT_EQ(read_file(frame(3)), frame_of_3);
    EXPECT_EQ(read_file(mesh(3)), mesh_of_3);
    EXPECT_FALSE(read_file(mesh(2)).empty());
    EXPECT_EQ(fs::last_write_time(mesh(1)), untouched);
    EXPECT_TRUE(write(true).empty());
}

} // namespace
} // namespace gaspard

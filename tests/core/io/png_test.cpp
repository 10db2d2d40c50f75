// PNG files are exchanged with libpng in both directions.
#include "core/base/error.hpp"
#include "core/base/read_file.hpp"
#include "core/io/image.hpp"
#include "support/messages.hpp"
#include "support/temporary_folder.hpp"

#include <fstream>
#include <png.h>
#include <random>

namespace gaspard {
namespace {

Image noise(int width, int height) {
    std::mt19937 random(7);
    Image image{width, height, {}};
    for (int i = 0; i < 4 * width * height; ++i)
        image.rgba.push_back(static_cast<std::uint8_t>(random() % 256));
    return image;
}

Image read_with_libpng(const std::filesystem::path& file) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    EXPECT_TRUE(png_image_begin_read_from_file(&png, file.c_str())) << png.message;
    EXPECT_EQ(png.format, PNG_FORMAT_RGBA);
    Image image{static_cast<int>(png.width), static_cast<int>(png.height), {}};
    image.rgba.resize(PNG_IMAGE_SIZE(png));
    EXPECT_TRUE(png_image_finish_read(&png, nullptr, image.rgba.data(), 0, nullptr)) << png.message;
    EXPECT_EQ(png.warning_or_error, 0u) << png.message;
    return image;
}

void write_with_libpng(const std::filesystem::path& file, int width, int height, png_uint_32 format,
                       const std::vector<std::uint8_t>& bytes) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(width);
    png.height = static_cast<png_uint_32>(height);
    png.format = format;
    ASSERT_TRUE(png_image_write_to_file(&png, file.c_str(), 0, bytes.data(), 0, nullptr)) << png.message;
}

TEST(Png, LibpngReadsEveryPixel) {
    const TemporaryFolder folder;
    for (const auto& [width, height] : {std::pair(1, 1), std::pair(37, 5), std::pair(300, 201)}) {
        const Image image = noise(width, height);
        write_png(folder / "p.png", image);
        const Image back = read_with_libpng(folder / "p.png");
        EXPECT_EQ(back.width, width);
        EXPECT_EQ(back.height, height);
        EXPECT_EQ(back.rgba, image.rgba);
    }
}

TEST(Png, IsDeterministic) {
    const TemporaryFolder folder;
    write_png(folder / "a.png", noise(64, 48));
    write_png(folder / "b.png", noise(64, 48));
    EXPECT_EQ(read_file(folder / "a.png"), read_file(folder / "b.png"));
}

TEST(Png, ReadsWhatLibpngWrites) {
    const TemporaryFolder folder;
    const Image image = noise(31, 17);
    write_with_libpng(folder / "rgba.png", 31, 17, PNG_FORMAT_RGBA, image.rgba);
    const Image back = read_image(folder / "rgba.png");
    EXPECT_EQ(back.width, 31);
    EXPECT_EQ(back.height, 17);
    EXPECT_EQ(back.rgba, image.rgba);

    write_with_libpng(folder / "rgb.png", 2, 1, PNG_FORMAT_RGB, {10, 20, 30, 40, 50, 60});
    EXPECT_EQ(read_image(folder / "rgb.png").rgba,
              (std::vector<std::uint8_t>{10, 20, 30, 255, 40, 50, 60, 255}));
    write_with_libpng(folder / "grey.png", 1, 2, PNG_FORMAT_GRAY, {77, 200});
    EXPECT_EQ(read_image(folder / "grey.png").rgba,
              (std::vector<std::uint8_t>{77, 77, 77, 255, 200, 200, 200, 255}));
}

TEST(Png, ReportsInvalidImages) {
    const TemporaryFolder folder;
    const auto message = [&](const std::string& name) {
        return message_of<InputError>([&] { read_image(folder / name); });
    };
    EXPECT_EQ(message("gone.png"),
              "cannot read " + (folder / "gone.png").string() + ": No such file or directory");
    std::filesystem::create_directory(folder / "folder.png");
    EXPECT_EQ(message("folder.png"), "cannot read " + (folder / "folder.png").string() + ": Is a directory");
    std::ofstream(folder / "text.png") << "I am not a picture\n";
    EXPECT_EQ(message("text.png").find("cannot read the image " + (folder / "text.png").string()), 0u);

    write_png(folder / "whole.png", noise(40, 40));
    const std::string bytes = read_file(folder / "whole.png");
    std::ofstream(folder / "half.png", std::ios::binary) << bytes.substr(0, bytes.size() / 2);
    EXPECT_EQ(message("half.png").find("cannot read the image " + (folder / "half.png").string()), 0u);
}

TEST(Png, FailureToWriteIsAMachineError) {
    EXPECT_THROW(write_png("/proc/gaspard/p.png", noise(2, 2)), MachineError);
    EXPECT_THROW(write_png("unused.png", Image{2, 2, {}}), InternalError);
}

} // namespace
} // namespace gaspard

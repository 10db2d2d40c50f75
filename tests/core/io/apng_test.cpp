// Animated PNG: read back frame by frame, each as a PNG of its own.
#include "core/base/error.hpp"
#include "core/base/read_file.hpp"
#include "core/io/apng.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/image.hpp"
#include "core/io/png_chunks.hpp"
#include "support/messages.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace gaspard {
namespace {

Image plain(int width, int height, std::uint8_t shade) {
    Image image{width, height, {}};
    image.rgba.assign(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), shade);
    return image;
}

unsigned number(const std::string& content, std::size_t at, int bytes) {
    unsigned value = 0;
    for (int i = 0; i < bytes; ++i)
        value = value << 8 | static_cast<unsigned char>(content.at(at + static_cast<std::size_t>(i)));
    return value;
}

class Apng : public ::testing::Test {
  public:
    std::filesystem::path frame(int k, const Image& image) {
        const auto file = folder / ("frame" + std::to_string(k) + ".png");
        write_png(file, image);
        return file;
    }
    TemporaryFolder folder;
};

TEST_F(Apng, HasEveryFrameInOrder) {
    std::vector<std::filesystem::path> frames;
    for (int k = 0; k < 3; ++k) frames.push_back(frame(k, plain(20, 10, static_cast<std::uint8_t>(50 * k))));
    write_apng(folder / "film.apng", frames, 4, 1.5);
    EXPECT_EQ(read_image(folder / "film.apng").rgba, plain(20, 10, 0).rgba) << "other readers see the first";

    unsigned next = 0; // of the chunks that are numbered
    std::vector<unsigned> delays;
    std::vector<std::string> data;
    std::string header;
    for (const PngChunk& chunk : png_chunks(read_file(folder / "film.apng"), "film")) {
        if (chunk.type == "IHDR") header = chunk.content;
        if (chunk.type == "acTL") {
            EXPECT_EQ(number(chunk.content, 0, 4), 3u);
        }
        if (chunk.type == "fcTL") {
            EXPECT_EQ(number(chunk.content, 0, 4), next++);
            EXPECT_EQ(number(chunk.content, 4, 4), 20u);
            EXPECT_EQ(number(chunk.content, 8, 4), 10u);
            delays.push_back(1000 * number(chunk.content, 20, 2) / number(chunk.content, 22, 2));
            data.emplace_back();
        }
        if (chunk.type == "IDAT") data.back() += chunk.content;
        if (chunk.type == "fdAT") {
            EXPECT_EQ(number(chunk.content, 0, 4), next++);
            data.back() += chunk.content.substr(4);
        }
    }
    EXPECT_EQ(delays, (std::vector<unsigned>{250, 250, 1750}));
    ASSERT_EQ(data.size(), 3u);
    for (int k = 0; k < 3; ++k) {
        const std::string png = std::string(png_signature) + png_chunk("IHDR", header) +
                                png_chunk("IDAT", data[static_cast<std::size_t>(k)]) + png_chunk("IEND", "");
        write_atomically(folder / "one.png", png);
        EXPECT_EQ(read_image(folder / "one.png").rgba[0], 50 * k);
    }
}

TEST_F(Apng, RefusesFramesThatDoNotFit) {
    const auto first = frame(0, plain(20, 10, 0)), other = frame(1, plain(10, 20, 0));
    EXPECT_NE(message_of<MachineError>([&] {
                  write_apng(folder / "film.apng", {first, other}, 25);
              }).find("different sizes"),
              std::string::npos);
    write_atomically(folder / "cut.png", read_file(first).substr(0, 60));
    EXPECT_NE(message_of<MachineError>([&] {
                  write_apng(folder / "film.apng", {folder / "cut.png"}, 25);
              }).find("not a complete PNG"),
              std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(folder / "film.apng"));
}

} // namespace
} // namespace gaspard

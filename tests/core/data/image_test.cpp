#include "core/base/error.hpp"
#include "core/data/image.hpp"
#include "support/picture_files.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

using Rows = std::vector<std::vector<std::uint8_t>>;

GreyImage decode(const std::string& bytes, std::size_t longest = 2048) {
    return decode_image(bytes, "picture", longest);
}

void expect_grey(const GreyImage& image, const std::vector<double>& grey, double tolerance = 1e-6) {
    ASSERT_EQ(image.grey.size(), grey.size());
    for (std::size_t i = 0; i < grey.size(); ++i)
        EXPECT_NEAR(static_cast<double>(image.grey[i]), grey[i], tolerance) << i;
}

std::string message(const std::string& bytes) {
    try {
        decode(bytes);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

double luma(double r, double g, double b) { return 0.299 * r + 0.587 * g + 0.114 * b; }

TEST(Image, ReadsGreyPngsOfAllDepths) {
    expect_grey(decode(png_bytes({.width = 4, .height = 2, .bits = 1}, {{0b10100000}, {0b01010000}})),
                {1, 0, 1, 0, 0, 1, 0, 1});
    expect_grey(decode(png_bytes({.width = 4, .height = 1, .bits = 2}, {{0b00011011}})),
                {0, 1 / 3.0, 2 / 3.0, 1});
    expect_grey(decode(png_bytes({.width = 2, .height = 1, .bits = 4}, {{0x5f}})), {1 / 3.0, 1});
    expect_grey(decode(png_bytes({.width = 2, .height = 1}, {{51, 255}})), {0.2, 1});
    expect_grey(decode(png_bytes({.width = 2, .height = 1, .bits = 16}, {{0x12, 0x34, 0xff, 0xff}})),
                {0x1234 / 65535.0, 1});
}

TEST(Image, ReadsColoursAndAlphaOverWhite) {
    const auto rgb =
        decode(png_bytes({.width = 2, .height = 1, .color = PNG_COLOR_TYPE_RGB}, {{255, 0, 0, 0, 255, 51}}));
    expect_grey(rgb, {luma(1, 0, 0), luma(0, 1, 0.2)});
    expect_grey(
        decode(png_bytes({.width = 2, .height = 1, .color = PNG_COLOR_TYPE_GRAY_ALPHA}, {{0, 51, 0, 255}})),
        {0.8, 0});
    expect_grey(decode(png_bytes({.width = 1, .height = 1, .bits = 16, .color = PNG_COLOR_TYPE_RGBA},
                                 {{0, 0, 0, 0, 0, 0, 0x80, 0}})),
                {1 - 0x8000 / 65535.0});
    const PngKind palette{.width = 3,
                          .height = 1,
                          .bits = 2,
                          .color = PNG_COLOR_TYPE_PALETTE,
                          .palette = {{255, 255, 255}, {0, 0, 255}, {0, 0, 0}},
                          .transparency = {255, 255, 0}};
    expect_grey(decode(png_bytes(palette, {{0b00011000}})), {1, luma(0, 0, 1), 1});
}

Rows gradient(int width, int height, int channels = 1) {
    Rows rows;
    for (int y = 0; y < height; ++y) {
        rows.emplace_back();
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < channels; ++c)
                rows.back().push_back(static_cast<std::uint8_t>((200 * x) / width + (50 * y) / height));
    }
    return rows;
}

TEST(Image, ReadsInterlacedPngsAsOthers) {
    const GreyImage plain = decode(png_bytes({.width = 37, .height = 21}, gradient(37, 21)));
    const GreyImage interlaced =
        decode(png_bytes({.width = 37, .height = 21, .interlaced = true}, gradient(37, 21)));
    EXPECT_EQ(plain.grey, interlaced.grey);
}

TEST(Image, AveragesLargePictures) {
    const GreyImage image = decode(
        png_bytes({.width = 5, .height = 3}, {{0, 10, 20, 30, 40}, {10, 20, 30, 40, 50}, {99, 99, 0, 0, 7}}),
        3);
    EXPECT_EQ(image.width, 3u);
    EXPECT_EQ(image.height, 2u);
    EXPECT_EQ(image.full_width, 5u);
    EXPECT_EQ(image.full_height, 3u);
    const auto of = [](double value) { return value / 255; };
    expect_grey(image, {of(10), of(30), of(45), of(99), 0, of(7)});
}

TEST(Image, ReadsJpegsOfAllColours) {
    const int w = 64, h = 48;
    const GreyImage png = decode(png_bytes({.width = w, .height = h}, gradient(w, h)));
    const std::vector<double> grey(png.grey.begin(), png.grey.end());
    for (const bool progressive : {false, true}) {
        expect_grey(decode(jpeg_bytes({.width = w, .height = h, .progressive = progressive}, gradient(w, h))),
                    grey, 0.02);
        expect_grey(decode(jpeg_bytes({.width = w, .height = h, .color = JCS_RGB, .progressive = progressive},
                                      gradient(w, h, 3))),
                    grey, 0.02);
    }
    expect_grey(
        decode(jpeg_bytes({.width = w, .height = h, .color = JCS_RGB, .stored = JCS_RGB}, gradient(w, h, 3))),
        grey, 0.02);
    // No colour and a black that grows: what is left white, as Adobe's programs store it (libjpeg writes
    // their marker).
    for (const J_COLOR_SPACE stored : {JCS_CMYK, JCS_YCCK}) {
        Rows ink = gradient(w, h, 4);
        for (auto& row : ink)
            for (std::size_t i = 0; i < row.size(); ++i)
                if (i % 4 != 3) row[i] = 255;
        expect_grey(decode(jpeg_bytes({.width = w, .height = h, .color = JCS_CMYK, .stored = stored}, ink)),
                    grey, 0.02);
    }
}

TEST(Image, ReducesLargeJpegsAsTheyAreDecoded) {
    const int w = 640, h = 480;
    const GreyImage image = decode(jpeg_bytes({.width = w, .height = h}, gradient(w, h)), 100);
    EXPECT_LE(image.width, 100u);
    EXPECT_GE(image.width, 64u);
    EXPECT_EQ(image.full_width, 640u);
    for (std::size_t x = 0; x < image.width; ++x) {
        const double place = (static_cast<double>(x) + 0.5) / static_cast<double>(image.width);
        EXPECT_NEAR(static_cast<double>(image.grey[x]) * 255, 200 * place, 4);
    }
}

/// An EXIF block with one entry.
std::vector<std::uint8_t> exif(std::uint8_t orientation, bool little) {
    std::vector<std::uint8_t> block = {'E', 'x', 'i', 'f', 0, 0};
    const std::vector<std::uint8_t> ii = {'I', 'I', 42, 0, 8, 0,           0, 0, 1, 0, 0x12, 0x01, 3,
                                          0,   1,   0,  0, 0, orientation, 0, 0, 0, 0, 0,    0,    0};
    const std::vector<std::uint8_t> mm = {'M', 'M', 0, 42, 0, 0, 0,           8, 0, 1, 0x01, 0x12, 0,
                                          3,   0,   0, 0,  1, 0, orientation, 0, 0, 0, 0,    0,    0};
    block.insert(block.end(), little ? ii.begin() : mm.begin(), little ? ii.end() : mm.end());
    return block;
}

TEST(Image, TurnsJpegsUpright) {
    // Black in the upper left, grey in the upper right, light in the lower left, white in the lower right.
    const int w = 32, h = 16;
    Rows rows(h, std::vector<std::uint8_t>(w));
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x)
            rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] =
                static_cast<std::uint8_t>(y < h / 2 ? (x < w / 2 ? 0 : 80) : (x < w / 2 ? 160 : 255));
    // Upper left, upper right, lower left and lower right corner of the upright picture.
    const int corners[9][4] = {{},
                               {0, 80, 160, 255},
                               {80, 0, 255, 160},
                               {255, 160, 80, 0},
                               {160, 255, 0, 80},
                               {0, 160, 80, 255},
                               {160, 0, 255, 80},
                               {255, 80, 160, 0},
                               {80, 255, 0, 160}};
    for (std::uint8_t orientation = 1; orientation <= 8; ++orientation)
        for (const bool little : {true, false}) {
            const GreyImage image =
                decode(jpeg_bytes({.width = w, .height = h, .exif = exif(orientation, little)}, rows));
            EXPECT_EQ(image.width, orientation >= 5 ? 16u : 32u);
            EXPECT_EQ(image.full_height, orientation >= 5 ? 32u : 16u);
            const std::size_t right = image.width - 1, bottom = image.height - 1;
            const std::size_t at[4] = {0, right, bottom * image.width, bottom * image.width + right};
            for (std::size_t k = 0; k < 4; ++k)
                EXPECT_NEAR(static_cast<double>(image.grey[at[k]]) * 255, corners[orientation][k], 6)
                    << int{orientation} << " corner " << k;
        }
}

TEST(Image, SaysWhatIsWrongInASentence) {
    const std::string png = png_bytes({.width = 64, .height = 64}, gradient(64, 64));
    const std::string jpeg = jpeg_bytes({.width = 64, .height = 64}, gradient(64, 64));
    EXPECT_EQ(message(""), "cannot read picture: the file is empty");
    EXPECT_EQ(message("hello"), "cannot read picture: it is neither a PNG nor a JPEG picture");
    EXPECT_EQ(message("GIF89a..."), "cannot read picture: it is a GIF file; convert it to PNG or JPEG");
    EXPECT_EQ(message(std::string("RIFF\1\2\3\4WEBPVP8 ")),
              "cannot read picture: it is a WebP file; convert it to PNG or JPEG");
    EXPECT_EQ(message(std::string("II*\0\1\1\1\1", 8)),
              "cannot read picture: it is a TIFF file; convert it to PNG or JPEG");
    EXPECT_EQ(message(std::string("\0\0\0\x18", 4) + "ftypheic"),
              "cannot read picture: it is a HEIC file; convert it to PNG or JPEG");
    EXPECT_EQ(message("BM123456"), "cannot read picture: it is a BMP file; convert it to PNG or JPEG");
    EXPECT_EQ(message("<?xml version=\"1.0\"?><svg>"),
              "cannot read picture: it is an SVG file; convert it to PNG or JPEG");
    EXPECT_EQ(message(png.substr(0, png.size() / 2)), "cannot read picture: the PNG picture is incomplete");
    EXPECT_EQ(message(png.substr(0, 20)), "cannot read picture: the PNG picture is incomplete");
    EXPECT_EQ(message(jpeg.substr(0, jpeg.size() / 2)),
              "cannot read picture: the JPEG picture is incomplete");
    std::string damaged = png;
    damaged[png.size() / 2] = static_cast<char>(damaged[png.size() / 2] ^ 0x55);
    EXPECT_EQ(message(damaged), "cannot read picture: the PNG picture is damaged");
    // 100000 x 100000 pixels in a few bytes.
    std::string huge = png;
    for (const std::size_t at : {16, 20}) huge.replace(at, 4, std::string("\0\1\x86\xa0", 4));
    const std::string error = message(huge); // the checksum of the header is wrong, too
    EXPECT_TRUE(error == "cannot read picture: the PNG picture is damaged" ||
                error.find("megapixels") != std::string::npos)
        << error;
}

TEST(Image, RefusesPicturesThatAreTooLarge) {
    std::string jpeg = jpeg_bytes({.width = 64, .height = 64}, gradient(64, 64));
    const std::size_t frame = jpeg.find("\xff\xc0");
    ASSERT_NE(frame, std::string::npos);
    jpeg.replace(frame + 5, 4, std::string("\xff\x00\xff\x00", 4)); // height and width
    EXPECT_EQ(message(jpeg),
              "cannot read picture: the picture has 65280 x 65280 pixels; at most 200 megapixels are "
              "allowed");
}

TEST(Image, RefusesPicturesWithTooLongASide) {
    const std::string png = png_bytes({.width = 70000, .height = 1}, {std::vector<std::uint8_t>(70000)});
    EXPECT_EQ(message(png), "cannot read picture: the picture has 70000 x 1 pixels; each side may have "
                            "65535");
}

TEST(Image, StopsWhenAsked) {
    const std::string png = png_bytes({.width = 64, .height = 64}, gradient(64, 64));
    const std::string jpeg = jpeg_bytes({.width = 64, .height = 64, .progressive = true}, gradient(64, 64));
    std::stop_source source;
    source.request_stop();
    for (const std::string& bytes : {png, jpeg})
        EXPECT_THROW(decode_image(bytes, "picture", 2048, {}, source.get_token()), Interrupted);
}

} // namespace
} // namespace gaspard

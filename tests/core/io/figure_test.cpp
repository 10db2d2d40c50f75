// Figures as PDF and SVG, and the resolution of PNG files.
#include "core/base/read_file.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/figure.hpp"
#include "core/io/formats.hpp"
#include "core/io/image.hpp"
#include "core/io/pdf.hpp"
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"
#include "support/temporary_folder.hpp"

#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <sstream>

namespace gaspard {
namespace {

class FigureTest : public testing::Test {
  protected:
    explicit FigureTest(const std::string& name = "plane-ring")
        : scenario(find_scenario(*catalogue, name)), run(catalogue, [&] {
              if (name == "plane-ring") set_value(*catalogue, scenario, "domain.cells", std::int64_t{8});
              return scenario;
          }()) {}

    std::string svg() const { return svg_of_figure(*run.snapshot(), view, "a ring"); }
    static bool has(const std::string& text, const std::string& part) {
        return text.find(part) != std::string::npos;
    }
    /// What a tool of Poppler says of a PDF.
    std::string tool(const std::string& command, const std::string& pdf, const std::string& to = "") const {
        const auto file = folder.path() / "figure.pdf", out = folder.path() / "said.txt";
        write_atomically(file, pdf);
        const std::string line = command + " " + file.string() + to + " > " + out.string();
        EXPECT_EQ(std::system(line.c_str()), 0) << line;
        return read_file(out);
    }

    std::shared_ptr<const Catalogue> catalogue = std::make_shared<Catalogue>(builtin_catalogue());
    Scenario scenario;
    mutable gaspard::Run run;
    Values view = run.scenario().view;
    TemporaryFolder folder;
};

TEST_F(FigureTest, APageHasTheSizeOfTheViewInMillimetres) {
    EXPECT_TRUE(has(svg(), "width=\"120mm\" height=\"90mm\"")) << svg().substr(0, 300);
    view.set("width", std::int64_t{1000});
    view.set("height", std::int64_t{500});
    view.set("dpi", 508.0);
    EXPECT_TRUE(has(svg(), "width=\"50mm\" height=\"25mm\"")) << svg().substr(0, 300);
    view.set("text_size", 2.0); // texts are larger, the page is not
    EXPECT_TRUE(has(svg(), "width=\"50mm\" height=\"25mm\"")) << svg().substr(0, 300);
    EXPECT_TRUE(has(svg(), "viewBox=\"0 0 70.87 35.43\"")) << svg().substr(0, 300);
}

TEST_F(FigureTest, LegendCaptionAndNoteAreShownOrNot) {
    EXPECT_TRUE(has(svg(), "id=\"legend\""));
    EXPECT_TRUE(has(svg(), "a ring · iteration 0"));
    view.set("legend", false);
    EXPECT_FALSE(has(svg(), "id=\"legend\""));
    EXPECT_TRUE(has(svg(), "a ring"));
    view.set("caption", false);
    EXPECT_FALSE(has(svg(), "a ring"));
    Snapshot folded = *run.snapshot();
    folded.x.x[40] += 0.3;
    folded.tangled = std::make_shared<const std::vector<std::uint32_t>>(std::vector<std::uint32_t>{3, 4});
    EXPECT_TRUE(has(svg_of_figure(folded, view), "2 tangled cells"));
    view.set("note", false);
    EXPECT_FALSE(has(svg_of_figure(folded, view), "tangled cell"));
}

TEST_F(FigureTest, AHighMeshFitsOnALowPage) {
    view.set("width", std::int64_t{1200});
    view.set("height", std::int64_t{400}); // the mesh is a square
    const std::string text = svg();
    EXPECT_TRUE(has(text, "width=\"120mm\" height=\"40mm\""));
    const std::string pixels = tool("pdftotext -bbox", pdf_of_svg(text), " -");
    std::istringstream lines(pixels);
    int words = 0;
    for (std::string line; std::getline(lines, line);)
        if (const auto at = line.find("yMax=\""); at != std::string::npos) {
            ++words;
            EXPECT_LE(std::stod(line.substr(at + 6)), 40 / 25.4 * 72) << line;
        }
    EXPECT_GT(words, 5) << pixels;
}

TEST_F(FigureTest, APdfHasVectorsTextAndTheSizeOfThePageInPoints) {
    const std::string pdf = pdf_of_svg(svg());
    EXPECT_TRUE(pdf.starts_with("%PDF"));
    EXPECT_EQ(pdf, pdf_of_svg(svg())) << "the same bytes";
    EXPECT_TRUE(has(tool("pdfinfo", pdf), "340.157 x 255.118 pts"));
    EXPECT_TRUE(has(tool("pdftotext -layout", pdf, " -"), "monitor"));
    EXPECT_FALSE(has(tool("pdfimages -list", pdf), "image")) << "vectors, no pixels";
    EXPECT_THROW(pdf_of_svg("no drawing"), MachineError);
}

TEST_F(FigureTest, TheFormatWritesFigurePdf) {
    const auto chosen = parse_formats("pdf");
    const auto snapshot = run.snapshot();
    const RunResult result{*snapshot, run.history(), run.space(), view};
    chosen.front()->write(folder.path(), result);
    EXPECT_TRUE(read_file(folder.path() / "figure.pdf").starts_with("%PDF"));
}

TEST_F(FigureTest, PngFilesHaveTheirResolution) {
    const Image image{2, 1, std::vector<std::uint8_t>(8, 100)};
    const auto file = folder.path() / "a.png";
    write_png(file, image, 300);
    const std::string bytes = read_file(file);
    const auto at = bytes.find("pHYs");
    ASSERT_NE(at, std::string::npos);
    const auto byte = [&](std::size_t i) {
        return static_cast<unsigned>(static_cast<unsigned char>(bytes[at + i]));
    };
    EXPECT_EQ((byte(4) << 24U) + (byte(5) << 16U) + (byte(6) << 8U) + byte(7), 11811U) << "pixels per metre";
    EXPECT_EQ(byte(12), 1U);
    EXPECT_EQ(read_image(file).rgba, image.rgba);
    write_png(file, image);
    EXPECT_EQ(read_file(file).find("pHYs"), std::string::npos);
}

class IntervalFigureTest : public FigureTest {
  protected:
    IntervalFigureTest() : FigureTest("layer-1d") {}
};

TEST_F(IntervalFigureTest, PlotsOfAnIntervalFillThePage) {
    view.set("layout", std::string("side-by-side"));
    EXPECT_TRUE(has(svg(), "width=\"120mm\" height=\"90mm\"")) << svg().substr(0, 300);
    EXPECT_TRUE(has(tool("pdfinfo", pdf_of_svg(svg())), "340.157 x 255.118 pts"));
}

} // namespace
} // namespace gaspard

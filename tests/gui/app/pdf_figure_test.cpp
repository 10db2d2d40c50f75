// Figures as PDF from the window. Not among the tests of threads: ThreadSanitizer does not see the locks of
// the libraries that make PDF.
#include "core/base/read_file.hpp"
#include "core/io/figure.hpp"
#include "core/io/pdf.hpp"
#include "gui/file_dialogs_fixture.hpp"

namespace gaspard {
namespace {

class PdfFigureTest : public FileDialogsTest {};

TEST_F(PdfFigureTest, IsTheFigureAsPdf) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    click("action.figure");
    click("figure.pdf");
    fill("figure.width", "800");
    fill("figure.file", (folder / "paper").string());
    click("figure.ok");
    ASSERT_TRUE(says("Saved " + (folder / "paper.pdf").string())) << said();
    const std::string pdf = read_file(folder / "paper.pdf");
    EXPECT_TRUE(pdf.starts_with("%PDF"));
    EXPECT_EQ(pdf, pdf_of_svg(svg_of_figure(*run().snapshot, look(), small_ring().title)));
}

} // namespace
} // namespace gaspard

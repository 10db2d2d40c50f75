#include "core/base/error.hpp"
#include "core/mesh/mesh.hpp"
#include "core/scenario/view_rows.hpp"
#include "core/tessellate/check_view.hpp"
#include "core/tessellate/pick.hpp"
#include "support/messages.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

TEST(CheckView, SaysWhatIsWrong) {
    Values values("view", view_rows());
    const Mesh mesh = unit_square_mesh(4);
    EXPECT_NO_THROW(check_view(values, &mesh));
    values.set("camera", std::string("nowhere"));
    EXPECT_NE(message_of<InputError>([&] { check_view(values); }).find("the camera 'nowhere'"),
              std::string::npos);
    values.set("camera", std::string());
    values.set("pick", std::string("cell 16"));
    EXPECT_NO_THROW(check_view(values));
    EXPECT_NE(message_of<InputError>([&] { check_view(values, &mesh); }).find("16 cells"), std::string::npos);
    values.set("pick", std::string("node 24"));
    EXPECT_NO_THROW(check_view(values, &mesh));
    for (const char* wrong : {"", "white", "#12345", "#12345g", "#+12345", "#1234567"}) {
        values.set("background", std::string(wrong));
        EXPECT_NE(message_of<InputError>([&] { check_view(values); })
                      .find("view.background must be theme, transparent or a colour as #rrggbb"),
                  std::string::npos)
            << wrong;
    }
    for (const char* right : {"theme", "transparent", "#09afAF"}) {
        values.set("background", std::string(right));
        EXPECT_NO_THROW(check_view(values)) << right;
    }
    values.set("range", std::string("fixed"));
    values.set("low", 2.0);
    EXPECT_NE(
        message_of<InputError>([&] { check_view(values); }).find("view.low = 2 must be below view.high = 1"),
        std::string::npos);
}

TEST(Pick, TextsReadBackAndOthersAreRefused) {
    for (const Pick& pick : {Pick{Pick::Kind::cell, 0}, Pick{Pick::Kind::node, 4294967295U}})
        EXPECT_EQ(parse_pick(format_pick(pick)), pick);
    EXPECT_FALSE(parse_pick(""));
    for (const char* text :
         {"cell", "cell x", "12", "cell -1", "node 1.5", "edge 3", "cell  4", "cell 99999999999"})
        EXPECT_NE(message_of<InputError>([&] { parse_pick(text); }).find("neither a cell nor a node"),
                  std::string::npos)
            << text;
}

} // namespace
} // namespace gaspard

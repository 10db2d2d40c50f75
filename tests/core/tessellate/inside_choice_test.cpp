// What view.cut, view.layers and view.only may say, and which faces of cells meet.
#include "core/base/error.hpp"
#include "core/scenario/view_rows.hpp"
#include "core/tessellate/check_view.hpp"
#include "core/tessellate/inside_choice.hpp"
#include "core/tessellate/key_table.hpp"
#include "core/tessellate/solid_faces.hpp"
#include "fixtures/fixture_meshes.hpp"
#include "support/messages.hpp"
#include "support/small_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <string>

namespace gaspard {
namespace {

TEST(CutPlanes, TextsReadBack) {
    for (const char* text : {"", "x 0.5", "-y -2", "x 0.5 and z 1e-3; -x 0.25", "normal 0.6 0 0.8 at 1 2 3",
                             "z 0 and normal 0.6 -0.8 0 at 0 0 0.5"}) {
        const auto cut = parse_cut(text);
        EXPECT_EQ(format_cut(parse_cut(format_cut(cut))), format_cut(cut)) << text;
        EXPECT_EQ(format_cut(flipped(flipped(cut))), format_cut(cut)) << text;
    }
    EXPECT_EQ(format_cut(parse_cut("  x   0.50 ")), "x 0.5");
    EXPECT_EQ(format_cut(parse_cut("normal 0 0 -3 at 1 2 0.5")), "-z 0.5");
    const auto cut = parse_cut("x 0.5 and -y 1/4; normal 2 0 0 at 1 1 1");
    ASSERT_EQ(cut.size(), 2U);
    ASSERT_EQ(cut[0].size(), 2U);
    EXPECT_EQ(cut[0][1].normal, (Vec3{0, -1, 0}));
    EXPECT_EQ(cut[0][1].distance({0, 0.05, 0}), 0.2);
    EXPECT_EQ(cut[1][0].distance({3, 0, 0}), 2);
}

TEST(CutPlanes, OthersAreRefusedWithOneSentence) {
    for (const char* wrong :
         {"x", "w 0.5", "x 0.5;", "x 0.5 and", "and", "x nan", "normal 0 0 0 at 0 0 0", "normal 1 0 at 0 0 0",
          "x 1; x 1; x 1; x 1; x 1; x 1; x 1; x 1; x 1", "x 1e400", "--x 1"}) {
        const std::string why = message_of<InputError>([&] { parse_cut(wrong); });
        EXPECT_TRUE(why.starts_with("view.cut = '" + std::string(wrong) + "' ")) << why;
    }
}

TEST(InsideChoice, IsReadFromTheView) {
    Values view("view", view_rows());
    EXPECT_FALSE(inside_choice(view).looks_inside());
    view.set("cut_cells", std::string("whole"));
    EXPECT_FALSE(inside_choice(view).looks_inside()) << "nothing is cut";
    view.set("layers", std::string("k 0 ; i 4 to 11"));
    view.set("only", std::string("jacobian < 0.5 and monitor>=2"));
    const InsideChoice choice = inside_choice(view);
    EXPECT_TRUE(choice.looks_inside());
    EXPECT_EQ(choice.layers[0], (LayerRange{4, 11}));
    EXPECT_EQ(choice.layers[1], LayerRange{});
    EXPECT_EQ(choice.layers[2], (LayerRange{0, 0}));
    ASSERT_EQ(choice.only.size(), 2U);
    EXPECT_EQ(choice.only[1], (CellCondition{"monitor", Relation::at_least, 2}));
    EXPECT_TRUE(choice.only[1].holds(2));
    EXPECT_FALSE(choice.only[0].holds(0.5));
    EXPECT_FALSE(choice.only[0].holds(std::numeric_limits<double>::quiet_NaN()));
}

TEST(InsideChoice, OtherTextsAreRefused) {
    const auto why = [](const char* key, const char* text) {
        Values view("view", view_rows());
        view.set(key, std::string(text));
        return message_of<InputError>([&] { check_view(view); });
    };
    for (const char* wrong : {"i", "i 1 to", "l 1", "i 2 to 1", "i 1; i 2", "i -1", "i 1 2 3", ";"})
        EXPECT_TRUE(why("layers", wrong).starts_with("view.layers = '")) << wrong;
    for (const char* wrong : {"jacobian", "jacobian < ", "< 1", "colour > 1", "none < 1", "area < 1 and",
                              "area < 1 or area > 2", "area < x"})
        EXPECT_TRUE(why("only", wrong).starts_with("view.only = '")) << wrong;
}

TEST(InsideChoice, LayersMustBeThere) {
    Values view("view", view_rows());
    view.set("layers", std::string("j 3"));
    const Mesh cube = cube_mesh(3), square = unit_square_mesh(4);
    EXPECT_EQ(message_of<InputError>([&] { check_view(view, &cube); }),
              "view.layers: the mesh has 3 layers of cells in direction j, counted from 0");
    EXPECT_EQ(message_of<InputError>([&] { check_view(view, &square); }),
              "view.layers is only for meshes whose cells are a lattice");
    view.set("layers", std::string("j 0 to 2"));
    EXPECT_NO_THROW(check_view(view, &cube));
}

TEST(SolidFaces, JoinCellsAndCountLayers) {
    const SolidFaces two = solid_faces(two_cubes());
    EXPECT_EQ(std::count(two.partners.begin(), two.partners.end(), SolidFaces::none), 10);
    const auto inner = static_cast<std::uint32_t>(
        std::find_if(two.partners.begin(), two.partners.end(), [](auto p) { return p != SolidFaces::none; }) -
        two.partners.begin());
    EXPECT_EQ(two.cell_beyond(inner), 1U);
    EXPECT_EQ(two.partners[two.partners[inner]], inner);

    const int n = 7;
    const SolidFaces faces = solid_faces(cube_mesh(n));
    for (int c = 0; c < n * n * n; ++c) {
        int depth = n;
        for (const int i : {c % n, c / n % n, c / n / n}) depth = std::min({depth, i, n - 1 - i});
        EXPECT_EQ(faces.depths[static_cast<std::size_t>(c)], static_cast<std::uint32_t>(depth));
    }
}

TEST(KeyTable, KeepsNumbersByKey) {
    KeyTable table;
    std::map<std::uint64_t, std::uint32_t> expected;
    std::uint64_t key = 1;
    for (std::uint32_t i = 0; i < 20000; ++i) {
        key = key * 6364136223846793005ULL + 1442695040888963407ULL;
        const std::uint64_t some = key >> 48;
        std::uint32_t& number = table[some];
        const auto known = expected.find(some);
        EXPECT_EQ(number, known == expected.end() ? KeyTable::missing : known->second);
        number = expected[some] = i;
    }
    table.clear();
    EXPECT_EQ(table[expected.begin()->first], KeyTable::missing);
}

} // namespace
} // namespace gaspard

#include "core/base/error.hpp"
#include "core/scenario/toml.hpp"
#include "gui/app/file_kinds.hpp"

#include <gtest/gtest.h>
#include <set>

namespace gaspard {
namespace {

using namespace std::string_view_literals;

TEST(FileKinds, ContentComesBeforeTheName) {
    EXPECT_EQ(use_of("a.PNG", ""), FileUse::image);
    EXPECT_EQ(use_of("photo", "\x89PNG\r\n\x1a\n....."), FileUse::image);
    EXPECT_EQ(use_of("photo.csv", "\xff\xd8\xff\xe0"), FileUse::image);
    EXPECT_EQ(use_of("data", "CDF\x01"sv), FileUse::field);
    EXPECT_EQ(use_of("data", "\x89HDF\r\n\x1a\n"sv), FileUse::field);
    for (const char* name : {"t.vtu", "t.vti", "t.vtr", "t.vts", "t.vtp", "t.vtk", "t.txt", "t.csv"})
        EXPECT_EQ(use_of(name, "<VTKFile"), FileUse::field) << name;
    EXPECT_EQ(use_of("p.xml", "<?xml"), FileUse::patch);
    EXPECT_EQ(use_of("p.json", "{"), FileUse::patch);
    EXPECT_EQ(use_of("p.json", "{\"degrees\": [2, 2], \"knots\""), FileUse::patch);
    EXPECT_EQ(use_of("p.json", "{\"degrees\": [2, 2, 1], \"knots\""), FileUse::solid);
    EXPECT_EQ(use_of("p.xml", "<xml> <Geometry type=\"TensorNurbs3\""), FileUse::solid);
    EXPECT_EQ(use_of("p.xml", "<xml> <Geometry type=\"TensorNurbs2\"/> <Geometry type=\"TensorBSpline3\""),
              FileUse::patch);
    const std::string late =
        "{\"control_points\": [" + std::string(200'000, ' ') + "], \"degrees\": [2, 2, 1]}";
    EXPECT_EQ(use_of("p.json", late.substr(0, head_size)), FileUse::solid) << "degrees behind many points";
    for (const char* name : {"m.obj", "m.off", "m.PLY", "m.stl"}) EXPECT_EQ(use_of(name, ""), FileUse::mesh);
    EXPECT_EQ(use_of("s.toml", "title"), FileUse::scenario);
    EXPECT_EQ(use_of("letter.pdf", "%PDF"), std::nullopt);
    EXPECT_EQ(use_of("none", ""), std::nullopt);
}

TEST(FileKinds, EveryEndingIsThereOnceAndIsNamed) {
    std::set<std::string_view> seen;
    for (const std::string_view ending : endings_of()) {
        EXPECT_TRUE(seen.insert(ending).second) << ending;
        EXPECT_NE(what_opens().find(ending), std::string::npos) << what_opens();
    }
}

TEST(FileKinds, AnImageBecomesTheMonitorAndTheRestStays) {
    const Catalogue catalogue = builtin_catalogue();
    for (const char* name : {"plane-ring", "walls-ring", "sphere-x2", "spline-circle"}) {
        const Scenario before = find_scenario(catalogue, name);
        const Scenario after = with_file(catalogue, before, before, FileUse::image, "/there/a.png");
        EXPECT_EQ(after.monitor.type, "image") << name;
        EXPECT_EQ(after.monitor.values.text("file"), "/there/a.png") << name;
        EXPECT_EQ(after.domain, before.domain) << name;
        EXPECT_EQ(after.method, before.method) << name;
        EXPECT_NO_THROW(check(catalogue, after)) << name;
        Scenario turned = after;
        turned.monitor.values.set("invert", true);
        EXPECT_TRUE(with_file(catalogue, before, turned, FileUse::image, "/there/b.png")
                        .monitor.values.boolean("invert"))
            << "the next picture keeps the settings";
    }
}

TEST(FileKinds, APatchBecomesTheDomain) {
    const Catalogue catalogue = builtin_catalogue();
    Scenario before = find_scenario(catalogue, "spline-circle");
    const Scenario after = with_file(catalogue, before, before, FileUse::patch, "/there/p.xml");
    EXPECT_EQ(after.domain.type, "spline-patch");
    EXPECT_EQ(after.domain.values.text("file"), "/there/p.xml");
    Scenario third = after;
    third.domain.values.set("patch", std::string("3"));
    EXPECT_EQ(with_file(catalogue, before, third, FileUse::patch, "/there/q.xml").domain.values.text("patch"),
              "")
        << "the number is of the file before";
}

TEST(FileKinds, AMeshBecomesTheSourceOfTransport) {
    const Catalogue catalogue = builtin_catalogue();
    for (const char* name : {"plane-ring", "transport-ring"}) {
        const Scenario before = find_scenario(catalogue, name);
        const Scenario after = with_file(catalogue, before, before, FileUse::mesh, "/there/m.obj");
        EXPECT_EQ(after.domain.type, "convex") << name;
        EXPECT_EQ(after.domain.values.text("shape"), "file") << name;
        EXPECT_EQ(after.domain.values.text("file"), "/there/m.obj") << name;
        EXPECT_EQ(after.monitor.type, "ring") << name;
        EXPECT_NO_THROW(check(catalogue, after)) << name;
    }
}

} // namespace
} // namespace gaspard

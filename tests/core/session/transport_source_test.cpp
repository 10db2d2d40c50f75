// Sources of transport whose meshes are files.
#include "core/base/error.hpp"
#include "core/io/formats.hpp"
#include "core/scenario/data_files.hpp"
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"
#include "core/transport/ring_mesh.hpp"
#include "support/messages.hpp"
#include "support/temporary_folder.hpp"

#include <fstream>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

class TransportSource : public testing::Test {
  protected:
    Scenario on(const std::string& file, const std::vector<std::string>& settings = {}) const {
        Scenario scenario = find_scenario(*catalogue, "transport-ellipse");
        apply_settings(*catalogue, scenario, {"domain.shape=file", "domain.file=" + file});
        apply_settings(*catalogue, scenario, settings);
        return scenario;
    }
    gaspard::Run solved(const Scenario& scenario) const {
        gaspard::Run run(catalogue, scenario);
        run.solve();
        EXPECT_EQ(run.status(), RunStatus::converged);
        return run;
    }
    std::string written(const std::string& name, const std::string& text) const {
        std::ofstream(folder / name) << text;
        return (folder / name).string();
    }
    /// What is said of an OBJ file with these lines, after its name.
    std::string source_refusal(const std::string& obj) const {
        const std::string file = written("bad.obj", obj);
        std::string text = message_of<InputError>([&] { gaspard::Run run(catalogue, on(file)); });
        for (const std::string start : {"domain.file: cannot read ", "domain.file: "})
            if (text.starts_with(start + file + ": ")) return text.substr((start + file + ": ").size());
        return "not about the file: " + text;
    }

    std::shared_ptr<const Catalogue> catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    TemporaryFolder folder;
};

const std::string flat_square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

// Coordinates of a file are rounded: nodes of the half disk are beyond the circle by up to 1e-10.
TEST_F(TransportSource, DensitiesMayEndAtItsBoundary) {
    for (const char* expression : {"1 - x^2 - y^2", "sqrt(1 - x^2 - y^2)"}) {
        const gaspard::Run run(
            catalogue, on("gaspard:half-disk.obj", {"monitor.source.type=formula",
                                                    std::string("monitor.source.expression=") + expression}));
        EXPECT_EQ(run.status(), RunStatus::running);
    }
}

TEST_F(TransportSource, SaysWhichKeysAndHowManyRefinementsAreOfUse) {
    EXPECT_NE(message_of<InputError>([&] { on("gaspard:half-disk.obj", {"domain.cells=16"}); })
                  .find("domain.cells is not a key for domain 'convex' as it is set, but with domain.shape = "
                        "ellipse; "
                        "available: shape"),
              std::string::npos);
    const std::string one = written("one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_NE(message_of<InputError>([&] {
                  gaspard::Run run(catalogue, on(one));
              }).find("set domain.refinements = 2"),
              std::string::npos);
    gaspard::Run refined(catalogue, on(one, {"domain.refinements=2"}));
    EXPECT_EQ(refined.discretisation().mesh()->cell_count(), 16U);
}

TEST_F(TransportSource, BeginsBehindAByteOrderMark) {
    const std::string mark = "\xef\xbb\xbf",
                      square = flat_square + "v 0.5 0.5 0\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";
    const gaspard::Run run(catalogue, on(written("marked.obj", mark + square)));
    EXPECT_EQ(run.discretisation().mesh()->node_count(), 5U);
}

TEST_F(TransportSource, ThinDomainsAreNoted) {
    const std::string thin = "v 0 0 0\nv 1 0 0\nv 1 1e-4 0\nv 0 1e-4 0\nv 0.5 0.5e-4 0\n"
                             "f 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";
    const auto note = [&](const Scenario& scenario) {
        const gaspard::Run run(catalogue, scenario);
        return run.monitor_report() && !run.monitor_report()->notes.empty()
                   ? run.monitor_report()->notes.back()
                   : std::string();
    };
    EXPECT_TRUE(note(on(written("thin.obj", thin))).starts_with("The source is 10000 times as long as wide"));
    Scenario extreme = find_scenario(*catalogue, "transport-ellipse");
    apply_settings(*catalogue, extreme, {"domain.target.a=1e6", "domain.target.b=1e-6"});
    EXPECT_TRUE(note(extreme).starts_with("The target is more than 1000000 times as long as wide"))
        << note(extreme);
}

TEST_F(TransportSource, TypesThatAreNotPossibleAreRefused) {
    const auto refusal = [&](const std::vector<std::string>& settings, const char* name) {
        Scenario scenario = find_scenario(*catalogue, name);
        return message_of<InputError>([&] { apply_settings(*catalogue, scenario, settings); });
    };
    EXPECT_EQ(refusal({"monitor.source.type=spiral"}, "transport-ellipse"),
              "monitor.source.type = spiral is not possible on domain 'convex' with method 'nvfem'");
    EXPECT_EQ(refusal({"pde.type=reaction-diffusion-2d"}, "layer-1d"),
              "pde.type = reaction-diffusion-2d is not possible on domain 'interval' with method 'mesh-pde'");
    Scenario scenario = find_scenario(*catalogue, "layer-1d"); // in any order
    apply_settings(*catalogue, scenario, {"pde.type=reaction-diffusion-2d", "domain.type=quadrilateral"});
    EXPECT_EQ(scenario.pde.type, "reaction-diffusion-2d");
    EXPECT_NE(
        refusal({"domain.file=m.obj"}, "transport-ellipse")
            .find("not a key for domain 'convex' as it is set, but with domain.shape = file; available: "),
        std::string::npos);
}

// An iterate of Newton's method may leave a patch so far that its places are none.
TEST_F(TransportSource, FormulasMayBeAskedForPlacesThatAreNone) {
    Scenario scenario = find_scenario(*catalogue, "spline-formula");
    apply_settings(*catalogue, scenario,
                   {"monitor.ranges=", "domain.type=spline-disk", "domain.cells=32", "method.type=newton",
                    "monitor.expression=1+50/cosh(20*((x-0.8)^2+(y-0.45)^2))^2"});
    gaspard::Run run(catalogue, scenario);
    EXPECT_EQ(run.solve().status, RunStatus::converged);
}

TEST_F(TransportSource, PackedFilesAreKnownByTheirContent) {
    const std::string corners = "0 0 0\n2 0 0\n2 2 0\n0 2 0\n1 1 0\n";
    const std::string faces = "3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n";
    const std::string off = written("m.off", "# of a program\n\nOFF\n5 4 0\n" + corners + faces);
    const std::string ply = written("m.ply", "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\n"
                                             "property float y\nproperty float z\nelement face 4\n"
                                             "property list uchar int vertex_indices\nend_header\n" +
                                                 corners + faces);
    for (const std::string& file : {off, ply}) {
        const Scenario packed = with_packed_data(on(file));
        EXPECT_NE(packed.domain.values.text("file"), file);
        const gaspard::Run run(catalogue, packed);
        EXPECT_EQ(run.discretisation().mesh()->cell_count(), 4U) << file;
    }
}

TEST_F(TransportSource, AMeshOfOurOwnExportIsReadBack) {
    const Mesh mesh = ring_mesh(*ellipse({4, -2, 0}, 2, 1, 20), 8).mesh;
    write_obj(folder / "ellipse.obj", mesh, mesh.nodes);
    Snapshot snapshot;
    snapshot.mesh = std::make_shared<const Mesh>(mesh);
    snapshot.x = mesh.nodes;
    write_ply(folder / "ellipse.ply", snapshot);
    for (const char* name : {"ellipse.obj", "ellipse.ply"})
        for (const char* degree : {"1", "2", "3"}) {
            const auto run = solved(on((folder / name).string(), {std::string("domain.degree=") + degree}));
            EXPECT_EQ(run.discretisation().mesh()->cell_count(), mesh.cell_count());
            EXPECT_LT(norm(bounding_box(run.discretisation().mesh()->nodes).centre() - Vec3{4, -2, 0}), 1e-9);
            EXPECT_EQ(run.history().back().tangled_cells, 0U);
            EXPECT_NEAR(*run.history().back().value("area_error"), 0, 0.03) << name << degree;
        }
}

TEST_F(TransportSource, AllFormatsGiveTheSameMap) {
    const std::string obj = written("m.obj", flat_square + "f 1 2 3\nf 1 3 4\n"),
                      off = written("m.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n"),
                      stl = written("m.stl",
                                    "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                                    "vertex 1 1 0\nendloop\nendfacet\nfacet normal 0 0 1\nouter loop\n"
                                    "vertex 0 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\n"
                                    "endsolid\n"),
                      quad = written("q.obj", flat_square + "f 1 2 3 4\n");
    const auto residual = [&](const std::string& file) {
        return gaspard::Run(catalogue, on(file, {"domain.refinements=3"})).history().front().residual;
    };
    const double first = residual(obj);
    EXPECT_GT(first, 0);
    EXPECT_EQ(residual(off), first);
    EXPECT_EQ(residual(stl), first);
    EXPECT_EQ(residual(quad), first) << "cut along its first diagonal, which is as short as the other";
}

TEST_F(TransportSource, RefinementsDivideTriangles) {
    const std::string file = written("m.obj", flat_square + "f 1 2 3\nf 1 3 4\n");
    double area_error = 1;
    for (const char* refinements : {"3", "4"}) {
        const auto run = solved(on(file, {std::string("domain.refinements=") + refinements}));
        EXPECT_EQ(run.discretisation().mesh()->cell_count(), refinements[0] == '3' ? 128U : 512U);
        const double error = std::abs(*run.history().back().value("area_error"));
        EXPECT_LT(error, area_error);
        area_error = error;
    }
    EXPECT_LT(area_error, 0.02);
}

TEST_F(TransportSource, BadFilesAreRefusedInOneSentence) {
    for (const auto& [obj, sentence] : std::initializer_list<std::pair<std::string, std::string>>{
             {"v 0 0 0\nv 1 0 0\nv .4 .4 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n",
              "the boundary of the mesh is not convex at node 2 at (0.4, 0.4)"},
             {"v 0 0 0\nv 1 0 0\nv 1 1 0\nv .9 .2 0\nf 1 2 3\nf 1 3 4\n",
              "triangles 0 and 1 have opposite orientations; all must be anticlockwise, or all clockwise"},
             {"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nv 3 0 0\nv 2 1 0\nf 1 2 3\nf 4 5 6\n",
              "the mesh must be connected, but it has 2 parts"},
             {"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n",
              "the mesh is a closed surface without a boundary"},
             {"v 0 0 0\nv 3 0 0\nv 0 3 0\nv 1 .5 0\nv 1.5 .5 0\nv 1 1 0\n"
              "f 1 2 5\nf 1 5 4\nf 2 3 6\nf 2 6 5\nf 3 1 4\nf 3 4 6\n",
              "the mesh must have one boundary, but it has 2, as there are holes"},
             {"v 0 0 0\nv 1 0 .1\nv 1 1 0\nf 1 2 3\n",
              "the mesh must lie in a plane z = const, but its z is between 0 and 0.1"},
             {flat_square + "v .5 -1 0\nf 1 2 3\nf 2 1 5\nf 1 2 4\n",
              "its surface is not a manifold: edge 1-2 has three faces"},
             {"v 0 0 0\nv 1 0 0\nv 2 0 0\nv 1 1 0\nf 1 2 3\nf 1 3 4\n",
              "triangle 0 is degenerate, its nodes lie on one line"},
             {"", "it is empty"}})
        EXPECT_EQ(source_refusal(obj), sentence);
    EXPECT_NE(message_of<InputError>([&] {
                  gaspard::Run run(catalogue, on((folder / "no.obj").string()));
              }).find("No such file"),
              std::string::npos);
    std::ofstream(folder / "large.obj").close();
    std::filesystem::resize_file(folder / "large.obj", std::uintmax_t{300} << 20);
    EXPECT_NE(message_of<InputError>([&] {
                  gaspard::Run run(catalogue, on((folder / "large.obj").string()));
              }).find("it is larger than 64 MiB"),
              std::string::npos);
}

TEST_F(TransportSource, ScenariosNameTheFileRelativeToTheirs) {
    const std::string file = written("m.obj", flat_square + "f 1 2 3\nf 1 3 4\n");
    const std::string one = "domain.refinements=1";
    EXPECT_NE(message_of<InputError>([&] {
                  gaspard::Run run(catalogue, on(file));
              }).find("are on its boundary; set domain.refinements = 1"),
              std::string::npos);
    Scenario scenario = with_relative_paths(on(file, {one}), folder.path());
    EXPECT_EQ(scenario.domain.values.text("file"), "m.obj");
    std::ofstream(folder / "mine.toml") << to_toml(scenario);
    const Scenario again = load_scenario(*catalogue, folder / "mine.toml");
    EXPECT_EQ(gaspard::Run(catalogue, again).discretisation().mesh()->cell_count(), 8U);
    const Scenario packed = with_packed_data(on(file, {one}));
    EXPECT_FALSE(has_data_files(packed));
    EXPECT_EQ(gaspard::Run(catalogue, packed).discretisation().mesh()->cell_count(), 8U);
}

TEST_F(TransportSource, AFileThatHasChangedIsReadAgain) {
    const std::string file = written("m.obj", flat_square + "f 1 2 3\nf 1 3 4\n");
    const Scenario scenario = on(file, {"domain.refinements=2"});
    gaspard::Run run(catalogue, scenario);
    run.solve();
    written("m.obj", "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n");
    EXPECT_EQ(run.change(run.scenario()), "");
    EXPECT_EQ(run.discretisation().mesh()->nodes[1], (Vec3{1, 0, 0})) << "not asked to";
    EXPECT_EQ(run.change(run.scenario(), {}, {}, Diagnostics::full, true), "");
    EXPECT_EQ(run.discretisation().mesh()->nodes[1], (Vec3{2, 0, 0}));
    run.solve();
    EXPECT_EQ(run.status(), RunStatus::converged);
    written("m.obj", "");
    EXPECT_THROW(run.change(run.scenario(), {}, {}, Diagnostics::full, true), InputError);
    EXPECT_EQ(run.discretisation().mesh()->nodes[1], (Vec3{2, 0, 0})) << "the run keeps its mesh";
}

TEST_F(TransportSource, SourceDensitiesLieOnTheMesh) {
    const std::string file =
        written("m.obj", "v 100 0 0\nv 104 0 0\nv 104 4 0\nv 100 4 0\nf 1 2 3\nf 1 3 4\n");
    const Scenario scenario = on(file, {"monitor.source.type=ring"});
    EXPECT_NEAR(scenario.source.values.real("center_x"), 102, 1e-9);
    EXPECT_NEAR(scenario.source.values.real("center_y"), 2, 1e-9);
}

} // namespace
} // namespace gaspard

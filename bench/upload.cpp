// Cost of showing a new snapshot on the window's thread: preparing it (values, range, histogram) and
// uploading the arrays to OpenGL. Drawing, which is the work of the graphics card, is not included.
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"
#include "gui/gl/offscreen.hpp"
#include "gui/render/mesh_renderer.hpp"

#include <array>
#include <benchmark/benchmark.h>

namespace {

using namespace gaspard;

/// Two iterates of a ring run, shown alternately.
struct Scene {
    explicit Scene(std::int64_t cells) {
        const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
        Scenario scenario = find_scenario(*catalogue, "plane-ring");
        scenario.domain.values.set("cells", cells);
        Run run(catalogue, scenario);
        view = scenario.view;
        for (auto& snapshot : snapshots) {
            for (int i = 0; i < 5; ++i) run.step();
            snapshot = run.snapshot();
        }
    }
    std::array<std::shared_ptr<const Snapshot>, 2> snapshots;
    Values view;
};

void count(benchmark::State& state, double bytes_per_node) {
    const auto side = static_cast<double>(state.range(0));
    const double iterations = static_cast<double>(state.iterations());
    state.counters["bytes"] = benchmark::Counter(bytes_per_node * (side + 1) * (side + 1) * iterations,
                                                 benchmark::Counter::kIsRate);
    state.counters["cell"] = benchmark::Counter(side * side * iterations,
                                                benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void picture(benchmark::State& state) {
    const Scene scene(state.range(0));
    SceneBuilder maker;
    maker.make(*scene.snapshots[0], scene.view); // creates triangles and edges once
    std::size_t turn = 0;
    for (auto _ : state) benchmark::DoNotOptimize(maker.make(*scene.snapshots[turn ^= 1], scene.view));
    // x, y, z and the values are read and copied, and read again for box, range and histogram.
    count(state, 3 * 4 * 8);
}

void upload(benchmark::State& state) {
    const auto context = make_offscreen_context();
    Gl gl = context->gl();
    gl.DrawArrays = [](GLenum, GLint, GLsizei) {};
    gl.DrawElements = [](GLenum, GLsizei, GLenum, const void*) {};
    gl.DrawElementsBaseVertex = [](GLenum, GLsizei, GLenum, const void*, GLint) {};
    const RenderTarget target(gl, 64, 64);
    target.bind();
    const Scene scene(state.range(0));
    SceneBuilder maker;
    const std::array<MeshScene, 2> pictures = {maker.make(*scene.snapshots[0], scene.view),
                                               maker.make(*scene.snapshots[1], scene.view)};
    MeshRenderer renderer(gl);
    const auto show = [&](const MeshScene& one) {
        renderer.draw(one, home(one.box, {64, 64}), {0, 0, 64, 64}, 64, dark_theme(), 1);
    };
    show(pictures[0]); // uploads cells, edges and xi once
    std::size_t turn = 0;
    const std::size_t before = renderer.uploaded_bytes();
    for (auto _ : state) {
        show(pictures[turn ^= 1]);
        gl.Finish();
    }
    const auto nodes = static_cast<double>(scene.snapshots[0]->x.size());
    const double sent = static_cast<double>(renderer.uploaded_bytes() - before) / nodes /
                        static_cast<double>(state.iterations());
    if (sent < 16) return state.SkipWithError("nothing was sent");
    // Four doubles are read and four floats written, which the driver reads and writes again.
    count(state, 4 * 8 + 3 * sent);
}

void sizes(benchmark::internal::Benchmark* one) {
    one->ArgName("n")->Unit(benchmark::kMicrosecond);
    for (const int n : {60, 120, 240, 480}) one->Arg(n);
}
BENCHMARK(picture)->Apply(sizes);
BENCHMARK(upload)->Apply(sizes);

} // namespace

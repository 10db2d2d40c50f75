// Draws the pictures that the tests compare with. Run by hand when a picture is meant to look different, and
// look at what it wrote: make_goldens [FOLDER], by default tests/goldens.
#include "scenes.hpp"

#include <filesystem>
#include <iostream>

int main(int argc, char** argv) {
    const std::filesystem::path folder = argc > 1 ? argv[1] : GASPARD_SOURCE_DIR "/tests/goldens";
    for (const auto& scene : gaspard::scenes()) {
        const auto file = folder / (scene.name + ".png");
        gaspard::write_png(file, scene.draw(gaspard::OffscreenBackend::any));
        std::cout << file.string() << "\n";
    }
    return 0;
}

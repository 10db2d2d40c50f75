// Animated PNG (a PNG with the chunks acTL, fcTL and fdAT), which browsers, viewers and slides play.
#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>
#include <vector>

namespace gaspard {

/// Joins PNG files of one size, as write_png() makes them: `rate` of them per second (at most 1000), for
/// ever; the last one stays for `hold` seconds more (below 60). Throws MachineError if a frame cannot be read
/// or is of another kind than the first, or the file cannot be written; Interrupted.
void write_apng(const std::filesystem::path& file, const std::vector<std::filesystem::path>& frames,
                double rate, double hold = 0, const std::stop_token& stop = {});

} // namespace gaspard

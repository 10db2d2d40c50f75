#include "core/io/apng.hpp"

#include "core/base/check.hpp"
#include "core/base/error.hpp"
#include "core/base/read_file.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/png_chunks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ostream>
#include <string>

namespace gaspard {

namespace {

struct Frame {
    std::string header;            ///< the content of IHDR
    std::vector<std::string> data; ///< of each IDAT
};

Frame read_frame(const std::filesystem::path& file) {
    Frame frame;
    for (PngChunk& chunk : png_chunks(read_file(file), file)) {
        if (chunk.type == "IHDR") frame.header = std::move(chunk.content);
        if (chunk.type == "IDAT") frame.data.push_back(std::move(chunk.content));
    }
    return frame;
}

/// The frame as large as the image, shown for a time in units of a second's part.
std::string frame_control(std::uint32_t number, const std::string& header, double seconds, long parts) {
    std::string content;
    append_big_endian(content, number);
    content += header.substr(0, 8); // width and height
    append_big_endian(content, 0);  // at the upper left corner
    append_big_endian(content, 0);
    for (const long part :
         {std::clamp(std::lround(seconds * static_cast<double>(parts)), 1L, 65535L), parts}) {
        content += static_cast<char>((part >> 8) & 0xFF);
        content += static_cast<char>(part & 0xFF);
    }
    content += std::string(2, '\0'); // stays until the next one, which replaces it
    return png_chunk("fcTL", content);
}

} // namespace

void write_apng(const std::filesystem::path& file, const std::vector<std::filesystem::path>& frames,
                double rate, double hold, const std::stop_token& stop) {
    GASPARD_CHECK(!frames.empty() && rate > 0 && hold >= 0);
    write_atomically(file, [&](std::ostream& stream) {
        // Such that a frame lasts exactly as long as it should, for three digits of the rate.
        const double per_frame = rate > 320 ? 10 : rate > 32 ? 100 : 1000;
        const long parts = std::lround(per_frame * rate);
        std::uint32_t number = 0; // of the chunks fcTL and fdAT together
        std::string header;
        for (std::size_t i = 0; i < frames.size(); ++i) {
            if (stop.stop_requested()) throw Interrupted();
            const Frame frame = read_frame(frames[i]);
            if (i == 0) {
                header = frame.header;
                std::string control;
                append_big_endian(control, static_cast<std::uint32_t>(frames.size()));
                append_big_endian(control, 0); // for ever
                stream << png_signature << png_chunk("IHDR", header) << png_chunk("acTL", control);
            }
            if (frame.header != header)
                throw MachineError("cannot join " + frames[i].string() + " and " + frames.front().string() +
                                   ": they have different sizes");
            const double shown = 1 / rate + (i + 1 == frames.size() ? hold : 0);
            stream << frame_control(number++, header, shown, parts);
            for (const std::string& data : frame.data) {
                if (i == 0) {
                    stream << png_chunk("IDAT", data);
                    continue;
                }
                std::string content;
                append_big_endian(content, number++);
                stream << png_chunk("fdAT", content + data);
            }
        }
        stream << png_chunk("IEND", "");
    });
}

} // namespace gaspard

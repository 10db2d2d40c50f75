// Videos and animated GIFs of PNG files, made by the program ffmpeg where it is installed.
#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <string_view>

namespace gaspard {

enum class VideoKind { mp4, webm, gif };

/// Throws InputError, which says how to get it, if there is no ffmpeg in PATH.
void check_ffmpeg(std::string_view format);

/// Of folder/00000.png, 00001.png, ...: `count` frames, `rate` per second; the last one stays for `hold`
/// seconds more. MP4 and WebM have even sizes: of odd ones the last row or column is cut off. Throws
/// MachineError with the last line of what ffmpeg says; Interrupted.
void write_video(const std::filesystem::path& file, VideoKind kind, const std::filesystem::path& folder,
                 int count, double rate, double hold, const std::stop_token& stop = {});

} // namespace gaspard

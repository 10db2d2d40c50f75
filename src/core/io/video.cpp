#include "core/io/video.hpp"

#include "core/base/error.hpp"
#include "core/base/parameter.hpp"
#include "core/base/read_file.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <vector>

namespace gaspard {

namespace fs = std::filesystem;

namespace {

fs::path find_ffmpeg() {
    const char* path = std::getenv("PATH");
    std::string_view rest = path ? path : "";
    while (!rest.empty()) {
        const auto end = std::min(rest.find(':'), rest.size());
        const fs::path program = fs::path(rest.substr(0, end)) / "ffmpeg";
        if (access(program.c_str(), X_OK) == 0) return program;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return {};
}

/// Removes a file at the end, if it is still there.
struct Removal {
    fs::path file;
    ~Removal() {
        std::error_code ignored;
        fs::remove(file, ignored);
    }
};

std::vector<std::string> codec(VideoKind kind) {
    switch (kind) {
    case VideoKind::mp4:
        return {"-c:v",     "libx264", "-preset",   "slow",       "-crf", "18",
                "-pix_fmt", "yuv420p", "-movflags", "+faststart", "-f",   "mp4"};
    case VideoKind::webm:
        return {"-c:v",    "libvpx-vp9", "-b:v",     "0",       "-crf", "24",
                "-row-mt", "1",          "-pix_fmt", "yuv420p", "-f",   "webm"};
    case VideoKind::gif:
        return {"-loop", "0", "-f", "gif"};
    }
    return {};
}

std::string filter(VideoKind kind, double hold) {
    const std::string stay =
        hold > 0 ? "tpad=stop_mode=clone:stop_duration=" + format_number(hold) + "," : std::string();
    if (kind == VideoKind::gif) // colours of this film
        return stay + "split[a][b];[a]palettegen=stats_mode=full[p];[b][p]paletteuse=dither=none";
    return stay + "crop=trunc(iw/2)*2:trunc(ih/2)*2:0:0";
}

/// As ffmpeg wants it: a percent sign is doubled, and a colon is no protocol.
std::string pattern_of(const fs::path& folder) {
    std::string text = "file:";
    for (const char letter : folder.string()) text += letter == '%' ? "%%" : std::string(1, letter);
    return text + "/%05d.png";
}

std::string last_line(const fs::path& log) {
    std::string text = read_file(log);
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text.substr(text.rfind('\n') + 1);
}

/// Runs a command to its end; its exit code. Killed when asked to stop.
int run_command(std::vector<std::string> words, const fs::path& log, const std::stop_token& stop) {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                     0600);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    pid_t child = 0;
    const int failed =
        posix_spawn(&child, words.front().c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failed != 0)
        throw MachineError("cannot start " + words.front() + ": " + std::generic_category().message(failed));
    int status = 0;
    while (waitpid(child, &status, WNOHANG) == 0) {
        if (stop.stop_requested()) {
            kill(child, SIGKILL);
            waitpid(child, &status, 0);
            throw Interrupted();
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

} // namespace

void check_ffmpeg(std::string_view format) {
    if (find_ffmpeg().empty())
        throw InputError("the format " + std::string(format) +
                         " needs the program ffmpeg, which is not installed (Debian: apt install ffmpeg); "
                         "apng needs no other program");
}

void write_video(const fs::path& file, VideoKind kind, const fs::path& folder, int count, double rate,
                 double hold, const std::stop_token& stop) {
    fs::path unfinished = file, log = file;
    unfinished += ".part";
    log += ".log";
    const Removal first{unfinished}, second{log};
    std::vector<std::string> words{find_ffmpeg().string(),
                                   "-nostdin",
                                   "-loglevel",
                                   "error",
                                   "-y",
                                   "-framerate",
                                   format_number(rate),
                                   "-i",
                                   pattern_of(folder),
                                   "-frames:v",
                                   std::to_string(count + static_cast<int>(hold * rate)),
                                   "-vf",
                                   filter(kind, hold)};
    for (std::string& word : codec(kind)) words.push_back(std::move(word));
    words.push_back("file:" + unfinished.string());
    if (words.front().empty()) check_ffmpeg(file.extension().string());
    if (run_command(words, log, stop) != 0)
        throw MachineError("ffmpeg cannot write " + file.string() + ": " + last_line(log));
    std::error_code error;
    fs::rename(unfinished, file, error);
    if (error) throw MachineError("cannot write " + file.string() + ": " + error.message());
}

} // namespace gaspard

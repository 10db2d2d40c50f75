// Programs run for a test: a screen of its own in memory (Xvfb), the program under test, and xdotool, which
// moves mouse and keys on that screen. Each process ends with its owner.
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace gaspard {

class ChildProcess {
  public:
    struct Setup {
        std::vector<std::string> command;
        std::map<std::string, std::string> environment{}; ///< set beyond ours; an empty value removes one
        std::filesystem::path folder = ".";
        std::filesystem::path output{}; ///< where standard output and error go; empty: to ours
        int inherited = -1;             ///< a file descriptor that the child keeps
    };
    explicit ChildProcess(const Setup& setup);
    ~ChildProcess(); ///< kills it if it still runs
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// The exit code (128 + signal for a killed one), or nothing if it still runs after so long.
    std::optional<int> wait(std::chrono::milliseconds patience);
    bool running() { return !wait(std::chrono::milliseconds(0)).has_value(); }
    void send(int signal);
    double cpu_seconds() const; ///< used by all its threads

  private:
    pid_t pid_ = -1;
    std::optional<int> exit_code_;
};

/// An X server of its own, on a number that is free.
class VirtualDisplay {
  public:
    VirtualDisplay(int width, int height);
    const std::string& name() const { return name_; } ///< ":1"
    /// Runs xdotool and returns what it prints, without the last line end; empty where it fails.
    std::string xdotool(const std::vector<std::string>& arguments) const;
    /// Tells programs that start from now on how dense the screen is; 96 is usual. False where that failed.
    bool set_density(int dots_per_inch) const;

  private:
    std::string name_;
    std::optional<ChildProcess> server_;
};

} // namespace gaspard

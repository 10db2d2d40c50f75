#include "gui/virtual_display.hpp"

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <poll.h>
#include <sstream>
#include <stdexcept>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace gaspard {

namespace {

[[noreturn]] void become(const ChildProcess::Setup& setup) {
    for (const auto& [name, value] : setup.environment)
        if (value.empty())
            unsetenv(name.c_str());
        else
            setenv(name.c_str(), value.c_str(), 1);
    std::error_code error;
    std::filesystem::current_path(setup.folder, error);
    if (error) _exit(127);
    if (!setup.output.empty()) {
        FILE* out = std::freopen(setup.output.c_str(), "w", stdout);
        if (!out || dup2(fileno(out), STDERR_FILENO) < 0) _exit(127);
    }
    for (int descriptor = 3; descriptor < 64; ++descriptor)
        if (descriptor != setup.inherited) close(descriptor);
    std::vector<char*> arguments;
    for (const auto& word : setup.command)
        arguments.push_back(const_cast<char*>(word.c_str())); // as execvp wants
    arguments.push_back(nullptr);
    execvp(arguments.front(), arguments.data());
    _exit(127);
}

} // namespace

ChildProcess::ChildProcess(const Setup& setup) : pid_(fork()) {
    if (pid_ < 0) throw std::runtime_error("a process could not be started");
    if (pid_ == 0) become(setup);
}

ChildProcess::~ChildProcess() {
    if (running()) kill(pid_, SIGTERM);
    if (!wait(std::chrono::seconds(5))) {
        kill(pid_, SIGKILL);
        wait(std::chrono::seconds(5));
    }
}

std::optional<int> ChildProcess::wait(std::chrono::milliseconds patience) {
    const auto end = std::chrono::steady_clock::now() + patience;
    while (!exit_code_) {
        int status = 0;
        if (waitpid(pid_, &status, WNOHANG) == pid_)
            exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        else if (std::chrono::steady_clock::now() >= end)
            return std::nullopt;
        else
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return exit_code_;
}

void ChildProcess::send(int signal) {
    if (running()) kill(pid_, signal);
}

double ChildProcess::cpu_seconds() const {
    std::ifstream file("/proc/" + std::to_string(pid_) + "/stat");
    std::string text((std::istreambuf_iterator<char>(file)), {});
    if (text.rfind(')') == std::string::npos) throw std::runtime_error("the process has gone");
    std::istringstream fields(text.substr(text.rfind(')') + 2)); // the name before may hold spaces
    std::string skipped;
    for (int i = 0; i < 11; ++i) fields >> skipped;
    double user = 0, system = 0;
    fields >> user >> system;
    return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

VirtualDisplay::VirtualDisplay(int width, int height) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe");
    ChildProcess::Setup setup;
    setup.command = {"Xvfb",      "-displayfd", std::to_string(ends[1]),
                     "-screen",   "0",          std::to_string(width) + "x" + std::to_string(height) + "x24",
                     "-nolisten", "tcp",        "-noreset"};
    setup.output = "/dev/null";
    setup.inherited = ends[1];
    server_.emplace(setup);
    close(ends[1]);
    std::string number;
    pollfd ready{ends[0], POLLIN, 0};
    char letter = 0;
    while (poll(&ready, 1, 20000) == 1 && read(ends[0], &letter, 1) == 1 && letter != '\n') number += letter;
    close(ends[0]);
    if (number.empty()) throw std::runtime_error("Xvfb did not start");
    name_ = ":" + number;
}

std::string VirtualDisplay::xdotool(const std::vector<std::string>& arguments) const {
    const auto file =
        std::filesystem::temp_directory_path() / ("gaspard-xdotool-" + std::to_string(getpid()));
    ChildProcess::Setup setup;
    setup.command = {"xdotool"};
    setup.command.insert(setup.command.end(), arguments.begin(), arguments.end());
    setup.environment = {{"DISPLAY", name_}};
    setup.output = file;
    ChildProcess process(setup);
    const bool done = process.wait(std::chrono::seconds(20)) == 0;
    std::ifstream stream(file);
    std::string text((std::istreambuf_iterator<char>(stream)), {});
    std::filesystem::remove(file);
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return done ? text : std::string();
}

bool VirtualDisplay::set_density(int dots_per_inch) const {
    ChildProcess::Setup setup;
    setup.command = {"xprop",
                     "-root",
                     "-f",
                     "RESOURCE_MANAGER",
                     "8s",
                     "-set",
                     "RESOURCE_MANAGER",
                     "Xft.dpi:\t" + std::to_string(dots_per_inch) + "\n"};
    setup.environment = {{"DISPLAY", name_}};
    setup.output = "/dev/null";
    return ChildProcess(setup).wait(std::chrono::seconds(20)) == 0;
}

} // namespace gaspard

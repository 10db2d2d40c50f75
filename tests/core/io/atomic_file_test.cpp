#include "core/base/error.hpp"
#include "core/base/read_file.hpp"
#include "core/io/atomic_file.hpp"
#include "support/comma_locale.hpp"
#include "support/messages.hpp"
#include "support/temporary_folder.hpp"

#include <atomic>
#include <csignal>
#include <fstream>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>

namespace gaspard {
namespace {

namespace fs = std::filesystem;
using testing::ExitedWithCode;
using Names = std::vector<std::string>;

void put(const fs::path& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(AtomicFile, WritesTheBytesAndReplacesAnOlderFile) {
    const TemporaryFolder folder;
    const std::string bytes("a\0b\r\nc", 6);
    write_atomically(folder / "f", bytes);
    EXPECT_EQ(read_file(folder / "f"), bytes);
    write_atomically(folder / "f", [](std::ostream& out) { out << "new\n"; });
    EXPECT_EQ(read_file(folder / "f"), "new\n");
    EXPECT_EQ(folder.content(), Names{"f"});
}

TEST(AtomicFile, HasDefaultPermissions) {
    const TemporaryFolder folder;
    put(folder / "plain", "");
    write_atomically(folder / "ours", "");
    EXPECT_EQ(fs::status(folder / "ours").permissions(), fs::status(folder / "plain").permissions());
}

TEST(AtomicFile, WritesRelativeNamesIntoTheCurrentFolder) {
    const TemporaryFolder folder;
    const fs::path before = fs::current_path();
    fs::current_path(folder.path());
    write_atomically("f", "here");
    fs::current_path(before);
    EXPECT_EQ(read_file(folder / "f"), "here");
}

TEST(AtomicFile, StreamIsInTheCLocale) {
    const TemporaryFolder folder;
    const CommaLocale comma;
    std::ostringstream proof;
    proof << 1234.5;
    ASSERT_EQ(proof.str(), "1.234,5");
    write_atomically(folder / "f", [](std::ostream& out) { out << 1234.5 << ' ' << 1234567; });
    EXPECT_EQ(read_file(folder / "f"), "1234.5 1234567");
}

TEST(AtomicFile, KeepsTheOldFileIfTheWriterThrows) {
    const TemporaryFolder folder;
    put(folder / "f", "old");
    const auto write = [](std::ostream& out) {
        out << "half";
        throw std::runtime_error("midway");
    };
    EXPECT_EQ(message_of<std::runtime_error>([&] { write_atomically(folder / "f", write); }), "midway");
    EXPECT_EQ(read_file(folder / "f"), "old");
    EXPECT_EQ(folder.content(), Names{"f"});
}

TEST(AtomicFile, ReportsAMissingFolder) {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "gone" / "f";
    const std::string message = message_of<MachineError>([&] { write_atomically(file, "x"); });
    EXPECT_EQ(message, "cannot write " + file.string() + ": No such file or directory");
}

TEST(AtomicFile, ReportsAFolderOfTheSameNameAndCleansUp) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "f");
    const std::string message = message_of<MachineError>([&] { write_atomically(folder / "f", "x"); });
    EXPECT_EQ(message, "cannot write " + (folder / "f").string() + ": Is a directory");
    EXPECT_EQ(folder.content(), Names{"f"});
}

/// In a child process: writes 5000 bytes under a file size limit of 1000, reports the error, exits with 0.
[[noreturn]] void write_beyond_the_limit(const fs::path& file) {
    std::signal(SIGXFSZ, SIG_IGN); // as in run_command_line
    const rlimit limit{1000, 1000};
    setrlimit(RLIMIT_FSIZE, &limit);
    try {
        write_atomically(file, std::string(5000, 'x'));
    } catch (const MachineError& error) {
        std::fputs(error.what(), stderr);
        std::_Exit(0);
    }
    std::_Exit(1);
}

TEST(AtomicFileDeathTest, KeepsTheOldFileOnAFullDisk) {
    const TemporaryFolder folder;
    put(folder / "f", "old");
    EXPECT_EXIT(write_beyond_the_limit(folder / "f"), ExitedWithCode(0), "cannot write .*/f: File too large");
    EXPECT_EQ(read_file(folder / "f"), "old");
    EXPECT_EQ(folder.content(), Names{"f"});
}

TEST(AtomicFile, DoesNotTouchOtherTemporaryFiles) {
    const TemporaryFolder folder;
    const std::string taken = ".gaspard-" + std::to_string(getpid()) + "-0.tmp";
    put(folder / taken, "of a writer at work");
    write_atomically(folder / "f", "x");
    EXPECT_EQ(read_file(folder / taken), "of a writer at work");
    EXPECT_EQ(folder.content(), (Names{taken, "f"}));
}

TEST(AtomicFile, WhatKilledProgramsHaveLeftIsRemovedAlone) {
    const TemporaryFolder folder;
    const std::string working = ".gaspard-" + std::to_string(getpid()) + "-0.tmp";
    for (const std::string& name : {std::string(".gaspard-999999999-0.tmp"), working, std::string("f.tmp")})
        put(folder / name, "x");
    remove_unfinished(folder.path());
    EXPECT_EQ(folder.content(), (Names{working, "f.tmp"}));
    remove_unfinished(folder / "not there");
}

TEST(AtomicFile, WritersOfTheSameFileDoNotMix) {
    const TemporaryFolder folder;
    write_atomically(folder / "f", std::string(100000, 'a'));
    std::atomic<bool> mixed = false;
    {
        std::vector<std::jthread> threads;
        for (const char letter : {'a', 'b', 'c'})
            threads.emplace_back([&, letter] {
                for (int i = 0; i < 20; ++i) {
                    write_atomically(folder / "f", std::string(100000, letter));
                    const std::string now = read_file(folder / "f");
                    if (now != std::string(100000, now.at(0))) mixed = true;
                }
            });
    }
    EXPECT_FALSE(mixed);
    EXPECT_EQ(folder.content(), Names{"f"});
}

TEST(CheckWritable, MakesTheFoldersAndLeavesThemEmpty) {
    const TemporaryFolder folder;
    check_writable(folder.path() / "a" / "b");
    EXPECT_TRUE(fs::is_directory(folder.path() / "a" / "b"));
    EXPECT_TRUE(fs::is_empty(folder.path() / "a" / "b"));
    check_writable(folder.path() / "a" / "b");      // exists now
    check_writable(folder.path() / "a" / "c" / ""); // with a trailing slash
    EXPECT_TRUE(fs::is_empty(folder.path() / "a" / "c"));
}

TEST(CheckWritable, ReportsAFileOfTheSameName) {
    const TemporaryFolder folder;
    put(folder / "f", "mine");
    for (const fs::path& wanted : {folder / "f", folder.path() / "f" / "g"})
        EXPECT_EQ(message_of<InputError>([&] { check_writable(wanted); }),
                  "cannot write to the folder " + wanted.string() + ": Not a directory");
    EXPECT_EQ(read_file(folder / "f"), "mine");
}

TEST(CheckWritable, ReportsMissingPermissions) {
    const std::string inside = message_of<InputError>([] { check_writable("/proc"); });
    EXPECT_TRUE(contains(inside, "cannot write to the folder /proc: ")) << inside;
    const std::string below = message_of<InputError>([] { check_writable("/proc/gaspard/out"); });
    EXPECT_TRUE(contains(below, "cannot write to the folder /proc/gaspard/out: ")) << below;
    EXPECT_THROW(check_writable(""), InputError);
}

TEST(CheckWritable, RemovesCreatedFoldersOnFailure) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "there");
    const fs::path wanted = folder.path() / "there" / "new" / std::string(300, 'n');
    const std::string message = message_of<InputError>([&] { check_writable(wanted); });
    EXPECT_TRUE(contains(message, "File name too long")) << message;
    EXPECT_TRUE(fs::is_empty(folder / "there"));
}

} // namespace
} // namespace gaspard

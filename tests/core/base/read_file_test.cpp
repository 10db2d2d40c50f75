#include "core/base/error.hpp"
#include "core/base/read_file.hpp"
#include "support/messages.hpp"
#include "support/temporary_folder.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <thread>

namespace gaspard {
namespace {

TEST(ReadFile, ReadsAllBytesUpToALimit) {
    const TemporaryFolder folder;
    const std::string bytes(100000, 'x');
    std::ofstream(folder / "file") << bytes;
    std::ofstream(folder / "empty") << "";
    EXPECT_EQ(read_file(folder / "file"), bytes);
    EXPECT_EQ(read_file(folder / "file", 100000), bytes);
    EXPECT_EQ(read_file(folder / "empty"), "");
    EXPECT_EQ(message_of<InputError>([&] { read_file(folder / "file", 99999); }),
              "cannot read " + (folder / "file").string() + ": it is larger than 97 KiB");
    EXPECT_NE(message_of<InputError>([&] { read_file(folder.path()); }).find("Is a directory"),
              std::string::npos);
    EXPECT_NE(message_of<InputError>([&] { read_file(folder / "none"); }).find("No such file"),
              std::string::npos);
}

TEST(ReadFile, ReadsAPipeThatIsOpenedForWritingLater) {
    const TemporaryFolder folder;
    const std::string pipe = (folder / "pipe").string(), bytes(300000, 'x');
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const std::jthread writer([&] { std::ofstream(pipe) << bytes; }); // opens once there is a reader
    EXPECT_EQ(read_file(pipe), bytes);
}

TEST(ReadFile, AnInterruptEndsWaitingForAPipe) {
    const TemporaryFolder folder;
    const std::string pipe = (folder / "pipe").string();
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(read_file(pipe, largest_file, stop.get_token()), Interrupted) << "nothing writes to it";
    std::stop_source later;
    std::jthread writer([&] { // holds the pipe open until the reader was told to stop, and writes nothing
        const std::ofstream open(pipe);
        later.request_stop();
        while (std::filesystem::exists(pipe)) std::this_thread::yield();
    });
    EXPECT_THROW(read_file(pipe, largest_file, later.get_token()), Interrupted);
    std::filesystem::remove(pipe);
}

} // namespace
} // namespace gaspard

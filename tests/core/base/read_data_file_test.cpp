#include "core/base/error.hpp"
#include "core/base/read_data_file.hpp"
#include "core/base/user_path.hpp"
#include "support/temporary_folder.hpp"

#include <fstream>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

TEST(DataFile, IsAPathOrAUri) {
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "numbers.csv") << "1,2\n";
    EXPECT_EQ(read_data_file("numbers.csv", folder.path()), "1,2\n");
    EXPECT_EQ(read_data_file("data:text/csv;base64,MSwyCg==", folder.path()), "1,2\n");
    EXPECT_EQ(read_data_file(" DATA:;Base64,\n MSwy\n Cg== \n"), "1,2\n");
    EXPECT_EQ(read_data_file("data:,1%2c2%0A"), "1,2\n");
    EXPECT_EQ(read_data_file("data:text/csv;charset=utf-8,1,2"), "1,2");
    EXPECT_EQ(read_data_file("data:;base64,AP8A"), std::string("\0\xff\0", 3));
    EXPECT_EQ(data_file_name("numbers.csv", "here"), "here/numbers.csv");
    EXPECT_EQ(data_file_name("data:;base64,AP8A", "here"), "the packed data");
}

TEST(DataFile, AUriIsNotAPath) {
    EXPECT_TRUE(is_path("data/field.nc"));
    EXPECT_FALSE(is_path("data:;base64,AP8A"));
    EXPECT_FALSE(is_path("\n data:;base64,AP8A"));
    EXPECT_FALSE(is_data_uri(""));
    EXPECT_FALSE(is_data_uri("dat"));
}

std::string error_of(const std::string& text, std::uintmax_t limit = largest_file) {
    try {
        read_data_file(text, {}, limit);
    } catch (const InputError& error) {
        return error.what();
    }
    return "none";
}

TEST(DataFile, WrongUrisAreOneSentence) {
    EXPECT_EQ(error_of("data:text/csv"), "the data: URI has no comma; it must be data:<type>;base64,<data>");
    EXPECT_EQ(error_of("data:;base64,MSwyC"), "the data: URI is not valid base64");
    EXPECT_EQ(error_of("data:;base64,M$wyCg=="), "the data: URI is not valid base64");
    EXPECT_EQ(error_of("data:,1%2"), "the data: URI has a '%' without two hexadecimal digits after it");
    EXPECT_EQ(error_of("data:;base64," + std::string(8192, 'A'), 4096), "the data: URI has more than 4 KiB");
    EXPECT_EQ(error_of("no-such-file.nc"), "cannot read no-such-file.nc: No such file or directory");
}

} // namespace
} // namespace gaspard

#include "core/base/data_uri.hpp"
#include "core/base/read_data_file.hpp"

#include <gtest/gtest.h>
#include <string>

namespace gaspard {
namespace {

TEST(DataUri, IsBase64AsInTheStandard) { // RFC 4648, section 10
    EXPECT_EQ(data_uri("", "text/csv"), "data:text/csv;base64,");
    EXPECT_EQ(data_uri("f", "text/csv"), "data:text/csv;base64,Zg==");
    EXPECT_EQ(data_uri("fo", "text/csv"), "data:text/csv;base64,Zm8=");
    EXPECT_EQ(data_uri("foo", "text/csv"), "data:text/csv;base64,Zm9v");
    EXPECT_EQ(data_uri("foobar", "text/csv"), "data:text/csv;base64,Zm9vYmFy");
}

TEST(DataUri, IsReadBackByteByByte) {
    std::string bytes;
    for (int i = 0; i < 1000; ++i) {
        bytes += static_cast<char>((i * 37) % 256);
        ASSERT_EQ(read_data_file(data_uri(bytes, "application/octet-stream")), bytes) << i;
    }
}

TEST(DataUri, KnowsTheTypesOfDataFiles) {
    EXPECT_EQ(media_type_of("a.PNG"), "image/png");
    EXPECT_EQ(media_type_of("a.b.jpeg"), "image/jpeg");
    EXPECT_EQ(media_type_of("a"), "application/octet-stream");
}

} // namespace
} // namespace gaspard

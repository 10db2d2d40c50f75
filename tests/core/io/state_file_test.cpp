#include "core/base/error.hpp"
#include "core/base/read_file.hpp"
#include "core/io/state_file.hpp"
#include "support/messages.hpp"
#include "support/temporary_folder.hpp"

#include <cmath>
#include <fstream>
#include <limits>

namespace gaspard {
namespace {

State sample() {
    return {"plane periodic Q2 n=3",
            {{"phi", {0.1, -0.0, 5e-324, 1.7976931348623157e308}}, {"empty", {}}, {"sigma", {1, 2, 3}}}};
}

void put(const std::filesystem::path& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
}

std::string little_endian(std::uint64_t value, int size) {
    std::string bytes;
    for (int i = 0; i < size; ++i) bytes += static_cast<char>(value >> 8 * i);
    return bytes;
}

std::string with_checksum(const std::string& body) {
    std::uint64_t hash = 14695981039346656037u;
    for (const unsigned char byte : body) {
        hash ^= byte;
        hash *= 1099511628211u;
    }
    return body + little_endian(hash, 8);
}

std::string refusal(const std::filesystem::path& file) {
    return message_of<InputError>([&] { read_state(file); });
}

TEST(StateFile, ReadsBackToTheSameBits) {
    const TemporaryFolder folder;
    for (const State& state : {sample(), State{"", {}}}) {
        write_state(folder / "state.bin", state);
        const State back = read_state(folder / "state.bin");
        EXPECT_EQ(back, state);
        for (std::size_t a = 0; a < state.arrays.size(); ++a)
            for (std::size_t i = 0; i < state.arrays[a].values.size(); ++i)
                EXPECT_EQ(std::signbit(back.arrays[a].values[i]), std::signbit(state.arrays[a].values[i]));
    }
}

TEST(StateFile, HasTheDocumentedLayout) {
    const TemporaryFolder folder;
    write_state(folder / "state.bin", State{"L=1", {{"ab", {1.0, -2.0}}}});
    const std::string body = std::string("GASPARD STATE\n\0\0", 16) + little_endian(1, 4) +
                             little_endian(1, 4) + little_endian(3, 4) + "L=1" + little_endian(2, 4) + "ab" +
                             little_endian(2, 8) + little_endian(0x3ff0000000000000, 8) +
                             little_endian(0xc000000000000000, 8);
    EXPECT_EQ(read_file(folder / "state.bin"), with_checksum(body));
}

TEST(StateFile, DetectsAnyChangedByte) {
    const TemporaryFolder folder;
    write_state(folder / "state.bin", sample());
    const std::string whole = read_file(folder / "state.bin");
    ASSERT_GT(whole.size(), 100u);
    for (std::size_t i = 0; i < whole.size(); ++i)
        for (const int flip : {0x01, 0x80, 0xff}) {
            std::string damaged = whole;
            damaged[i] = static_cast<char>(damaged[i] ^ flip);
            put(folder / "damaged.bin", damaged);
            EXPECT_THROW(read_state(folder / "damaged.bin"), InputError) << "byte " << i;
        }
}

TEST(StateFile, DetectsAnyOtherLength) {
    const TemporaryFolder folder;
    write_state(folder / "state.bin", sample());
    const std::string whole = read_file(folder / "state.bin");
    for (std::size_t length = 0; length < whole.size(); ++length) {
        put(folder / "short.bin", whole.substr(0, length));
        EXPECT_THROW(read_state(folder / "short.bin"), InputError) << "length " << length;
    }
    put(folder / "long.bin", whole + '\0');
    EXPECT_THROW(read_state(folder / "long.bin"), InputError);
}

TEST(StateFile, DetectsWrongLengthsDespiteAValidChecksum) {
    const TemporaryFolder folder;
    const std::string start = std::string("GASPARD STATE\n\0\0", 16) + little_endian(1, 4);
    const std::string one = little_endian(1, 4);
    for (const std::string& body :
         {start + one + little_endian(0xffffffff, 4),                                        // layout
          start + one + little_endian(0, 4) + little_endian(0, 4) + little_endian(~0ull, 8), // values
          start + one + little_endian(0, 4) + little_endian(0, 4) + little_endian(1ull << 61, 8),
          start + little_endian(0xffffffff, 4) + little_endian(0, 4), // arrays
          start + little_endian(0, 4) + little_endian(0, 4) + "more"}) {
        put(folder / "state.bin", with_checksum(body));
        EXPECT_EQ(refusal(folder / "state.bin"),
                  "the state file " + (folder / "state.bin").string() + " is damaged");
    }
}

TEST(StateFile, ReportsErrors) {
    const TemporaryFolder folder;
    const std::string file = (folder / "state.bin").string();
    EXPECT_EQ(refusal(file), "cannot read " + file + ": No such file or directory");
    put(file, "v 1 2 3\n");
    EXPECT_EQ(refusal(file), "the state file " + file + " is not a Gaspard state file (state.bin of a run)");
    put(file,
        with_checksum(std::string("GASPARD STATE\n\0\0", 16) + little_endian(7, 4) + little_endian(0, 8)));
    EXPECT_EQ(refusal(file), "the state file " + file + " has version 7; this program supports version 1");
    for (const double value : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        write_state(file, State{"x", {{"phi", {1, value}}}});
        EXPECT_EQ(refusal(file), "the state file " + file + " contains numbers that are not finite");
    }
}

} // namespace
} // namespace gaspard

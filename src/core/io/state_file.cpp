#include "core/io/state_file.hpp"

#include "core/base/error.hpp"
#include "core/base/fnv1a.hpp"
#include "core/base/read_file.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/little_endian.hpp"

#include <bit>
#include <cmath>

namespace gaspard {

namespace {

constexpr std::string_view mark("GASPARD STATE\n\0\0", 16);
constexpr std::uint32_t newest_version = 1;

void append_text(std::string& bytes, std::string_view text) {
    append_little_endian(bytes, static_cast<std::uint32_t>(text.size()));
    bytes += text;
}

/// Reads from the front of the bytes; throws InputError if there are too few.
class Reader {
  public:
    Reader(std::string_view bytes, std::string file) : bytes_(bytes), file_(std::move(file)) {}

    std::string_view take(std::uint64_t count) {
        if (count > bytes_.size()) fail("is damaged");
        const auto taken = bytes_.substr(0, count);
        bytes_.remove_prefix(count);
        return taken;
    }
    template <class Unsigned>
    Unsigned number() {
        Unsigned value = 0;
        const auto bytes = take(sizeof value);
        for (std::size_t i = 0; i < sizeof value; ++i)
            value |= static_cast<Unsigned>(static_cast<unsigned char>(bytes[i])) << (8 * i);
        return value;
    }
    std::string text() { return std::string(take(number<std::uint32_t>())); }
    std::vector<double> reals() {
        const auto count = number<std::uint64_t>();
        if (count > bytes_.size() / sizeof(double)) fail("is damaged");
        std::vector<double> values(count);
        for (double& value : values) {
            value = std::bit_cast<double>(number<std::uint64_t>());
            if (!std::isfinite(value)) fail("contains numbers that are not finite");
        }
        return values;
    }
    std::size_t left() const { return bytes_.size(); }
    [[noreturn]] void fail(const std::string& what) const {
        throw InputError("the state file " + file_ + " " + what);
    }

  private:
    std::string_view bytes_;
    std::string file_;
};

} // namespace

bool is_state(std::string_view head) { return head.starts_with(mark); }

namespace {

void check_whole(Reader& reader, std::string_view bytes) {
    if (!is_state(bytes)) reader.fail("is not a Gaspard state file (state.bin of a run)");
    if (bytes.size() < mark.size() + sizeof(std::uint64_t)) reader.fail("is truncated");
    const auto body = bytes.substr(0, bytes.size() - sizeof(std::uint64_t));
    if (Reader(bytes.substr(body.size()), {}).number<std::uint64_t>() != fnv1a(body))
        reader.fail("is damaged: the checksum does not match");
}

} // namespace

void write_state(const std::filesystem::path& file, const State& state) {
    std::string bytes(mark);
    append_little_endian(bytes, newest_version);
    append_little_endian(bytes, static_cast<std::uint32_t>(state.arrays.size()));
    append_text(bytes, state.layout);
    for (const auto& array : state.arrays) {
        append_text(bytes, array.name);
        append_little_endian(bytes, static_cast<std::uint64_t>(array.values.size()));
        for (const double value : array.values) append_little_endian(bytes, value);
    }
    append_little_endian(bytes, fnv1a(bytes));
    write_atomically(file, bytes);
}

State read_state(const std::filesystem::path& file) {
    const std::string bytes = read_file(file);
    Reader reader(bytes, file.string());
    check_whole(reader, bytes);
    reader.take(mark.size());
    const auto version = reader.number<std::uint32_t>();
    if (version != newest_version)
        reader.fail("has version " + std::to_string(version) + "; this program supports version " +
                    std::to_string(newest_version));
    const auto count = reader.number<std::uint32_t>();
    State state;
    state.layout = reader.text();
    for (std::uint32_t i = 0; i < count; ++i) {
        State::Array array;
        array.name = reader.text();
        array.values = reader.reals();
        state.arrays.push_back(std::move(array));
    }
    if (reader.left() != sizeof(std::uint64_t)) reader.fail("is damaged");
    return state;
}

} // namespace gaspard

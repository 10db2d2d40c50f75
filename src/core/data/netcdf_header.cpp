#include "core/data/netcdf_header.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gaspard {

namespace {

constexpr std::size_t most_entries = 10'000;  // of a list
constexpr std::size_t most_dimensions = 1024; // of a variable: the library's limit
constexpr std::size_t longest_name = 256;

[[noreturn]] void damaged() {
    throw InputError("it is damaged, or not a NetCDF file (its header is not valid)");
}

class Header {
  public:
    explicit Header(std::string_view bytes) : bytes_(bytes) {
        if (bytes.size() < 8 || !bytes.starts_with("CDF")) damaged();
        const char version = bytes[3];
        if (version != 1 && version != 2 && version != 5) damaged();
        long_counts_ = version == 5, long_offsets_ = version != 1;
        at_ = 4;
        records_ = count();
    }

    void check() {
        read_dimensions();
        read_attributes();
        const std::size_t variables = list(0x0b);
        for (std::size_t i = 0; i < variables; ++i) read_variable();
    }

  private:
    std::uint64_t number(std::size_t size) {
        if (bytes_.size() - at_ < size) damaged();
        std::uint64_t value = 0;
        for (std::size_t k = 0; k < size; ++k)
            value = value << 8 | static_cast<unsigned char>(bytes_[at_ + k]);
        at_ += size;
        return value;
    }
    std::uint64_t count() { return number(long_counts_ ? 8 : 4); }

    void skip(std::uint64_t size) {
        const std::uint64_t padded = (size + 3) / 4 * 4;
        if (size > bytes_.size() || padded > bytes_.size() - at_) damaged();
        at_ += static_cast<std::size_t>(padded);
    }

    /// The number of entries of a list with this tag; an absent list has the tag 0 and none.
    std::size_t list(std::uint64_t tag) {
        const std::uint64_t found = number(4), entries = count();
        if ((found != tag && found != 0) || (found == 0 && entries > 0) || entries > most_entries) damaged();
        return static_cast<std::size_t>(entries);
    }

    void read_name() {
        const std::uint64_t length = count();
        if (length == 0 || length > longest_name) damaged();
        skip(length);
    }

    static std::uint64_t size_of(std::uint64_t type) {
        static constexpr std::array<std::uint64_t, 12> sizes = {0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
        if (type == 0 || type >= sizes.size()) damaged();
        return sizes[static_cast<std::size_t>(type)];
    }

    void read_dimensions() {
        const std::size_t dimensions = list(0x0a);
        for (std::size_t i = 0; i < dimensions; ++i) {
            read_name();
            lengths_.push_back(count());
            if (lengths_.back() > std::uint64_t{1} << 40) damaged();
        }
        if (std::count(lengths_.begin(), lengths_.end(), 0) > 1) damaged(); // one may grow
    }

    void read_attributes() {
        const std::size_t attributes = list(0x0c);
        for (std::size_t i = 0; i < attributes; ++i) {
            read_name();
            const std::uint64_t size = size_of(number(4)), values = count();
            if (values > bytes_.size()) damaged();
            skip(values * size);
        }
    }

    void read_variable() {
        read_name();
        const std::uint64_t rank = count();
        if (rank > most_dimensions) damaged();
        std::uint64_t values = 1;
        for (std::uint64_t d = 0; d < rank; ++d) {
            const std::uint64_t dimension = count();
            if (dimension >= lengths_.size()) damaged();
            const std::uint64_t length = lengths_[static_cast<std::size_t>(dimension)];
            if (length == 0 && d > 0) damaged(); // records come first
            if (length > 0 && values > (std::uint64_t{1} << 48) / length) damaged();
            values *= std::max<std::uint64_t>(length, 1);
        }
        read_attributes();
        const std::uint64_t size = size_of(number(4)) * values;
        count(); // its size once more, which may not fit
        const std::uint64_t begin = number(long_offsets_ ? 8 : 4);
        if (begin > bytes_.size() || size > bytes_.size() - begin + 3) {
            // A variable of which nothing is written yet, in a file without records.
            const bool of_records = rank > 0 && records_ == 0;
            if (!of_records) damaged();
        }
    }

    std::string_view bytes_;
    std::size_t at_ = 0;
    bool long_counts_ = false, long_offsets_ = false;
    std::uint64_t records_ = 0;
    std::vector<std::uint64_t> lengths_;
};

} // namespace

void check_classic_netcdf(std::string_view bytes) { Header(bytes).check(); }

} // namespace gaspard

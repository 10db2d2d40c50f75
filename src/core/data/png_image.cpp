// PNG by libpng, row by row. libpng reports errors by longjmp, which runs no destructors: between setjmp
// and the calls of libpng there are only trivial objects.
#include "core/base/error.hpp"
#include "core/data/image_rows.hpp"

#include <algorithm>
#include <csetjmp>
#include <cstring>
#include <limits>
#include <optional>
#include <png.h>

namespace gaspard {

namespace {

/// The most that an interlaced picture may take, which is decoded as a whole.
constexpr std::size_t most_picture_bytes = std::size_t{1} << 29;

class PngDecoder {
  public:
    explicit PngDecoder(const DecodeContext& context) : context_(context), rest_(context.bytes) {
        png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, &fail, &ignore);
        info_ = png_ ? png_create_info_struct(png_) : nullptr;
        if (!info_) {
            png_destroy_read_struct(&png_, nullptr, nullptr);
            throw MachineError("not enough memory to read " + context.name);
        }
    }
    ~PngDecoder() { png_destroy_read_struct(&png_, &info_, nullptr); }
    PngDecoder(const PngDecoder&) = delete;
    PngDecoder& operator=(const PngDecoder&) = delete;

    GreyImage decode() {
        if (!read_header()) refuse();
        check_image_size(context_.name, width_, height_);
        if (!set_up()) refuse();
        rows_.emplace(context_, width_, height_, width_, height_);
        grey_.resize(width_);
        if (passes_ > 1)
            decode_whole();
        else
            decode_rows();
        return rows_->take("PNG");
    }

  private:
    [[noreturn]] void refuse() const {
        refuse_image(context_.name, ended_ ? "the PNG picture is incomplete" : "the PNG picture is damaged");
    }
    static void fail(png_structp png, png_const_charp) {
        std::longjmp(static_cast<PngDecoder*>(png_get_error_ptr(png))->jump_, 1);
    }
    static void ignore(png_structp, png_const_charp) {}
    static void read(png_structp png, png_bytep to, std::size_t count) {
        auto& self = *static_cast<PngDecoder*>(png_get_io_ptr(png));
        if (self.rest_.size() < count) {
            self.ended_ = true;
            png_error(png, "end of file");
        }
        std::memcpy(to, self.rest_.data(), count);
        self.rest_.remove_prefix(count);
    }

    bool read_header() {
        if (setjmp(jump_)) return false;
        png_set_read_fn(png_, this, &read);
        png_set_user_limits(png_, std::numeric_limits<std::int32_t>::max(),
                            std::numeric_limits<std::int32_t>::max()); // check_image_size is stricter
        png_set_chunk_malloc_max(png_, 8 << 20);
        png_set_chunk_cache_max(png_, 64);
        png_read_info(png_, info_);
        width_ = png_get_image_width(png_, info_), height_ = png_get_image_height(png_, info_);
        return true;
    }
    /// Rows are then grey, grey with alpha, RGB or RGBA, of 8 or 16 bits.
    bool set_up() {
        if (setjmp(jump_)) return false;
        png_set_expand(png_);
        passes_ = png_set_interlace_handling(png_);
        png_read_update_info(png_, info_);
        row_bytes_ = png_get_rowbytes(png_, info_);
        channels_ = png_get_channels(png_, info_);
        bytes_ = png_get_bit_depth(png_, info_) == 16 ? 2 : 1;
        return true;
    }
    bool read_row(png_bytep row) {
        if (setjmp(jump_)) return false;
        png_read_row(png_, row, nullptr);
        return true;
    }
    bool read_end() {
        if (setjmp(jump_)) return false;
        png_read_end(png_, nullptr);
        return true;
    }

    void decode_rows() {
        std::vector<png_byte> row(row_bytes_);
        for (std::size_t y = 0; y < height_; ++y) {
            if (!read_row(row.data())) refuse();
            add(row.data());
        }
        if (!read_end()) refuse();
    }
    void decode_whole() {
        if (row_bytes_ > most_picture_bytes / height_)
            refuse_image(context_.name, "the interlaced picture takes more than 512 MiB; save it without "
                                        "interlacing");
        std::vector<png_byte> pixels(row_bytes_ * height_);
        for (int pass = 0; pass < passes_; ++pass)
            for (std::size_t y = 0; y < height_; ++y) {
                if (context_.stop.stop_requested()) throw Interrupted();
                if (!read_row(pixels.data() + y * row_bytes_)) refuse();
            }
        if (!read_end()) refuse();
        for (std::size_t y = 0; y < height_; ++y) add(pixels.data() + y * row_bytes_);
    }
    void add(const png_byte* row) {
        bytes_ == 2 ? convert<2>(row) : convert<1>(row);
        rows_->add(grey_);
    }
    template <int bytes>
    void convert(const png_byte* p) {
        constexpr float scale = bytes == 2 ? 1 / 65535.0F : 1 / 255.0F;
        const auto at = [&](int channel) {
            if constexpr (bytes == 2)
                return static_cast<float>(p[2 * channel] << 8 | p[2 * channel + 1]);
            else
                return static_cast<float>(p[channel]);
        };
        const int channels = channels_, step = channels * bytes;
        for (std::size_t i = 0; i < width_; ++i, p += step) {
            float grey = at(0);
            if (channels >= 3) grey = 0.299F * grey + 0.587F * at(1) + 0.114F * at(2);
            grey *= scale;
            if (channels % 2 == 0) grey = 1 - at(channels - 1) * scale * (1 - grey);
            grey_[i] = grey;
        }
    }

    const DecodeContext& context_;
    std::string_view rest_;
    bool ended_ = false;
    std::jmp_buf jump_{};
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
    std::size_t width_ = 0, height_ = 0, row_bytes_ = 0;
    int passes_ = 1, channels_ = 1, bytes_ = 1;
    std::optional<ImageRows> rows_;
    std::vector<float> grey_;
};

} // namespace

GreyImage decode_png(const DecodeContext& context) { return PngDecoder(context).decode(); }

} // namespace gaspard

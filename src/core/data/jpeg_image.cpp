// JPEG by libjpeg-turbo, row by row; large pictures are reduced by 2, 4 or 8 as they are decoded. libjpeg
// reports errors by longjmp, which runs no destructors: between setjmp and the calls of libjpeg there are
// only trivial objects.
#include "core/base/error.hpp"
#include "core/data/image_rows.hpp"

#include <algorithm>
#include <csetjmp>
#include <cstdio> // before jpeglib.h, which needs FILE
#include <jerror.h>
#include <jpeglib.h>
#include <optional>

namespace gaspard {

namespace {

/// The most that the coefficients of a progressive picture may take, which libjpeg keeps as a whole.
constexpr std::size_t most_bytes = std::size_t{1} << 29;
/// Real pictures have about ten scans; thousands of them on a large picture would take hours.
constexpr int most_scans = 200;

class JpegDecoder {
  public:
    explicit JpegDecoder(const DecodeContext& context) : context_(context) {
        jpeg_.err = jpeg_std_error(&errors_);
        jpeg_.client_data = this;
        errors_.error_exit = &fail;
        errors_.emit_message = &note;
        errors_.output_message = [](j_common_ptr) {};
        progress_.progress_monitor = &watch;
    }
    ~JpegDecoder() { jpeg_destroy_decompress(&jpeg_); }
    JpegDecoder(const JpegDecoder&) = delete;
    JpegDecoder& operator=(const JpegDecoder&) = delete;

    GreyImage decode() {
        if (!read_header()) refuse();
        check_image_size(context_.name, jpeg_.image_width, jpeg_.image_height);
        const std::size_t pixels = std::size_t{jpeg_.image_width} * jpeg_.image_height;
        const auto components = static_cast<std::size_t>(jpeg_.num_components);
        if (jpeg_has_multiple_scans(&jpeg_) && pixels > most_bytes / 2 / components)
            refuse_image(context_.name,
                         "the progressive picture takes more than 512 MiB; save it as baseline JPEG");
        choose_output();
        const int turned = orientation(); // libjpeg forgets the markers when it has finished
        if (!start()) refuse();
        rows_.emplace(context_, jpeg_.output_width, jpeg_.output_height, jpeg_.image_width,
                      jpeg_.image_height);
        decode_rows();
        return upright(rows_->take("JPEG"), turned);
    }

  private:
    [[noreturn]] void refuse() const {
        if (stopped_) throw Interrupted();
        if (code_ == JERR_CONVERSION_NOTIMPL || code_ == JERR_BAD_PRECISION ||
            code_ == JERR_SOF_UNSUPPORTED || code_ == JERR_ARITH_NOTIMPL)
            refuse_image(context_.name, "this kind of JPEG is not supported; save it as baseline JPEG");
        if (code_ == JWRN_JPEG_EOF) refuse_image(context_.name, "the JPEG picture is incomplete");
        refuse_image(context_.name, "the JPEG picture is damaged");
    }
    static JpegDecoder& self(j_common_ptr jpeg) { return *static_cast<JpegDecoder*>(jpeg->client_data); }
    [[noreturn]] static void give_up(j_common_ptr jpeg, int code) {
        self(jpeg).code_ = code;
        std::longjmp(self(jpeg).jump_, 1);
    }
    static void fail(j_common_ptr jpeg) { give_up(jpeg, jpeg->err->msg_code); }
    /// Warnings: libjpeg goes on with grey pixels where data are damaged. Others are ignored.
    static void note(j_common_ptr jpeg, int level) {
        if (level >= 0) return;
        for (const int code : {int{JWRN_JPEG_EOF}, int{JWRN_HIT_MARKER}, int{JWRN_HUFF_BAD_CODE},
                               int{JWRN_MUST_RESYNC}, int{JWRN_NOT_SEQUENTIAL}})
            if (jpeg->err->msg_code == code) give_up(jpeg, code);
    }
    static void watch(j_common_ptr jpeg) {
        JpegDecoder& decoder = self(jpeg);
        if (decoder.context_.stop.stop_requested()) {
            decoder.stopped_ = true;
            give_up(jpeg, 0);
        }
        if (decoder.jpeg_.input_scan_number > most_scans) give_up(jpeg, JERR_CONVERSION_NOTIMPL);
    }

    bool read_header() {
        if (setjmp(jump_)) return false;
        jpeg_create_decompress(&jpeg_);
        jpeg_.progress = &progress_;
        jpeg_mem_src(&jpeg_, reinterpret_cast<const unsigned char*>(context_.bytes.data()),
                     static_cast<unsigned long>(context_.bytes.size()));
        jpeg_save_markers(&jpeg_, JPEG_APP0 + 1, 0xffff);
        jpeg_read_header(&jpeg_, TRUE);
        return true;
    }
    void choose_output() {
        const bool printed = jpeg_.jpeg_color_space == JCS_CMYK || jpeg_.jpeg_color_space == JCS_YCCK;
        jpeg_.out_color_space = printed ? JCS_CMYK : JCS_GRAYSCALE;
        jpeg_.dct_method = JDCT_ISLOW;
        const std::size_t side = std::max(jpeg_.image_width, jpeg_.image_height);
        jpeg_.scale_num = 1, jpeg_.scale_denom = 1;
        // Not below `longest`, so that averages of whole pixels follow.
        while (jpeg_.scale_denom < 8 && side / (2 * jpeg_.scale_denom) >= context_.longest)
            jpeg_.scale_denom *= 2;
    }
    bool start() {
        if (setjmp(jump_)) return false;
        jpeg_start_decompress(&jpeg_);
        return true;
    }
    bool read_row(unsigned char* row) {
        if (setjmp(jump_)) return false;
        jpeg_read_scanlines(&jpeg_, &row, 1);
        return true;
    }
    bool finish() {
        if (setjmp(jump_)) return false;
        jpeg_finish_decompress(&jpeg_);
        return true;
    }

    void decode_rows() {
        const std::size_t width = jpeg_.output_width;
        const bool printed = jpeg_.out_color_space == JCS_CMYK;
        std::vector<unsigned char> row(width * static_cast<std::size_t>(jpeg_.output_components));
        std::vector<float> grey(width);
        for (std::size_t y = 0; y < jpeg_.output_height; ++y) {
            if (!read_row(row.data())) refuse();
            for (std::size_t i = 0; i < width; ++i)
                grey[i] = printed ? ink(row.data() + 4 * i) : static_cast<float>(row[i]) / 255;
            rows_->add(grey);
        }
        if (!finish()) refuse();
    }
    /// Cyan, magenta, yellow and black; Adobe's programs store what is left white.
    float ink(const unsigned char* p) const {
        float left[4];
        for (int k = 0; k < 4; ++k)
            left[k] = static_cast<float>(jpeg_.saw_Adobe_marker ? p[k] : 255 - p[k]) / 255;
        return (0.299F * left[0] + 0.587F * left[1] + 0.114F * left[2]) * left[3];
    }
    int orientation() const {
        constexpr std::string_view sign("Exif\0\0", 6);
        for (auto marker = jpeg_.marker_list; marker; marker = marker->next) {
            const std::string_view data(reinterpret_cast<const char*>(marker->data), marker->data_length);
            if (data.starts_with(sign))
                return exif_orientation({marker->data + sign.size(), marker->data_length - sign.size()});
        }
        return 1;
    }

    const DecodeContext& context_;
    jpeg_decompress_struct jpeg_{};
    jpeg_error_mgr errors_{};
    jpeg_progress_mgr progress_{};
    std::jmp_buf jump_{};
    int code_ = 0;
    bool stopped_ = false;
    std::optional<ImageRows> rows_;
};

} // namespace

GreyImage decode_jpeg(const DecodeContext& context) { return JpegDecoder(context).decode(); }

} // namespace gaspard

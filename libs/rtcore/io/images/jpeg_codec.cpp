#include "rtcore/io/images/codecs.h"
#include "rtcore/io/images/damage_forms.h"
#include "rtcore/io/images/panorama_xmp.h"
#include "rtcore/settings/library_text.h"

#include <cstdio> // jpeglib.h needs it

#include <jpeglib.h>

#include <jerror.h>

#include <array>
#include <csetjmp>
#include <cstdlib>

namespace rtcore {
namespace {

constexpr int kQuality = 95;
constexpr int kMaxScans = 500; // a progressive file of many empty scans would take hours

constexpr auto kJpegTexts = std::to_array<LibraryText>({
    {"Premature end of {0}", damage::kEndsEarly},
    {"Corrupt JPEG data: {0}", damage::kPixels},
    {"DCT coefficient out of range", damage::kPixels},
    {"Bogus {0}", damage::kHeader},
    {"Invalid {0}", damage::kHeader},
    {"Missing {0}", damage::kHeader},
    {"Not a JPEG file: {0}", damage::kHeader},
    {"JPEG datastream contains no image", damage::kHeader},
    {"Too many color components: {0}", damage::kHeader},
    {"Sampling factors too large {0}", damage::kHeader},
    {"{0} was not defined", damage::kHeader},
    {"Unsupported {0}", damage::kUnread},
    {"{0} not implemented{1}", damage::kUnread},
    {"{0} not supported{1}", damage::kUnread},
});

/// libjpeg's own handler ends the process. This one returns to the last setjmp, so every function that calls
/// the library has only trivial variables. (`base` comes first: the library hands back a pointer to it.)
struct JpegErrors {
    jpeg_error_mgr base;
    std::jmp_buf leave;
    std::array<char, JMSG_LENGTH_MAX> message;
};

JpegErrors& errorsOf(j_common_ptr info) { return *reinterpret_cast<JpegErrors*>(info->err); }

[[noreturn]] void onError(j_common_ptr info) {
    info->err->format_message(info, errorsOf(info).message.data());
    std::longjmp(errorsOf(info).leave, 1);
}

/// Warnings that mean that a part of the image is missing are errors here.
void onMessage(j_common_ptr info, int level) {
    const int code = info->err->msg_code;
    const bool damaged = code == JWRN_JPEG_EOF || code == JWRN_HIT_MARKER || code == JWRN_HUFF_BAD_CODE;
    if (level < 0 && damaged) onError(info);
}

void onProgress(j_common_ptr info) {
    if (reinterpret_cast<j_decompress_ptr>(info)->input_scan_number > kMaxScans) {
        info->err->msg_code = JERR_BAD_PROGRESSION;
        onError(info);
    }
}

void install(JpegErrors& errors, jpeg_error_mgr*& target) {
    target = jpeg_std_error(&errors.base);
    errors.base.error_exit = onError;
    errors.base.emit_message = onMessage;
    errors.message.fill(0);
}

/// One row of `components` bytes a pixel to colours. CMYK is stored inverted by Adobe's programs, which say
/// so.
void convertRow(const JSAMPLE* row, int components, bool inverted, Rgba8* target, int width) {
    const auto channel = [&](unsigned ink, unsigned black) {
        const unsigned product = inverted ? ink * black : (255 - ink) * (255 - black);
        return static_cast<std::uint8_t>((product + 127) / 255);
    };
    for (int x = 0; x < width; ++x, row += components) {
        if (components == 1) target[x] = {row[0], row[0], row[0], 255};
        if (components == 3) target[x] = {row[0], row[1], row[2], 255};
        if (components == 4) {
            target[x] = {channel(row[0], row[3]), channel(row[1], row[3]), channel(row[2], row[3]), 255};
        }
    }
}

class JpegReader {
  public:
    JpegReader(ByteSpan bytes, const std::string& name) : bytes_(bytes), name_(name) {
        install(errors_, info_.err);
        progress_.progress_monitor = onProgress;
    }
    ~JpegReader() { jpeg_destroy_decompress(&info_); }
    JpegReader(const JpegReader&) = delete;
    JpegReader& operator=(const JpegReader&) = delete;

    DecodedImage read() {
        if (!readHeader()) fail();
        checkImageSize(name_, info_.image_width, info_.image_height);
        // Every block of 8 x 8 pixels, at most 16 x 16 for colour, takes some bits even where nothing is to
        // be seen.
        const std::size_t pixels = std::size_t{info_.image_width} * info_.image_height;
        checkPlausible(name_, pixels, bytes_.size(), 2048);
        if (!start()) fail();
        LdrImage image(static_cast<int>(info_.output_width), static_cast<int>(info_.output_height));
        row_.resize(std::size_t{info_.output_width} * static_cast<std::size_t>(info_.output_components));
        while (info_.output_scanline < info_.output_height) {
            const int y = static_cast<int>(info_.output_scanline);
            if (!readRow()) fail();
            convertRow(row_.data(), info_.output_components, info_.saw_Adobe_marker != 0, &image.at(0, y),
                       image.width);
        }
        if (!finish()) fail();
        return image;
    }

  private:
    bool readHeader() {
        if (setjmp(errors_.leave) != 0) return false;
        jpeg_create_decompress(&info_);
        info_.progress = &progress_;
        jpeg_mem_src(&info_, reinterpret_cast<const unsigned char*>(bytes_.data()),
                     static_cast<unsigned long>(bytes_.size()));
        jpeg_read_header(&info_, TRUE);
        return true;
    }
    bool start() {
        if (setjmp(errors_.leave) != 0) return false;
        switch (info_.jpeg_color_space) {
        case JCS_GRAYSCALE:
            info_.out_color_space = JCS_GRAYSCALE;
            break;
        case JCS_CMYK:
        case JCS_YCCK:
            info_.out_color_space = JCS_CMYK;
            break;
        default:
            info_.out_color_space = JCS_RGB;
            break;
        }
        jpeg_start_decompress(&info_);
        return true;
    }
    bool readRow() {
        if (setjmp(errors_.leave) != 0) return false;
        JSAMPROW row = row_.data();
        return jpeg_read_scanlines(&info_, &row, 1) == 1;
    }
    bool finish() {
        if (setjmp(errors_.leave) != 0) return false;
        jpeg_finish_decompress(&info_);
        return true;
    }
    [[noreturn]] void fail() const {
        badImage(name_, say("damaged JPEG: {0}", meaningOf(errors_.message.data(), kJpegTexts)));
    }

    ByteSpan bytes_;
    const std::string& name_;
    jpeg_decompress_struct info_{};
    JpegErrors errors_{};
    jpeg_progress_mgr progress_{};
    std::vector<JSAMPLE> row_;
};

class JpegWriter {
  public:
    explicit JpegWriter(const std::string& name) : name_(name) { install(errors_, info_.err); }
    ~JpegWriter() {
        jpeg_destroy_compress(&info_);
        std::free(buffer_);
    }
    JpegWriter(const JpegWriter&) = delete;
    JpegWriter& operator=(const JpegWriter&) = delete;

    /// `xmp`: a packet to keep; may be "".
    Bytes write(const LdrImage& image, const std::string& xmp) {
        if (!start(image.width, image.height)) fail();
        if (!xmp.empty() && !writeXmp(std::string("http://ns.adobe.com/xap/1.0/") + '\0' + xmp)) fail();
        std::vector<JSAMPLE> row(static_cast<std::size_t>(image.width) * 3);
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                const Rgba8 p = image.at(x, y);
                JSAMPLE* target = row.data() + static_cast<std::size_t>(x) * 3;
                target[0] = p.r;
                target[1] = p.g;
                target[2] = p.b;
            }
            if (!writeRow(row.data())) fail();
        }
        if (!finish()) fail();
        const auto* bytes = reinterpret_cast<const std::byte*>(buffer_);
        return {bytes, bytes + size_};
    }

  private:
    bool start(int width, int height) {
        if (setjmp(errors_.leave) != 0) return false;
        jpeg_create_compress(&info_);
        jpeg_mem_dest(&info_, &buffer_, &size_);
        info_.image_width = static_cast<JDIMENSION>(width);
        info_.image_height = static_cast<JDIMENSION>(height);
        info_.input_components = 3;
        info_.in_color_space = JCS_RGB;
        jpeg_set_defaults(&info_);
        jpeg_set_quality(&info_, kQuality, TRUE);
        // Full resolution of colour, too: a rendering has sharp coloured edges.
        info_.comp_info[0].h_samp_factor = info_.comp_info[0].v_samp_factor = 1;
        jpeg_start_compress(&info_, TRUE);
        return true;
    }
    bool writeXmp(const std::string& content) {
        if (setjmp(errors_.leave) != 0) return false;
        jpeg_write_marker(&info_, JPEG_APP0 + 1, reinterpret_cast<const JOCTET*>(content.data()),
                          static_cast<unsigned>(content.size()));
        return true;
    }
    bool writeRow(JSAMPROW row) {
        if (setjmp(errors_.leave) != 0) return false;
        return jpeg_write_scanlines(&info_, &row, 1) == 1;
    }
    bool finish() {
        if (setjmp(errors_.leave) != 0) return false;
        jpeg_finish_compress(&info_);
        return true;
    }
    [[noreturn]] void fail() const {
        cannotEncode(name_, say("{0}: {1}", std::string("JPEG"), meaningOf(errors_.message.data(), {})));
    }

    const std::string& name_;
    jpeg_compress_struct info_{};
    JpegErrors errors_{};
    unsigned char* buffer_ = nullptr;
    unsigned long size_ = 0;
};

} // namespace

DecodedImage decodeJpeg(ByteSpan bytes, const std::string& name) { return JpegReader(bytes, name).read(); }

Bytes encodeJpeg(const LdrImage& image, bool panorama, const std::string& name) {
    return JpegWriter(name).write(image, panorama ? panoramaXmp(image.width, image.height) : std::string());
}

} // namespace rtcore

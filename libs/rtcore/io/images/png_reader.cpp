#include "rtcore/io/images/codecs.h"
#include "rtcore/io/images/damage_forms.h"
#include "rtcore/settings/library_text.h"

#include <png.h>

#include <array>
#include <bit>
#include <csetjmp>
#include <cstring>

namespace rtcore {
namespace {

constexpr auto kPngTexts = std::to_array<LibraryText>({
    {damage::kEndsEarly, damage::kEndsEarly},
    {"Not enough image data", damage::kEndsEarly},
    {"{0}: CRC error", damage::kChecksum},
    {"IDAT: {0}", damage::kPixels},
    {"Decompression error", damage::kPixels},
    {"bad adaptive filter value", damage::kPixels},
    {"Invalid {0}", damage::kHeader},
    {"Missing {0}", damage::kHeader},
    {"IHDR: {0}", damage::kHeader},
    {"{0}: invalid chunk type", damage::kHeader},
    {"{0}: missing {1}", damage::kHeader},
    {"{0}: out of place", damage::kHeader},
    {"PNG unsigned integer out of range", damage::kHeader},
    {"PNG file corrupted by ASCII conversion", damage::kHeader},
    {"Not a PNG file", damage::kHeader},
});

/// libpng leaves by longjmp when it meets an error, so every function that calls it has only trivial
/// variables.
class PngReader {
  public:
    PngReader(ByteSpan bytes, const std::string& name)
        : bytes_(bytes), name_(name),
          png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, this, onError, onWarning)),
          info_(png_ != nullptr ? png_create_info_struct(png_) : nullptr) {
        if (info_ == nullptr) fail(form("libpng cannot be started"));
    }
    ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;

    DecodedImage read() {
        if (!readHeader()) fail(meaningOf(message_.data(), kPngTexts));
        checkImageSize(name_, width_, height_);
        // Deflate never packs more than 1032 bytes into one.
        checkPlausible(name_, static_cast<std::size_t>(height_) * storedRowBytes_, bytes_.size(), 1040);
        if (depth_ == 16) return readInto(DeepImage(static_cast<int>(width_), static_cast<int>(height_)));
        return readInto(LdrImage(static_cast<int>(width_), static_cast<int>(height_)));
    }

  private:
    template <typename Pixel>
    DecodedImage readInto(Image<Pixel> image) {
        const std::size_t rowBytes = static_cast<std::size_t>(width_) * sizeof(Pixel);
        if (rowBytes_ != rowBytes) fail(form("unexpected row size"));
        rows_.resize(height_);
        auto* data = reinterpret_cast<png_bytep>(image.pixels.data());
        for (std::size_t y = 0; y < rows_.size(); ++y) rows_[y] = data + y * rowBytes;
        if (!readPixels()) fail(meaningOf(message_.data(), kPngTexts));
        return image;
    }

    bool readHeader() {
        if (setjmp(png_jmpbuf(png_)) != 0) return false;
        png_set_user_limits(png_, kMaxImageSide, kMaxImageSide);
        png_set_read_fn(png_, this, onRead);
        png_read_info(png_, info_);
        width_ = png_get_image_width(png_, info_);
        height_ = png_get_image_height(png_, info_);
        depth_ = png_get_bit_depth(png_, info_);
        storedRowBytes_ = png_get_rowbytes(png_, info_);
        toRgba();
        rowBytes_ = png_get_rowbytes(png_, info_);
        return true;
    }

    /// Asks for four channels of 8 or 16 bits, whatever the file holds.
    void toRgba() {
        png_set_expand(png_);
        png_set_gray_to_rgb(png_);
        png_set_add_alpha(png_, 0xffff, PNG_FILLER_AFTER);
        if (depth_ == 16 && std::endian::native == std::endian::little) png_set_swap(png_);
        png_set_interlace_handling(png_);
        png_read_update_info(png_, info_);
    }

    bool readPixels() {
        if (setjmp(png_jmpbuf(png_)) != 0) return false;
        png_read_image(png_, rows_.data());
        png_read_end(png_, nullptr);
        return true;
    }

    [[noreturn]] void fail(const Sentence& problem) const {
        badImage(name_, say("damaged PNG: {0}", problem));
    }

    static void onRead(png_structp png, png_bytep target, std::size_t count) {
        auto& self = *static_cast<PngReader*>(png_get_io_ptr(png));
        if (count > self.bytes_.size() - self.position_) png_error(png, damage::kEndsEarly);
        std::memcpy(target, self.bytes_.data() + self.position_, count);
        self.position_ += count;
    }
    [[noreturn]] static void onError(png_structp png, png_const_charp message) {
        auto& self = *static_cast<PngReader*>(png_get_error_ptr(png));
        std::strncpy(self.message_.data(), message, self.message_.size() - 1);
        png_longjmp(png, 1);
    }
    static void onWarning(png_structp /*png*/, png_const_charp /*message*/) {}

    ByteSpan bytes_;
    const std::string& name_;
    std::size_t position_ = 0;
    png_structp png_;
    png_infop info_;
    png_uint_32 width_ = 0, height_ = 0;
    int depth_ = 0;
    std::size_t storedRowBytes_ = 0, rowBytes_ = 0;
    std::vector<png_bytep> rows_;
    std::array<char, 200> message_{};
};

} // namespace

DecodedImage decodePng(ByteSpan bytes, const std::string& name) { return PngReader(bytes, name).read(); }

} // namespace rtcore

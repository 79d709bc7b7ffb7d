#include "rtcore/io/images/codecs.h"
#include "rtcore/settings/library_text.h"

#include <tiffio.h>

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstring>
#include <memory>
#include <mutex>

namespace rtcore {
namespace {

/// A file in memory, as libtiff wants to see one.
struct MemoryFile {
    ByteSpan input;
    Bytes output;
    bool writing = false;
    std::size_t position = 0;

    std::size_t size() const { return writing ? output.size() : input.size(); }
};

MemoryFile& fileOf(thandle_t handle) { return *static_cast<MemoryFile*>(handle); }

tmsize_t onRead(thandle_t handle, void* target, tmsize_t count) {
    MemoryFile& file = fileOf(handle);
    if (count <= 0 || file.position >= file.size()) return 0;
    const std::size_t n = std::min(static_cast<std::size_t>(count), file.size() - file.position);
    std::memcpy(target, (file.writing ? file.output.data() : file.input.data()) + file.position, n);
    file.position += n;
    return static_cast<tmsize_t>(n);
}

tmsize_t onWrite(thandle_t handle, void* source, tmsize_t count) {
    MemoryFile& file = fileOf(handle);
    if (!file.writing || count <= 0) return 0;
    const std::size_t end = file.position + static_cast<std::size_t>(count);
    if (end > file.output.size()) file.output.resize(end);
    std::memcpy(file.output.data() + file.position, source, static_cast<std::size_t>(count));
    file.position = end;
    return count;
}

toff_t onSeek(thandle_t handle, toff_t offset, int whence) {
    MemoryFile& file = fileOf(handle);
    const toff_t base = whence == SEEK_CUR ? file.position : whence == SEEK_END ? file.size() : 0;
    file.position = static_cast<std::size_t>(base + offset);
    return file.position;
}

int onClose(thandle_t /*handle*/) { return 0; }

toff_t onSize(thandle_t handle) { return fileOf(handle).size(); }

struct CloseTiff {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
using Tiff = std::unique_ptr<TIFF, CloseTiff>;

#if TIFFLIB_VERSION >= 20221213
constexpr tmsize_t kLargestAllocation = tmsize_t{1} << 31;

int ignoreMessage(TIFF* /*tiff*/, void* /*user*/, const char* /*module*/, const char* /*format*/,
                  va_list /*list*/) {
    return 1;
}

Tiff openTiff(MemoryFile& file, const char* mode) {
    const std::unique_ptr<TIFFOpenOptions, void (*)(TIFFOpenOptions*)> options(TIFFOpenOptionsAlloc(),
                                                                               TIFFOpenOptionsFree);
    TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), kLargestAllocation);
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), ignoreMessage, nullptr);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), ignoreMessage, nullptr);
    return Tiff(TIFFClientOpenExt("", mode, &file, onRead, onWrite, onSeek, onClose, onSize, nullptr, nullptr,
                                  options.get()));
}
#else
Tiff openTiff(MemoryFile& file, const char* mode) {
    static std::once_flag silenced;
    std::call_once(silenced, [] {
        TIFFSetErrorHandler(nullptr);
        TIFFSetWarningHandler(nullptr);
    });
    return Tiff(TIFFClientOpen("", mode, &file, onRead, onWrite, onSeek, onClose, onSize, nullptr, nullptr));
}
#endif

template <typename T>
T field(TIFF* tiff, std::uint32_t tag, T fallback) {
    T value = fallback;
    return TIFFGetFieldDefaulted(tiff, tag, &value) == 1 ? value : fallback;
}

constexpr auto kTiffTexts = std::to_array<LibraryText>({
    {"Sorry, can not handle images with {0}-bit samples", form("it has samples of {0} bits")},
    {"Sorry, can not handle images with IEEE floating-point samples",
     form("it has samples of an unusual kind")},
});

struct Layout {
    std::uint16_t bits, samples, format, planes, photometric, orientation;
    bool associatedAlpha, tiled;
};

Layout layoutOf(TIFF* tiff) {
    Layout l{};
    l.bits = field<std::uint16_t>(tiff, TIFFTAG_BITSPERSAMPLE, 1);
    l.samples = field<std::uint16_t>(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
    l.format = field<std::uint16_t>(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
    l.planes = field<std::uint16_t>(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    l.photometric = field<std::uint16_t>(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISWHITE);
    l.orientation = field<std::uint16_t>(tiff, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
    std::uint16_t extraCount = 0;
    const std::uint16_t* extra = nullptr;
    if (TIFFGetFieldDefaulted(tiff, TIFFTAG_EXTRASAMPLES, &extraCount, &extra) == 1 && extraCount > 0) {
        l.associatedAlpha = extra[0] == EXTRASAMPLE_ASSOCALPHA;
    }
    l.tiled = TIFFIsTiled(tiff) != 0;
    return l;
}

/// Rows of plain grey or RGB samples, with or without alpha: read as they are, in full depth.
bool isPlain(const Layout& l) {
    const bool rgb = l.photometric == PHOTOMETRIC_RGB && (l.samples == 3 || l.samples == 4);
    const bool grey = l.photometric == PHOTOMETRIC_MINISBLACK && (l.samples == 1 || l.samples == 2);
    const bool integer = l.format == SAMPLEFORMAT_UINT && (l.bits == 8 || l.bits == 16);
    const bool real = l.format == SAMPLEFORMAT_IEEEFP && l.bits == 32;
    return (rgb || grey) && (integer || real) && !l.tiled && !l.associatedAlpha &&
           (l.planes == PLANARCONFIG_CONTIG || l.samples == 1) && l.orientation == ORIENTATION_TOPLEFT;
}

void setPixel(Rgba8& p, const std::uint8_t* s, int n) {
    p = n < 3 ? Rgba8{s[0], s[0], s[0]} : Rgba8{s[0], s[1], s[2]};
    if (n % 2 == 0) p.a = s[n - 1];
}
void setPixel(Rgba16& p, const std::uint16_t* s, int n) {
    p = n < 3 ? Rgba16{s[0], s[0], s[0]} : Rgba16{s[0], s[1], s[2]};
    if (n % 2 == 0) p.a = s[n - 1];
}
void setPixel(Colour& p, const float* s, int n) {
    p = n < 3 ? Colour{s[0], s[0], s[0]} : Colour{s[0], s[1], s[2]};
}

template <typename Sample, typename Pixel>
Image<Pixel> readRows(TIFF* tiff, int samples, int width, int height, const std::string& name) {
    const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(samples);
    if (TIFFScanlineSize64(tiff) != count * sizeof(Sample))
        badImage(name, "damaged TIFF: rows of an odd size");
    std::vector<Sample> row(count);
    Image<Pixel> image(width, height);
    for (int y = 0; y < height; ++y) {
        if (TIFFReadScanline(tiff, row.data(), static_cast<std::uint32_t>(y), 0) < 0) {
            badImage(name, say("damaged TIFF: row {0} cannot be decoded", y));
        }
        for (int x = 0; x < width; ++x) {
            setPixel(image.at(x, y),
                     row.data() + static_cast<std::size_t>(x) * static_cast<std::size_t>(samples), samples);
        }
    }
    return image;
}

std::uint8_t unpremultiply(unsigned colour, unsigned alpha) {
    return alpha == 0 ? std::uint8_t{0}
                      : static_cast<std::uint8_t>(std::min(255U, (colour * 255U + alpha / 2) / alpha));
}

/// Palettes, YCbCr, tiles, separate planes, ...: libtiff makes 8-bit RGBA of them, premultiplied.
LdrImage readAnyKind(TIFF* tiff, int width, int height, const std::string& name) {
    char reason[1024] = "";
    if (TIFFRGBAImageOK(tiff, reason) == 0)
        badImage(name, say("TIFF of a kind that cannot be read: {0}", meaningOf(reason, kTiffTexts)));
    LdrImage image(width, height);
    std::vector<std::uint32_t> raster(image.pixels.size());
    if (TIFFReadRGBAImageOriented(tiff, static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height),
                                  raster.data(), ORIENTATION_TOPLEFT, 1) == 0) {
        badImage(name, "damaged TIFF: its pixels cannot be decoded");
    }
    for (std::size_t i = 0; i < raster.size(); ++i) {
        const std::uint32_t v = raster[i], a = TIFFGetA(v);
        image.pixels[i] = {unpremultiply(TIFFGetR(v), a), unpremultiply(TIFFGetG(v), a),
                           unpremultiply(TIFFGetB(v), a), static_cast<std::uint8_t>(a)};
    }
    return image;
}

void appendRow(std::vector<std::uint8_t>& row, const LdrImage& image, int y, bool alpha) {
    row.clear();
    for (int x = 0; x < image.width; ++x) {
        const Rgba8 p = image.at(x, y);
        row.insert(row.end(), {p.r, p.g, p.b});
        if (alpha) row.push_back(p.a);
    }
}

void setFields(TIFF* tiff, const LdrImage& image, bool alpha, double dpi) {
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(image.width));
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(image.height));
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, alpha ? 4 : 3);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_RGB);
    TIFFSetField(tiff, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_LZW);
    TIFFSetField(tiff, TIFFTAG_PREDICTOR, PREDICTOR_HORIZONTAL);
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, TIFFDefaultStripSize(tiff, 0));
    if (dpi > 0) {
        TIFFSetField(tiff, TIFFTAG_RESOLUTIONUNIT, RESUNIT_INCH);
        TIFFSetField(tiff, TIFFTAG_XRESOLUTION, dpi);
        TIFFSetField(tiff, TIFFTAG_YRESOLUTION, dpi);
    }
    const std::uint16_t kind = EXTRASAMPLE_UNASSALPHA;
    if (alpha) TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, 1, &kind);
}

} // namespace

DecodedImage decodeTiff(ByteSpan bytes, const std::string& name) {
    MemoryFile file;
    file.input = bytes;
    const Tiff tiff = openTiff(file, "rm");
    if (!tiff) badImage(name, "damaged TIFF: its directory cannot be read");
    const auto w = field<std::uint32_t>(tiff.get(), TIFFTAG_IMAGEWIDTH, 0);
    const auto h = field<std::uint32_t>(tiff.get(), TIFFTAG_IMAGELENGTH, 0);
    checkImageSize(name, w, h);
    const int width = static_cast<int>(w), height = static_cast<int>(h);
    const Layout layout = layoutOf(tiff.get());
    if (!isPlain(layout)) return readAnyKind(tiff.get(), width, height, name);
    if (layout.bits == 8)
        return readRows<std::uint8_t, Rgba8>(tiff.get(), layout.samples, width, height, name);
    if (layout.bits == 16)
        return readRows<std::uint16_t, Rgba16>(tiff.get(), layout.samples, width, height, name);
    return readRows<float, Colour>(tiff.get(), layout.samples, width, height, name);
}

Bytes encodeTiff(const LdrImage& image, double dpi, const std::string& name) {
    MemoryFile file;
    file.writing = true;
    Tiff tiff = openTiff(file, "wm");
    if (!tiff) cannotEncode(name, "libtiff cannot be started");
    const bool alpha = hasAlpha(image);
    setFields(tiff.get(), image, alpha, dpi);
    std::vector<std::uint8_t> row;
    for (int y = 0; y < image.height; ++y) {
        appendRow(row, image, y, alpha);
        if (TIFFWriteScanline(tiff.get(), row.data(), static_cast<std::uint32_t>(y), 0) < 0) {
            cannotEncode(name, say("libtiff cannot write row {0}", y));
        }
    }
    if (TIFFFlush(tiff.get()) == 0) cannotEncode(name, "libtiff cannot write the directory");
    tiff.reset();
    return std::move(file.output);
}

} // namespace rtcore

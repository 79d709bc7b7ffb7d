// The only file that sees CImg, and only its writers: they get pixels that we made. Its readers are not used:
// they start other programs for what they do not know (./convert from the current folder), write past a
// TIFF's pixels, leak on damaged PNG files, drop BMP palettes shorter than full. Its JPEG writer ends the
// process when the disk is full, and its TIFF writer does not notice that: both are in files of their own.
// All goes through FILE*, for which CImg never falls back to another program.
#define cimg_display 0
#define cimg_verbosity 0
#define cimg_no_system_calls
#define cimg_use_openmp 0
#define cimg_use_png
#include <CImg.h>

#include "rtcore/io/images/codecs.h"
#include "rtcore/settings/library_text.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

namespace rtcore {
namespace {

using Planes = cimg_library::CImg<unsigned char>;

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

Planes toPlanes(const LdrImage& image, bool alpha) {
    const auto w = static_cast<unsigned>(image.width), h = static_cast<unsigned>(image.height);
    Planes planes(w, h, 1, alpha ? 4 : 3);
    const std::size_t n = image.pixels.size();
    unsigned char* data = planes.data();
    for (std::size_t i = 0; i < n; ++i) {
        const Rgba8 p = image.pixels[i];
        data[i] = p.r;
        data[n + i] = p.g;
        data[2 * n + i] = p.b;
        if (alpha) data[3 * n + i] = p.a;
    }
    return planes;
}

Bytes contentOf(std::FILE* file, const std::string& name) {
    const long size = std::fflush(file) == 0 && std::ferror(file) == 0 ? std::ftell(file) : -1;
    if (size < 0) cannotEncode(name, say("the folder for temporary files: {0}", systemReason(errno)));
    Bytes bytes(static_cast<std::size_t>(size));
    std::rewind(file);
    if (std::fread(bytes.data(), 1, bytes.size(), file) != bytes.size()) {
        cannotEncode(name, "cannot read back from the folder for temporary files");
    }
    return bytes;
}

/// The bytes that `save` writes, by way of a temporary file without a name.
template <typename Save>
Bytes throughCImg(const LdrImage& image, bool alpha, const std::string& name, Save save) {
    const File file(std::tmpfile());
    if (!file) cannotEncode(name, say("no temporary file: {0}", systemReason(errno)));
    try {
        save(toPlanes(image, alpha), file.get());
    } catch (const cimg_library::CImgException& error) {
        cannotEncode(name, meaningOf(error.what(), {}));
    }
    return contentOf(file.get(), name);
}

} // namespace

Bytes encodePng(const LdrImage& image, const std::string& name) {
    return throughCImg(image, hasAlpha(image), name,
                       [](const Planes& planes, std::FILE* file) { planes.save_png(file, 1); });
}

Bytes encodeBmp(const LdrImage& image, const std::string& name) {
    return throughCImg(image, false, name,
                       [](const Planes& planes, std::FILE* file) { planes.save_bmp(file); });
}

Bytes encodePpm(const LdrImage& image, const std::string& name) {
    return throughCImg(image, false, name,
                       [](const Planes& planes, std::FILE* file) { planes.save_pnm(file, 1); });
}

} // namespace rtcore

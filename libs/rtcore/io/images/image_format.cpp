#include "rtcore/io/images/image_format.h"

#include "rtcore/io/images/codecs.h"

#include <algorithm>
#include <string_view>

namespace rtcore {
namespace {

using namespace std::string_view_literals;

using Texts = ImageCodec::Texts;

/// Adapts an encoder that keeps no notes.
template <Bytes (*kEncode)(const LdrImage&, const std::string&)>
Bytes plain(const LdrImage& image, const ImageNotes&, const FormatName&, const std::string& name) {
    return kEncode(image, name);
}
template <Bytes (*kEncode)(const HdrImage&, const std::string&)>
Bytes plainLinear(const HdrImage& image, Texts, const std::string& name) {
    return kEncode(image, name);
}
Bytes encodePngWithNotes(const LdrImage& image, const ImageNotes& notes, const FormatName&,
                         const std::string& name) {
    return withPngNotes(encodePng(image, name), image, notes);
}
Bytes encodeJpegFor(const LdrImage& image, const ImageNotes& notes, const FormatName&,
                    const std::string& name) {
    return encodeJpeg(image, notes.panorama, name);
}
Bytes encodeTiffFor(const LdrImage& image, const ImageNotes& notes, const FormatName&,
                    const std::string& name) {
    return encodeTiff(image, notes.dpi, name);
}
Bytes encodeRareAs(const LdrImage& image, const ImageNotes&, const FormatName& target,
                   const std::string& name) {
    return encodeRare(image, name, target.magickName);
}
Bytes encodeExrImage(const HdrImage& image, Texts texts, const std::string& name) {
    return encodeExr(image, texts, name);
}

constexpr ImageCodec kPng{decodePng, encodePngWithNotes};
constexpr ImageCodec kJpeg{decodeJpeg, encodeJpegFor};
constexpr ImageCodec kBmp{decodeBmp, plain<encodeBmp>};
constexpr ImageCodec kPnm{decodePnm, plain<encodePpm>};
constexpr ImageCodec kTga{decodeTga, plain<encodeTga>};
constexpr ImageCodec kTiff{decodeTiff, encodeTiffFor};
constexpr ImageCodec kRadiance{decodeRadiance, nullptr, plainLinear<encodeRadiance>};
constexpr ImageCodec kExr{decodeExr, nullptr, encodeExrImage,
                          [](const FormatName&) { return exrAvailable(); }};
constexpr ImageCodec kPfm{decodePfm, nullptr, plainLinear<encodePfm>};
constexpr ImageCodec kRare{decodeRare, encodeRareAs, nullptr,
                           [](const FormatName& target) { return rareWritable(target.magickName); }};

// ImageMagick 6 writes AVIF and HEIC, too, but with pixels that it never set.
constexpr FormatName kNames[] = {
    {"png", kPng, "", true},
    {"jpg", kJpeg},
    {"jpeg", kJpeg},
    {"bmp", kBmp},
    {"ppm", kPnm},
    {"tga", kTga, "", true},
    {"tif", kTiff, "", true},
    {"tiff", kTiff, "", true},
    {"exr", kExr, "", true},
    {"hdr", kRadiance},
    {"pfm", kPfm},
    {"webp", kRare, "WEBP", true},
    {"gif", kRare, "GIF"},
    {"jp2", kRare, "JP2"},
    {"psd", kRare, "PSD"},
    {"dds", kRare, "DDS"},
    {"pcx", kRare, "PCX"},
    {"sgi", kRare, "SGI"},
};

struct Signature {
    std::size_t offset;
    std::string_view mark;
    const ImageCodec& codec;
    const char* magickName = "";
};
constexpr Signature kSignatures[] = {
    {0, "\x89PNG\r\n\x1a\n"sv, kPng},
    {0, "\xff\xd8\xff"sv, kJpeg},
    {0, "II*\0"sv, kTiff},
    {0, "MM\0*"sv, kTiff},
    {0, "II+\0"sv, kTiff},
    {0, "MM\0+"sv, kTiff},
    {0, "#?"sv, kRadiance},
    {0, "\x76\x2f\x31\x01"sv, kExr},
    {8, "WEBP"sv, kRare, "WEBP"},
    {0, "GIF8"sv, kRare, "GIF"},
    {0, "DDS "sv, kRare, "DDS"},
    {0, "8BPS"sv, kRare, "PSD"},
    {4, "jP  \r\n"sv, kRare, "JP2"},
    {0, "\x01\xda"sv, kRare, "SGI"},
    {0, "BM"sv, kBmp},
};

unsigned byteAt(ByteSpan bytes, std::size_t i) { return std::to_integer<unsigned>(bytes[i]); }

bool matches(ByteSpan bytes, const Signature& s) {
    if (bytes.size() < s.offset + s.mark.size()) return false;
    for (std::size_t i = 0; i < s.mark.size(); ++i) {
        if (byteAt(bytes, s.offset + i) != static_cast<unsigned char>(s.mark[i])) return false;
    }
    return true;
}

const Signature* findSignature(ByteSpan bytes) {
    const auto* found = std::find_if(std::begin(kSignatures), std::end(kSignatures),
                                     [&](const Signature& s) { return matches(bytes, s); });
    return found == std::end(kSignatures) ? nullptr : found;
}

bool isBlank(unsigned c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '#'; }

bool looksLikeTga(ByteSpan bytes) {
    if (bytes.size() < 18) return false;
    const unsigned mapType = byteAt(bytes, 1), type = byteAt(bytes, 2), depth = byteAt(bytes, 16);
    const unsigned width = byteAt(bytes, 12) | byteAt(bytes, 13) << 8U;
    const unsigned height = byteAt(bytes, 14) | byteAt(bytes, 15) << 8U;
    const unsigned kind = type & 7U;
    const bool depthFits =
        depth == 8 || ((depth == 15 || depth == 16 || depth == 24 || depth == 32) && kind == 2);
    return mapType <= 1 && kind >= 1 && kind <= 3 && (type & ~11U) == 0 && depthFits && width > 0 &&
           height > 0;
}

} // namespace

const ImageCodec* sniffCodec(ByteSpan bytes) {
    if (const Signature* signature = findSignature(bytes)) return &signature->codec;
    if (bytes.size() > 2 && byteAt(bytes, 0) == 'P' && isBlank(byteAt(bytes, 2))) {
        const unsigned kind = byteAt(bytes, 1);
        if (kind >= '1' && kind <= '6') return &kPnm;
        if (kind == 'F' || kind == 'f') return &kPfm;
    }
    return looksLikeTga(bytes) ? &kTga : nullptr;
}

std::string sniffRareFormat(ByteSpan bytes) {
    const Signature* signature = findSignature(bytes);
    return signature != nullptr ? signature->magickName : "";
}

std::span<const FormatName> formatNames() { return kNames; }

const FormatName* findFormat(const std::string& extension) {
    std::string lower = extension;
    for (char& c : lower) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    const auto* found = std::find_if(std::begin(kNames), std::end(kNames),
                                     [&](const FormatName& n) { return lower == n.extension; });
    return found == std::end(kNames) ? nullptr : found;
}

std::string extensionOf(const std::filesystem::path& path) {
    const std::string extension = path.extension().string();
    return extension.empty() ? extension : extension.substr(1);
}

} // namespace rtcore

// Notes in PNG files, which CImg's writer does not know (ISO/IEC 15948, 11.3.4 and 11.3.5.3).
#include "rtcore/io/images/byte_reader.h"
#include "rtcore/io/images/codecs.h"
#include "rtcore/io/images/panorama_xmp.h"

#include <zlib.h>

#include <cmath>
#include <cstdint>

namespace rtcore {
namespace {

void appendBigEndian(Bytes& bytes, std::uint32_t number) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::byte>(number >> shift));
}

/// `content` begins with the four letters of its kind.
void appendChunk(Bytes& bytes, const Bytes& content) {
    constexpr std::size_t kKind = 4;
    appendBigEndian(bytes, static_cast<std::uint32_t>(content.size() - kKind));
    bytes.insert(bytes.end(), content.begin(), content.end());
    const auto* const first = reinterpret_cast<const Bytef*>(content.data());
    appendBigEndian(bytes, static_cast<std::uint32_t>(crc32(0, first, static_cast<uInt>(content.size()))));
}

Bytes textChunk(const ImageText& text) {
    Bytes content;
    append(content, "tEXt" + text.name + '\0' + text.text);
    return content;
}

/// Text that is not compressed, of no language.
Bytes xmpChunk(const std::string& packet) {
    Bytes content;
    append(content, std::string("iTXtXML:com.adobe.xmp") + std::string(5, '\0') + packet);
    return content;
}

Bytes sizeChunk(double dpi) {
    constexpr double kInchesOfMetre = 1 / 0.0254;
    const auto pixelsOfMetre = static_cast<std::uint32_t>(std::lround(dpi * kInchesOfMetre));
    Bytes content;
    append(content, "pHYs");
    appendBigEndian(content, pixelsOfMetre);
    appendBigEndian(content, pixelsOfMetre);
    append8(content, 1); // the unit is a metre
    return content;
}

} // namespace

Bytes withPngNotes(Bytes png, const LdrImage& image, const ImageNotes& notes) {
    constexpr std::ptrdiff_t kHead = 8 + 25; // the signature and IHDR
    Bytes chunks;
    if (notes.dpi > 0) appendChunk(chunks, sizeChunk(notes.dpi));
    for (const ImageText& text : notes.texts) appendChunk(chunks, textChunk(text));
    if (notes.panorama) appendChunk(chunks, xmpChunk(panoramaXmp(image.width, image.height)));
    png.insert(png.begin() + kHead, chunks.begin(), chunks.end());
    return png;
}

} // namespace rtcore

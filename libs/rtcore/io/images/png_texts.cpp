// Texts of PNG files, which CImg's writer does not know (ISO/IEC 15948, 11.3.4.3).
#include "rtcore/io/images/byte_reader.h"
#include "rtcore/io/images/codecs.h"

#include <zlib.h>

#include <algorithm>
#include <cstdint>

namespace rtcore {
namespace {

void appendBigEndian(Bytes& bytes, std::uint32_t number) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::byte>(number >> shift));
}

void appendChunk(Bytes& bytes, const ImageText& text) {
    const std::string content = text.name + '\0' + text.text;
    appendBigEndian(bytes, static_cast<std::uint32_t>(content.size()));
    const std::size_t checked = bytes.size();
    append(bytes, "tEXt" + content);
    const auto* const first = reinterpret_cast<const Bytef*>(bytes.data() + checked);
    appendBigEndian(bytes,
                    static_cast<std::uint32_t>(crc32(0, first, static_cast<uInt>(bytes.size() - checked))));
}

} // namespace

Bytes withPngTexts(Bytes png, std::span<const ImageText> texts) {
    constexpr std::ptrdiff_t kHead = 8 + 25; // the signature and IHDR
    Bytes chunks;
    for (const ImageText& text : texts) appendChunk(chunks, text);
    png.insert(png.begin() + kHead, chunks.begin(), chunks.end());
    return png;
}

} // namespace rtcore

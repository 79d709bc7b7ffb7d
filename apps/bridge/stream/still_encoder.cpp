#include "bridge/stream/still_encoder.h"

#include <libdeflate.h>

#include <new>
#include <stdexcept>
#include <string_view>

namespace bridge {

namespace {

// Level 1 is 10 % larger than 3 and twice as fast; the filter `up` is the fastest one that helps.
constexpr int kLevel = 1;
constexpr unsigned char kUp = 2, kNone = 0;

using PngBytes = std::vector<std::uint8_t>;

void addNumber(PngBytes& out, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<std::uint8_t>(value >> shift));
}

void addChunk(PngBytes& out, std::string_view type, std::span<const unsigned char> content) {
    addNumber(out, static_cast<std::uint32_t>(content.size()));
    const std::size_t start = out.size();
    out.insert(out.end(), type.begin(), type.end());
    out.insert(out.end(), content.begin(), content.end());
    addNumber(out, libdeflate_crc32(0, out.data() + start, out.size() - start));
}

PngBytes headerOf(const Pixels& pixels) {
    PngBytes header;
    addNumber(header, static_cast<std::uint32_t>(pixels.width));
    addNumber(header, static_cast<std::uint32_t>(pixels.height));
    header.insert(header.end(), {8, 2, 0, 0, 0}); // 8 bits, RGB
    return header;
}

/// Each row less the one above it; the first one as it is.
void filterRows(const Pixels& pixels, std::vector<unsigned char>& out) {
    const auto width = static_cast<std::size_t>(pixels.width),
               height = static_cast<std::size_t>(pixels.height);
    out.resize((3 * width + 1) * height);
    const auto* in = reinterpret_cast<const unsigned char*>(pixels.bytes.data());
    unsigned char* to = out.data();
    for (std::size_t y = 0; y < height; ++y) {
        const unsigned char* const above = in - 4 * width;
        *to++ = y == 0 ? kNone : kUp;
        for (std::size_t x = 0; x < width; ++x, to += 3)
            for (std::size_t c = 0; c < 3; ++c) {
                const std::size_t at = 4 * x + c;
                to[c] = y == 0 ? in[at] : static_cast<unsigned char>(in[at] - above[at]);
            }
        in += 4 * width;
    }
}

} // namespace

StillEncoder::StillEncoder() : library_(libdeflate_alloc_compressor(kLevel)) {
    if (library_ == nullptr) throw std::bad_alloc();
}

StillEncoder::~StillEncoder() { libdeflate_free_compressor(library_); }

SharedFrame StillEncoder::encode(const Pixels& pixels, FrameFacts facts) {
    filterRows(pixels, filtered_);
    compressed_.resize(libdeflate_zlib_compress_bound(library_, filtered_.size()));
    const std::size_t size = libdeflate_zlib_compress(library_, filtered_.data(), filtered_.size(),
                                                      compressed_.data(), compressed_.size());
    if (size == 0) throw std::runtime_error("the frame cannot be compressed");
    auto frame = std::make_shared<EncodedFrame>();
    frame->facts = facts;
    frame->facts.width = static_cast<std::uint16_t>(pixels.width);
    frame->facts.height = static_cast<std::uint16_t>(pixels.height);
    frame->codec = Codec::Png;
    frame->exact = true;
    constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
    frame->bytes.reserve(size + 64);
    frame->bytes.assign(kSignature.begin(), kSignature.end());
    addChunk(frame->bytes, "IHDR", headerOf(pixels));
    addChunk(frame->bytes, "IDAT", std::span(compressed_).first(size));
    addChunk(frame->bytes, "IEND", {});
    return frame;
}

} // namespace bridge

#include "bridge/stream/motion_encoder.h"

#include "bridge/stream/jpeg_strips.h"
#include "bridge/stream/shrink.h"

#include <turbojpeg.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace bridge {

namespace {

constexpr int kFineQuality = 90;

} // namespace

MotionEncoder::MotionEncoder() : library_(tjInitCompress()) {
    if (library_ == nullptr)
        throw std::runtime_error(std::string("no JPEG encoder: ") + tjGetErrorStr2(nullptr));
}

MotionEncoder::~MotionEncoder() { tjDestroy(library_); }

SharedFrame MotionEncoder::encode(const Pixels& pixels, const Rung& rung, FrameFacts facts) {
    const auto side = [&](int shown, int is) {
        return std::clamp(std::max(shown, is) / std::max(1, rung.divide), 1, is);
    };
    const int width = side(facts.shownWidth, pixels.width), height = side(facts.shownHeight, pixels.height);
    const bool fits = width == pixels.width && height == pixels.height;
    return compress(fits ? pixels : shrink(pixels, width, height, small_), rung.quality, TJSAMP_420, facts);
}

SharedFrame MotionEncoder::encodeFine(const Pixels& pixels, FrameFacts facts) {
    return compress(pixels, kFineQuality, TJSAMP_444, facts);
}

SharedFrame MotionEncoder::compress(const Pixels& pixels, int quality, int subsampling, FrameFacts facts) {
    const int rows = stripHeight(pixels.width);
    const std::size_t room = tjBufSize(pixels.width, std::min(rows, pixels.height), subsampling);
    const auto count = static_cast<std::size_t>((pixels.height + rows - 1) / rows);
    buffer_.resize(std::max(buffer_.size(), count * room));
    strips_.clear();
    for (int top = 0; top < pixels.height; top += rows) {
        const std::size_t before = 4 * static_cast<std::size_t>(pixels.width) * static_cast<std::size_t>(top);
        const auto* const source = reinterpret_cast<const unsigned char*>(pixels.bytes.data()) + before;
        unsigned char* out = buffer_.data() + strips_.size() * room;
        unsigned long size = room;
        if (tjCompress2(library_, source, pixels.width, 0, std::min(rows, pixels.height - top), TJPF_RGBX,
                        &out, &size, subsampling, quality, TJFLAG_NOREALLOC) != 0)
            throw std::runtime_error(std::string("the JPEG encoder: ") + tjGetErrorStr2(library_));
        strips_.emplace_back(out, size);
    }
    auto frame = std::make_shared<EncodedFrame>();
    frame->facts = facts;
    frame->facts.width = static_cast<std::uint16_t>(pixels.width);
    frame->facts.height = static_cast<std::uint16_t>(pixels.height);
    frame->bytes = joinStrips(strips_, pixels.height);
    return frame;
}

} // namespace bridge

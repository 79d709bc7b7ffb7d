#include "bridge/stream/motion_encoder.h"

#include "bridge/stream/jpeg_strips.h"

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
    const int shown = std::max<int>(facts.shownWidth, pixels.width);
    const int divide = std::max(1, rung.divide * pixels.width / shown);
    const Pixels input = divide == 1 ? pixels : shrink(pixels, divide, small_);
    return compress(input, rung.quality, TJSAMP_420, facts);
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

Pixels shrink(const Pixels& pixels, int divide, std::vector<std::byte>& out) {
    const int width = std::max(1, pixels.width / divide), height = std::max(1, pixels.height / divide);
    const int across = std::min(divide, pixels.width), down = std::min(divide, pixels.height);
    const auto count = static_cast<unsigned>(across * down);
    const auto* const in = reinterpret_cast<const unsigned char*>(pixels.bytes.data());
    const std::size_t row = 4 * static_cast<std::size_t>(pixels.width);
    out.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    auto* to = reinterpret_cast<unsigned char*>(out.data());
    for (int y = 0; y < height; ++y) {
        const unsigned char* const line = in + row * static_cast<std::size_t>(y * divide);
        for (int x = 0; x < width; ++x, to += 4) {
            unsigned sums[3] = {count / 2, count / 2, count / 2};
            for (int j = 0; j < down; ++j) {
                const unsigned char* from =
                    line + row * static_cast<std::size_t>(j) + 4 * static_cast<std::size_t>(x * divide);
                for (int i = 0; i < across; ++i, from += 4)
                    for (int c = 0; c < 3; ++c) sums[c] += from[c];
            }
            for (int c = 0; c < 3; ++c) to[c] = static_cast<unsigned char>(sums[c] / count);
            to[3] = 255;
        }
    }
    return {out, width, height};
}

} // namespace bridge

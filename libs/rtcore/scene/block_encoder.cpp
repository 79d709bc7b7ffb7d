#include "rtcore/scene/block_encoder.h"

#include <bit>
#include <cstddef>
#include <limits>

namespace rtcore {

namespace {

using Texels = std::array<Rgba8, kBlockTexels>;

/// One channel of the texels, and what it spans.
struct BlockChannel {
    std::array<int, kBlockTexels> values{};
    int base = 0, range = 0;

    void measure() {
        int greatest = base = values[0];
        for (const int value : values) {
            base = std::min(base, value);
            greatest = std::max(greatest, value);
        }
        range = greatest - base;
    }
};
using BlockChannels = std::array<BlockChannel, 3>;

constexpr int kSideOfBlock = static_cast<int>(kBlockSide);
constexpr std::uint32_t kWidestStep = 63, kNoStep = 64;

constexpr int maxIndex(unsigned bits) { return (1 << bits) - 1; }
constexpr int ceilDivided(int a, int b) { return (a + b - 1) / b; }

/// The bits of the smallest step by which indices of so many bits reach across the range, or kNoStep.
std::uint32_t stepFor(int range, unsigned bits) {
    const auto needed = static_cast<unsigned>(std::max(8, ceilDivided(8 * range - 4, maxIndex(bits))));
    const auto exponent = static_cast<unsigned>(std::bit_width(needed)) - 4;
    const unsigned mantissa = (needed + (1U << exponent) - 1) >> exponent; // 8 to 16
    return std::min(kNoStep, 8 * exponent + mantissa - 8);
}

float indicesPerCode(int step) { return 8.0F / static_cast<float>(step); }

std::uint32_t indexOf(int offset, float indicesPerCode, int max) {
    const auto nearest = static_cast<int>(static_cast<float>(offset) * indicesPerCode + 0.5F);
    return static_cast<std::uint32_t>(std::min(nearest, max));
}

/// The mean squared error of a value by the step's bits.
const std::array<double, kNoStep + 1> kExpectedError = [] {
    std::array<double, kNoStep + 1> errors{};
    constexpr int kValues = 1920;
    for (std::uint32_t bits = 0; bits <= kWidestStep; ++bits) {
        const int step = blockStep(bits);
        for (int offset = 0; offset < kValues; ++offset) {
            const int error = offset - blockOffset(indexOf(offset, indicesPerCode(step), kValues), step);
            errors[bits] += static_cast<double>(error * error) / kValues;
        }
    }
    errors[kNoStep] = 1e6; // there are others
    return errors;
}();

/// By how much an error of a channel counts in the sum over red, green and blue.
constexpr std::array<double, 3> kWeightsOfYCoCg{3, 0.5, 0.75}, kWeightsOfRgb{1, 1, 1};

struct Encoding {
    std::uint32_t mode = 0;
    std::array<std::uint32_t, 3> steps{};
    double error = std::numeric_limits<double>::max(); ///< expected
};

Encoding encodingBy(std::uint32_t mode, const BlockChannels& channels) {
    Encoding encoding{mode, {}, 0};
    const auto& weights = kBlockModes[mode].lumaChroma ? kWeightsOfYCoCg : kWeightsOfRgb;
    for (std::size_t c = 0; c < 3; ++c) {
        encoding.steps[c] = stepFor(channels[c].range, kBlockModes[mode].bits[c]);
        encoding.error += weights[c] * kExpectedError[encoding.steps[c]];
    }
    return encoding;
}

BlockChannels yCoCgOf(const Texels& texels) {
    BlockChannels channels;
    for (std::size_t i = 0; i < kBlockTexels; ++i) {
        const Rgba8 p = texels[i];
        const int co = p.r - p.b, rest = p.b + (co >> 1), cg = p.g - rest;
        channels[0].values[i] = rest + (cg >> 1);
        channels[1].values[i] = co + kChromaZero;
        channels[2].values[i] = cg + kChromaZero;
    }
    for (BlockChannel& channel : channels) channel.measure();
    return channels;
}

BlockChannels rgbOf(const Texels& texels) {
    BlockChannels channels;
    for (std::size_t i = 0; i < kBlockTexels; ++i) {
        channels[0].values[i] = texels[i].r;
        channels[1].values[i] = texels[i].g;
        channels[2].values[i] = texels[i].b;
    }
    for (BlockChannel& channel : channels) channel.measure();
    return channels;
}

/// The 13 bits of each texel.
std::array<std::uint32_t, kBlockTexels> fieldsOf(const Encoding& encoding, const BlockChannels& channels) {
    std::array<std::uint32_t, kBlockTexels> fields{};
    unsigned from = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const unsigned bits = kBlockModes[encoding.mode].bits[c];
        const float scale = indicesPerCode(blockStep(encoding.steps[c]));
        const int max = maxIndex(bits), base = channels[c].base;
        for (std::size_t i = 0; i < kBlockTexels; ++i)
            fields[i] |= indexOf(channels[c].values[i] - base, scale, max) << from;
        from += bits;
    }
    return fields;
}

std::uint64_t headOf(const Encoding& encoding, const BlockChannels& channels) {
    const auto base = [&](std::size_t c) { return static_cast<std::uint64_t>(channels[c].base); };
    std::uint64_t head = encoding.mode | base(0) << 4U | base(1) << 12U | base(2) << 21U;
    for (std::size_t c = 0; c < 3; ++c) head |= std::uint64_t{encoding.steps[c]} << (30 + 6 * c);
    return head;
}

TexelBlock packed(const Encoding& encoding, const BlockChannels& channels) {
    TexelBlock block;
    const std::uint64_t head = headOf(encoding, channels);
    const auto fields = fieldsOf(encoding, channels);
    for (std::size_t y = 0; y < kBlockSide; ++y) {
        std::uint64_t row = (head >> (kHeadBitsOfRow * y) & 0xFFFU) << (64 - kHeadBitsOfRow);
        for (std::size_t x = 0; x < kBlockSide; ++x)
            row |= std::uint64_t{fields[kBlockSide * y + x]} << (kTexelBits * x);
        block.rows[y] = row;
    }
    return block;
}

Texels texelsOf(const LdrImage& image, int left, int top) {
    Texels texels;
    Rgba8* to = texels.data();
    for (int y = top; y < top + kSideOfBlock; ++y)
        for (int x = left; x < left + kSideOfBlock; ++x)
            *to++ = image.at(std::min(x, image.width - 1), std::min(y, image.height - 1));
    return texels;
}

/// All steps are one code.
bool isExact(const TexelBlock& block) { return (block.rows[2] >> 58U | block.rows[3] >> 52U) == 0; }

std::uint64_t squaredError(const Texels& texels, const TexelBlock& block) {
    if (isExact(block)) return 0;
    int sum = 0;
    const auto square = [](int a, int b) { return (a - b) * (a - b); };
    for (std::uint32_t i = 0; i < kBlockTexels; ++i) {
        const Rgba8 is = texelOf(block, i), wanted = texels[i];
        sum += square(is.r, wanted.r) + square(is.g, wanted.g) + square(is.b, wanted.b);
    }
    return static_cast<std::uint64_t>(sum);
}

} // namespace

TexelBlock encodeBlock(const Texels& texels) {
    const BlockChannels yCoCg = yCoCgOf(texels), rgb = rgbOf(texels);
    Encoding best;
    for (std::uint32_t mode = 0; mode < kBlockModes.size() && best.error > 0; ++mode) {
        const Encoding encoding = encodingBy(mode, kBlockModes[mode].lumaChroma ? yCoCg : rgb);
        if (encoding.error < best.error) best = encoding;
    }
    return packed(best, kBlockModes[best.mode].lumaChroma ? yCoCg : rgb);
}

double appendBlocks(const LdrImage& image, std::vector<TexelBlock>& to) {
    const auto columns = static_cast<int>(blocksOf(static_cast<std::uint32_t>(image.width)));
    const auto rows = static_cast<int>(blocksOf(static_cast<std::uint32_t>(image.height)));
    const std::size_t first = to.size();
    const std::size_t count = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    to.resize(first + count);
    std::uint64_t error = 0;
#pragma omp parallel for schedule(static) reduction(+ : error)
    for (int y = 0; y < rows; ++y) {
        TexelBlock* block = &to[first + static_cast<std::size_t>(y) * static_cast<std::size_t>(columns)];
        for (int x = 0; x < columns; ++x, ++block) {
            const Texels texels = texelsOf(image, x * kSideOfBlock, y * kSideOfBlock);
            *block = encodeBlock(texels);
            error += squaredError(texels, *block);
        }
    }
    return static_cast<double>(error) / static_cast<double>(count * kBlockTexels * 3);
}

} // namespace rtcore

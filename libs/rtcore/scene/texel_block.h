/// Opaque images in half the memory: 4 x 4 texels in 32 bytes, exact where their range is narrow.
///
/// Row y of a block is one number of 64 bits: 13 bits for each texel from the left, the lowest first, and 12
/// bits of the block's head above them. The head, 48 bits, the lowest from row 0: the mode (4 bits), the
/// bases of three channels (8, 9 and 9 bits), their steps (6 bits each). A channel's value is its base plus
/// the texel's index times the step, where a step of bits eeemmm is (8 + m) 2^e eighths: an index more is a
/// code more where e = m = 0, which is exact. The mode says how many of the 13 bits are whose index, and what
/// the channels are: red, green and blue, or those of YCoCg-R, whose transform is exact, too. Source: Malvar
/// and Sullivan, YCoCg-R: a color space with RGB reversibility and low dynamic range, JVT-I014r3, 2003.
#pragma once

#include "rtcore/scene/image.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace rtcore {

inline constexpr std::uint32_t kBlockSide = 4, kBlockTexels = kBlockSide * kBlockSide;

struct TexelBlock {
    std::array<std::uint64_t, kBlockSide> rows{}; ///< from the top; every value means texels
    friend bool operator==(const TexelBlock&, const TexelBlock&) = default;
};
static_assert(sizeof(TexelBlock) == 32 && std::is_trivially_copyable_v<TexelBlock>);

/// How the 13 bits of a texel are divided.
struct BlockMode {
    std::array<std::uint8_t, 3> bits; ///< of each channel's index; the first channel's are the lowest
    bool lumaChroma = false;          ///< Y, Co, Cg (chroma plus kChromaZero), else red, green, blue
};

inline constexpr unsigned kTexelBits = 13, kHeadBitsOfRow = 12;
inline constexpr int kChromaZero = 256;

/// Those that served 31 images best, photographs, drawings, noise, normals and masks, the best first.
inline constexpr std::array<BlockMode, 16> kBlockModes{{{{6, 4, 3}, true},
                                                        {{5, 4, 4}, false},
                                                        {{7, 4, 2}, true},
                                                        {{5, 4, 4}, true},
                                                        {{5, 5, 3}, true},
                                                        {{5, 5, 3}, false},
                                                        {{7, 3, 3}, true},
                                                        {{6, 3, 4}, true},
                                                        {{6, 1, 6}, true},
                                                        {{6, 6, 1}, true},
                                                        {{6, 6, 1}, false},
                                                        {{4, 5, 4}, false},
                                                        {{6, 5, 2}, true},
                                                        {{4, 6, 3}, true},
                                                        {{4, 4, 5}, false},
                                                        {{6, 4, 3}, false}}};

/// How many blocks `texels` of a row or of a column take.
constexpr std::uint32_t blocksOf(std::uint32_t texels) { return (texels + kBlockSide - 1) / kBlockSide; }

/// A step in eighths of a code, 8 to 1920, by its 6 bits.
constexpr int blockStep(std::uint32_t bits) { return static_cast<int>((8 + (bits & 7U)) << (bits >> 3U)); }

/// By how much the value at `index` exceeds the base.
constexpr int blockOffset(std::uint32_t index, int step) { return (static_cast<int>(index) * step + 4) >> 3; }

/// What says all of a texel.
struct PackedTexel {
    std::uint32_t low, high; ///< 24 bits each of the head
    std::uint32_t indices;   ///< 13 bits, and others above them
};

/// The texel number 4 y + x of a block, 0 to 15.
inline PackedTexel packedTexel(const TexelBlock& block, std::uint32_t number) {
    const auto head = [&](std::size_t row) {
        return static_cast<std::uint32_t>(block.rows[row] >> (64 - kHeadBitsOfRow));
    };
    return {
        head(0) | head(1) << kHeadBitsOfRow, head(2) | head(3) << kHeadBitsOfRow,
        static_cast<std::uint32_t>(block.rows[number / kBlockSide] >> (kTexelBits * (number % kBlockSide)))};
}

/// The same, decoded: opaque. Any bytes give some colour.
inline Rgba8 texelOf(const TexelBlock& block, std::uint32_t number) {
    const PackedTexel packed = packedTexel(block, number);
    const BlockMode& mode = kBlockModes[packed.low & 15U];
    std::uint32_t indices = packed.indices;
    const auto value = [&](std::size_t channel, std::uint32_t base, std::uint32_t step) {
        const std::uint32_t index = indices & ((1U << mode.bits[channel]) - 1);
        indices >>= mode.bits[channel];
        return static_cast<int>(base) + blockOffset(index, blockStep(step & 63U));
    };
    const int a = value(0, packed.low >> 4U & 0xFFU, packed.high >> 6U);
    const int b = value(1, packed.low >> 12U & 0x1FFU, packed.high >> 12U);
    const int c = value(2, packed.low >> 21U | (packed.high & 63U) << 3U, packed.high >> 18U);
    const int co = b - kChromaZero, cg = c - kChromaZero;
    const int rest = a - (cg >> 1), blue = rest - (co >> 1);
    const bool luma = mode.lumaChroma;
    const auto code = [](int of) { return static_cast<std::uint8_t>(std::clamp(of, 0, 255)); };
    return {code(luma ? blue + co : a), code(luma ? rest + cg : b), code(luma ? blue : c), 255};
}

/// The texel of that number, counted through all blocks.
inline Rgba8 texelIn(const TexelBlock* blocks, std::uint32_t number) {
    return texelOf(blocks[number / kBlockTexels], number % kBlockTexels);
}

} // namespace rtcore

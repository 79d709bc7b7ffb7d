#include "rtcore/io/bsp/crc_folding.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/io/bsp/crc_folding.cpp"
#include "rtcore/simd/foreach_target.h"

#include <hwy/highway.h>
#include <zlib.h>

#include <array>

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

// Elsewhere Highway multiplies bit by bit, and tables are faster.
#if HWY_ARCH_X86 && HWY_TARGET <= HWY_SSE4 && !defined(HWY_DISABLE_PCLMUL_AES)

namespace hn = hwy::HWY_NAMESPACE;

using Block = hn::Full128<std::uint64_t>;
using Lanes = hn::Vec<Block>;

HWY_INLINE Lanes blockAt(const std::byte* at) {
    return hn::BitCast(Block(),
                       hn::LoadU(hn::Full128<std::uint8_t>(), reinterpret_cast<const std::uint8_t*>(at)));
}

/// `value`, moved as many bits on as the factors stand for, and what is there.
HWY_INLINE Lanes folded(Lanes value, Lanes factors, Lanes there) {
    return hn::Xor(hn::Xor(hn::CLMulLower(value, factors), hn::CLMulUpper(value, factors)), there);
}

std::uint32_t foldedCrc(const std::byte* at, std::size_t size, std::uint32_t before) {
    constexpr std::size_t kBlock = 16, kStep = 4 * kBlock;
    // x to the power of 512 + 32, 512 - 32, 128 + 32 and 128 - 32, modulo the polynomial, bits reversed.
    alignas(16) constexpr std::uint64_t kBy64[] = {0x154442BD4, 0x1C6E41596},
                                        kBy16[] = {0x1751997D0, 0x0CCAA009E};
    alignas(16) const std::uint64_t first[] = {static_cast<std::uint32_t>(~before), 0};
    const Block block;
    Lanes by = hn::Load(block, kBy64);
    Lanes a = hn::Xor(blockAt(at), hn::Load(block, first)), b = blockAt(at + kBlock),
          c = blockAt(at + 2 * kBlock), d = blockAt(at + 3 * kBlock);
    for (const std::byte* const end = at + size; (at += kStep) != end;) {
        a = folded(a, by, blockAt(at));
        b = folded(b, by, blockAt(at + kBlock));
        c = folded(c, by, blockAt(at + 2 * kBlock));
        d = folded(d, by, blockAt(at + 3 * kBlock));
    }
    by = hn::Load(block, kBy16);
    alignas(16) std::array<std::uint8_t, kBlock> rest;
    const Lanes all = folded(folded(folded(a, by, b), by, c), by, d);
    hn::Store(hn::BitCast(hn::Full128<std::uint8_t>(), all), hn::Full128<std::uint8_t>(), rest.data());
    return static_cast<std::uint32_t>(::crc32_z(0xFFFFFFFFU, rest.data(), rest.size()));
}

#else

std::uint32_t foldedCrc(const std::byte* at, std::size_t size, std::uint32_t before) {
    return static_cast<std::uint32_t>(::crc32_z(before, reinterpret_cast<const Bytef*>(at), size));
}

#endif

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(foldedCrc);

std::uint32_t foldedCrc(std::span<const std::byte> bytes, std::uint32_t before) {
    return HWY_DYNAMIC_DISPATCH(foldedCrc)(bytes.data(), bytes.size(), before);
}

} // namespace rtcore
#endif

#include "rtcore/sampling/lens_pattern.h"

#include "rtcore/sampling/pixel_pattern.h"

namespace rtcore {

std::uint32_t permuted(std::uint32_t i, std::uint32_t count, std::uint32_t key) {
    if (count == 1) return 0;
    std::uint32_t mask = count - 1;
    for (const unsigned shift : {1U, 2U, 4U, 8U, 16U}) mask |= mask >> shift;
    // Each step has an inverse among the numbers up to the mask; those from `count` on are sent on.
    do {
        i ^= key;
        i *= 0xE170893DU;
        i ^= key >> 16;
        i ^= (i & mask) >> 4;
        i ^= key >> 8;
        i *= 0x0929EB3FU;
        i ^= key >> 23;
        i ^= (i & mask) >> 1;
        i *= 1 | key >> 27;
        i *= 0x6935FA69U;
        i ^= (i & mask) >> 11;
        i *= 0x74DCB303U;
        i ^= (i & mask) >> 2;
        i *= 0x9E501CC3U;
        i ^= (i & mask) >> 2;
        i *= 0xC860A3DFU;
        i &= mask;
        i ^= i >> 5;
    } while (i >= count);
    const auto turned = i + static_cast<std::uint32_t>(static_cast<std::uint64_t>(key) * count >> 32);
    return turned < count ? turned : turned - count;
}

void LensPattern::prepare(int n) {
    const auto count = static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
    if (points_.size() == count) return;
    points_.clear();
    for (int row = 0; row < n; ++row) {
        for (int column = 0; column < n; ++column) points_.push_back(rotatedGridPoint(column, row, n));
    }
}

LensPattern::Pixel LensPattern::pixel(std::uint16_t x, std::uint16_t y) {
    return {mixBits(mixBits(x | static_cast<std::uint32_t>(y) << 16) ^ 0x4C454E53U),
            randomShift({x, y, 0}, SampleDimension::Lens)};
}

SquarePoint LensPattern::at(const Pixel& pixel, std::uint32_t sub) const {
    const SquarePoint point = points_[permuted(sub, static_cast<std::uint32_t>(points_.size()), pixel.key)];
    return {wrapped(point.u, pixel.shift.u), wrapped(point.v, pixel.shift.v)};
}

} // namespace rtcore

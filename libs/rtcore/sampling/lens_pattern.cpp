#include "rtcore/sampling/lens_pattern.h"

#include "rtcore/sampling/pixel_pattern.h"

namespace rtcore {

std::uint32_t permuted(std::uint32_t i, std::uint32_t count, std::uint32_t key) {
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
    return (i + key % count) % count;
}

void LensPattern::prepare(int n) {
    const auto count = static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
    if (points_.size() == count) return;
    points_.clear();
    for (int row = 0; row < n; ++row) {
        for (int column = 0; column < n; ++column) points_.push_back(rotatedGridPoint(column, row, n));
    }
}

SquarePoint LensPattern::at(SampleId id) const {
    const std::uint32_t key = mixBits(mixBits(id.x | static_cast<std::uint32_t>(id.y) << 16) ^ 0x4C454E53U);
    const SquarePoint point = points_[permuted(id.sub, static_cast<std::uint32_t>(points_.size()), key)];
    const SquarePoint shift = randomShift({id.x, id.y, 0}, Draw::Lens);
    return {wrapped(point.u, shift.u), wrapped(point.v, shift.v)};
}

} // namespace rtcore

#include "rtcore/gathering/curve_order.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace rtcore {

namespace {

constexpr std::uint32_t kAxisBits = 10;

/// Two zeros before each of the bits.
std::uint32_t spreadBits(std::uint32_t x) {
    x = (x | x << 16) & 0x030000FFU;
    x = (x | x << 8) & 0x0300F00FU;
    x = (x | x << 4) & 0x030C30C3U;
    return (x | x << 2) & 0x09249249U;
}

} // namespace

std::uint32_t alongCurve(Vec3 point, const Box3& bounds) {
    constexpr float kCells = 1U << kAxisBits;
    const Vec3 size = bounds.size();
    std::uint32_t code = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const float at = size[axis] > 0 ? (point[axis] - bounds.lo[axis]) / size[axis] : 0;
        const auto cell = static_cast<std::uint32_t>(at > 0 ? std::min(at, 0.9995F) * kCells : 0);
        code |= spreadBits(cell) << axis;
    }
    return code;
}

/// (Sorted by the digits of their codes, the last one first.)
std::span<const std::uint32_t> CurveOrder::of(std::span<const Receiver> receivers, const Box3& bounds) {
    constexpr std::uint32_t kDigits = 1U << kAxisBits;
    entries_.resize(receivers.size());
    sorted_.resize(receivers.size());
    for (std::uint32_t i = 0; i < receivers.size(); ++i)
        entries_[i] = {alongCurve(receivers[i].position, bounds), i};
    for (std::uint32_t shift = 0; shift < 3 * kAxisBits; shift += kAxisBits) {
        const auto digitOf = [&](const Entry& entry) { return entry.code >> shift & (kDigits - 1); };
        std::array<std::uint32_t, kDigits + 1> first{};
        for (const Entry& entry : entries_) ++first[digitOf(entry) + 1];
        for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
        for (const Entry& entry : entries_) sorted_[first[digitOf(entry)]++] = entry;
        entries_.swap(sorted_);
    }
    order_.resize(receivers.size());
    std::ranges::transform(entries_, order_.begin(), &Entry::number);
    return order_;
}

} // namespace rtcore

/// The media that a point of a ray lies in.
#pragma once

#include <cstdint>

namespace rtcore {

/// Up to four solids of glass around a point, in the order in which the ray came into them; beyond, the one
/// that it came into first is forgotten. A medium is a number from 1 on (GlassSolids).
class MediaList {
  public:
    static constexpr int kMax = 4;

    constexpr MediaList() = default;
    constexpr MediaList(std::uint32_t low, std::uint32_t high) : bits_(std::uint64_t{high} << 32 | low) {}
    std::uint32_t low() const { return static_cast<std::uint32_t>(bits_); }
    std::uint32_t high() const { return static_cast<std::uint32_t>(bits_ >> 32); }

    bool empty() const { return bits_ == 0; }
    /// 0 where there are no more; the one that the ray came into last is the first.
    std::uint16_t operator[](int i) const { return static_cast<std::uint16_t>(bits_ >> kBits * i); }

    void enter(std::uint16_t medium) { bits_ = bits_ << kBits | medium; }
    /// As if the ray had come into it before all others; false where there is no room.
    bool enterFirst(std::uint16_t medium) {
        int count = 0;
        while (count < kMax && (*this)[count] != 0) ++count;
        if (count == kMax) return false;
        bits_ |= std::uint64_t{medium} << kBits * count;
        return true;
    }
    /// Takes the last such medium out; false where there is none.
    bool leave(std::uint16_t medium) {
        for (int i = 0; i < kMax; ++i) {
            if ((*this)[i] != medium) continue;
            const std::uint64_t kept = (std::uint64_t{1} << kBits * i) - 1; // those above it
            bits_ = (bits_ & kept) | (bits_ >> kBits & ~kept);
            return true;
        }
        return false;
    }
    friend bool operator==(const MediaList&, const MediaList&) = default;

  private:
    static constexpr int kBits = 16;
    std::uint64_t bits_ = 0;
};

} // namespace rtcore

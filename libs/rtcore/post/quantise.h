/// From linear light in [0, 1] to eight bits of sRGB; the formulas are in tone_map-inl.h.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace rtcore {

/// The sRGB curve as a table over the bits of the float, 64 chords in each power of two: within 1/500 of a
/// code of the exact curve, at a fraction of its time, and the same on every processor.
class SrgbCurve {
  public:
    SrgbCurve();

    /// A chord: the code at its begin, and how much greater it is at its end.
    struct Chord {
        float code, rise;
    };
    /// Chord i begins at the float with the bits (kFirst + i) << kShift; the last one begins before kLast.
    const Chord* chords() const { return chords_.data(); }
    static constexpr int kShift = 17;
    static constexpr std::uint32_t kFirst = 0x39000000U >> kShift; ///< 2^-13, still on the linear part
    static constexpr std::uint32_t kLast = 0x3F800000U >> kShift;  ///< 1

  private:
    std::array<Chord, kLast - kFirst + 1> chords_{};
};

} // namespace rtcore

/// From linear light in [0, 1] to eight bits of sRGB.
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
    /// x in [0, 1] -> [0, 255], before rounding.
    float code(float x) const;

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

/// A threshold in [0, 1) for each pixel, the same in every frame: neighbouring thresholds differ much, so
/// that the error of rounding spreads as fine grain (Jimenez 2014, interleaved gradient noise).
float ditherThreshold(int x, int y);

/// floor(code + threshold), within 0..255.
inline std::uint8_t quantise(float code, float threshold) {
    const float value = code + threshold;
    return static_cast<std::uint8_t>(value >= 255 ? 255 : value > 0 ? value : 0);
}

} // namespace rtcore

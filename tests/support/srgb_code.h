/// One code of the sRGB curve, as images get them in blocks.
#pragma once

#include "rtcore/post/tone_map-inl.h"

namespace test {

/// x in [0, 1] -> [0, 255], before rounding.
inline float srgbCode(const rtcore::SrgbCurve& curve, float x) {
    namespace formulas = rtcore::HWY_NAMESPACE;
    const rtcore::SrgbCurve::Chord chord = curve.chords()[formulas::chordOf(x)];
    return formulas::srgbCode(x, chord.code, chord.rise);
}

} // namespace test

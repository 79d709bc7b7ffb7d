#include "rtcore/post/quantise.h"

#include "rtcore/math/colour.h"

#include <bit>
#include <cmath>

namespace rtcore {

SrgbCurve::SrgbCurve() {
    const auto codeAt = [](std::size_t i) {
        return 255 * srgbEncode(std::bit_cast<float>(static_cast<std::uint32_t>((kFirst + i) << kShift)));
    };
    for (std::size_t i = 0; i < chords_.size(); ++i) chords_[i] = {codeAt(i), codeAt(i + 1) - codeAt(i)};
}

float SrgbCurve::code(float x) const {
    if (!(x > 0x1p-13F)) return x > 0 ? 255 * 12.92F * x : 0.0F;
    if (x >= 1) return 255;
    const auto bits = std::bit_cast<std::uint32_t>(x);
    const std::size_t chord = (bits >> kShift) - kFirst;
    constexpr auto kMask = (std::uint32_t{1} << kShift) - 1;
    const float share = static_cast<float>(bits & kMask) / static_cast<float>(kMask + 1);
    return chords_[chord].code + chords_[chord].rise * share;
}

float ditherThreshold(int x, int y) {
    const float inner = 0.06711056F * static_cast<float>(x) + 0.00583715F * static_cast<float>(y);
    const float outer = 52.9829189F * (inner - std::floor(inner));
    const float threshold = outer - std::floor(outer);
    return threshold < 1 ? threshold : 0.0F;
}

} // namespace rtcore

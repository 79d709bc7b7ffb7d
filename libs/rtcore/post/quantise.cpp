#include "rtcore/post/quantise.h"

#include "rtcore/math/colour.h"

#include <bit>

namespace rtcore {

SrgbCurve::SrgbCurve() {
    const auto codeAt = [](std::size_t i) {
        return 255 * srgbEncode(std::bit_cast<float>(static_cast<std::uint32_t>((kFirst + i) << kShift)));
    };
    for (std::size_t i = 0; i < chords_.size(); ++i) chords_[i] = {codeAt(i), codeAt(i + 1) - codeAt(i)};
}

} // namespace rtcore

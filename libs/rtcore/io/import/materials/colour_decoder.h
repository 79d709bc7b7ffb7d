/// Vertex colours of files into linear ones.
#pragma once

#include "rtcore/math/colour.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace rtcore {

/// Codes of one byte are found in a table: most colours are such.
class ColourDecoder {
  public:
    /// `linear`: they are linear as they stand, else sRGB.
    explicit ColourDecoder(bool linear) : linear_(linear) {
        for (std::size_t i = 0; i < table_.size(); ++i) table_[i] = srgbDecode(static_cast<float>(i) / 255);
    }
    Colour operator()(Colour c) const { return {decode(c.r), decode(c.g), decode(c.b)}; }

  private:
    float decode(float v) const {
        if (linear_ || !(v > 0)) return v;
        if (v >= 1) return 1;
        const auto code = static_cast<std::size_t>(std::lround(v * 255));
        return static_cast<float>(code) / 255 == v ? table_[code] : srgbDecode(v);
    }
    bool linear_;
    std::array<float, 256> table_{};
};

} // namespace rtcore

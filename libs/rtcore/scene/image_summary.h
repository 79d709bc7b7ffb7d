/// Properties of a whole image, for uses that do not look it up texel by texel.
#pragma once

#include "rtcore/scene/model.h"

#include <array>
#include <span>

namespace rtcore {

struct ImageSummary {
    Colour meanColour{1, 1, 1};                   ///< linear
    std::array<float, 4> meanChannel{1, 1, 1, 1}; ///< of the codes as they stand, 0..1
    bool transparent = false;                     ///< an alpha under 1 is there
    bool dark = false;                            ///< a red under 1 is there
};

/// Takes one texel or more, and about a nanosecond for each.
ImageSummary summarise(std::span<const Rgba8> texels);

/// The same of one of the model's textures; a few nanoseconds for each texel where it is in blocks.
ImageSummary summarise(const Model& model, const Texture& texture);

} // namespace rtcore

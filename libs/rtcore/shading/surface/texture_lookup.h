/// Texture lookups: bilinear or nearest (Texture::filter), linear light.
#pragma once

#include "rtcore/scene/model.h"

namespace rtcore {

struct TextureSample {
    Colour colour; ///< linear
    float alpha = 1;
    Vec3 stored; ///< red, green, blue as they are stored, 0..1: masks and normals are numbers, not light
};

/// `uv` of any size; (0,0) is the lower left corner of the image, which goes on beyond 0..1 as
/// Texture::wrapU and wrapV say. Safe from many threads.
TextureSample sampleTexture(const Model& model, const Texture& texture, Vec2 uv);

/// The colour of sampleTexture() alone, in a third of the time.
Colour sampleColour(const Model& model, const Texture& texture, Vec2 uv);

/// Linear light of each of the 256 codes of sRGB.
const float* linearOfCodes();

} // namespace rtcore

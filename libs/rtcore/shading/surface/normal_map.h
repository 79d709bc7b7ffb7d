/// Normal maps in tangent space: red to the right of the image, green up, blue out of the surface (OpenGL,
/// glTF).
#pragma once

#include "rtcore/kernels/ray_wave.h"
#include "rtcore/scene/scene.h"

namespace rtcore {

/// `normal` (unit, of the front side, interpolated) bent as the texture says at `uv`. The tangents follow
/// from the triangle's own texture coordinates in the texture's set; `scale` multiplies how far it leans.
/// Unchanged where these span no area. Safe from many threads.
Vec3 mapNormal(const Scene& scene, const Texture& texture, std::uint32_t triangle, Vec2 uv, Vec3 normal,
               float scale = 1);

} // namespace rtcore

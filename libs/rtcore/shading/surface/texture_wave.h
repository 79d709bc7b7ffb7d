/// Textured albedos of many points at once; the bits are those of diffuseAt() (surface.h).
#pragma once

#include "rtcore/kernels/ray_wave.h"
#include "rtcore/kernels/wave_memory.h"
#include "rtcore/scene/scene.h"

#include <cstdint>
#include <span>

namespace rtcore {

/// Albedos of the hits named by `points`, kWaveBlock at most, whose materials have a diffuse texture, to
/// albedo[0], [1] ...
void texturedAlbedos(const Scene& scene, const HitWave& hits, std::span<const std::uint32_t> points,
                     Colour* albedo);

} // namespace rtcore

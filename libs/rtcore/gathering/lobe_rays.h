/// Rays along glossy lobes, which end in cells: as large ones as the lobe is wide there.
#pragma once

#include "rtcore/gathering/gather_rays.h"
#include "rtcore/gathering/lit_scene.h"
#include "rtcore/irradiance/outgoing_cells.h"
#include "rtcore/kernels/ray_wave.h"
#include "rtcore/math/colour.h"
#include "rtcore/shading/lobe_taps.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// One for each thread; keeps its memory.
class LobeRays {
  public:
    /// Finds where the rays end, and `direct`, which comes along them by no cell: emission that lights
    /// something, and the surroundings. Light of lights is left out, since highlights show it.
    void trace(const GatherScene& in, const LitScene& lit, std::span<const LobeTap> taps,
               std::span<OutgoingCells::Site> sites, std::span<Colour> direct);

  private:
    RayWave rays_;
    HitWave hits_;
};

} // namespace rtcore

/// The points of a wave whose materials are of the metallic-roughness model (scattering/metallic-inl.h).
#pragma once

#include "rtcore/shading/surface/surface_wave.h"

#include <cstdint>
#include <vector>

namespace rtcore {

/// Which of these points send out mirrored rays.
enum class Mirroring : std::uint8_t {
    Faded, ///< all that are smooth, the fainter the rougher (kMirrorsBelow): so they show their surroundings
           ///< where the lobe is only asked what it does with the light of lights
    Exact, ///< those alone whose lobe is so narrow that it is a mirror (kMinAlpha); the others are sampled
};

/// Input of the lobes of a wave's points, and their purpose.
struct LobeTask {
    const Scene& scene;
    const MaterialTable& materials;
    const HitWave& hits;
    Mirroring mirroring;
    Colour ambient = {};                ///< a radiance from all directions
    const ArraysOf3* emitted = nullptr; ///< what metal reflects of it is added there, unless it is null
};

/// One for each thread; keeps its memory from wave to wave.
class MetallicPoints {
  public:
    /// For points whose `diffuseBrdf` is the base colour / pi, and `weight` that of all light that they
    /// reflect: sets `diffuseBrdf`, `straight`, `grazing`, `gloss`, `further`, `furtherShape` and `alpha`,
    /// and where they mirror `specular` and the trait kSpecular. The wave has at least one such material
    /// (MaterialTable::anyMetallic()).
    void complete(const LobeTask& task, const SurfaceWave& surfaces);

  private:
    void lookUp(const LobeTask& task, const SurfaceWave& surfaces);

    std::vector<float> roughness_, metallic_; ///< of the texture at each point, 1 where there is none
};

} // namespace rtcore

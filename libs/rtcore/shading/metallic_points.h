/// The points of a wave whose materials are of the metallic-roughness model (scattering/metallic-inl.h).
#pragma once

#include "rtcore/shading/frame_context.h"
#include "rtcore/shading/wave.h"

#include <cstdint>
#include <vector>

namespace rtcore {

/// Which of these points send out mirrored rays.
enum class Mirroring : std::uint8_t {
    Faded, ///< all that are smooth, the fainter the rougher (kMirrorsBelow): so they show their surroundings
           ///< where the lobe is only asked what it does with the light of lights
    Exact, ///< those alone whose lobe is so narrow that it is a mirror (kLeastAlpha); the others are drawn
           ///< from
};

/// One for each thread; keeps its memory from wave to wave.
class MetallicPoints {
  public:
    /// For points whose `diffuse` is the base colour / pi, and `weight` that of all light that they reflect:
    /// sets `diffuse`, `straight`, `grazing`, `gloss`, `further`, `furtherShape` and `alpha`, and where they
    /// mirror `specular` and the trait kSpecular. `emitted`, unless it is null, gets what they reflect of
    /// `ambient`, a radiance from all directions. The wave has at least one such material
    /// (MaterialTable::anyMetallic()).
    void complete(const FrameContext& frame, const Wave& wave, Mirroring mirroring, Colour ambient,
                  const ArraysOf3* emitted);

  private:
    void lookUp(const FrameContext& frame, const Wave& wave);

    std::vector<float> roughness_, metallic_; ///< of the texture at each point, 1 where there is none
};

} // namespace rtcore

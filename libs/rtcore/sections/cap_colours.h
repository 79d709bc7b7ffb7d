/// The colours that caps have of the materials of what is cut.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/scene/scene.h"
#include "rtcore/sections/section_caps.h"

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace rtcore {

/// Keeps the means of textures, each of which takes about a nanosecond for a texel, while the model is the
/// same.
class CapMaterialColours {
  public:
    /// Linear, by numbers of materials; set for those of the shapes: the diffuse albedo, multiplied with the
    /// mean of its texture where there is one. Good until the next call.
    const std::vector<Colour>& of(const Scene& scene, const SectionCaps& caps);

  private:
    Colour colourOf(const Scene& scene, const Material& material);

    std::shared_ptr<const void> model_; ///< owns the textures
    std::map<std::uint32_t, Colour> means_;
    std::vector<Colour> colours_;
};

} // namespace rtcore

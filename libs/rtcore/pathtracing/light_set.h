/// All lights of a scene for path tracing: its lights, its emissive triangles and its surroundings; and the
/// probabilities with which a point samples them.
#pragma once

#include "rtcore/lights/background_light.h"
#include "rtcore/lights/emitters.h"
#include "rtcore/lights/environment_sampler.h"
#include "rtcore/lights/light_tree.h"
#include "rtcore/pathtracing/visibility_cache.h"
#include "rtcore/scene/light.h"
#include "rtcore/scene/scene.h"
#include "rtcore/settings/render_settings.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace rtcore {

/// Arrays and sums for vector code (light_selection-inl.h). Lights are selected by group: the first `lights`
/// groups are lights, then come the emitters and the surroundings.
struct LightRows {
    const Light* light = nullptr;
    std::uint32_t lights = 0;
    bool emitters = false, surroundings = false;
    LightTreeRows tree;        ///< without nodes: each light is weighed by itself
    LightTreeRows emitterTree; ///< without nodes: few emitters, weighed together
    Vec3 emittersCentre;       ///< seen from far away, they are a point light there
    float emittersIntensity = 0,
          emittersSquare = 0;   ///< its luminance, W/sr; distances^2 below this count as it
    float surroundingLight = 0; ///< luminance of what surroundings throw on a surface
    VisibilityRows visible;     ///< may be empty: nothing is known

    std::uint32_t emitterGroup() const { return lights; }
    std::uint32_t surroundingGroup() const { return lights + 1; }
    bool byTree() const { return tree.nodes != nullptr; }
    bool emittersByTree() const { return emitterTree.nodes != nullptr; }
    /// What a point weighs: lights and emitters, or the cuts of their trees, and surroundings.
    std::uint32_t lightCandidates() const { return byTree() ? tree.cuts : lights; }
    std::uint32_t emitterCandidates() const {
        return emittersByTree() ? emitterTree.cuts : (emitters ? 1U : 0U);
    }
    std::uint32_t candidates() const {
        return lightCandidates() + emitterCandidates() + (surroundings ? 1U : 0U);
    }
};

/// Immutable once prepared, shared by all threads; the scene must outlive it.
class LightSet {
  public:
    /// Up to this many lights are weighed one by one at each point, more of them by their tree.
    static constexpr std::size_t kMaxWeighed = 32;
    static constexpr std::size_t kMaxCandidates = kMaxWeighed + LightTree::kMaxCut + 1;

    /// Takes the lights that are on. `bounds`: of all that rays may hit. `hidden`: by triangle of the model,
    /// not 0 where it is; may be empty.
    void prepare(const Scene& scene, const RenderSettings& settings, const Box3& bounds,
                 std::span<const std::uint8_t> hidden = {});

    /// The visibility of what points weigh, until the lights are prepared anew.
    void setVisibility(VisibilityCache&& cache) { visibility_ = std::move(cache); }

    /// Scattered rays may meet some of the lights.
    bool anyToHit() const {
        return anyArea_ || !discs_.empty() || !emitters_.empty() || !surroundings_.empty();
    }
    bool anyArea() const { return anyArea_; } ///< with a position
    /// Indices of the lights that are seen as discs, and of those that are seen in mirrors.
    std::span<const std::uint32_t> discs() const { return discs_; }
    std::span<const std::uint32_t> mirrored() const { return mirrored_; }

    LightRows rows() const;
    std::span<const Light> lights() const { return lights_; }
    const Emitters& emitters() const { return emitters_; }
    const EnvironmentSampler& surroundings() const { return surroundings_; }
    /// The background as seen by scattered rays that leave the scene.
    const BackgroundLight& background() const { return background_; }
    /// By material: not 0 where its emission is seen, but lights nothing.
    std::span<const std::uint8_t> emitsNoLight() const { return emitsNoLight_; }

  private:
    std::vector<Light> lights_;
    std::vector<std::uint32_t> discs_, mirrored_;
    Emitters emitters_;
    EnvironmentSampler surroundings_;
    BackgroundLight background_;
    std::vector<std::uint8_t> emitsNoLight_;
    LightTree tree_;
    VisibilityCache visibility_;
    bool anyArea_ = false;
};

} // namespace rtcore

/// The light that reaches the points of a wave, and the fog on its rays: ambient light, then one light after
/// another, each with its shadows.
#pragma once

#include "rtcore/shading/fog/fog_shafts.h"
#include "rtcore/shading/fog/fog_wave.h"
#include "rtcore/shading/frame_context.h"
#include "rtcore/shading/light/area_light_sampler.h"
#include "rtcore/shading/light/light_choice.h"
#include "rtcore/shading/light/light_wave.h"
#include "rtcore/shading/light/occlusion_wave.h"
#include "rtcore/shading/light/shadows.h"
#include "rtcore/shading/light/sky_wave.h"
#include "rtcore/shading/primary_hits.h"
#include "rtcore/shading/sample_sums.h"
#include "rtcore/shading/wave.h"

#include <cstdint>
#include <vector>

namespace rtcore {

/// Where the light of a wave goes to.
struct LightSums {
    SampleSums& sums;
    PrimaryHits* primaryHits; ///< null where they are not wanted
};

/// One for each thread; keeps its memory from wave to wave and from frame to frame.
class WaveLighting {
  public:
    /// Starts a frame; `fog` lives as long, and has entered each wave before its light is asked for.
    void begin(const FrameContext& frame, const FogWave& fog);

    /// Adds the light that the fog on the wave's rays scatters.
    void addFog(const FrameContext& frame, const Wave& wave, SampleSums& sums);
    /// Adds the light at the wave's points. Returns soon, with sums undefined, when frame.stopped().
    void addLight(const FrameContext& frame, Wave& wave, const LightSums& to);

  private:
    void addShafts(const FrameContext& frame, const Wave& wave, std::size_t light);
    void addSurroundings(const FrameContext& frame, HemisphereWave& light, Wave& wave, const LightSums& to);
    void addPointLight(const FrameContext& frame, Wave& wave, std::size_t light, const LightSums& to);
    void addAreaLight(const FrameContext& frame, Wave& wave, std::size_t light, const LightSums& to);
    void addArriving(const FrameContext& frame, Wave& wave, std::size_t light, const LightSums& to);
    void addChosen(const FrameContext& frame, Wave& wave, const LightSums& to);
    void addChosen(const FrameContext& frame, Wave& wave);
    void addChosen(const FrameContext& frame, const Wave& wave, std::size_t light, LightChoice::Taken taken);
    void addTaken(const FrameContext& frame, std::size_t light, LightChoice::Taken taken);
    bool chooses(const FrameContext& frame, const LightSums& to) const;
    void takeShadows(const FrameContext& frame, SurfaceWave& surfaces, std::size_t light);
    void recall(const FrameContext& frame, const Wave& wave);
    void note(std::size_t light, std::size_t point, Colour arriving);
    void confirm(std::size_t light);
    void keep(const FrameContext& frame, const Wave& wave) const;
    KnownVisibility knownOf(std::size_t light) const {
        return {clear_.data(), dark_.data(), 1U << light % kRememberedLights};
    }
    bool remembers(std::size_t light) const { return remembers_ && light < kRememberedLights; }
    bool tracesTinted(const FrameContext& frame) const {
        return frame.settings->shadows && shadows_.tinted() && frame.shadowMaps == nullptr;
    }

    const FogWave* fog_ = nullptr;
    FogShafts shafts_;
    std::vector<float> shifts_; ///< of the rays' samples in the fog
    OcclusionWave occlusion_;
    SkyWave sky_; ///< at most one of the two is on
    AreaLightSampler areaLightSampler_;
    ShadowTracer shadows_;
    ShadowRays shadowRays_;
    std::vector<std::size_t> on_; ///< the lights that are on
    LightChoice choice_;
    std::vector<std::uint32_t> points_; ///< of the wave, among which are chosen
    SurfaceWave part_;                  ///< these, where they are not all
    SurfaceWave some_;                  ///< points that take a light that is chosen
    WaveMemory chosenMemory_;
    ArraysOf3 chosen_;       ///< light of these, by point of the wave
    bool remembers_ = false; ///< the next four hold for the wave
    /// LightVisibility of its points, for whole blocks: what is known, and what rays find. Of lights of which
    /// both is found, a part arrives.
    std::vector<std::uint32_t> clear_, dark_, foundClear_, foundDark_;
    std::vector<Colour> arriving_; ///< along shadow rays, by the maps
};

} // namespace rtcore

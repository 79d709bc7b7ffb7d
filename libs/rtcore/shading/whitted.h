/// Whitted's ray tracing (1980), wave by wave: all rays of one kind are traced at once, what they hit is lit
/// by one light after another, and the rays that follow wait in queues. Nothing recurses.
#pragma once

#include "rtcore/kernels/ray_statistics.h"
#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/sampling/sample_id.h"
#include "rtcore/scene/scene.h"
#include "rtcore/settings/render_settings.h"
#include "rtcore/shading/fog/fog_wave.h"
#include "rtcore/shading/frame_context.h"
#include "rtcore/shading/normal_sums.h"
#include "rtcore/shading/primary_hits.h"
#include "rtcore/shading/sample_sums.h"
#include "rtcore/shading/secondary_rays.h"
#include "rtcore/shading/special_points.h"
#include "rtcore/shading/stage_times.h"
#include "rtcore/shading/start_media.h"
#include "rtcore/shading/surface/light_division.h"
#include "rtcore/shading/wave.h"
#include "rtcore/shading/wave_lighting.h"

#include <atomic>
#include <span>
#include <vector>

namespace rtcore {

/// One for each thread; reuses its memory from wave to wave and from frame to frame, so that steady frames do
/// not allocate. The result for a wave depends on nothing but the wave.
class WhittedIntegrator {
  public:
    WhittedIntegrator() = default;
    /// Ready for waves of one frame; the arguments must outlive it.
    WhittedIntegrator(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings);
    WhittedIntegrator(const Scene&, const RayTracer&, RenderSettings&&) = delete; // would not outlive it

    /// Starts a frame, during which the arguments must live; `materials` was prepared for the same scene and
    /// settings. Resets the statistics.
    void begin(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings,
               const MaterialTable& materials, bool measureStages = false);

    /// Whether trace() needs sample ids: random numbers are derived from them.
    static bool needsSampleIds(const Scene& scene, const RenderSettings& settings);
    /// Traces primary rays (directions of unit length) and all that follow from them. `samples` names each of
    /// them; may be empty unless needsSampleIds().
    void trace(const RayWave& primary, std::span<const SampleId> samples = {});
    /// Results of the last wave: radiance along each primary ray, and 1 where it hit something, else 0; both
    /// with room for whole blocks of kWaveBlock.
    const ArraysOf3& radiance() const { return sums_.radiance(); }
    const std::vector<std::uint8_t>& hit() const { return sums_.hit(); }

    /// Whether the next waves leave the background out of radiance(), and tell in transmitted() how much of
    /// it is seen: past holes and panes, in a straight line. Mirrors and what bends light show it all the
    /// same.
    void hideBackground(bool on) { sums_.keepTransmitted(on); }
    const ArraysOf3& transmitted() const { return sums_.transmitted(); }

    /// Chooses which parts of primaryHits() the next waves record: those of the last wave, of sample i at i.
    void collectPrimaryHits(PrimaryHitParts parts) { hitParts_ = parts; }
    std::span<const PrimaryHit> primaryHits() const { return primaryHits_.hits(); }

    /// Whether primary rays of the next waves see white matte paper on all surfaces, as those of PathFrame.
    void seeWhite(bool on) { white_ = on; }

    /// Whether the next waves record normals(): those of the last wave, of sample i at i.
    void collectNormals(bool on) { collectsNormals_ = on; }
    std::span<const Vec3> normals() const { return normals_.normals(); }

    /// Shadow maps to look shadows up in instead of tracing rays; null: shadows are traced.
    void takeShadowsFrom(const ShadowMaps* maps) { frame_.shadowMaps = maps; }

    /// Has the next waves collect the points that take indirect light, in place of ambient light, occlusion
    /// and the light of the sky: taps(). To be called before begin(), whose materials were prepared without
    /// ambient light then.
    void collectTaps(bool on, const PixelSize& pixel) {
        frame_.indirectTaps = on ? &taps_ : nullptr;
        frame_.pixelSize = pixel;
    }
    /// Points with narrow lobes send out so many rays each, in the next waves.
    void setLobeRays(std::uint32_t rays) { frame_.lobeRays = rays; }
    /// Those of the last wave.
    std::span<const IndirectTap> taps() const { return taps_.matte; }
    std::span<const LobeTap> lobes() const { return taps_.lobes; }
    /// Adds their light, which arrives in their order, to radiance() and primaryHits().
    void addIndirect(std::span<const ArrivingLight> arriving);
    /// The same of the radiance along the rays of lobes. That of what mirrors counts as mirrored.
    void addAlongLobes(std::span<const Colour> radiance);

    /// Known visibility of lights at the primary hits of the next wave, by sample; shadow rays add their
    /// results. Empty: nothing is known or kept.
    void remember(std::span<LightVisibility> visibility) { frame_.visibility = visibility; }

    /// trace(), with the results copied to spans of the size of the wave.
    void trace(const RayWave& primary, std::span<Colour> radiance, std::span<std::uint8_t> hit);

    /// Becomes true: trace() returns soon, with radiance undefined. May be null.
    void stopWhen(const std::atomic<bool>* flag) { frame_.stop = flag; }

    /// All rays since the frame began.
    const RayStatistics& statistics() const { return statistics_; }
    StageClock& clock() { return clock_; }

  private:
    void traceWave();
    bool hidesBackground(std::size_t ray) const;
    bool seesWhite() const { return white_ && wave_.paths.primary(); }
    void setWeights();
    void addTaps();
    void addBackground();
    void addDiscs();
    void addMirrored();
    const ArraysOf3* findEmission();
    void divideLight(const ArraysOf3* emitted);

    FrameContext frame_;
    MaterialTable ownMaterials_; ///< when no frame shares its table
    Colour ambient_;             ///< that nothing occludes
    bool white_ = false;
    bool mirroredLights_ = false; ///< a light that is on is seen in mirrors
    RayStatistics statistics_;
    StageClock clock_;

    Wave wave_;
    SampleSums sums_;
    FogWave fog_;
    SpecialPoints special_;
    LightDivision division_;
    WaveLighting lighting_;
    SecondaryRays secondary_;
    StartMedia startMedia_;
    PathQueue startPaths_; ///< of primary rays, where some begin in solids
    PrimaryHitParts hitParts_ = PrimaryHitParts::None;
    PrimaryHits primaryHits_;
    IndirectTaps taps_;
    bool collectsNormals_ = false;
    NormalSums normals_;
};

} // namespace rtcore

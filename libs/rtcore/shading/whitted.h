/// Whitted's ray tracing (1980), wave by wave: all rays of one kind are traced at once, what they hit is lit
/// by one light after another, and the rays that follow wait in queues. Nothing recurses.
#pragma once

#include "rtcore/kernels/ray_statistics.h"
#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/sampling/sample_id.h"
#include "rtcore/scene/scene.h"
#include "rtcore/settings/render_settings.h"
#include "rtcore/shading/first_hits.h"
#include "rtcore/shading/fog_shafts.h"
#include "rtcore/shading/fog_wave.h"
#include "rtcore/shading/lamp_draw.h"
#include "rtcore/shading/light_wave.h"
#include "rtcore/shading/material_table.h"
#include "rtcore/shading/occlusion_wave.h"
#include "rtcore/shading/shadow_maps.h"
#include "rtcore/shading/shadows.h"
#include "rtcore/shading/stage_times.h"
#include "rtcore/shading/surface.h"
#include "rtcore/shading/surface_split.h"
#include "rtcore/shading/surface_wave.h"
#include "rtcore/shading/wave_paths.h"

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

    /// Starts a frame, during which the arguments must live; `materials` was prepared for the same scene and
    /// settings. Resets the statistics.
    void begin(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings,
               const MaterialTable& materials, bool measureStages = false);

    /// Whether trace() needs the names of the samples: something is drawn for each of them.
    static bool drawsSamples(const Scene& scene, const RenderSettings& settings);
    /// Traces primary rays (directions of unit length) and all that follow from them. `samples` names each of
    /// them; may be empty unless drawsSamples().
    void trace(const RayWave& primary, std::span<const SampleId> samples = {});
    /// Of the last wave: radiance along each primary ray, and 1 where it hit something, else 0; both with
    /// room for whole blocks of kWaveBlock.
    const ArraysOf3& radiance() const { return radiance_; }
    const std::vector<std::uint8_t>& hit() const { return hit_; }

    /// Whether waves to come tell firstHits(): what the last one's samples saw, sample i at i.
    void collectFirstHits(bool on) { collectFirstHits_ = on; }
    const FirstHits& firstHits() const { return firstHits_; }

    /// Where the shadows of waves to come are looked up in place of being traced; null: they are traced.
    void takeShadowsFrom(const ShadowMaps* maps) { maps_ = maps; }

    /// trace(), with the results copied to spans of the size of the wave.
    void trace(const RayWave& primary, std::span<Colour> radiance, std::span<std::uint8_t> hit);

    /// Becomes true: trace() returns soon, with radiance undefined. May be null.
    void stopWhen(const std::atomic<bool>* flag) { stop_ = flag; }

    /// All rays since the frame began.
    const RayStatistics& statistics() const { return statistics_; }
    StageClock& clock() { return clock_; }

  private:
    /// A point that lets light through.
    struct Transparent {
        Surface surface;
        SurfaceSplit split;
        Path path;
    };

    void traceWave(RayKind kind, const RayWave& rays);
    SampleId sampleId(std::uint32_t sample) const;
    void setShares(RayKind kind);
    void addBackground(const RayWave& rays);
    void addGlow();
    void completePoints(const RayWave& rays);
    void completeGeneral(const RayWave& rays, std::size_t i, Colour& glow);
    void setAlbedo(std::size_t i, Colour albedo, Colour& glow);
    void completeTextured();
    bool passHole(const RayWave& rays, std::size_t i, const Surface& surface, Path& path);
    void enterFog(const RayWave& rays);
    void addFog();
    void addShafts(const Light& light, std::uint32_t number);
    void lightFromEverywhere();
    void lightBy(const Light& light, std::uint32_t number);
    void lightBySamples(const Light& light, std::uint32_t number);
    void addUnshadowed(const Light& light, std::uint32_t number);
    void lookShadowsUp(const ShadowMap& map);
    void takeFirstHits();
    void tellFirstHits();
    void darken(const std::vector<std::uint8_t>& occluded);
    void tint(const std::vector<Colour>& arriving);
    void accumulate();
    void spawn();
    void spawnTransmitted(const Transparent& point);
    void evenQueues();
    bool matters(Colour weight) const;
    bool tracesTinted() const { return settings_->shadows && shadows_.tinted() && maps_ == nullptr; }
    bool stopped() const { return stop_ != nullptr && stop_->load(std::memory_order_relaxed); }

    const Scene* scene_ = nullptr;
    const RayTracer* tracer_ = nullptr;
    const RenderSettings* settings_ = nullptr;
    const MaterialTable* materials_ = nullptr;
    MaterialTable ownMaterials_; ///< when no frame shares its table
    ShadowTracer shadows_;
    OcclusionWave occlusion_;
    Colour ambient_; ///< that nothing occludes
    RayStatistics statistics_;
    StageClock clock_;
    const std::atomic<bool>* stop_ = nullptr;
    std::span<const SampleId> samples_; ///< of the wave being traced

    WaveMemory radianceMemory_;
    ArraysOf3 radiance_;
    std::vector<std::uint8_t> hit_;
    PathQueue wave_;  ///< the secondary rays being traced
    WavePaths paths_; ///< of the rays being traced
    PathQueue mirrored_, refracted_;
    HitWave hits_;
    SurfaceWave surfaces_;
    std::vector<Colour> glow_; ///< of the points that are not plain, in their order
    /// Points that wait until there is a block of them: which, and their place in glow_.
    struct TexturedPoints {
        std::size_t count = 0;
        std::uint32_t point[kWaveBlock], place[kWaveBlock];
    } textured_;
    std::vector<Transparent> transparent_;
    ShadowRays shadowRays_;
    const ShadowMaps* maps_ = nullptr;
    std::vector<Colour> arriving_; ///< along shadow rays, by the maps
    LampDraw lampDraw_;
    FogWave fog_;
    FogShafts shafts_;
    std::vector<float> shifts_; ///< of the rays' samples in the fog
    bool collectFirstHits_ = false;
    FirstHits firstHits_;
    enum class Lit {
        Not,
        Everywhere,
        ByPoint,
        BySize
    } lit_ = Lit::Not; ///< what accumulate() adds the light of
};

} // namespace rtcore

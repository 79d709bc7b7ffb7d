/// Path tracing (Kajiya 1986), wave by wave: each camera ray goes on as one path, which samples a light at
/// each point and scatters in a direction of a lobe; light that both find is weighted by the power
/// heuristic (Veach 1995). The mean over samples is the light of any number of bounces. What counts which
/// light is a table in docs/shading.md.
#pragma once

#include "rtcore/kernels/ray_statistics.h"
#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/pathtracing/kept_light.h"
#include "rtcore/pathtracing/light_set.h"
#include "rtcore/pathtracing/next_event.h"
#include "rtcore/pathtracing/path_batches.h"
#include "rtcore/pathtracing/path_points.h"
#include "rtcore/pathtracing/sampling_strategy.h"
#include "rtcore/sampling/sample_id.h"
#include "rtcore/scene/scene.h"
#include "rtcore/settings/render_settings.h"
#include "rtcore/shading/fog/fog_wave.h"
#include "rtcore/shading/frame_context.h"
#include "rtcore/shading/light/shadows.h"
#include "rtcore/shading/sample_sums.h"
#include "rtcore/shading/stage_times.h"
#include "rtcore/shading/start_media.h"
#include "rtcore/shading/surface/light_division.h"
#include "rtcore/shading/wave.h"
#include "rtcore/shading/wave_lighting.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// Input of a frame, shared by all threads; must outlive it.
struct PathFrame {
    const Scene& scene;
    const RayTracer& tracer;
    const RenderSettings&
        settings; ///< of them `path`, textures, shadows, reflections, refractions, maxDepth, fog
    const MaterialTable& materials; ///< prepared for the scene without ambient light
    const LightSet& lights;
    SamplingStrategy strategy = SamplingStrategy::Both;
    /// Rays of the camera see white matte paper on all surfaces, glass and mirrors too, and neither fog nor
    /// anything beyond: their radiance times pi is the illuminance there.
    bool white = false;
    /// PathIntegrator::radiance() leaves out the background that rays of the camera see in a straight line,
    /// past holes and panes; transmitted() tells how much of it there is.
    bool hidesBackground = false;
};

/// One for each thread; reuses its memory. The result for a sample depends on nothing but the sample: not on
/// what else is in its wave, not on threads or instruction set.
class PathIntegrator {
  public:
    /// Starts a frame; the arguments must outlive it. Resets the statistics.
    void begin(const PathFrame& frame);

    /// Traces camera rays (directions of unit length) to the ends of their paths. `samples` names each of
    /// them, and which of its pixel's samples it is.
    void trace(const RayWave& rays, std::span<const SampleId> samples);
    /// In place of camera rays: the paths of light that comes to points of white matte paper, which nothing
    /// else meets. The radiance of each, times pi, is the irradiance there. Solids of glass that a point is
    /// in are known.
    void traceWhite(std::span<const WhitePoint> points, std::span<const SampleId> samples);
    /// Traces rays that gather light for points which scatter it as matte surfaces do: what is left of the
    /// paths after their first bounce. Not with the light that such points sample themselves: of lights, and
    /// of what emits where the ray or its straight way through panes ends.
    void traceGathering(const RayWave& rays, std::span<const SampleId> samples);
    /// Results of the last wave: radiance along each camera ray, and 1 where it hit something, else 0. Not
    /// finite where numbers of the scene are not.
    const ArraysOf3& radiance() const { return sums_.radiance(); }
    const ArraysOf3& transmitted() const { return sums_.transmitted(); }
    const std::vector<std::uint8_t>& hit() const { return sums_.hit(); }

    /// Becomes true: trace() returns soon, with radiance undefined. May be null.
    void stopWhen(const std::atomic<bool>* flag) { frame_.stop = flag; }

    /// All rays since the frame began.
    const RayStatistics& statistics() const { return statistics_; }
    StageClock& clock() { return clock_; }

  private:
    void nameSamples(std::span<const SampleId> samples);
    void traceCamera(const RayWave& rays);
    void startInMedia(std::uint32_t first);
    void startWhite(std::span<const WhitePoint> points);
    void tracePaths();
    void traceOnward();
    bool seesWhite() const { return white_ && paths_ == nullptr; }
    bool leavesLightsOut(std::size_t ray) const;
    bool leavesDiscsOut(std::size_t ray) const;
    void takeSeen(std::span<const PathBatch> batches);
    void traceSeen();
    void startStep(RayKind kind, const RayWave& rays);
    void shade(std::size_t first, std::size_t count);
    void scatter();
    PathNames names() const;
    void setWeights();
    void addFound();
    void addTransmitted();
    bool hidesBackground(std::size_t ray) const;
    void addSurroundings();
    void addDiscs();
    void addMirrored();
    void addEmission();
    void addTo(std::size_t ray, Colour light);
    float weightOfHit(std::size_t ray, float sampled) const;
    float weightOfEmission(std::size_t point) const;
    void sampleLights();
    void takeShadows();
    void addKept();
    template <typename Wanted>
    void takePart(Wanted&& wanted);
    void tint(std::uint32_t group);
    bool isSurrounding(std::uint32_t group) const;
    void tintBy(const ShadowTracer& tracer, const std::vector<Colour>& arriving);

    FrameContext frame_;
    RenderSettings settings_;
    const LightSet* lights_ = nullptr;
    LightRows rows_;
    PathSettings limits_;
    SamplingStrategy strategy_ = SamplingStrategy::Both;
    bool white_ = false;
    RayStatistics statistics_;
    StageClock clock_;

    RayWave rays_; ///< of a step
    HitWave hits_;
    Wave wave_; ///< a batch of them
    RayWave cameraRays_;
    StartMedia startMedia_; ///< of cameraRays_
    PathBatch startBatch_;  ///< those rays, where some begin in solids
    bool cutsSeen_ = false; ///< sections cut for rays of the camera alone
    RayWave seenRays_;      ///< of a step: those that no surface has scattered
    HitWave seenHits_;
    std::vector<std::size_t> seenIndices_; ///< of them in rays_
    PathBatches current_, next_;
    PathBatch* paths_ = nullptr;  ///< of the wave's rays; null for those of the camera
    PathBatch* onward_ = nullptr; ///< of next_: takes the rays that follow
    SampleSums sums_;
    std::vector<std::uint32_t> pixelNames_, subs_;
    std::vector<float> densities_; ///< of rays that leave the scene, by next event
    FogWave fog_;
    WaveLighting fogLighting_;
    PathPoints points_;
    LightDivision division_;
    NextEvents events_;
    ShadowTracer shadows_;
    ShadowTracer opaqueGlass_; ///< where caustics count, they are the light of what rays see behind glass
    ShadowRays part_;          ///< of the kept light
    KeptLight kept_;
};

} // namespace rtcore

/// Shadows of a whole wave of rays towards one light, or the sky: black, or tinted by what lets light
/// through.
#pragma once

#include "rtcore/kernels/ray_statistics.h"
#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/scene/scene.h"
#include "rtcore/settings/render_settings.h"
#include "rtcore/shading/fog/fog.h"
#include "rtcore/shading/light/shadow_media.h"
#include "rtcore/shading/surface/surface.h"

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace rtcore {

/// How far a ray of light gets.
struct LightEnd {
    float clear = std::numeric_limits<float>::max(); ///< distance to the first surface
    float distance = clear;                          ///< to what lets nothing of it through
    Colour tint = kWhite;                            ///< what is left of it between the two
};

/// Reuses its memory from wave to wave and from frame to frame; one for each thread.
class ShadowTracer {
  public:
    /// For the waves of one frame, during which the arguments must live. `clear`: what lets light through
    /// (MaterialTable::clear()); empty where nothing does. `fog`: null where there is none. `kind`: what its
    /// rays are traced and counted as.
    void begin(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings,
               std::span<const std::uint8_t> clear, const FogMedium* fog = nullptr,
               RayKind kind = RayKind::Shadow);

    /// Whether transmittance() has to be asked: without transparent surfaces, occluded() says all.
    bool tinted() const { return !clear_.empty(); }
    /// 1 for each ray (directions of unit length) whose light does not arrive, else 0. Valid until the next
    /// call.
    const std::vector<std::uint8_t>& occluded(const RayWave& rays, RayStatistics& statistics);

    /// For each ray the fraction of the light of `light` that arrives along it: 1 unhindered, 0
    /// behind anything opaque. Transparent surfaces take (1 - Fresnel) of it and tint it; light goes straight
    /// on through them, without focusing. Fog weakens it outside of solids. Valid until the next call.
    const std::vector<Colour>& transmittance(const RayWave& rays, const Light& light,
                                             RayStatistics& statistics);
    /// The same of light from anywhere, without fog.
    const std::vector<Colour>& transmittance(const RayWave& rays, RayStatistics& statistics);
    /// The part of it through holes and thin panes alone, which a ray that is scattered in this direction
    /// passes just as straight. The rest passes solids, which would bend such a ray. Valid as long
    /// as what transmittance() gave last.
    const std::vector<Colour>& unbent() const { return unbent_; }

    /// The paths of light along rays that leave a light, in directions of unit length, without fog. Valid
    /// until the next call.
    const std::vector<LightEnd>& ends(const RayWave& rays);

  private:
    void startLayers(const RayWave& rays);
    void settle(const RayWave& rays, const Light* fogLight, RayStatistics& statistics);
    void goOn(std::size_t ray, const Surface& surface, const Hit& hit);
    void traceTinted(const Light* fogLight, RayStatistics& statistics);
    void traceLayers(const Light* fogLight, RayStatistics& statistics);
    bool mayNest(const Surface& surface, const Hit& hit) const;
    MediaMeeting meetingAt(const Surface& surface, const Hit& hit, float distance) const;
    /// The ray came from the surface before it, hit.t away.
    Passing throughSurface(const Surface& surface, const Hit& hit) const;
    float throughFog(const Ray& ray, const Light& light, const Hit& hit) const;

    const Scene* scene_ = nullptr;
    const RayTracer* tracer_ = nullptr;
    const FogMedium* fog_ = nullptr;
    RayKind kind_ = RayKind::Shadow;
    bool textures_ = true, refractions_ = true;
    std::span<const std::uint8_t> clear_; ///< by material

    std::vector<Colour> transmittance_, unbent_;
    std::vector<LightEnd> ends_;
    std::vector<float> travelled_; ///< of ends_
    std::vector<std::uint8_t> occluded_;
    std::vector<Obstacle> obstacles_;
    HitWave hits_;
    RayWave current_, next_;
    std::vector<std::uint32_t> currentIndex_, nextIndex_;
    RayWave waiting_; ///< where solids may overlap
    std::vector<std::uint32_t> waitingIndex_;
    MediaMeetings meetings_;
    std::vector<float> sinceSolid_; ///< by ray: how far it has come since the last solid's surface
    std::vector<MediaList> media_;  ///< of ends_
};

} // namespace rtcore

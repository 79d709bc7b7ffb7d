#include "rtcore/shading/light/shadows.h"

#include "rtcore/scattering/fresnel.h"
#include "rtcore/scene/media_crossing.h"
#include "rtcore/shading/surface/medium.h"
#include "rtcore/shading/surface/surface.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rtcore {

namespace {

/// Light that passed this many surfaces counts as lost; it bounds the work of a hostile model.
constexpr int kMaxSurfaces = 256;

} // namespace

void ShadowTracer::begin(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings,
                         std::span<const std::uint8_t> clear, const FogMedium* fog, RayKind kind) {
    scene_ = &scene;
    tracer_ = &tracer;
    fog_ = fog;
    kind_ = kind;
    textures_ = settings.textures;
    refractions_ = settings.refractions;
    clear_ = clear;
}

const std::vector<std::uint8_t>& ShadowTracer::occluded(const RayWave& rays, RayStatistics& statistics) {
    statistics.count(kind_, rays.size());
    tracer_->occluded(kind_, rays, occluded_);
    return occluded_;
}

const std::vector<Colour>& ShadowTracer::transmittance(const RayWave& rays, const Light& light,
                                                       RayStatistics& statistics) {
    const Light* const fogLight = fog_ != nullptr ? &light : nullptr;
    settle(rays, fogLight, statistics);
    traceTinted(fogLight, statistics);
    return transmittance_;
}

const std::vector<Colour>& ShadowTracer::transmittance(const RayWave& rays, RayStatistics& statistics) {
    settle(rays, nullptr, statistics);
    traceTinted(nullptr, statistics);
    return transmittance_;
}

/// Rays that meet nothing, or something opaque, whatever lies before it; the others remain. `fogLight`: the
/// light that fog weakens, null where none does.
void ShadowTracer::settle(const RayWave& rays, const Light* fogLight, RayStatistics& statistics) {
    transmittance_.assign(rays.size(), kWhite);
    unbent_.assign(rays.size(), kWhite);
    statistics.count(kind_, rays.size());
    tracer_->findObstacles(rays, clear_, obstacles_);
    current_.clear();
    current_.reserve(rays.size());
    next_.reserve(rays.size());
    currentIndex_.clear();
    currentIndex_.reserve(rays.size());
    nextIndex_.reserve(rays.size());
    for (std::uint32_t i = 0; i < rays.size(); ++i) {
        if (obstacles_[i] == Obstacle::Unknown) {
            current_.push(rays.ray(i));
            currentIndex_.push_back(i);
        } else if (obstacles_[i] == Obstacle::Opaque) {
            transmittance_[i] = unbent_[i] = {};
        } else if (fogLight != nullptr) {
            transmittance_[i] = unbent_[i] =
                transmittance_[i] * fogLightTransmittance(*fog_, *fogLight, rays.ray(i).origin);
        }
    }
}

void ShadowTracer::startLayers(const RayWave& rays) {
    current_ = rays;
    currentIndex_.resize(rays.size());
    // As much as the other: the two are swapped, and steady frames must not allocate.
    next_.reserve(rays.size());
    nextIndex_.reserve(rays.size());
    for (std::uint32_t i = 0; i < rays.size(); ++i) currentIndex_[i] = i;
}

/// Continues a ray behind the surface that it hit.
void ShadowTracer::goOn(std::size_t ray, const Surface& surface, const Hit& hit) {
    Ray rest = current_.ray(ray);
    rest.origin = surface.position - surface.geometricNormal * surface.clearance;
    // The step off each surface counts: else behind many of them a ray would go on into the light itself.
    const float step = surface.clearance * std::fabs(dot(surface.geometricNormal, rest.direction));
    rest.tMax = rest.tMax - hit.t - step;
    if (!(rest.tMax > 0)) return;
    next_.push(rest);
    nextIndex_.push_back(currentIndex_[ray]);
}

const std::vector<LightEnd>& ShadowTracer::ends(const RayWave& rays) {
    ends_.assign(rays.size(), {});
    travelled_.assign(rays.size(), 0);
    media_.assign(rays.size(), {});
    startLayers(rays);
    for (int layer = 0; layer < kMaxSurfaces && !current_.empty(); ++layer) {
        tracer_->intersect(kind_, current_, hits_);
        next_.clear();
        nextIndex_.clear();
        for (std::size_t i = 0; i < current_.size(); ++i) {
            if (!hits_.isHit(i)) continue;
            const Hit hit = hits_.hit(i);
            const std::uint32_t index = currentIndex_[i];
            travelled_[index] += hit.t;
            if (layer == 0) ends_[index].clear = hit.t;
            const Surface surface = shapeAt(*scene_, current_.ray(i).direction, hit, hits_.clearanceOf(i));
            const Passing passing = mayNest(surface, hit)
                                        ? passMedium(*scene_, meetingAt(surface, hit, hit.t), media_[index])
                                        : throughSurface(surface, hit);
            const Colour left = ends_[index].tint * passing.all;
            if (isBlack(left)) {
                ends_[index].distance = travelled_[index];
                continue;
            }
            ends_[index].tint = left;
            goOn(i, surface, hit);
        }
        std::swap(current_, next_);
        std::swap(currentIndex_, nextIndex_);
    }
    for (const std::uint32_t lost : currentIndex_) ends_[lost].distance = travelled_[lost];
    return ends_;
}

/// The rays that remain. Where solids may overlap, a part of them at a time, which bounds the memory of what
/// they meet.
void ShadowTracer::traceTinted(const Light* fogLight, RayStatistics& statistics) {
    sinceSolid_.clear();
    if (scene_->solids == nullptr || !scene_->solids->overlap || !refractions_)
        return traceLayers(fogLight, statistics);
    constexpr std::size_t kPart = 1024;
    std::swap(waiting_, current_);
    std::swap(waitingIndex_, currentIndex_);
    for (std::size_t first = 0; first < waiting_.size(); first += kPart) {
        const std::size_t count = std::min(kPart, waiting_.size() - first);
        current_.clear();
        current_.append(waiting_, first, count);
        const auto begin = waitingIndex_.begin() + static_cast<std::ptrdiff_t>(first);
        currentIndex_.assign(begin, begin + static_cast<std::ptrdiff_t>(count));
        meetings_.start(transmittance_.size());
        sinceSolid_.assign(transmittance_.size(), 0);
        traceLayers(fogLight, statistics);
        for (std::size_t i = first; i < first + count; ++i) {
            const Passing passing = meetings_.passing(*scene_, waitingIndex_[i]);
            transmittance_[waitingIndex_[i]] *= passing.all;
            unbent_[waitingIndex_[i]] *= passing.unbent;
        }
    }
}

/// Surface after surface.
void ShadowTracer::traceLayers(const Light* fogLight, RayStatistics& statistics) {
    for (int layer = 0; layer < kMaxSurfaces && !current_.empty(); ++layer) {
        if (layer > 0) statistics.count(kind_, current_.size());
        tracer_->intersect(kind_, current_, hits_);
        next_.clear();
        nextIndex_.clear();
        for (std::size_t i = 0; i < current_.size(); ++i) {
            Colour& arriving = transmittance_[currentIndex_[i]];
            Colour& unbent = unbent_[currentIndex_[i]];
            const Ray ray = current_.ray(i);
            if (!hits_.isHit(i)) {
                if (fogLight == nullptr) continue;
                const float left = fogLightTransmittance(*fog_, *fogLight, ray.origin);
                arriving = arriving * left;
                unbent = unbent * left;
                continue;
            }
            const Hit hit = hits_.hit(i);
            const Surface surface = shapeAt(*scene_, ray.direction, hit, hits_.clearanceOf(i));
            const std::uint32_t index = currentIndex_[i];
            const bool nested = mayNest(surface, hit);
            const Passing passing = nested ? Passing{} : throughSurface(surface, hit);
            arriving *= passing.all;
            unbent *= passing.unbent;
            if (nested) {
                MediaMeeting at = meetingAt(surface, hit, sinceSolid_[index] + hit.t);
                if (fogLight != nullptr) at.fog = throughFog(ray, *fogLight, hit);
                meetings_.add(index, at);
                sinceSolid_[index] = 0;
            } else if (!sinceSolid_.empty()) {
                sinceSolid_[index] += hit.t;
            }
            if (fogLight != nullptr && !nested && !(surface.closed && surface.fromInside)) {
                const float left = throughFog(ray, *fogLight, hit);
                arriving = arriving * left;
                unbent = unbent * left;
            }
            if (isBlack(arriving)) continue;
            goOn(i, surface, hit);
        }
        std::swap(current_, next_);
        std::swap(currentIndex_, nextIndex_);
    }
    for (const std::uint32_t lost : currentIndex_) transmittance_[lost] = unbent_[lost] = {};
}

/// Transmittance of the fog between two surfaces.
float ShadowTracer::throughFog(const Ray& ray, const Light& light, const Hit& hit) const {
    if (!traitsOf(light).position && !fog_->exponential) return 1;
    return fogTransmittance(*fog_, ray.origin, ray.direction, hit.t);
}

bool ShadowTracer::mayNest(const Surface& surface, const Hit& hit) const {
    return refractions_ && boundsMedium(*scene_, hit.triangle, *surface.material);
}

/// Such a surface, `distance` from the solid before it.
MediaMeeting ShadowTracer::meetingAt(const Surface& surface, const Hit& hit, float distance) const {
    return {hit.triangle,
            surface.fromInside,
            distance,
            dot(surface.toViewer, surface.shadingNormal),
            opacityAt(*scene_, textures_, hit),
            coverageAt(*scene_, textures_, hit, surface.fromInside),
            1};
}

Passing ShadowTracer::throughSurface(const Surface& surface, const Hit& hit) const {
    const Material& material = *surface.material;
    const float coverage = coverageAt(*scene_, textures_, hit, surface.fromInside);
    const float opacity = refractions_ ? opacityAt(*scene_, textures_, hit) : 1.0F;
    Colour through{};
    if (opacity < 1) {
        // The outer angle on both faces: total reflection inside would make solids opaque to straight rays.
        const float reflected =
            fresnelDielectric(dot(surface.toViewer, surface.shadingNormal), material.indexOfRefraction);
        through = kWhite * (1 - opacity);
        if (surface.closed) {
            through = through * (1 - reflected);
            if (!surface.fromInside) through *= tintOnEntering(material);
            if (surface.fromInside) through *= absorption(extinctionOf(material), hit.t);
        } else {
            through = through * (1 - thinWallReflectance(reflected)) * material.transmission;
        }
    }
    const Colour holes = kWhite * (1 - coverage), all = holes + through * coverage;
    return {all, surface.closed ? holes : all};
}

} // namespace rtcore

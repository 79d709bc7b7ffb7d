#include "rtcore/shading/whitted.h"

#include "rtcore/shading/lighting.h"
#include "rtcore/shading/medium.h"
#include "rtcore/shading/phong.h"

#include <algorithm>
#include <limits>

namespace rtcore {

namespace {

/// Secondary rays traced at once: enough for streams, and a bound on the memory of the queues.
constexpr std::size_t kWaveSize = 16384;
/// Thin walls and holes that a path may pass; it bounds the work of a hostile model.
constexpr std::uint16_t kMaxPasses = 1000;
constexpr float kInfinity = std::numeric_limits<float>::max();

/// `side` is the normal on the side that the ray leaves to.
Ray rayFrom(const Surface& s, Vec3 side, Vec3 direction) {
    return {s.position + side * s.clearance, 0, direction, kInfinity};
}

/// The mirrored direction, bent back where a smooth normal would send it below the real surface.
Vec3 mirrorDirection(const Surface& s) {
    constexpr float kLowest = 1e-3F;
    const Vec3 r = reflect(-s.toViewer, s.shadingNormal);
    const float height = dot(r, s.geometricNormal);
    return height < kLowest ? normalize(r + s.geometricNormal * (kLowest - height)) : normalize(r);
}

/// Diffuse and glossy reflection towards the viewer, times the cosine: what irradiance is multiplied with.
Colour reflectedShare(const Surface& s, Vec3 toLight) {
    const float cosine = dot(s.shadingNormal, toLight);
    Colour share = s.diffuse / kPi;
    if (!isBlack(s.material->specular)) {
        const float lobe = dot(reflect(-toLight, s.shadingNormal), s.toViewer);
        share += s.material->specular * phongLobe(lobe, s.material->shininess);
    }
    return share * (cosine * terminatorFactor(s.geometricNormal, s.shadingNormal, toLight));
}

} // namespace

WhittedIntegrator::WhittedIntegrator(const Scene& scene, const RayTracer& tracer,
                                     const RenderSettings& settings)
    : scene_(scene), tracer_(tracer), settings_(settings),
      shadows_(scene, tracer, settings.textures, settings.refractions) {}

void WhittedIntegrator::trace(const RayWave& primary, std::span<Colour> radiance,
                              std::span<std::uint8_t> hit) {
    radiance_ = radiance;
    hit_ = hit;
    std::fill(radiance.begin(), radiance.end(), Colour{});
    std::fill(hit.begin(), hit.end(), std::uint8_t{0});
    mirrored_.clear();
    refracted_.clear();

    wave_.rays = primary;
    wave_.paths.resize(primary.size());
    for (std::uint32_t i = 0; i < primary.size(); ++i) {
        wave_.paths[i] = {};
        wave_.paths[i].sample = i;
    }
    traceWave(RayKind::Primary);
    while (!mirrored_.empty() || !refracted_.empty()) {
        if (stopped()) return;
        const bool mirror = mirrored_.size() >= refracted_.size();
        (mirror ? mirrored_ : refracted_).takeLast(kWaveSize, wave_);
        traceWave(mirror ? RayKind::Mirror : RayKind::Refracted);
    }
}

void WhittedIntegrator::traceWave(RayKind kind) {
    statistics_.count(kind, wave_.size());
    tracer_.intersect(kind, wave_.rays, hits_);
    points_.clear();
    for (std::size_t i = 0; i < wave_.size(); ++i) {
        const Ray ray = wave_.rays.ray(i);
        if (hits_.isHit(i)) {
            addPoint(ray, hits_.hit(i), wave_.paths[i]);
        } else {
            addBackground(wave_.paths[i], ray.direction);
        }
    }
    for (const Point& point : points_) addGlow(point);
    for (const Light& light : scene_.lights) {
        if (light.on != 0 && !stopped()) addLight(light);
    }
    for (const Point& point : points_) {
        spawnMirrored(point);
        spawnTransmitted(point);
    }
}

void WhittedIntegrator::addBackground(const Path& path, Vec3 direction) {
    const Environment* const environment = scene_.environment();
    const TexelFilter filter = settings_.environmentFilter == EnvironmentFilter::Bilinear
                                   ? TexelFilter::Bilinear
                                   : TexelFilter::Nearest;
    const Colour seen = environment != nullptr ? environment->radiance(direction, filter) : scene_.background;
    radiance_[path.sample] += path.weight * seen;
}

void WhittedIntegrator::addPoint(const Ray& ray, const Hit& hit, Path path) {
    path.weight *= absorption(path.extinction, hit.t);
    Point point;
    point.surface = surfaceAt(scene_, settings_.textures, ray.direction, hit);
    if (point.surface.coverage < 1) {
        passThroughHole(ray, point.surface, path);
        if (point.surface.coverage == 0) return;
        path.weight = path.weight * point.surface.coverage;
    }
    if (path.depth == 0) hit_[path.sample] = 1;
    point.split = splitLight(point.surface, settings_);
    point.path = path;
    points_.push_back(point);
}

void WhittedIntegrator::passThroughHole(const Ray& ray, const Surface& surface, Path path) {
    path.weight = path.weight * (1 - surface.coverage);
    if (!matters(path.weight) || path.passes >= kMaxPasses) return;
    ++path.passes;
    refracted_.push(rayFrom(surface, -surface.geometricNormal, ray.direction), path);
}

/// Emission, and the constant light from everywhere.
void WhittedIntegrator::addGlow(const Point& point) {
    const Surface& s = point.surface;
    const Colour ambient = scene_.ambient * (s.diffuse + s.material->specular) * point.split.scattered;
    radiance_[point.path.sample] += point.path.weight * (s.emission + ambient);
}

void WhittedIntegrator::addLight(const Light& light) {
    shadowRays_.clear();
    unshadowed_.clear();
    unshadowedSample_.clear();
    for (const Point& point : points_) {
        const Surface& s = point.surface;
        const Illumination lit = illuminate(light, s.position);
        if (dot(s.geometricNormal, lit.toLight) <= 0 || dot(s.shadingNormal, lit.toLight) <= 0) continue;
        const Colour share = point.path.weight * point.split.scattered * reflectedShare(s, lit.toLight);
        const Colour added = share * lit.irradiance;
        if (isBlack(added)) continue;
        if (!settings_.shadows) {
            radiance_[point.path.sample] += added;
            continue;
        }
        Ray ray = rayFrom(s, s.geometricNormal, lit.toLight);
        ray.tMax = std::max(lit.distance - s.clearance, 0.0F);
        shadowRays_.push(ray);
        unshadowed_.push_back(added);
        unshadowedSample_.push_back(point.path.sample);
    }
    if (shadowRays_.empty()) return;
    const std::vector<Colour>& arriving = shadows_.transmittance(shadowRays_, statistics_);
    for (std::size_t i = 0; i < unshadowed_.size(); ++i) {
        radiance_[unshadowedSample_[i]] += unshadowed_[i] * arriving[i];
    }
}

void WhittedIntegrator::spawnMirrored(const Point& point) {
    Path path = point.path;
    path.weight *= point.split.mirrored;
    if (path.depth >= settings_.maxDepth || !matters(path.weight)) return;
    ++path.depth;
    mirrored_.push(rayFrom(point.surface, point.surface.geometricNormal, mirrorDirection(point.surface)),
                   path);
}

void WhittedIntegrator::spawnTransmitted(const Point& point) {
    const Surface& s = point.surface;
    const Material& m = *s.material;
    Path path = point.path;
    path.weight *= point.split.transmitted;
    if (isBlack(path.weight)) return;
    Vec3 direction = -s.toViewer;
    if (!s.closed) {
        path.weight *= m.transmission;
        if (++path.passes > kMaxPasses) return;
    } else {
        if (path.depth >= settings_.maxDepth) return;
        ++path.depth;
        const float eta = s.fromInside ? 1 / m.indexOfRefraction : m.indexOfRefraction;
        if (!refract(direction, s.shadingNormal, eta, direction)) return;
        if (dot(direction, s.geometricNormal) >= 0) return; // a smooth normal bent it back out
        if (!s.fromInside) path.weight *= tintOnEntering(m);
        path.extinction = s.fromInside ? Colour{} : extinctionOf(m);
    }
    if (!matters(path.weight)) return;
    refracted_.push(rayFrom(s, -s.geometricNormal, direction), path);
}

bool WhittedIntegrator::matters(Colour weight) const {
    const float largest = maxComponent(weight);
    return largest > 0 && largest >= settings_.minContribution;
}

} // namespace rtcore

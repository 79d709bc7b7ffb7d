#include "rtcore/render/guides.h"

#include <algorithm>

namespace rtcore {

namespace {

/// Mirrors and panes between the eye and what it sees.
constexpr int kMaxDepth = 8;
/// A ray that matters less than this for its sample's albedo is not traced.
constexpr float kMinContribution = 0.01F;
/// The mean of an environment beside surfaces, whose albedo is some 0.5.
constexpr float kMeanSurroundings = 0.5F;

/// Of the same hue, with no channel above 1.
Colour dimmed(Colour colour) { return colour / std::max(maxComponent(colour), 1.0F); }

std::shared_ptr<const Environment> dimmed(const std::shared_ptr<const Environment>& environment) {
    if (environment == nullptr) return nullptr;
    const float mean = luminance(environment->meanRadiance());
    if (!(mean > 0)) return environment;
    Environment copy = *environment;
    copy.intensity *= kMeanSurroundings / mean;
    return std::make_shared<const Environment>(std::move(copy));
}

} // namespace

Scene guideScene(const Scene& scene) {
    Scene guide = scene;
    guide.lights.clear();
    guide.ambient = kWhite;
    guide.background = dimmed(scene.background);
    for (auto& environment : guide.environments) environment = dimmed(environment);
    for (Material& material : guide.materials) material.emission = dimmed(material.emission);
    guide.fog.colour = guide.fog.emission = guide.fog.albedo = Colour{};
    guide.fog.surroundings = 0;
    return guide;
}

RenderSettings guideSettings(const RenderSettings& settings, GuideRays rays) {
    constexpr int kFew = 2, kUsual = 4, kThroughLens = 8; // each way
    RenderSettings guide = settings;
    guide.integrator = Integrator::Whitted;
    guide.antialiasing = rays == GuideRays::Few ? kFew : settings.depthOfField.on ? kThroughLens : kUsual;
    guide.sampling = SamplingPattern::Grid;
    guide.adaptive = 0;
    guide.maxDepth = kMaxDepth;
    guide.minContribution = kMinContribution;
    guide.ambientOcclusion.on = guide.skyLight.on = false;
    guide.fog.shafts = 0;
    return guide;
}

} // namespace rtcore

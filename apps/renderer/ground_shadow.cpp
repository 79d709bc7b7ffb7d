#include "renderer/ground_shadow.h"

#include "rtcore/post/effects.h"
#include "rtcore/render/ground_tracer.h"

#include <algorithm>
#include <utility>

namespace renderer {

namespace {

/// Nothing stands on the ground.
class NoSurfaces final : public rtcore::RayTracer {
  public:
    explicit NoSurfaces(const rtcore::Box3& bounds) : bounds_(bounds) {}

    void intersect(rtcore::RayKind /*kind*/, const rtcore::RayWave& rays,
                   rtcore::HitWave& hits) const override {
        rtcore::missAll(rays.size(), hits);
    }
    void occluded(rtcore::RayKind /*kind*/, const rtcore::RayWave& rays,
                  std::vector<std::uint8_t>& occluded) const override {
        occluded.assign(rays.size(), 0);
    }
    void findObstacles(const rtcore::RayWave& rays, std::span<const std::uint8_t> /*clear*/,
                       std::vector<rtcore::Obstacle>& found) const override {
        found.assign(rays.size(), rtcore::Obstacle::None);
    }
    rtcore::Box3 bounds() const override { return bounds_; }

  private:
    rtcore::Box3 bounds_;
};

rtcore::Scene withGroundOf(const ShadowWork& work) {
    constexpr float kAlbedo = 0.5F; // it only scales both images
    rtcore::Scene grounded = work.scene;
    if (grounded.ground) return grounded;
    if (!work.ground)
        work.ground = rtcore::makeGround(work.scene.model, work.scene.up, rtcore::kWhite * kAlbedo,
                                         rtcore::GroundEdge::Fades);
    grounded.ground = work.ground;
    return grounded;
}

/// By Whitted's rays, whose samples are the same whatever they meet, with soft light of the surroundings, and
/// without what is spread over pixels.
rtcore::RenderSettings shadowSettings(const rtcore::RenderSettings& settings, const rtcore::Scene& scene) {
    constexpr int kAcross = 4, kPasses = 3; // samples of a pixel, each way; of the filter
    rtcore::RenderSettings own = settings;
    own.integrator = rtcore::Integrator::Whitted;
    own.antialiasing = std::max(kAcross, settings.antialiasing);
    own.denoise.passes = std::max(kPasses, settings.denoise.passes);
    own.bloom.radius = 0;
    own.falseColours.on = false;
    own.fog.on = false;
    own.indirect.mode = rtcore::IndirectMode::Off;
    if (scene.environment() != nullptr) own.skyLight.on = true;
    return own;
}

bool renderGround(const ShadowWork& work, const rtcore::View& view, rtcore::Frame& frame) {
    const rtcore::ImageRequest request{.aovs = rtcore::effectsNeedAovs(view.settings),
                                       .background = rtcore::Background::Hidden};
    return work.images.of(view.settings.integrator).render(view, work.control, request, frame);
}

/// The part of the light that is left at a pixel, of which a part, `beside`, lies beside the ground.
float leftOf(float with, float without, float beside) {
    const float ratio = without > 0 ? std::clamp(with / without, 0.0F, 1.0F) : 1.0F;
    return beside + (1 - beside) * ratio;
}

} // namespace

rtcore::HdrImage groundShadow(const ShadowWork& work) {
    const rtcore::Scene scene = withGroundOf(work);
    const rtcore::RenderSettings settings = shadowSettings(work.settings, scene);
    const auto catching = [&](std::shared_ptr<const rtcore::RayTracer> surfaces) {
        return rtcore::GroundTracer(std::move(surfaces), scene.ground, rtcore::GroundRole::Catcher);
    };
    const rtcore::GroundTracer standing = catching(work.surfaces),
                               bare = catching(std::make_shared<const NoSurfaces>(work.surfaces->bounds()));
    const auto rendered = [&](const rtcore::GroundTracer& tracer, rtcore::Frame& frame) {
        rtcore::HdrImage image;
        if (renderGround(work, {scene, tracer, work.camera, settings}, frame))
            image = work.developer.finish(frame, settings, work.control.threads);
        return image;
    };
    rtcore::Frame frame;
    const rtcore::HdrImage with = rendered(standing, frame);
    if (with.empty()) return {};
    const rtcore::HdrImage without = rendered(bare, frame);
    if (without.empty()) return {};
    rtcore::HdrImage left(with.width, with.height);
    for (std::size_t i = 0; i < left.pixels.size(); ++i) {
        const rtcore::Colour a = with.pixels[i], b = without.pixels[i], beside = frame.transmitted.pixels[i];
        left.pixels[i] = {leftOf(a.r, b.r, beside.r), leftOf(a.g, b.g, beside.g), leftOf(a.b, b.b, beside.b)};
    }
    return left;
}

} // namespace renderer

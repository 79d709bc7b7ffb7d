#include "rtcore/render/sample_rays.h"

#include <algorithm>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/render/sample_rays.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/math/float3-inl.h"
#include "rtcore/render/panorama-inl.h"
#include "rtcore/sampling/disc-inl.h"

#ifndef RTCORE_RENDER_SAMPLE_BLOCK_
#define RTCORE_RENDER_SAMPLE_BLOCK_
namespace rtcore {
/// Block of 64 samples: positions in pixels and on the lens (its radius is 1), and their rays.
struct SampleBlock {
    static constexpr std::size_t kSize = 64;
    float x[kSize], y[kSize], u[kSize], v[kSize];
    float ox[kSize], oy[kSize], oz[kSize], dx[kSize], dy[kSize], dz[kSize];
};
} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

void aimParallel(const CameraRays& camera, SampleBlock& block) {
    const Float3 corner = broadcast(camera.plane().corner), right = broadcast(camera.plane().right),
                 down = broadcast(camera.plane().down), eye = broadcast(camera.eye()),
                 forward = broadcast(camera.forward());
    for (std::size_t i = 0; i < SampleBlock::kSize; i += lanes()) {
        const Float3 seen = corner + right * load(block.x + i) + down * load(block.y + i);
        store(eye + seen, block.ox + i, block.oy + i, block.oz + i);
        store(forward, block.dx + i, block.dy + i, block.dz + i);
    }
}

void aimAround(const CameraRays& camera, SampleBlock& block) {
    const Float3 eye = broadcast(camera.eye());
    for (std::size_t i = 0; i < SampleBlock::kSize; i += lanes()) {
        store(eye, block.ox + i, block.oy + i, block.oz + i);
        store(directionAround(camera.around(), load(block.x + i), load(block.y + i)), block.dx + i,
              block.dy + i, block.dz + i);
    }
}

/// `round`: places on the lens are points of the unit square yet.
void aimBlock(const CameraRays& camera, const Lens& lens, bool round, SampleBlock& block) {
    const Float3 corner = broadcast(camera.plane().corner), right = broadcast(camera.plane().right),
                 down = broadcast(camera.plane().down), eye = broadcast(camera.eye()),
                 lensRight = broadcast(lens.right), lensDown = broadcast(lens.down);
    const bool disc = round && lens.open();
    for (std::size_t i = 0; i < SampleBlock::kSize; i += lanes()) {
        Disc<Float> onLens{load(block.u + i), load(block.v + i)};
        if (disc) onLens = onDisc(onLens.x, onLens.y);
        const Float3 offset = lensRight * onLens.x - lensDown * onLens.y;
        const Float3 seen = corner + right * load(block.x + i) + down * load(block.y + i);
        // Towards the sharp point seen / inverseFocus from the eye, divided by its distance.
        const Float3 aimed = seen - offset * lens.inverseFocus;
        store(eye + offset, block.ox + i, block.oy + i, block.oz + i);
        store(normalize(aimed), block.dx + i, block.dy + i, block.dz + i);
    }
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(aimAround);
HWY_EXPORT(aimBlock);
HWY_EXPORT(aimParallel);

namespace {

void placeBlock(const SampleView& view, std::span<const SampleId> samples, SampleBlock& block) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const SampleId id = samples[i];
        const SquarePoint inPixel = view.pathSeed
                                        ? pointInSequence(id, *view.pathSeed, SampleDimension::Position, 0)
                                        : view.pattern.at(id);
        block.x[i] = static_cast<float>(id.x) + inPixel.u;
        block.y[i] = static_cast<float>(id.y) + inPixel.v;
    }
}

void placeOnLens(const SampleView& view, std::span<const SampleId> samples, SampleBlock& block) {
    SampleId last = samples.front();
    LensPattern::Pixel pixel = LensPattern::pixel(last.x, last.y);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const SampleId id = samples[i];
        if (id.x != last.x || id.y != last.y) pixel = LensPattern::pixel(id.x, id.y);
        last = id;
        const SquarePoint point = view.pathSeed
                                      ? pointInSequence(id, *view.pathSeed, SampleDimension::Lens, 0)
                                      : view.lensPattern.at(pixel, id.sub);
        const Vec2 onLens = view.aperture.round() ? Vec2{point.u, point.v} : view.aperture.at(point);
        block.u[i] = onLens.x;
        block.v[i] = onLens.y;
    }
}

} // namespace

void aimSamples(const View& view, FocusFinder& focus, SampleView& samples) {
    const auto width = static_cast<float>(view.settings.width);
    const auto height = static_cast<float>(view.settings.height);
    CameraRays& rays = samples.camera;
    rays = CameraRays(view.camera, view.settings.width, view.settings.height);
    samples.lens = {};
    const DepthOfFieldSettings& lens = view.settings.depthOfField;
    if (!lens.on || rays.parallel() || rays.panorama()) return; // these have no lens
    // Focus on the middle of the whole image, whichever part of it is rendered.
    const float distance =
        lens.focus > 0 ? lens.focus : focus.distance(view.tracer, rays, width * 0.5F, height * 0.5F);
    samples.lens =
        makeLens(rays, view.camera.horizontalFov, lens.fNumber, distance, view.scene.metresPerUnit);
    samples.aperture.prepare(lens.blades);
}

void makeSampleRays(const SampleView& view, std::span<const SampleId> samples, RayWave& rays) {
    rays.resize(samples.size());
    std::fill(rays.tMin.begin(), rays.tMin.end(), 0.0F);
    std::fill(rays.tMax.begin(), rays.tMax.end(), std::numeric_limits<float>::max());
    SampleBlock block{};
    for (std::size_t first = 0; first < samples.size(); first += SampleBlock::kSize) {
        const std::size_t count = std::min(SampleBlock::kSize, samples.size() - first);
        placeBlock(view, samples.subspan(first, count), block);
        if (view.lens.open()) placeOnLens(view, samples.subspan(first, count), block);
        if (view.camera.parallel()) {
            HWY_DYNAMIC_DISPATCH(aimParallel)(view.camera, block);
        } else if (view.camera.panorama()) {
            HWY_DYNAMIC_DISPATCH(aimAround)(view.camera, block);
        } else {
            HWY_DYNAMIC_DISPATCH(aimBlock)(view.camera, view.lens, view.aperture.round(), block);
        }
        std::copy_n(block.ox, count, &rays.ox[first]);
        std::copy_n(block.oy, count, &rays.oy[first]);
        std::copy_n(block.oz, count, &rays.oz[first]);
        std::copy_n(block.dx, count, &rays.dx[first]);
        std::copy_n(block.dy, count, &rays.dy[first]);
        std::copy_n(block.dz, count, &rays.dz[first]);
    }
}

} // namespace rtcore
#endif

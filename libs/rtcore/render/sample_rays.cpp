#include "rtcore/render/sample_rays.h"

#include <algorithm>
#include <limits>

#include "rtcore/platform/vector_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/render/sample_rays.cpp"
#include <hwy/foreach_target.h>
// The loop over targets comes before the code that is compiled for each of them.
#include "rtcore/shading/vector_math-inl.h"

#ifndef RTCORE_RENDER_SAMPLE_BLOCK_
#define RTCORE_RENDER_SAMPLE_BLOCK_
namespace rtcore {
/// Of 64 samples: places in pixels, on the lens (its radius is 1), and what becomes of them.
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

HWY_INLINE Vectors everywhere(Vec3 v) { return constant(v.x, v.y, v.z); }

/// onDisc(), with its bits.
HWY_INLINE void mapToDisc(Floats& u, Floats& v) {
    const Floats one = constant(1), a = hn::Sub(hn::Add(u, u), one), b = hn::Sub(hn::Add(v, v), one);
    const Lanes across = hn::Gt(hn::Abs(a), hn::Abs(b));
    const Floats r = hn::IfThenElse(across, a, b), other = hn::IfThenElse(across, b, a);
    const Floats angle = hn::Mul(constant(kDiscAngle), hn::Div(other, r));
    const Floats z = hn::Mul(angle, angle);
    const auto times = [z](Floats sum, float next) { return hn::Add(constant(next), hn::Mul(z, sum)); };
    Floats sine = constant(kDiscSine[0]), cosine = constant(kDiscCosine[0]);
    for (std::size_t i = 1; i < kDiscSine.size(); ++i) sine = times(sine, kDiscSine[i]);
    for (std::size_t i = 1; i < kDiscCosine.size(); ++i) cosine = times(cosine, kDiscCosine[i]);
    const Floats along = hn::Mul(r, cosine), aside = hn::Mul(r, hn::Mul(angle, sine));
    const Lanes out = hn::Ne(r, hn::Zero(FloatTag()));
    u = hn::IfThenElseZero(out, hn::IfThenElse(across, along, aside));
    v = hn::IfThenElseZero(out, hn::IfThenElse(across, aside, along));
}

void aimParallel(const CameraRays& camera, SampleBlock& block) {
    const FloatTag d;
    const Vectors corner = everywhere(camera.plane().corner), right = everywhere(camera.plane().right),
                  down = everywhere(camera.plane().down), eye = everywhere(camera.eye()),
                  forward = everywhere(camera.forward());
    for (std::size_t i = 0; i < SampleBlock::kSize; i += hn::Lanes(d)) {
        const Vectors seen = corner + right * hn::LoadU(d, block.x + i) + down * hn::LoadU(d, block.y + i);
        storeVectors(eye + seen, block.ox + i, block.oy + i, block.oz + i);
        storeVectors(forward, block.dx + i, block.dy + i, block.dz + i);
    }
}

/// `round`: places on the lens are points of the unit square yet.
void aimBlock(const CameraRays& camera, const Lens& lens, bool round, SampleBlock& block) {
    const FloatTag d;
    const Vectors corner = everywhere(camera.plane().corner), right = everywhere(camera.plane().right),
                  down = everywhere(camera.plane().down), eye = everywhere(camera.eye()),
                  lensRight = everywhere(lens.right), lensDown = everywhere(lens.down);
    const Floats inverseFocus = constant(lens.inverseFocus);
    const bool disc = round && lens.open();
    for (std::size_t i = 0; i < SampleBlock::kSize; i += hn::Lanes(d)) {
        Floats u = hn::LoadU(d, block.u + i), v = hn::LoadU(d, block.v + i);
        if (disc) mapToDisc(u, v);
        const Vectors offset = lensRight * u - lensDown * v;
        const Vectors seen = corner + right * hn::LoadU(d, block.x + i) + down * hn::LoadU(d, block.y + i);
        // Towards the sharp point seen / inverseFocus from the eye, divided by its distance.
        const Vectors aimed = seen - offset * inverseFocus;
        storeVectors(eye + offset, block.ox + i, block.oy + i, block.oz + i);
        storeVectors(normalize(aimed, hn::Eq(inverseFocus, inverseFocus)), block.dx + i, block.dy + i,
                     block.dz + i);
    }
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(aimBlock);
HWY_EXPORT(aimParallel);

namespace {

void placeBlock(const SampleView& view, std::span<const SampleId> samples, SampleBlock& block) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const SampleId id = samples[i];
        const SquarePoint inPixel = view.pattern.at(id);
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
        const SquarePoint point = view.lensPattern.at(pixel, id.sub);
        const Vec2 onLens = view.aperture.round() ? Vec2{point.u, point.v} : view.aperture.at(point);
        block.u[i] = onLens.x;
        block.v[i] = onLens.y;
    }
}

} // namespace

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

// Samples in vectors. Included once for each instruction set, inside the loop of foreach_target.h.
#include "rtcore/live/live_samples.h"
#include "rtcore/math/packed_light-inl.h"

#if defined(RTCORE_LIVE_LIVE_SAMPLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_LIVE_LIVE_SAMPLES_INL_H_
#undef RTCORE_LIVE_LIVE_SAMPLES_INL_H_
#else
#define RTCORE_LIVE_LIVE_SAMPLES_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// LiveSamples::Point
struct LivePoints {
    Float3 position;
    Uint state;

    HWY_INLINE explicit LivePoints(const LiveSamples::Point& first) {
        hn::Vec<FloatTag> bits;
        hn::LoadInterleaved4(FloatTag(), &first.position.x, position.x.raw, position.y.raw, position.z.raw,
                             bits);
        state = bitsOf(Float(bits));
    }
    HWY_INLINE Mask has(std::uint32_t bits) const { return (state & bits) != 0U; }
};

HWY_INLINE Uint statesOf(const LiveSamples::Point& first) { return LivePoints(first).state; }

/// LiveSamples::Light
HWY_INLINE Float3 radianceOf(const LiveSamples::Light& first) {
    hn::Vec<Uint::Tag> packed, clear, dark;
    hn::LoadInterleaved3(Uint::Tag(), &first.radiance, packed, clear, dark);
    return unpackedLight<Float>(Uint(packed));
}

/// LiveLayers::tints
HWY_INLINE Float3 tintOf(const std::uint32_t& first) { return unpackedLight<Float>(load(&first)); }

/// Where samples are seen in an image, in pixels from its upper left corner. `depth` along the axis of view,
/// with ImagePlane::addedDepth; 0 or less is behind the eye.
struct SeenAt {
    Float x, y, depth;
};
HWY_INLINE SeenAt seenInParallel(const LivePoints& points, const ImagePlane& plane) {
    const Float3 offset = points.position - broadcast(plane.eye + plane.corner);
    const Float depth = dot(offset, broadcast(plane.axis));
    return {dot(offset, broadcast(plane.column)), dot(offset, broadcast(plane.row)),
            select(points.has(LiveSamples::kBackground), Float(plane.addedDepth),
                   selectOrZero(depth > 0.0F, depth + plane.addedDepth))};
}
HWY_INLINE SeenAt seenAt(const LivePoints& points, const ImagePlane& plane) {
    if (plane.parallel) return seenInParallel(points, plane);
    const Mask background = points.has(LiveSamples::kBackground);
    const Float3 offset = points.position - selectOrZero(!background, broadcast(plane.eye));
    const Float depth = dot(offset, broadcast(plane.axis));
    return {dot(offset, broadcast(plane.column)) / depth, dot(offset, broadcast(plane.row)) / depth, depth};
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif

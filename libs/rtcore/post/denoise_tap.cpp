#include "rtcore/post/denoise_tap.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/post/denoise_tap.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/simd/wide-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

template <typename F>
HWY_INLINE F notNegative(F x) {
    return selectOrZero(x > 0.0F, x);
}

HWY_INLINE void loadAs(Float& value, const float* from) { value = load(from); }
HWY_INLINE void loadAs(float& value, const float* from) { value = *from; }
HWY_INLINE void store(float value, float* to) { *to = value; }

/// Adds the tap to the sums of pixel `x`, or of as many pixels from it on as F has lanes.
template <typename F>
HWY_INLINE void addPixels(const DenoiseTap& tap, std::size_t x) {
    const auto load = [x](const float* row) HWY_ATTR {
        F value;
        loadAs(value, row + x);
        return value;
    };
    const NoisyRow& p = tap.pixels;
    const NoisyRow& q = tap.neighbours;
    const F c1 = notNegative(load(p.normalX) * load(q.normalX) + load(p.normalY) * load(q.normalY) +
                             load(p.normalZ) * load(q.normalZ));
    const F c2 = c1 * c1, c4 = c2 * c2, c8 = c4 * c4, c16 = c8 * c8;

    const F nearness = load(p.nearness);
    const F slope = load(tap.across) * tap.stepX + load(tap.down) * tap.stepY;
    const F off = load(q.nearness) - (nearness + slope);
    const F within = tap.tolerance * nearness;
    const F square = within * within;
    const F inPlane = notNegative(square - off * off);
    // Anything that far away is background.
    const F plane = selectOrZero(square > 1e-30F, inPlane / square);

    const F unlike = (load(q.bright) - load(p.bright)) * load(tap.alike);
    const F light = notNegative(1.0F - unlike * unlike);

    const F weight = tap.kernel * (c16 * c16) * plane * (light * light);
    store(load(tap.weights) + weight, tap.weights + x);
    store(load(tap.red) + weight * load(q.red), tap.red + x);
    store(load(tap.green) + weight * load(q.green), tap.green + x);
    store(load(tap.blue) + weight * load(q.blue), tap.blue + x);
}

void addTapVectors(const DenoiseTap& tap, std::size_t count) {
    std::size_t x = 0;
    for (; x + lanes() <= count; x += lanes()) addPixels<Float>(tap, x);
    for (; x < count; ++x) addPixels<float>(tap, x);
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(addTapVectors);

void addTap(const DenoiseTap& tap, std::size_t count) { HWY_DYNAMIC_DISPATCH(addTapVectors)(tap, count); }

} // namespace rtcore
#endif

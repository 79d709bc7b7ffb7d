#include "rtcore/post/denoise_tap.h"

#include "rtcore/platform/vector_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/post/denoise_tap.cpp"
#include <hwy/foreach_target.h>
// The loop over targets comes before the code that is compiled for each of them.
#include "rtcore/shading/vector_math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

template <class Tag>
HWY_INLINE hn::Vec<Tag> notNegative(Tag d, hn::Vec<Tag> x) {
    return hn::IfThenElseZero(hn::Gt(x, hn::Zero(d)), x);
}

/// From pixel `x` on, for as many as `d` has lanes.
template <class Tag>
HWY_INLINE void addLanes(Tag d, const DenoiseTap& tap, std::size_t x) {
    using V = hn::Vec<Tag>;
    const auto load = [d, x](const float* row) HWY_ATTR { return hn::LoadU(d, row + x); };
    const GrainyRow& p = tap.pixels;
    const GrainyRow& q = tap.neighbours;
    const V dots =
        hn::Add(hn::Add(hn::Mul(load(p.normalX), load(q.normalX)), hn::Mul(load(p.normalY), load(q.normalY))),
                hn::Mul(load(p.normalZ), load(q.normalZ)));
    const V c1 = notNegative(d, dots);
    const V c2 = hn::Mul(c1, c1), c4 = hn::Mul(c2, c2), c8 = hn::Mul(c4, c4), c16 = hn::Mul(c8, c8);

    const V nearness = load(p.nearness);
    const V slope = hn::Add(hn::Mul(load(tap.across), hn::Set(d, tap.stepX)),
                            hn::Mul(load(tap.down), hn::Set(d, tap.stepY)));
    const V off = hn::Sub(load(q.nearness), hn::Add(nearness, slope));
    const V within = hn::Mul(hn::Set(d, tap.tolerance), nearness);
    const V square = hn::Mul(within, within);
    const V inPlane = notNegative(d, hn::Sub(square, hn::Mul(off, off)));
    // What is so far off is background.
    const V plane = hn::IfThenElseZero(hn::Gt(square, hn::Set(d, 1e-30F)), hn::Div(inPlane, square));

    const V unlike = hn::Mul(hn::Sub(load(q.bright), load(p.bright)), load(tap.alike));
    const V light = notNegative(d, hn::Sub(hn::Set(d, 1.0F), hn::Mul(unlike, unlike)));

    const V guided = hn::Mul(hn::Mul(hn::Set(d, tap.kernel), hn::Mul(c16, c16)), plane);
    const V weight = hn::Mul(guided, hn::Mul(light, light));
    hn::StoreU(hn::Add(load(tap.weights), weight), d, tap.weights + x);
    hn::StoreU(hn::Add(load(tap.red), hn::Mul(weight, load(q.red))), d, tap.red + x);
    hn::StoreU(hn::Add(load(tap.green), hn::Mul(weight, load(q.green))), d, tap.green + x);
    hn::StoreU(hn::Add(load(tap.blue), hn::Mul(weight, load(q.blue))), d, tap.blue + x);
}

void addTapVectors(const DenoiseTap& tap, std::size_t count) {
    const FloatTag d;
    const std::size_t lanes = hn::Lanes(d);
    std::size_t x = 0;
    for (; x + lanes <= count; x += lanes) addLanes(d, tap, x);
    for (; x < count; ++x) addLanes(hn::CappedTag<float, 1>(), tap, x);
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

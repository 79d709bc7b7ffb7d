// packed_light.h in each number type. Included once for each instruction set, inside the loop of
// foreach_target.h, or alone.
#include "rtcore/math/float3-inl.h"

#if defined(RTCORE_LIVE_PACKED_LIGHT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_LIVE_PACKED_LIGHT_INL_H_
#undef RTCORE_LIVE_PACKED_LIGHT_INL_H_
#else
#define RTCORE_LIVE_PACKED_LIGHT_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

inline constexpr std::uint32_t kLightBias = 15, kLightMantissaBits = 9;

template <typename F>
HWY_INLINE Vec3Of<F> unpackedLight(UintOf<F> packed) {
    // A float's bias in place of the exponent's own.
    constexpr std::uint32_t kRebias = 127 - kLightBias - kLightMantissaBits;
    const F scale = floatOf(shiftLeft<23>(shiftRight<27>(packed) + kRebias));
    const auto channel = [](UintOf<F> bits) { return toFloat(toInt(bits & 511U)); };
    return {channel(packed) * scale, channel(shiftRight<9>(packed)) * scale,
            channel(shiftRight<18>(packed)) * scale};
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif

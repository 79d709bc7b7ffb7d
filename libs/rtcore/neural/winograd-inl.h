// The transforms of Winograd's F(4 x 4, 3 x 3) in one axis, with the points 0, 1, -1, 2, -2 and infinity
// (Lavin and Gray 2016). Included once for each instruction set, inside the loop of foreach_target.h.
#include "rtcore/simd/wide-inl.h"

#if defined(RTCORE_NEURAL_WINOGRAD_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_NEURAL_WINOGRAD_INL_H_
#undef RTCORE_NEURAL_WINOGRAD_INL_H_
#else
#define RTCORE_NEURAL_WINOGRAD_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// B^T d of six pixels.
struct InputTransform {
    static constexpr int kPixels = 6, kPoints = 6;

    static HWY_INLINE void apply(const Float* d, Float* points) {
        const Float even = d[4] - 4.0F * d[2], odd = d[3] - 4.0F * d[1];
        const Float nearEven = d[4] - d[2], nearOdd = 2.0F * (d[3] - d[1]);
        points[0] = (4.0F * d[0] - 5.0F * d[2]) + d[4];
        points[1] = even + odd;
        points[2] = even - odd;
        points[3] = nearEven + nearOdd;
        points[4] = nearEven - nearOdd;
        points[5] = (4.0F * d[1] - 5.0F * d[3]) + d[5];
    }
};

/// The same of the pixels a, b, b, c, c, d of an upsampled image, from a, b, c, d; without the point -1,
/// where it is zero.
struct UpsampledInputTransform {
    static constexpr int kPixels = 4, kPoints = 5;

    static HWY_INLINE void apply(const Float* d, Float* points) {
        points[0] = (4.0F * d[0] - 5.0F * d[1]) + d[2];
        points[1] = 2.0F * (d[2] - 4.0F * d[1]);
        points[2] = 3.0F * (d[2] - d[1]);
        points[3] = d[1] - d[2];
        points[4] = (4.0F * d[1] - 5.0F * d[2]) + d[3];
    }
};

/// A^T m of six points: four pixels.
HWY_INLINE void outputTransform(const Float* m, Float* pixels) {
    const Float sum = m[1] + m[2], difference = m[1] - m[2];
    const Float farSum = m[3] + m[4], farDifference = m[3] - m[4];
    pixels[0] = (m[0] + sum) + farSum;
    pixels[1] = difference + 2.0F * farDifference;
    pixels[2] = sum + 4.0F * farSum;
    pixels[3] = (difference + 8.0F * farDifference) + m[5];
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif

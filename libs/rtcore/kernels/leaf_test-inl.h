// One triangle against a vector of rays: watertight.h, with the same bits. Included once for each target.
#if defined(RTCORE_KERNELS_LEAF_TEST_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_KERNELS_LEAF_TEST_INL_H_
#undef RTCORE_KERNELS_LEAF_TEST_INL_H_
#else
#define RTCORE_KERNELS_LEAF_TEST_INL_H_
#endif

#include "rtcore/kernels/wave_kernels.h"

#include <hwy/highway.h>

#include <bit>
#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = hn::ScalableTag<float>;
using IntTag = hn::ScalableTag<std::int32_t>;
using ByteTag = hn::ScalableTag<std::uint8_t>;
using Floats = hn::Vec<FloatTag>;
using Ints = hn::Vec<IntTag>;
using Bytes = hn::Vec<ByteTag>;
using Lanes = hn::Mask<FloatTag>; ///< which lanes something holds for
constexpr std::size_t kLanes = hn::MaxLanes(FloatTag());

/// While a kernel works, "no triangle" is the largest index, so that comparisons of signed numbers order it.
constexpr std::int32_t kNone = std::numeric_limits<std::int32_t>::max();

/// What the rays of a packet have in common, which decides how corners are brought to them.
enum class Shared {
    Origin, ///< the origin and the dominant axis
    Axis,   ///< the dominant axis
    Nothing
};

/// Where the corners of a reference's triangle are, and its index.
struct Corners {
    const float *a, *b, *c;
    std::int32_t triangle;
};

HWY_INLINE Corners cornersOf(const KernelScene& scene, std::uint32_t reference) {
    if (scene.records != nullptr) {
        const Vertex* const record = scene.records + std::size_t{reference} * 3;
        return {&record[0].x, &record[1].x, &record[2].x,
                std::bit_cast<std::int32_t>(record[0].unused)};
    }
    const std::uint32_t index = scene.references[reference];
    const Triangle& triangle = scene.triangles[index];
    return {&scene.vertices[triangle.v[0]].x, &scene.vertices[triangle.v[1]].x,
            &scene.vertices[triangle.v[2]].x, static_cast<std::int32_t>(index)};
}

/// The dominant axis of each lane as RayShear chooses it, and how to bring the coordinates of a vector (x, y,
/// z, -) into the order (kx, ky, kz).
struct AxisOrder {
    Bytes x, y, z; ///< for TableLookupBytes
    Lanes isX, isY;

    HWY_INLINE AxisOrder(Floats dx, Floats dy, Floats dz) {
        const IntTag di;
        const Floats ax = hn::Abs(dx);
        const Floats ay = hn::Abs(dy);
        const Floats az = hn::Abs(dz);
        isX = hn::And(hn::Gt(ax, ay), hn::Gt(ax, az));
        isY = hn::AndNot(hn::Gt(ax, ay), hn::Gt(ay, az));
        // Byte positions of one coordinate's float inside its vertex.
        constexpr std::int32_t kX = 0x03020100;
        constexpr std::int32_t kY = 0x07060504;
        constexpr std::int32_t kZ = 0x0B0A0908;
        const auto order = [&](std::int32_t forX, std::int32_t forY, std::int32_t forZ) HWY_ATTR {
            const Ints i = hn::IfThenElse(hn::RebindMask(di, isX), hn::Set(di, forX),
                                          hn::IfThenElse(hn::RebindMask(di, isY), hn::Set(di, forY),
                                                         hn::Set(di, forZ)));
            return hn::BitCast(ByteTag(), i);
        };
        x = order(kY, kZ, kX);
        y = order(kZ, kX, kY);
        z = order(kX, kY, kZ);
    }
    HWY_INLINE Floats choose(Floats forX, Floats forY, Floats forZ) const {
        return hn::IfThenElse(isX, forX, hn::IfThenElse(isY, forY, forZ));
    }
};

/// A vector of rays as the leaf test wants them: origin and shear in the order of the dominant axis.
struct ShearedRays {
    Floats x, y, z;
    Floats sx, sy, sz;
};

HWY_INLINE ShearedRays shear(const AxisOrder& order, Floats ox, Floats oy, Floats oz, Floats dx, Floats dy,
                             Floats dz) {
    const Floats along = order.choose(dx, dy, dz);
    return {order.choose(oy, oz, ox),
            order.choose(oz, ox, oy),
            order.choose(ox, oy, oz),
            hn::Div(order.choose(dy, dz, dx), along),
            hn::Div(order.choose(dz, dx, dy), along),
            hn::Div(hn::Set(FloatTag(), 1.0F), along)};
}

/// What the test of one triangle says of each lane.
struct Outcome {
    Lanes inside; ///< the ray's line meets the triangle
    Floats t;     ///< where; NaN or any other number outside
    Floats v, w, det;
};

/// Corner minus origin in the order of the dominant axis.
struct Offset {
    Floats x, y, z;
};

HWY_INLINE Outcome edgeTest(Offset a, Offset b, Offset c, const ShearedRays& rays) {
    const FloatTag d;
    const Floats ax = hn::Sub(a.x, hn::Mul(rays.sx, a.z));
    const Floats ay = hn::Sub(a.y, hn::Mul(rays.sy, a.z));
    const Floats bx = hn::Sub(b.x, hn::Mul(rays.sx, b.z));
    const Floats by = hn::Sub(b.y, hn::Mul(rays.sy, b.z));
    const Floats cx = hn::Sub(c.x, hn::Mul(rays.sx, c.z));
    const Floats cy = hn::Sub(c.y, hn::Mul(rays.sy, c.z));
    const Floats u = hn::Sub(hn::Mul(cx, by), hn::Mul(cy, bx));
    const Floats v = hn::Sub(hn::Mul(ax, cy), hn::Mul(ay, cx));
    const Floats w = hn::Sub(hn::Mul(bx, ay), hn::Mul(by, ax));
    const Floats zero = hn::Zero(d);
    const Lanes front = hn::Ge(hn::Min(hn::Min(u, v), w), zero);
    const Lanes back = hn::Le(hn::Max(hn::Max(u, v), w), zero);
    const Floats det = hn::Add(hn::Add(u, v), w);
    const Lanes seen = hn::Ge(hn::Abs(det), hn::Set(d, std::numeric_limits<float>::min()));
    const Floats sum = hn::Add(hn::Add(hn::Mul(u, a.z), hn::Mul(v, b.z)), hn::Mul(w, c.z));
    return {hn::And(hn::Or(front, back), seen), hn::Div(hn::Mul(sum, rays.sz), det), v, w, det};
}

/// Corners at the rays of a packet that share their dominant axis `kz`.
HWY_INLINE Offset offsetAlong(const float* corner, int kx, int ky, int kz, const ShearedRays& rays) {
    const FloatTag d;
    return {hn::Sub(hn::Set(d, corner[kx]), rays.x), hn::Sub(hn::Set(d, corner[ky]), rays.y),
            hn::Sub(hn::Set(d, corner[kz]), rays.z)};
}

/// Corners at rays of any axis.
HWY_INLINE Offset offsetEach(const float* corner, const AxisOrder& order, const ShearedRays& rays) {
    const FloatTag d;
    const Bytes all = hn::BitCast(ByteTag(), hn::LoadDup128(d, corner));
    return {hn::Sub(hn::BitCast(d, hn::TableLookupBytes(all, order.x)), rays.x),
            hn::Sub(hn::BitCast(d, hn::TableLookupBytes(all, order.y)), rays.y),
            hn::Sub(hn::BitCast(d, hn::TableLookupBytes(all, order.z)), rays.z)};
}

/// The smaller of both; the second where either is not a number.
HWY_INLINE Floats smaller(Floats a, Floats b) {
#if HWY_ARCH_X86
    return hn::Min(a, b);
#else
    return hn::IfThenElse(hn::Lt(a, b), a, b);
#endif
}

/// The larger of both; the second where either is not a number.
HWY_INLINE Floats larger(Floats a, Floats b) {
#if HWY_ARCH_X86
    return hn::Max(a, b);
#else
    return hn::IfThenElse(hn::Gt(a, b), a, b);
#endif
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif

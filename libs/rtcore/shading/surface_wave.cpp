#include "rtcore/shading/surface_wave.h"

#include <algorithm>
#include <iterator>

#include "rtcore/platform/vector_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/shading/surface_wave.cpp"
#include <hwy/foreach_target.h>
// The loop over targets comes before the code that is compiled for each of them.
#include "rtcore/shading/vector_math-inl.h"

#ifndef RTCORE_SHADING_SURFACE_WAVE_TYPES
#define RTCORE_SHADING_SURFACE_WAVE_TYPES
namespace rtcore {

/// What is looked up for a hit.
struct SurfaceSources {
    const Vertex* vertices;
    const Triangle* triangles;
    const ShadingTriangle* shading;
    const Vec3* normals;
    const MaterialRow* rows;
};

/// The rays and hits of one block, with room for a whole one: beyond the last, nothing is hit.
struct BlockRays {
    const float *dx, *dy, *dz, *u, *v;
    const std::uint32_t* triangle;
};

} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

struct Corners {
    Vectors a, b, c;
};

HWY_INLINE Vectors everywhere(const float* HWY_RESTRICT v) { return constant(v[0], v[1], v[2]); }

/// What consecutive rays hit.
struct Found {
    Corners position, normal;
    Vectors diffuse;
    Bits traits, material;
};

/// The same triangle for all.
HWY_INLINE Found lookUp(const SurfaceSources& from, std::uint32_t t) {
    const BitsTag du;
    const Triangle& triangle = from.triangles[t];
    const ShadingTriangle& shading = from.shading[t];
    const MaterialRow& row = from.rows[shading.material];
    const auto vertex = [&](std::size_t i) { return everywhere(&from.vertices[triangle.v[i]].x); };
    const auto normal = [&](std::size_t i) { return everywhere(&from.normals[shading.v[i]].x); };
    return {{vertex(0), vertex(1), vertex(2)},
            {normal(0), normal(1), normal(2)},
            everywhere(row.diffuse),
            hn::Set(du, row.traits),
            hn::Set(du, shading.material)};
}

HWY_INLINE Corners select(Lanes lanes, const Corners& a, const Corners& b) {
    return {select(lanes, a.a, b.a), select(lanes, a.b, b.b), select(lanes, a.c, b.c)};
}
HWY_INLINE Bits select(Lanes lanes, Bits a, Bits b) {
    const FloatTag d;
    return hn::BitCast(BitsTag(), hn::IfThenElse(lanes, hn::BitCast(d, a), hn::BitCast(d, b)));
}

HWY_INLINE Lanes lanesOf(decltype(hn::Eq(Bits(), Bits())) mask) {
    return hn::MaskFromVec(hn::BitCast(FloatTag(), hn::VecFromMask(BitsTag(), mask)));
}

HWY_INLINE void storeAt(Vectors v, const ArraysOf3& arrays, std::size_t at) {
    storeVectors(v, arrays.x + at, arrays.y + at, arrays.z + at);
}

HWY_INLINE Vectors interpolate(const Corners& corners, Floats u, Floats v) {
    const Floats w = hn::Sub(hn::Sub(constant(1), u), v);
    return corners.a * w + corners.b * u + corners.c * v;
}

HWY_INLINE Floats largestOf(Floats a, Floats b, Floats c) {
    return larger(hn::Abs(a), larger(hn::Abs(b), hn::Abs(c)));
}

/// surface.h
HWY_INLINE Lanes normalsBehind(const Corners& normals, Vectors front) {
    return hn::Lt(dot(normals.a + normals.b + normals.c, front), constant(kNormalsBehind));
}

/// math/ray_offset.h
HWY_INLINE Floats clearanceOf(const Corners& p, Vectors normal) {
    const Vectors extent{largestOf(p.a.x, p.b.x, p.c.x), largestOf(p.a.y, p.b.y, p.c.y),
                         largestOf(p.a.z, p.b.z, p.c.z)};
    const Floats across = dot(extent, {hn::Abs(normal.x), hn::Abs(normal.y), hn::Abs(normal.z)});
    const Floats most = larger(extent.x, larger(extent.y, extent.z));
    return hn::Mul(hn::Add(hn::Mul(constant(4), across), most), constant(0x1p-20F));
}

/// The surfaces of a block; elements from `first` on of `wave`. Appends the points that are not plain to
/// `notPlain`, which has room for a vector more, and returns how many.
std::size_t fillBlock(const SurfaceSources& sources, const BlockRays& rays, std::size_t first,
                      SurfaceWave& wave, std::uint32_t* HWY_RESTRICT notPlain) {
    const FloatTag d;
    const BitsTag du;
    const Floats zero = hn::Zero(d);
    const Bits lane = hn::Iota(du, 0);
    std::size_t notPlainCount = 0;
    std::uint32_t known = kNoTriangle; // whose normal and clearance these are
    Vectors front = constant(0, 0, 0);
    Lanes behind = hn::Lt(zero, zero);
    Floats clearance = zero;
    for (std::size_t i = 0; i < kWaveBlock; i += hn::Lanes(d)) {
        const std::size_t at = first + i;
        const Bits hit = hn::LoadU(du, rays.triangle + i);
        const Lanes used = lanesOf(hn::Ne(hit, hn::Set(du, kNoTriangle)));
        if (hn::AllFalse(d, used)) {
            hn::StoreU(hn::Zero(du), du, wave.traits + at);
            continue;
        }
        // Neighbours hit few triangles: one after another, and each for all of its rays at once.
        std::uint32_t triangle = rays.triangle[i + static_cast<std::size_t>(hn::FindFirstTrue(d, used))];
        Found found = lookUp(sources, triangle);
        Lanes rest = hn::And(used, lanesOf(hn::Ne(hit, hn::Set(du, triangle))));
        const bool same = hn::AllFalse(d, rest);
        while (!hn::AllFalse(d, rest)) {
            triangle = rays.triangle[i + static_cast<std::size_t>(hn::FindFirstTrue(d, rest))];
            const Lanes these = lanesOf(hn::Eq(hit, hn::Set(du, triangle)));
            const Found next = lookUp(sources, triangle);
            found = {select(these, next.position, found.position), select(these, next.normal, found.normal),
                     select(these, next.diffuse, found.diffuse), select(these, next.traits, found.traits),
                     select(these, next.material, found.material)};
            rest = hn::AndNot(these, rest);
        }
        const Bits traits = select(used, found.traits, hn::Zero(du));
        hn::StoreU(traits, du, wave.traits + at);
        hn::StoreU(found.material, du, wave.material + at);
        storeAt(found.diffuse, wave.diffuse, at);
        const Lanes special = lanesOf(hn::Ne(hn::And(traits, hn::Set(du, traits::kNotPlain)), hn::Zero(du)));
        if (!hn::AllFalse(d, special)) {
            const Bits index = hn::Add(lane, hn::Set(du, static_cast<std::uint32_t>(at)));
            const Floats some = hn::Compress(hn::BitCast(d, index), special);
            hn::StoreU(hn::BitCast(du, some), du, notPlain + notPlainCount);
            notPlainCount += hn::CountTrue(d, special);
        }

        const Floats u = hn::LoadU(d, rays.u + i);
        const Floats v = hn::LoadU(d, rays.v + i);
        const Corners& p = found.position;
        storeAt(interpolate(p, u, v), wave.position, at);
        if (!same || triangle != known) {
            front = normalize(cross(p.b - p.a, p.c - p.a), used);
            behind = normalsBehind(found.normal, front);
            clearance = clearanceOf(p, front);
            known = same ? triangle : kNoTriangle;
        }
        hn::StoreU(clearance, d, wave.clearance + at);
        const Vectors direction = loadVectors(rays.dx + i, rays.dy + i, rays.dz + i);
        const Lanes inside = hn::Gt(dot(front, direction), zero);
        const Vectors geometric = negateWhere(inside, front);
        storeAt(geometric, wave.geometricNormal, at);
        storeAt({hn::Neg(direction.x), hn::Neg(direction.y), hn::Neg(direction.z)}, wave.toViewer, at);

        const Vectors normal = normalize(interpolate(found.normal, u, v), used);
        const Vectors shading = negateWhere(hn::Xor(inside, behind), normal);
        storeAt(select(isZero(normal), geometric, shading), wave.shadingNormal, at);
    }
    return notPlainCount;
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(fillBlock);

namespace {

/// The rest of a wave that does not fill a block, copied to where a whole one may be read.
class LastRays {
  public:
    BlockRays copy(const BlockRays& from, std::size_t count) {
        const float* const arrays[] = {from.dx, from.dy, from.dz, from.u, from.v};
        for (std::size_t i = 0; i < 5; ++i) std::copy_n(arrays[i], count, values_[i]);
        std::fill_n(std::copy_n(from.triangle, count, triangles_), kWaveBlock - count, kNoTriangle);
        return {values_[0], values_[1], values_[2], values_[3], values_[4], triangles_};
    }

  private:
    float values_[5][kWaveBlock] = {};
    std::uint32_t triangles_[kWaveBlock];
};

} // namespace

void SurfaceWave::resize(std::size_t count) {
    size_ = count;
    ArraysOf3* const vectors[] = {&position, &geometricNormal, &shadingNormal, &toViewer,
                                  &diffuse,  &share,           &onward,        &added};
    memory_.resize(3 * std::size(vectors) + 1, count);
    std::size_t next = 0;
    for (ArraysOf3* const v : vectors) {
        v->x = memory_.array(next++);
        v->y = memory_.array(next++);
        v->z = memory_.array(next++);
    }
    clearance = memory_.array(next++);
    if (traits_.size() < count + kWaveBlock) {
        traits_.resize(count + kWaveBlock);
        materials_.resize(count + kWaveBlock);
    }
    traits = traits_.data();
    material = materials_.data();
    if (notPlain_.size() < count + kWaveBlock) notPlain_.resize(count + kWaveBlock);
}

void SurfaceWave::fill(const Mesh& mesh, const MaterialTable& materials, const RayWave& rays,
                       const HitWave& hits) {
    resize(rays.size());
    const SurfaceSources sources{mesh.vertices.data(), mesh.triangles.data(), mesh.shading.data(),
                                 mesh.normals.data(), materials.rows()};
    notPlainCount_ = 0;
    LastRays last;
    for (std::size_t first = 0; first < size_; first += kWaveBlock) {
        const std::size_t count = std::min(kWaveBlock, size_ - first);
        BlockRays block{rays.dx.data() + first, rays.dy.data() + first, rays.dz.data() + first,
                        hits.u.data() + first,  hits.v.data() + first,  hits.triangle.data() + first};
        if (count < kWaveBlock) block = last.copy(block, count);
        notPlainCount_ +=
            HWY_DYNAMIC_DISPATCH(fillBlock)(sources, block, first, *this, notPlain_.data() + notPlainCount_);
    }
}

} // namespace rtcore
#endif

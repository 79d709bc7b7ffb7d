#include "rtcore/shading/surface_wave.h"

#include <algorithm>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/shading/surface_wave.cpp"
#define HWY_DISABLED_TARGETS HWY_SSSE3
#include <hwy/foreach_target.h>
// The loop over targets comes before the code that is compiled for each of them.
#include "rtcore/shading/vector_math-inl.h"

#ifndef RTCORE_SHADING_SURFACE_CORNERS
#define RTCORE_SHADING_SURFACE_CORNERS
namespace rtcore {

/// The corners of the triangles of one block, four floats each, as loads that split them want them.
struct BlockCorners {
    alignas(64) float position[3][4 * kWaveBlock];
    alignas(64) float normal[3][4 * kWaveBlock];
    alignas(64) float diffuse[4 * kWaveBlock]; ///< the fourth: traits
};

/// What rays and hits of one block are, with room for a whole block.
struct BlockRays {
    const float *dx, *dy, *dz, *u, *v;
};

} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

struct Corners {
    Vectors a, b, c;
};

HWY_INLINE Vectors loadCorner(const float* HWY_RESTRICT corner) {
    Vectors v;
    Floats unused;
    hn::LoadInterleaved4(FloatTag(), corner, v.x, v.y, v.z, unused);
    return v;
}

HWY_INLINE Vectors interpolate(const Corners& corners, Floats u, Floats v) {
    const Floats w = hn::Sub(hn::Sub(constant(1), u), v);
    return corners.a * w + corners.b * u + corners.c * v;
}

HWY_INLINE Floats largestOf(Floats a, Floats b, Floats c) {
    return larger(hn::Abs(a), larger(hn::Abs(b), hn::Abs(c)));
}

/// math/ray_offset.h
HWY_INLINE Floats clearanceOf(const Corners& p, Vectors normal) {
    const Vectors extent{largestOf(p.a.x, p.b.x, p.c.x), largestOf(p.a.y, p.b.y, p.c.y),
                         largestOf(p.a.z, p.b.z, p.c.z)};
    const Floats across = dot(extent, {hn::Abs(normal.x), hn::Abs(normal.y), hn::Abs(normal.z)});
    const Floats most = larger(extent.x, larger(extent.y, extent.z));
    return hn::Mul(hn::Add(hn::Mul(constant(4), across), most), constant(0x1p-20F));
}

/// The surfaces of a block from its corners; elements from `first` on of `wave`.
void fillBlock(const BlockCorners& block, const BlockRays& rays, std::size_t first, SurfaceWave& wave) {
    const FloatTag d;
    const BitsTag du;
    for (std::size_t i = 0; i < kWaveBlock; i += hn::Lanes(d)) {
        const std::size_t at = first + i;
        Vectors diffuse;
        Floats traits;
        hn::LoadInterleaved4(d, block.diffuse + 4 * i, diffuse.x, diffuse.y, diffuse.z, traits);
        hn::StoreU(hn::BitCast(du, traits), du, wave.traits + at);
        const Lanes used = hn::MaskFromVec(
            hn::BitCast(d, hn::VecFromMask(du, hn::Ne(hn::BitCast(du, traits), hn::Zero(du)))));
        if (hn::AllFalse(d, used)) continue;
        storeVectors(diffuse, wave.diffuse.x + at, wave.diffuse.y + at, wave.diffuse.z + at);

        const Floats u = hn::LoadU(d, rays.u + i);
        const Floats v = hn::LoadU(d, rays.v + i);
        const Corners p{loadCorner(block.position[0] + 4 * i), loadCorner(block.position[1] + 4 * i),
                        loadCorner(block.position[2] + 4 * i)};
        storeVectors(interpolate(p, u, v), wave.position.x + at, wave.position.y + at, wave.position.z + at);

        Vectors geometric = normalize(cross(p.b - p.a, p.c - p.a), used);
        hn::StoreU(clearanceOf(p, geometric), d, wave.clearance + at);
        const Vectors direction = loadVectors(rays.dx + i, rays.dy + i, rays.dz + i);
        const Floats zero = hn::Zero(d);
        geometric = negateWhere(hn::Gt(dot(geometric, direction), zero), geometric);
        storeVectors(geometric, wave.geometricNormal.x + at, wave.geometricNormal.y + at,
                     wave.geometricNormal.z + at);
        storeVectors({hn::Neg(direction.x), hn::Neg(direction.y), hn::Neg(direction.z)}, wave.toViewer.x + at,
                     wave.toViewer.y + at, wave.toViewer.z + at);

        const Corners n{loadCorner(block.normal[0] + 4 * i), loadCorner(block.normal[1] + 4 * i),
                        loadCorner(block.normal[2] + 4 * i)};
        Vectors shading = normalize(interpolate(n, u, v), used);
        shading = select(isZero(shading), geometric, shading);
        shading = negateWhere(hn::Lt(dot(shading, geometric), zero), shading);
        storeVectors(shading, wave.shadingNormal.x + at, wave.shadingNormal.y + at,
                     wave.shadingNormal.z + at);
    }
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(fillBlock);

namespace {

/// Copies what the hits [first, first + count) of a wave need; returns whether there are any.
bool collectCorners(const Mesh& mesh, const MaterialTable& materials, const HitWave& hits, std::size_t first,
                    std::size_t count, BlockCorners& block, std::uint32_t* material,
                    std::vector<std::uint32_t>& notPlain) {
    constexpr std::size_t kVertexBytes = 16, kNormalBytes = 12;
    const MaterialRow* const rows = materials.rows();
    const std::uint32_t* const hit = hits.triangle.data() + first;
    bool any = false;
    for (std::size_t i = 0; i < count; ++i) {
        float* const diffuse = block.diffuse + 4 * i;
        if (hit[i] == kNoTriangle) {
            std::memset(diffuse, 0, sizeof(float) * 4);
            continue;
        }
        any = true;
        const Triangle& triangle = mesh.triangles[hit[i]];
        const ShadingTriangle& shading = mesh.shading[hit[i]];
        for (std::size_t corner = 0; corner < 3; ++corner) {
            std::memcpy(block.position[corner] + 4 * i, &mesh.vertices[triangle.v[corner]], kVertexBytes);
            std::memcpy(block.normal[corner] + 4 * i, &mesh.normals[shading.v[corner]], kNormalBytes);
        }
        const MaterialRow& row = rows[shading.material];
        std::memcpy(diffuse, row.diffuse, sizeof(float) * 4);
        material[first + i] = shading.material;
        if ((row.traits & traits::kNotPlain) != 0) notPlain.push_back(static_cast<std::uint32_t>(first + i));
    }
    for (std::size_t i = count; i < kWaveBlock; ++i) std::memset(block.diffuse + 4 * i, 0, sizeof(float) * 4);
    return any;
}

/// The rest of a wave that does not fill a block, copied to where a whole one may be read.
class LastRays {
  public:
    BlockRays copy(const BlockRays& from, std::size_t count) {
        const float* const arrays[] = {from.dx, from.dy, from.dz, from.u, from.v};
        for (std::size_t i = 0; i < 5; ++i) std::copy_n(arrays[i], count, values_[i]);
        return {values_[0], values_[1], values_[2], values_[3], values_[4]};
    }

  private:
    float values_[5][kWaveBlock] = {};
};

} // namespace

void SurfaceWave::resize(std::size_t count) {
    size_ = count;
    ArraysOf3* const vectors[] = {&position, &geometricNormal, &shadingNormal, &toViewer,
                                  &diffuse,  &share,           &added};
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
    notPlain_.clear();
    notPlain_.reserve(count);
}

void SurfaceWave::fill(const Mesh& mesh, const MaterialTable& materials, const RayWave& rays,
                       const HitWave& hits) {
    resize(rays.size());
    BlockCorners block;
    std::memset(&block, 0, sizeof block);
    for (std::size_t first = 0; first < size_; first += kWaveBlock) {
        const std::size_t count = std::min(kWaveBlock, size_ - first);
        if (!collectCorners(mesh, materials, hits, first, count, block, material, notPlain_)) {
            std::fill_n(traits + first, kWaveBlock, 0U);
            continue;
        }
        const BlockRays ofBlock{rays.dx.data() + first, rays.dy.data() + first, rays.dz.data() + first,
                                hits.u.data() + first, hits.v.data() + first};
        if (count == kWaveBlock) {
            HWY_DYNAMIC_DISPATCH(fillBlock)(block, ofBlock, first, *this);
        } else {
            LastRays last;
            HWY_DYNAMIC_DISPATCH(fillBlock)(block, last.copy(ofBlock, count), first, *this);
        }
    }
}

} // namespace rtcore
#endif

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

/// Rays that often hit one and the same triangle; no vector is longer.
inline constexpr std::size_t kGroup = 16;

/// The corners of the triangles of one block, four floats each, as loads that split them want them.
struct BlockCorners {
    alignas(64) float position[3][4 * kWaveBlock];
    alignas(64) float normal[3][4 * kWaveBlock];
    alignas(64) float diffuse[4 * kWaveBlock]; ///< the fourth: traits
    /// What all rays of a group hit, and then only its first element is set; kNoTriangle: they differ.
    std::uint32_t shared[kWaveBlock / kGroup];
    std::uint32_t traits; ///< of any point
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

/// Values of consecutive rays, or the same one for all.
HWY_INLINE Vectors loadCorner(const float* HWY_RESTRICT corner, bool shared) {
    if (shared) return constant(corner[0], corner[1], corner[2]);
    Vectors v;
    Floats unused;
    hn::LoadInterleaved4(FloatTag(), corner, v.x, v.y, v.z, unused);
    return v;
}

HWY_INLINE Corners loadCorners(const float (&corners)[3][4 * kWaveBlock], std::size_t i, bool shared) {
    return {loadCorner(corners[0] + 4 * i, shared), loadCorner(corners[1] + 4 * i, shared),
            loadCorner(corners[2] + 4 * i, shared)};
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
    const Floats zero = hn::Zero(d);
    const bool viewed = (block.traits & (traits::kGlossy | traits::kMirror | traits::kGeneral)) != 0;
    std::uint32_t known = kNoTriangle; // whose normal and clearance these are
    Vectors front = constant(0, 0, 0);
    Floats clearance = zero;
    for (std::size_t i = 0; i < kWaveBlock; i += hn::Lanes(d)) {
        const std::size_t at = first + i;
        const std::uint32_t triangle = block.shared[i / kGroup];
        const bool shared = triangle != kNoTriangle;
        const std::size_t from = shared ? i / kGroup * kGroup : i;
        Vectors diffuse;
        Bits traits;
        if (shared) {
            diffuse = loadCorner(block.diffuse + 4 * from, true);
            std::uint32_t bits = 0;
            hwy::CopyBytes<sizeof bits>(block.diffuse + 4 * from + 3, &bits);
            traits = hn::Set(du, bits);
        } else {
            Floats bits;
            hn::LoadInterleaved4(d, block.diffuse + 4 * i, diffuse.x, diffuse.y, diffuse.z, bits);
            traits = hn::BitCast(du, bits);
        }
        hn::StoreU(traits, du, wave.traits + at);
        const Lanes used =
            hn::MaskFromVec(hn::BitCast(d, hn::VecFromMask(du, hn::Ne(traits, hn::Zero(du)))));
        if (hn::AllFalse(d, used)) continue;
        storeAt(diffuse, wave.diffuse, at);

        const Floats u = hn::LoadU(d, rays.u + i);
        const Floats v = hn::LoadU(d, rays.v + i);
        const Corners p = loadCorners(block.position, from, shared);
        storeAt(interpolate(p, u, v), wave.position, at);

        if (!shared || triangle != known) {
            front = normalize(cross(p.b - p.a, p.c - p.a), used);
            clearance = clearanceOf(p, front);
            known = triangle;
        }
        hn::StoreU(clearance, d, wave.clearance + at);
        const Vectors direction = loadVectors(rays.dx + i, rays.dy + i, rays.dz + i);
        const Vectors geometric = negateWhere(hn::Gt(dot(front, direction), zero), front);
        storeAt(geometric, wave.geometricNormal, at);
        if (viewed) storeAt({hn::Neg(direction.x), hn::Neg(direction.y), hn::Neg(direction.z)}, wave.toViewer, at);

        Vectors shading = normalize(interpolate(loadCorners(block.normal, from, shared), u, v), used);
        shading = select(isZero(shading), geometric, shading);
        shading = negateWhere(hn::Lt(dot(shading, geometric), zero), shading);
        storeAt(shading, wave.shadingNormal, at);
    }
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(fillBlock);

namespace {

bool allEqual(const std::uint32_t* hits) {
    std::uint32_t difference = 0;
    for (std::size_t i = 1; i < kGroup; ++i) difference |= hits[i] ^ hits[0];
    return difference == 0;
}

/// Copies what blocks of hits need to where vector code loads it.
class CornerCollector {
  public:
    /// `material` has room for whole blocks, `notPlain` for one number more than there are hits.
    CornerCollector(const Mesh& mesh, const MaterialTable& materials, const HitWave& hits,
                    std::uint32_t* material, std::uint32_t* notPlain)
        : vertices_(mesh.vertices.data()), normals_(mesh.normals.data()), triangles_(mesh.triangles.data()),
          shading_(mesh.shading.data()), rows_(materials.rows()), hits_(hits.triangle.data()),
          count_(hits.size()), material_(material), notPlain_(notPlain) {
        std::memset(&block, 0, sizeof block);
    }

    /// The block from hit `first` on; returns whether anything is hit.
    bool collect(std::size_t first) {
        block.traits = 0;
        for (std::size_t group = 0; group < kWaveBlock / kGroup; ++group) {
            const std::size_t at = group * kGroup;
            const std::size_t begin = first + at;
            const std::size_t end = std::clamp(count_, begin, begin + kGroup);
            const bool shared = end == begin + kGroup && allEqual(hits_ + begin);
            block.shared[group] = shared ? hits_[begin] : kNoTriangle;
            if (shared && hits_[begin] != kNoTriangle) {
                copy(begin, at);
                share(begin);
                continue;
            }
            for (std::size_t i = begin; i < end; ++i) copy(i, i - first);
            for (std::size_t i = end; i < begin + kGroup; ++i) clear(i - first);
        }
        return block.traits != 0;
    }
    std::size_t notPlain() const { return notPlainCount_; }

    BlockCorners block;

  private:
    void clear(std::size_t at) { std::memset(block.diffuse + 4 * at, 0, sizeof(float) * 4); }

    void copy(std::size_t hit, std::size_t at) {
        constexpr std::size_t kVertexBytes = 16, kNormalBytes = 12;
        const std::uint32_t t = hits_[hit];
        if (t == kNoTriangle) {
            clear(at);
            return;
        }
        const Triangle triangle = triangles_[t];
        const ShadingTriangle shading = shading_[t];
        const MaterialRow& row = rows_[shading.material];
        std::memcpy(block.position[0] + 4 * at, vertices_ + triangle.v[0], kVertexBytes);
        std::memcpy(block.position[1] + 4 * at, vertices_ + triangle.v[1], kVertexBytes);
        std::memcpy(block.position[2] + 4 * at, vertices_ + triangle.v[2], kVertexBytes);
        std::memcpy(block.normal[0] + 4 * at, normals_ + shading.v[0], kNormalBytes);
        std::memcpy(block.normal[1] + 4 * at, normals_ + shading.v[1], kNormalBytes);
        std::memcpy(block.normal[2] + 4 * at, normals_ + shading.v[2], kNormalBytes);
        std::memcpy(block.diffuse + 4 * at, row.diffuse, sizeof(float) * 4);
        const std::uint32_t traits = row.traits;
        material_[hit] = shading.material;
        block.traits |= traits;
        notPlain_[notPlainCount_] = static_cast<std::uint32_t>(hit);
        notPlainCount_ += (traits & traits::kNotPlain) != 0 ? 1 : 0;
    }

    /// Material and list of what is not plain for the other rays of a group that hits one triangle.
    void share(std::size_t begin) {
        std::fill_n(material_ + begin, kGroup, material_[begin]);
        if ((rows_[material_[begin]].traits & traits::kNotPlain) == 0) return;
        for (std::size_t i = 1; i < kGroup; ++i) {
            notPlain_[notPlainCount_++] = static_cast<std::uint32_t>(begin + i);
        }
    }

    const Vertex* vertices_;
    const Vec3* normals_;
    const Triangle* triangles_;
    const ShadingTriangle* shading_;
    const MaterialRow* rows_;
    const std::uint32_t* hits_;
    std::size_t count_;
    std::uint32_t* material_;
    std::uint32_t* notPlain_;
    std::size_t notPlainCount_ = 0;
};

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
    if (notPlain_.size() < count + 1) notPlain_.resize(count + 1);
}

void SurfaceWave::fill(const Mesh& mesh, const MaterialTable& materials, const RayWave& rays,
                       const HitWave& hits) {
    resize(rays.size());
    CornerCollector corners(mesh, materials, hits, material, notPlain_.data());
    const BlockCorners& block = corners.block;
    for (std::size_t first = 0; first < size_; first += kWaveBlock) {
        const std::size_t count = std::min(kWaveBlock, size_ - first);
        if (!corners.collect(first)) {
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
    notPlainCount_ = corners.notPlain();
}

} // namespace rtcore
#endif

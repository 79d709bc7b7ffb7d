#include "rtcore/shading/surface/surface_wave.h"

#include <algorithm>
#include <iterator>
#include <numbers>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/shading/surface/surface_wave.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/math/triangle-inl.h"

#ifndef RTCORE_SHADING_SURFACE_SURFACE_WAVE_TYPES
#define RTCORE_SHADING_SURFACE_SURFACE_WAVE_TYPES
namespace rtcore {

/// Sources of the values that are looked up for a hit.
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

/// Hits of consecutive rays.
struct Found {
    Corners<Float> position, normal;
    Float3 diffuse;
    Uint traits, material;
};

/// The same triangle for all.
HWY_INLINE Found lookUp(const SurfaceSources& from, std::uint32_t t) {
    const Triangle& triangle = from.triangles[t];
    const ShadingTriangle& shading = from.shading[t];
    const MaterialRow& row = from.rows[shading.material];
    const auto vertex = [&](std::size_t i) {
        const Vertex& v = from.vertices[triangle.v[i]];
        return broadcast(Vec3{v.x, v.y, v.z});
    };
    const auto normal = [&](std::size_t i) { return broadcast(from.normals[shading.v[i]]); };
    return {{vertex(0), vertex(1), vertex(2)},
            {normal(0), normal(1), normal(2)},
            broadcast(row.diffuseBrdf),
            row.traits,
            shading.material};
}

HWY_INLINE Corners<Float> select(Mask where, const Corners<Float>& a, const Corners<Float>& b) {
    return {select(where, a.a, b.a), select(where, a.b, b.b), select(where, a.c, b.c)};
}

/// The surfaces of a block; elements from `first` on of `wave`. Appends the points that are not plain to
/// `notPlain`, which has room for a vector more, and returns how many.
std::size_t fillBlock(const SurfaceSources& sources, const BlockRays& rays, std::size_t first,
                      SurfaceWave& wave, std::uint32_t* HWY_RESTRICT notPlain) {
    std::size_t notPlainCount = 0;
    std::uint32_t known = kNoTriangle; // whose normal and clearance these are
    Float3 front{};
    Mask behind = noLanes();
    Float clearance = 0.0F;
    for (std::size_t i = 0; i < kWaveBlock; i += lanes()) {
        const std::size_t at = first + i;
        const Uint hit = load(rays.triangle + i);
        const Mask used = hit != kNoTriangle;
        if (none(used)) {
            store(Uint(0U), wave.traits + at);
            continue;
        }
        // Neighbours hit few triangles: one after another, and each for all of its rays at once.
        std::uint32_t triangle = rays.triangle[i + used.first()];
        Found found = lookUp(sources, triangle);
        Mask rest = used & (hit != triangle);
        const bool same = none(rest);
        while (any(rest)) {
            triangle = rays.triangle[i + rest.first()];
            const Mask these = hit == triangle;
            const Found next = lookUp(sources, triangle);
            found = {select(these, next.position, found.position), select(these, next.normal, found.normal),
                     select(these, next.diffuse, found.diffuse), select(these, next.traits, found.traits),
                     select(these, next.material, found.material)};
            rest = without(rest, these);
        }
        const Uint traits = selectOrZero(used, found.traits);
        store(traits, wave.traits + at);
        store(found.material, wave.material + at);
        storeAt(found.diffuse, wave.diffuseBrdf, at);
        const Float u = load(rays.u + i);
        const Float v = load(rays.v + i);
        storeAt(interpolate<Float>(found.position, u, v), wave.position, at);
        if (!same || triangle != known) {
            front = normalize(normalOf(found.position), used);
            behind = normalsBehind<Float>(found.normal, front);
            clearance = surfaceClearance<Float>(found.position, front);
            known = same ? triangle : kNoTriangle;
        }
        store(clearance, wave.clearance + at);
        const Float3 direction = load(rays.dx + i, rays.dy + i, rays.dz + i);
        const Mask inside = dot(front, direction) > 0.0F;
        const Float3 geometric = select(inside, -front, front);
        storeAt(geometric, wave.geometricNormal, at);
        storeAt(-direction, wave.toViewer, at);

        const Float3 normal = normalize(interpolate<Float>(found.normal, u, v), used);
        const Float3 shading = select(inside ^ behind, -normal, normal);
        const Mask straight = isZero(normal);
        storeAt(select(straight, geometric, shading), wave.shadingNormal, at);
        const Mask special = (traits & traits::kNotPlain) != 0U;
        if (any(special)) {
            const Compressor some(special);
            some.store(iota(at), notPlain + notPlainCount);
            notPlainCount += some.count();
            const Uint side = selectOrZero(inside, Uint(traits::kFromInside)) |
                              selectOrZero(without(inside ^ behind, straight), Uint(traits::kTurned));
            store(traits | selectOrZero(special, side), wave.traits + at);
        }
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

void SurfaceWave::resize(std::size_t count, const MaterialTable& materials) {
    size_ = count;
    const bool metallic = materials.anyMetallic(), tinted = materials.anyTint(),
               coated = materials.anyCoated();
    ArraysOf3* const always[] = {&position,    &geometricNormal, &shadingNormal, &toViewer,
                                 &diffuseBrdf, &weight,          &specular,      &contribution};
    ArraysOf3* const ofMetal[] = {&straight, &grazing, &gloss, &further, &furtherShape};
    const std::size_t vectors = std::size(always) + (metallic ? std::size(ofMetal) : 0) + (tinted ? 1 : 0);
    memory_.resize(3 * vectors + (metallic ? 2 : 1) + (coated ? 3 : 0), count);
    std::size_t next = 0;
    const auto place = [&](ArraysOf3& v, bool used) {
        v = used ? memory_.arraysOf3(next) : ArraysOf3{};
        next += used ? 3 : 0;
    };
    for (ArraysOf3* const v : always) place(*v, true);
    for (ArraysOf3* const v : ofMetal) place(*v, metallic);
    place(tint, tinted);
    clearance = memory_.array(next++);
    alpha = metallic ? memory_.array(next++) : nullptr;
    for (float** const values : {&coat, &coatAlbedo, &coatAlpha})
        *values = coated ? memory_.array(next++) : nullptr;
    if (traits_.size() < count + kWaveBlock) {
        traits_.resize(count + kWaveBlock);
        materials_.resize(count + kWaveBlock);
    }
    traits = traits_.data();
    material = materials_.data();
    if (notPlain_.size() < count + kWaveBlock) notPlain_.resize(count + kWaveBlock);
}

void SurfaceWave::gather(const SurfaceWave& from, std::span<const std::uint32_t> points,
                         const MaterialTable& materials) {
    resize(points.size(), materials);
    notPlainCount_ = 0;
    const auto take = [&](auto* to, const auto* values) {
        for (std::size_t i = 0; i < points.size(); ++i) to[i] = values[points[i]];
    };
    const auto take3 = [&](ArraysOf3 SurfaceWave::*member) {
        const ArraysOf3 &to = this->*member, &values = from.*member;
        if (to.x == nullptr) return;
        take(to.x, values.x);
        take(to.y, values.y);
        take(to.z, values.z);
    };
    for (ArraysOf3 SurfaceWave::*member :
         {&SurfaceWave::position, &SurfaceWave::geometricNormal, &SurfaceWave::shadingNormal,
          &SurfaceWave::toViewer, &SurfaceWave::diffuseBrdf, &SurfaceWave::weight, &SurfaceWave::straight,
          &SurfaceWave::grazing, &SurfaceWave::gloss, &SurfaceWave::further, &SurfaceWave::furtherShape,
          &SurfaceWave::tint})
        take3(member);
    take(clearance, from.clearance);
    if (alpha != nullptr) take(alpha, from.alpha);
    if (coat != nullptr) {
        take(coat, from.coat);
        take(coatAlbedo, from.coatAlbedo);
        take(coatAlpha, from.coatAlpha);
    }
    take(traits, from.traits);
    take(material, from.material);
    // Whole blocks are worked on: nothing is hit behind the last.
    std::fill_n(traits + points.size(), kWaveBlock, 0U);
    std::fill_n(material + points.size(), kWaveBlock, 0U);
}

void SurfaceWave::clearTint(const MaterialTable& materials) {
    if (!materials.anyTint()) return;
    const std::size_t room = (size_ + kWaveBlock - 1) / kWaveBlock * kWaveBlock;
    for (float* const values : {tint.x, tint.y, tint.z}) std::fill_n(values, room, 1.0F);
}

void SurfaceWave::fillWhite(std::span<const WhitePoint> points, const MaterialTable& materials) {
    resize(points.size(), materials);
    clearTint(materials);
    notPlainCount_ = 0;
    const Vec3 brdf = Vec3{1, 1, 1} * std::numbers::inv_pi_v<float>;
    for (std::size_t i = 0; i < points.size(); ++i) {
        traits[i] = traits::kPoint;
        position.set(i, points[i].position);
        clearance[i] = 0;
        geometricNormal.set(i, points[i].normal);
        shadingNormal.set(i, points[i].normal);
        toViewer.set(i, points[i].normal);
        diffuseBrdf.set(i, brdf);
    }
    std::fill_n(traits + points.size(), kWaveBlock, 0U);
    std::fill_n(material, points.size() + kWaveBlock, 0U);
}

void SurfaceWave::whiten(const MaterialTable& materials) {
    notPlainCount_ = 0;
    const Vec3 brdf = Vec3{1, 1, 1} * std::numbers::inv_pi_v<float>;
    for (std::size_t i = 0; i < size_; ++i) {
        if (traits[i] == 0) continue;
        traits[i] = traits::kPoint;
        material[i] = materials.white();
        shadingNormal.set(i, geometricNormal.at(i));
        diffuseBrdf.set(i, brdf);
    }
}

void SurfaceWave::fill(const Mesh& mesh, const MaterialTable& materials, const RayWave& rays,
                       const HitWave& hits) {
    resize(rays.size(), materials);
    clearTint(materials);
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
    if (hits.clearance.empty()) return;
    for (std::size_t i = 0; i < size_; ++i) {
        if (hits.isHit(i)) clearance[i] = std::max(clearance[i], hits.clearance[i]);
    }
}

} // namespace rtcore
#endif

#include "rtcore/shading/surface/metallic_points.h"

#include "rtcore/scattering/ggx_albedo.h"
#include "rtcore/scene/metallic_roughness.h"
#include "rtcore/shading/surface/surface.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/shading/surface/metallic_points.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/scattering/coat-inl.h"
#include "rtcore/shading/surface/faded_mirror-inl.h"
#include "rtcore/shading/surface/material_rows-inl.h"

#ifndef RTCORE_SHADING_SURFACE_METALLIC_POINTS_TYPES
#define RTCORE_SHADING_SURFACE_METALLIC_POINTS_TYPES
namespace rtcore {

struct MetallicSources {
    const MaterialRow* rows;
    const GgxAlbedoTable* table;
    const float *roughness, *metallic; ///< factors at each point; null: all 1
};

} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// The fraction of the gloss that a mirrored ray is to show.
HWY_INLINE Float mirroredGloss(Mirroring mirroring, Float roughness) {
    if (mirroring == Mirroring::Exact) return selectOrZero(roughness * roughness < kMinAlpha, Float(1));
    return fadedMirror<Float>(roughness);
}

/// Lays the coats of points over their lobes. Returns what a mirrored ray shows of them.
HWY_INLINE Float layCoats(const LobeTask& task, const MetallicSources& from, const Rows& row, Mask sharp,
                          Float cosine, const SurfaceWave& s, std::size_t i, MetallicLobes<Float>& lobes) {
    const Mask coated =
        hasTrait(load(s.traits + i), traits::kPoint) & hasTrait(load(s.traits + i), traits::kCoated);
    const Float weight = selectOrZero(coated, row.get(&MaterialRow::coat));
    const Float roughness = select(coated, row.get(&MaterialRow::coatRoughness), Float(1));
    const CoatLobe<Float> coat = coatLobe<Float>(*from.table, weight, roughness, cosine);
    layUnder<Float>(1.0F - coat.albedo, lobes);
    const Float fraction = selectOrZero(sharp, mirroredGloss(task.mirroring, roughness));
    const Mask narrow = sharp & (roughness * roughness < kMinAlpha);
    store(select(narrow, Float(0), weight), s.coat + i);
    store(coat.albedo * (1.0F - fraction), s.coatAlbedo + i);
    store(coat.alpha, s.coatAlpha + i);
    return weight * coatFresnel<Float>(cosine) * fraction;
}

void completeMetallic(const LobeTask& task, const MetallicSources& from, const SurfaceWave& s) {
    for (std::size_t i = 0; i < s.size(); i += lanes()) {
        const Uint traits = load(s.traits + i);
        const Mask used = hasTrait(traits, traits::kPoint) & hasTrait(traits, traits::kMetallic);
        if (none(used)) continue;
        const Rows row(from.rows, s.material + i, used);
        Float roughness = row.get(&MaterialRow::roughness), metallic = row.get(&MaterialRow::metallic);
        if (from.roughness != nullptr) {
            roughness = roughness * load(from.roughness + i);
            metallic = metallic * load(from.metallic + i);
        }
        const Float3 normal = loadAt(s.shadingNormal, i), base = loadAt(s.diffuseBrdf, i);
        const Float cosine = dot(liftedViewer<Float>(loadAt(s.toViewer, i), normal), normal);
        MetallicLobes<Float> lobes = metallicLobes<Float>(*from.table, base * kPi, metallic, roughness,
                                                          row.get(&MaterialRow::specular), cosine);
        const Mask sharp = used & hasTrait(traits, traits::kSharp);
        const Float fraction = selectOrZero(sharp, mirroredGloss(task.mirroring, roughness));
        Float3 varnish{};
        if (s.coat != nullptr)
            varnish = broadcast(kWhite) * layCoats(task, from, row, sharp, cosine, s, i, lobes);
        const Mask mirrors = (fraction > 0.0F) | (varnish.x > 0.0F);
        const Float3 weight = loadAt(s.weight, i);
        if (any(mirrors)) {
            const Float3 mirrored =
                glossFactor<Float>(lobes.straight, lobes.grazing, cosine) * fraction + varnish;
            storeAt(select(mirrors, weight * mirrored, loadAt(s.specular, i)), s.specular, i);
            store(select(mirrors, traits | traits::kSpecular, traits), s.traits + i);
            const Mask narrow = sharp & (roughness * roughness < kMinAlpha);
            lobes.straight = select(narrow, Float3{}, lobes.straight);
            lobes.grazing = select(narrow, Float3{}, lobes.grazing);
        }
        const Float3 gloss = lobes.glossAlbedo * (1.0F - fraction) + lobes.further;
        storeAt(lobes.straight, s.straight, i);
        storeAt(lobes.grazing, s.grazing, i);
        storeAt(gloss, s.gloss, i);
        storeAt(lobes.further, s.further, i);
        storeAt(lobes.shape, s.furtherShape, i);
        store(lobes.alpha, s.alpha + i);
        storeAt(select(used, lobes.diffuse / kPi, base), s.diffuseBrdf, i);
        if (task.emitted == nullptr) continue;
        Float3 scattered = lobes.diffuse + gloss;
        if (s.coat != nullptr) scattered = scattered + broadcast(kWhite) * load(s.coatAlbedo + i);
        const Float3 reflected = weight * scattered * broadcast(task.ambient);
        const Float3 emitted = loadAt(*task.emitted, i);
        storeAt(select(used, emitted + reflected, emitted), *task.emitted, i);
    }
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(completeMetallic);

void MetallicPoints::lookUp(const LobeTask& task, const SurfaceWave& surfaces) {
    roughness_.assign(surfaces.size() + kWaveBlock, 1);
    metallic_.assign(surfaces.size() + kWaveBlock, 1);
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        if ((surfaces.traits[i] & traits::kVaried) == 0) continue;
        const RoughnessFactors factors = roughnessAt(task.scene, task.hits.hit(i));
        roughness_[i] = factors.roughness;
        metallic_[i] = factors.metallic;
    }
}

void MetallicPoints::complete(const LobeTask& task, const SurfaceWave& surfaces) {
    const bool varied = task.materials.anyVaried();
    if (varied) lookUp(task, surfaces);
    const MetallicSources from{task.materials.rows(), &ggxAlbedoTable(), varied ? roughness_.data() : nullptr,
                               varied ? metallic_.data() : nullptr};
    HWY_DYNAMIC_DISPATCH(completeMetallic)(task, from, surfaces);
}

} // namespace rtcore
#endif

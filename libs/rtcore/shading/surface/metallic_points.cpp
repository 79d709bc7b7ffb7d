#include "rtcore/shading/surface/metallic_points.h"

#include "rtcore/scattering/ggx_albedo.h"
#include "rtcore/scene/metallic_roughness.h"
#include "rtcore/shading/surface/surface.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/shading/surface/metallic_points.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/scattering/metallic-inl.h"
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
        const Mask mirrors = fraction > 0.0F;
        const Float3 weight = loadAt(s.weight, i);
        if (any(mirrors)) {
            const Float3 mirrored = glossFactor<Float>(lobes.straight, lobes.grazing, cosine) * fraction;
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
        const Float3 reflected = weight * (lobes.diffuse + gloss) * broadcast(task.ambient);
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

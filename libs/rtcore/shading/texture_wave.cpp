#include "rtcore/shading/texture_wave.h"

#include "rtcore/shading/texture_lookup.h"

#include "rtcore/platform/vector_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/shading/texture_wave.cpp"
#include <hwy/foreach_target.h>
// The loop over targets comes before the code that is compiled for each of them.
#include "rtcore/shading/vector_math-inl.h"

#ifndef RTCORE_SHADING_TEXTURE_WAVE_TYPES
#define RTCORE_SHADING_TEXTURE_WAVE_TYPES
namespace rtcore {

/// A block of points on its way from hits to albedos.
struct TextureBlock {
    alignas(64) float corner[3][2][kWaveBlock] = {}; ///< texture coordinates of the triangle
    alignas(64) float u[kWaveBlock] = {}, v[kWaveBlock] = {};
    alignas(64) std::uint32_t size[2][kWaveBlock] = {};  ///< of the texture: width, height
    alignas(64) std::uint32_t wrap[2][kWaveBlock] = {};  ///< TextureWrap of u, v
    bool repeats = true;                                 ///< all of them do
    alignas(64) std::uint32_t texel[4][kWaveBlock] = {}; ///< which four: upper left, right, lower left, right
    alignas(64) float share[2][kWaveBlock] = {};         ///< of the right ones, of the lower ones
    alignas(64) float light[4][3][kWaveBlock] = {};      ///< of the four texels
    alignas(64) float albedo[3][kWaveBlock] = {};        ///< first the material's own
};

} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

struct Taps {
    Bits first, second;
    Floats share;
};

HWY_INLINE Floats fractionOf(Floats x) { return hn::Sub(x, hn::Floor(x)); }

/// The lanes that wrap so.
HWY_INLINE Lanes wrapAs(Bits wrap, TextureWrap kind) {
    const Bits wanted = hn::Set(BitsTag(), static_cast<std::uint32_t>(kind));
    return hn::MaskFromVec(hn::BitCast(FloatTag(), hn::VecFromMask(BitsTag(), hn::Eq(wrap, wanted))));
}

/// tapAt() of texture_lookup.cpp; `repeats`: all do, whatever `wrap` says.
template <bool repeats>
HWY_INLINE Taps tapsAt(Floats coordinate, Bits size, Bits wrap) {
    const FloatTag d;
    const BitsTag du;
    const hn::RebindToSigned<FloatTag> di;
    const auto n = hn::BitCast(di, size);
    Floats inside = fractionOf(coordinate);
    Lanes atEdge = hn::Lt(constant(1), constant(0)); // of the lanes that do not repeat
    if constexpr (!repeats) {
        const Lanes clamps = wrapAs(wrap, TextureWrap::ClampToEdge);
        const Lanes mirrors = wrapAs(wrap, TextureWrap::MirroredRepeat);
        const Floats pair = hn::Mul(constant(2), fractionOf(hn::Mul(coordinate, constant(0.5F))));
        const Floats there = hn::Sub(constant(1), hn::Abs(hn::Sub(constant(1), pair)));
        inside = hn::IfThenElse(clamps, smaller(larger(coordinate, constant(0)), constant(1)), inside);
        inside = hn::IfThenElse(mirrors, there, inside);
        atEdge = hn::Or(clamps, mirrors);
    }
    const Lanes finite = hn::And(hn::Ge(inside, constant(0)), hn::Le(inside, constant(1)));
    const Floats x =
        hn::Sub(hn::Mul(hn::IfThenElseZero(finite, inside), hn::ConvertTo(d, n)), constant(0.5F));
    const Floats whole = hn::Floor(x);
    const auto base = hn::ConvertTo(di, whole);
    const auto kept = hn::RebindMask(di, atEdge);
    const auto texel = [&](auto i) {
        const auto below = hn::IfThenElse(kept, hn::Zero(di), hn::Add(i, n));
        const auto above = hn::IfThenElse(kept, hn::Sub(n, hn::Set(di, 1)), hn::Sub(i, n));
        const auto fromBelow = hn::IfThenElse(hn::Lt(i, hn::Zero(di)), below, i);
        const auto there = hn::IfThenElse(hn::Lt(i, n), fromBelow, above);
        return hn::BitCast(du, hn::IfThenElseZero(hn::RebindMask(di, finite), there));
    };
    return {texel(base), texel(hn::Add(base, hn::Set(di, 1))), hn::IfThenElseZero(finite, hn::Sub(x, whole))};
}

template <bool repeats>
HWY_INLINE void findTexelsOf(TextureBlock& block) {
    const FloatTag d;
    const BitsTag du;
    for (std::size_t i = 0; i < kWaveBlock; i += hn::Lanes(d)) {
        const Floats u = hn::Load(d, block.u + i), v = hn::Load(d, block.v + i);
        const Floats w = hn::Sub(hn::Sub(constant(1), u), v);
        const auto coordinate = [&](std::size_t axis) {
            return hn::Add(hn::Add(hn::Mul(hn::Load(d, block.corner[0][axis] + i), w),
                                   hn::Mul(hn::Load(d, block.corner[1][axis] + i), u)),
                           hn::Mul(hn::Load(d, block.corner[2][axis] + i), v));
        };
        const Bits width = hn::Load(du, block.size[0] + i);
        const Taps x = tapsAt<repeats>(coordinate(0), width, hn::Load(du, block.wrap[0] + i));
        const Taps y = tapsAt<repeats>(hn::Sub(constant(1), coordinate(1)), hn::Load(du, block.size[1] + i),
                                       hn::Load(du, block.wrap[1] + i));
        const Bits upper = hn::Mul(y.first, width), lower = hn::Mul(y.second, width);
        hn::Store(hn::Add(upper, x.first), du, block.texel[0] + i);
        hn::Store(hn::Add(upper, x.second), du, block.texel[1] + i);
        hn::Store(hn::Add(lower, x.first), du, block.texel[2] + i);
        hn::Store(hn::Add(lower, x.second), du, block.texel[3] + i);
        hn::Store(x.share, d, block.share[0] + i);
        hn::Store(y.share, d, block.share[1] + i);
    }
}

void findTexels(TextureBlock& block) {
    block.repeats ? findTexelsOf<true>(block) : findTexelsOf<false>(block);
}

void mixTexels(TextureBlock& block) {
    const FloatTag d;
    const auto mix = [](Floats a, Floats b, Floats share) {
        return hn::Add(a, hn::Mul(hn::Sub(b, a), share));
    };
    for (std::size_t i = 0; i < kWaveBlock; i += hn::Lanes(d)) {
        const Floats x = hn::Load(d, block.share[0] + i), y = hn::Load(d, block.share[1] + i);
        for (std::size_t c = 0; c < 3; ++c) {
            const auto light = [&](std::size_t texel) { return hn::Load(d, block.light[texel][c] + i); };
            const Floats seen = mix(mix(light(0), light(1), x), mix(light(2), light(3), x), y);
            hn::Store(hn::Mul(hn::Load(d, block.albedo[c] + i), seen), d, block.albedo[c] + i);
        }
    }
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(findTexels);
HWY_EXPORT(mixTexels);

void texturedAlbedos(const Scene& scene, const HitWave& hits, std::span<const std::uint32_t> points,
                     Colour* albedo) {
    const Mesh& mesh = scene.mesh();
    TextureBlock block;
    const Rgba8* texels[kWaveBlock];
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::uint32_t hit = points[i];
        const ShadingTriangle& shading = mesh.shading[hits.triangle[hit]];
        const Material& material = scene.materials[shading.material];
        const Texture& texture = scene.model.textures[material.diffuseTexture];
        texels[i] = scene.model.texels.data() + texture.firstTexel;
        block.size[0][i] = texture.width;
        block.size[1][i] = texture.height;
        block.wrap[0][i] = static_cast<std::uint32_t>(texture.wrapU);
        block.wrap[1][i] = static_cast<std::uint32_t>(texture.wrapV);
        if (texture.wrapU != TextureWrap::Repeat || texture.wrapV != TextureWrap::Repeat)
            block.repeats = false;
        block.u[i] = hits.u[hit];
        block.v[i] = hits.v[hit];
        for (std::size_t corner = 0; corner < 3 && !mesh.texcoords.empty(); ++corner) {
            const Vec2 uv = mesh.texcoords[shading.v[corner]];
            block.corner[corner][0][i] = uv.x;
            block.corner[corner][1][i] = uv.y;
        }
        block.albedo[0][i] = material.diffuse.r;
        block.albedo[1][i] = material.diffuse.g;
        block.albedo[2][i] = material.diffuse.b;
    }
    HWY_DYNAMIC_DISPATCH(findTexels)(block);
    const float* const linear = linearOfCodes();
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t t = 0; t < 4; ++t) {
            const Rgba8 texel = texels[i][block.texel[t][i]];
            block.light[t][0][i] = linear[texel.r];
            block.light[t][1][i] = linear[texel.g];
            block.light[t][2][i] = linear[texel.b];
        }
    }
    HWY_DYNAMIC_DISPATCH(mixTexels)(block);
    for (std::size_t i = 0; i < points.size(); ++i) {
        albedo[i] = {block.albedo[0][i], block.albedo[1][i], block.albedo[2][i]};
    }
}

} // namespace rtcore
#endif

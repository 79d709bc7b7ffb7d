#include "rtcore/shading/surface/texture_wave.h"

#include "rtcore/shading/surface/surface.h"
#include "rtcore/shading/surface/texture_lookup.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/shading/surface/texture_wave.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/shading/surface/texture-inl.h"

#ifndef RTCORE_SHADING_SURFACE_TEXTURE_WAVE_TYPES
#define RTCORE_SHADING_SURFACE_TEXTURE_WAVE_TYPES
namespace rtcore {

/// A block of points on its way from hits to albedos.
struct TextureBlock {
    alignas(64) float corner[3][2][kWaveBlock] = {}; ///< texture coordinates of the triangle
    alignas(64) float u[kWaveBlock] = {}, v[kWaveBlock] = {};
    alignas(64) std::uint32_t size[2][kWaveBlock] = {};  ///< of the texture: width, height
    alignas(64) std::uint32_t wrap[2][kWaveBlock] = {};  ///< TextureWrap of u, v
    bool repeats = true;                                 ///< all of them do
    alignas(64) float flip[kWaveBlock] = {};             ///< not 0: upside down
    bool flips = false;                                  ///< any of them is
    alignas(64) std::uint32_t filter[kWaveBlock] = {};   ///< TextureFilter
    bool linear = true;                                  ///< all of them are
    alignas(64) std::uint32_t inBlocks[kWaveBlock] = {}; ///< not 0: TextureStorage::Blocks
    bool plain = true;                                   ///< none of them is
    alignas(64)
        std::uint32_t texel[4][kWaveBlock] = {};    ///< numbers of four: upper left, right, lower left, right
    alignas(64) float fraction[2][kWaveBlock] = {}; ///< of the right ones, of the lower ones
    alignas(64) float light[4][3][kWaveBlock] = {}; ///< of the four texels
    alignas(64) float albedo[3][kWaveBlock] = {};   ///< first that without texture
};

} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

template <bool repeats>
HWY_INLINE void findTexelsOf(TextureBlock& block) {
    for (std::size_t i = 0; i < kWaveBlock; i += lanes()) {
        const Float u = load(block.u + i), v = load(block.v + i);
        const Float w = 1.0F - u - v;
        const auto coordinate = [&](std::size_t axis) {
            return load(block.corner[0][axis] + i) * w + load(block.corner[1][axis] + i) * u +
                   load(block.corner[2][axis] + i) * v;
        };
        const Uint width = load(block.size[0] + i);
        Taps<Float> x = tapsAt<repeats, Float>(coordinate(0), width, load(block.wrap[0] + i));
        Float upwards = coordinate(1);
        if (block.flips) upwards = select(load(block.flip + i) != Float(0.0F), 1.0F - upwards, upwards);
        Taps<Float> y =
            tapsAt<repeats, Float>(1.0F - upwards, load(block.size[1] + i), load(block.wrap[1] + i));
        if (!block.linear) {
            const Mask nearest = load(block.filter + i) == static_cast<std::uint32_t>(TextureFilter::Nearest);
            x = sharpened<Float>(x, nearest);
            y = sharpened<Float>(y, nearest);
        }
        Uint upper = y.first * width, lower = y.second * width;
        if (!block.plain) {
            const Mask inBlocks = load(block.inBlocks + i) != Uint(0U);
            upper = select(inBlocks, rowInBlocks(y.first, width), upper);
            lower = select(inBlocks, rowInBlocks(y.second, width), lower);
            x.first = select(inBlocks, columnInBlocks(x.first), x.first);
            x.second = select(inBlocks, columnInBlocks(x.second), x.second);
        }
        store(upper + x.first, block.texel[0] + i);
        store(upper + x.second, block.texel[1] + i);
        store(lower + x.first, block.texel[2] + i);
        store(lower + x.second, block.texel[3] + i);
        store(x.fraction, block.fraction[0] + i);
        store(y.fraction, block.fraction[1] + i);
    }
}

void findTexels(TextureBlock& block) {
    block.repeats ? findTexelsOf<true>(block) : findTexelsOf<false>(block);
}

void mixTexels(TextureBlock& block) {
    for (std::size_t i = 0; i < kWaveBlock; i += lanes()) {
        const Float x = load(block.fraction[0] + i), y = load(block.fraction[1] + i);
        for (std::size_t c = 0; c < 3; ++c) {
            const auto light = [&](std::size_t texel) { return load(block.light[texel][c] + i); };
            const Float seen = mix(mix(light(0), light(1), x), mix(light(2), light(3), x), y);
            store(load(block.albedo[c] + i) * seen, block.albedo[c] + i);
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
    const void* texels[kWaveBlock]; // or blocks
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::uint32_t hit = points[i];
        const ShadingTriangle& shading = mesh.shading[hits.triangle[hit]];
        const Material& material = scene.material(shading.material);
        const Texture& texture = scene.model.textures[material.diffuseTexture];
        block.inBlocks[i] = texture.inBlocks() ? 1 : 0;
        block.plain = block.plain && !texture.inBlocks();
        texels[i] = texture.inBlocks()
                        ? static_cast<const void*>(scene.model.blocks.data() + texture.firstTexel)
                        : scene.model.texels.data() + texture.firstTexel;
        block.size[0][i] = texture.width;
        block.size[1][i] = texture.height;
        block.wrap[0][i] = static_cast<std::uint32_t>(texture.wrapU);
        block.wrap[1][i] = static_cast<std::uint32_t>(texture.wrapV);
        if (texture.wrapU != TextureWrap::Repeat || texture.wrapV != TextureWrap::Repeat)
            block.repeats = false;
        block.filter[i] = static_cast<std::uint32_t>(texture.filter);
        block.linear = block.linear && texture.filter == TextureFilter::Linear;
        block.flip[i] = material.flipTextures != 0 ? 1.0F : 0.0F;
        block.flips = block.flips || material.flipTextures != 0;
        block.u[i] = hits.u[hit];
        block.v[i] = hits.v[hit];
        for (std::size_t corner = 0; corner < 3 && !mesh.texcoords.empty(); ++corner) {
            const Vec2 uv = mesh.texcoord(shading.v[corner], texture.texcoordSet);
            block.corner[corner][0][i] = uv.x;
            block.corner[corner][1][i] = uv.y;
        }
        const Colour untextured =
            mesh.colours.empty() ? material.diffuse : untexturedAt(scene, hits.hit(hit));
        block.albedo[0][i] = untextured.r;
        block.albedo[1][i] = untextured.g;
        block.albedo[2][i] = untextured.b;
    }
    HWY_DYNAMIC_DISPATCH(findTexels)(block);
    const float* const linear = linearOfCodes();
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t t = 0; t < 4; ++t) {
            const std::uint32_t number = block.texel[t][i];
            const Rgba8 texel = block.inBlocks[i] != 0
                                    ? texelIn(static_cast<const TexelBlock*>(texels[i]), number)
                                    : static_cast<const Rgba8*>(texels[i])[number];
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

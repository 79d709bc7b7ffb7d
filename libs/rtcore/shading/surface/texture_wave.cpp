#include "rtcore/shading/surface/texture_wave.h"

#include "rtcore/shading/surface/surface.h"
#include "rtcore/shading/surface/texture_lookup.h"

#include <array>

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

/// Texels of points whose textures are in blocks; zeros for others.
struct PackedTexels {
    alignas(64) std::uint32_t low[4][kWaveBlock] = {}, high[4][kWaveBlock] = {}; ///< PackedTexel
    alignas(64) std::uint32_t indices[4][kWaveBlock] = {}, mode[4][kWaveBlock] = {};
    alignas(64) std::uint32_t code[4][3][kWaveBlock]; ///< red, green, blue
};

/// Above the bits of the three indices, 4 each: whether the mode is of luma and chroma.
inline constexpr std::uint32_t kLumaChroma = 1U << 12U;
inline constexpr std::array<std::uint32_t, kBlockModes.size()> kPackedModes = [] {
    std::array<std::uint32_t, kBlockModes.size()> packed{};
    for (std::size_t i = 0; i < packed.size(); ++i) {
        const BlockMode& mode = kBlockModes[i];
        packed[i] = mode.lumaChroma ? kLumaChroma : 0;
        for (std::size_t c = 0; c < 3; ++c) packed[i] |= std::uint32_t{mode.bits[c]} << (4 * c);
    }
    return packed;
}();

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

HWY_INLINE Uint shiftedLeft(Uint a, Uint bits) { return hn::Shl(a.raw, bits.raw); }
HWY_INLINE Uint shiftedRight(Uint a, Uint bits) { return hn::Shr(a.raw, bits.raw); }

/// Takes the lowest `bits` off the indices, and gives the value of the channel: that of texelOf().
HWY_INLINE Int takeValue(Uint& indices, Uint bits, Uint base, Uint step) {
    const Uint index = indices & (shiftedLeft(Uint(1U), bits) - Uint(1U));
    indices = shiftedRight(indices, bits);
    const Uint eighths = shiftedLeft(Uint(8U) + (step & Uint(7U)), shiftRight<3>(step & Uint(63U)));
    return toInt(base + shiftRight<3>(index * eighths + Uint(4U)));
}

HWY_INLINE Uint codeOf(Int value) {
    const Int positive = select(value < Int(0), Int(0), value);
    return toUint(select(positive > Int(255), Int(255), positive));
}

void decodeTexels(PackedTexels& texels) {
    const Uint four(15U), nine(0x1FFU);
    for (std::size_t t = 0; t < 4; ++t) {
        for (std::size_t i = 0; i < kWaveBlock; i += lanes()) {
            const Uint low = load(texels.low[t] + i), high = load(texels.high[t] + i);
            const Uint mode = load(texels.mode[t] + i);
            Uint indices = load(texels.indices[t] + i);
            const Int a =
                takeValue(indices, mode & four, shiftRight<4>(low) & Uint(0xFFU), shiftRight<6>(high));
            const Int b = takeValue(indices, shiftRight<4>(mode) & four, shiftRight<12>(low) & nine,
                                    shiftRight<12>(high));
            const Uint baseOfThird = shiftRight<21>(low) | shiftLeft<3>(high & Uint(63U));
            const Int c = takeValue(indices, shiftRight<8>(mode) & four, baseOfThird, shiftRight<18>(high));
            const Int co = b - Int(kChromaZero), cg = c - Int(kChromaZero);
            const Int rest = a - shiftRight<1>(cg), blue = rest - shiftRight<1>(co);
            const Mask luma = (mode & Uint(kLumaChroma)) != Uint(0U);
            store(codeOf(select(luma, blue + co, a)), texels.code[t][0] + i);
            store(codeOf(select(luma, rest + cg, b)), texels.code[t][1] + i);
            store(codeOf(select(luma, blue, c)), texels.code[t][2] + i);
        }
    }
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
HWY_EXPORT(decodeTexels);
HWY_EXPORT(mixTexels);

namespace {

/// Of the texture of each point: its texels, or its blocks.
using TexelPointers = std::array<const void*, kWaveBlock>;

void setLight(const std::uint32_t (&code)[3], std::size_t texel, std::size_t point, TextureBlock& block) {
    const float* const linear = linearOfCodes();
    for (std::size_t c = 0; c < 3; ++c) block.light[texel][c][point] = linear[code[c]];
}

void lightTexels(const TexelPointers& texels, std::size_t points, TextureBlock& block) {
    for (std::size_t i = 0; i < points; ++i) {
        for (std::size_t t = 0; block.inBlocks[i] == 0 && t < 4; ++t) {
            const Rgba8 texel = static_cast<const Rgba8*>(texels[i])[block.texel[t][i]];
            setLight({texel.r, texel.g, texel.b}, t, i, block);
        }
    }
}

void lightBlocks(const TexelPointers& texels, std::size_t points, TextureBlock& block) {
    PackedTexels packed;
    for (std::size_t i = 0; i < points; ++i) {
        const auto* const blocks = static_cast<const TexelBlock*>(texels[i]);
        for (std::size_t t = 0; block.inBlocks[i] != 0 && t < 4; ++t) {
            const std::uint32_t number = block.texel[t][i];
            const PackedTexel texel = packedTexel(blocks[number / kBlockTexels], number % kBlockTexels);
            packed.low[t][i] = texel.low;
            packed.high[t][i] = texel.high;
            packed.indices[t][i] = texel.indices;
            packed.mode[t][i] = kPackedModes[texel.low & 15U];
        }
    }
    HWY_DYNAMIC_DISPATCH(decodeTexels)(packed);
    for (std::size_t i = 0; i < points; ++i) {
        for (std::size_t t = 0; block.inBlocks[i] != 0 && t < 4; ++t)
            setLight({packed.code[t][0][i], packed.code[t][1][i], packed.code[t][2][i]}, t, i, block);
    }
}

} // namespace

void texturedAlbedos(const Scene& scene, const HitWave& hits, std::span<const std::uint32_t> points,
                     Colour* albedo) {
    const Mesh& mesh = scene.mesh();
    TextureBlock block;
    TexelPointers texels{};
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
    lightTexels(texels, points.size(), block);
    if (!block.plain) lightBlocks(texels, points.size(), block);
    HWY_DYNAMIC_DISPATCH(mixTexels)(block);
    for (std::size_t i = 0; i < points.size(); ++i) {
        albedo[i] = {block.albedo[0][i], block.albedo[1][i], block.albedo[2][i]};
    }
}

} // namespace rtcore
#endif
